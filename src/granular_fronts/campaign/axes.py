"""The values of an axis: a list, or evenly or logarithmically spaced from start to stop.

Spaced values are rounded to `DIGITS` significant digits.  A point is recognised by its values, and
those of ``linspace: [0, 1, 11]`` must be found again, to the last bit, in ``[0, 1, 21]``.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

DIGITS = 12


def expand_axis(given: Sequence[float] | Mapping) -> list[float]:
    """Write out the values of an axis.

    Parameters
    ----------
    given : sequence of float or mapping
        The values, or ``{linspace: [start, stop, count]}``, or ``{logspace: [start, stop, count]}``
        with the values start and stop themselves, not their logarithms.

    Returns
    -------
    list of float
    """
    if not isinstance(given, Mapping):
        return [*given]
    [(spacing, (start, stop, count))] = given.items()
    fractions = [index / max(count - 1, 1) for index in range(count)]
    if spacing == "linspace":
        return [round_value(start * (1.0 - f) + stop * f) for f in fractions]
    return [round_value(start * (stop / start) ** f) for f in fractions]


def round_value(value: float) -> float:
    """The value with `DIGITS` significant digits; a whole number stays one."""
    return value if isinstance(value, int) else float(f"{value:.{DIGITS}g}")


def count_values(given: Sequence[float] | Mapping) -> int:
    """Number of values of an axis, without writing them out."""
    if not isinstance(given, Mapping):
        return len(given)
    [(_, _, count)] = given.values()
    return count


def spacing_errors(name: str, given: Sequence[float] | Mapping) -> Iterator[str]:
    """Say why an axis cannot be written out.

    Parameters
    ----------
    name : str
        Of the axis.
    given : sequence or mapping
        As in `expand_axis`.

    Yields
    ------
    str
        A sentence for each reason.
    """
    if not isinstance(given, Mapping):
        return
    [(spacing, (start, stop, count))] = given.items()
    if not (isinstance(count, int) and count >= 1):
        yield (
            f"axes.{name}.{spacing} asks for {count} values, but needs a whole number of 1 or "
            "more: write [start, stop, count]."
        )
    if spacing == "logspace" and min(start, stop) <= 0:
        yield (
            f"axes.{name}.logspace runs from {start} to {stop}, but a logarithmic axis needs "
            "both above 0: raise them, or use linspace."
        )


def order_errors(name: str, values: Sequence[float]) -> Iterator[str]:
    """Say where the values of an axis do not increase.

    Parameters
    ----------
    name : str
        Of the axis.
    values : sequence of float
        Written out.

    Yields
    ------
    str
        One sentence, for the first such place.
    """
    for before, after in pairwise(values):
        if after <= before:
            yield (
                f"axes.{name} has {after:g} after {before:g}, but its values must increase: "
                "sort them and name each once."
            )
            return
