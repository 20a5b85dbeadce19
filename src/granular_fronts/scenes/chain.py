"""Scenes of the family ``chain``: motions of a finite chain of beads, section 3.3."""

import functools
import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from granular_fronts.scenes.beads import Contacts, CountOrBeads, Pattern, Wall
from granular_fronts.scenes.drives import Drive, FunctionOfTime, Piece
from granular_fronts.scenes.laws import (
    AnyLaw,
    decades,
    decades_of_impact,
    decades_of_load,
    energy_problems,
    exponent_of,
    tolerance_problems,
)
from granular_fronts.scenes.memory import COLUMNS_PER_ROW, NUMBERS_PER_BEAD, Held, memory_problems
from granular_fronts.scenes.parts import (
    Distinct,
    Listed,
    Name,
    NotNegative,
    Part,
    Place,
    Positive,
    Several,
    Times,
    name_entry,
    say,
)
from granular_fronts.scenes.sentences import Scene

RELATIVE_TOLERANCE_FLOOR = 1.0e-15
"""Smallest relative tolerance the solver can honour: a few units of double-precision round-off."""

LARGEST_OVERSHOOT = 10.0
"""Compression that no chain at rest reaches, over the largest relative displacement that drives it.

Chains of 2 to 21 beads without damping, pressed or pushed from both ends, stay below 3.5 for α of 1
to 1.5.
"""


class Boundary(Part):
    """What happens at the ends of the chain, a drive at its left end or a wall."""

    held: ClassVar[tuple[str, ...]] = ()
    """Ends at which a relative displacement is held."""

    free_contacts: ClassVar[int] = -1
    """How many more contacts move than beads: a ring and a wall close the chain."""

    @property
    def left_end(self) -> float:
        """Relative displacement held at the left end, 0 where none is."""
        return getattr(self, "left", 0.0)

    @property
    def right_end(self) -> float:
        """Relative displacement held at the right end, 0 where none is."""
        return getattr(self, "right", 0.0)

    @property
    def force_in_time(self) -> FunctionOfTime | None:
        """What pushes bead 1, if anything does."""
        return getattr(self, "force", None)

    def pieces(self) -> list[Piece]:
        """Return the pieces of the drive, none if the left end is held."""
        return self.force_in_time.pieces() if self.force_in_time else []

    @property
    def largest(self) -> float:
        """A bound of the size of the drive; a piece of a slope ends where the next begins."""
        return max((abs(p.constant) + abs(p.amplitude) for p in self.pieces()), default=0.0)

    @property
    def at_start(self) -> float:
        """Value of the drive at t = 0, 0 without one."""
        first = (self.pieces() or [Piece(0.0, 0.0)])[0]
        return first.constant + first.amplitude * math.sin(first.phase)


class Pressure(Boundary):
    """Holds the outer u_0 and u_N, equation (25)."""

    held = ("left", "right")
    kind: Literal["pressure"]
    left: float = Field(
        description="Relative displacement δ held at the left end, x_0 − x_1.  Range δ ≥ 0 (0 is a "
        "free end), or any for a law that pulls."
    )
    right: float = Field(
        description="Relative displacement δ̃ held at the right end, x_N − x_N+1; as left."
    )


class Periodic(Boundary):
    """Joins the ends, equation (26)."""

    free_contacts = 0
    kind: Literal["ring"]


RIGHT_END = "Relative displacement δ̃ held at the right end, x_N − x_N+1; 0, a free end, by default."


class Piston(Boundary):
    """Moves bead 1."""

    held = ("right",)
    kind: Literal["piston"]
    velocity: Drive = Field(
        description="Velocity V of bead 1, which is the piston, or a function of time; at V = 0 it "
        "is a wall at the left end.  A number has the range V ≥ 0, since one that retreats leaves "
        "contacts behind, or any for a law that pulls."
    )
    ramp: NotNegative = Field(
        0.0,
        description="Time over which the velocity rises linearly from 0 to the number V; V from "
        "the start by default.",
    )
    right: float = Field(0.0, description=RIGHT_END)

    def problems(self) -> Iterator[str]:
        """A ramp belongs to a number, and no velocity jumps."""
        if "ramp" in self.model_fields_set and self.velocity.constant is None:
            yield "ramp is given, but velocity is a function of time: leave ramp out."
        if self.velocity.pulse:
            yield (
                "velocity.pulse jumps, which takes an infinite force: give half_sine, or a table "
                "in which the velocity falls over some time."
            )

    def pieces(self) -> list[Piece]:
        """Return the pieces of the velocity."""
        return self.velocity.pieces(self.ramp)


