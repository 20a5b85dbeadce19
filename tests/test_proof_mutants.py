"""Change the checker in one place, and see that the tests of proofs notice.

A mutant has one integer larger by one, one sign or product or comparison exchanged, or one
requirement left out.  It is noticed if it does not prove what the certificates kept prove, with
the same numbers, or if it proves something from what is wrong.  Run this file to try all mutants,
or those of the modules that it is given.
"""

import ast
import copy
import signal
import sys
import tempfile
import types
from pathlib import Path

import numpy as np
import pytest
from projects import ROOT

pytest.importorskip("flint")

from test_proof_checker import DATA, LIES, PROVED, load

PACKAGE = "granular_fronts.proofs"
TRUSTED = ("balls", "inequalities", "tail_roots", "consequences", "rear_expansion", "checker")
SOURCES = {name: (ROOT / f"src/granular_fronts/proofs/{name}.py").read_text() for name in TRUSTED}
EXCHANGED = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Lt: ast.Gt,
    ast.Gt: ast.Lt,
    ast.LtE: ast.Gt,
    ast.GtE: ast.Lt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
}


def requirement(node):
    """Whether a statement only asks for something: a call of require…, or a raise."""
    called = (
        node.value.func if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) else None
    )
    name = getattr(called, "attr", getattr(called, "id", ""))
    return name.startswith(("require", "_require")) or isinstance(node, ast.Raise)


def places(tree):
    """The nodes that can be changed."""
    for node in ast.walk(tree):
        whole = isinstance(node, ast.Constant) and type(node.value) is int
        operation = isinstance(node, ast.BinOp) and type(node.op) in EXCHANGED
        comparison = isinstance(node, ast.Compare) and type(node.ops[0]) in EXCHANGED
        if whole or operation or comparison or requirement(node):
            yield node


def change(node):
    """Change a node in place; its description."""
    before = ast.unparse(node)
    if isinstance(node, ast.Constant):
        node.value += 1
    elif isinstance(node, ast.BinOp):
        node.op = EXCHANGED[type(node.op)]()
    elif isinstance(node, ast.Compare):
        node.ops[0] = EXCHANGED[type(node.ops[0])]()
    else:
        node.__class__, node.__dict__ = ast.Pass, {"lineno": node.lineno, "col_offset": 0}
    return f"line {node.lineno}: {before}  →  {ast.unparse(node)}"


def mutants(changed=TRUSTED, every=1):
    """Descriptions and syntax trees by module, one place changed in each; every so many of all."""
    trees = {name: ast.parse(source) for name, source in SOURCES.items()}
    all_places = [(name, k) for name in changed for k in range(len(list(places(trees[name]))))]
    for name, k in all_places[::every]:
        mutant = copy.deepcopy(trees[name])
        description = change(list(places(mutant))[k])
        yield f"{name}, {description}", trees | {name: mutant}


def checker_of(trees):
    """`check_certificate` of changed modules."""
    kept = {name: sys.modules.get(f"{PACKAGE}.{name}") for name in trees}
    try:
        for name, tree in trees.items():
            module = types.ModuleType(f"{PACKAGE}.{name}")
            sys.modules[module.__name__] = module
            exec(compile(ast.fix_missing_locations(tree), name, "exec"), module.__dict__)
        return module.check_certificate
    finally:
        for name, module in kept.items():
            if module is not None:
                sys.modules[f"{PACKAGE}.{name}"] = module


def differs(check):
    """Whether a checker does not prove what the certificates kept prove."""
    for name in ("overshoot", "monotone", "steep"):
        record, known = check(DATA / f"{name}.npz"), PROVED[name]
        if not record["proved"] or record["statements"] != known["statements"]:
            return True
        found = [(one["left"], one["right"]) for one in record["inequalities"]]
        wanted = [(left, right) for _, left, right in known["inequalities"]]
        if len(found) != len(wanted) or not np.allclose(found, wanted, rtol=1e-9, atol=1e-13):
            return True
    return False


def believes_lies(check, folder):
    """Whether a checker proves something from a certificate that is wrong."""
    for lie in LIES.values():
        data = load("monotone")
        lie(data)
        np.savez(folder / "lie.npz", **data)
        if check(folder / "lie.npz")["proved"]:
            return True
    return False


def noticed(trees, folder):
    """Whether the tests notice a mutant; one that does not end within a minute is noticed."""

    def stop(*_):
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(60)
    try:
        check = checker_of(trees)
        return differs(check) or believes_lies(check, folder)
    except Exception:
        return True
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.slow
def test_checker_itself_is_no_mutant():
    assert not differs(checker_of({name: ast.parse(text) for name, text in SOURCES.items()}))


@pytest.mark.slow
def test_most_mutants_are_noticed(tmp_path):
    """A sample of all: the three that survive are equivalent, as −x and x times (−1, 1) are."""
    sample = list(mutants(every=29))
    survivors = [name for name, trees in sample if not noticed(trees, tmp_path)]
    assert len(survivors) <= 0.12 * len(sample), survivors


if __name__ == "__main__":
    total = survived = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, trees in mutants(sys.argv[1:] or TRUSTED):
            total += 1
            if not noticed(trees, Path(folder)):
                survived += 1
                print(f"not noticed: {name}", flush=True)
    print(f"{total - survived} of {total} mutants noticed")
