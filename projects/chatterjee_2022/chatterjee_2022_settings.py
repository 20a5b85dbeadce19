"""What a user may change: the laws of the contact, its dampings, and the loads on the ball."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.parts import Listed, Named, Part, Positive


class Powers(Part):
    """Exponents of the elastic and the viscous force."""

    alpha: Annotated[float, Field(ge=1, le=3)]
    beta: Annotated[float, Field(ge=1, le=3)]


class Falls(Part):
    """A ball that falls on a plate with the velocity 1."""

    laws: Named[Powers]
    loads: Listed[Annotated[float, Field(ge=0, le=0.1)]]
    dampings: Listed[Positive]
    tolerance: Tolerance