class Force(Boundary):
    """Pushes bead 1."""

    held = ("right",)
    kind: Literal["force"]
    force: Drive = Field(
        description="External force on bead 1, a number or a function of time; below 0 it pulls "
        "bead 1 away."
    )
    right: float = Field(0.0, description=RIGHT_END)


class WallBehind(Boundary):
    """Holds u_0, or pushes bead 1, and stops bead N at x = 0."""

    held = ("left",)
    free_contacts = 0
    kind: Literal["wall"]
    material: Wall | None = Field(
        None,
        description="Material of the wall, for example steel, where the beads have materials; with "
        "a diameter it is a ball that is held.",
    )
    left: float = Field(
        0.0,
        description="Relative displacement δ held at the left end, x_0 − x_1; 0, a free end, by "
        "default.",
    )
    force: Drive | None = Field(
        None,
        description="External force on bead 1 in place of a held end, a number or a function of "
        "time.",
    )

    def problems(self) -> Iterator[str]:
        """One thing presses the left end."""
        if {"left", "force"} <= self.model_fields_set:
            yield " has left and force, but one of them presses the left end: leave one out."


class Rest(Part):
    """Contacts just touch and only a piston moves."""

    kind: Literal["rest"]


class Equilibrium(Part):
    """Each contact bears what lies behind it.  Without a wall that is what the right end exerts."""

    kind: Literal["equilibrium"]


class Striker(Part):
    """Equilibrium with the first beads moving."""

    kind: Literal["striker"]
    beads: Place = Field(description="Number k of beads that move: below N, or to N before a wall.")
    velocity: float = Field(description="Velocity of these beads, not 0.")

    def problems(self) -> Iterator[str]:
        """A striker moves."""
        if self.velocity == 0.0:
            yield "velocity is 0, but a striker moves: give another velocity."


class Given(Part):
    """All values, one by one."""

    kind: Literal["given"]
    relative_displacement: Several[float] = Field(
        description="Relative displacements u_n = x_n − x_n+1, compression positive.  Between two "
        "held ends n = 1 … N − 1, on a ring n = 1 … N."
    )
    velocity: Several[float] = Field(description="Velocities of the beads, n = 1 … N.")


class Tolerance(Part):
    """Accuracy asked of the solver, per step."""

    relative: Annotated[float, Field(gt=0, le=0.1)] = Field(
        description="Error per step relative to the solution, 1e-15 or more by double precision."
    )
    absolute: Positive = Field(
        description="Error allowed per step where the solution is small: 1e-20 to 0.1 of the "
        "largest relative displacement that drives the motion."
    )

    def problems(self) -> Iterator[str]:
        """No solver in double precision honours less."""
        if self.relative < RELATIVE_TOLERANCE_FLOOR:
            yield (
                f"relative is {self.relative}, under the solver's floor of "
                f"{RELATIVE_TOLERANCE_FLOOR}, which double precision sets: ask for the floor or "
                "more."
            )


class Probe(Times):
    """One time series of the relative displacement and the velocity of a few beads."""

    beads: Listed[Place] = Field(description="Numbers n of the beads, 1 to N.")


class Sensor(Times):
    """One time series of the forces at a few contacts, inside a few beads, or both."""

    contacts: Listed[Place] | None = Field(
        None,
        description="Numbers n of the contacts between the beads n and n + 1: 1 to N − 1, or to N "
        "on a ring and before a wall.",
    )
    beads: Listed[Place] | None = Field(
        None,
        description="Numbers n of the beads inside which the mean force of both sides is taken.",
    )

    def problems(self) -> Iterator[str]:
        """A sensor is somewhere."""
        yield from super().problems()
        if not (self.contacts or self.beads):
            yield " has neither contacts nor beads: say where it is."


