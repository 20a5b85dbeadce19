"""Points of the heteroclinic orbit of section 5: one damping μ each.

Overshoot and width are taken from the orbit, traced once as usual and once by series of another
order.  Rates are taken from its extrema.  See `continuum.log_kdv_burgers.heteroclinic`.
"""

import functools
import math

from granular_fronts.accuracy import EPSILON
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.points import single_points, solve_groups
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import (
    heteroclinic,
    past_all_turns,
    refined_orbit,
)
from granular_fronts.continuum.log_kdv_burgers.survey import measure_rates

ERROR_METHOD = (
    "largest difference to the orbit traced with another order; of a rate, its change along the "
    "orbit"
)


def solve_chunk(points, settings, activity):
    """Trace heteroclinic orbits one after the other, to round-off; a profile is in s."""
    s = KINDS["heteroclinic"].profile_points(settings["profile"])
    sizes = dict.fromkeys(settings["scalars"], ())
    if s is not None:
        sizes["rescaled_force"] = (s.size,)
    groups = (
        (index, functools.partial(_measure, float(point["mu"]), s))
        for index, point in single_points(points)
    )
    return solve_groups(points["mu"].shape, sizes, groups, ERROR_METHOD, activity)


def _measure(mu, s):
    """Return each scalar of one orbit, and its profile, with an error."""
    orbits = refined_orbit(mu, past_all_turns(mu))
    rate, rate_error, frequency, frequency_error = measure_rates(mu)
    measured = {
        "overshoot": orbits.estimate(_overshoot),
        "width_10_90": orbits.estimate(_width),
        "growth_rate": (rate, rate_error),
        "angular_frequency": (frequency, frequency_error),
    }
    if s is not None:
        force = heteroclinic(mu, s)["rescaled_force"]
        measured["rescaled_force"] = (force.values, force.attrs["error_estimate"])
    return measured


def _overshoot(orbit):
    """Return the largest y − 1 of an orbit, 0 where it is below the last digit of 1."""
    _, p = orbit.turning_points()
    overshoot = math.expm1(-p[0]) if p.size else 0.0
    return overshoot if overshoot > EPSILON else 0.0


def _width(orbit):
    """Return the distance in s from y = 0.9 to y = 0.1."""
    return orbit.s_at(math.log(10.0)) - orbit.s_at(-math.log(0.9))
