r"""Points of waves on rings and their amplitude equations, James (2021), sections 4.3 and 5.

A point is a ring at one slow time τ.  Points that differ in nothing but `slow_time` belong to one
ring, which is solved once, so that τ is best the fast axis.  Every ring is solved in units of
length δ and time 1/c, in which a wave depends only on α and γc.  `studies.ring_limit` says what is
recorded and how errors are estimated.

The damping is given by one of γ, γc, ε, ε/γc and μ.  The length of a ring is given by p or by its
half in ξ, for which the nearest p is taken.
"""

import functools

import numpy as np

from granular_fronts.arguments import double_precision
from granular_fronts.campaign.kinds import KINDS, MOST_HALF_BEADS
from granular_fronts.campaign.points import groups_along, solve_groups
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.errors import InputError
from granular_fronts.model.amplitude_scaling import SlowScales, gamma_for
from granular_fronts.scenes.ring import GivenForce
from granular_fronts.studies.ring_limit import Ring, compare
from granular_fronts.studies.ring_starts import scene_start

ERROR_METHOD = (
    "largest difference to measuring a second solution of chain and equations, on more Fourier "
    "coefficients or cells and at a tenth of the tolerance"
)
SLOW_TIME = "slow_time"
DAMPINGS = (0.001, 1000.0)
"""Smallest and largest γc."""
PLACES_BETWEEN = 8
"""Places at which a given start is checked, for each of its values."""
LENGTH_TOLERANCE = 0.05
"""Share by which half of a ring may miss the given length, since beads are whole."""


def solve_chunk(points, settings, activity):
    """Solve rings to a tolerance per step, each at all of its slow times; a profile is in ξ."""
    xi = KINDS["ring"].profile_points(settings["profile"])
    sizes = dict.fromkeys(settings["scalars"], ())
    if xi is not None:
        sizes["relative_displacement"] = (xi.size,)
    groups = (
        (members, functools.partial(_measure, ring, slow_times, settings, xi))
        for members, ring, slow_times in groups_along(points, SLOW_TIME)
    )
    return solve_groups(points[SLOW_TIME].shape, sizes, groups, ERROR_METHOD, activity)


def _measure(ring, slow_times, settings, xi):
    """Return the values and errors of one ring at its slow times."""
    times, place = np.unique(slow_times, return_inverse=True)
    made = make_ring(ring, settings["start"])
    measured = compare(made, times, settings["tolerance"], xi)
    return {name: (found[place], error) for name, (found, error) in measured.items()}


def make_ring(point, start):
    """Return the `Ring` of a point and a campaign's start, in units of δ and 1/c.

    An InputError says that the wave is flat or does not fit into the ring.
    """
    alpha, delta = point["alpha"], point["delta"]
    given = {name: point[name] for name in ("damping", "epsilon", "ratio", "mu") if name in point}
    with double_precision("A scale of this ring", "bring alpha, delta and damping nearer to 1"):
        gamma = gamma_for(alpha, delta, **given) if given else point["gamma"]
        scaling = SlowScales(alpha, gamma, delta)
        damping = gamma * scaling.speed
    least, most = DAMPINGS
    if not least <= damping <= most:
        raise InputError(
            f"gamma c is {damping:.3g}, but rings are followed for {least:g} to {most:g}: give "
            "another damping."
        )
    half_beads = _half_beads(point, scaling)
    half_length = scaling.half_length(half_beads)
    if start["profile"] == "given":
        wave = GivenForce(kind="given", rescaled_force=start["rescaled_force"])
        _check_given(wave, half_length)
    else:
        _check_wave(start["profile"], point, half_length, scaling.epsilon)
        wave = scene_start(start["profile"], point["half_width"], point["base"], half_length)
    return Ring(alpha, damping, half_beads, wave, start.get("velocity", "slow"))


def _half_beads(point, scaling):
    """Return the given p, or the p of the ring whose length is nearest to the given one."""
    if "half_beads" in point:
        return int(point["half_beads"])
    wanted = point["half_length"]
    half_beads = max(2, round(wanted / scaling.epsilon + 0.5))
    if half_beads > MOST_HALF_BEADS:
        raise InputError(
            f"half_length is {wanted:g}, which asks for p = {half_beads:.3g}, above "
            f"{MOST_HALF_BEADS:g}: shorten the ring, raise alpha or lower the damping."
        )
    found = scaling.half_length(half_beads)
    if abs(found - wanted) > LENGTH_TOLERANCE * wanted:
        raise InputError(
            f"half_length is {wanted:g}, but beads are ε = {scaling.epsilon:.3g} apart in xi, and "
            f"the nearest ring has {found:.3g}: lengthen it, lower alpha or raise the damping."
        )
    return half_beads


def _check_given(wave, half_length):
    """Raise unless the trigonometric polynomial through given values stays above 0."""
    places = PLACES_BETWEEN * (len(wave.rescaled_force) - 1)
    xi = np.linspace(-half_length, half_length, places, endpoint=False)
    least = make_start(wave).values(xi, half_length).min()
    if not least > 0.0:
        raise InputError(
            f"rescaled_force passes through {least:.3g} between its values: give more of them, or "
            "raise the smallest."
        )


def _check_wave(profile, point, half_length, epsilon):
    """Raise unless a wave of the given width and base is one, and fits into the ring."""
    if point["base"] == 1.0:
        raise InputError("base is 1, the height of the wave, which leaves no wave: lower it.")
    if profile == "plateau" and point["base"] > 1.0:
        raise InputError("base is the floor of equation (49), which must be below 1: lower it.")
    if point["half_width"] < epsilon:
        raise InputError(
            f"half_width is {point['half_width']:g}, but beads are ε = {epsilon:.3g} apart in "
            "xi: widen the wave, lower alpha or raise the damping."
        )
    if point["half_width"] >= half_length:
        raise InputError(
            f"half_width is {point['half_width']:g}, but half of the ring is {half_length:.3g} in "
            "xi: narrow the wave or lengthen the ring."
        )
