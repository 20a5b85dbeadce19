"""Sizes of what moves in a scene, as decimal logarithms, and what double precision holds of them.

A scene is driven by relative displacements of about δ, with energies of about δ^(α + 1).
"""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.scenes.laws import decades_of_energy, decades_of_impact, is_short

MOST_DECADES = 140
"""Decades on either side of 1 within which the square of a number is a double too."""

ABSOLUTE_TOLERANCE_FLOOR = 1.0e-20
"""Smallest absolute tolerance over the largest relative displacement: far below its round-off.

From rest the integrator's first steps shrink with it: at 1e-25 some laws take minutes, and none is
more exact.
"""

ABSOLUTE_TOLERANCE_CEILING = 0.1
"""Largest absolute tolerance over the largest relative displacement."""


def decades(value: float) -> float:
    """Decimal logarithm of a size, −∞ for none."""
    return math.log10(abs(value)) if value else -math.inf


def decades_of_displacement(scene: Mapping) -> float:
    """Decimal logarithm of the largest relative displacement that drives a scene.

    Parameters
    ----------
    scene : mapping
        A scene with a law that obeys the schema.

    Returns
    -------
    float
        −∞ where nothing moves.
    """
    if "displacement" in scene:
        return decades(scene["displacement"])
    boundary, start = scene["boundary"], scene["start"]
    displacements = [boundary.get("left", 0.0), boundary.get("right", 0.0)]
    displacements += start.get("relative_displacement", [])
    velocities = [boundary.get("velocity", 0.0), *start.get("velocity", [])]
    fastest = max(map(abs, velocities))
    return max(
        max(map(decades, displacements)), decades_of_impact(scene["law"], fastest, MOST_DECADES)
    )


def energies_are_representable(scene: Mapping) -> Iterator[str]:
    """Energies δ^(α + 1) of a scene with a law, and the damping, neither overflow nor vanish."""
    if "law" not in scene:
        return
    law, size = scene["law"], decades_of_displacement(scene)
    if math.isfinite(size):
        for name, found in decades_of_energy(law, size).items():
            if abs(found) > MOST_DECADES:
                key = f"law.{name} is {law[name]}, which" if is_short(law) else f"law.{name}"
                yield (
                    f"{key} with relative displacements of about 1e{size:+.0f} makes energies of "
                    f"about 1e{found:+.0f}, beyond the 1e±{MOST_DECADES} that double precision can "
                    "square: bring both nearer to 1."
                )
    if not is_short(law):
        return
    found = decades(law["gamma"])
    if math.isfinite(found) and abs(found) > MOST_DECADES:
        yield (
            f"law.gamma is {law['gamma']}, beyond the 1e±{MOST_DECADES} that double precision can "
            "square: bring it nearer to 1, or give 0 for no damping."
        )


def absolute_tolerance_errors(absolute: float, size: float) -> Iterator[str]:
    """Say that an absolute tolerance drowns in rounding, or lets everything pass.

    Parameters
    ----------
    absolute : float
        The key ``tolerance.absolute`` of a section.
    size : float
        Decimal logarithm of the largest relative displacement.

    Yields
    ------
    str
    """
    above = math.log10(absolute) - size
    if above < math.log10(ABSOLUTE_TOLERANCE_FLOOR):
        limit, side, advice = ABSOLUTE_TOLERANCE_FLOOR, "below", "more"
    elif math.isfinite(above) and above > math.log10(ABSOLUTE_TOLERANCE_CEILING):
        limit, side, advice = ABSOLUTE_TOLERANCE_CEILING, "above", "less"
    else:
        return
    largest = 10.0**size
    yield (
        f"tolerance.absolute is {absolute}, {side} {limit:g} of the largest relative displacement, "
        f"which is about {largest:.3g}: give {limit * largest:.1e} or {advice}."
    )
