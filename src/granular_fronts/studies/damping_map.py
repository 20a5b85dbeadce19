r"""The plane of exponent and damping: level curves of the overshoot, and of critical damping.

Where a front with β = α ceases to oscillate has several answers (see `critical_damping`); each is a
curve γ(α) in the frame δ = c = 1.  The overshoot max u − 1 of the exact front shows what they mean
to the eye.  It never vanishes as long as the tail oscillates, but falls by decades below the first
curve that one would draw.

Two peaks.  Up to critical damping the tail is a sum of an oscillation and, above α*, of a part
without one that decays little faster.  That part holds the first maximum of u back.  As γ grows the
second maximum becomes the higher one, and then the first stays below the compression behind the
front, until it is a maximum no more.  Between the first curve and the critical damping the
overshoot is that of a later swing, and its level curves bend where they enter this region.

Every curve is a root in γ at a given α, bracketed by a sweep and found by Brent's method on single
fronts.  An error e of u is one of :math:`e/|f'|` in γ where f vanishes.
"""

from functools import cache

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from granular_fronts.accuracy import Estimate, estimated_variable
from granular_fronts.fronts.linear.critical_damping import critical_damping, meaning_changes_at
from granular_fronts.fronts.profile.equation import power_problem
from granular_fronts.fronts.profile.solve import solve_profile
from granular_fronts.fronts.properties import MEASURES, measure
from granular_fronts.fronts.sweep import sweep_fronts
from granular_fronts.numerics.interpolation import last_crests

DEFINITIONS = ("tail", "double-root", "long-wave", "overshoot")
BENDS = 1.25
"""Exponent below which the curves bend most, and are solved between the given exponents too."""
BELOW = np.geomspace(0.5, 0.01, 36)
"""Shares of critical damping by which damping is below it where both peaks change places.

They are denser near it, where the first maximum soon ceases to be one.
"""
NOISE = 1.0e-13
"""Size of peaks that are rounding."""
ERROR_OF_PEAK = 1.0e-14
ERROR_METHOD = "error of a peak over its slope along the damping"
NOWHERE = Estimate(np.nan, 0.0)


def map_plane(alpha, gamma, overshoot_cut, levels):
    """Return curves of critical damping and of the overshoot over exponents in equal steps.

    The exponents are given as to `numpy.linspace`, with those of `BENDS` between, and the dampings
    that bracket the curves as to `numpy.geomspace`.  `critical_damping_<definition>` on (alpha) is
    NaN where it does not apply.  `overshoot_level` on (level, alpha) and the dampings from which on
    `second_peak_leads`, with peaks that are `equal_peaks`, and `first_peak_stays_below` the state
    behind are NaN outside the range of dampings, and where peaks are rounding.  The attribute
    `overshoot_cut` says above which overshoot a front oscillates to the eye.  `exchange_exponent`
    is the α* where the meaning of "tail" changes.
    """
    exponents, dampings = np.linspace(**alpha), np.geomspace(**gamma)
    middles = 0.5 * (exponents[:-1] + exponents[1:])
    exponents = np.union1d(exponents, middles[middles < BENDS])
    last = meaning_changes_at()
    curves = {
        f"critical_damping_{definition.replace('-', '_')}": (
            "alpha",
            [_critical(definition, one, last, overshoot_cut) for one in exponents],
        )
        for definition in DEFINITIONS
    }
    found = [_curves(one, dampings, levels) for one in exponents]
    for column, name in enumerate(("first_peak_stays_below", "second_peak_leads")):
        estimates = [row[column] for row in found]
        curves[name] = estimated_variable("alpha", estimates, ERROR_METHOD)
    leads = curves["second_peak_leads"][1]
    equal = [
        Estimate(_peaks(*place)[0], ERROR_OF_PEAK) if np.isfinite(place[1]) else NOWHERE
        for place in zip(exponents, leads, strict=True)
    ]
    curves["equal_peaks"] = estimated_variable("alpha", equal, ERROR_METHOD)
    of_levels = [[row[2 + column] for row in found] for column in range(len(levels))]
    curves["overshoot_level"] = estimated_variable(("level", "alpha"), of_levels, ERROR_METHOD)
    return xr.Dataset(
        curves,
        {"alpha": exponents, "level": levels, "gamma": dampings[[0, -1]]},
        {"overshoot_cut": overshoot_cut, "exchange_exponent": last},
    )


def _critical(definition, alpha, last, cut):
    """Return the critical damping by a definition, NaN where it does not apply."""
    if definition == "double-root" and alpha > last:
        return np.nan
    options = {"cut": cut} if definition == "overshoot" else {}
    return critical_damping(alpha, definition=definition, **options)


def _curves(alpha, dampings, levels):
    """Return the dampings of both curves of two peaks and of each level of the overshoot."""
    critical = critical_damping(alpha)
    near = critical * (1.0 - BELOW)
    dampings = np.union1d(dampings[dampings < near[0]], near)
    sweep = sweep_fronts(alpha, dampings)
    first, largest = (sweep[name].values for name in ("first_peak", "largest_peak"))
    changes = [
        (first < -NOISE, lambda first, _second, _largest: first),
        (largest > first + NOISE, lambda first, second, _largest: first - second),
        *(
            (largest < level, lambda _first, _second, largest, level=level: largest - level)
            for level in levels
        ),
    ]
    return [_change(alpha, dampings, after, vanishing) for after, vanishing in changes]


def _change(alpha, dampings, after, vanishing):
    """Return where a function of both peaks and the largest vanishes, before a first damping."""
    k = int(np.argmax(after))
    if k == 0:  # Nowhere, or before the smallest damping.
        return NOWHERE
    before, behind = dampings[k - 1 : k + 1]

    @cache
    def function(gamma):
        return vanishing(*_peaks(alpha, gamma))

    gamma = brentq(function, before, behind, xtol=1.0e-15, rtol=1.0e-13)
    slope = (function(before) - function(behind)) / (behind - before)
    return Estimate(gamma, ERROR_OF_PEAK / slope)


def _peaks(alpha, gamma):
    """Return the first, the second and the largest peak of a front less the state behind."""
    profile = solve_profile(power_problem(alpha, gamma, alpha))
    start = np.flatnonzero(profile.s >= 0.9)[-1]
    crests = last_crests(profile.s, start, 2, 1.0, 0.0) - 1.0
    return *crests, measure(profile)[0][MEASURES.index("largest_peak")]
