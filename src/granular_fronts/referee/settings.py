"""What config/referee.yaml asks for: the motions, dampings and laws that make the problems."""

import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.memory import Held, memory_problems
from granular_fronts.scenes.parts import (
    Distinct,
    Name,
    NotNegative,
    Part,
    Positive,
    Several,
    Whole,
    name_entry,
    say,
)
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import read_yaml

LABEL = "config/referee.yaml: "
"""How each sentence on the settings begins."""

APART = 5  # contacts on both sides between which a pulse is timed
SAME = 1.0e-9  # distance of an end from a whole number of intervals that counts as none, over it
NUMBERS_OF_A_BEAD = 4  # of each state: u and ẋ, of the solution and of its refinement


class Motion(Part):
    """A chain, when its motion ends, and its dampings."""

    beads: Annotated[Whole, Field(ge=2)] = Field(description="Number of beads.")
    end_time: Positive = Field(description="Time at which the motion ends.")
    dampings: Annotated[Distinct[str], Field(min_length=1)] = Field(
        description="Names of dampings."
    )


class Motions(Part):
    """What moves the beads."""

    front: Motion | None = Field(
        None, description="A front that pressure drives into a chain at rest."
    )
    contact_loss: Motion | None = Field(
        None, description="The same in a short chain, whose last beads are ejected."
    )
    striker: Motion | None = Field(None, description="A chain whose first bead strikes the others.")
    collision: Motion | None = Field(
        None, description="Two beads, the first of which strikes the other."
    )
    solitary_wave: Motion | None = Field(
        None,
        description="As striker, where the speed of the pulse is compared with its force.",
    )

    def by_name(self) -> dict[str, Motion]:
        """Return the motions that are given."""
        return {name: motion for name, motion in self if motion}

    def problems(self) -> Iterator[str]:
        """There is a motion, two beads collide, and a pulse has a way."""
        if not self.by_name():
            yield f" is empty: give at least one of {', '.join(type(self).model_fields)}."
        if self.collision and self.collision.beads != 2:
            yield f"collision.beads is {self.collision.beads}, but two beads collide: write 2."
        if self.solitary_wave and self.solitary_wave.beads < (least := 2 * APART + 2):
            yield (
                f"solitary_wave.beads is {self.solitary_wave.beads}, too few to time a pulse: "
                f"write {least} or more."
            )


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
    laws: Annotated[dict[Name, Annotated[float, Field(ge=1)]], Field(min_length=1)] = Field(
        description="Exponents β of the viscous force, 3/2, 5/4 or 1, by the names of the laws."
    )
    dampings: Annotated[dict[Name, NotNegative], Field(min_length=1)] = Field(
        description="Dampings γ in units of the front (30), by their names; with 0 all laws are "
        "one, called hertz."
    )
    motions: Motions

    def problems(self) -> Iterator[str]:
        """Dampings are known, a table holds the problem's own, and motions end at a state."""
        for place, (before, factor) in enumerate(pairwise(self.factors), 1):
            if factor <= before:
                yield (
                    f"{name_entry('factors', place)} is {say(factor)}, not above {say(before)} "
                    "before it: list them in increasing order."
                )
        if 1.0 not in self.factors:
            yield "factors does not hold 1, the damping of the problem itself: add 1."
        for name, motion in self.motions.by_name().items():
            yield from self._motion_problems(f"motions.{name}", motion)

    def _motion_problems(self, key: str, motion: Motion) -> Iterator[str]:
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
        states = NUMBERS_OF_A_BEAD * motion.beads * motion.end_time / self.interval
        asked = {f"{key}.{name}": getattr(motion, name) for name in ("beads", "end_time")}
        yield from memory_problems([Held(asked | {"interval": self.interval}, states)])


class SettingsFile(Part):
    """Problems with known answers for discrete-element codes."""

    referee: Settings


def read_settings(file: Path | str) -> Settings:
    """Return what a file asks for; an InputError says what is wrong in it."""
    return read_part(SettingsFile, read_yaml(file), LABEL).referee
