r"""Whether a measured number lies where a statement says.

A statement allows a range of values: a printed number x, all that rounds to it; a printed
inequality, one side of its limit; words, what a criterion says, in one of the forms ::

    1 within 0.01        0.4 to 0.6        at least 0        above 0        at most 1        below 1

An explanation may follow after a comma.  `above` and `below`, like the printed signs > and <, leave
out the limit itself.

The measured value v with the numerical error e stands for all numbers from v − e to v + e.  The
statement is true if all of them are in the range, and false if none is.  It stays undecided if only
some are, if e is negative or larger than half the width of the range, or if v or e is not a number:
the error never counts in favour of either answer.
"""

import math
import re
from decimal import Decimal, InvalidOperation
from typing import NamedTuple

from granular_fronts.accuracy import Estimate

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


def range_of_criterion(criterion: str) -> Range:
    """Read a criterion or a printed inequality.

    Parameters
    ----------
    criterion : str
        For example "at most 0.05, a twentieth of the jump" or "> 0".

    Returns
    -------
    Range

    Raises
    ------
    ValueError
        If it has none of the forms above, or allows no number.
    """
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
    """Half a unit of the last digit of a printed number, which is text.

    Parameters
    ----------
    printed : str
        For example "0.56" or "5.5e-3".

    Returns
    -------
    str
        In plain digits where they are few, for example "0.005" or "5e-05".

    Raises
    ------
    ValueError
        If the text is infinite or no number, and so has no last digit.
    """
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
    """Compare a measured number with a range.

    Parameters
    ----------
    allowed : Range
    measured : Estimate

    Returns
    -------
    bool or None
        Whether it lies in the range; None where its numerical error leaves that open.
    """
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
