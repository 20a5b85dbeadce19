"""How long each method takes to reach an error, how much longer than ours, and what to use."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from step import run_step

LEVELS = (1e-4, 1e-6, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14)
JUDGED_LEVELS = (1e-4, 1e-6, 1e-9, 1e-12)
PAPERS_WAY = ("scilab_ode", "upwind")
# Discrete-element codes, which are built for millions of particles in space and keep their step.
CODES = ("lammps_nve", "lammps_mvv")
# Ending of a method whose grid is given: to be timed, while users call the one that chooses it.
ON_GIVEN_GRID = "_on_grid"
PACKAGES = ("diffrax", "lammps", "numbalsoda", "scilab", "scipy", "sundials", "upwind")
BUSY = "timed while the machine was busy"


def tabulate_speed_error(
    dataset: Path, csv: Path, markdown: Path, verdicts_csv: Path, verdicts_markdown: Path
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
    write_table(table, round_floats(table, 3), csv, markdown, [data])
    write_table(verdicts, verdicts, verdicts_csv, verdicts_markdown, [data])


def _compare_methods(data: xr.Dataset, level: float) -> Iterator[dict[str, Any]]:
    """Rows of one problem at one error, for the methods that reach it."""
    times = _times_to_reach(data, level)
    own = str(data["own_method"].item())
    for method, milliseconds in times.items():
        chosen = data.sel({"method": method})
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
    """What to know of the runs of one method."""
    remarks = sorted(set(chosen["message"].values) - {""})
    if (chosen["below_reference"] == 1.0).any():
        remarks.append("closer than the error of the reference")
    if (chosen["disturbed"] == 1.0).any():
        remarks.append(BUSY)
    return "; ".join(remarks)


def _times_to_reach(data: xr.Dataset, level: float) -> dict[str, float]:
    """Milliseconds to an error, of every method that reaches it, the fastest first."""
    times = {
        str(method): _time_to_reach(data.sel({"method": method}), level)
        for method in data["method"].values
    }
    reached = {method: time for method, time in times.items() if np.isfinite(time)}
    return dict(sorted(reached.items(), key=lambda item: item[1]))


def _time_to_reach(chosen: xr.Dataset, level: float) -> float:
    """Milliseconds to an error of `level`, interpolated in the logarithms; NaN if never reached.

    Of all runs the fastest with at most a given error counts, so that the curve is monotone.
    """
    finite = np.isfinite(chosen["error"].values)
    order = np.argsort(chosen["error"].values[finite])
    error = chosen["error"].values[finite][order]
    seconds = np.minimum.accumulate(chosen["seconds"].values[finite][order])
    if error.size == 0 or level < error[0]:
        return np.nan
    return 1e3 * np.exp(np.interp(np.log(level), np.log(error), np.log(seconds)))


def judge(data: xr.Dataset, level: float) -> str:
    """A sentence on what to use for one problem to reach one error.

    Nothing is said where the reference is no better than the error.  A method on a given grid is
    named beside the one that finds its grid itself, which is what a user calls.
    """
    if level < float(data["reference_error"]):
        return ""
    reached, own = _times_to_reach(data, level), str(data["own_method"].item())
    times = _without_given_grids(reached)
    if not times:
        best = data["error"].min("tolerance")
        closest = best["method"].values[int(best.argmin("method"))]
        return f"Nobody reached {level:.0e}; {closest} came closest with {float(best.min()):.1e}."
    fastest = next(iter(times))
    others = _rivals(times, fastest, own)
    compared = [
        f"{short(times[other] / times[fastest])} times faster than {other}" for other in others
    ]
    unreached = [
        f"{method} did not get there with the tolerances asked"
        for method in PAPERS_WAY
        if fails(data, times, method)
    ]
    sentence = f"To {level:.0e} use {fastest} ({times[fastest]:.3g} ms)"
    sentence += f", {' and '.join(compared)}" if compared else ", which alone reached it"
    given = f"{fastest}{ON_GIVEN_GRID}"
    alone = [f"on a given grid {reached[given]:.3g} ms"] if given in reached else []
    named = [fastest, *others, *([given] if alone else [])]
    busy = (data["disturbed"].sel({"method": named}) == 1.0).any()
    remarks = [*alone, *unreached, *_compare_codes(data, times), *([BUSY] if busy else [])]
    return "; ".join([sentence, *remarks]) + "."


def _compare_codes(data: xr.Dataset, times: dict[str, float]) -> Iterator[str]:
    """A remark on the faster scheme of the discrete-element code that was tried."""
    (fastest, least), codes = next(iter(times.items())), [name for name in times if name in CODES]
    if codes:
        yield f"{codes[0]} takes {short(times[codes[0]] / least)} times as long as {fastest}"
    elif any(fails(data, times, method) for method in CODES):
        yield "no scheme of lammps got there with the steps tried"


def _without_given_grids(times: dict[str, float]) -> dict[str, float]:
    """The methods that find their grid themselves, or all where none of these is left."""
    found = {name: time for name, time in times.items() if not name.endswith(ON_GIVEN_GRID)}
    return found or times


def _rivals(times: dict[str, float], fastest: str, own: str) -> list[str]:
    """Whom to compare the fastest with: the best of the other side, and the paper's own way."""
    others = [method for method in times if method != fastest]
    if _is_peer(fastest):
        chosen = [own] if own in others else []
    else:
        chosen = [method for method in others if _is_peer(method)][:1] or others[:1]
    return chosen + [method for method in others if method in PAPERS_WAY and method not in chosen]


def short(ratio: float) -> str:
    """A ratio of times, which are known to two digits at best."""
    return f"{float(f'{ratio:.2g}'):g}"


def fails(data: xr.Dataset, times: dict[str, float], method: str) -> bool:
    """Whether a method was tried and never came so close."""
    tried = method in data["method"].values and np.isfinite(data.sel({"method": method})["error"])
    return bool(np.any(tried)) and method not in times


def _is_peer(method: str) -> bool:
    """Whether a method is somebody else's."""
    return method.split("_")[0] in PACKAGES


if __name__ == "__main__":
    run_step(tabulate_speed_error, globals().get("snakemake"))
