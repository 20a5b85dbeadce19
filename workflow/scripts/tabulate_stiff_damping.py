"""How long explicit and implicit steps take to reach an error, and which of them a run takes."""

from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr
from tabulate_speed_error import time_to_reach

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from step import run_step

LEVELS = (1e-6, 1e-8, 1e-10, 1e-12)


def tabulate_stiff_damping(dataset: Path, csv: Path, markdown: Path) -> None:
    """Write a row for each damping and error.

    Parameters
    ----------
    dataset : Path
        Written by measure_stiff_damping.
    csv, markdown : Path
        Tables to write.
    """
    data = read_dataset(dataset, "stiff_damping")
    cases = (data.sel(gamma=gamma) for gamma in data["gamma"].values)
    rows = [describe(case, level, data.attrs["stiff_from"]) for case in cases for level in LEVELS]
    table = pd.DataFrame(rows)
    write_table(table, round_floats(table, 3), csv, markdown, [data])


def describe(case: xr.Dataset, level: float, stiff_from: float) -> dict[str, Any]:
    """Times of both methods to one error; NaN where it is not reached."""
    explicit, implicit = (
        time_to_reach(case.sel({"method": name}), level) for name in ("explicit", "implicit")
    )
    return {
        "gamma": float(case["gamma"]),
        "stiffness": float(case["stability_steps"]),
        "error": level,
        "explicit_ms": explicit,
        "implicit_ms": implicit,
        "gain": explicit / implicit,
        "taken": "implicit" if float(case["stability_steps"]) >= stiff_from else "explicit",
        "reference_error": float(case["reference_error"]),
    }


if __name__ == "__main__":
    run_step(tabulate_stiff_damping, globals().get("snakemake"))
