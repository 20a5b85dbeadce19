"""Check that the law of a scene is possible, and estimate the sizes of its motion.

A scene is driven by relative displacements of about δ, with energies of about δ^(α + 1).  Sizes are
decimal logarithms, −∞ for none.
"""

import functools
import json
import math
import sys
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.model.laws import Law, make_law
from granular_fronts.model.potentials import Potential
from granular_fronts.scenes.beads import bead_count
from granular_fronts.scenes.drives import key_of_drive, largest_of

MOST_DECADES = 140
"""Decades on either side of 1 within which the square of a number is a double too."""

ABSOLUTE_TOLERANCE_FLOOR = 1.0e-20
"""Smallest absolute tolerance over the largest relative displacement: far below its round-off.

From rest the integrator's first steps shrink with it: at 1e-25 some laws take minutes, and none is
more exact.
"""

ABSOLUTE_TOLERANCE_CEILING = 0.1
"""Largest absolute tolerance over the largest relative displacement."""

DECADES_PER_UNIT = 8
"""Compressions for each factor of 10 among which the one of an energy is looked up."""


def is_short(law: object) -> bool:
    """Return whether a law is given by its exponents."""
    return isinstance(law, Mapping) and "alpha" in law


def law_errors(section: Mapping) -> Iterator[str]:
    """Say why the law of a section cannot be made."""
    law = section.get("law")
    if law is None or is_short(law):
        return
    try:
        made_law(law)
    except InputError as error:
        yield f"law: {error}"


def made_law(law: Any) -> Law:
    """Return the law of a mapping, or one that is made already; else an InputError."""
    if is_of_potentials(law):
        return make_law(law)
    if isinstance(law, Mapping):
        return _made(json.dumps(law, sort_keys=True))
    return law


def is_of_potentials(law: object) -> bool:
    """Return whether a law is a mapping with a potential that Python has made already."""
    return isinstance(law, Mapping) and any(isinstance(part, Potential) for part in law.values())


@functools.lru_cache
def _made(text: str) -> Law:
    return make_law(json.loads(text))


def exponent_of(law: Any) -> float | None:
    """Return the exponent α of a Hertz potential, None for other elastic potentials."""
    elastic = made_law(law).elastic
    return elastic.parameters[0] if elastic.kind == "hertz" else None


def decades_of_impact(law: Any, velocity: float, most: int) -> float:
    """Return the size of the strain that a velocity makes of contacts at rest, within 10^±most.

    A velocity v compresses them to about :math:`V(-u) = v^2`, that is :math:`v^{2/(α + 1)}` for
    the law (28), or stretches them as far where that takes less.
    """
    if velocity == 0.0:
        return -math.inf
    if is_short(law):
        return 2.0 / (law["alpha"] + 1.0) * math.log10(abs(velocity))
    elastic = made_law(law).elastic
    sizes = np.linspace(-most, most, 2 * most * DECADES_PER_UNIT + 1)
    energies = np.fmax(*(elastic.value(sign * 10.0**sizes) for sign in (-1.0, 1.0)))
    energies -= elastic.value(0.0)
    return _first_size(elastic, sizes, energies >= float(velocity) ** 2)


def decades_of_load(law: Any, load: float, most: int) -> float:
    """Return the size of the strain at which a contact bears a force, within 10^±most."""
    if load == 0.0:
        return -math.inf
    if is_short(law):
        return math.log10(load) / law["alpha"]
    elastic = made_law(law).elastic
    sizes = np.linspace(-most, most, 2 * most * DECADES_PER_UNIT + 1)
    forces = np.fmax(*(abs(elastic.first(sign * 10.0**sizes)) for sign in (-1.0, 1.0)))
    return _first_size(elastic, sizes, forces >= load)


def _first_size(potential: Any, sizes: Any, enough: Any) -> float:
    """Return the first size at which something is enough, or beyond which no contact is pressed."""
    enough = enough | (-(10.0**sizes) <= potential.domain[0])
    return float(sizes[enough.argmax()] if enough.any() else sizes[-1])


def front_speed(law: Any, size: float) -> float:
    """Return the front speed into contacts at rest, (V'(−u)/−u)^½ for u = 10^size."""
    elastic, u = made_law(law).elastic, 10.0**size
    if -u <= elastic.domain[0]:
        return 0.0
    return math.sqrt(abs(float(elastic.first(-u))) / u)


def decades_of_energy(law: Any, size: float) -> dict[str, float]:
    """Return the sizes of V and W at a compression of 10^size, by key of the law."""
    if is_short(law):
        return {key: (law[key] + 1.0) * size for key in ("alpha", "beta") if key in law}
    made = made_law(law)
    energies = {key: _decades_of_energy(getattr(made, key), size) for key in ("elastic", "viscous")}
    return {key: found for key, found in energies.items() if math.isfinite(found)}


def _decades_of_energy(potential: Any, size: float) -> float:
    """Return the same of one potential, −∞ where it is 0."""
    if potential.factor == 0.0 or -(10.0**size) <= potential.domain[0]:
        return -math.inf
    if potential.kind in ("hertz", "power"):
        return math.log10(potential.factor) + (potential.parameters[0] + 1.0) * size
    low, high = potential.domain
    at_rest = potential.value(0.0) if low < 0.0 < high else 0.0
    energy = abs(float(potential.value(-(10.0**size)) - at_rest))
    if energy == 0.0 and potential.shape:  # Functions that are given may be flat.
        energy = math.ulp(0.0)
    return math.log10(min(energy, sys.float_info.max)) if energy else -math.inf


def decades(value: float) -> float:
    """Return the decimal logarithm of a size."""
    return math.log10(abs(value)) if value else -math.inf


def decades_of_displacement(scene: Mapping) -> float:
    """Return the size of the largest relative displacement that drives a scene with a law."""
    if "displacement" in scene:
        return decades(scene["displacement"])
    boundary, start = scene["boundary"], scene["start"]
    displacements = [boundary.get("left", 0.0), boundary.get("right", 0.0)]
    displacements += start.get("relative_displacement", [])
    velocity = start.get("velocity", [])
    velocities = velocity if isinstance(velocity, list) else [velocity]
    drive, driven = largest_of(boundary), key_of_drive(boundary)
    fastest = max(map(abs, [drive if driven == "velocity" else 0.0, *velocities]))
    # A body force on N beads is the force of a compression, as a velocity is.
    weight = (
        math.sqrt(abs(scene.get("gravity", 0.0)) * bead_count(scene)) if "beads" in scene else 0.0
    )
    return max(
        max(map(decades, displacements)),
        decades_of_load(scene["law"], drive, MOST_DECADES) if driven == "force" else -math.inf,
        *(decades_of_impact(scene["law"], one, MOST_DECADES) for one in (fastest, weight)),
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
    """Say that an absolute tolerance drowns in the rounding of a motion, or lets all pass."""
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
