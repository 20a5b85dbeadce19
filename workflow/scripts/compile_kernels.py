"""Compile the kernels of some packages, so that jobs that start together find them ready."""

import json
import time
from importlib import import_module
from pathlib import Path

import numba

from granular_fronts.arguments import choice
from granular_fronts.numerics.compiled import SOURCES
from granular_fronts.output.files import complete_file
from step import run_step


def compile_kernels(packages: list[str], stamp: Path) -> None:
    """Fill the cache of compiled kernels.

    Parameters
    ----------
    packages : list of str
        Folders of the package, each with a module `compilation`.
    stamp : Path
        JSON file that says with which numba, and in how many seconds.
    """
    start = time.perf_counter()
    for package in packages:
        known = [file.parent.name for file in SOURCES.glob("*/compilation.py")]
        import_module(
            f"granular_fronts.{choice('a package', package, known)}.compilation"
        ).compile_kernels()
    seconds = round(time.perf_counter() - start, 3)
    with complete_file(stamp) as unfinished:
        unfinished.write_text(json.dumps({"numba": numba.__version__, "seconds": seconds}) + "\n")


if __name__ == "__main__":
    run_step(compile_kernels, globals()["snakemake"])
