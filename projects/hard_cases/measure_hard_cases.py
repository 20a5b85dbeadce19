"""Solve the hard cases, each against an answer known some other way."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from step import run_step

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.hard_cases.event_orders import fitted_order, measure_orders
from granular_fronts.studies.hard_cases.registry import run_case

REFUSED = dict.fromkeys(("problem", "expected", "criterion", "quantity"), "") | dict.fromkeys(
    ("measured", "error", "limit"), np.nan
)


def measure_hard_cases(cases: list[str], dataset: Path) -> None:
    """Solve each case once, and measure the order of convergence through contact events.

    Parameters
    ----------
    cases : list of str
        Names, as in granular_fronts.studies.hard_cases.registry.
    dataset : Path
        The netCDF file to write, on (case) and (solver, rung).
    """
    rows = [measure_case(name) for name in cases]
    measured = pd.DataFrame(rows).set_index("case").to_xarray()
    measured["seconds"].attrs["units"] = "s"
    error_method = "this is the distance to an answer known another way, see criterion"
    measured["error"].attrs["error_method"] = error_method
    measured = measured.merge(_tabulate_orders(measure_orders()))
    write_dataset(measured, dataset, scene_id="hard_cases", config={"cases": cases})


def measure_case(name: str) -> dict[str, Any]:
    """Return one case as a row."""
    case, seconds, refusal = run_case(name)
    found = case._asdict() if case else REFUSED
    passed = bool(case and case.passed)
    return {"case": name, **found, "passed": int(passed), "seconds": seconds, "message": refusal}


def _tabulate_orders(curves: Mapping[str, tuple[np.ndarray, np.ndarray]]) -> xr.Dataset:
    """Return the steps and errors on (solver, rung), padded with NaN, and the fitted orders."""
    rungs = max(steps.size for steps, _ in curves.values())
    padded = np.full((2, len(curves), rungs), np.nan)
    for row, (steps, errors) in enumerate(curves.values()):
        padded[:, row, : steps.size] = steps, errors
    return xr.Dataset(
        {
            "event_steps": (("solver", "rung"), padded[0]),
            "event_error": (("solver", "rung"), padded[1]),
            "observed_order": ("solver", [fitted_order(*curve) for curve in curves.values()]),
        },
        {"solver": list(curves), "rung": np.arange(1, rungs + 1)},
    )


if __name__ == "__main__":
    run_step(measure_hard_cases, globals()["snakemake"])