class Grid(Part):
    """Space–time grid of all beads over 0 ≤ t ≤ end_time."""

    step: Positive = Field(description="Time between two rows of the grid, at most end_time.")


class Record(Part):
    """What is kept of the motion; nothing else is stored."""

    snapshots: Distinct[NotNegative] = Field(
        description="Times t at which the whole chain is kept, up to end_time; may be empty."
    )
    probes: dict[Name, Probe] = Field(
        {},
        description="Time series of a few beads, each under a name of its own.",
        json_schema_extra={"additionalProperties": False},
    )
    sensors: dict[Name, Sensor] = Field(
        {},
        description="Time series of forces as an experiment records them, with momentum and energy "
        "that pass, each under a name of its own.",
        json_schema_extra={"additionalProperties": False},
    )
    grid: Grid | None = None
    arrival_level: float | None = Field(
        None,
        description="Relative displacement u at which a front has arrived at a bead, above 0, or "
        "any for a law that pulls; half of δ for a front of height δ.  At a level below the error "
        "of u, five or fewer times of arrival have errors up to 2000 times too wide.",
    )
    extremes: bool = Field(
        False,
        description="Whether largest force, first gap and smallest u are located.  A contact opens "
        "where u returns to 0, although the force of a damped one pulls shortly before.",
    )
    balances: bool = Field(
        False, description="Whether the energy balance is integrated with the motion."
    )

    def series(self) -> dict[str, Times]:
        """Return every probe and sensor by its key."""
        probes = {f"probes.{name}": probe for name, probe in self.probes.items()}
        return probes | {f"sensors.{name}": sensor for name, sensor in self.sensors.items()}

    def problems(self) -> Iterator[str]:
        """Every name is that of one series."""
        named = {"grid": "of the record of the space–time grid"}
        for key in self.series():
            name = key.rpartition(".")[2]
            if name in named:
                yield f"{key} has the name {named[name]}: give it another name."
            named[name] = f"of record.{key}"

    def late(self, end_time: float) -> Iterator[str]:
        """Say what is recorded after the motion."""
        times = {f"{key}.stop": one.stop for key, one in self.series().items()}
        times |= {name_entry("snapshots", i): t for i, t in enumerate(self.snapshots)}
        times |= {"grid.step": self.grid.step} if self.grid else {}
        for key, time in times.items():
            if time > end_time:
                yield late_sentence(f"record.{key}", time, end_time)


def late_sentence(key: str, time: float, end_time: float) -> str:
    """Say that something is recorded after the motion."""
    return (
        f"{key} is {say(time)}, beyond the end of the motion at end_time {say(end_time)}: give "
        f"{say(end_time)} or less, or raise end_time."
    )


