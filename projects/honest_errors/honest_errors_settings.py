"""Random problems whose stated errors are compared with true ones."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.parts import Part, Whole


class RandomProblems(Part):
    """Which random problems of a kind are solved."""

    seed: Annotated[Whole, Field(ge=0)] = Field(description="Seed of the random numbers.")
    count: Annotated[int, Field(ge=1, le=100_000)] = Field(description="How many problems.")


class HonestErrors(Part):
    """Random problems of each kind."""

    chains: RandomProblems = Field(description="Chains of every law, boundary and start.")
    fronts: RandomProblems = Field(description="Exact fronts of every law.")
    rings: RandomProblems = Field(description="Rings against their amplitude equations.")
