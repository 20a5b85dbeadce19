"""Scenes of the family ``heteroclinic``: fronts of equation (56), section 5.2."""

import math
from collections.abc import Iterator

from pydantic import Field

from granular_fronts.model.amplitude_scaling import SMALLEST_DAMPING
from granular_fronts.scenes.memory import COLUMNS_PER_ROW, Held, memory_problems
from granular_fronts.scenes.parts import (
    Listed,
    NotNegative,
    Pair,
    Part,
    Positive,
    Range,
    name_entry,
    say,
    step_problems,
)
from granular_fronts.scenes.sentences import Scene

GAUSSIAN_CENTRE = -2.0 * math.sqrt(0.5 + math.log(2.0))
"""The s of the maximum of the orbit for μ = 0, y = exp(½ − (s − centre)²/4) with y(0) = ½."""

GAUSSIAN_HALF_WIDTH = 2.0 * math.sqrt(0.5 - math.log(5e-324))
"""Distance in s from that centre at which this orbit is below the smallest double."""

LATER_UNDERFLOW = 7.0
"""Bound on how much later, over μ, the other orbits underflow: ln(745/ln 2) ≈ 6.98 for large μ."""


class Profile(Range):
    """Where the fronts are kept, with y_h(0) = 1/2."""

    start: float = Field(
        description="First s, before stop, and for μ = 0 above the s of about −56.8 at which y "
        "underflows."
    )
    stop: float = Field(
        description="Last s, up to the s at which y underflows, about 52.4 for μ = 0 and later for "
        "μ > 0."
    )
    step: Positive = Field(description="Distance in s between two points.")


class Well(Part):
    """Points at which the potential W of equation (56) is kept."""

    limit: Positive = Field(description="Largest |y|.")
    step: Positive = Field(description="Distance in y between two points.")

    def problems(self) -> Iterator[str]:
        """The range holds a step."""
        yield from step_problems(self.step, self.limit, "limit")


class Portrait(Part):
    """Trajectories of the planar system (57)."""

    mu: NotNegative = Field(description="Damping μ of all trajectories.")
    starts: Listed[Pair[float]] = Field(
        description="Points (y, z) through which a trajectory is followed, forwards and backwards "
        "in s; no equilibrium."
    )
    span: Positive = Field(description="Length in s of each trajectory before and after its point.")
    step: Positive = Field(description="Distance in s between two points of a trajectory.")
    limit: Positive = Field(description="Largest |y| and |z|, where a trajectory ends.")

    def problems(self) -> Iterator[str]:
        """No trajectory stays in an equilibrium, and the span holds a step."""
        yield from step_problems(self.step, self.span, "span")
        for index, (y, z) in enumerate(self.starts):
            if z == 0 and y in (-1, 0, 1):
                yield (
                    f"{name_entry('starts', index)} is [{say(y)}, {say(z)}], an equilibrium, where "
                    "nothing moves: start elsewhere."
                )


class Orbits(Scene):
    """Fronts y_h(s) of equation (56) for a list of dampings, and what else figure 8 shows."""

    mu: Listed[NotNegative] = Field(description="Dampings μ of equation (54), each at most once.")
    profile: Profile
    well: Well | None = None
    portrait: Portrait | None = None

    def held(self) -> Iterator[Held]:
        """Numbers that orbits, well and portrait hold at once, at least."""
        profile = self.profile
        asked = {"profile.stop": profile.stop, "profile.step": profile.step}
        yield Held(asked, COLUMNS_PER_ROW * len(self.mu) * profile.points)
        if self.well:
            limit, step = self.well.limit, self.well.step
            yield Held(
                {"well.limit": limit, "well.step": step}, COLUMNS_PER_ROW * 2.0 * limit / step
            )
        if self.portrait:
            span, step = self.portrait.span, self.portrait.step
            asked = {"portrait.span": span, "portrait.step": step}
            yield Held(asked, COLUMNS_PER_ROW * 2.0 * span / step)

    def problems(self) -> Iterator[str]:
        """What ties parts together; memory first, since the rest relies on it."""
        found = [*memory_problems(self.held())]
        if found:
            yield from found
            return
        for index, mu in enumerate(self.mu):
            if mu > 0 and not SMALLEST_DAMPING <= mu <= 1.0 / SMALLEST_DAMPING:
                yield (
                    f"{name_entry('mu', index)} is {mu}, where the energy of the orbit loses its "
                    f"digits: give 0, or {SMALLEST_DAMPING} to {1.0 / SMALLEST_DAMPING:g}."
                )
        yield from self._profile_ends_before_underflow()
        if self.portrait and self.portrait.mu not in self.mu:
            shown = say(self.portrait.mu)
            yield (
                f"portrait.mu is {shown}, but the orbit shown in the portrait is one of mu "
                f"[{', '.join(map(say, self.mu))}]: choose one of these, or add {shown} to mu."
            )

    def _profile_ends_before_underflow(self) -> Iterator[str]:
        """The fronts are kept where y is a double above zero."""
        mu = min(self.mu)
        last = GAUSSIAN_CENTRE + GAUSSIAN_HALF_WIDTH + LATER_UNDERFLOW * mu
        first = GAUSSIAN_CENTRE - GAUSSIAN_HALF_WIDTH if mu == 0 else -math.inf
        start, stop = self.profile.start, self.profile.stop
        for key, value, is_beyond, limit, side in (
            ("stop", stop, stop > last, last, "before"),
            ("start", start, start < first, first, "after"),
        ):
            if is_beyond:
                yield (
                    f"profile.{key} is {say(value)}, but for mu = {say(mu)} y falls below the "
                    f"smallest double at s = {limit:.2f}: choose one {side} it."
                )
