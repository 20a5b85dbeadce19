"""The sections ``exact_fronts`` and ``laws``: what each study is computed for."""

import math
from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from granular_fronts.errors import InputError
from granular_fronts.model.materials import material_of
from granular_fronts.scenes.laws import AnyPotential, law_of_parts
from granular_fronts.scenes.parts import (
    Interval,
    Listed,
    Named,
    Pair,
    Part,
    Positive,
    name_entry,
    say,
)

DENSITIES = 1.0, 30_000.0
"""Densities of solid beads in kg/m³, from foams to beyond osmium (22 590)."""

BEADS_PER_TIME = 1.15
"""Beads that a wave from the compression 1 runs through in a unit of time, with a margin."""

FORMING_TIME = 16.0
"""End of the shortest motion, over 1 + γ, in which a pressed wave passes its own width.

Of α = 1 the width from 90 to 10 per cent grows like 2.56 (γt)^(1/2); it is seen at a quarter too.
"""

THETA_END_ERROR = 1.0e-9
"""Rounding of end_time over a step of the θ-method, relative to end_time."""

Exponent = Annotated[float, Field(gt=1)]
ViscousExponent = Annotated[float, Field(ge=1)]
Count = Annotated[int, Field(ge=2, le=10_000)]
Theta = Annotated[float, Field(gt=0.5, le=1)]
ThetaStep = Annotated[float, Field(ge=1e-6)]

ALPHA = "Exponent α of the elastic force."
BETAS = "Exponents β of the viscous force."
GAMMA = "Strength γ of the viscous force."
NORMALISED_GAMMA = "Strength γc of the viscous force for δ = c = 1, equation (30)."


class Dampings(Interval):
    """Dampings at equal ratios."""

    start: Positive = Field(description=NORMALISED_GAMMA)
    stop: Positive = Field(description=NORMALISED_GAMMA)
    num: Count = Field(description="How many values there are.")


class Exponents(Interval):
    """Exponents α of both forces, at equal distances."""

    start: Exponent = Field(description="Exponent α.")
    stop: Exponent = Field(description="Exponent α.")
    num: Count = Field(description="How many values there are.")


class Survey(Part):
    """Fronts whose properties are tabulated and compared with the continuum fronts."""

    alpha: Listed[Exponent] = Field(description="Exponents α of both forces.")
    gamma: Dampings


class CriticalDamping(Part):
    """The plane of exponent and damping, with critical damping in its several meanings."""

    alpha: Exponents
    gamma: Dampings
    overshoot_cut: Annotated[float, Field(gt=0, le=0.1)] = Field(
        description="Overshoot max u/δ − 1 from which on it counts as visible."
    )
    levels: Listed[Annotated[float, Field(gt=0, le=10)]] = Field(
        description="Overshoots whose level curves are solved, growing from above overshoot_cut."
    )


class OneFront(Part):
    """One front with β = α."""

    alpha: Exponent = Field(description="Exponent α.")
    gamma: Positive = Field(description=NORMALISED_GAMMA)


class Multipliers(Part):
    """Fronts whose stability is computed."""

    fronts: Named[OneFront] = Field(description="The fronts, each under a name of its own.")
    beads_behind: Listed[Annotated[int, Field(ge=10, le=2000)]] = Field(
        description="Numbers of compressed beads behind the front that are kept, one spectrum for "
        "each."
    )


class Trends(Part):
    """How fronts change with velocity, pressure and exponent, sections 1 and 3.3."""

    alpha: Exponent = Field(description=ALPHA)
    betas: Listed[ViscousExponent] = Field(description=BETAS)
    piston_velocities: Listed[Positive] = Field(
        min_length=2, description="Velocities v_p behind a front over the critical one."
    )
    displacements: Listed[Positive] = Field(
        min_length=2, description="Compressions δ behind a front."
    )
    gamma: Positive = Field(description=GAMMA)
    exponents: Listed[Exponent] = Field(
        min_length=3, description="Exponents α of both forces, towards 1."
    )
    mu: Positive = Field(description="Damping parameter μ (54) of the fronts followed to α = 1.")


class ExactFronts(Part):
    """Many exact fronts with β = α in the frame δ = c = 1, section 6."""

    survey: Survey
    critical_damping: CriticalDamping
    multipliers: Multipliers
    trends: Trends


