"""Change the checker in one place, and see that the tests of proofs notice.

A mutant has one integer larger by one, one sign or product or comparison exchanged, or one
requirement left out.  It is noticed if it does not prove what the unchanged checker proves, with
the same numbers, or if it proves something from what is wrong.

A slow test tries a sample.  All mutants of some modules (hours for all modules) are tried by

    export PYTHONPATH=tests/support:tests/proofs:src:workflow/lib
    python tools/mutation.py families tail_roots

which names those that nothing notices.
"""

import ast
import copy
import os
import resource
import sys
import tempfile
import time
import types
from fractions import Fraction
from pathlib import Path

import numpy as np
from certificates import load
from flint import arb
from test_proof_checker import LIES
from test_proof_dashpots import LATE, WRONG
from test_proof_tails import FAR

from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solve import solve_front
from granular_fronts.proofs.certificate import describe
from granular_fronts.proofs.dashpots.certificate import describe as describe_dashpots

PACKAGE = "granular_fronts.proofs"
TRUSTED = (
    "balls",
    "arrays",
    "contraction",
    "tail_roots",
    "uniqueness",
    "consequences",
    "dashpots.row_norms",
    "dashpots.ahead",
    "dashpots.checker",
    "stability",
    "rear_expansion",
    "checker",
    "families",
)
FOLDER = Path(__file__).parents[1] / "src/granular_fronts/proofs"
TREES = {name: ast.parse((FOLDER / f"{name.replace('.', '/')}.py").read_text()) for name in TRUSTED}
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
NOT_MUTATED = "LONGEST_LINE", "TAYLOR_ORDER", "require_short", "def load"
"""Statements that limit a message or the time of a check, choose an order, or read a file."""
LIMITS = {resource.RLIMIT_AS: 8 * 2**30, resource.RLIMIT_CORE: 0}
"""Bytes of memory at which a mutant is stopped."""
SHORT, LONG = 40, 180
"""Seconds of processor time at which one is stopped; the unchanged checker takes 10 and 46."""


def requirement(node):
    """Whether a statement only asks for something: a call of require…, or a raise."""
    called = (
        node.value.func if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) else None
    )
    name = getattr(called, "attr", getattr(called, "id", ""))
    return name.startswith(("require", "_require")) or isinstance(node, ast.Raise)


def excluded(node):
    """Whether a node is one of the statements that are not mutated."""
    named = ast.unparse(node).partition("(")[0].split(" = ")[0]
    return isinstance(node, ast.stmt) and named in NOT_MUTATED


def walk(tree):
    """The nodes of a module from the outside to the inside, without excluded statements."""
    if not excluded(tree):
        yield tree
        for node in ast.iter_child_nodes(tree):
            yield from walk(node)


def places(tree):
    """The nodes that can be changed."""
    for node in walk(tree):
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
    all_places = [(name, k) for name in changed for k in range(len(list(places(TREES[name]))))]
    for name, k in all_places[::every]:
        mutant = copy.deepcopy(TREES[name])
        description = change(list(places(mutant))[k])
        yield f"{name}, {description}", TREES | {name: mutant}


def modules_of(trees):
    """The modules of syntax trees, which import one another."""
    kept = {name: sys.modules.get(f"{PACKAGE}.{name}") for name in trees}
    made = {}
    try:
        for name, tree in trees.items():
            made[name] = sys.modules[f"{PACKAGE}.{name}"] = types.ModuleType(f"{PACKAGE}.{name}")
            code = compile(ast.fix_missing_locations(tree), name, "exec")
            exec(code, made[name].__dict__)
        return made
    finally:
        for name, module in kept.items():
            if module is not None:
                sys.modules[f"{PACKAGE}.{name}"] = module


def rough(data, size):
    """A certificate whose P̄ jumps from cell to cell, so that the errors of the front are large."""
    profile = data["profile"].copy()
    profile[0, ::2, 0] += size
    return data | {"profile": profile}


def longer(data):
    """The same front with a bead of 1 more behind."""
    rows = np.zeros_like(data["profile"][:, : data["sizes"][2]])
    rows[0, :, 0] = 1
    sizes = data["sizes"] + np.array([1, 0, 0, 0, 0, 0, 0])
    return data | {"sizes": sizes, "profile": np.concatenate([rows, data["profile"]], axis=1)}


def interval(alpha, low, high, cells=20):
    """A certificate of an interval of γ."""
    alpha, ends = Fraction(alpha), (Fraction(low), Fraction(high))
    front = solve_front(float(alpha), float(sum(ends) / 2))
    return describe(front, (alpha, alpha), ends, cells, 40, 6e-4)


