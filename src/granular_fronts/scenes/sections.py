"""A section of the configuration that a study takes, with all its checks.

The schema says which keys a section has.  Checks add what ties two keys together, and whether all
fits into memory.  A check is a function of a section that obeys the schema.  It yields a sentence
for each violation.  The sentence begins with the key inside the section, and names the value, the
limit and what to do.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from granular_fronts.scenes.memory import COLUMNS_PER_ROW, Held, memory_problems

Check = Callable[[Mapping], Iterator[str]]


def section_errors(given: Mapping, checks: tuple[Check, ...]) -> list[str]:
    """Say what is wrong with a section that obeys the schema; each level relies on the last.

    The checks of the section come after those of all sections.
    """
    return [*memory_problems(_held(given))] or [
        error for check in (ranges_increase, steps_fit_ranges, *checks) for error in check(given)
    ]


def _held(section: Mapping[str, Any]) -> Iterator[Held]:
    """Numbers that a study holds at once, where the schema does not limit all counts."""
    if "steps_per_collision" in section:
        states = float(section["collision_times"]) * max(section["steps_per_collision"])
        keys = "beads", "collision_times", "steps_per_collision"
        asked = {key: section[key] for key in keys}
        yield Held(asked, COLUMNS_PER_ROW * section["beads"] * states)


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


def _mappings(value: object, key: str = "") -> Iterator[tuple[str, Mapping]]:
    """Every mapping inside a value, with its dotted key."""
    if isinstance(value, Mapping):
        yield key, value
        for name, item in value.items():
            yield from _mappings(item, f"{key}.{name}" if key else name)
