"""Tabulate the hard cases: the limit, the result, passed or failed."""

from pathlib import Path

from step import run_step

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table

COLUMNS = ["name", "problem", "expected", "criterion", "quantity", "measured", "error", "limit"]
COLUMNS += ["outcome", "seconds", "remark"]


def tabulate_hard_cases(dataset: Path, csv: Path, markdown: Path) -> None:
    """Write a row for each case.

    Parameters
    ----------
    dataset : Path
        Written by measure_hard_cases.
    csv, markdown : Path
        Tables to write.
    """
    data = read_dataset(dataset, "hard_cases")
    rows = data.drop_dims(["solver", "rung"]).to_dataframe().reset_index()
    rows["outcome"] = rows["passed"].map({1: "passed", 0: "failed"})
    table = rows.rename(columns={"case": "name", "message": "remark"})[COLUMNS]
    write_table(table, round_floats(table, 3), csv, markdown)


if __name__ == "__main__":
    run_step(tabulate_hard_cases, globals()["snakemake"])
