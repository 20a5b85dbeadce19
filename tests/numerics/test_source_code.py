"""Digests of code change with what the code does, and with nothing else."""

import json

import pytest

from granular_fronts.numerics import source_code
from granular_fronts.numerics.source_code import code_digest, file_digest, syntax_digest

CODE = '''"""A module."""

LIMIT = 2.0
"""The limit."""


def double(x):
    """Twice x."""
    return LIMIT * x  # a comment
'''

# What is replaced by what, and whether the code then does something else.
CHANGES = {
    "docstring of the module": ("A module.", "One module.", False),
    "docstring of a constant": ('"""The limit."""\n', "", False),
    "docstring of a function": ('    """Twice x."""\n', "", False),
    "comment": ("a comment", "another", False),
    "layout": ("LIMIT * x", "(\n        LIMIT\n        * x\n    )", False),
    "constant": ("2.0", "3.0", True),
    "kind of number": ("2.0", "2", True),
    "name": ("double", "twice", True),
    "order of operands": ("LIMIT * x", "x * LIMIT", True),
    "string that is a value": ('LIMIT = 2.0\n"""The limit."""', 'LIMIT = """2.0"""', True),
}


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    """Digests are kept in a folder of the test's own."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    (tmp_path / "cache").mkdir()
    source_code._read_kept.cache_clear()
    yield
    source_code._read_kept.cache_clear()


@pytest.mark.parametrize(("old", "new", "counts"), CHANGES.values(), ids=CHANGES)
def test_what_code_does_counts_and_words_and_layout_do_not(old, new, counts):
    assert old in CODE
    changed = syntax_digest(CODE.replace(old, new).encode())
    assert (changed != syntax_digest(CODE.encode())) == counts


def written(tmp_path, **files):
    """Files of some names with some code."""
    paths = [tmp_path / f"{name}.py" for name in files]
    # In a process a file is read once.
    file_digest.cache_clear()
    for path, code in zip(paths, files.values(), strict=True):
        path.write_text(code)
    return paths


def test_names_of_files_count_and_their_order_does_not(tmp_path):
    first, second = written(tmp_path, first=CODE, second="x = 1\n")
    digest = code_digest([first, second], tmp_path)
    assert code_digest([second, first], tmp_path) == digest
    swapped = written(tmp_path, first="x = 1\n", second=CODE)
    assert code_digest(swapped, tmp_path) != digest
    assert code_digest(swapped[:1], tmp_path) != code_digest(
        written(tmp_path, third="x = 1\n"), tmp_path
    )


@pytest.mark.parametrize("damaged", [False, True])
def test_kept_digests_are_those_computed(tmp_path, monkeypatch, damaged):
    files = written(tmp_path, first=CODE)
    digest = code_digest(files, tmp_path)
    kept = tmp_path / "cache" / source_code.KEPT
    assert list(json.loads(kept.read_text()).values()) == [syntax_digest(CODE.encode())]
    source_code._read_kept.cache_clear()
    if damaged:
        kept.write_text("{")
    else:
        monkeypatch.setattr(source_code, "syntax_digest", None)  # It must not be needed.
    assert code_digest(files, tmp_path) == digest


@pytest.mark.parametrize("folder", ["absent", "file/below"])
def test_without_a_cache_nothing_is_written(tmp_path, monkeypatch, folder):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / folder))
    files = written(tmp_path, first=CODE)
    assert code_digest(files, tmp_path) == code_digest(files, tmp_path)
    assert not (tmp_path / "absent").exists()
