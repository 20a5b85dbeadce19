"""The kinds of campaign: the numbers of a point, what is recorded, and which module solves it.

A kind is solved by one function ``solve_chunk(points, settings, activity)`` in its module. `points`
holds an array of shape (lines, fast) for each number of a point.  `settings` belong to a
`Campaign`, and `activity` heads the progress bar.  The result is a `points.Solved`.
"""

from collections.abc import Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field
from pydantic_core import PydanticCustomError

from granular_fronts.scenes.memory import NUMBERS_PER_BEAD, Held, memory_problems
from granular_fronts.scenes.parts import NotNegative, Part, Positive, Whole

if TYPE_CHECKING:
    from granular_fronts.campaign.points import Solved

MOST_HALF_BEADS = 1_000_000


class Kind(NamedTuple):
    """One family of problems."""

    module: str  # with `solve_chunk`
    seconds_per_point: float  # processor time of a usual point, by which a campaign is cut
    keys: tuple[str, ...]  # of a file, beside those of every kind
    point: type[Part]  # numbers of a point, none where they are inside a scene
    point_of_given: type[Part]  # the same where a file gives the law, or lists the wave
    scalars: Mapping[str, str]  # what may be recorded at each point, with its meaning
    profile: tuple[str, str]  # name and meaning of the profile that may be recorded
    profile_along: tuple[str, str]  # the same of its coordinate
    one_of: tuple[tuple[str, ...], ...] = ()  # of each group a point has exactly one number

    @property
    def profile_counts(self) -> bool:
        """Whether only whole numbers make sense along the profile."""
        return self.profile_along[0] == "bead"

    def profile_points(self, profile: Mapping[str, Any] | None) -> np.ndarray | None:
        """Return the evenly spaced points of a recorded profile, or None."""
        if profile is None:
            return None
        points = np.linspace(profile["start"], profile["stop"], profile["count"])
        return points.round().astype(int) if self.profile_counts else points

    def solve_chunk(
        self, points: Mapping[str, np.ndarray], settings: Mapping, activity: str = "solving"
    ) -> "Solved":
        """Solve the points of one chunk, in this process."""
        return import_module(self.module).solve_chunk(points, settings, activity)


