"""Speed against error of the solvers of the logarithmic Burgers equation, James (2021), eq. (50).

Four schemes solve the rings of section 4.3 up to their end:

upwind          the paper's explicit scheme, compiled;
finite_volumes  ours, with finer cells at the start;
uniform_cells   ours without them, which shows what the kinks of the start cost;
fourier         another method, which shares no scheme with ours.

The start (49) has kinks; a smooth start of similar width shows the order away from them. Errors are
the largest over ξ̃ at the end, in Y, against finite volumes on fine cells; the error of these is
their largest difference to the Fourier method, also refined. Where a scheme has both cells and a
tolerance, the tolerance is tied to the sixth power of the cell width, so that neither is wasted.

All runs take turns, on one thread, after one of each kind has compiled everything and filled the
caches; short runs are repeated within their turn, and the least wall-clock time counts.
"""

import os
import platform
import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pandas as pd

from granular_fronts.continuum.log_burgers.solution import START_LEVELS, solve
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.progress import counted
from granular_fronts.reference_methods import upwind
from granular_fronts.reference_methods.fourier import evolve_fourier
from step import run_step

TOLERANCE_PER_WIDTH = 0.05
EVALUATED_POINTS = 8192
SHORTEST_TURN = 0.05
SMOOTH_POINTS, SMOOTH_SHARPNESS = 257, 12.0


class Outcome(NamedTuple):
    """Points ξ̃ and values Y at the end of a run, and its work."""

    xi: np.ndarray
    values: np.ndarray
    steps: int
    right_hand_sides: int


Finish = Callable[[], Outcome]
"""Gives the outcome of a run that has ended, untimed."""


class Run(NamedTuple):
    """What to solve and how."""

    start: str
    scheme: str
    grid: int
    setting: float
    solve: Callable[[], Finish]


def measure_log_burgers(problems: dict, scenes: dict, dataset: Path) -> None:
    """Solve the rings by every scheme over its grids, and keep errors and times.

    Parameters
    ----------
    problems : dict
        As under ``precision.log_burgers`` of the configuration; its keys name scenes.
    scenes : dict
        As under ``scenes.periodic`` of the configuration.
    dataset : Path
        The netCDF file to write, on (run).
    """
    load_before = os.getloadavg()[0]
    rows = [
        {"scene": name, "alpha": scenes[name]["law"]["alpha"]} | row
        for name, problem in problems.items()
        for row in measure_scene(name, problem, scenes[name])
    ]
    measured = pd.DataFrame(rows).rename_axis("run").to_xarray()
    measured["seconds"].attrs["units"] = "s"
    measured["error"].attrs = {
        "long_name": "largest error of Y over xi at the end",
        "error_method": "this is the distance to the reference",
    }
    measured.attrs = {
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, Python "
        f"{platform.python_version()}",
        "load_before": load_before,
        "solver": "least wall-clock time of the repeats, one thread",
    }
    config = {name: {"problem": problems[name], "scene": scenes[name]} for name in problems}
    write_dataset(measured, dataset, scene_id="precision_log_burgers", config=config)


def measure_scene(name: str, problem: dict, scene: dict) -> list[dict]:
    """Errors, times and work of all runs on one ring, a row for each.

    `problem` is an entry of ``precision.log_burgers``, `scene` one of ``scenes.periodic``.
    """
    scenes = {"kinks": scene, "smooth": scene | {"start": _smooth_start()}}
    references = {start: _solve_reference(problem["reference"], scenes[start]) for start in scenes}
    runs = list(_list_runs(problem, scenes))
    for run in {run.scheme: run for run in reversed(runs)}.values():
        run.solve()
    seconds = [np.inf] * len(runs)
    finish: dict[int, Finish] = {}
    turns = list(product(range(problem["repeats"]), enumerate(runs)))
    for _, (index, run) in counted(turns, f"precision, {name}", "run"):
        least, finish[index] = _time_turn(run.solve)
        seconds[index] = min(seconds[index], least)
    outcomes = [finish[index]() for index in range(len(runs))]
    return [
        {
            "start": run.start,
            "scheme": run.scheme,
            "grid": run.grid,
            "setting": run.setting,
            "error": distance(references[run.start][0], outcome),
            "reference_error": references[run.start][1],
            "seconds": least,
            "steps": outcome.steps,
            "right_hand_sides": outcome.right_hand_sides,
        }
        for run, outcome, least in zip(runs, outcomes, seconds, strict=True)
    ]


