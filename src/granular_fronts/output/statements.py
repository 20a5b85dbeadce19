"""Statements that can be true or false, measured on the data of scenes and judged.

A statement is an entry of config/paper_numbers.yaml, of config/findings.yaml or of such a file of a
project: a mapping of

- `quantity`: what is measured, in words;
- `kind`: `number`, `inequality` or `words` of the paper, or a `finding` of this project;
- `read`: what was read of the paper of others, its `abstract`, `opening`, `numbers` or `all`;
- `printed`: the number, inequality or words that the paper prints; none for a finding;
- `within`: half-width around a printed number, where it is not half a unit of its last digit;
- `criterion`: what words and findings are judged by, in one of the forms below;
- `scene`: the scene, or a list of scenes, whose datasets are measured;
- `measure`: `module.function`, a function of a module beside the file or of
  `granular_fronts.module`, that takes these datasets and returns an `Estimate`;
- `arguments`: what else that function takes, by name;
- `expected`: the verdict in the default configuration;
- `not_judged`: why there is no verdict, for a statement that cannot be judged;
- `remark`: what a reader should know.

A statement of the paper holds for the paper's parameters.  If a dataset does not have the
parameters of the reference configuration, its statement is measured but not judged; tolerances may
differ.

Words mean what their paper says around them.  Where that was not read, they are compatible with
what is measured or not, or out of reach, but they neither hold nor fail.

A statement allows a range of values.  A printed number allows all that rounds to it, and a printed
inequality one side of its limit.  Words allow what a criterion says, in one of the forms ::

    1 within 0.01        0.4 to 0.6        at least 0        above 0        at most 1        below 1

An explanation may follow after a comma.  `above` and `below`, like the printed signs > and <, leave
out the limit itself.

The measured value v with the numerical error e means all numbers from v − e to v + e.  The
statement is true if all of them are in the range, and false if none is.  It stays undecided if only
some are.  It also does so if e is negative or larger than half the width of the range, or if v or e
is not a number.  The error never counts in favour of either answer.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from decimal import Decimal, InvalidOperation
from typing import TYPE_CHECKING, Any, NamedTuple

from granular_fronts.accuracy import Estimate
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.departures import describe, physical_departures

if TYPE_CHECKING:
    import xarray as xr

REPRODUCED, NOT_REPRODUCED = "reproduced", "not reproduced"
HOLDS, DOES_NOT_HOLD = "holds", "does not hold"
COMPATIBLE, NOT_COMPATIBLE, OUT_OF_REACH = "compatible", "not compatible", "out of reach"
UNDECIDED, NOT_JUDGED, OTHER_PARAMETERS = "undecided", "not judged", "other parameters"

ANSWERS = {
    "number": (REPRODUCED, NOT_REPRODUCED),
    "inequality": (REPRODUCED, NOT_REPRODUCED),
    "words": (HOLDS, DOES_NOT_HOLD),
    "finding": (HOLDS, DOES_NOT_HOLD),
}
"""Names of a true and of a false statement."""

READ = ("abstract", "opening", "numbers", "all")

UNMEASURED = Estimate(math.nan, math.nan)

NUMBER = r"[-+]?[0-9.]+(?:e[-+]?[0-9]+)?"
FORMS = re.compile(
    rf"(?P<side>at least|above|at most|below|>=|>|<=|<) (?P<limit>{NUMBER})"
    rf"|(?P<first>{NUMBER}) (?P<pair>within|to) (?P<second>{NUMBER})"
)
LOWER, STRICT = ("at least", "above", ">=", ">"), ("above", "below", ">", "<")


class Range(NamedTuple):
    """The values that a statement allows; `strict` leaves out the limits themselves."""

    low: float
    high: float
    strict: bool = False


def scenes_of(statement: Mapping[str, Any]) -> list[str]:
    """Return the names of the scenes that a statement is about, as a list."""
    scene = statement["scene"]
    return [scene] if isinstance(scene, str) else scene


def answers_to(statement: Mapping[str, Any]) -> tuple[str, str, str]:
    """Return the names of a true statement, of a false one, and of one that is not judged."""
    kind, read = statement["kind"], statement.get("read", "all")
    for key, value, known in (("kind", kind, ANSWERS), ("read", read, READ)):
        if value not in known:
            raise InputError(
                f"{key} of “{statement['quantity']}” is {value}: write one of {', '.join(known)}."
            )
    if kind == "words" and read != "all":
        return COMPATIBLE, NOT_COMPATIBLE, OUT_OF_REACH
    return *ANSWERS[kind], NOT_JUDGED


def criterion_of(statement: Mapping[str, Any]) -> str:
    """Return the criterion of a statement in words and numbers; empty if it is not judged."""
    answers_to(statement)
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
    """Return one of the `answers_to` a statement, or that it stays undecided."""
    true, false, not_judged = answers_to(statement)
    if "not_judged" in statement:
        return not_judged
    answer = judge(range_of_criterion(criterion_of(statement)), measured)
    if answer is None:
        return UNDECIDED
    return true if answer else false


def evaluate(
    statement: Mapping[str, Any],
    function: Callable[..., Estimate],
    datasets: Mapping[str, xr.Dataset],
    references: Mapping[str, Any],
) -> dict[str, Any]:
    """Measure a statement and judge it; return the statement and the result as a row of a table.

    Datasets, which carry their configuration, and reference configurations go by scene name.
    """
    names = scenes_of(statement)
    differences = [
        difference
        for name in names
        for difference in physical_departures(configuration_of(datasets[name]), references[name])
    ]
    measured_on, arguments = [datasets[name] for name in names], statement.get("arguments", {})
    try:
        measured = function(*measured_on, **arguments)
    except (LookupError, ValueError, ArithmeticError):
        # Other parameters may leave out what is measured; the paper's may not.
        if not differences:
            raise
        measured = UNMEASURED
    if differences:
        verdict, remark = OTHER_PARAMETERS, describe(differences)
    else:
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


def range_of_criterion(criterion: str) -> Range:
    """Read a criterion, "at most 0.05, a twentieth of the jump", or a printed inequality, "> 0"."""
    form = FORMS.fullmatch(criterion.partition(",")[0])
    if form is None:
        raise ValueError(
            f"The criterion {criterion!r} cannot be read: write it like one of 1 within 0.01, "
            "0.4 to 0.6, at least 0, above 0, at most 1, below 1."
        )
    if form["pair"]:
        first, second = float(form["first"]), float(form["second"])
        limits = (first - second, first + second) if form["pair"] == "within" else (first, second)
        if limits[0] > limits[1]:
            raise ValueError(
                f"The criterion {criterion!r} allows no number: write the smaller limit first, and "
                "a half-width of at least 0."
            )
        return Range(*limits)
    limit, strict = float(form["limit"]), form["side"] in STRICT
    return (
        Range(limit, math.inf, strict) if form["side"] in LOWER else Range(-math.inf, limit, strict)
    )


def half_unit(printed: str) -> str:
    """Return half a unit of the last digit of a printed number, as text: "0.005" of "0.56"."""
    try:
        exponent = Decimal(printed).as_tuple().exponent
    except InvalidOperation:
        exponent = "n"
    if not isinstance(exponent, int):
        raise ValueError(
            f"The printed number is {printed}, which has no last digit: give its digits, or say "
            "`within` what the number is reproduced."
        )
    return f"{float(Decimal(5).scaleb(exponent - 1)):g}"


def judge(allowed: Range, measured: Estimate) -> bool | None:
    """Return whether a number lies in a range; None where its numerical error leaves that open."""
    value, error = measured
    half_width = 0.5 * (allowed.high - allowed.low)
    # Also where one of them is not a number.
    if not (math.isfinite(value) and 0.0 <= error <= half_width):
        return None
    lowest, highest = value - error, value + error
    if allowed.strict:
        inside = allowed.low < lowest and highest < allowed.high
        outside = highest <= allowed.low or allowed.high <= lowest
    else:
        inside = allowed.low <= lowest and highest <= allowed.high
        outside = highest < allowed.low or allowed.high < lowest
    return inside if inside or outside else None
