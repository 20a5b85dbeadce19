"""What a campaign file may hold.

What the law, the scene and the numbers of a point may be is checked in `definition`, at the values
of the grid.
"""

import difflib
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BeforeValidator, Discriminator, Field, Tag
from pydantic_core import PydanticCustomError

from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.numbers import dotted, name_in_grid, number_paths
from granular_fronts.scenes.laws import LawOfPotentials
from granular_fronts.scenes.memory import Held, memory_problems
from granular_fronts.scenes.parts import (
    Distinct,
    Interval,
    NotNegative,
    Part,
    Place,
    Positive,
    Several,
    Whole,
    count,
    name_entry,
    say,
)
from granular_fronts.scenes.ring import GivenForce

DIGITS = 12
"""Significant digits of the values of a spaced axis."""

MOST_POINTS = 1_000_000
"""Points of a campaign that need not be asked for with ``allow_large: true``."""

NUMBERS_PER_POINT = 4
"""Memory of a point while the grid is written out, beside what is recorded, in numbers."""

Number = TypeVar("Number")


def _three(values: Any) -> Any:
    """Take a list of start, stop and count."""
    if isinstance(values, list) and len(values) != 3:
        sentence = f"{{key}} has {count(values)}: list 3 (start, stop, count)."
        raise PydanticCustomError("sentence", sentence)  # type: ignore[misc]
    return tuple(values) if isinstance(values, list) else values


StartStopCount = Annotated[tuple[Number, Number, Place], BeforeValidator(_three)]


class Spacing(Part):
    """Values from a start to a stop, rounded to 12 digits."""

    linspace: StartStopCount[float] | None = Field(
        None, description="Start, stop and count of evenly spaced values."
    )
    logspace: StartStopCount[Positive] | None = Field(
        None,
        description="Start, stop and count of values with even logarithms; start and stop are "
        "values.",
    )

    def __len__(self) -> int:
        """Return number of values."""
        return (self.linspace or self.logspace or ())[2]

    def values(self) -> list[float]:
        """Return the values, rounded, since a point is recognised by its values.

        So ``linspace: [0, 1, 21]`` holds the values of ``[0, 1, 11]`` to the last bit.
        """
        start, stop, count = self.linspace or self.logspace or ()
        fractions = [index / max(count - 1, 1) for index in range(count)]
        if self.linspace:
            exact = [start * (1.0 - f) + stop * f for f in fractions]
        else:
            exact = [start * (stop / start) ** f for f in fractions]
        return [float(f"{value:.{DIGITS}g}") for value in exact]

    def problems(self) -> Iterator[str]:
        """One spacing is given."""
        given = [name for name, values in self if values]
        if len(given) != 1:
            yield f" has {' and '.join(given) or 'no spacing'}: give linspace or logspace."


Axis = Annotated[
    Annotated[Spacing, Tag("<spaced>")]
    | Annotated[Several[float], Field(min_length=1), Tag("<listed>")],
    Discriminator(lambda value: f"<{'spaced' if isinstance(value, Mapping | Part) else 'listed'}>"),
]


class Profile(Interval):
    """Points at which the profile is kept too, in the coordinate of the kind (ξ or bead number)."""

    count: Annotated[Whole, Field(ge=2, le=100_000)] = Field(description="Number of points.")


class Record(Part):
    """What is kept of each point."""

    scalars: Annotated[Distinct[str], Field(min_length=1)] | None = Field(
        None, description="Names of the scalars to keep; all that the kind has if left out."
    )
    profile: Profile | None = None


class Start(Part):
    """Wave that a ring starts from: profile plateau, pulse, front or given."""

    profile: Literal["plateau", "pulse", "front", "given"] = Field(
        description="Rescaled force y at t = 0 over one turn of the ring.  It is the plateau of "
        "equation (49), a pulse (a periodic Gaussian), a front of equation (45) with its mirror "
        "image, or given as a list."
    )
    velocity: Literal["leading", "slow"] = Field(
        "slow",
        description="Velocities at t = 0: leading for equation (51), slow for equation (43), on "
        "the slow manifold to first order.",
    )
    rescaled_force: Annotated[Several[NotNegative], Field(min_length=5)] | None = Field(
        None,
        description="For profile given, values of y at equally spaced points from −ℓ to ℓ, the "
        "first equal to the last.",
    )

    def problems(self) -> Iterator[str]:
        """A list is given for its profile alone, and is a wave on a ring."""
        if (self.rescaled_force is not None) != (self.profile == "given"):
            yield (
                f" has profile {self.profile}, but rescaled_force belongs only to profile given: "
                "give both or neither."
            )
        if self.rescaled_force:
            yield from GivenForce(kind="given", rescaled_force=self.rescaled_force).problems()
            if len({*self.rescaled_force}) == 1:
                yield "rescaled_force has one value throughout, which is no wave: vary it."


