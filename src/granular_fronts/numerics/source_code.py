"""What source files do, by digests that docstrings, comments and layout do not change.

The digest of a file comes from its syntax tree without the strings that are statements.  Since
parsing all files takes a third of a second, a file of the cache folder keeps digests by the
contents that they belong to.
"""

import ast
import hashlib
import json
import os
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from pathlib import Path

KEPT = "code_digests.json"


def cache_root() -> Path:
    """Return the folder of what is derived from sources: NUMBA_CACHE_DIR or the user's cache."""
    user_cache = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    return Path(os.environ.get("NUMBA_CACHE_DIR", user_cache / "granular_fronts"))


def code_digest(files: Iterable[Path], root: Path) -> str:
    """Return the digest of Python files in any order, 16 hexadecimals.

    What lies between `root`, a folder above them, and the files counts as their names.
    """
    digests = {file.relative_to(root).as_posix(): file_digest(file) for file in files}
    lines = "\n".join(f"{name} {digests[name]}" for name in sorted(digests))
    return hashlib.sha256(lines.encode()).hexdigest()[:16]


@cache
def file_digest(file: Path) -> str:
    """Return the digest of what a file does, looked up where its contents are known."""
    content = file.read_bytes()
    key = hashlib.sha256(content).hexdigest()
    kept = _read_kept(cache_root() / KEPT)
    if key not in kept:
        kept[key] = syntax_digest(content)
        _keep(cache_root() / KEPT, kept)
    return kept[key]


def syntax_digest(content: bytes) -> str:
    """Return the digest of the syntax tree of a file without docstrings."""
    tree = ast.parse(content)
    for node in ast.walk(tree):
        for field in ("body", "orelse", "finalbody"):
            statements = getattr(node, field, None)
            if isinstance(statements, list):
                setattr(node, field, [one for one in statements if not _is_docstring(one)])
    return hashlib.sha256(ast.dump(tree).encode()).hexdigest()


def _is_docstring(node: ast.AST) -> bool:
    """Return whether a node is a string that is a statement."""
    is_constant = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return is_constant and isinstance(node.value.value, str)


@cache
def _read_kept(path: Path) -> dict[str, str]:
    """Return the digests that are kept, none where the file is missing or damaged."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def _keep(path: Path, digests: dict[str, str]) -> None:
    """Write the digests at once or not at all, where there is a cache within reach."""
    unfinished = path.with_name(f"{path.name}.{os.getpid()}")
    try:
        unfinished.write_text(json.dumps(digests), encoding="utf-8")
        unfinished.replace(path)
    except OSError:
        with suppress(OSError):
            unfinished.unlink()
