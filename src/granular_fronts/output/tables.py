"""The one place that writes tables: each for machines with all digits, and rounded for people."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from granular_fronts.output.files import complete_file

if TYPE_CHECKING:
    import pandas as pd


def write_table(
    table: pd.DataFrame, rounded: pd.DataFrame, csv: Path | str, markdown: Path | str
) -> None:
    """Write a table with all digits as CSV and rounded as Markdown, each when it is complete."""
    with complete_file(csv) as unfinished:
        table.to_csv(unfinished, index=False)
    with complete_file(markdown) as unfinished:
        rounded.to_markdown(unfinished, index=False, disable_numparse=True)


def round_floats(table: pd.DataFrame, digits: int) -> pd.DataFrame:
    """Return a table with its floats as text of a number of significant digits."""
    return table.map(lambda cell: f"{cell:.{digits}g}" if isinstance(cell, float) else cell)
