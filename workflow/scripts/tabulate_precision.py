"""How long each method takes to reach an error, and how much longer than ours."""

from pathlib import Path

import numpy as np
import pandas as pd

from granular_fronts.datasets import read_dataset
from granular_fronts.files import complete_file
from step import run_step

OURS = "strain_form"
LEVELS = (1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)


def tabulate_precision(dataset: Path, csv: Path, markdown: Path) -> None:
    """Compare all methods at equal error.

    Parameters
    ----------
    dataset : Path
        Written by measure_precision.
    csv, markdown : Path
        Tables to write.
    """
    data = read_dataset(dataset, "precision_chain")
    rows = [
        row
        for problem in data["problem"].values
        for level in LEVELS
        for row in compare_methods(data.sel(problem=problem), problem, level)
        if np.isfinite(row["milliseconds"])
    ]
    table = pd.DataFrame(rows)
    with complete_file(csv) as unfinished:
        table.to_csv(unfinished, index=False)
    rounded = table.map(lambda cell: f"{cell:.3g}" if isinstance(cell, float) else cell)
    with complete_file(markdown) as unfinished:
        rounded.to_markdown(unfinished, index=False, disable_numparse=True)


def compare_methods(data, problem, level):
    """Rows of one problem at one error level, without time for methods that never reach it."""
    ours = time_to_reach(data.sel({"method": OURS}), level)
    for method in data["method"].values:
        chosen = data.sel({"method": method})
        if not np.isfinite(chosen["error"]).any():
            continue
        milliseconds = time_to_reach(chosen, level)
        yield {
            "problem": problem,
            "error": level,
            "method": method,
            "milliseconds": milliseconds,
            "times_ours": milliseconds / ours,
            "best_error": float(chosen["error"].min()),
            "reference_error": float(data["reference_error"]),
            "remark": "; ".join(sorted(set(chosen["message"].values) - {""})),
        }


def time_to_reach(chosen, level):
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


if __name__ == "__main__":
    run_step(tabulate_precision, globals().get("snakemake"))
