"""Compile kernels, and say where their machine code is cached on disk.

Numba notices a change in the file of a compiled function, but not in the files of the functions it
calls.  Here the cache folder of a kernel carries a digest of its own module and of all that this
one imports.  So no stale machine code is used, and a change in a module leaves unrelated kernels
alone.

Numba compiles a function once for each type of its arguments.  A literal integer is a type of its
own, so callers write ``int64(2)`` where others pass a variable.

The cache may be kept from run to run, and passed between machines.  The key of a folder is the
digest of the code and the versions of numba, llvmlite and NumPy, whose functions kernels contain.
Numba adds the processor and the version of Python.  What does not fit is compiled anew.
"""

import functools
import os
import sys
from pathlib import Path

import llvmlite
import numba
import numpy as np
from llvmlite import binding
from numba.core import event
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler
from numba.core.registry import CPUDispatcher

from granular_fronts.errors import InputError
from granular_fronts.numerics.imports import import_closure, module_files
from granular_fronts.numerics.source_code import cache_root, code_digest

if numba.config.DISABLE_JIT:
    raise InputError("NUMBA_DISABLE_JIT is set, but kernels must be compiled: unset it.")

SOURCES = Path(__file__).parents[1]

MODULES = module_files(SOURCES.parent)

PACKAGES_IN_WORDS = {
    "chain": "the chain",
    "continuum": "the amplitude equations",
    "fronts": "the exact fronts",
    "model": "the contact laws",
    "numerics": "the numerical methods",
    "reference_methods": "the reference methods",
}

# Of each function that `kernel` compiles; a user's functions are not among them.
_package_of_kernel = {}

# What numba begins the name of the place of a function's environment with.
ENVIRONMENT = "_ZN08NumbaEnv"


class _CompilationNotice(event.Listener):
    """Says for each package, once in a process, that kernels of it are compiled."""

    def __init__(self):
        self.depth = 0
        self.announced = set()

    def on_start(self, event):
        """Announce the package of a kernel, unless it is compiled for another that calls it."""
        package = _package_of_kernel.get(event.data["dispatcher"].py_func)
        if self.depth == 0 and package and package not in self.announced:
            self.announced.add(package)
            print(
                f"Compiling the kernels of {PACKAGES_IN_WORDS.get(package, package)}; "
                "this happens once and takes up to a minute.",
                file=sys.stderr,
                flush=True,
            )
        self.depth += 1

    def on_end(self, event):
        """Come back to the kernel that calls the compiled one, if any."""
        self.depth -= 1


event.register("numba:compile", _CompilationNotice())


def kernel(function=None, /, **options):
    """Compile a function with numba, cached until its module or one that this imports changes.

    Options are those of `numba.njit`: ``@kernel`` and ``@kernel(fastmath=True)`` both decorate.
    """

    def compile_cached(function):
        numba.config.CACHE_DIR = str(cache_folder(file_of(function)))
        _package_of_kernel[function] = _package_of(function)
        return numba.njit(cache=True, **options)(function)

    return compile_cached(function) if function else compile_cached


def subroutine(function=None, /, **options):
    """Compile a function that kernels alone call, as a part of each of them.

    It is optimised, turned into machine code and cached within the kernels alone.  Doing this for
    each function by itself, too, would take as long again as compiling the kernels.

    What fuses multiply and add, and whatever calls it up to a kernel, asks for `forceinline`.  Each
    kernel carries a copy of a function that it calls, which may fuse otherwise.  Of several copies
    in a process any may run.
    """
    options |= {"pipeline_class": _PartCompiler}
    options |= {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}

    def compile_part(function):
        compiled = numba.njit(**options)(function)
        compiled.__class__ = Subroutine
        return compiled

    return compile_part(function) if function else compile_part


class _Part(JITCodeLibrary):
    """The code of a subroutine, as kernels take it in."""

    def _optimize_final_module(self):
        """Leave it to the kernels."""

    def _finalize_final_module(self):
        """Make machine code of nothing but the places of the environments, which numba fills."""
        self._finalize_dynamic_globals()
        names = [variable.name for variable in self._final_module.global_variables]
        places = [f'@"{name}" = common global i8* null' for name in names if ENVIRONMENT in name]
        self._codegen._add_module(binding.parse_assembly("\n".join(places)))
        self._finalized = True


class _PartCompiler(Compiler):
    """Compiler of a subroutine."""

    def __init__(self, typing_context, target_context, library, *others):
        part = _Part(target_context.codegen(), "subroutine")
        super().__init__(typing_context, target_context, part, *others)


class Subroutine(CPUDispatcher):
    """A compiled function that Python cannot call: there is nothing it could jump to."""

    def __call__(self, *arguments):
        """Raise where numba would end the process."""
        raise TypeError(f"{self.__name__} is compiled for kernels alone: call it from a kernel.")


def file_of(function):
    """The file that defines a function."""
    return Path(function.__code__.co_filename)


def _package_of(function):
    """The folder of the package that defines a function, or the folder of its file elsewhere."""
    file = file_of(function)
    return file.relative_to(SOURCES).parts[0] if SOURCES in file.parents else file.parent.name


def callback(signature, **options):
    """Compile a function that kernels call by its `address`, cached like a kernel.

    The signature is numba's, and options are those of `numba.cfunc`.
    """

    def compile_cached(function):
        numba.config.CACHE_DIR = str(cache_folder(file_of(function)))
        return numba.cfunc(signature, cache=True, **options)(function)

    return compile_cached


@functools.cache
def cache_folder(file):
    """Folder of the machine code of a file's kernels, in NUMBA_CACHE_DIR or the user's cache."""
    # A kernel may be outside the package with others that it calls, in a test for example.
    near = {one.stem: one for one in file.parent.glob("*.py")}
    modules = MODULES if file in MODULES.values() else {**MODULES, **near}
    [name] = [name for name, path in modules.items() if path == file]
    files = [modules[one] for one in import_closure([name], modules)]
    versions = f"numba{numba.__version__}_llvmlite{llvmlite.__version__}_numpy{np.__version__}"
    root = Path(os.path.commonpath(files)).parent
    return cache_root() / f"{name}_{code_digest(files, root)}_{versions}"
