"""Scenes of the family ``periodic``: a ring and its amplitude equations, section 4.3."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from granular_fronts.model.amplitude_scaling import SlowScales
from granular_fronts.model.laws import make_law
from granular_fronts.scenes.chain import Grid, Tolerance, late_sentence
from granular_fronts.scenes.laws import (
    LawOfOneExponent,
    decades,
    energy_problems,
    tolerance_problems,
)
from granular_fronts.scenes.memory import COLUMNS_PER_ROW, NUMBERS_PER_BEAD, Held, memory_problems
from granular_fronts.scenes.parts import (
    Listed,
    NotNegative,
    Part,
    Positive,
    Several,
    Whole,
    name_entry,
    say,
)
from granular_fronts.scenes.sentences import Scene

EQUATION_TOLERANCE_FLOOR = 1.0e-13
"""Smallest error per step that the rounding of a rescaled variable of order 1 lets through."""

CELLS_PER_EDGE = 2
"""Fewest cells over a unit of ξ, the width of the falling edge of eq. (49)."""


class PlateauStart(Part):
    """The start of equation (49)."""

    kind: Literal["plateau"]
    half_width: NotNegative = Field(
        description="Half-width of the plateau y = 1 in ξ, 10 in equation (49)."
    )
    floor: Annotated[float, Field(ge=0, le=1)] = Field(
        description="Value η of y far from the plateau, equation (49)."
    )


class GivenForce(Part):
    """Values of the rescaled force, one by one."""

    kind: Literal["given"]
    rescaled_force: Annotated[Several[float], Field(min_length=3)] = Field(
        description="Values of y at equally spaced points from ξ = −ℓ to ξ = ℓ, both ends "
        "included.  They are at least 0, the same at both ends."
    )

    def problems(self) -> Iterator[str]:
        """No contact pulls, and both ends are one point of the ring."""
        first, *_, last = self.rescaled_force
        if (smallest := min(self.rescaled_force)) < 0:
            yield (
                f"rescaled_force has {say(smallest)} as its smallest value, but a contact cannot "
                "pull: give values of 0 or more."
            )
        if first != last:
            yield (
                f"rescaled_force begins with {say(first)} and ends with {say(last)}, but on a ring "
                "both ends are one point: give a periodic start."
            )


RingStart = Annotated[PlateauStart | GivenForce, Field(discriminator="kind")]


class Resolution(Part):
    """Cells and tolerance of one equation."""

    cells: Annotated[Whole, Field(ge=8)] = Field(
        description="Number of cells over one turn of the ring, two or more for each unit of ξ."
    )
    tolerance: Annotated[float, Field(gt=0, le=0.1)] = Field(
        description="Error allowed per step in the rescaled variable, whose largest value is 1."
    )

    def problems(self) -> Iterator[str]:
        """No error per step drowns in rounding."""
        if self.tolerance < EQUATION_TOLERANCE_FLOOR:
            yield (
                f"tolerance is {self.tolerance}, under the solver's floor of "
                f"{EQUATION_TOLERANCE_FLOOR}: ask for the floor or more."
            )


class Upwind(Part):
    """The explicit upwind scheme of section 4.3, with its own step."""

    points: Annotated[Whole, Field(ge=8)] = Field(
        description="Number of points over one turn of the ring, 10⁴ in section 4.3."
    )


class Equations(Part):
    """Grid and accuracy of the amplitude equations that are named; one or more."""

    logarithmic: Resolution | None = Field(
        None, description="The logarithmic Burgers equation (41), solved as (50)."
    )
    unlimited: Resolution | None = Field(
        None, description="The equation (40) before the limit α → 1."
    )
    dispersive: Resolution | None = Field(
        None,
        description="The logarithmic KdV–Burgers equation (55), in the variables and the frame of "
        "(50), for granular_fronts.evolve_log_kdv_burgers; no rule solves it.",
    )
    upwind: Upwind | None = Field(
        None,
        description="The equation (50) by the explicit upwind scheme of section 4.3, next to "
        "logarithmic.",
    )

    def grids(self) -> dict[str, int]:
        """Return cells or points of the equations that are named, by their keys."""
        named = {name: one for name, one in self if one is not None}
        return {
            f"{name}.{key}": getattr(one, key)
            for name, one in named.items()
            for key in ("cells", "points")
            if key in type(one).model_fields
        }

    def problems(self) -> Iterator[str]:
        """The error of the paper's scheme is its distance from the finite volumes."""
        if not self.grids():
            yield " is empty: give at least one entry."
        if self.upwind and not self.logarithmic:
            yield (
                "logarithmic is missing, but equations.upwind is measured against it: give its "
                "cells and tolerance."
            )


