"""What a user may change: three impacts, and fronts far behind others."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Chain, Tolerance
from granular_fronts.scenes.parts import Listed, Part, Positive

Contact = Annotated[int, Field(ge=100, le=10_000)]


class Fronts(Part):
    """Strengths γ of the viscous force, contacts, and what counts as two pulses."""

    dampings: Listed[Positive]
    contacts: Listed[Contact]
    early_contacts: Listed[Contact]
    parts: Listed[Annotated[float, Field(ge=0.1, lt=1)]]
    tolerance: Tolerance


class Impacts(Part):
    """Motions behind an impact by their damping, and fronts that are compared with exact ones."""

    weak: Chain
    medium: Chain
    strong: Chain
    fronts: Fronts
