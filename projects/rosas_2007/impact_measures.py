"""Numbers measured on impacts: the primary pulse, what is behind it, and the secondary front.

A measure takes the dataset of a scene whose `arrival_level` is recorded, or of `impact_fronts`, and
returns an `Estimate`.
"""

import math

import numpy as np
from scipy.signal import find_peaks

from granular_fronts.accuracy import Estimate, estimate, rounded, tabulated
from granular_fronts.fronts.solitary_waves import solitary_wave

ALPHA = 1.5
"""Exponent of beads."""

APART = 5
"""Contacts on both sides between which the speed of a pulse is measured."""

NEGLIGIBLE = 1e-6
"""Velocity of no pulse."""


def speed_of_primary(motion, contact):
    """Return its speed over that of the solitary wave of the same height."""
    times = motion["first_peak_time"]
    passage = float(times.sel(bead=contact + APART) - times.sel(bead=contact - APART))
    speed = rounded(2.0 * APART) / Estimate(passage, 2.0 * times.attrs["error_estimate"])
    highest = estimate(*(solitary_wave(ALPHA, points).u.max() for points in (16, 32)))
    peaks = motion["first_peak"]
    height = Estimate(float(peaks.sel(bead=contact)), peaks.attrs["error_estimate"]) / highest
    return speed / height ** (0.5 * (ALPHA - 1.0))


def persistence(motion, early, late):
    """Return how many times faster the primary pulse decays than the secondary one.

    Both by their largest velocities in the snapshots of two times.  The error is the change when
    the peak is that of a bead, not of a parabola through three.
    """
    primary, secondary = _peaks(motion, early) - _peaks(motion, late)
    return estimate(*primary / secondary)


def _peaks(motion, time):
    """Return logarithms of the two foremost maxima of the velocity, between beads and of a bead."""
    logarithm = np.log(np.maximum(motion["velocity"].sel(t=time).values, NEGLIGIBLE))
    peaks = []
    for place in find_peaks(logarithm)[0][-1:-3:-1]:
        ahead, middle, behind = logarithm[place - 1 : place + 2]
        rise = (behind - ahead) ** 2 / (8.0 * (2.0 * middle - ahead - behind))
        peaks.append([middle + rise, middle])
    return np.array(peaks)


def sound_behind(motion, time, contact):
    """Return the speed of sound (α u^(α−1))^(1/2) at a contact, 0 in a sonic vacuum."""
    u = motion["relative_displacement"].sel(t=time, bead=contact)
    speed = math.sqrt(ALPHA) * max(float(u), 0.0) ** (0.5 * (ALPHA - 1.0))
    error = float(motion["relative_displacement"].attrs["error_estimate"])
    return Estimate(speed, 0.25 * speed * error / max(float(u), error))


def one_pulse_over_no_overshoot(fronts, part, contact):
    """Return the damping from which there is one pulse over that from which no front overshoots."""
    one_pulse = tabulated(fronts, "one_pulse", part=part)
    return one_pulse / tabulated(fronts, "no_overshoot", early_contact=contact)


def overshoot_less_exact(fronts, gamma, contact):
    """Return the overshoot less that of the exact front of the same damping."""
    front = fronts.sel(gamma=gamma, contact=contact)
    return tabulated(front, "overshoot") - tabulated(front, "exact_overshoot")


def height_over_theory(fronts, gamma, contact):
    """Return the height by the speed over that by the momentum of the pulse."""
    front = fronts.sel(gamma=gamma, contact=contact)
    return tabulated(front, "height") / tabulated(front, "height_of_momentum")
