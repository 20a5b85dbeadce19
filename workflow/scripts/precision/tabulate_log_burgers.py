"""Errors, times and observed orders of the solvers of the logarithmic Burgers equation."""

from pathlib import Path

import numpy as np
import pandas as pd

from granular_fronts.output.datasets import configuration_of, read_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.output.provenance import write_provenance
from granular_fronts.output.tables import round_floats
from step import run_step

COARSE_ERROR, FINE_ERROR = 1.0e-5, 1.0e-8
TIMES_UPWIND = 1000.0
COLUMNS = [
    "alpha",
    "start",
    "scheme",
    "grid",
    "setting",
    "error",
    "reference_error",
    "milliseconds",
    "steps",
    "right_hand_sides",
    "order",
]


def tabulate_log_burgers(dataset: Path, csv: Path, markdown: Path) -> None:
    """List all runs with their observed orders, and say what was reached.

    Parameters
    ----------
    dataset : Path
        Written by measure_log_burgers.
    csv, markdown : Path
        Tables to write; below the second stands a sentence for each exponent.
    """
    data = read_dataset(dataset, "precision_log_burgers")
    problems = configuration_of(data)
    runs = data.to_dataframe().reset_index(drop=True)
    runs["milliseconds"] = 1e3 * runs["seconds"]
    groups = runs.groupby(["scene", "start", "scheme"], sort=False)
    runs["order"] = pd.concat([observed_order(group) for _, group in groups])
    sentences = [
        judge(group, problems[scene]["problem"]["milliseconds"])
        for scene, group in runs.groupby("scene", sort=False)
    ]
    with complete_file(csv) as unfinished:
        runs[COLUMNS].to_csv(unfinished, index=False)
    rounded = round_floats(runs[COLUMNS], 3)
    table = rounded.replace("nan", "").to_markdown(index=False, disable_numparse=True)
    with complete_file(markdown) as unfinished:
        unfinished.write_text("\n\n".join([table, *sentences]) + "\n", encoding="utf-8")
    write_provenance(csv.with_suffix(".json"), [csv, markdown], [data])


def observed_order(group: pd.DataFrame) -> pd.Series:
    """Order of convergence from each run and the one before it; none for the first.

    The Fourier method converges with its step, all others with their grid.
    """
    fourier = (group["scheme"] == "fourier").all()
    fineness = 1.0 / group["setting"] if fourier else group["grid"].astype(float)
    return -np.log(group["error"]).diff() / np.log(fineness).diff()


def judge(runs: pd.DataFrame, milliseconds: float) -> str:
    """A sentence on what the finite volumes reach for one exponent.

    `COARSE_ERROR` was asked for within so many milliseconds.
    """
    kinked = runs[runs["start"] == "kinks"]
    paper = kinked[kinked["scheme"] == "upwind"].iloc[-1]
    ours = kinked[kinked["scheme"] == "finite_volumes"]
    coarse, fine = _time_to_reach(ours, COARSE_ERROR), _time_to_reach(ours, FINE_ERROR)
    ratio = paper["milliseconds"] / _time_to_reach(ours, paper["error"])
    reached = coarse <= milliseconds and np.isfinite(fine) and ratio >= TIMES_UPWIND
    return (
        f"α = {paper['alpha']:g}: the paper's scheme on {paper['grid']} points errs by "
        f"{paper['error']:.2g} and takes {paper['milliseconds']:.3g} ms; the finite volumes are as "
        f"accurate {ratio:.3g} times faster (asked: {TIMES_UPWIND:g}), come to {COARSE_ERROR:g} "
        f"{in_words(coarse)} (asked: {milliseconds:g} ms) and to {FINE_ERROR:g} {in_words(fine)}: "
        f"{'all' if reached else 'not all'} that was asked for is reached."
    )


def in_words(milliseconds: float) -> str:
    """A time in words."""
    return f"in {milliseconds:.3g} ms" if np.isfinite(milliseconds) else "never"


def _time_to_reach(runs: pd.DataFrame, error: float) -> float:
    """Milliseconds of the fastest run with at most an error; infinite if there is none."""
    return runs.loc[runs["error"] <= error, "milliseconds"].to_numpy().min(initial=np.inf)


if __name__ == "__main__":
    run_step(tabulate_log_burgers, globals().get("snakemake"))
