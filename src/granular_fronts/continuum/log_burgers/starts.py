r"""Starts of the amplitude equations on a ring, as exact cell averages and as point values.

The start of James (2021), eq. (49), is the rescaled force

.. math:: y^0 = 1 \;(|\xi| \le w), \qquad
    y^0 = \max\bigl(1 - (|\xi| - w)^2,\; \eta\bigr) \;(w \le |\xi| \le \ell), \qquad w = 10.

It has kinks at :math:`|\xi| = w + \sqrt{1-\eta}`.  Point values would leave an error of second
order for ever. The averages of :math:`v = y^{1/\alpha}` over cells are differences of its integral.
With :math:`q = 1/\alpha` this is an incomplete beta function,

.. math:: \int_0^s (1 - r^2)^q\,dr = \tfrac12\, B(s^2;\, \tfrac12,\, q + 1),

so that a kink inside a cell costs nothing.

A given start is a list of y at equally spaced points from −ℓ to ℓ, both ends included and equal.
In between it is the trigonometric polynomial through the points.  Its averages are exact for α = 1,
and by Gauss's quadrature on parts of cells for others.
"""

from typing import NamedTuple

import numpy as np
from scipy.special import beta, betainc

from granular_fronts.continuum.log_kdv_burgers.fourier_waves import values_at
from granular_fronts.scenes.ring import PlateauStart

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


class Plateau(NamedTuple):
    """The start (49): half-width w of the plateau, floor η."""

    half_width: float
    floor: float

    def values(self, xi, half_length):
        """Return y⁰ at the points `xi`, any shape, taken modulo 2ℓ."""
        distance = np.abs(wrap(xi, half_length)) - self.half_width
        return np.maximum(1.0 - np.maximum(distance, 0.0) ** 2, self.floor)

    def averages(self, cells, half_length, alpha):
        """Return the averages of y^(1/α) over equal cells from −ℓ to ℓ, shape (cells,)."""
        edges = np.linspace(-half_length, half_length, cells + 1)
        integral = np.sign(edges) * self._integral(np.abs(edges), 1.0 / alpha)
        # The difference of two integrals may round to less than the floor.
        averages = np.diff(integral) * cells / (2.0 * half_length)
        return np.maximum(averages, self.floor ** (1.0 / alpha))

    def _integral(self, distance, power):
        """Return ∫ y^q from 0 to a distance."""
        fall = np.sqrt(1.0 - self.floor)
        fallen = np.clip(distance - self.half_width, 0.0, fall)
        slope = 0.5 * beta(0.5, power + 1.0) * betainc(0.5, power + 1.0, fallen**2)
        beyond = np.maximum(distance - self.half_width - fall, 0.0)
        return np.minimum(distance, self.half_width) + slope + self.floor**power * beyond


class Given(NamedTuple):
    """A start listed at equally spaced points from −ℓ to ℓ, both ends included."""

    rescaled_force: tuple

    @property
    def floor(self):
        """Lower bound of y; 0, since the polynomial may dip below its points."""
        return 0.0

    def values(self, xi, half_length):
        """Return y⁰ at the points `xi`, any shape, taken modulo 2ℓ."""
        return values_at(self._amplitudes(), half_length, np.asarray(xi, dtype=float))

    def averages(self, cells, half_length, alpha):
        """Return averages of y^(1/α) over equal cells from −ℓ to ℓ, shape (cells,)."""
        amplitudes = self._amplitudes()
        # Parts of cells that are fine enough for every wave.
        parts = -(-2 * amplitudes.size // cells)
        if alpha != 1.0:
            inside = np.arange(cells * parts)[:, np.newaxis] + 0.5 * (1.0 + NODES)
            y = values_at(amplitudes, half_length, half_length * (2.0 * inside / len(inside) - 1.0))
            means = 0.5 * (np.sign(y) * np.abs(y) ** (1.0 / alpha)) @ WEIGHTS
            return means.reshape(cells, parts).mean(axis=1)
        turn = np.arange(amplitudes.size) / (cells * parts)
        averages = amplitudes * np.exp(1j * np.pi * turn) * np.sinc(turn)
        values = np.fft.irfft(averages, cells * parts, norm="forward")
        return values.reshape(cells, parts).mean(axis=1)

    def _amplitudes(self):
        """Return the amplitudes of the waves 0 … M/2 of y."""
        values = np.asarray(self.rescaled_force[:-1], dtype=float)
        amplitudes = np.fft.rfft(values, norm="forward")
        if values.size % 2 == 0:
            amplitudes[-1] *= 0.5
        return amplitudes


def make_start(start):
    """Return the start that a scene describes."""
    if isinstance(start, PlateauStart):
        return Plateau(start.half_width, start.floor)
    return Given(start.rescaled_force)


def wrap(xi, half_length):
    """Return ξ modulo 2ℓ, in [−ℓ, ℓ)."""
    return np.mod(np.asarray(xi, dtype=float) + half_length, 2.0 * half_length) - half_length
