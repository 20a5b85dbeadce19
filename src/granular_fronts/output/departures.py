"""Where a configuration departs from another.

A scene, or the whole configuration, is a mapping of mappings. Two of them are compared leaf by
leaf.  A leaf is whatever is not a mapping; a list counts as one.  It is named by its dotted key, as
in ``boundary.left``.
"""

from collections.abc import Iterator, Mapping
from typing import Any

ABSENT = None  # replaces a leaf that only the other mapping has
NAMED_DEPARTURES = 3  # by a sentence, before it counts the others


def departures(configuration: Any, reference: Any) -> list[tuple[str, Any, Any]]:
    """Return dotted key, value and reference value of each leaf in which two configurations differ.

    Numbers compare by value, so that 5 and 5.0 are the same.  A leaf that only one of them has is
    `ABSENT` in the other.  The order follows the reference, then what only `configuration` has.

    >>> departures({"law": {"gamma": 0.21}}, {"law": {"gamma": 0.06}, "beads": 420})
    [('law.gamma', 0.21, 0.06), ('beads', None, 420)]
    """
    values, references = dict(leaves(configuration)), dict(leaves(reference))
    return [
        (key, values.get(key, ABSENT), references.get(key, ABSENT))
        for key in references | values
        if key not in values or key not in references or values[key] != references[key]
    ]


def leaves(configuration: Any, key: str = "") -> Iterator[tuple[str, Any]]:
    """Pairs of dotted key and value; an empty mapping is a leaf: something without parameters."""
    if isinstance(configuration, Mapping) and (configuration or not key):
        for name, value in configuration.items():
            yield from leaves(value, f"{key}.{name}" if key else str(name))
    else:
        yield key, configuration


def physical_departures(configuration: Any, reference: Any) -> list[tuple[str, Any, Any]]:
    """Return departures that change the problem, not how accurately it is solved: no tolerances."""
    every = departures(configuration, reference)
    return [each for each in every if "tolerance" not in each[0].split(".")]


def describe(differences: list[tuple[str, Any, Any]]) -> str:
    """Return the first departures in words, with both values."""
    named = [_describe_one(*difference) for difference in differences[:NAMED_DEPARTURES]]
    more = len(differences) - len(named)
    return "; ".join([*named, f"and {more} more"] if more else named)


def _describe_one(key: str, value: Any, reference: Any) -> str:
    if reference is ABSENT:
        return f"{key} is {value}, by default absent"
    return f"{key} is {'absent' if value is ABSENT else value} instead of {reference}"
