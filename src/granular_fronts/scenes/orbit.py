"""Scenes of the family ``heteroclinic``: fronts of equation (56), section 5.2."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.model.amplitude_scaling import SMALLEST_DAMPING
from granular_fronts.scenes.schema import name_entry
from granular_fronts.scenes.sections import Check

GAUSSIAN_CENTRE = -2.0 * math.sqrt(0.5 + math.log(2.0))
"""The s of the maximum of the orbit for μ = 0, y = exp(½ − (s − centre)²/4) with y(0) = ½."""

GAUSSIAN_HALF_WIDTH = 2.0 * math.sqrt(0.5 - math.log(5e-324))
"""Distance in s from that centre at which this orbit is below the smallest double."""

LATER_UNDERFLOW = 7.0
"""Bound on how much later, over μ, the other orbits underflow: ln(745/ln 2) ≈ 6.98 for large μ."""


def _dampings_are_normal(scene: Mapping) -> Iterator[str]:
    """A damping is 0 or leaves the energy of the orbit its digits."""
    for index, mu in enumerate(scene["mu"]):
        if 0 < mu < SMALLEST_DAMPING:
            yield (
                f"{name_entry('mu', index)} is {mu}, where the energy of the orbit loses its "
                f"digits: give 0, or {SMALLEST_DAMPING} or more."
            )


def _profile_ends_before_underflow(scene: Mapping) -> Iterator[str]:
    """The fronts are kept where y is a double above zero."""
    profile, mu = scene["profile"], min(scene["mu"])
    last = GAUSSIAN_CENTRE + GAUSSIAN_HALF_WIDTH + LATER_UNDERFLOW * mu
    first = GAUSSIAN_CENTRE - GAUSSIAN_HALF_WIDTH if mu == 0 else -math.inf
    for key, beyond, limit in [
        ("stop", profile["stop"] > last, last),
        ("start", profile["start"] < first, first),
    ]:
        if beyond:
            yield (
                f"profile.{key} is {profile[key]}, but for mu = {mu} y falls below the smallest "
                f"double at s = {limit:.2f}: end the profile before."
            )


def _portrait_leaves_equilibria(scene: Mapping) -> Iterator[str]:
    """No trajectory of the plane starts in an equilibrium, where it would stay."""
    for index, (y, z) in enumerate(scene.get("portrait", {}).get("starts", [])):
        if z == 0 and y in (-1, 0, 1):
            yield (
                f"{name_entry('portrait.starts', index)} is [{y}, {z}], an equilibrium, where "
                "nothing moves: start elsewhere."
            )


def _portrait_has_its_orbit(scene: Mapping) -> Iterator[str]:
    """The damping of a portrait is one of those whose orbit is computed."""
    mu = scene.get("portrait", {}).get("mu")
    if mu is not None and mu not in scene["mu"]:
        yield (
            f"portrait.mu is {mu}, but the orbit shown in the portrait is one of mu "
            f"{scene['mu']}: choose one of these, or add {mu} to mu."
        )


ORBIT: tuple[Check, ...] = (
    _dampings_are_normal,
    _profile_ends_before_underflow,
    _portrait_leaves_equilibria,
    _portrait_has_its_orbit,
)
