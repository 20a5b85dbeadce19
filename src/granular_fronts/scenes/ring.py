"""Scenes of the family ``periodic``: a ring and its amplitude equations, section 4.3."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.scenes.chain import (
    absolute_tolerance_resolves_motion,
    record_ends_with_motion,
    relative_tolerance_above_floor,
)
from granular_fronts.scenes.sections import Check

EQUATION_TOLERANCE_FLOOR = 1.0e-13
"""Smallest error per step that the rounding of a rescaled variable of order 1 lets through."""

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
    for key, found in _grids(scene).items():
        if found < needed:
            yield (
                f"{key} is {found}, too coarse to hold the edge of the wave, of width 1 on a ring "
                f"of length 2ℓ = {length:.6g}: give {needed} or more."
            )


def _grids(scene: Mapping) -> dict[str, int]:
    """Return the cells or points of the equations that a scene names, by their keys."""
    return {
        f"equations.{name}.{key}": settings[key]
        for name, settings in scene["equations"].items()
        for key in ("cells", "points")
        if key in settings
    }


def _equation_tolerances_above_floor(scene: Mapping) -> Iterator[str]:
    """No error per step drowns in rounding."""
    for name, settings in scene["equations"].items():
        tolerance = settings.get("tolerance", math.inf)
        if tolerance < EQUATION_TOLERANCE_FLOOR:
            yield (
                f"equations.{name}.tolerance is {tolerance}, under the solver's floor of "
                f"{EQUATION_TOLERANCE_FLOOR}: ask for the floor or more."
            )


def _upwind_scheme_has_its_measure(scene: Mapping) -> Iterator[str]:
    """The error of the paper's scheme is its distance from the finite volumes."""
    if "upwind" in scene["equations"] and "logarithmic" not in scene["equations"]:
        yield (
            "equations.logarithmic is missing, but equations.upwind is measured against it: give "
            "its cells and tolerance."
        )


RING: tuple[Check, ...] = (
    relative_tolerance_above_floor,
    absolute_tolerance_resolves_motion,
    _start_does_not_pull,
    _start_is_periodic,
    _plateau_fits_ring,
    _grids_hold_edge,
    _equation_tolerances_above_floor,
    _upwind_scheme_has_its_measure,
    record_ends_with_motion,
)
