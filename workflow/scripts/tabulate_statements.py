"""Compare statements of the paper or of this project with computed numbers, and judge them."""

import math
import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import pandas as pd

from granular_fronts.accuracy import Estimate
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.statements import evaluate, scenes_of
from granular_fronts.output.tables import write_table
from granular_fronts.scenes.yaml_files import read_yaml
from job import job

COLUMNS = {
    "quantity": "quantity",
    "paper_place": "paper_place",
    "read": "read",
    "printed": "printed",
    "computed": "computed",
    "numerical_error": "numerical error",
    "verdict": "verdict",
    "criterion": "criterion",
    "remark": "remark",
    "scene": "scene",
    "kind": "kind",
    "expected": "expected",
}
"""Columns and their heads; a table has those that its statements fill."""

FOR_MACHINES = ["kind", "expected"]


def tabulate_statements(
    statements: str, shown: Mapping[str, Any], datasets: list[str], csv: str, markdown: str
) -> None:
    """Measure and judge each statement on its scenes, and write the table.

    Parameters
    ----------
    statements : str
        File of the statements. Their measures may also be functions of modules beside it.
    shown : mapping
        For each scene its parameters and those that the statements are about.
    datasets : list of str
        Result files of all scenes.
    csv, markdown : str
        Tables to write: full precision, and rounded for people.
    """
    folder = Path(statements).parent
    listed = read_yaml(statements)
    needed = {name for statement in listed for name in scenes_of(statement)}
    files = {Path(path).stem: path for path in datasets}
    data = {name: read_dataset(files[name], name) for name in files if name in needed}
    reference = {scene: meant for scene, (_, meant) in shown.items()}
    rows = pd.DataFrame(
        [
            evaluate(statement, find_measure(statement["measure"], folder), data, reference)
            for statement in listed
        ]
    )
    table = rows[[column for column in COLUMNS if column in rows]].rename(columns=COLUMNS)
    readable = table.drop(columns=FOR_MACHINES).assign(
        computed=[_rounded(value, ".6g") for value in rows["computed"]],
        **{"numerical error": [_rounded(value, ".1e") for value in rows["numerical_error"]]},
    )
    # A finding has neither words of a paper nor a place there.
    write_table(table, readable.fillna(""), csv, markdown)


def find_measure(name: str, folder: Path) -> Callable[..., Estimate]:
    """Find a measure, `module.function`, in a folder or else in the package."""
    module, _, function = name.rpartition(".")
    if (folder / f"{module}.py").exists():
        sys.path.append(str(folder))
        return getattr(import_module(module), function)
    return getattr(import_module(f"granular_fronts.{module}"), function)


def _rounded(value: float, form: str) -> str:
    """Return a number as text, or a dash."""
    return "–" if math.isnan(value) else format(value, form)


if __name__ == "__main__":
    with job(snakemake):
        tabulate_statements(
            snakemake.input.statements,
            snakemake.params.shown,
            snakemake.input.datasets,
            snakemake.output.csv,
            snakemake.output.markdown,
        )
