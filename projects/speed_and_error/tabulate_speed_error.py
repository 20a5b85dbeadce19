"""How long each method takes to reach an error, how much longer than ours, and what to use."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from step import run_step

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table

LEVELS = (1e-4, 1e-6, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14)
JUDGED_LEVELS = (1e-4, 1e-5, 1e-6, 1e-9, 1e-12)
# The one that a time limit is for; without a limit it is not judged.
LIMITED_LEVEL = 1e-5
COUNTS = ["grid", "right_hand_sides", "steps"]
PAPERS_WAY = ("scilab_ode", "upwind")
# Discrete-element codes, which are built for millions of particles in space and keep their step.
CODES = ("lammps_nve", "lammps_mvv")
# Ending of a method whose grid is given: to be timed, while users call the one that chooses it.
ON_GIVEN_GRID = "_on_grid"
PACKAGES = ("diffrax", "lammps", "numbalsoda", "scilab", "scipy", "upwind")
BUSY = "timed while the machine was busy"


def tabulate_speed_error(
    dataset: Path,
    csv: Path,
    markdown: Path,
    verdicts_csv: Path,
    verdicts_markdown: Path,
    runs_csv: Path,
    runs_markdown: Path,
) -> None:
    """Compare all methods at equal error, and say for each problem which to use.

    Parameters
    ----------
    dataset : Path
        Written by merge_precision.
    csv, markdown : Path
        Tables of times to write.
    verdicts_csv, verdicts_markdown : Path
        Tables of sentences to write.
    runs_csv, runs_markdown : Path
        Tables of all runs to write, with observed orders.
    """
    data = read_dataset(dataset, "speed_error")
    table = pd.DataFrame(
        [
            row
            for problem in data["problem"].values
            for level in LEVELS
            for row in _compare_methods(data.sel(problem=problem), level)
        ]
    )
    verdicts = pd.DataFrame(
        [
            {"problem": problem, "error": f"{level:.0e}", "verdict": verdict}
            for problem in data["problem"].values
            for level in JUDGED_LEVELS
            if (verdict := judge(data.sel(problem=problem), level))
        ]
    )
    write_table(table, round_floats(table, 3), csv, markdown)
    write_table(verdicts, verdicts, verdicts_csv, verdicts_markdown)
    runs = list_runs(data)
    rounded = round_floats(runs.assign(**runs[COUNTS].map("{:.0f}".format)), 3).replace("nan", "")
    write_table(runs, rounded, runs_csv, runs_markdown)


def list_runs(data: xr.Dataset) -> pd.DataFrame:
    """Return all runs, each with the order of convergence in the tolerance from the one before it.

    Where the tolerance is a step or the width of a cell, this is the order of the method.
    """
    kept = data[["error", "reference_error", "seconds", *COUNTS, "disturbed"]]
    runs = kept.sortby("step_tolerance", ascending=False).to_dataframe().reset_index()
    runs = runs.rename(columns={"solver": "method", "step_tolerance": "tolerance"})
    runs = runs.dropna(subset="disturbed")
    runs.insert(3, "milliseconds", 1e3 * runs.pop("seconds"))
    fineness = np.log(runs[["error", "tolerance"]]).groupby([runs["problem"], runs["method"]])
    runs["order"] = fineness.diff()["error"] / fineness.diff()["tolerance"]
    return runs.drop(columns="disturbed")


def _compare_methods(data: xr.Dataset, level: float) -> Iterator[dict[str, Any]]:
    """Rows of one problem at one error, for the methods that reach it."""
    times = _times_to_reach(data, level)
    own = str(data["own_method"].item())
    for method, milliseconds in times.items():
        chosen = data.sel(solver=method)
        yield {
            "problem": str(data["problem"].item()),
            "error": level,
            "method": method,
            "milliseconds": milliseconds,
            "times_ours": milliseconds / times.get(own, np.nan),
            "best_error": float(chosen["error"].min()),
            "reference_error": float(data["reference_error"]),
            "remark": remark(chosen),
        }


def remark(chosen: xr.Dataset) -> str:
    """Return what to know of the runs of one method."""
    remarks = sorted(set(chosen["message"].values) - {""})
    if (chosen["below_reference"] == 1.0).any():
        remarks.append("closer than the error of the reference")
    if (chosen["disturbed"] == 1.0).any():
        remarks.append(BUSY)
    return "; ".join(remarks)


def _times_to_reach(data: xr.Dataset, level: float) -> dict[str, float]:
    """Return the milliseconds to an error, of every method that reaches it, the fastest first."""
    times = {
        str(method): _time_to_reach(data.sel(solver=method), level)
        for method in data["solver"].values
    }
    reached = {method: time for method, time in times.items() if np.isfinite(time)}
    return dict(sorted(reached.items(), key=lambda item: item[1]))


def _time_to_reach(chosen: xr.Dataset, level: float) -> float:
    """Milliseconds of the fastest run to an error of at most `level`, log-interpolated, or NaN."""
    finite = np.isfinite(chosen["error"].values)
    order = np.argsort(chosen["error"].values[finite])
    error = chosen["error"].values[finite][order]
    seconds = np.minimum.accumulate(chosen["seconds"].values[finite][order])
    if error.size == 0 or level < error[0]:
        return np.nan
    return 1e3 * np.exp(np.interp(np.log(level), np.log(error), np.log(seconds)))


def judge(data: xr.Dataset, level: float) -> str:
    """Return a sentence on what to use for one problem to reach one error.

    Nothing is said where the reference is no better than the error, nor of a level without its time
    limit.  A method on a given grid is named together with the one that finds its grid itself,
    which users call.
    """
    unlimited = level == LIMITED_LEVEL and np.isnan(float(data["time_limit"]))
    if unlimited or level < float(data["reference_error"]):
        return ""
    reached, own = _times_to_reach(data, level), str(data["own_method"].item())
    times = _without_given_grids(reached)
    if not times:
        best = data["error"].min("step_tolerance")
        closest = best["solver"].values[int(best.argmin("solver"))]
        return f"Nobody reached {level:.0e}; {closest} came closest with {float(best.min()):.1e}."
    fastest = next(iter(times))
    others = _rivals(times, fastest, own)
    compared = [
        f"{short(times[other] / times[fastest])} times faster than {other}" for other in others
    ]
    sentence = f"To {level:.0e} use {fastest} ({times[fastest]:.3g} ms)"
    sentence += f", {' and '.join(compared)}" if compared else ", which alone reached it"
    given = f"{fastest}{ON_GIVEN_GRID}"
    alone = [f"on a given grid {reached[given]:.3g} ms"] if given in reached else []
    named = [fastest, *others, *([given] if alone else [])]
    busy = (data["disturbed"].sel(solver=named) == 1.0).any()
    papers = _compare_papers_way(data, times)
    limit = _keep_limit(data, times, level)
    remarks = [*alone, *papers, *limit, *_compare_codes(data, times), *([BUSY] if busy else [])]
    return "; ".join([sentence, *remarks]) + "."


def _compare_papers_way(data: xr.Dataset, times: dict[str, float]) -> Iterator[str]:
    """A remark on each method of the paper that did not get there, and what its best run costs."""
    fastest = next(iter(times))
    for method in PAPERS_WAY:
        if fails(data, times, method):
            best = float(data["error"].sel(solver=method).min())
            needed, ours = (_time_to_reach(data.sel(solver=m), best) for m in (method, fastest))
            yield (
                f"{method} did not get there with the tolerances asked: it comes to {best:.1e} in "
                f"{needed:.3g} ms, {short(needed / ours)} times as long as {fastest}"
            )


def _keep_limit(data: xr.Dataset, times: dict[str, float], level: float) -> Iterator[str]:
    """A remark on the time within which our method was to reach the level that has a limit."""
    if level == LIMITED_LEVEL:
        own, limit = str(data["own_method"].item()), 1e3 * float(data["time_limit"])
        verb = "keeps" if times.get(own, np.inf) <= limit else "misses"
        yield f"{own} {verb} its limit of {limit:g} ms"


def _compare_codes(data: xr.Dataset, times: dict[str, float]) -> Iterator[str]:
    """A remark on the faster scheme of the discrete-element code that was tried."""
    (fastest, least), codes = next(iter(times.items())), [name for name in times if name in CODES]
    if codes:
        yield f"{codes[0]} takes {short(times[codes[0]] / least)} times as long as {fastest}"
    elif any(fails(data, times, method) for method in CODES):
        yield "no scheme of lammps got there with the steps tried"


def _without_given_grids(times: dict[str, float]) -> dict[str, float]:
    """Return the methods that find their grid themselves, or all where none of these is left."""
    found = {name: time for name, time in times.items() if not name.endswith(ON_GIVEN_GRID)}
    return found or times


def _rivals(times: dict[str, float], fastest: str, own: str) -> list[str]:
    """Return rivals of the fastest: the best of the other side, and the paper's own way."""
    others = [method for method in times if method != fastest]
    if _is_peer(fastest):
        chosen = [own] if own in others else []
    else:
        chosen = [method for method in others if _is_peer(method)][:1] or others[:1]
    return chosen + [method for method in others if method in PAPERS_WAY and method not in chosen]


def short(ratio: float) -> str:
    """Return a ratio of times, which are known to two digits at best."""
    return f"{float(f'{ratio:.2g}'):g}"


def fails(data: xr.Dataset, times: dict[str, float], method: str) -> bool:
    """Return whether a method was tried and never came so close."""
    tried = method in data["solver"].values and np.isfinite(data.sel(solver=method)["error"])
    return bool(np.any(tried)) and method not in times


def _is_peer(method: str) -> bool:
    """Return whether a method is somebody else's."""
    return method.split("_")[0] in PACKAGES


if __name__ == "__main__":
    run_step(tabulate_speed_error, globals()["snakemake"])
