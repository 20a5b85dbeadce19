"""Where a configuration departs from another.

A scene, or the whole configuration, is a mapping of mappings. Two of them are compared leaf by
leaf: a leaf is whatever is not a mapping, a list counts as one, and a leaf is named by its dotted
key, as in ``boundary.left``.
"""

from collections.abc import Iterator, Mapping
from typing import Any

ABSENT = None
"""Stands for a leaf that only the other mapping has."""

NAMED_DEPARTURES = 3
"""Differences that a sentence names before it counts the others."""


def departures(asked: Any, reference: Any) -> list[tuple[str, Any, Any]]:
    """List the leaves in which a configuration differs from a reference.

    Parameters
    ----------
    asked, reference : mapping
        Nested mappings, whose leaves are numbers, text, booleans or lists. Numbers compare by
        value, so that 5 and 5.0 are the same.

    Returns
    -------
    list of (str, object, object)
        Dotted key, value and reference value of each difference, `ABSENT` for a leaf that only one
        of them has; in the order of the reference, then what only `asked` has. Empty where the two
        say the same.

    Examples
    --------
    >>> departures({"law": {"gamma": 0.21}}, {"law": {"gamma": 0.06}, "beads": 420})
    [('law.gamma', 0.21, 0.06), ('beads', None, 420)]
    """
    values, references = dict(leaves(asked)), dict(leaves(reference))
    return [
        (key, values.get(key, ABSENT), references.get(key, ABSENT))
        for key in references | values
        if key not in values or key not in references or values[key] != references[key]
    ]


def leaves(configuration: Any, key: str = "") -> Iterator[tuple[str, Any]]:
    """Walk over the leaves of a nested mapping, as pairs of dotted key and value.

    Parameters
    ----------
    configuration : mapping
    key : str, optional
        Dotted key of this mapping in a larger one.

    Yields
    ------
    tuple of (str, object)
        An empty mapping is a leaf too: it says that there is something without parameters.
    """
    if isinstance(configuration, Mapping) and (configuration or not key):
        for name, value in configuration.items():
            yield from leaves(value, f"{key}.{name}" if key else str(name))
    else:
        yield key, configuration


def physical_departures(asked: Any, reference: Any) -> list[tuple[str, Any, Any]]:
    """List the differences that change the question, not how accurately it is answered.

    Parameters
    ----------
    asked, reference : mapping
        As for `departures`.

    Returns
    -------
    list of (str, object, object)
        As of `departures`, without tolerances.
    """
    differences = departures(asked, reference)
    return [difference for difference in differences if "tolerance" not in difference[0].split(".")]


def describe(differences: list[tuple[str, Any, Any]]) -> str:
    """Say the first differences in words, with both values.

    Parameters
    ----------
    differences : list of (str, object, object)
        As `departures` gives.

    Returns
    -------
    str
    """
    named = [_describe_one(*difference) for difference in differences[:NAMED_DEPARTURES]]
    more = len(differences) - len(named)
    return "; ".join([*named, f"and {more} more"] if more else named)


def _describe_one(key: str, value: Any, reference: Any) -> str:
    if reference is ABSENT:
        return f"{key} is {value}, by default absent"
    return f"{key} is {'absent' if value is ABSENT else value} instead of {reference}"