def _time_turn(solve: Callable[[], Finish]) -> tuple[float, Finish]:
    """Least time of the runs of one turn, and what the last of them gave."""
    begun, least = time.perf_counter(), np.inf
    while time.perf_counter() - begun < SHORTEST_TURN:
        started = time.perf_counter()
        result = solve()
        least = min(least, time.perf_counter() - started)
    return least, result


def _list_runs(problem: Mapping[str, Any], scenes: Mapping[str, Any]) -> Iterator[Run]:
    """All runs on one ring, coarse ones first within a scheme."""
    kinks = scenes["kinks"]
    for points in problem["upwind_points"]:
        setting = upwind_step(kinks, points)
        yield Run("kinks", "upwind", points, setting, partial(_run_upwind, kinks, points))
    for start, scheme, levels in (
        ("kinks", "finite_volumes", START_LEVELS),
        ("kinks", "uniform_cells", 0),
        ("smooth", "finite_volumes", START_LEVELS),
    ):
        scene = scenes[start]
        for cells in problem["cells"]:
            tolerance = TOLERANCE_PER_WIDTH * (length(scene) / cells) ** 6
            solve_cells = partial(_run_cells, scene, cells, tolerance, levels)
            yield Run(start, scheme, cells, tolerance, solve_cells)
    points = problem["reference"]["points"]
    for step in problem["longest_steps"]:
        yield Run("kinks", "fourier", points, step, partial(_run_fourier, kinks, points, step))


def _run_upwind(scene: Mapping[str, Any], points: int) -> Finish:
    """The paper's scheme."""
    half_length = 0.5 * length(scene)
    values = make_start(scene["start"]).values(upwind.grid(half_length, points), half_length)
    run = upwind.evolve_upwind(values, half_length, _end_of(scene))
    return lambda: Outcome(run.xi, run.values, run.steps, run.steps)


def upwind_step(scene: Mapping[str, Any], points: int) -> float:
    """Time step that the paper takes on these points."""
    fastest = abs(np.log(scene["start"]["floor"]))
    return upwind.PAPER_FRACTION * upwind.largest_step(length(scene) / points, fastest)


def _run_cells(scene: Mapping[str, Any], cells: int, tolerance: float, levels: int) -> Finish:
    """Finite volumes."""
    evolution = solve(scene, 1.0, [scene["end_time"]], cells, tolerance, levels)
    counts, half_length = evolution.counts, evolution.half_length
    xi = upwind.grid(half_length, EVALUATED_POINTS)
    return lambda: Outcome(
        xi,
        evolution.rescaled_force(0, xi),
        counts["steps_accepted"],
        counts["right_hand_sides"],
    )


def _run_fourier(scene: Mapping[str, Any], points: int, longest_step: float) -> Finish:
    """The Fourier method, of four right-hand sides per step."""
    run = evolve_fourier(scene, points, longest_step)
    return lambda: Outcome(run.xi, run.values, run.steps, 4 * run.steps)


def _solve_reference(reference: Mapping[str, Any], scene: Mapping[str, Any]) -> tuple[Any, float]:
    """Finite volumes on fine cells, and how far the Fourier method is from them."""
    accurate = solve(scene, 1.0, [scene["end_time"]], reference["cells"], reference["tolerance"])
    independent = _run_fourier(scene, reference["points"], reference["longest_step"])()
    return accurate, distance(accurate, independent)


def distance(accurate: Any, outcome: Outcome) -> float:
    """Largest difference of Y over the points of an outcome."""
    return float(np.abs(outcome.values - accurate.rescaled_force(0, outcome.xi)).max())


def _smooth_start() -> dict[str, Any]:
    """An analytic bump of height 1: exp of a cosine."""
    angle = np.pi * np.linspace(-1.0, 1.0, SMOOTH_POINTS)
    force = np.exp(SMOOTH_SHARPNESS * (np.cos(angle) - 1.0))
    force[-1] = force[0]
    return {"kind": "given", "rescaled_force": force}


def length(scene: Mapping[str, Any]) -> float:
    """Of the ring, 2ℓ."""
    return 2.0 * scaling_of(scene).half_length(scene["half_beads"])


def _end_of(scene: Mapping[str, Any]) -> float:
    """τ at the end."""
    return scaling_of(scene).slow_rate * scene["end_time"]


if __name__ == "__main__":
    run_step(measure_log_burgers, globals().get("snakemake"))
