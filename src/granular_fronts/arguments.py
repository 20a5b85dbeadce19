"""Check arguments of functions, and say in one sentence what is wrong.

Each function below checks one kind of argument, for example a number, a name or a path.  It returns
the argument as plain float, int, ndarray, ... or raises an `InputError`.  The sentence names the
argument, shows its value, and says what is needed and what to do. Text, None, truth values, complex
numbers, nan and inf are never numbers; nor is an array where one number belongs.

Only arrays need numpy, which is imported where one is checked: the workflow checks its
configuration at each start without it.
"""

from __future__ import annotations

import contextlib
import math
import numbers
import reprlib
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from granular_fronts.errors import InputError

Kind = TypeVar("Kind")

Limit = float | None
"""A limit that numbers must keep, or none."""


def scalar(
    name: str,
    value: object,
    *,
    above: Limit = None,
    least: Limit = None,
    below: Limit = None,
    most: Limit = None,
    advice: str = "give such a number",
) -> float:
    """Return a finite real number within limits.

    Parameters
    ----------
    name : str
        What the sentence calls the argument.
    value : object
        The argument; numpy scalars and arrays without dimensions are numbers too.
    above, least, below, most : float, optional
        Limits: larger than, at least, smaller than, at most.
    advice : str, optional
        End of the sentence: why the limit, or the way out.

    Returns
    -------
    float

    Raises
    ------
    InputError
        If the argument is no such number.
    """
    number = _real(value)
    if math.isfinite(number) and _lies_within(number, above, least, below, most):
        return number
    limits = _limits_in_words(above, least, below, most)
    raise InputError(f"{name} is {shown(value)}, but must be a finite number{limits}: {advice}.")


def count(
    name: str,
    value: object,
    *,
    least: int = 1,
    most: int | None = None,
    advice: str = "give such a number",
) -> int:
    """Return a whole number; arguments and errors as of `scalar`."""
    number = _real(value)
    if number.is_integer() and _lies_within(number, None, least, None, most):
        return int(number)
    limits = _limits_in_words(None, least, None, most)
    raise InputError(f"{name} is {shown(value)}, but must be a whole number{limits}: {advice}.")


def array(
    name: str,
    values: object,
    *,
    above: Limit = None,
    least: Limit = None,
    below: Limit = None,
    most: Limit = None,
    advice: str = "give such numbers",
) -> np.ndarray:
    """Return finite real numbers within limits, in an array of any shape; arguments as of `scalar`.

    The sentence of the InputError shows the first number that is wrong.
    """
    try:
        given = np.asarray(values)
    except (TypeError, ValueError):
        given = np.empty(0, dtype=object)
    if given.dtype.kind not in "iuf":
        raise InputError(f"{name} is {shown(values)}, but must hold real numbers: {advice}.")
    found = given.astype(float)
    good = np.isfinite(found) & _lies_within(found, above, least, below, most)
    if good.all():
        return found
    limits = _limits_in_words(above, least, below, most)
    raise InputError(
        f"{name} holds {found[~good][0]}, but must hold finite numbers{limits}: {advice}."
    )


def sequence(name: str, values: object, **limits: Any) -> np.ndarray:
    """Return one or more numbers as an array of one dimension."""
    found = np.atleast_1d(array(name, values, **limits))
    if found.ndim != 1 or found.size == 0:
        raise InputError(
            f"{name} has shape {found.shape}, but must be a list of one or more numbers: give one."
        )
    return found


def choice(name: str, value: object, choices: Collection[str]) -> str:
    """Return one of several names."""
    if isinstance(value, str) and value in choices:
        return value
    raise InputError(
        f"{name} is {shown(value)}, but must be one of {', '.join(choices)}: choose one of these."
    )


def instance(name: str, value: object, kind: type[Kind], advice: str) -> Kind:
    """Return an object of a kind; the advice says where to get one."""
    if isinstance(value, kind):
        return value
    wanted = _with_article(kind.__name__)
    raise InputError(f"{name} is {shown(value)}, but must be {wanted}: {advice}.")


def path(name: str, value: object) -> Path:
    """Return the path of a file, which need not exist."""
    if isinstance(value, (str, Path)) and str(value) and "\0" not in str(value):
        return Path(value)
    raise InputError(f"{name} is {shown(value)}, but must be a path: give the name of a file.")


def new_file(name: str, value: object) -> Path:
    """Return the path of a file that can be written, in a folder that exists; see `path`."""
    file = path(name, value)
    if (file.exists() and not file.is_file()) or not file.parent.is_dir():
        raise InputError(f"{name} is {file}, but must be a file in a folder that exists: name one.")
    return file


@contextlib.contextmanager
def double_precision(what: str, advice: str) -> Iterator[None]:
    """A context in which overflow ends in a sentence that begins with `what`.

    So does a division by what has underflowed.
    """
    try:
        yield
    except (OverflowError, ZeroDivisionError) as error:
        raise InputError(f"{what} lies beyond double precision: {advice}.") from error


def _real(value: Any) -> float:
    """Return a number as a float, infinite if it is too large; nan for anything else."""
    if getattr(value, "ndim", None) == 0:
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return math.nan
    try:
        return float(value)
    except OverflowError:
        return math.inf


def _lies_within(found: Any, above: Limit, least: Limit, below: Limit, most: Limit) -> Any:
    """Return whether a number, or each of an array, keeps all limits that are given."""
    kept = found == found
    if above is not None:
        kept = kept & (found > above)
    if least is not None:
        kept = kept & (found >= least)
    if below is not None:
        kept = kept & (found < below)
    if most is not None:
        kept = kept & (found <= most)
    return kept


def _limits_in_words(above: Limit, least: Limit, below: Limit, most: Limit) -> str:
    words = ("above", above), ("at least", least), ("below", below), ("at most", most)
    limits = [
        f"{word} {limit:g}" for word, limit in words if limit is not None and math.isfinite(limit)
    ]
    return f", {' and '.join(limits)}" if limits else ""


def _with_article(noun: str) -> str:
    """Return a noun behind "a" or "an", by its first letter."""
    return f"{'an' if noun[0] in 'AEIOUaeiou' else 'a'} {noun}"


def shown(value: Any) -> str:
    """Return a value as short text on one line."""
    if getattr(value, "shape", ()):
        return f"an array of shape {tuple(value.shape)}"
    if getattr(value, "ndim", None) == 0:
        value = value.item()
    return " ".join(reprlib.repr(value).split())
