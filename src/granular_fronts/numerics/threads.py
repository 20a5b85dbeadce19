"""One thread for LAPACK, so that eigenvalues have the same bits on every number of processors.

OpenBLAS and MKL share sums among threads, and the order of a sum decides its rounding.  Libraries
without these functions, which have no threads or cannot be asked, are left as they are.
"""

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib import import_module

NAMES = (
    ("scipy_openblas_get_num_threads", "scipy_openblas_set_num_threads"),
    ("openblas_get_num_threads", "openblas_set_num_threads"),
    ("MKL_Get_Max_Threads", "MKL_Set_Num_Threads"),
)
"""What asks for the number of threads and what sets it: in wheels of SciPy, elsewhere, and MKL."""


@cache
def _functions():
    """Both functions of the library that SciPy calls, or None."""
    # A name is sought in the libraries that this module was linked with, too.
    library = ctypes.CDLL(import_module("scipy.linalg.cython_lapack").__file__)
    for names in NAMES:
        if all(hasattr(library, name) for name in names):
            return [getattr(library, name) for name in names]
    return None


@contextmanager
def one_thread() -> Iterator[None]:
    """Keep SciPy's linear algebra to one thread; as a decorator too."""
    if not (functions := _functions()):
        yield
        return
    threads, keep_to = functions
    before = threads()
    keep_to(1)
    try:
        yield
    finally:
        keep_to(before)