class Chain(Scene):
    """One motion of the chain, equations (31) and (32), and what is recorded of it.

    Its arguments are the keys of a scene in the configuration; the page of the manual on these has
    the range of each.  An InputError says all that is wrong.

    Examples
    --------
    >>> scene = gf.Chain(
    ...     law={"alpha": 1.5, "beta": 1.5, "gamma": 0.06},
    ...     beads=20,
    ...     boundary={"kind": "pressure", "left": 0.1, "right": 0.0},
    ...     start={"kind": "rest"},
    ...     end_time=20.0,
    ...     tolerance={"relative": 1e-10, "absolute": 1e-12},
    ...     record={"snapshots": [20.0]},
    ... )
    >>> scene.boundary
    Pressure(kind='pressure', left=0.1, right=0.0)
    """

    law: AnyLaw = Field(
        description="Law of the contacts.  With alpha, beta and gamma it is that of equations (24) "
        "and (28); with elastic and viscous it has two potentials, equation (5)."
    )
    beads: CountOrBeads = Field(
        description="Number N of beads of mass 1, or their count with masses or materials; a "
        "single one before a wall."
    )
    contacts: Contacts = Contacts()
    gravity: float = Field(0.0, description="Body force over mass, towards the right end.")
    boundary: Annotated[
        Pressure | Periodic | Piston | WallBehind | Force, Field(discriminator="kind")
    ] = Field(description="What happens at the ends of the chain: a drive, a wall.")
    start: Annotated[Rest | Equilibrium | Striker | Given, Field(discriminator="kind")] = Field(
        description="State of the chain at t = 0."
    )
    end_time: Positive = Field(description="Time t at which the motion ends; it begins at t = 0.")
    tolerance: Tolerance
    record: Record

    @property
    def contact_count(self) -> int:
        """Number of contacts that move: N − 1, or N on a ring and before a wall."""
        return self.beads.count + self.boundary.free_contacts

    @property
    def elastic(self) -> Pattern:
        """Pattern of the factors of the elastic forces."""
        if not self.beads.spheres:
            return self.contacts.elastic
        return self.beads.stiffness(self.contact_count, getattr(self.boundary, "material", None))

    @functools.cached_property
    def size(self) -> float:
        """Size of the largest relative displacement that drives the motion."""
        boundary, start = self.boundary, self.start
        displacements, velocities = [boundary.left_end, boundary.right_end], [0.0]
        if isinstance(start, Given):
            displacements += start.relative_displacement
            velocities += start.velocity
        elif isinstance(start, Striker):
            velocities.append(start.velocity)
        load = 0.0
        if isinstance(boundary, Piston):
            velocities.append(boundary.largest)
        else:
            load = boundary.largest
        # A body force on N beads is the force of a compression, as a velocity is.
        weight = math.sqrt(abs(self.gravity) * self.beads.count)
        return max(
            *map(decades, displacements),
            decades_of_load(self.law, load),
            decades_of_impact(self.law, max(map(abs, velocities))),
            decades_of_impact(self.law, weight),
        )

    def held(self) -> Iterator[Held]:
        """Numbers that the motion holds at once, at least."""
        beads, record, end = float(self.beads.count), self.record, self.end_time
        count = {"beads" if self.beads.are_equal else "beads.count": self.beads.count}
        numbers = (NUMBERS_PER_BEAD + COLUMNS_PER_ROW * len(record.snapshots)) * beads
        yield Held(count, numbers)
        if record.grid:
            step = record.grid.step
            asked = {**count, "end_time": end, "record.grid.step": step}
            yield Held(asked, COLUMNS_PER_ROW * end / step * beads)
        for key, one in record.series().items():
            # A sensor needs the whole chain, since momentum and energy of all beads beyond count.
            columns = len(one.beads) if isinstance(one, Probe) else beads
            asked = {f"record.{key}.stop": one.stop, f"record.{key}.step": one.step}
            yield Held(asked, COLUMNS_PER_ROW * one.points * columns)

    def problems(self) -> Iterator[str]:
        """What ties parts together, in levels: each relies on those before."""
        for level in (
            self._contacts_move,
            lambda: energy_problems(self.law, self.size),
            lambda: memory_problems(self.held()),
            self._relations,
        ):
            found = [*level()]
            if found:
                yield from found
                return

    def _contacts_move(self) -> Iterator[str]:
        """A single bead touches a wall."""
        if self.beads.count == 1 and not isinstance(self.boundary, WallBehind):
            key = "beads" if self.beads.are_equal else "beads.count"
            yield (
                f"{key} is 1, but boundary.kind is {self.boundary.kind}, where a single bead "
                "touches nothing: take a wall, or 2 or more beads."
            )

    def _relations(self) -> Iterator[str]:
        yield from tolerance_problems(self.tolerance.absolute, self.size)
        yield from self._start_fits()
        yield from self._ends_are_pressed()
        yield from self._strains_lie_in_domain()
        yield from self._patterns_fit()
        yield from self._ends_bear_the_start()
        yield from self._softening_start_is_compressed()
        yield from self._series_are_on_chain()
        yield from self._arrival_level_can_be_met()
        yield from self.record.late(self.end_time)

    def _start_fits(self) -> Iterator[str]:
        """A ring has a given start, which lists every bead; a striker has beads to hit."""
        boundary, start, beads = self.boundary, self.start, self.beads.count
        if isinstance(boundary, Periodic) and not isinstance(start, Given):
            yield (
                f"start.kind is {start.kind}, but nothing sets a ring in motion: use kind given, "
                "with relative_displacement and velocity."
            )
        # Before a wall all of them hit.
        most = beads if isinstance(boundary, WallBehind) else beads - 1
        if isinstance(start, Striker) and start.beads > most:
            yield (
                f"start.beads is {start.beads}, but at most {most} can move at the start: give "
                f"{most} or fewer."
            )
        if not isinstance(start, Given):
            return
        expected = {"relative_displacement": self.contact_count, "velocity": beads}
        for key, number in expected.items():
            found = len(getattr(start, key))
            if found != number:
                yield (
                    f"start.{key} has {found} numbers, but {beads} beads with boundary "
                    f"{boundary.kind} need {number}: give one for each."
                )
        begins = boundary.at_start
        if isinstance(boundary, Piston) and start.velocity and start.velocity[0] != begins:
            yield (
                f"start.velocity begins with {say(start.velocity[0])}, but bead 1 is a piston that "
                f"begins at the velocity {begins:.17g}: give {begins:.17g} first."
            )

    def _ends_are_pressed(self) -> Iterator[str]:
        """No end or piston pulls, and no level of arrival is stretched, where contacts open."""
        if exponent_of(self.law) is None:
            return
        for end in self.boundary.held:
            if (u := getattr(self.boundary, end)) < 0:
                yield f"boundary.{end} is {say(u)}, below its limit 0: give 0 or more."
        # A function of time may retreat for a while.
        velocity = getattr(self.boundary, "velocity", FunctionOfTime()).constant or 0.0
        if velocity < 0:
            yield (
                f"boundary.velocity is {say(velocity)}, below its limit 0: give 0, a wall, or a "
                "number above 0."
            )
        if (level := self.record.arrival_level) is not None and level <= 0:
            yield (
                f"record.arrival_level is {say(level)}, but must be above 0: give a number above 0."
            )

    def _strains_lie_in_domain(self) -> Iterator[str]:
        """The law holds for the contacts at the ends that are held, and at the start."""
        low, high = self.law.domain
        ends = sorted(self.boundary.held)
        found = {f"boundary.{end}": getattr(self.boundary, end) for end in ends}
        if isinstance(self.start, Rest):
            found["start.relative_displacement of a chain at rest"] = 0.0
        if isinstance(self.start, Given):
            key = "start.relative_displacement"
            found |= {name_entry(key, i): u for i, u in enumerate(self.start.relative_displacement)}
        for key, u in found.items():
            if not low < -u < high:
                yield (
                    f"{key} is {say(u)}, but the law holds for relative displacements between "
                    f"{-high:g} and {-low:g} only: give one between, or another law."
                )

    def _patterns_fit(self) -> Iterator[str]:
        """Every pattern fits its chain, and materials are given for all bodies or none."""
        errors = [*self._material_problems()]
        if errors:
            yield from errors
            return
        key = "beads" if self.beads.spheres else "beads.mass"
        patterns = {key: (self.beads.masses(), self.beads.count)}
        patterns["contacts.elastic"] = self.elastic, self.contact_count
        if self.contacts.viscous:
            patterns["contacts.viscous"] = self.contacts.viscous, self.contact_count
        for key, (pattern, count) in patterns.items():
            for sentence in pattern.problems_along(count, isinstance(self.boundary, Periodic)):
                yield f"{key}{sentence}" if sentence[0] == " " else f"{key}.{sentence}"

    def _material_problems(self) -> Iterator[str]:
        """Say what is wrong with beads and walls of materials; those touch by Hertz's law."""
        boundary, wall = self.boundary, getattr(self.boundary, "material", None)
        if not self.beads.spheres:
            if wall:
                yield (
                    f"boundary.material is {wall}, but the beads have no material: name theirs in "
                    "beads.cell, as in steel 9.5 mm."
                )
            return
        if "elastic" in self.contacts.model_fields_set:
            yield (
                "beads names materials, which set masses and stiffness, but contacts.elastic is "
                "given too: leave one of them out."
            )
        if isinstance(boundary, WallBehind) and not wall:
            yield "boundary.material is missing: name the material of the wall, as in steel."
        if (alpha := exponent_of(self.law)) != 1.5:
            found = "law has another potential" if alpha is None else f"law has alpha {say(alpha)}"
            yield (
                f"beads names materials, which touch by Hertz's law, but {found}: give alpha 1.5, "
                "or masses."
            )

    def _ends_bear_the_start(self) -> Iterator[str]:
        """A chain in equilibrium is held by what bears its weight; gravity needs such an end."""
        boundary, start, gravity = self.boundary, self.start, self.gravity
        left, right = boundary.left_end, boundary.right_end
        if gravity and isinstance(boundary, Periodic | Piston):
            yield (
                f"gravity is {say(gravity)}, but boundary.kind is {boundary.kind}: take pressure "
                "at both ends, a force or a wall."
            )
        if not isinstance(start, Equilibrium | Striker):
            return
        is_struck = isinstance(start, Striker)
        if isinstance(boundary, Periodic) or (isinstance(boundary, Piston) and is_struck):
            yield f"start.kind is {start.kind}, but boundary.kind is {boundary.kind}: take a wall."
        elif isinstance(boundary, Force | Piston) and gravity:
            yield (
                f"start.kind is {start.kind}, but gravity is {say(gravity)} and boundary.kind "
                f"{boundary.kind}, which do not balance: take a wall."
            )
        elif isinstance(boundary, Pressure) and (gravity or left != right):
            yield (
                f"start.kind is {start.kind}, but boundary.left is {say(left)}, boundary.right "
                f"{say(right)} and gravity {say(gravity)}, which do not balance: take a wall, or "
                "equal ends without gravity."
            )
        elif left < 0.0:
            yield (
                f"start.kind is {start.kind}, but boundary.left is {say(left)}, which pulls: give "
                "0 or more."
            )
        elif gravity < 0.0:
            yield (
                f"gravity is {say(gravity)}, away from the wall that bears the chain: give 0 or "
                "more."
            )

    def _softening_start_is_compressed(self) -> Iterator[str]:
        """With α < 1 no contact just touches: its stiffness αu^(α − 1) would be infinite."""
        alpha, boundary, start, smallest = exponent_of(self.law), self.boundary, self.start, 0.0
        if isinstance(start, Equilibrium | Striker):
            # The first contact bears the least.
            pressed = boundary.left_end or boundary.right_end
            if isinstance(boundary, WallBehind) and boundary.force:
                pressed = boundary.at_start
            smallest = pressed + max(self.gravity, 0.0)
        elif isinstance(start, Given):
            smallest = min(start.relative_displacement, default=math.inf)
        if alpha is not None and alpha < 1 and smallest <= 0:
            yield (
                f"law has alpha {say(alpha)}, below 1, where contacts are infinitely stiff at the "
                f"smallest relative displacement, {say(smallest)}: take alpha of 1 or more, or "
                "compress all."
            )

    def _series_are_on_chain(self) -> Iterator[str]:
        """Every probe and sensor is on the chain."""
        limits = {"beads": self.beads.count, "contacts": self.contact_count}
        for key, one in self.record.series().items():
            for places, most in limits.items():
                for number in getattr(one, places, None) or ():
                    if number > most:
                        yield (
                            f"record.{key}.{places} names {places[:-1]} {number}, but the chain "
                            f"has {most} {places}: choose one of 1 to {most}."
                        )

    def _arrival_level_can_be_met(self) -> Iterator[str]:
        """A chain of equal beads at rest comes to the level at which a front has arrived."""
        level, size = self.record.arrival_level or 0.0, self.size
        are_alike = self.beads.are_equal and not self.contacts.model_fields_set
        if not (isinstance(self.start, Rest) and are_alike and math.isfinite(size)):
            return
        if decades(level) > size + math.log10(LARGEST_OVERSHOOT):
            driving = 10.0**size
            yield (
                f"record.arrival_level is {say(level)}, but relative displacements stay below "
                f"{LARGEST_OVERSHOOT * driving:.3g} where about {driving:.3g} drives them: give "
                f"{0.5 * driving:.3g}, half of a front."
            )
