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

SAME = {
    "docstring of the module": CODE.replace("A module.", "One module."),
    "docstring of a constant": CODE.replace('"""The limit."""\n', ""),
    "docstring of a function": CODE.replace('    """Twice x."""\n', ""),
    "comment": CODE.replace("a comment", "another"),
    "layout": CODE.replace("LIMIT * x", "(\n        LIMIT\n        * x\n    )"),
}
OTHER = {
    "constant": CODE.replace("2.0", "3.0"),
    "kind of number": CODE.replace("2.0", "2"),
    "name": CODE.replace("double", "twice"),
    "order of operands": CODE.replace("LIMIT * x", "x * LIMIT"),
    "string that is a value": CODE.replace('LIMIT = 2.0\n"""The limit."""', 'LIMIT = """2.0"""'),
}


@pytest.fixture(autouse=True)
def own_cache(tmp_path, monkeypatch):
    """Digests are kept in a folder of the test's own."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    (tmp_path / "cache").mkdir()
    source_code._read_kept.cache_clear()
    yield
    source_code._read_kept.cache_clear()


@pytest.mark.parametrize("change", SAME)
def test_words_and_layout_do_not_count(change):
    assert SAME[change] != CODE
    assert syntax_digest(SAME[change].encode()) == syntax_digest(CODE.encode())


@pytest.mark.parametrize("change", OTHER)
def test_what_code_does_counts(change):
    assert OTHER[change] != CODE
    assert syntax_digest(OTHER[change].encode()) != syntax_digest(CODE.encode())


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
