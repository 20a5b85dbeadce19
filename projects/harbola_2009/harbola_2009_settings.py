"""What a user may change: tapers of radii and of masses, and how accurately chains are solved."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.beads import Taper
from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.parts import Distinct, Part


class Pulses(Part):
    """Chains of spheres whose radii have a taper."""

    tapers: Annotated[dict[str, Taper], Field(min_length=1)]
    beads: Annotated[int, Field(ge=3, le=1000)]
    tolerance: Tolerance


class Losses(Part):
    """Values of ε, where each mass is exp(ε) times the one before."""

    tapers: Annotated[Distinct[Annotated[float, Field(ge=-1, le=1)]], Field(min_length=1)]
    tolerance: Tolerance


class TaperedChains(Part):
    """Pulses in chains of several tapers, and their losses at smaller and smaller taper."""

    pulses: Pulses
    losses: Losses