def dashpots(low, high, size=0.0):
    """A certificate of an interval of γ with linear dashpots, of a ū that may jump."""
    front, ends = solve_front(1.5, 0.3, beta=1.0), (Fraction(low), Fraction(high))
    data = describe_dashpots(front, (Fraction(3, 2),) * 2, ends, 16, 40, 6e-4)
    data["strain"][::2, 0] += size
    return data


class Examples:
    """Certificates, pairs of neighbours and wrong ones, with what the unchanged checker proves."""

    def __init__(self, folder):
        kept = {name: load(name) for name in ("overshoot", "monotone", "steep")}
        kept["rough"] = rough(kept["overshoot"], 1e-6)
        kept["rather monotone"] = rough(kept["monotone"], 1e-10)
        kept["below"] = interval("3/2", "0.2525", "0.253")
        kept["around"] = interval("3/2", "0.2632", "0.2633")
        first, second = interval(2, "0.3", "0.301"), interval(2, "0.301", "0.302", 30)
        first, second = rough(longer(longer(first)), 1e-6), rough(second, 1e-7)
        kept["dashpots"] = dashpots("0.3", "0.3")
        kept["dashpots around"] = dashpots("0.299999", "0.300001")
        kept["rough dashpots"] = dashpots("0.3", "0.3", 1e-6)
        wrong = {name: load("monotone") for name in LIES}
        for name, data in wrong.items():
            LIES[name](data)
        for name, lie in (WRONG | LATE).items():
            wrong[f"dashpots {name}"] = data = dict(kept["dashpots"])
            lie(data)
        self.kept = [self.file(folder, name, data) for name, data in kept.items()]
        self.around = folder / "around.npz"
        self.wrong = [self.file(folder, name, data) for name, data in wrong.items()]
        self.pair = [self.file(folder, name, d) for name, d in (("1", first), ("2", second))]
        apart = {
            "a gap": second | {"gamma": np.array([3011, 10000, 302, 1000])},
            "another law": second | {"alpha": np.array([2, 1, 200001, 100000])},
            "rougher": rough(second, 5e-4),
        }
        one, two = self.pair
        self.apart = [(one, self.file(folder, name, data)) for name, data in apart.items()]
        self.apart += [(two, one), (one, one)]
        self.known = list(self.proofs(modules_of(TREES)))

    @staticmethod
    def file(folder, name, data):
        np.savez(folder / f"{name}.npz", **data)
        return folder / f"{name}.npz"

    def proofs(self, made):
        """What modules prove: of roots, of the pair, and of one certificate after another."""
        with made["balls"].in_balls():
            yield from tails(made["tail_roots"])
        for paths in (self.pair, [self.around]):
            family = list(made["families"].prove_family(paths))
            for record in family:
                yield True, record["statements"], record["inequalities"]
            yield True, list(made["families"].conclude(family)), []
        for path in self.kept:
            record = made["checker"].check_certificate(path)
            yield record["proved"], record["statements"], record["inequalities"]
        with made["balls"].in_balls():
            bulging = made["families"].prove(self.kept[1])
            bulging.u_high, bulging.inequalities = bulging.u_high + 1e-3, []
            yield True, list(bulging.rear()), bulging.inequalities
            for path in self.kept[1:3]:
                front = made["families"].prove(path)
                for kappa in ([9, 0], [0, 9]):  # The line behind and ahead of all cells.
                    front.outer_kappa = made["balls"].array(kappa)
                    yield True, [front.Z2(arb(0.1)).str(18)], []
            front = made["dashpots.checker"].DashpotFront(made["arrays"].load(self.kept[-1]))
            front.proved = list(front.exists())
            for front.rho_behind, front.rho_ahead in ((arb(99), arb(0)), (arb(0), arb(99))):
                yield True, [front.Z2(arb(0.1)).str(18)], []
            strongly_damped = load("overshoot") | {"gamma": np.array([6, 5, 6, 5])}
            yield True, [made["checker"].Front(strongly_damped).nK.str(18)], []

    def differ(self, made):
        """Whether modules do not prove what the unchanged ones prove."""
        return not all(map(same, self.proofs(made), self.known))

    def believed(self, made):
        """Whether modules prove something from what is wrong."""
        return (
            wrong_tails(made)
            or any(overlooked(made, self.pair, cell) for cell in (0, -1))
            or any(joined(made, pair) for pair in self.apart)
            or any(made["checker"].check_certificate(path)["proved"] for path in self.wrong)
        )


