r"""Solitary waves of the conservative chain, the limit γ → 0 of the first peak of a front.

In units of the speed c = 1 the wave of :math:`\ddot u = \Delta_d u_+^\alpha` solves

.. math:: u = K * u^\alpha, \qquad K(s) = (1 - |s|)_+, \qquad
          \hat K(k) = \Bigl(\frac{\sin(k/2)}{k/2}\Bigr)^2 .

It is found by Petviashvili's iteration, :math:`u \leftarrow M^\theta K * u^\alpha` with :math:`M =
\langle u, u\rangle/\langle u, K * u^\alpha\rangle` and θ = α/(α − 1), on a long period.  The wave
decays super-exponentially and does not feel the period.

As α → 1 the force :math:`u^\alpha` tends to the Gaussian :math:`e^{1/2 - s^2/4}`,
:math:`s = 2\sqrt3\,(1 - 1/\alpha)^{1/2}\,\xi` (James 2021, section 5.2, Remark 8).
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.errors import SolveError

POINTS_PER_BEAD = 16
HALF_PERIOD = 12.0  # in units of s, where the Gaussian is 1e-16
SETTLED = 1.0e-15  # largest change of u; the error is far larger near α = 1
ITERATIONS = 100_000


class SolitaryWave(NamedTuple):
    """A wave on its grid, even in ξ; relative displacements are in units of c = 1."""

    xi: np.ndarray
    u: np.ndarray
    residual: float  # largest |u − K * u^α|


def solitary_wave(alpha, points_per_bead=POINTS_PER_BEAD):
    """Return the solitary wave of speed 1; a refined grid checks it."""
    rate = 2.0 * np.sqrt(3.0 * (alpha - 1.0) / alpha)
    half = np.ceil(max(HALF_PERIOD / rate, 4.0))
    points = int(2 * half * points_per_bead)
    xi = np.arange(points) / points_per_bead - half
    kernel = np.sinc(np.fft.rfftfreq(points, 1.0 / points_per_bead)) ** 2

    def image(u):
        return np.fft.irfft(kernel * np.fft.rfft(np.maximum(u, 0.0) ** alpha), points)

    power, u = alpha / (alpha - 1.0), gaussian(alpha, xi)
    for _ in range(ITERATIONS):
        smoothed = image(u)
        new = ((u @ u) / (u @ smoothed)) ** power * smoothed
        settled = np.abs(new - u).max() < SETTLED
        u = new
        if settled:
            return SolitaryWave(xi, u, float(np.abs(u - image(u)).max()))
    raise SolveError(
        f"The solitary wave for alpha = {alpha} is not found in {ITERATIONS} iterations: choose "
        "alpha farther from 1."
    )


def gaussian(alpha, xi):
    """Return u = y^(1/α) of the Gaussian of Remark 8, ξ in beads from its peak."""
    return np.exp((0.5 - 3.0 * (alpha - 1.0) / alpha * xi**2) / alpha)
