"""Statements that can be true or false, measured on the data of scenes and judged.

A statement is an entry of config/paper_numbers.yaml or of config/findings.yaml: a mapping of

- `quantity`: what is measured, in words;
- `kind`: `number`, `inequality` or `words` of the paper, or a `finding` of this project;
- `printed`: the number, inequality or words that the paper prints; none for a finding;
- `within`: half-width around a printed number, where it is not half a unit of its last digit;
- `criterion`: what words and findings are judged by (see `granular_fronts.output.judgement`);
- `scene`: the scene, or a list of scenes, whose datasets are measured;
- `measure`: `module.function`, a function of `granular_fronts.module` that takes these
  datasets and returns an `Estimate`;
- `arguments`: what else that function takes, by name;
- `expected`: the verdict in the default configuration;
- `not_judged`: why there is no verdict, for a statement that cannot be judged;
- `remark`: what a reader should know.

A statement of the paper holds for the paper's parameters.  Where a dataset belongs to other
parameters than those of the reference configuration, its statement is measured but not judged;
tolerances may differ.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from granular_fronts.accuracy import Estimate
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.departures import describe, physical_departures
from granular_fronts.output.judgement import half_unit, judge, range_of_criterion

if TYPE_CHECKING:
    import xarray as xr

REPRODUCED, NOT_REPRODUCED = "reproduced", "not reproduced"
HOLDS, DOES_NOT_HOLD = "holds", "does not hold"
UNDECIDED, NOT_JUDGED, OTHER_PARAMETERS = "undecided", "not judged", "other parameters"

ANSWERS = {
    "number": (REPRODUCED, NOT_REPRODUCED),
    "inequality": (REPRODUCED, NOT_REPRODUCED),
    "words": (HOLDS, DOES_NOT_HOLD),
    "finding": (HOLDS, DOES_NOT_HOLD),
}
"""What to call a statement that is true, and one that is false."""

UNMEASURED = Estimate(math.nan, math.nan)


def scenes_of(statement: Mapping[str, Any]) -> list[str]:
    """Names of the scenes that a statement is about, as a list."""
    scene = statement["scene"]
    return [scene] if isinstance(scene, str) else scene


def criterion_of(statement: Mapping[str, Any]) -> str:
    """What a statement is judged by, in words and numbers.

    Parameters
    ----------
    statement : mapping

    Returns
    -------
    str
        Empty for a statement that is not judged.
    """
    if "not_judged" in statement:
        return ""
    for key in ("printed", "criterion"):
        if not isinstance(text := statement.get(key, ""), str):
            raise InputError(
                f"{key} of “{statement['quantity']}” is {text} without quotation marks: set them, "
                "since the digits that are written count."
            )
    if statement["kind"] == "number":
        within = statement.get("within", half_unit(statement["printed"]))
        return f"{statement['printed']} within {within}"
    if statement["kind"] == "inequality":
        return statement["printed"]
    return statement["criterion"]


def verdict_on(statement: Mapping[str, Any], measured: Estimate) -> str:
    """Verdict on a statement about the paper's parameters.

    Parameters
    ----------
    statement : mapping
    measured : Estimate

    Returns
    -------
    str
        Reproduced or not, holds or does not hold, undecided, or not judged.
    """
    if "not_judged" in statement:
        return NOT_JUDGED
    answer = judge(range_of_criterion(criterion_of(statement)), measured)
    if answer is None:
        return UNDECIDED
    true, false = ANSWERS[statement["kind"]]
    return true if answer else false


def evaluate(
    statement: Mapping[str, Any],
    function: Callable[..., Estimate],
    datasets: Mapping[str, xr.Dataset],
    references: Mapping[str, Any],
) -> dict[str, Any]:
    """Measure a statement and judge it.

    Parameters
    ----------
    statement : mapping
    function : callable
        The measure that the statement names.
    datasets : mapping
        Of scene name to its dataset, which carries its configuration.
    references : mapping
        Of scene name to its reference configuration.

    Returns
    -------
    dict
        The row of a table: `quantity`, `criterion`, `computed`, `numerical_error`, `scene`,
        `verdict`, `expected` and `remark`, beside what else the statement says.
    """
    names = scenes_of(statement)
    differences = [
        difference
        for name in names
        for difference in physical_departures(configuration_of(datasets[name]), references[name])
    ]
    measured_on, arguments = [datasets[name] for name in names], statement.get("arguments", {})
    if differences:
        measured = measure_departed(function, measured_on, arguments)
        verdict, remark = OTHER_PARAMETERS, describe(differences)
    else:
        measured = function(*measured_on, **arguments)
        verdict = verdict_on(statement, measured)
        remark = statement.get("not_judged", statement.get("remark", ""))
    return {
        **statement,
        "criterion": criterion_of(statement),
        "computed": measured.value,
        "numerical_error": measured.error,
        "scene": ", ".join(names),
        "verdict": verdict,
        "remark": remark,
    }


def measure_departed(
    function: Callable[..., Estimate], datasets: Sequence[xr.Dataset], arguments: Mapping[str, Any]
) -> Estimate:
    """Measure a statement on other parameters, which may leave out what it needs.

    Parameters
    ----------
    function : callable
    datasets : list of xarray.Dataset
    arguments : mapping
        Of names to values, for example a bead or a material.

    Returns
    -------
    Estimate
        Not a number where there is nothing to measure.
    """
    try:
        return function(*datasets, **arguments)
    except (LookupError, ValueError, ArithmeticError):
        return UNMEASURED


def unexpected_verdicts(rows: Iterable[Mapping[str, Any]]) -> list[str]:
    """Find the verdicts that differ from the expected ones.

    Parameters
    ----------
    rows : iterable of mapping
        With `quantity`, `verdict`, `expected`.

    Returns
    -------
    list of str
        A sentence for each; none for other parameters, of which nothing is expected.
    """
    return [
        f"{row['quantity']}: the verdict is {row['verdict']!r}, expected is {row['expected']!r}."
        for row in rows
        if row["verdict"] not in (row["expected"], OTHER_PARAMETERS)
    ]
