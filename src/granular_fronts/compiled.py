"""Where compiled code is cached on disk.

Numba notices a change in the file of a compiled function, but not in the files of the functions it
calls.  Here the cache folder carries a digest of all folders of the package instead, so that stale
machine code cannot be used.  Import this module before any module that compiles.
"""

import hashlib
import os
from pathlib import Path

import numba

SOURCES = Path(__file__).parent
# Nothing compiles beside these folders: a new plot style costs no compilation.
COMPILING = "*/*.py"


def source_digest(pattern="**/*.py"):
    """Digest of the package's files that match a pattern, 12 hexadecimal digits."""
    digest = hashlib.sha256()
    for path in sorted(SOURCES.glob(pattern)):
        digest.update(path.relative_to(SOURCES).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:12]


def use_versioned_cache():
    """Cache compiled code under NUMBA_CACHE_DIR, or the user's cache folder, by source digest."""
    user_cache = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    base = Path(os.environ.get("NUMBA_CACHE_DIR", user_cache / "granular_fronts"))
    numba.config.CACHE_DIR = str(base / source_digest(COMPILING))


use_versioned_cache()
