"""Set every number the paper prints beside the one computed here."""

import math
from collections.abc import Callable
from decimal import Decimal, InvalidOperation
from importlib import import_module
from pathlib import Path

import pandas as pd
import yaml

from granular_fronts.datasets import read_dataset
from granular_fronts.measured import Measured
from granular_fronts.tables import write_table
from step import run_step

COLUMNS = (
    "quantity",
    "paper_place",
    "printed",
    "computed",
    "error_estimate",
    "scene",
    "verdict",
    "remark",
)
REPRODUCED, NOT_REPRODUCED, NOT_JUDGED = "reproduced", "not reproduced", "no number printed"


def tabulate_paper_numbers(numbers: Path, datasets: list[Path], csv: Path, markdown: Path) -> None:
    """Measure each quantity on its scene, judge it, and write the table.

    Parameters
    ----------
    numbers : Path
        List of printed numbers, config/paper_numbers.yaml.
    datasets : list of Path
        Result files of all scenes.
    csv, markdown : Path
        Tables to write: full precision, and rounded for reading.
    """
    data = {path.stem: read_dataset(path, path.stem) for path in datasets}
    entries = yaml.safe_load(numbers.read_text(encoding="utf-8"))
    rows = [make_row(entry, data[entry["scene"]]) for entry in entries]
    table = pd.DataFrame(rows, columns=COLUMNS)
    rounded = table.assign(
        computed=[f"{value:.6g}" for value in table["computed"]],
        error_estimate=[f"{value:.1e}" for value in table["error_estimate"]],
    )
    write_table(table, rounded, csv, markdown, list(data.values()))


def make_row(entry, dataset):
    """One row of the table, as a dict."""
    measured = find_measure(entry["measure"])(dataset)
    return {
        "quantity": entry["quantity"],
        "paper_place": entry["paper_place"],
        "printed": entry["printed"],
        "computed": measured.value,
        "error_estimate": measured.error,
        "scene": entry["scene"],
        "verdict": judge(entry["printed"], measured, entry.get("within")),
        "remark": entry["remark"],
    }


def find_measure(name: str) -> Callable[..., Measured]:
    """Find a measure by its name: `function` of the chain, or `wing.function` of another wing."""
    wing, _, function = name.rpartition(".")
    return getattr(import_module(f"granular_fronts.{wing or 'chain'}.measures"), function)


def judge(printed, measured, within=None):
    """Verdict on a measured value.

    Parameters
    ----------
    printed : str
        A number, an inequality (`>= 0`, `> 1`, `< 0`), or words.
    measured : Measured
        Its error counts in favour of the printed number.
    within : float, optional
        Half-width to judge with, instead of half a unit of the last printed digit.
    """
    relation, _, limit = printed.partition(" ")
    if relation in (">", ">="):
        fits = measured.value + measured.error >= float(limit)
        return REPRODUCED if fits else NOT_REPRODUCED
    if relation == "<":
        fits = measured.value - measured.error < float(limit)
        return REPRODUCED if fits else NOT_REPRODUCED
    try:
        number = Decimal(printed)
    except InvalidOperation:
        return NOT_JUDGED
    if within is None:
        within = 0.5 * 10.0 ** number.as_tuple().exponent
    distance = abs(measured.value - float(number))
    if math.isnan(distance) or distance > within + measured.error:
        return NOT_REPRODUCED
    return REPRODUCED


if __name__ == "__main__":
    run_step(tabulate_paper_numbers, globals().get("snakemake"))
