"""Table of critical damping in its several meanings."""

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job

PREFIX = "critical_damping_"


def tabulate_critical_damping(dataset: str, csv: str, markdown: str) -> None:
    """Write every definition over the exponent, and its ratio to the long-wave formula.

    Parameters
    ----------
    dataset : str
        The damping map.
    csv, markdown : str
        Tables to write: all digits, and rounded for people.
    """
    data = read_dataset(dataset)
    curves = data[[name for name in data.data_vars if str(name).startswith(PREFIX)]]
    table = curves.to_dataframe().reset_index()
    table.columns = [name.removeprefix(PREFIX).replace("_", " ") for name in table.columns]
    table["tail over long wave"] = table["tail"] / table["long wave"]
    write_table(table, round_floats(table, 6), csv, markdown)


if __name__ == "__main__":
    with job(snakemake):
        tabulate_critical_damping(
            snakemake.input.dataset, snakemake.output.csv, snakemake.output.markdown
        )
