"""The kinds of campaign: their parameters, what they record, and which module solves them.

A kind is solved by one function ``solve_chunk(points, settings, activity)`` in its module. `points`
holds an array of shape (lines, fast) for each parameter of the kind.  `settings` belong to a
`Campaign`, and `activity` heads the progress bar.  The result is a `Solved`.
"""

import math
from collections.abc import Mapping
from importlib import import_module
from typing import NamedTuple

import numpy as np


class Parameter(NamedTuple):
    """A number that a point of a campaign may have."""

    meaning: str  # in words, for the data and for messages
    least: float
    above: bool = False  # whether the value must be above `least`, not at it
    default: object = ...  # an ellipsis where a campaign must give it; None for β = α
    whole: bool = False
    most: float = math.inf


class Kind(NamedTuple):
    """One family of problems.

    Attributes
    ----------
    module : str
        Module with `solve_chunk`.
    seconds_per_point : float
        Processor time of a usual point, by which a campaign is cut into jobs.
    parameters : mapping of str to Parameter
    scalars : mapping of str to str
        What may be recorded at each point, with its meaning.
    profile, profile_along : tuple of str
        Name and meaning of the profile that may be recorded, and of its coordinate.
    profile_counts : bool
        Whether only whole numbers make sense along the profile.
    beside_law : mapping of str to Parameter or None
        Parameters that take the place of α, β and γ where a campaign gives a law by the kinds of
        its potentials; None for a kind without laws.
    one_of : tuple of tuple of str
        Groups of parameters of which a campaign gives exactly one each.
    starts : tuple of str
        Profiles that a motion may start from; empty for a kind that has no choice.
    of_formula : tuple of str
        Parameters of every start but ``given``.
    of_scene : bool
        Whether a campaign gives a scene, of which its axes vary the numbers.
    """

    module: str
    seconds_per_point: float
    parameters: Mapping[str, Parameter]
    scalars: Mapping[str, str]
    profile: tuple[str, str]
    profile_along: tuple[str, str]
    profile_counts: bool = False
    beside_law: Mapping[str, Parameter] | None = None
    one_of: tuple[tuple[str, ...], ...] = ()
    starts: tuple[str, ...] = ()
    of_formula: tuple[str, ...] = ()
    of_scene: bool = False

    def of_start(self, start) -> "Kind":
        """Return the kind without the parameters that a given start does not have."""
        listed = start and start["profile"] == "given"
        return self._without(self.of_formula if listed else ())

    def of_choice(self, given) -> "Kind":
        """Return kind without the parameters in whose place others are given, by their names."""
        return self._without({name for group in self.one_of for name in group}.difference(given))

    def of_law(self, varied) -> "Kind":
        """Return the kind for any law of which named numbers vary, such as ``elastic_rate``."""
        numbers = {
            name: Parameter(f"law.{name.replace('_', '.', 1)}", -math.inf) for name in varied
        }
        kept = self._without(("alpha", "beta", "gamma")).parameters
        return self._replace(parameters=numbers | self.beside_law | kept)

    def of_numbers(self, axes) -> "Kind":
        """Return the kind for a scene of which some numbers vary, by their names in the grid."""
        numbers = {name: Parameter(axis, -math.inf) for name, axis in axes.items()}
        return self._replace(parameters=numbers)

    def _without(self, names) -> "Kind":
        kept = {name: value for name, value in self.parameters.items() if name not in names}
        return self._replace(parameters=kept)

    def profile_points(self, profile) -> np.ndarray | None:
        """Return the evenly spaced points of a recorded profile, or None."""
        if profile is None:
            return None
        points = np.linspace(profile["start"], profile["stop"], profile["count"])
        return points.round().astype(int) if self.profile_counts else points

    def solve_chunk(self, points, settings, activity="solving") -> "Solved":
        """Solve the points of one chunk, in this process."""
        return import_module(self.module).solve_chunk(points, settings, activity)


