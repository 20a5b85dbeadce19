r"""The logarithmic KdV–Burgers equation for the Fourier amplitudes of a wave on a ring.

The amplitudes of :math:`y = \sum_k \hat y_k e^{i\kappa_k(\xi + \ell)}`,
:math:`\kappa_k = \pi k/\ell`, obey

.. math::

    \dot{\hat y}_k = \lambda_k \hat y_k - i\kappa_k\,\widehat{(y\ln|y|)}_k, \qquad
    \lambda_k = -\nu\kappa_k^2 + iD\kappa_k^3,

with diffusion :math:`\nu = 1` and dispersion :math:`D = \mu^{-2}` in the variables of `evolution`,
:math:`\nu = \mu` and :math:`D = 1` in those of James (2021), eq. (55).  The flux is evaluated on N
equally spaced points from −ℓ on.  Its amplitude of k = 0 does not enter, so that the mean of y is
kept exactly.

Order.  Where y is smooth and not zero, the error falls faster than any power of N.  At a change of
sign :math:`y\ln|y|` has a logarithmically infinite slope, which the N points sample with an error
of second order.

Small values.  :math:`\ln|y|` is taken as :math:`\tfrac12\ln(y^2 + \eta^2)`, η being `floor`.  The
flux is then smooth, and differs from :math:`y\ln|y|` by less than 0.41 η.

The start.  Amplitudes at :math:`\tau = 0` come from exact averages over `OVERSAMPLING` times as
many cells as points.  So kinks cost an aliasing error of third order on these cells.
"""

from typing import NamedTuple

import numpy as np

OVERSAMPLING = 8
# Waves summed in one block when values at given points are asked for.
BLOCK = 16


class Equation(NamedTuple):
    """What is solved."""

    half_length: float  # ℓ of the ring
    diffusion: float  # ν, at least 0
    dispersion: float  # D of the third derivative, at least 0
    floor: float  # η, below which the logarithm is cut off; positive


def wave_numbers(equation, points):
    """Return κ of the waves that a number of points resolves, shape (points//2 + 1,)."""
    return np.pi * np.arange(points // 2 + 1) / equation.half_length


def linear_rates(equation, kappa):
    """Return λ of the linear part."""
    return kappa**2 * (-equation.diffusion + 1j * equation.dispersion * kappa)


def flux_amplitudes(equation, amplitudes, points):
    """Return the amplitudes of the flux y ln|y|, evaluated on the points."""
    y = values_on_points(amplitudes, points)
    return np.fft.rfft(0.5 * y * np.log(y * y + equation.floor**2), norm="forward")


def values_on_points(amplitudes, points):
    """Return the values at −ℓ + 2ℓ j/N, j = 0 … N − 1."""
    return np.fft.irfft(amplitudes, points, norm="forward")


def values_at(amplitudes, half_length, xi):
    """Return the values at any points, any shape, taken modulo 2ℓ: the sum of all waves."""
    blocks = -(-amplitudes.size // BLOCK)
    weights = np.zeros((blocks, BLOCK), complex)
    weights.flat[: amplitudes.size] = 2.0 * amplitudes
    weights[0, 0] = amplitudes[0]
    phase = np.pi * (xi / half_length + 1.0)
    waves_of_block = _powers(np.exp(1j * phase), BLOCK)
    first_waves = _powers(np.exp(1j * BLOCK * phase), blocks)
    return ((waves_of_block @ weights.T) * first_waves).sum(axis=-1).real


def _powers(numbers, count):
    """Return the powers 0 … count − 1 along a new last axis; exponentials would cost ten times."""
    factors = np.repeat(numbers[..., np.newaxis], count, axis=-1)
    factors[..., 0] = 1.0
    return np.multiply.accumulate(factors, axis=-1)


def start_amplitudes(start, half_length, points):
    """Return the amplitudes of a start from its exact averages, shape (points//2 + 1,)."""
    cells = OVERSAMPLING * points
    waves = np.arange(points // 2 + 1)
    amplitudes = np.fft.rfft(start.averages(cells, half_length, 1.0), norm="forward")[: waves.size]
    return amplitudes * np.exp(-1j * np.pi * waves / cells) / np.sinc(waves / cells)
