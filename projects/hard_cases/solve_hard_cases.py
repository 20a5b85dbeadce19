"""Solve the hard cases, and keep and tabulate how far each is from its known answer."""

import numpy as np
import pandas as pd

from edge_cases import CASES
from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job

LONG_NAMES = {
    "case": "problem at the edge of what the solvers can do",
    "answer": "what the answer is known from",
    "error": "largest distance from the answer",
    "limit": "largest error that passes",
}


def solve_hard_cases(dataset: str, csv: str, markdown: str) -> None:
    """Solve each case once.

    Parameters
    ----------
    dataset : str
        The netCDF file to write, on (case).
    csv, markdown : str
        The table to write: all digits, and rounded for people.
    """
    rows = []
    for name, solve in CASES.items():
        print(f"Solving {name}.")
        rows.append({"case": name} | solve()._asdict())
    table = pd.DataFrame(rows)
    solved = table.set_index("case").to_xarray()
    for name, words in LONG_NAMES.items():
        solved[name].attrs["long_name"] = words
    write_dataset(solved, dataset, scene_id="hard_cases", config={})
    table["outcome"] = np.where(table["error"] <= table["limit"], "passed", "failed")
    write_table(table, round_floats(table, 2), csv, markdown)


if __name__ == "__main__":
    with job(snakemake):
        solve_hard_cases(snakemake.output.dataset, snakemake.output.csv, snakemake.output.markdown)