def tails(module):
    """What a module finds of tail roots: the crossing, a double root, the bend, four roots."""
    real, pair = sorted(tail_roots(1.5, 0.26324587, count=2), key=lambda root: root.imag)
    law, *roots = module.crossing(arb(1.5), 0.26324587378607, (real, pair), 1e-7)
    yield True, [law.gamma.str(18), *(root.str(18) for root in roots)], law.inequalities
    start = tail_roots(1.125, critical_damping(1.125), count=1)[0].real
    law, root = module.double_root(arb(1.125), start, 1e-4)
    yield True, [law.gamma.str(18), root.str(18)], law.inequalities
    yield True, [module.find_bend(2.347, 1e-3).str(18)], []
    law = module.Law(arb(1.5), arb(0.3))
    starts = tail_roots(1.5, 0.3, count=4)
    found = [module.find_root(law, start.real, start.imag, 1e-9) for start in starts]
    yield True, [root.str(18) for root in found], law.inequalities
    alpha, gamma, w, zeros = FAR
    law = module.Law(arb(alpha), arb(gamma))
    module.require_zeros(law, "roots far from the real axis", arb(w), zeros)
    yield True, [], law.inequalities


def wrong_tails(made):
    """Whether a module finds tail roots that there are not, or not all."""
    module, roots = made["tail_roots"], list(tail_roots(1.5, 0.3, count=5))
    pair, third = roots[1:3]
    law = module.Law(arb(1.5), arb(0.3))
    tries = [
        (module.find_bend, 2.4, 1e-6),
        (module.find_bend, -2.3469413041671690, 1e-6),
        (module.require_zeros, law, "a line through a root", arb(roots[0].real, 1e-12), 0),
        (module.require_zeros, law, "a line through a root", arb(roots[0].real, 1e-12), 1),
        (module.double_root, arb(1.3), 2.34, 1e-2),
        (module.double_root, arb(1.125), 3.1, 0.2),
        (module.crossing, arb(1.5), 0.2633, roots[:2], 1e-9),
        (module.crossing, arb(1.5), 0.26324587378607, (third, pair), 1e-7),
        (module.find_root, law, roots[0].real, 1e-12, 1e-9),
        (module.find_root, law, pair.real, -pair.imag, 1e-9),
        (module.find_root, law, roots[0].real, 0, 3.0),
    ]
    with made["balls"].in_balls():
        for function, *arguments in tries:
            try:
                function(*arguments)
            except (made["balls"].NotProvedError, ValueError):
                continue
            return True
    return False


def same(found, known):
    """Whether two proofs have the same statements and the same sides of inequalities."""
    sides = [[(one["left"], one["right"]) for one in proof[2]] for proof in (found, known)]
    return (
        found[:2] == known[:2]
        and len(sides[0]) == len(sides[1])
        and np.allclose(*sides, rtol=1e-9, atol=1e-13)
    )


def joined(made, pair):
    """Whether modules join two certificates to a family."""
    try:
        return len(list(made["families"].prove_family(pair))) == 2
    except made["balls"].NotProvedError:
        return False


def overlooked(made, pair, cell):
    """Whether modules join fronts that are apart in one cell."""
    families = made["families"]
    first, second = map(families.prove, pair)
    second.strain = list(second.strain)
    second.strain[cell] = [second.strain[cell][0] + 0.5, *second.strain[cell][1:]]
    try:
        with made["balls"].in_balls():
            families.join(first, second)
    except made["balls"].NotProvedError:
        return False
    return True


def noticed(trees, seconds, *ways):
    """Whether a mutant is noticed in one of several ways, in a process of its own.

    One that takes too much time or memory, or that ends its process, is noticed.
    """
    child = os.fork()
    if child == 0:
        for limit, most in (LIMITS | {resource.RLIMIT_CPU: seconds}).items():
            resource.setrlimit(limit, (most, most))
        try:
            made = modules_of(trees)
            unnoticed = not any(way(made) for way in ways)
        except Exception:
            unnoticed = False
        os._exit(int(unnoticed))
    _, status = os.waitpid(child, 0)
    return os.waitstatus_to_exitcode(status) != 1


if __name__ == "__main__":
    total = survived = 0
    with tempfile.TemporaryDirectory() as folder:
        examples = Examples(Path(folder))
        for name, trees in mutants(sys.argv[1:] or TRUSTED):
            total += 1
            if not noticed(trees, LONG, examples.differ, examples.believed):
                survived += 1
                print(f"not noticed: {name}", flush=True)
    print(f"{total - survived} of {total} mutants noticed in {time.process_time():.0f} s")
