"""A section of the configuration that a study takes, with all its checks.

The schema says which keys a section has.  Checks add what ties two keys together, and whether all
fits into memory.  A check is a function of a section that obeys the schema.  It yields a sentence
for each violation.  The sentence begins with the key inside the section, and names the value, the
limit and what to do.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from granular_fronts.scenes.memory import COLUMNS_PER_ROW, Held, memory_problems

Check = Callable[[Mapping], Iterator[str]]


def section_errors(given: Mapping, checks: tuple[Check, ...]) -> list[str]:
    """Say what is wrong with a section that obeys the schema; each level relies on the last.

    The checks of the section come after those of all sections.
    """
    return [*memory_problems(_held(given))] or [
        error for check in (ranges_increase, *checks) for error in check(given)
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
        if None not in (start, stop) and start >= stop:
            yield (
                f"{key}.start is {start}, but must come before its stop {stop}: lower start or "
                "raise stop."
            )


def _mappings(value: object, key: str = "") -> Iterator[tuple[str, Mapping]]:
    """Every mapping inside a value, with its dotted key."""
    if isinstance(value, Mapping):
        yield key, value
        for name, item in value.items():
            yield from _mappings(item, f"{key}.{name}" if key else name)
