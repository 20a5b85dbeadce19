"""Compare the verdicts in tables of statements with those that the statements expect."""

import pandas as pd

from granular_fronts.output.files import complete_file
from job import job


def check_verdicts(tables: list[str], verdict: str) -> None:
    """Write how many verdicts are the expected ones.

    Parameters
    ----------
    tables : list of str
        Tables of statements, the CSV files.
    verdict : str
        Text file to write; not written when a verdict is another one.

    Raises
    ------
    ValueError
        If a verdict is not the expected one, with one sentence for each.
    """
    rows = [row for table in tables for row in pd.read_csv(table, dtype=str).to_dict("records")]
    if wrong := [row for row in rows if row["verdict"] != row["expected"]]:
        raise ValueError(
            "\n".join(
                f"{row['quantity']}: {row['verdict']}, but {row['expected']} is expected: "
                f"{row['computed']} ± {row['numerical error']}, see {row['criterion']}."
                for row in wrong
            )
        )
    with complete_file(verdict) as unfinished:
        unfinished.write_text(f"All {len(rows)} verdicts are the expected ones.\n")


if __name__ == "__main__":
    with job(snakemake):
        check_verdicts(snakemake.input.tables, snakemake.output.verdict)
