"""Limits of memory and time of one job, and the sentence for a section that exceeds them.

The estimates of memory and time are lower bounds, mostly by orders of magnitude.  They decide only
what is refused.  A job of half a day is accepted; a job of days is refused before it starts.
"""

import functools
import operator
from collections.abc import Iterator, Mapping
from typing import NamedTuple

MOST_MEMORY = 16 * 2**30  # bytes that one job may hold
LONGEST_TIME = 86400.0  # seconds on one core that one job may take

MOST_VALUES = 1_000_000
"""Values of a configuration, a campaign or a scene: to check so many takes half a minute."""

BYTES_PER_NUMBER = 8
LARGEST = 1.0e300  # replaces what overflows

NUMBERS_PER_BEAD = 64  # state and stages of the integrator, and what is followed at each bead
COLUMNS_PER_ROW = 4  # numbers kept for each bead and time: two fields and what they are made from
SECONDS_PER_POINT = 5.0e-9  # of a grid, for each step in time or each evaluation

SECONDS_PER_CROSSING = 5.0e-8
"""A front of height δ runs through a bead in the time 1/c, c = δ^((α − 1)/2): one crossing."""


class Part(NamedTuple):
    """What some keys together, dotted inside a section, contribute to its size."""

    large: tuple[str, ...]  # of counts, with which the size grows
    small: tuple[str, ...] = ()  # of spacings, with which it falls
    numbers: float = 0.0  # held at once
    seconds: float = 0.0  # on one core

    @property
    def memory(self) -> float:
        """Bytes held at once."""
        return min(BYTES_PER_NUMBER * self.numbers, LARGEST)


def grid_part(large: tuple[str, ...], small: tuple[str, ...], numbers: float) -> Part:
    """Return the part of a grid of so many numbers, each of which takes its time."""
    return Part(large, small, numbers, numbers * SECONDS_PER_POINT)


def points_of(axis: Mapping) -> float:
    """Return how many points a range has, from its start to its stop."""
    return (axis["stop"] - axis["start"]) / axis["step"]


def part_errors(section: Mapping, parts: list[Part]) -> Iterator[str]:
    """Say that some parts together are too large: the keys that contribute most, and the size."""
    memory = sum(part.memory for part in parts)
    seconds = min(sum(part.seconds for part in parts), LARGEST)
    if memory <= MOST_MEMORY and seconds <= LONGEST_TIME:
        return
    most = max(parts, key=lambda part: max(part.memory / MOST_MEMORY, part.seconds / LONGEST_TIME))
    above = [
        (f"{_show_memory(memory)} of memory", _show_memory(MOST_MEMORY), memory > MOST_MEMORY),
        (f"{show_time(seconds)} on one core", show_time(LONGEST_TIME), seconds > LONGEST_TIME),
    ]
    sizes, limits, _ = zip(*(one for one in above if one[-1]), strict=True)
    keys = [
        f"{key} = {functools.reduce(operator.getitem, key.split('.'), section)}"
        for key in (*most.large, *most.small)
    ]
    remedies = [f"lower {' or '.join(most.large)}"] if most.large else []
    remedies += [f"raise {' or '.join(most.small)}"] if most.small else []
    yield (
        f"{', '.join(keys)} {'takes' if len(keys) == 1 else 'take'} at least "
        f"{' and '.join(sizes)}, above the limit of {' or '.join(limits)}: "
        f"{', or '.join(remedies)}."
    )


def _show_memory(memory: float) -> str:
    """Return the bytes in words, for example ``16 GiB``."""
    for unit in ("bytes", "KiB", "MiB"):
        if memory < 1000.0:
            return f"{memory:.0f} {unit}"
        memory /= 1024.0
    return f"{_show_number(memory)} GiB"


def show_time(seconds: float) -> str:
    """Return a duration in words, for example ``30 days``."""
    for unit, length in [("years", 365.25 * 86400.0), ("days", 86400.0), ("hours", 3600.0)]:
        if seconds >= 2.0 * length:
            return f"{_show_number(seconds / length)} {unit}"
    return f"{seconds:.0f} s"


def _show_number(value: float) -> str:
    return f"{value:,.0f}" if value < 1e6 else f"{value:.0e}"
