"""How many beads a scene has, and whether what varies along its chain is possible.

A pattern gives one factor for each bead or contact of a chain.  It is a number for all of them, or
a mapping whose keys multiply.  A `cell` repeats a list, and a `taper` grows by a ratio or a
difference from one to the next.  A draw that is `random` lies between 1 − spread and 1 + spread,
and a `list` names all.  An `impurity` then replaces a single value.  `chain.patterns` evaluates it.
"""

import math
from collections.abc import Iterator, Mapping
from typing import Any

MOST_DECADES = 6
"""Decades on either side of 1 of a mass or a factor.  Light beads are fast, and set the steps."""


def bead_count(scene: Mapping[str, Any]) -> int:
    """Return the number N of beads of a chain scene."""
    beads = scene["beads"]
    return int(beads["count"] if isinstance(beads, Mapping) else beads)


def contact_count(scene: Mapping[str, Any]) -> int:
    """Return the number of contacts that move: N − 1, or N on a ring and before a wall."""
    return bead_count(scene) - (scene["boundary"]["kind"] not in ("ring", "wall"))


def impurities(pattern: Mapping[str, Any]) -> list[tuple[int, float]]:
    """Return place and value of each impurity of a pattern."""
    given = pattern.get("impurity", [])
    return [
        (one["bead"], one["mass"]) if "bead" in one else (one["contact"], one["factor"])
        for one in ([given] if isinstance(given, Mapping) else given)
    ]


def patterns_fit(scene: Mapping) -> Iterator[str]:
    """Every pattern fits its chain, and all its values are above 0."""
    ring = scene["boundary"]["kind"] == "ring"
    if isinstance(scene["beads"], Mapping):
        mass = scene["beads"].get("mass", 1.0)
        yield from _pattern_errors("beads.mass", mass, bead_count(scene), ring)
    for key, pattern in scene.get("contacts", {}).items():
        yield from _pattern_errors(f"contacts.{key}", pattern, contact_count(scene), ring)


def _pattern_errors(key: str, pattern: Any, count: int, ring: bool) -> Iterator[str]:
    """Say what is wrong with one pattern of `count` values."""
    if not isinstance(pattern, Mapping):
        pattern = {"cell": [pattern]}
    cell, taper = pattern.get("cell", [1.0]), pattern.get("taper", {})
    if ring and count % len(cell):
        yield (
            f"{key}.cell has {len(cell)} values, but a ring of {count} has no whole number of such "
            f"cells: take {count - count % len(cell) or len(cell)} beads."
        )
    if ring and taper:
        yield f"{key}.taper is given, but a ring has no end: give a cell or a list."
    last = 1.0 + taper.get("difference", 0.0) * (count - 1)
    if last <= 0.0:
        yield (
            f"{key}.taper.difference is {taper['difference']}, with which value {count} is "
            f"{last:g}: give more than {-1.0 / (count - 1):.3g}."
        )
        return
    for place, _ in impurities(pattern):
        if place > count:
            yield f"{key}.impurity is at {place}, but there are {count}: give 1 to {count}."
    if len(pattern.get("list", [0.0] * count)) != count:
        yield f"{key}.list has {len(pattern['list'])} values, but there are {count}: give one each."
    placed = [math.log10(value) for _, value in impurities(pattern)]
    furthest = max([_decades_of_factors(pattern, last, count), *map(abs, placed)])
    if furthest > MOST_DECADES:
        yield (
            f"{key} comes to 1e±{furthest:.0f}, beyond the 1e±{MOST_DECADES} that a chain can "
            "follow: bring its values nearer to 1."
        )


def _decades_of_factors(pattern: Mapping, last: float, count: int) -> float:
    """Return the largest |decimal logarithm| of the product; `last` is where a taper adds to."""
    ratio = pattern.get("taper", {}).get("ratio", 1.0)
    spread = pattern.get("random", {}).get("spread", 0.0)
    ends = [0.0, math.log10(last) + (count - 1) * math.log10(ratio)]
    listed = ([math.log10(value) for value in pattern.get(key, [])] for key in ("cell", "list"))
    sizes = [ends, [math.log10(1.0 - spread), math.log10(1.0 + spread)], *filter(None, listed)]
    return max(abs(sum(map(min, sizes))), abs(sum(map(max, sizes))))