class SphericalBead(Part):
    """A spherical bead."""

    gamma: Annotated[float, Field(gt=0, lt=0.438)] = Field(
        description="Damping γ that remark 6 prints; at 0.438 no bead would rebound."
    )
    mass: Annotated[float, Field(gt=0, le=1e15)] = Field(
        description="Mass m in kilograms (SI), a handbook value but for cork, whose mass remark 6 "
        "prints."
    )
    radius: Annotated[float, Field(ge=1e-9, le=1000)] = Field(
        description="Radius R in metres (SI), which remark 6 prints."
    )

    def problems(self) -> Iterator[str]:
        """Mass and radius belong to a solid, in SI units."""
        density = 0.75 * self.mass / math.pi / self.radius**3
        lightest, heaviest = DENSITIES
        if not lightest <= density <= heaviest:
            yield (
                f"radius is {say(self.radius)} and its mass {say(self.mass)}, a density of "
                f"{density:.2g} kg/m³, outside {lightest:g} to {heaviest:g} of solids: give metres "
                "and kilograms."
            )


class Materials(Part):
    """Real beads and the fronts they carry, remark 6; SI units."""

    impact_velocity: Positive = Field(
        description="Relative velocity v_0 of the impact for which γ is printed, in m/s (SI)."
    )
    beads: Named[SphericalBead] = Field(
        description="Beads; the key names the material, in the table of "
        "`granular_fronts.model.materials`."
    )
    piston_velocities: Listed[Positive] = Field(
        description="Velocities v_p of the beads behind a front, in m/s (SI)."
    )
    forces: Listed[Positive] = Field(description="Forces that press a chain, in newtons (SI).")

    def problems(self) -> Iterator[str]:
        """Every material is known."""
        for name in self.beads:
            try:
                material_of(name)
            except InputError as error:
                yield f"beads.{name}: {error}"


class DampingRegimes(Part):
    """Damping against velocity, equation (29), drawn in figure damping_regimes."""

    alpha: Exponent = Field(description=ALPHA)
    betas: Listed[ViscousExponent] = Field(description=BETAS)
    decades: Annotated[float, Field(gt=0, le=100)] = Field(
        description="Decades of velocity on both sides of v_c."
    )
    points: Annotated[int, Field(ge=2, le=100_000)] = Field(description="Number of velocities.")


class ThetaMotion(Part):
    """A chain that the θ-method moves."""

    beads: Annotated[int, Field(ge=3, le=10_000)] = Field(description="Number N of beads.")
    end_time: Annotated[float, Field(gt=0, le=10_000)] = Field(
        description="Time t at which the motion ends, a multiple of each step."
    )

    def step_problems(self, key: str, step: float) -> Iterator[str]:
        """The motion ends after a whole number of steps."""
        end = self.end_time
        whole = math.floor(end / step + 0.5)
        if whole < 1 or abs(whole * step - end) > THETA_END_ERROR * end:
            yield (
                f"{key} is {say(step)}, and no whole number of such steps ends at end_time "
                f"{say(end)}: give a step that divides end_time."
            )


class ThetaOrder(ThetaMotion):
    """Study of the order of the agreement."""

    thetas: Listed[Theta] = Field(description="Values of θ.")
    steps: Listed[ThetaStep] = Field(min_length=3, description="Steps h, falling; three or more.")

    def problems(self) -> Iterator[str]:
        """Every step divides the time."""
        for index, step in enumerate(self.steps):
            yield from self.step_problems(name_entry("steps", index), step)


class ThetaProfile(ThetaMotion):
    """One chain whose relative displacements are drawn."""

    theta: Theta = Field(description="Parameter θ.")
    step: ThetaStep = Field(description="Step h.")

    def problems(self) -> Iterator[str]:
        """The step divides the time."""
        yield from self.step_problems("step", self.step)


class NumericalDamping(Part):
    """The θ-method on a conservative chain, and damped chains."""

    alpha: Annotated[float, Field(ge=1)] = Field(description=ALPHA)
    displacement: Positive = Field(
        description="Relative displacement δ held at the left end from t = 0 on."
    )
    order: ThetaOrder
    profile: ThetaProfile


class ChoiceOfVariables(Part):
    """Smoothness, order and conservation in (x, ẋ) and in (x, w), section 3.2."""

    alpha: Exponent = Field(description=ALPHA)
    betas: Listed[Annotated[float, Field(ge=1, lt=2)]] = Field(description=BETAS)
    gamma: Positive = Field(description=GAMMA)


