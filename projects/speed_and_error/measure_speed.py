"""Speed against error: our solvers and other people's on the same problems, side by side.

The methods of a problem run in one process, on one thread and in turns, so that a slow moment of
the machine hits all of them.  Each has run once before, to compile and to fill the caches.  Of the
repeats the least time counts.  A method that is not installed is named and left out.  One that
fails is kept, without an error but with its reason.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

# Libraries read their limits when they are imported.
from peers import one_thread  # noqa: F401

# isort: split
import pandas as pd
import xarray as xr

from granular_fronts.errors import SolveError
from granular_fronts.output.datasets import write_dataset
from job import job
from peers.runs import Run
from problems.chain import make_chain
from problems.fronts import make_front
from problems.log_burgers import make_ring
from problems.problem import Problem, error_of

# A longer run is timed once: what disturbs it for a moment is a small part of it.
SECONDS_WORTH_REPEATING = 3.0
# Share of a processor below which a run waited for others, or above which it used more than one.
UNDISTURBED = (0.95, 1.05)
LONG_NAMES = {
    "run": "number of the run",
    "problem": "problem solved",
    "method": "what solved it",
    "fineness": "relative tolerance, longest step, or number of cells or points",
    "error": "largest distance of any field to the reference, at least the reference's own error",
    "reference_error": "error of the reference itself",
    "seconds": "wall-clock time of the solve alone",
    "disturbed": "whether something else took part of the machine meanwhile",
    "message": "why there is no result, or an uncertain one",
}


def measure_speed(settings: dict, ring: dict, chain_states: str, fronts: str, dataset: str) -> None:
    """Solve every problem by every method, and keep errors and times.

    Parameters
    ----------
    settings : dict
        Of the project, as in its config.yaml.
    ring : dict
        The periodic scene that is solved by the logarithmic Burgers equation.
    chain_states, fronts : str
        Files with accurate solutions.
    dataset : str
        The netCDF file to write, on (run).
    """
    makers = {
        "chain": partial(make_chain, states=xr.load_dataset(chain_states)),
        "front": partial(make_front, states=xr.load_dataset(fronts)),
        "ring": partial(make_ring, scene=ring),
    }
    rows: list[dict[str, Any]] = []
    absent: set[str] = set()
    for name, given in settings["tasks"].items():
        problem = makers[given["kind"]](given)
        found, missing = measure(problem, given["methods"], settings["repeats"])
        rows += [{"problem": name} | row for row in found]
        absent |= missing
    measured = pd.DataFrame(rows).rename_axis("run").to_xarray()
    for variable, words in LONG_NAMES.items():
        measured[variable].attrs["long_name"] = words
    measured["seconds"].attrs["units"] = "s"
    measured["error"].attrs["error_method"] = "this is the distance to the reference"
    measured.attrs["absent"] = ", ".join(sorted(absent))
    write_dataset(measured, dataset, scene_id="speed_error", config=settings)


def measure(
    problem: Problem, methods: Mapping[str, Sequence[float]], repeats: int
) -> tuple[list[dict[str, Any]], set[str]]:
    """Return a row for each method and fineness, and the methods that are not installed."""
    missing = set()
    for method, (coarsest, *_) in methods.items():
        if (run := _attempt(problem, method, coarsest)).absent:
            print(f"{method} is left out: {run.message}.")
            missing.add(method)
    best: dict[tuple[str, float], Run] = {}
    points = [(name, one) for name in methods if name not in missing for one in methods[name]]
    for point in points * repeats:
        if point in best and not best[point].seconds < SECONDS_WORTH_REPEATING:
            continue
        run = _attempt(problem, *point)
        if point not in best or run.seconds < best[point].seconds:
            best[point] = run
    rows = [
        {
            "method": method,
            "fineness": fineness,
            "error": error_of(run, problem),
            "reference_error": problem.reference_error,
            "seconds": run.seconds,
            "disturbed": _is_disturbed(run),
            "message": run.message,
        }
        for (method, fineness), run in best.items()
    ]
    return rows, missing


def _attempt(problem: Problem, method: str, fineness: float) -> Run:
    """Run a method once; the reason why a solver stopped is kept."""
    try:
        return problem.methods[method](fineness)
    except (ArithmeticError, SolveError) as error:
        return Run(message=str(error))


def _is_disturbed(run: Run) -> int:
    """Return whether a run waited for others, or used more than one processor."""
    share = run.cpu_seconds / run.seconds
    return int(share < UNDISTURBED[0] or share > UNDISTURBED[1])


if __name__ == "__main__":
    with job(snakemake):
        measure_speed(
            snakemake.params.settings,
            snakemake.params.ring,
            snakemake.input.chain_states,
            snakemake.input.fronts,
            snakemake.output.dataset,
        )
