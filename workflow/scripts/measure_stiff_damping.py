"""Explicit against implicit steps over the damping: error and time of both.

The reference is the implicit method at the tightest tolerance that double precision allows, and its
error is the distance from the explicit pair there. All runs take turns in one process.
"""

import math
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.chain import stiff
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare, work_done
from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.progress import counted
from step import run_step

METHODS = {"explicit": math.inf, "implicit": 0.0}
ABSOLUTE_OVER_RELATIVE = 1.0e-2
TIGHTEST = 1.0e-14


def measure_stiff_damping(problem: dict, dataset: Path) -> None:
    """Solve one initiation for every damping, by both methods over the tolerances.

    Parameters
    ----------
    problem : dict
        As under ``stiff_damping`` of the configuration.
    dataset : Path
        The netCDF file to write, on (gamma, method, tolerance).
    """
    rows: list[dict[str, Any]] = []
    own_errors, stiffnesses = [], []
    for gamma in counted(problem["gammas"], "stiff damping", "damping"):
        references = {name: run_once(problem, gamma, name, TIGHTEST)["state"] for name in METHODS}
        expected = references["implicit"]
        own_errors.append(np.abs(references["explicit"] - expected).max())
        law = prepare(make_scene(problem, gamma)).law
        stiffnesses.append(stiff.stiffness(law, problem["displacement"]))
        for tolerance in problem["relative_tolerances"]:
            rows += measure_tolerance(problem, gamma, tolerance, expected)
    measured = pd.DataFrame(rows).set_index(["gamma", "method", "tolerance"]).to_xarray()
    measured["seconds"].attrs["units"] = "s"
    measured["error"].attrs["error_method"] = "this is the distance to a run at 1e-14"
    measured["reference_error"] = xr.DataArray(own_errors, {"gamma": problem["gammas"]})
    measured["stability_steps"] = xr.DataArray(stiffnesses, {"gamma": problem["gammas"]})
    measured.attrs = {"solver": "least process time of the repeats", "stiff_from": stiff.STIFF}
    write_dataset(measured, dataset, scene_id="stiff_damping", config=problem)


def measure_tolerance(
    problem: Mapping[str, Any], gamma: float, tolerance: float, expected: np.ndarray
) -> Iterator[dict[str, Any]]:
    """Rows of both methods, the fastest of the repeats each."""
    best: dict[str, dict[str, Any]] = {}
    for _ in range(problem["repeats"]):
        for name in METHODS:
            run = run_once(problem, gamma, name, tolerance)
            if name not in best or run["seconds"] < best[name]["seconds"]:
                best[name] = run
    for name, run in best.items():
        yield {
            "gamma": gamma,
            "method": name,
            "tolerance": tolerance,
            "error": np.abs(run["state"] - expected).max(),
            "seconds": run["seconds"],
            "steps": float(run["steps"]),
            "right_hand_sides": float(run["right_hand_sides"]),
        }


def run_once(
    problem: Mapping[str, Any], gamma: float, method: str, tolerance: float
) -> dict[str, Any]:
    """Final u and ẋ, process time and work of one run."""
    scene = make_scene(problem, gamma)
    run = prepare(scene)
    accuracy = {"relative": tolerance, "absolute": ABSOLUTE_OVER_RELATIVE * tolerance}
    started = time.process_time()
    integrate(run, accuracy, stiff_from=METHODS[method])
    seconds = time.process_time() - started
    final = collect(scene, run).isel(t=-1)
    work = work_done(run.clock)
    return {
        "state": np.concatenate([final[name] for name in ("relative_displacement", "velocity")]),
        "seconds": seconds,
        "steps": work["steps_accepted"],
        "right_hand_sides": work["right_hand_sides"],
    }


def make_scene(problem: Mapping[str, Any], gamma: float) -> dict[str, Any]:
    """The initiation with a given damping, recorded at its end."""
    return {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": gamma},
        "beads": problem["beads"],
        "boundary": {"kind": "pressure", "left": problem["displacement"], "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": problem["end_time"],
        "record": {"snapshots": [problem["end_time"]]},
    }


if __name__ == "__main__":
    run_step(measure_stiff_damping, globals().get("snakemake"))
