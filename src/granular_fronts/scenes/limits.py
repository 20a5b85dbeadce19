"""How much memory a job needs at least, and the sentence for more than the machine has."""

import functools
import operator
import os
from collections.abc import Iterator, Mapping
from typing import Any

from granular_fronts.arguments import shown
from granular_fronts.scenes.beads import bead_count

BYTES_PER_NUMBER = 8
NUMBERS_PER_BEAD = 64  # state and stages of the integrator, and what is followed at each bead
COLUMNS_PER_ROW = 4  # numbers kept for each bead and time: two fields and what they are made from


Held = dict[tuple[str, ...], float]
"""How many numbers are held at once, by the dotted keys that together ask for them."""


def numbers_held(section: Mapping[str, Any]) -> Held:
    """Return how many numbers a scene or a study holds at least."""
    if "steps_per_collision" in section:  # A study that holds every state.
        states = float(section["collision_times"]) * max(section["steps_per_collision"])
        keys = "beads", "collision_times", "steps_per_collision"
        return {keys: COLUMNS_PER_ROW * section["beads"] * states}
    if "profile" in section and "mu" in section:  # Orbits, their well and their portrait.
        points = len(section["mu"]) * _points_of(section["profile"])
        held: Held = {("profile.stop", "profile.step"): COLUMNS_PER_ROW * points}
        for name, length in (("well", "limit"), ("portrait", "span")):
            if name in section:
                points = 2.0 * section[name][length] / section[name]["step"]
                held[f"{name}.{length}", f"{name}.step"] = COLUMNS_PER_ROW * points
        return held
    if "driven_bead" in section:  # An exact front and a chain.
        points = _points_of(section["window"])
        return {
            ("window.stop", "window.step"): 6.0 * COLUMNS_PER_ROW * points,
            ("driven_bead",): NUMBERS_PER_BEAD * float(section["driven_bead"]),
        }
    if "boundary" not in section and "half_beads" not in section:
        return {}  # The schema limits all counts.
    record, columns_per_row = section["record"], COLUMNS_PER_ROW
    if "half_beads" in section:  # The chain and two equations.
        key, beads, columns_per_row = "half_beads", 2.0 * section["half_beads"], 3 * COLUMNS_PER_ROW
    else:
        key = "beads.count" if isinstance(section["beads"], Mapping) else "beads"
        beads = float(bead_count(section))
    rows = len(record["snapshots"])
    held = {(key,): (NUMBERS_PER_BEAD + columns_per_row * rows) * beads}
    if "grid" in record:
        rows = section["end_time"] / record["grid"]["step"]
        held[key, "end_time", "record.grid.step"] = columns_per_row * rows * beads
    for name, axis in record.get("probes", {}).items():
        place = f"record.probes.{name}"
        numbers = COLUMNS_PER_ROW * _points_of(axis) * len(axis["beads"])
        held[f"{place}.stop", f"{place}.step"] = numbers
    for name, axis in record.get("sensors", {}).items():
        # A sensor needs the whole chain: momentum and energy of all beads beyond it count.
        place = f"record.sensors.{name}"
        numbers = COLUMNS_PER_ROW * _points_of(axis) * beads
        held[key, f"{place}.stop", f"{place}.step"] = numbers
    for name, settings in section.get("equations", {}).items():
        for count in {"cells", "points"} & settings.keys():
            held[f"equations.{name}.{count}",] = NUMBERS_PER_BEAD * float(settings[count])
    return held


def _points_of(axis: Mapping[str, float]) -> float:
    """Return how many points a range has, from its start to its stop."""
    return max(0.0, (axis["stop"] - axis["start"]) / axis["step"])


def memory_errors(section: Mapping[str, Any], held: Held) -> Iterator[str]:
    """Say that numbers held at once do not fit into memory, by the keys that ask for most."""
    memory, limit = BYTES_PER_NUMBER * sum(held.values()), memory_of_machine()
    if memory > limit:
        given = [
            f"{key} is {shown(functools.reduce(operator.getitem, key.split('.'), section))}"
            for key in max(held, key=held.__getitem__)
        ]
        yield (
            f"{' and '.join(given)}, for which at least {_in_gibibytes(memory)} of memory are "
            f"needed, above the {_in_gibibytes(limit)} of this machine: ask for less."
        )


def memory_of_machine() -> int:
    """Return the bytes of the memory of this machine."""
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


def _in_gibibytes(memory: float) -> str:
    value = memory / 2**30
    return f"{value:,.0f} GiB" if value < 1e6 else f"{value:.0e} GiB"
