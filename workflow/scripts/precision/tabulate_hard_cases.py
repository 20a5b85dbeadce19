"""The hard cases as a table: what is asked for, what came out, passed or failed."""

from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from step import run_step


def tabulate_hard_cases(dataset: Path, csv: Path, markdown: Path) -> None:
    """Write a row for each case.

    Parameters
    ----------
    dataset : Path
        Written by measure_hard_cases.
    csv, markdown : Path
        Tables to write.
    """
    data = read_dataset(dataset, "hard_cases")
    table = pd.DataFrame([describe(data.sel(case=name)) for name in data["case"].values])
    write_table(table, round_floats(table, 3), csv, markdown, [data])


def describe(case: xr.Dataset) -> dict[str, Any]:
    """One row."""
    texts = ("problem", "expected", "criterion", "quantity")
    return {
        "name": str(case["case"].values),
        **{name: str(case[name].values) for name in texts},
        "measured": float(case["measured"]),
        "error": float(case["error"]),
        "limit": float(case["limit"]),
        "outcome": "passed" if case["passed"] else "failed",
        "seconds": float(case["seconds"]),
        "remark": str(case["message"].values),
    }


if __name__ == "__main__":
    run_step(tabulate_hard_cases, globals().get("snakemake"))