def _whole(value: Any) -> Any:
    """Let a spaced axis hold whole numbers, which arrive as 30.0."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _fits_into_memory(beads: int) -> int:
    for sentence in memory_problems([Held({"{key}": beads}, NUMBERS_PER_BEAD * float(beads))]):
        raise PydanticCustomError("sentence", sentence)  # type: ignore[misc]
    return beads


Exponent = Annotated[float, Field(gt=1)]


class Powers(Part):
    """The law (28)."""

    alpha: Exponent = Field(description="exponent of the elastic force")
    beta: Annotated[float, Field(ge=1)] | None = Field(
        None, description="exponent of the viscous force"
    )
    gamma: NotNegative = Field(description="strength of the viscous force")


class DrivenChain(Part):
    """A chain under pressure, of a law that the campaign gives."""

    delta: Positive = Field(description="relative displacement held at the left end")
    delta_right: NotNegative = Field(
        0.0, description="relative displacement held at the right end, 0 for a free end"
    )
    beads: Annotated[
        Whole, Field(ge=20), BeforeValidator(_whole), AfterValidator(_fits_into_memory)
    ] = Field(description="number of beads N")
    crossings: Positive = Field(
        1.2,
        description="end of the motion, in times N/c that the front needs to cross the chain",
    )


class DrivenChainOfPowers(DrivenChain, Powers):
    """A chain under pressure."""


class FrontOfPowers(Powers):
    """An exact front with δ = c = 1."""

    gamma: Positive = Field(description="strength of the viscous force")


class FrontOfLaw(Part):
    """An exact front, of a law that the campaign gives."""

    behind: float = Field(description="strain behind the front")
    ahead: float = Field(0.0, description="strain ahead of the front")
    damping: Positive = Field(1.0, description="factor of the viscous potential")


class ListedWave(Part):
    """A ring at a slow time, from values that the campaign lists."""

    alpha: Annotated[Exponent, Field(le=10)] = Field(description="exponent of the elastic force")
    gamma: Positive | None = Field(None, description="strength of the viscous force")
    damping: Positive | None = Field(
        None, description="strength of the viscous force times the speed, gamma c"
    )
    epsilon: Positive | None = Field(None, description="small parameter of section 4")
    ratio: Positive | None = Field(None, description="epsilon over gamma c, equal to 12/mu^2")
    mu: Positive | None = Field(None, description="damping of the logarithmic KdV-Burgers equation")
    delta: Positive = Field(1.0, description="relative displacement at which y is 1")
    half_beads: (
        Annotated[Whole, Field(ge=2, le=MOST_HALF_BEADS), BeforeValidator(_whole)] | None
    ) = Field(None, description="p of a ring of 2p - 1 beads")
    half_length: Annotated[Positive, Field(le=1e3)] | None = Field(
        None, description="half of the ring in xi"
    )
    slow_time: Annotated[Positive, Field(le=1e3)] = Field(
        description="slow time tau at which errors are taken"
    )


class Wave(ListedWave):
    """A ring at a slow time."""

    half_width: Annotated[float, Field(ge=0.01, le=1e3)] = Field(
        description="half width of the wave at the start, in xi"
    )
    base: Annotated[Positive, Field(le=2)] = Field(
        description="rescaled force between the waves at the start"
    )


EQUATIONS = {
    "logarithmic": "the logarithmic Burgers equation (41)",
    "unlimited": "equation (40)",
    "dispersive": "the logarithmic KdV-Burgers equation (55)",
}
"""Equations that a ring is compared with, by the names of their errors."""

ERRORS_OF_AN_EQUATION = {
    "displacement_sup": "largest difference of u over delta between the chain and",
    "displacement_rms": "root mean square difference of u over delta between the chain and",
    "velocity_sup": "largest difference of dx/dt over delta c, to first order, to",
    "velocity_rms": "root mean square difference of dx/dt over delta c, to first order, to",
    "leading_velocity_sup": "largest difference of dx/dt over delta c, by (51), to",
    "height": "excess of the height of the wave, over delta, in",
    "place": "distance in xi by which the wave is ahead of the chain's in",
    "decay": "relative excess of the loss of height since the start in",
    "lost_1": "slow time at which displacement_sup passes 1 %, NaN if later than slow_time, of",
    "lost_5": "slow time at which displacement_sup passes 5 %, NaN if later than slow_time, of",
    "lost_10": "slow time at which displacement_sup passes 10 %, NaN if later than slow_time, of",
}


KINDS: dict[str, Kind] = {
    "chain": Kind(
        module="granular_fronts.campaign.chain_points",
        seconds_per_point=0.05,
        keys=("law", "fixed", "tolerance"),
        point=DrivenChainOfPowers,
        point_of_given=DrivenChain,
        scalars={
            "front_speed": "front speed over c, about 1; c = delta^((alpha - 1)/2) for powers",
            "first_peak": "first maximum of u_n over delta at the middle of the chain, minus 1",
            "largest_peak": "largest maximum of u_n over delta at the middle of the chain, minus 1",
            "overshoot": "the largest peak, see largest_peak",
            "largest_overshoot": "largest u_n over delta of all beads and times, minus 1",
            "smallest_compression": "smallest u_n over delta of all beads and times",
            "first_gap_time": "time at which the first contact opens, over 1/c; NaN if none does",
            "first_gap_bead": "bead n whose contact with n + 1 opens first; NaN if none does",
        },
        profile=("relative_displacement", "relative displacement over delta at the end"),
        profile_along=("bead", "bead number n"),
    ),
    "front": Kind(
        module="granular_fronts.campaign.front_points",
        seconds_per_point=0.0025,
        keys=("law", "fixed", "tolerance"),
        point=FrontOfPowers,
        point_of_given=FrontOfLaw,
        scalars={
            "first_peak": "first maximum of u behind the front, less its value behind",
            "largest_peak": "largest maximum of u, less its value behind, 0 if it is monotone",
            "overshoot": "the largest peak, see largest_peak",
            "width_10_90": "distance in beads over which u falls from 0.9 to 0.1 of its jump",
            "slope": "largest -u'",
            "tail_rate": "rate at which u settles behind the front, Re lambda",
            "tail_frequency": "frequency in xi of the slowest tail, Im lambda; 0 if it is monotone",
            "dissipated_power": "power dissipated by all contacts",
            "speed_defect": "speed found over the exact one, minus 1",
            "profile_error": "estimate of the largest error of u",
        },
        profile=("relative_displacement", "relative displacement u"),
        profile_along=("xi", "distance from the front, n - ct"),
    ),
    "motion": Kind(
        module="granular_fronts.campaign.motion_points",
        seconds_per_point=0.15,
        keys=("scene",),
        point=Part,
        point_of_given=Part,
        scalars={
            "largest_force": "largest peak of the force at the last contact; NaN if none passes",
            "time_of_flight": "time between the first arrivals at the first and the last contact",
            "transmitted_momentum": "momentum gained by the beads beyond the last contact",
            "transmitted_energy": "energy gained by the beads beyond the last contact",
            "last_velocity": "velocity of the last bead at the end",
        },
        profile=("velocity", "velocity at the end"),
        profile_along=("bead", "bead number n"),
    ),
    "ring": Kind(
        module="granular_fronts.campaign.ring_points",
        seconds_per_point=1.0,
        keys=("start", "fixed", "tolerance"),
        point=Wave,
        point_of_given=ListedWave,
        scalars={
            f"{error}_{equation}": f"{meaning} {name}"
            for equation, name in EQUATIONS.items()
            for error, meaning in ERRORS_OF_AN_EQUATION.items()
        }
        | {
            "epsilon_of_ring": "small parameter epsilon of the ring",
            "ratio_of_ring": "epsilon over gamma c of the ring",
            "damping_of_ring": "gamma c of the ring",
            "beads_of_ring": "number of beads of the ring",
            "residual_leading": "largest dx/dt over delta c less (51) in the chain's own y",
            "residual_printed": "largest dx/dt over delta c less (43) in the chain's own y",
            "residual_first_order": "largest dx/dt over delta c less its whole first order",
            "smallest_compression": "smallest u over delta of all beads and times",
            "first_gap_time": "slow time at which the first contact opens; NaN if none does",
        },
        profile=("relative_displacement", "relative displacement over delta of the chain"),
        profile_along=("xi", "coordinate of the moving frame of (51), epsilon (n - p - c t) - tau"),
        one_of=(("gamma", "damping", "epsilon", "ratio", "mu"), ("half_beads", "half_length")),
    ),
}
