"""What a user may change: motions that are shown, shocks that are followed, and exact fronts."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Chain, Tolerance
from granular_fronts.scenes.parts import Distinct, NotNegative, Part, Positive

Exponent = Annotated[float, Field(gt=1, le=5)]


class Shocks(Part):
    """Strengths γ of the viscous force, and contacts that crests pass."""

    alpha: Exponent
    dampings: Annotated[Distinct[NotNegative], Field(min_length=1)]
    contacts: Annotated[Distinct[Annotated[int, Field(ge=20, le=10_000)]], Field(min_length=3)]
    tolerance: Tolerance


class Fronts(Part):
    """Strengths γ of the viscous force, each half the one before."""

    alpha: Exponent
    dampings: Annotated[Distinct[Positive], Field(min_length=4)]


class WeakDamping(Part):
    """Driven chains without and with damping, and exact fronts."""

    free: Chain
    weak: Chain
    medium: Chain
    strong: Chain
    shocks: Shocks
    fronts: Fronts
