r"""Numbers measured on impacts: the primary pulse, what is behind it, and the secondary front.

A measure takes the dataset of a scene whose `arrival_level` is recorded, or of `impact_fronts` or
`impact_separation`, and returns an `Estimate`.

The primary pulse at weak damping is a solitary wave that loses what its contacts dissipate.  A wave
:math:`u = s\,U(\xi)` of speed :math:`c = s^{(\alpha-1)/2}` has the energy :math:`E = s^{\alpha+1}
E_1`, by the virial theorem :math:`E_1 = \frac{\alpha+3}{2(\alpha+1)} \int U^{\alpha+1} d\xi`.
With every bead it loses :math:`\gamma \int \dot u^2 dt = \gamma\,c\,s^2 \int U'^2 d\xi`.  Hence

.. math::

    \frac{d}{dn} s^{(\alpha-1)/2} = -\gamma k, \qquad
    k = \frac{\alpha-1}{2(\alpha+1)} \frac{\int U'^2 d\xi}{E_1} :

its speed falls linearly with the distance, not exponentially, and it ends after
:math:`c/(\gamma k)` beads.
"""

import math

import numpy as np

from granular_fronts.accuracy import Estimate, rounded, tabulated
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.output.datasets import configuration_of

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


def loss_of_primary(motion, first, last):
    """Return how much its speed falls from contact to contact, over γ k, by its height."""
    power, gamma = 0.5 * (ALPHA - 1.0), configuration_of(motion)["law"]["gamma"]
    fine, coarse = (_constants(points) for points in (32, 16))
    numbers = []
    for highest, k in (fine, coarse):
        speeds = [(_peak(motion, contact).value / highest) ** power for contact in (first, last)]
        numbers.append((speeds[0] - speeds[1]) / (gamma * k * (last - first)))
    relative = 2.0 * _peak(motion, last).error / (numbers[0] * gamma * (last - first))
    return Estimate(numbers[0], abs(numbers[0] - numbers[1]) + relative * numbers[0])


def _constants(points):
    """Return the largest U of the solitary wave of speed 1, and k."""
    wave = solitary_wave(ALPHA, points)
    wave_number = 2j * np.pi * np.fft.rfftfreq(wave.u.size, 1.0 / points)
    slope = np.fft.irfft(wave_number * np.fft.rfft(wave.u), wave.u.size)
    energy = 0.5 * (ALPHA + 3.0) / (ALPHA + 1.0) * np.sum(np.maximum(wave.u, 0.0) ** (ALPHA + 1.0))
    return wave.u.max(), 0.5 * (ALPHA - 1.0) / (ALPHA + 1.0) * np.sum(slope**2) / energy


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


def power_of_decay(fronts, gamma, first, last):
    """Return the power of the distance by which the height decays between two contacts."""
    near, far = (tabulated(fronts, "height", gamma=gamma, contact=place) for place in (first, last))
    ratio = far / near
    return Estimate(math.log(ratio.value), ratio.error / ratio.value) / math.log(last / first)


def separation_over_critical(fronts, found):
    """Return the largest damping with two pulses over the critical one of a front of height 1."""
    return tabulated(found, "separating_damping") / fronts.attrs["critical_damping"]
