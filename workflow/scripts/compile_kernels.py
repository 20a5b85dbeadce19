"""Compile the kernels of the chain, so that jobs that start together find them ready.

About ten seconds once, then one: python workflow/scripts/compile_kernels.py --stamp kernels.json
"""

import json
import time
from pathlib import Path

import numba

from granular_fronts.chain import warm_up
from step import run_step


def compile_kernels(stamp: Path) -> None:
    """Fill the cache of compiled kernels.

    Parameters
    ----------
    stamp : Path
        JSON file that says with which numba, and in how many seconds.
    """
    start = time.perf_counter()
    warm_up()
    seconds = round(time.perf_counter() - start, 3)
    stamp.write_text(json.dumps({"numba": numba.__version__, "seconds": seconds}) + "\n")


if __name__ == "__main__":
    run_step(compile_kernels, globals().get("snakemake"))
