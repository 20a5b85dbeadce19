"""How many beads a scene has, and whether what varies along its chain is possible.

A pattern gives one factor for each bead or contact of a chain.  It is a number for all of them, or
a mapping whose keys multiply.  A `cell` repeats a list, and a `taper` grows by a ratio or a
difference from one to the next.  A draw that is `random` lies between 1 − spread and 1 + spread,
and a `list` names all.  An `impurity` then replaces a single value.  `chain.patterns` evaluates it.

Beads may be spheres of materials instead, by a `cell` or `list` of words such as ``steel 9.5 mm``.
Then :math:`m_n` is in units of the first mass.  The factor of contact n is its stiffness over that
of two spheres like the first one (`model.materials`).
"""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.model.materials import body_of, hertz_stiffness
from granular_fronts.scenes.schema import name_entry

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
    found = []
    for one in [given] if isinstance(given, Mapping) else given:
        place = "bead" if "bead" in one else "contact"
        [value] = (one[key] for key in one if key != place)
        found.append((one[place], value))
    return found


def has_materials(scene: Mapping[str, Any]) -> bool:
    """Return whether the beads are spheres of materials."""
    return bool(_words(scene["beads"])[1])


def _words(beads: Any) -> tuple[str, list[str]]:
    """Return the key of the spheres that beads are given by, and the words for them."""
    given = beads if isinstance(beads, Mapping) else {}
    key = "list" if "list" in given else "cell"
    return key, given.get(key, [])


def mass_pattern(scene: Mapping[str, Any]) -> Any:
    """Return the pattern of the masses, those of spheres over the first one."""
    key, words = _words(scene["beads"])
    if not words:
        return scene["beads"].get("mass", 1.0) if isinstance(scene["beads"], Mapping) else 1.0
    masses = [body_of(word).mass for word in words]
    return {key: [mass / masses[0] for mass in masses]}


def elastic_pattern(scene: Mapping[str, Any]) -> Any:
    """Return the pattern of the elastic factors, of spheres over the contact of two first ones."""
    _, words = _words(scene["beads"])
    if not words:
        return scene.get("contacts", {}).get("elastic", 1.0)
    # The sphere ahead of the last one is the first of a ring; it is not touched at a held end.
    bodies = [body_of(words[n % len(words)]) for n in range(bead_count(scene) + 1)]
    if "material" in scene["boundary"]:
        bodies[-1] = body_of(scene["boundary"]["material"])
    like_first = hertz_stiffness(bodies[0], bodies[0])
    factors = [hertz_stiffness(*pair) / like_first for pair in pairwise(bodies)]
    return {"list": factors[: contact_count(scene)]}


def patterns_fit(scene: Mapping) -> Iterator[str]:
    """Every pattern fits its chain, and all its values are above 0."""
    errors = [*_material_errors(scene)]
    if errors:
        yield from errors
        return
    ring, contacts = scene["boundary"]["kind"] == "ring", contact_count(scene)
    key = "beads" if has_materials(scene) else "beads.mass"
    yield from _pattern_errors(key, mass_pattern(scene), bead_count(scene), ring)
    patterns = {"elastic": elastic_pattern(scene)} | scene.get("contacts", {})
    for key, pattern in patterns.items():
        yield from _pattern_errors(f"contacts.{key}", pattern, contacts, ring)


def _material_errors(scene: Mapping) -> Iterator[str]:
    """Say what is wrong with beads and walls of materials."""
    beads, boundary, contacts = scene["beads"], scene["boundary"], scene.get("contacts", {})
    (key, words), wall = _words(beads), boundary.get("material")
    if not words:
        if wall:
            yield (
                f"boundary.material is {wall}, but the beads have no material: name theirs in "
                "beads.cell, as in steel 9.5 mm."
            )
        return
    given = [f"beads.{name}" for name in ("cell", "list", "mass") if name in beads]
    given += ["contacts.elastic"] if "elastic" in contacts else []
    if len(given) > 1:
        yield (
            f"{given[0]} names materials, which set masses and stiffness, but {given[1]} is given "
            "too: leave one of them out."
        )
    if boundary["kind"] == "wall" and not wall:
        yield "boundary.material is missing: name the material of the wall, as in steel."
    named = {name_entry(f"beads.{key}", index): word for index, word in enumerate(words)}
    for place, word in (named | ({"boundary.material": wall} if wall else {})).items():
        try:
            is_flat = math.isinf(body_of(word).radius)
        except InputError as error:
            yield f"{place}: {error}"
            continue
        if is_flat and place in named:
            yield f"{place} is {word}, without a diameter: give one, as in {word} 9.5 mm."


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
    places = [place for place, _ in impurities(pattern)]
    for place in sorted(set(places)):
        if place > count:
            yield f"{key}.impurity is at {place}, but there are {count}: give 1 to {count}."
        if places.count(place) > 1:
            yield f"{key}.impurity names {place} more than once: keep one of its values."
    if "list" in pattern and len(pattern["list"]) != count:
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
