"""Compare statements of the paper or of this project with computed numbers, and judge them."""

import math
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import pandas as pd

from granular_fronts.accuracy import Estimate
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.statements import evaluate, scenes_of
from granular_fronts.output.tables import write_table
from granular_fronts.scenes.yaml_files import read_yaml
from step import run_step

COLUMNS = {
    "quantity": "quantity",
    "paper_place": "paper_place",
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
    statements: Path, reference: dict, datasets: list[Path], csv: Path, markdown: Path
) -> None:
    """Measure and judge each statement on its scenes, and write the table.

    Parameters
    ----------
    statements : Path
        Statements of the paper, config/paper_numbers.yaml, or findings, config/findings.yaml.
    reference : dict
        The paper's parameters of every scene, by its name.
    datasets : list of Path
        Result files of all scenes.
    csv, markdown : Path
        Tables to write: full precision, and rounded for people.
    """
    listed = read_yaml(statements)
    needed = {name for statement in listed for name in scenes_of(statement)}
    data = {path.stem: read_dataset(path, path.stem) for path in datasets if path.stem in needed}
    rows = pd.DataFrame(
        [
            evaluate(statement, find_measure(statement["measure"]), data, reference)
            for statement in listed
        ]
    )
    table = rows[[column for column in COLUMNS if column in rows]].rename(columns=COLUMNS)
    readable = table.drop(columns=FOR_MACHINES).assign(
        computed=[_rounded(value, ".6g") for value in rows["computed"]],
        **{"numerical error": [_rounded(value, ".1e") for value in rows["numerical_error"]]},
    )
    write_table(table, readable, csv, markdown)


def find_measure(name: str) -> Callable[..., Estimate]:
    """Find a measure, `module.function`, in `granular_fronts.module`."""
    module, _, function = name.rpartition(".")
    return getattr(import_module(f"granular_fronts.{module}"), function)


def _rounded(value: float, form: str) -> str:
    """Return a number as text, or a dash."""
    return "–" if math.isnan(value) else format(value, form)


if __name__ == "__main__":
    run_step(tabulate_statements, globals()["snakemake"])
