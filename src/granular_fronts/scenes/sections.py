"""A section of the configuration, for example a scene, with all its checks.

The schema says which keys a section has.  A `Section` adds what ties two keys together, how much
memory and time it takes, and what the figures draw from it.  A check is a function of a section
that obeys the schema.  It yields a sentence for each violation.  The sentence begins with the key
inside the section, and names the value, the limit and what to do.

Nothing of this imports numpy or numba: the workflow checks its configuration at each start.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from granular_fronts.scenes.drives import drive_errors
from granular_fronts.scenes.laws import energies_are_representable, law_errors
from granular_fronts.scenes.limits import Part, part_errors

Check = Callable[[Mapping], Iterator[str]]

TABLE = "the table of printed numbers"
"""It judges the paper's parameters only: it needs what is recorded, but no values of parameters."""


class Need(NamedTuple):
    """A key that must be there and not be empty, since a figure or a table draws it."""

    key: str  # dotted inside the section; of a family of scenes the first word is the scene
    user: str  # what draws or tabulates it
    values: tuple[float, ...] = ()  # that the list must have
    entries: int = 1  # that a list must have at the least


class Section(NamedTuple):
    """Checks of a section in addition to its schema.

    Its `checks` come after those of all sections: of its law and drive, `ranges_increase` and
    `steps_fit_ranges`.
    """

    checks: tuple[Check, ...] = ()
    # The parts of its memory and time; None where the schema limits all counts.
    size: Callable[[Mapping], Iterator[Part]] | None = None
    needs: tuple[Need, ...] = ()

    def errors(self, given: Mapping) -> list[str]:
        """Say what is wrong with a section that obeys the schema; each level relies on the last."""
        checks = (ranges_increase, steps_fit_ranges, *self.checks)
        return (
            [*law_errors(given), *drive_errors(given)]
            or [*energies_are_representable(given)]
            or [error for check in checks for error in check(given)]
            or [*(part_errors(given, [*self.size(given)]) if self.size else [])]
        )


def ranges_increase(section: Mapping) -> Iterator[str]:
    """Every range starts before it stops."""
    for key, mapping in _mappings(section):
        start: Any = mapping.get("start")
        stop: Any = mapping.get("stop")
        # A probe may be called start or stop.
        if None not in (start, stop) and not isinstance(start, Mapping) and start >= stop:
            yield (
                f"{key}.start is {start}, but must come before its stop {stop}: lower start or "
                "raise stop."
            )


def steps_fit_ranges(section: Mapping) -> Iterator[str]:
    """No step is longer than the range that it divides."""
    for key, mapping in _mappings(section):
        # A probe may be called start or step.
        own = {name: value for name, value in mapping.items() if not isinstance(value, Mapping)}
        if {"start", "stop", "step"} <= own.keys():
            length, limits = own["stop"] - own["start"], "from start to stop"
        else:
            limits = "span" if "span" in own else "limit"
            length = own.get(limits, math.inf)
        if 0 < length < own.get("step", 0.0):
            yield (
                f"{key}.step is {own['step']}, longer than the range of {length:g} that it "
                f"divides ({limits}): give {length:g} or less."
            )


def section_label(path: str) -> str:
    """Return how a sentence on a section begins, for example ``Scene weak: ``."""
    names = path.split(".")
    return f"Scene {names[-1]}: " if names[0] == "scenes" else f"{path}."


def need_errors(configuration: Mapping, path: str, needs: tuple[Need, ...]) -> Iterator[str]:
    """Say what figures need and a section, or a scene of a family ``path.*``, lacks."""
    missing = set()
    for need in needs:
        place, key = path, need.key
        if path.endswith("*"):
            scene, _, key = key.partition(".")
            place = path.removesuffix("*") + scene
        section = _look_up(configuration, place)
        if section is not None:
            yield from _errors_of_need(need, section_label(place) + key, _look_up(section, key))
        elif place not in missing:
            missing.add(place)
            yield (
                f"{place} is missing, but {need.user} needs it: give it as config/default.yaml "
                "does."
            )


def _errors_of_need(need: Need, place: str, found: Any) -> Iterator[str]:
    if not found:
        yield (
            f"{place} is {'missing' if found is None else 'empty or off'}, but {need.user} needs "
            "it: give it as config/default.yaml does."
        )
        return
    missing = [f"{value:g}" for value in need.values if value not in found]
    if missing:
        yield (
            f"{place} is {found}, but {need.user} needs {', '.join(missing)} too: add "
            f"{'it' if len(missing) == 1 else 'them'}."
        )
    if isinstance(found, list) and len(found) < need.entries:
        yield (
            f"{place} is {found}, but {need.user} needs {need.entries} entries or more: add one."
        )


def _look_up(section: Any, key: str) -> Any:
    """Return the value at a dotted key, or None."""
    for name in key.split("."):
        if not isinstance(section, Mapping) or name not in section:
            return None
        section = section[name]
    return section


def _mappings(value: object, key: str = "") -> Iterator[tuple[str, Mapping]]:
    """Every mapping inside a value, with its dotted key."""
    if isinstance(value, Mapping):
        yield key, value
        for name, item in value.items():
            yield from _mappings(item, f"{key}.{name}" if key else name)
