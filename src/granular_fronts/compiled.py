"""Compile kernels, and say where their machine code is cached on disk.

Numba notices a change in the file of a compiled function, but not in the files of the functions it
calls.  Here the cache folder of a kernel carries a digest of its own wing and of the wings that
this one calls, so that stale machine code cannot be used, and a change in one wing leaves the
kernels of the others alone.
"""

import functools
import hashlib
import os
from pathlib import Path

import numba

SOURCES = Path(__file__).parent

CALLED_WINGS = {
    "chain": ("elementary",),
    "continuum": ("elementary",),
    "fronts": ("chain", "elementary"),
}
"""The folders whose kernels the kernels of a folder call, besides their own."""


def kernel(function=None, /, **options):
    """Compile a function with numba, cached until its wing or a wing it calls changes.

    Parameters
    ----------
    function : callable, optional
        None where options are given: ``@kernel`` and ``@kernel(fastmath=True)`` both decorate.
    **options
        Options of `numba.njit`.

    Returns
    -------
    callable
        The compiled function, or the decorator that makes it.
    """

    def compile_cached(function):
        wing = Path(function.__code__.co_filename).parent.name
        numba.config.CACHE_DIR = str(cache_folder(wing))
        return numba.njit(cache=True, **options)(function)

    return compile_cached(function) if function else compile_cached


def cache_folder(wing):
    """Folder of a wing's machine code, under NUMBA_CACHE_DIR or the user's cache folder."""
    user_cache = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache"))
    base = Path(os.environ.get("NUMBA_CACHE_DIR", user_cache / "granular_fronts"))
    patterns = [f"{name}/*.py" for name in (wing, *CALLED_WINGS.get(wing, ()))]
    return base / f"{wing}_{source_digest(*patterns)}"


@functools.cache
def source_digest(*patterns):
    """Digest of the package's files that match the patterns, all by default, 12 hexadecimals."""
    digest = hashlib.sha256()
    for pattern in patterns or ("**/*.py",):
        for path in sorted(SOURCES.glob(pattern)):
            name = path.relative_to(SOURCES).as_posix()
            digest.update(name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:12]
