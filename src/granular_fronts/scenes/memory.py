"""How much memory a job needs at least, and the sentence for more than the machine has."""

import os
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from granular_fronts.arguments import shown

BYTES_PER_NUMBER = 8
NUMBERS_PER_BEAD = 64  # state and stages of the integrator, and what is followed at each bead
COLUMNS_PER_ROW = 4  # numbers kept for each bead and time: two fields and what they are made from


class Held(NamedTuple):
    """Numbers that are held at once, and the keys with their values that together ask for them."""

    asked: Mapping[str, object]
    numbers: float


def memory_problems(held: Iterable[Held]) -> Iterator[str]:
    """Say that numbers held at once do not fit into memory, by the keys that ask for most."""
    held = [*held]
    memory, limit = BYTES_PER_NUMBER * sum(one.numbers for one in held), memory_of_machine()
    if memory > limit:
        most = max(held, key=lambda one: one.numbers)
        given = " and ".join(f"{key} is {shown(value)}" for key, value in most.asked.items())
        yield (
            f"{given}, for which at least {_in_gibibytes(memory)} of memory are needed, above the "
            f"{_in_gibibytes(limit)} of this machine: ask for less."
        )


def memory_of_machine() -> int:
    """Return the bytes of the memory of this machine."""
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


def _in_gibibytes(memory: float) -> str:
    value = memory / 2**30
    return f"{value:,.0f} GiB" if value < 1e6 else f"{value:.0e} GiB"