class CampaignFile(Part):
    """A grid of parameter points of one kind of problem."""

    kind: Literal["chain", "front", "motion", "ring"] = Field(
        description="Kind of problem solved at each point."
    )
    law: LawOfPotentials | None = Field(
        None,
        description="Law by the kinds of its potentials, in place of alpha, beta and gamma, as in "
        "the configuration.  An axis such as law.elastic.rate varies one of its numbers.",
    )
    scene: dict[str, Any] | None = Field(
        None,
        description="Scene of a chain as in the configuration, for kind motion.  An axis such as "
        "beads.mass.cell.2 varies one of its numbers, here the second entry of a list.  Its sensor "
        "says where numbers are measured.",
    )
    axes: Annotated[dict[str, Axis], Field(min_length=1)] = Field(
        description="Parameters that vary, slowest first, each with its increasing values, a list "
        "or their spacing.  Along the last one, the fast axis, solutions are continued and chunks "
        "are cut last."
    )
    fixed: dict[str, Annotated[float, Field(description="Value of the parameter.")]] = Field(
        {}, description="Parameters with one value for the whole campaign."
    )
    start: Start | None = None
    tolerance: Annotated[float, Field(ge=1e-15, le=0.1)] = Field(
        1.0e-9, description="Accuracy asked of the solver, as the kind uses it."
    )
    record: Record = Record()
    chunk_points: Place | None = Field(
        None, description="Most points solved by one job; by the usual time of a point if left out."
    )
    allow_large: bool = Field(
        False, description="Whether more points than the usual bound are meant."
    )

    @property
    def point(self) -> type[Part]:
        """The numbers of a point, but for those inside a law or a scene."""
        is_given = self.law or (self.start and self.start.rescaled_force)
        kind = KINDS[self.kind]
        return kind.point_of_given if is_given else kind.point

    @property
    def inside(self) -> dict[str, str]:
        """The axes that vary a number of the law or the scene, with their names in the grid."""
        if self.scene is not None:
            return {axis: name_in_grid(axis) for axis in self.axes}
        of_law = [axis for axis in self.axes if self.law and axis.startswith("law.")]
        return {axis: name_in_grid(axis.removeprefix("law.")) for axis in of_law}

    def problems(self) -> Iterator[str]:
        """The keys are those of the kind, and numbers and scalars exist; the grid is not huge."""
        yield from self._kind_has_keys()
        yield from self._kind_has_record()
        size = math.prod(map(len, self.axes.values()))
        if size > MOST_POINTS and not self.allow_large:
            yield (
                f"axes make {size:,.0f} points, above {MOST_POINTS:,}: shorten an axis, or write "
                "allow_large: true."
            )
        profile = self.record.profile.count if self.record.profile else 0
        kept = len(self.record.scalars or KINDS[self.kind].scalars) + profile
        asked = {f"axes.{name}": values for name, values in self.plain()["axes"].items()}
        yield from memory_problems([Held(asked, size * (NUMBERS_PER_POINT + kept))])

    def _kind_has_keys(self) -> Iterator[str]:
        kind, given = KINDS[self.kind], [*self.axes, *self.fixed]
        for key in ("law", "scene", "start", "fixed", "tolerance"):
            if key in self.model_fields_set and key not in kind.keys:
                yield f"{key} is given, but kind {self.kind} has none: leave it out."
        for key in ("scene", "start"):
            if key in kind.keys and getattr(self, key) is None:
                yield f"{key} is missing, but kind {self.kind} needs one: add it."
        for number in self.fixed:
            if number in self.axes:
                yield f"{number} is given under axes and under fixed: leave one out."
        for group in kind.one_of:
            found = [number for number in group if number in given]
            if len(found) != 1:
                yield (
                    f"axes and fixed need exactly one of {', '.join(group)}, and have "
                    f"{' and '.join(found) or 'none'}: {'keep' if found else 'give'} one."
                )
        known = [*map(dotted, number_paths(self.scene))]
        for axis in self.axes if self.scene is not None else ():
            if axis not in known:
                yield f"axes.{axis} is no number of the scene: {_advice(axis, known)}"

    def _kind_has_record(self) -> Iterator[str]:
        kind, profile = KINDS[self.kind], self.record.profile
        for index, name in enumerate(self.record.scalars or ()):
            if name not in kind.scalars:
                yield (
                    f"{name_entry('record.scalars', index)} is {name!r}, which kind {self.kind} "
                    f"does not record: {_advice(name, kind.scalars)}"
                )
        if profile and kind.profile_counts:
            beads = math.floor(profile.stop) - math.ceil(profile.start) + 1
            if profile.count > beads:
                yield (
                    f"record.profile.count is {profile.count}, but from {say(profile.start)} to "
                    f"{say(profile.stop)} there are {beads} beads: ask for no more."
                )


def _advice(name: str, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(name, known, n=1)
    return f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}."
