"""What problems.yaml asks for: the motions, dampings and laws that make the problems."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.parts import (
    Listed,
    Named,
    NotNegative,
    Part,
    Positive,
    Several,
    say,
)
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import read_yaml

FILE = Path(__file__).with_name("problems.yaml")

APART = 5  # contacts on both sides between which a pulse is timed
SAME = 1.0e-9  # distance of an end from a whole number of intervals that counts as none, over it

Kind = Literal["plate", "drop", "collision", "striker", "solitary_wave", "front", "contact_loss"]


class Motion(Part):
    """A chain, when its motion ends, and its dampings."""

    beads: Annotated[int, Field(ge=1, le=10_000)] = Field(description="Number of beads.")
    end_time: Positive = Field(description="Time at which the motion ends.")
    dampings: Listed[str] = Field(description="Names of dampings.")


class Settings(Part):
    """What the problems have in common, and the motions, dampings and laws that make them."""

    displacement: Annotated[float, Field(gt=0, le=1e8)] = Field(
        description="Relative displacement δ that the pressure keeps at the pushed end."
    )
    interval: Positive = Field(description="Time between two states that are compared.")
    tolerance: Tolerance
    factors: Annotated[Several[Positive], Field(min_length=3)] = Field(
        description="Dampings over γ at which the measured number is known, increasing, 1 among "
        "them."
    )
    laws: Named[Annotated[float, Field(ge=1)]] = Field(
        description="Exponents β of the viscous force, 3/2, 5/4 or 1, by the names of the laws."
    )
    dampings: Named[NotNegative] = Field(
        description="Dampings γ in units of the front (30), by their names; with 0 all laws are "
        "one, called hertz."
    )
    motions: Annotated[dict[Kind, Motion], Field(min_length=1)] = Field(
        description="A bead that hits a plate with a velocity, or falls on it by its weight; a "
        "front that pressure drives into a chain at rest; the same in a short chain, "
        "whose last beads are ejected; a bead that strikes a chain, or another bead; the same "
        "chain, where the speed of the pulse is compared with its force."
    )

    def combinations(self) -> dict[str, tuple[Kind, str, str]]:
        """Return motion, damping and law of each problem by its name."""
        return {
            f"{motion}_{damping}_{law}": (motion, damping, law)
            for motion, chain in self.motions.items()
            for damping in chain.dampings
            for law in (self.laws if self.dampings[damping] else ["hertz"])
        }

    def problems(self) -> Iterator[str]:
        """Dampings are known, a table holds the problem's own, and motions end at a state."""
        if 1.0 not in self.factors or [*self.factors] != sorted({*self.factors}):
            factors = ", ".join(map(say, self.factors))
            yield (
                f"factors are {factors}, but must increase and hold 1, the damping of the problem "
                "itself: sort them and add 1."
            )
        for name, motion in self.motions.items():
            yield from self._motion_problems(f"motions.{name}", name, motion)

    def _motion_problems(self, key: str, name: Kind, motion: Motion) -> Iterator[str]:
        for damping in motion.dampings:
            if damping not in self.dampings:
                yield (
                    f"{key}.dampings names {damping!r}, which is unknown: choose from "
                    f"{', '.join(self.dampings)}."
                )
        if abs(math.remainder(motion.end_time, self.interval)) > SAME * motion.end_time:
            yield (
                f"{key}.end_time is {say(motion.end_time)}, no multiple of interval "
                f"{say(self.interval)}, so that no state is compared at the end: change one."
            )
        at_wall = name in ("plate", "drop")
        if at_wall != (motion.beads == 1):
            yield (
                f"{key}.beads is {motion.beads}, but one bead hits a plate, and other motions have "
                "more: write such a number."
            )
        if name == "collision" and motion.beads != 2:
            yield f"{key}.beads is {motion.beads}, but two beads collide: write 2."
        if name == "solitary_wave" and motion.beads < (least := 2 * APART + 2):
            yield (
                f"{key}.beads is {motion.beads}, too few to time a pulse: write {least} or more."
            )


def read_settings() -> Settings:
    """Return what problems.yaml asks for; an InputError says what is wrong in it."""
    return read_part(Settings, read_yaml(FILE), f"{FILE.name}: ")
