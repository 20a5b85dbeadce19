"""Numbers measured on impacts: the primary pulse, what is behind it, and the secondary front.

A measure takes the dataset of a scene whose `arrival_level` is recorded, or of `impact_fronts`, and
returns an `Estimate`.
"""

import math

import numpy as np

from granular_fronts.accuracy import Estimate, rounded, tabulated
from granular_fronts.fronts.solitary_waves import solitary_wave

ALPHA = 1.5
"""Exponent of beads."""

APART = 5
"""Contacts on both sides between which the speed of a pulse is measured."""


def _peak(motion, contact):
    peaks = motion["first_peak"]
    return Estimate(float(peaks.sel(bead=contact)), float(peaks.attrs["error_estimate"]))


def decay_of_primary(motion, first, last):
    """Return the rate per bead at which the compression of the primary pulse decays."""
    ratio = _peak(motion, first) / _peak(motion, last)
    return Estimate(math.log(ratio.value), ratio.error / ratio.value) / float(last - first)


def speed_of_primary(motion, contact):
    """Return its speed over that of the solitary wave of the same height."""
    times = motion["first_peak_time"]
    error = float(times.attrs["error_estimate"])
    passage = Estimate(
        float(times.sel(bead=contact + APART) - times.sel(bead=contact - APART)), 2.0 * error
    )
    speed = rounded(2.0 * APART) / passage
    highest = [solitary_wave(ALPHA, points).u.max() for points in (16, 32)]
    height = _peak(motion, contact).value / highest[0]
    theory = height ** (0.5 * (ALPHA - 1.0))
    return speed / Estimate(theory, abs(highest[1] - highest[0]) * theory)


def persistence(motion, early, late):
    """Return how many times faster the primary pulse decays than the secondary one.

    Both by their largest velocities in the snapshots of two times.  The error is the change when
    the peak is that of a bead, not of a parabola through three.
    """
    rates = []
    for interpolate in (True, False):
        primary, secondary = zip(
            *(_two_peaks(motion, time, interpolate) for time in (early, late)), strict=True
        )
        rates.append(math.log(primary[0] / primary[1]) / math.log(secondary[0] / secondary[1]))
    return Estimate(rates[0], abs(rates[0] - rates[1]))


def _two_peaks(motion, time, interpolate):
    """Return the velocities of the two foremost maxima, those of beads or between beads."""
    velocity = motion["velocity"].sel(t=time).values
    inner = np.flatnonzero((velocity[1:-1] > velocity[:-2]) & (velocity[1:-1] >= velocity[2:])) + 1
    return [
        _top(velocity[place - 1 : place + 2]) if interpolate else velocity[place]
        for place in inner[velocity[inner] > 1e-6][-1:-3:-1]
    ]


def _top(three):
    """Return the largest value of the parabola of three logarithms."""
    before, middle, after = np.log(three)
    return math.exp(middle - (after - before) ** 2 / (8.0 * (before + after - 2.0 * middle)))


def sound_behind(motion, time, contact):
    """Return the speed of sound (α u^(α−1))^(1/2) at a contact, 0 in a sonic vacuum."""
    u = motion["relative_displacement"].sel(t=time, bead=contact)
    speed = math.sqrt(ALPHA) * max(float(u), 0.0) ** (0.5 * (ALPHA - 1.0))
    error = float(motion["relative_displacement"].attrs["error_estimate"])
    return Estimate(speed, 0.25 * speed * error / max(float(u), error))


def overshoot_less_exact(fronts, gamma, contact):
    """Return the overshoot less that of the exact front of the same damping."""
    front = fronts.sel(gamma=gamma, contact=contact)
    return tabulated(front, "overshoot") - tabulated(front, "exact_overshoot")


def height_over_theory(fronts, gamma, contact):
    """Return the height by the speed over that by the momentum of the pulse."""
    front = fronts.sel(gamma=gamma, contact=contact)
    return tabulated(front, "height") / tabulated(front, "height_of_momentum")
