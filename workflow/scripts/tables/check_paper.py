"""Compare the verdicts in the tables of a paper with those that its statements expect."""

from pathlib import Path

import pandas as pd

from granular_fronts.output.files import complete_file
from step import run_step


def check_paper(results: Path, judged: list[str], verdict: Path) -> None:
    """Write how many verdicts are the expected ones.

    Parameters
    ----------
    results : Path
        The folder that holds data, figures and tables.
    judged : list of str
        Names of the tables of statements.
    verdict : Path
        Text file to write; not written when a verdict is another one.

    Raises
    ------
    ValueError
        If a verdict is not the expected one, with one sentence for each.
    """
    rows = [
        row
        for name in judged
        for row in pd.read_csv(results / "tables" / f"{name}.csv", dtype=str).to_dict("records")
    ]
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
    run_step(check_paper, globals()["snakemake"])
