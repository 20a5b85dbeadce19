"""Compile the kernels of a package, so that jobs that start together find them ready."""

import json
import time
from importlib import import_module

import numba

from granular_fronts.output.files import complete_file
from job import job


def compile_kernels(package: str, stamp: str) -> None:
    """Fill the cache of compiled kernels.

    Parameters
    ----------
    package : str
        A folder of granular_fronts with a module `compilation`.
    stamp : str
        JSON file that says with which numba, and in how many seconds.
    """
    start = time.perf_counter()
    import_module(f"granular_fronts.{package}.compilation").compile_kernels()
    seconds = round(time.perf_counter() - start, 3)
    with complete_file(stamp) as unfinished:
        unfinished.write_text(json.dumps({"numba": numba.__version__, "seconds": seconds}) + "\n")


if __name__ == "__main__":
    with job(snakemake):
        compile_kernels(snakemake.wildcards.package, snakemake.output.stamp)
