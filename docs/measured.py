"""Bring the measured numbers of the pages up to date with the tables of a finished run.

A number that is a result is followed by its name in a comment, ``0.263<!-- critical_tail -->``,
which no reader sees.  ``measured.yaml`` says of each name where its number comes from and how
it is written:

- `table`, `row`: a file below ``results/tables``, and what singles out one of its rows;
- `count`: in place of `row`, what singles out the rows whose number is written, all where it is {};
- `column`: in this row, ``computed`` by default;
- `times`: a factor, 100 for per cent; optional;
- `form`: a format of Python, ``.3f`` for example; an exponent is written as a power of ten;
- `bound`: in place of `form`, what the number and its numerical error together stay below; a page
  that says "within 10⁻⁶" states such a bound.

The names at its end, `by_tests`, are of numbers that a test computes and holds the page to.
To bring the pages up to date: python docs/measured.py
"""

import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import yaml

HERE = Path(__file__).parent
ROOT = HERE.parent
ENTRIES = Path(__file__).with_suffix(".yaml")
MADE_BY_THE_BUILD = {"generated", "_build", "jupyter_execute"}

DIGITS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
MARKED = re.compile(r"(?P<number>[−\-+]?[\d.·⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)(?P<mark><!-- (?P<name>\w+) -->)")
"""A number, and the comment that names it."""


def pages() -> list[Path]:
    """README and the pages of the manual, without those that the build writes."""
    written = (page for page in sorted(HERE.rglob("*.md")) if not MADE_BY_THE_BUILD & {*page.parts})
    return [ROOT / "README.md", *written]


def names_in(text: str) -> list[str]:
    """Names of the measured numbers of a page."""
    return [match["name"] for match in MARKED.finditer(text)]


def fill(text: str, numbers: Mapping[str, str]) -> str:
    """A page with its measured numbers replaced.

    Parameters
    ----------
    text : str
    numbers : mapping of str to str
        By their names; a number whose name is missing stays as it is.

    Returns
    -------
    str
    """
    return MARKED.sub(
        lambda match: numbers.get(match["name"], match["number"]) + match["mark"], text
    )


def load_numbers(results: Path, entries: Path = ENTRIES) -> dict[str, str]:
    """The numbers of a run, as they are written.

    Parameters
    ----------
    results : Path
        Results of a run of the workflow; a number of a table that was not made is left out.
    entries : Path, optional
        What the numbers are.

    Returns
    -------
    dict of str to str
        By their names.

    Raises
    ------
    SystemExit
        If a number is not below the bound that a page states.
    """
    listed = yaml.safe_load(entries.read_text(encoding="utf-8"))
    return dict(_written_numbers(listed, results / "tables"))


def _written_numbers(listed: Mapping[str, Any], tables: Path) -> Iterator[tuple[str, str]]:
    """Names and texts of the numbers whose tables are there."""
    read = {}
    for name, entry in listed.items():
        path = tables / f"{entry.get('table')}.csv"
        if not path.exists():
            continue
        if path not in read:
            read[path] = pd.read_csv(path)
        if "count" in entry:
            yield name, str(len(_rows(read[path], entry["count"])))
            continue
        row = _only_row(read[path], entry["row"], name)
        value = entry.get("times", 1.0) * float(row[entry.get("column", "computed")])
        if "bound" in entry:
            reached = abs(value) + float(row["numerical error"])
            if reached > entry["bound"]:
                sys.exit(
                    f"{name} of docs/measured.yaml reaches {reached:.2g}, above the bound "
                    f"{entry['bound']} that the pages state: state a larger one."
                )
            yield name, in_print(entry["bound"], ".3g" if entry["bound"] > 1e-3 else ".0e")
        else:
            yield name, in_print(value, entry["form"])


def _only_row(table: pd.DataFrame, wanted: Mapping[str, Any], name: str) -> pd.Series:
    """The row of a table with some values."""
    rows = _rows(table, wanted)
    if len(rows) != 1:
        sys.exit(
            f"{name} of docs/measured.yaml names {len(rows)} rows, but must name one: see `row`."
        )
    return rows.iloc[0]


def _rows(table: pd.DataFrame, wanted: Mapping[str, Any]) -> pd.DataFrame:
    """The rows of a table with some values."""
    fits = np.ones(len(table), bool)
    for column, value in wanted.items():
        cells = table[column]
        fits &= cells == value if isinstance(value, str) else np.isclose(cells, value)
    return table[fits]


def in_print(value: float, form: str) -> str:
    """A number as it is printed: a true minus, and powers of ten."""
    mantissa, exponential, exponent = format(value, form).partition("e")
    power = f"10{str(int(exponent)).translate(DIGITS)}" if exponential else ""
    if power and mantissa in ("1", "-1"):
        return f"{mantissa[:-1]}{power}".replace("-", "−")
    return "·".join(filter(None, [mantissa.replace("-", "−"), power]))


if __name__ == "__main__":
    found = load_numbers(ROOT / "results")
    if not found:
        sys.exit(f"{ROOT / 'results' / 'tables'} holds no tables: run make first.")
    for page in pages():
        old = page.read_text(encoding="utf-8")
        if (new := fill(old, found)) != old:
            page.write_text(new, encoding="utf-8")
