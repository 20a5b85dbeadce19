"""Scenes of the family ``periodic``: a ring beside its amplitude equations, section 4.3."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.scenes.chain import (
    absolute_tolerance_resolves_motion,
    record_ends_with_motion,
    relative_tolerance_above_floor,
)
from granular_fronts.scenes.limits import (
    COLUMNS_PER_ROW,
    NUMBERS_PER_BEAD,
    SECONDS_PER_CROSSING,
    SECONDS_PER_POINT,
    Part,
    grid_part,
)
from granular_fronts.scenes.sections import Need, Section

EQUATION_TOLERANCE_FLOOR = 1.0e-13
"""Smallest error per step that the rounding of a rescaled variable of order 1 lets through."""

SOLVED_EQUATIONS = ("logarithmic", "unlimited", "dispersive")
"""Keys of the amplitude equations that have cells and a tolerance of their own."""

CELLS_PER_EDGE = 2
"""Fewest cells over a unit of ξ, the width of the falling edge of eq. (49)."""


def _start_does_not_pull(scene: Mapping) -> Iterator[str]:
    """A rescaled force is not negative, since no contact pulls."""
    smallest = min(scene["start"].get("rescaled_force", [0.0]))
    if smallest < 0:
        yield (
            f"start.rescaled_force has {smallest} as its smallest value, but a contact cannot "
            "pull: give values of 0 or more."
        )


def _start_is_periodic(scene: Mapping) -> Iterator[str]:
    """The values at −ℓ and ℓ are equal, since these are one point of the ring."""
    first, *_, last = scene["start"].get("rescaled_force", [0.0, 0.0])
    if first != last:
        yield (
            f"start.rescaled_force begins with {first} and ends with {last}, but on a ring both "
            "ends are one point: give a periodic start."
        )


def _plateau_fits_ring(scene: Mapping) -> Iterator[str]:
    """A start (49) falls to its floor within −ℓ ≤ ξ ≤ ℓ."""
    half_length = scaling_of(scene).half_length(scene["half_beads"])
    half_width = scene["start"].get("half_width", -1.0)
    if half_width + 1.0 > half_length:
        yield (
            f"start.half_width is {half_width}, and with its edge of width 1 the plateau exceeds "
            f"half the ring, ℓ = (p − 1/2) ε = {half_length:.6g}: lower it or raise half_beads."
        )


def _grids_hold_edge(scene: Mapping) -> Iterator[str]:
    """Cells are no wider than the edge of a wave allows."""
    length = 2.0 * scaling_of(scene).half_length(scene["half_beads"])
    needed = math.ceil(CELLS_PER_EDGE * length)
    equations = scene["equations"]
    counts = {f"{name}.cells": equations[name]["cells"] for name in SOLVED_EQUATIONS}
    for name, found in (counts | {"upwind.points": equations["upwind"]["points"]}).items():
        if found < needed:
            yield (
                f"equations.{name} is {found}, too coarse to hold the edge of the wave, of width 1 "
                f"on a ring of length 2ℓ = {length:.6g}: give {needed} or more."
            )


def _equation_tolerances_above_floor(scene: Mapping) -> Iterator[str]:
    """No error per step drowns in rounding."""
    for name in SOLVED_EQUATIONS:
        tolerance = scene["equations"][name]["tolerance"]
        if tolerance < EQUATION_TOLERANCE_FLOOR:
            yield (
                f"equations.{name}.tolerance is {tolerance}, under the solver's floor of "
                f"{EQUATION_TOLERANCE_FLOOR}: ask for the floor or more."
            )


def _size_of_ring(scene: Mapping) -> Iterator[Part]:
    """A ring of 2p − 1 beads, and its amplitude equations on their grids."""
    beads, end, scaling = 2.0 * scene["half_beads"], scene["end_time"], scaling_of(scene)
    equations, rows = scene["equations"], end / scene["record"]["grid"]["step"]
    crossings = scaling.speed * end * beads
    yield Part(
        ("half_beads", "end_time"), (), NUMBERS_PER_BEAD * beads, crossings * SECONDS_PER_CROSSING
    )
    numbers = 3.0 * COLUMNS_PER_ROW * rows * beads
    yield grid_part(("half_beads", "end_time"), ("record.grid.step",), numbers)
    for name in SOLVED_EQUATIONS:
        cells = float(equations[name]["cells"])
        yield grid_part((f"equations.{name}.cells",), (), NUMBERS_PER_BEAD * cells)
    points = float(equations["upwind"]["points"])
    per_length = points / (2.0 * scaling.half_length(scene["half_beads"]))
    seconds = points * per_length * per_length * scaling.slow_rate * end * SECONDS_PER_POINT
    yield Part(("equations.upwind.points", "end_time"), (), NUMBERS_PER_BEAD * points, seconds)


RING = Section(
    checks=(
        relative_tolerance_above_floor,
        absolute_tolerance_resolves_motion,
        _start_does_not_pull,
        _start_is_periodic,
        _plateau_fits_ring,
        _grids_hold_edge,
        _equation_tolerances_above_floor,
        record_ends_with_motion,
    ),
    size=_size_of_ring,
    needs=tuple(
        need
        for scene in ("weak", "hertz")
        for need in (
            Need(f"{scene}.record.snapshots", "figure 5", values=(0.0,)),
            Need(
                f"{scene}.record.snapshots", "the speed in the table of printed numbers", entries=2
            ),
        )
    ),
)
