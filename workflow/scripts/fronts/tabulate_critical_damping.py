"""Table of critical damping in its several meanings."""

from pathlib import Path

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from step import run_step

PREFIX = "critical_damping_"


def tabulate_critical_damping(dataset: Path, csv: Path, markdown: Path) -> None:
    """Write every definition over the exponent, and its ratio to the long-wave formula.

    Parameters
    ----------
    dataset : Path
        The damping map.
    csv, markdown : Path
        Tables to write: all digits, and rounded for people.
    """
    data = read_dataset(dataset)
    curves = data[[name for name in data.data_vars if str(name).startswith(PREFIX)]]
    table = curves.to_dataframe().reset_index()
    table.columns = [name.removeprefix(PREFIX).replace("_", " ") for name in table.columns]
    table["tail over long wave"] = table["tail"] / table["long wave"]
    write_table(table, round_floats(table, 6), csv, markdown)


if __name__ == "__main__":
    run_step(tabulate_critical_damping, globals()["snakemake"])
