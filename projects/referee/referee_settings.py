"""What the study of the scheme of discrete-element codes is given."""

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.memory import COLUMNS_PER_ROW, Held, memory_problems
from granular_fronts.scenes.parts import Listed, Part, say

Beta = Annotated[float, Field(ge=1, le=1.5)]
Gamma = Annotated[float, Field(ge=0.01, le=0.13)]
Steps = Annotated[int, Field(ge=10, le=10_000)]

BETA = "Exponent β of the viscous force."
GAMMA = "Strength γ of the viscous force."
STEPS = "Steps within the time of a collision."


class ShownChain(Part):
    """The chain whose motion and checks are shown."""

    beta: Beta = Field(description=BETA)
    gamma: Gamma = Field(description=GAMMA)
    steps_per_collision: Steps = Field(description=STEPS)


class HalfStepDamping(Part):
    """The half-step scheme of discrete-element codes and accurate chains, δ = c = 1."""

    alpha: Annotated[float, Field(ge=1.5, le=1.5)] = Field(
        description="Exponent α of the elastic force; the damping is measured for 1.5 alone."
    )
    # Each exponent is drawn in a line style, and each strength in a colour.
    betas: Listed[Beta] = Field(
        max_length=3, description="Exponents β of the viscous force, at most 3."
    )
    gammas: Listed[Gamma] = Field(
        max_length=6,
        description="Strengths γ of the viscous force, for which a front overshoots, at most 6.",
    )
    beads: Annotated[int, Field(ge=8, le=10_000)] = Field(description="Number N of beads.")
    collision_times: Annotated[int, Field(ge=2, le=1000)] = Field(
        description="End of the motion in times of a collision."
    )
    steps_per_collision: Listed[Steps] = Field(
        min_length=3, description="Steps within the time of a collision; three numbers or more."
    )
    shown: ShownChain

    def held(self) -> Iterator[Held]:
        """Numbers that are held at once."""
        keys = "beads", "collision_times", "steps_per_collision"
        states = float(self.collision_times) * max(self.steps_per_collision)
        asked = {key: getattr(self, key) for key in keys}
        yield Held(asked, COLUMNS_PER_ROW * self.beads * states)

    def problems(self) -> Iterator[str]:
        """The chain that is shown is one of those that are measured, and all fit into memory."""
        yield from memory_problems(self.held())
        for name in ("beta", "gamma"):
            value, measured = getattr(self.shown, name), getattr(self, f"{name}s")
            if value not in measured:
                yield (
                    f"shown.{name} is {say(value)}, but {name}s are "
                    f"{', '.join(map(say, measured))}: show one of these, or add it."
                )
