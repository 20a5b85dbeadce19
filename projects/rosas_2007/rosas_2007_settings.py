"""What a user may change: three impacts, and fronts far behind others."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Chain, Tolerance
from granular_fronts.scenes.parts import Distinct, Part, Positive


class Fronts(Part):
    """Strengths γ of the viscous force, and contacts at which fronts are compared."""

    dampings: Annotated[Distinct[Positive], Field(min_length=1)]
    contacts: Annotated[Distinct[Annotated[int, Field(ge=100, le=10_000)]], Field(min_length=1)]
    tolerance: Tolerance


class Impacts(Part):
    """Motions behind an impact by their damping, and fronts that are compared with exact ones."""

    weak: Chain
    medium: Chain
    strong: Chain
    fronts: Fronts
