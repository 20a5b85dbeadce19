"""Speed against error: our solvers and other people's on the same problems, side by side.

The methods of a problem run in one process, on one thread and in turns.  So a slow moment of the
machine hits all of them.  Each has run once before, to compile and to fill the caches. Of the
repeats the least time counts. Errors are measured against a reference, outside the timing, and none
is reported below the error of the reference. A method that is not installed is named and left out.
A method that fails is kept, without an error but with its reason.
"""

import importlib
import json
import os
import platform
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

# Libraries read their limits when they are imported.
from peers import one_thread  # noqa: F401

# isort: split
import numpy as np
import pandas as pd
import xarray as xr
from step import run_step

from granular_fronts.output.datasets import write_dataset
from peers.runs import Run
from problems.problem import Problem, errors_of

# A longer run is timed once: what disturbs it for a moment is a small part of it.
SECONDS_WORTH_REPEATING = 3.0
# Share of a processor below which a run waited for others, or above which it used more than one.
UNDISTURBED = (0.95, 1.05)


def measure_precision(
    family: str, problems: dict, dataset: Path, reference: Path | None = None
) -> None:
    """Solve every problem of a family by every method, and keep errors, times and work.

    Parameters
    ----------
    family : str
        A module of workflow/scripts/precision/problems.
    problems : dict
        As under ``precision.<family>`` of the configuration.
    dataset : Path
        The netCDF file to write, on (problem, solver, step_tolerance).
    reference : Path, optional
        Accurate solutions, in tests/references; none for a family that computes its own.
    """
    load_before = os.getloadavg()[0]
    module = importlib.import_module(f"problems.{family}")
    states = xr.load_dataset(reference) if reference else None
    rows: list[dict[str, Any]] = []
    absent: dict[str, str] = {}
    facts: dict[str, dict[str, Any]] = {}
    for name, settings in problems.items():
        problem = module.make_problem(settings, states)
        tolerances = tolerances_of(problem, settings)
        missing = run_once(problem, tolerances)
        absent |= missing
        facts[name] = {
            "own_method": problem.ours,
            "reference_error": problem.reference_error,
            "time_limit": 1e-3 * settings.get("milliseconds", np.nan),
        }
        present = {method: tolerances[method] for method in tolerances if method not in missing}
        rows += [{"problem": name} | row for row in measure(problem, present, settings["repeats"])]
    for method, reason in absent.items():
        print(f"{method} is left out: {reason}.", file=sys.stderr)
    measured = to_dataset(rows, facts)
    measured.attrs = {
        "absent": json.dumps(absent),
        "load_before": load_before,
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, Python "
        f"{platform.python_version()}",
        "solver": "least wall-clock time of the repeats, one thread",
    }
    write_dataset(measured, dataset, scene_id=f"precision_{family}", config=problems)


def tolerances_of(problem: Problem, settings: Mapping[str, Any]) -> dict[str, list[float]]:
    """Return the tolerances of each method, the loosest first."""
    own = {**settings.get("own_tolerances", {}), **problem.tolerances}
    return {
        method: sorted(own.get(method) or settings["tolerances"], reverse=True)
        for method in settings.get("methods", own)
    }


def run_once(problem: Problem, tolerances: Mapping[str, list[float]]) -> dict[str, str]:
    """Run every method once at its loosest tolerance; why the absent ones are absent."""
    runs = {method: _attempt(problem, method, listed[0]) for method, listed in tolerances.items()}
    return {method: run.message for method, run in runs.items() if run.absent}


def measure(
    problem: Problem, tolerances: Mapping[str, list[float]], repeats: int
) -> list[dict[str, Any]]:
    """Return the errors, times and work on one problem, a row for each method and tolerance."""
    points = [(method, tolerance) for method, listed in tolerances.items() for tolerance in listed]
    points.sort(key=lambda point: -point[1])
    best: dict[tuple[str, float], Run] = {}
    for point in points * repeats:
        if point in best and not best[point].seconds < SECONDS_WORTH_REPEATING:
            continue
        run = _attempt(problem, *point)
        if point not in best or run.seconds < best[point].seconds:
            best[point] = run
    methods = list(tolerances)
    return [
        {
            "solver": method,
            "step_tolerance": tolerance,
            **_costs_of(run),
            **errors_of(run, problem.reference),
        }
        for (method, tolerance), run in sorted(
            best.items(), key=lambda item: methods.index(item[0][0])
        )
    ]


def _attempt(problem: Problem, method: str, tolerance: float) -> Run:
    """Run a method once; whatever stops somebody else's solver is kept as its reason."""
    try:
        return problem.methods[method](tolerance)
    except Exception as error:
        return Run(message=f"{type(error).__name__}: {error}")


def _costs_of(run: Run) -> dict[str, Any]:
    """Return the costs of a run, and whether something else took part of the machine meanwhile."""
    share = run.cpu_seconds / run.seconds
    return {
        "seconds": run.seconds,
        "cpu_share": share,
        "disturbed": float(share < UNDISTURBED[0] or share > UNDISTURBED[1]),
        "right_hand_sides": float(run.right_hand_sides),
        "steps": float(run.steps),
        "grid": float(run.grid),
        "message": run.message,
    }


def to_dataset(rows: list[dict[str, Any]], facts: Mapping[str, Mapping[str, Any]]) -> xr.Dataset:
    """Return the rows as a dataset on (problem, solver, step_tolerance), NaN where nothing ran.

    `facts` is what is known of each problem.
    """
    measured = pd.DataFrame(rows).set_index(["problem", "solver", "step_tolerance"]).to_xarray()
    methods = list(dict.fromkeys(row["solver"] for row in rows))
    measured = measured.reindex({"problem": list(facts), "solver": methods})
    for name in next(iter(facts.values())):
        measured[name] = ("problem", [known[name] for known in facts.values()])
    measured["message"] = measured["message"].fillna("").astype(object)
    for name in ("seconds", "time_limit"):
        measured[name].attrs["units"] = "s"
    for name in measured:
        if "error" in str(name):
            measured[name].attrs["error_method"] = "this is the distance to the reference"
    return measured


if __name__ == "__main__":
    run_step(measure_precision, globals()["snakemake"])