class Solved(NamedTuple):
    """The answer of a kind to the points of a chunk, arrays of shape (lines, fast[, profile])."""

    values: dict[str, np.ndarray]  # NaN at points that failed
    reasons: np.ndarray  # why a point failed, a text; empty where it is solved
    errors: dict[str, float]  # estimate of the largest absolute error, or NaN
    error_method: str


ALPHA = Parameter("exponent of the elastic force", 1.0, above=True)
BETA = Parameter("exponent of the viscous force", 1.0, default=None)
GAMMA = Parameter("strength of the viscous force", 0.0)

MODELS = {
    "logarithmic": "the logarithmic Burgers equation (41)",
    "unlimited": "equation (40)",
    "dispersive": "the logarithmic KdV-Burgers equation (55)",
}
"""Equations that a ring is compared with, by the names of their errors."""

ERRORS_OF_A_MODEL = {
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
        parameters={
            "alpha": ALPHA,
            "beta": BETA,
            "gamma": GAMMA,
            "delta": Parameter("relative displacement held at the left end", 0.0, above=True),
            "delta_right": Parameter(
                "relative displacement held at the right end, 0 for a free end", 0.0, default=0.0
            ),
            "beads": Parameter("number of beads N", 20, whole=True),
            "crossings": Parameter(
                "end of the motion, in times N/c that the front needs to cross the chain",
                0.0,
                above=True,
                default=1.2,
            ),
        },
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
        profile_counts=True,
        beside_law={},
    ),
    "front": Kind(
        module="granular_fronts.campaign.front_points",
        seconds_per_point=0.0025,
        parameters={"alpha": ALPHA, "beta": BETA, "gamma": GAMMA._replace(above=True)},
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
        beside_law={
            "behind": Parameter("strain behind the front", -math.inf),
            "ahead": Parameter("strain ahead of the front", -math.inf, default=0.0),
            "damping": Parameter("factor of the viscous potential", 0.0, above=True, default=1.0),
        },
    ),
    "motion": Kind(
        module="granular_fronts.campaign.motion_points",
        seconds_per_point=0.15,
        parameters={},
        scalars={
            "largest_force": "largest peak of the force at the last contact; NaN if none passes",
            "time_of_flight": "time between the first arrivals at the first and the last contact",
            "transmitted_momentum": "momentum gained by the beads beyond the last contact",
            "transmitted_energy": "energy gained by the beads beyond the last contact",
            "last_velocity": "velocity of the last bead at the end",
        },
        profile=("velocity", "velocity at the end"),
        profile_along=("bead", "bead number n"),
        profile_counts=True,
        of_scene=True,
    ),
    "ring": Kind(
        module="granular_fronts.campaign.ring_points",
        seconds_per_point=1.0,
        parameters={
            "alpha": ALPHA._replace(most=10.0),
            "gamma": GAMMA._replace(above=True),
            "damping": Parameter(
                "strength of the viscous force times the speed, gamma c", 0.0, True
            ),
            "epsilon": Parameter("small parameter of section 4", 0.0, True),
            "ratio": Parameter("epsilon over gamma c, equal to 12/mu^2", 0.0, True),
            "mu": Parameter("damping of the logarithmic KdV-Burgers equation", 0.0, True),
            "delta": Parameter("relative displacement at which y is 1", 0.0, True, default=1.0),
            "half_beads": Parameter("p of a ring of 2p - 1 beads", 2, whole=True, most=1e6),
            "half_length": Parameter("half of the ring in xi", 0.0, True, most=1e3),
            "half_width": Parameter("half width of the wave at the start, in xi", 0.01, most=1e3),
            "base": Parameter("rescaled force between the waves at the start", 0.0, True, most=2.0),
            "slow_time": Parameter("slow time tau at which errors are taken", 0.0, True, most=1e3),
        },
        scalars={
            f"{error}_{model}": f"{meaning} {name}"
            for model, name in MODELS.items()
            for error, meaning in ERRORS_OF_A_MODEL.items()
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
        one_of=(
            ("gamma", "damping", "epsilon", "ratio", "mu"),
            ("half_beads", "half_length"),
        ),
        starts=("plateau", "pulse", "front", "given"),
        of_formula=("half_width", "base"),
    ),
}
