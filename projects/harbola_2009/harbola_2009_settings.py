"""What a user may change: tapers of radii and of masses, and how accurately chains are solved."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.beads import Taper
from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.parts import Listed, Part


class TaperedChains(Part):
    """Chains of spheres whose radii have a taper, and ε where a mass is exp(ε) times the last."""

    chains: Annotated[dict[str, Taper], Field(min_length=1)]
    tapers: Listed[Annotated[float, Field(ge=-1, le=1)]]
    tolerance: Tolerance