class LimitingRings(Part):
    """Rings compared with the logarithmic Burgers equation for α towards 1, section 4.1."""

    exponents: Listed[Annotated[float, Field(ge=1.02, le=3)]] = Field(
        min_length=3, description="Exponents α of both forces, towards 1."
    )
    gamma: Annotated[float, Field(gt=0, le=100)] = Field(description=GAMMA)
    half_length: Annotated[float, Field(ge=10, le=100)] = Field(
        description="Half of the ring in ξ."
    )
    half_width: Annotated[float, Field(ge=1, le=8)] = Field(
        description="Half of the plateau of the start in ξ."
    )
    slow_time: Annotated[float, Field(gt=0, le=10)] = Field(
        description="Slow time τ at which the rings end."
    )


class LimitingCases(Part):
    """No damping, no nonlinearity, softening, elastic collisions, α towards 1; sections 2 to 4."""

    alpha: Exponent = Field(description=ALPHA)
    weak_gamma: Positive = Field(description=GAMMA)
    strong_gamma: Positive = Field(description=GAMMA)
    beads: Annotated[int, Field(ge=100, le=100_000)] = Field(
        description="Number N of beads of the pressed chains."
    )
    end_time: Positive = Field(description="Time t at which the pressed chains end.")
    softening: Annotated[float, Field(gt=0, lt=1)] = Field(
        description="Exponent α of the softening force."
    )
    strains_ahead: Listed[Annotated[float, Field(gt=0, lt=1)]] = Field(
        description="Compressions ahead of its front, which tend to 0."
    )
    impact_velocities: Listed[Positive] = Field(
        min_length=2, description="Relative velocities of elastic collisions."
    )
    rings: LimitingRings

    def problems(self) -> Iterator[str]:
        """The waves of pressed chains run past their own width, and not to the last bead."""
        beads, end = self.beads, self.end_time
        if beads < BEADS_PER_TIME * end:
            yield (
                f"beads is {beads}, but waves run through about {BEADS_PER_TIME * end:.3g} beads "
                f"until end_time {end:g}: give more beads, or a smaller end_time."
            )
        name = max("weak_gamma", "strong_gamma", key=lambda name: getattr(self, name))
        gamma = getattr(self, name)
        least = FORMING_TIME * (1.0 + gamma)
        if end < least:
            yield (
                f"end_time is {say(end)}, but with {name} {gamma:g} a wave needs {least:.3g} to "
                f"run past its own width: give {least:.3g} or more, or a smaller {name}."
            )


class Lattice(Part):
    """Potentials of a lattice (5), and the states that a front joins."""

    elastic: AnyPotential = Field(
        description="Potential V of the elastic force, a kind of granular_fronts.model.kinds and "
        "its parameters."
    )
    dissipation: AnyPotential = Field(
        description="Potential W of the viscous force, a kind and its parameters; convex between "
        "the states."
    )
    states: Pair[float] = Field(
        description="Strains R₋ and R₊ at n → −∞ and n → +∞, negative in compression.  Any two "
        "that a front joins."
    )

    def problems(self) -> Iterator[str]:
        """Both potentials exist, and a front joins two different states of theirs."""
        try:
            law_of_parts(elastic=self.elastic)
        except InputError as error:
            yield f"elastic: {error}"
            return
        try:
            law = law_of_parts(elastic=self.elastic, viscous=self.dissipation)
        except InputError as error:
            yield f"dissipation: {error}"
            return
        low, high = law.domain
        behind, ahead = self.states
        for state in self.states:
            if not low < state < high:
                yield (
                    f"states has {say(state)}, but its law holds for strains between {low:g} and "
                    f"{high:g} only: give states between."
                )
        if behind == ahead:
            yield (
                f"states are {say(behind)} and {say(ahead)}, but a front joins two different "
                "states: change one."
            )
            return
        for force, potential in (("elastic", law.elastic), ("dissipation", law.viscous)):
            if potential.kind in ("hertz", "power") and min(self.states) >= 0.0:
                yield (
                    f"states are {say(behind)} and {say(ahead)}, where the {force} force of Hertz "
                    "vanishes, since no strain is below 0: give a compressed state, below 0."
                )


class JumpConditions(Part):
    """Fronts between two states, solved and driven, against equations (12) to (17)."""

    beads: Annotated[int, Field(ge=64, le=100_000)] = Field(
        description="How many beads a driven front passes."
    )
    tolerance: Annotated[float, Field(ge=1e-14, le=0.1)] = Field(
        description="Largest error per step of the driven chains, over the jump of the strain."
    )
    cases: Named[Lattice] = Field(description="Lattices; the key names one.")


class Laws(Part):
    """Contact laws at work, section 3.1."""

    materials: Materials
    damping_regimes: DampingRegimes
    numerical_damping: NumericalDamping
    choice_of_variables: ChoiceOfVariables
    limiting_cases: LimitingCases
    jump_conditions: JumpConditions
