"""How long each method takes to reach an error, and how much longer than the fastest."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pandas as pd

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job

LEVELS = (1e-4, 1e-6, 1e-9, 1e-12)


def tabulate_speed_error(
    dataset: str, csv: str, markdown: str, runs_csv: str, runs_markdown: str
) -> None:
    """Compare all methods at equal error, and list all runs.

    Parameters
    ----------
    dataset : str
        Written by measure_speed.
    csv, markdown : str
        Tables to write of the times to reach an error, the fastest method first.
    runs_csv, runs_markdown : str
        Tables to write of all runs.
    """
    runs = read_dataset(dataset, "speed_error").to_dataframe()
    table = pd.DataFrame(
        [
            row
            for _, of_problem in runs.groupby("problem", sort=False)
            for level in LEVELS
            for row in compare_methods(of_problem, level)
        ]
    )
    write_table(table, round_floats(table, 3), csv, markdown)
    write_table(runs, round_floats(runs, 3), runs_csv, runs_markdown)


def compare_methods(runs: pd.DataFrame, level: float) -> Iterator[dict[str, Any]]:
    """Yield the methods that reach an error in one problem, the fastest first.

    Nothing is said where the reference is no better than the error.
    """
    if level < runs["reference_error"].iloc[0]:
        return
    times = {method: time_to_reach(of, level) for method, of in runs.groupby("method", sort=False)}
    reached = {method: time for method, time in times.items() if np.isfinite(time)}
    for method, milliseconds in sorted(reached.items(), key=lambda item: item[1]):
        yield {
            "problem": runs["problem"].iloc[0],
            "error": level,
            "method": method,
            "milliseconds": milliseconds,
            "times_the_fastest": milliseconds / min(reached.values()),
            "disturbed": int(runs.loc[runs["method"] == method, "disturbed"].any()),
        }


def time_to_reach(runs: pd.DataFrame, level: float) -> float:
    """Return the milliseconds of one method to an error of at most `level`, NaN if none came there.

    Between its runs the time is interpolated in logarithms.
    """
    found = runs.dropna(subset="error").sort_values("error")
    if found.empty or level < found["error"].iloc[0]:
        return np.nan
    seconds = np.minimum.accumulate(found["seconds"])
    return 1e3 * float(np.exp(np.interp(np.log(level), np.log(found["error"]), np.log(seconds))))


if __name__ == "__main__":
    with job(snakemake):
        tabulate_speed_error(
            snakemake.input.dataset,
            snakemake.output.csv,
            snakemake.output.markdown,
            snakemake.output.runs_csv,
            snakemake.output.runs_markdown,
        )