class RingRecord(Part):
    """What is kept of the motion; nothing else is stored."""

    snapshots: Listed[NotNegative] = Field(
        description="Times t, up to end_time, at which chain and equations are kept whole."
    )
    grid: Grid = Field(
        description="Times over 0 ≤ t ≤ end_time at which chain and equations are compared."
    )


class Ring(Scene):
    """One wave on a ring of 2p − 1 beads, section 4.3, as a chain (26) and by equations.

    Its arguments are the keys of a scene in the configuration; the page of the manual on these has
    the range of each.  An InputError says all that is wrong.

    Examples
    --------
    >>> ring = gf.Ring(
    ...     law={"alpha": 1.1, "gamma": 0.24},
    ...     displacement=5.0,
    ...     half_beads=40,
    ...     start={"kind": "plateau", "half_width": 5.0, "floor": 0.1},
    ...     end_time=5.0,
    ...     tolerance={"relative": 1e-8, "absolute": 1e-10},
    ...     equations={"logarithmic": {"cells": 64, "tolerance": 1e-5}},
    ...     record={"snapshots": [5.0], "grid": {"step": 5.0}},
    ... )
    >>> round(ring.half_length, 3)
    13.805
    """

    law: LawOfOneExponent
    displacement: Positive = Field(
        description="Relative displacement δ at which the rescaled force y is 1."
    )
    half_beads: Annotated[Whole, Field(ge=2)] = Field(
        description="The p of the paper; the ring has N = 2p − 1 beads."
    )
    start: RingStart = Field(
        description="Rescaled force y at t = 0 over one turn of the ring, −ℓ ≤ ξ ≤ ℓ with "
        "ℓ = (p − 1/2) ε."
    )
    end_time: Positive = Field(
        description="Time t of the chain at which the motion ends; it begins at t = 0."
    )
    tolerance: Tolerance = Field(description="Accuracy asked of the chain's solver, per step.")
    equations: Equations
    record: RingRecord

    @property
    def beads(self) -> int:
        """Number N of beads."""
        return 2 * self.half_beads - 1

    @property
    def scaling(self) -> SlowScales:
        """Scales of section 4."""
        return SlowScales(self.law.alpha, self.law.gamma, self.displacement)

    @property
    def half_length(self) -> float:
        """Half of the ring, ℓ in ξ."""
        return self.scaling.half_length(self.half_beads)

    def held(self) -> Iterator[Held]:
        """Numbers that the chain and two equations hold at once, at least."""
        beads, columns, end = float(self.beads), 3 * COLUMNS_PER_ROW, self.end_time
        numbers = (NUMBERS_PER_BEAD + columns * len(self.record.snapshots)) * beads
        yield Held({"half_beads": self.half_beads}, numbers)
        step = self.record.grid.step
        asked = {"half_beads": self.half_beads, "end_time": end, "record.grid.step": step}
        yield Held(asked, columns * end / step * beads)
        for key, number in self.equations.grids().items():
            yield Held({f"equations.{key}": number}, NUMBERS_PER_BEAD * float(number))

    def problems(self) -> Iterator[str]:
        """What ties parts together, in levels: each relies on those before."""
        law = make_law(alpha=self.law.alpha, gamma=self.law.gamma)
        size = decades(self.displacement)
        found = [*energy_problems(law, size)] or [*memory_problems(self.held())]
        if found:
            yield from found
            return
        yield from tolerance_problems(self.tolerance.absolute, size)
        yield from self._wave_fits_ring()
        yield from self._record_ends_with_motion()

    def _wave_fits_ring(self) -> Iterator[str]:
        """A start (49) falls to its floor on the ring, and cells are no wider than its edge."""
        half_length = self.half_length
        if isinstance(self.start, PlateauStart) and self.start.half_width + 1.0 > half_length:
            yield (
                f"start.half_width is {say(self.start.half_width)}, and with its edge of width 1 "
                f"the plateau exceeds half the ring, ℓ = (p − 1/2) ε = {half_length:.6g}: lower it "
                "or raise half_beads."
            )
        needed = math.ceil(CELLS_PER_EDGE * 2.0 * half_length)
        for key, found in self.equations.grids().items():
            if found < needed:
                yield (
                    f"equations.{key} is {found}, too coarse to hold the edge of the wave, of "
                    f"width 1 on a ring of length 2ℓ = {2.0 * half_length:.6g}: give {needed} or "
                    "more."
                )

    def _record_ends_with_motion(self) -> Iterator[str]:
        """Nothing is recorded after the motion."""
        times = {name_entry("snapshots", i): t for i, t in enumerate(self.record.snapshots)}
        for key, time in (times | {"grid.step": self.record.grid.step}).items():
            if time > self.end_time:
                yield late_sentence(f"record.{key}", time, self.end_time)
