r"""Fourth-order exponential steps: diffusion and dispersion exactly, the flux by Runge-Kutta.

For :math:`\dot u = \lambda u + N(u)`, one equation for each wave, the method of Krogstad
(2005), *J. Comput. Phys.* 203, 72-88, takes with :math:`z = h\lambda` the stages

.. math::

    U_2 &= e^{z/2}u + \tfrac h2\varphi_1(\tfrac z2) N_1, \\
    U_3 &= e^{z/2}u + h\bigl[\tfrac12\varphi_1(\tfrac z2) - \varphi_2(\tfrac z2)\bigr] N_1
           + h\varphi_2(\tfrac z2) N_2, \\
    U_4 &= e^z u + h[\varphi_1(z) - 2\varphi_2(z)] N_1 + 2h\varphi_2(z) N_3,

and the step, with all :math:`\varphi` at z,

.. math::

    u^+ = e^z u + h[\varphi_1 - 3\varphi_2 + 4\varphi_3] N_1
        + h[2\varphi_2 - 4\varphi_3](N_2 + N_3) + h[4\varphi_3 - \varphi_2] N_4 .

Error.  With :math:`N(u^+)` in place of :math:`N_4` the last formula is of third order.  The
difference of both is kept below the tolerance in the maximum norm.  :math:`N(u^+)` is the
:math:`N_1` of the next step, so that a step costs four fluxes.

The functions :math:`\varphi_0 = e^z`, :math:`\varphi_{j+1} = (\varphi_j - 1/j!)/z` come from this
recursion where :math:`|z| \ge 1`, and from the series of :math:`\varphi_3` elsewhere, since the
recursion loses digits there.  Those of the whole step follow from the half one by

.. math:: \varphi_k(z) = 2^{-k} \Bigl[ \varphi_0(\tfrac z2)\, \varphi_k(\tfrac z2)
    + \sum_{j=1}^{k} \frac{\varphi_j(z/2)}{(k - j)!} \Bigr] .
"""

import math
from bisect import bisect_right
from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_kdv_burgers.fourier_waves import (
    flux_amplitudes,
    linear_rates,
    values_on_points,
    wave_numbers,
)
from granular_fronts.errors import SolveError

SERIES_TERMS = 18
FIRST_STEP = 1.0e-6
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.8, 0.1, 5.0
# A step that should change by a factor between these stays as it is, which saves new weights.
LEAST_SHRINKING, LEAST_GROWTH = 0.85, 1.5
SMALLEST_RATIO = 1.0e-8
RESOLUTION = 1.0e-14


def phi_functions(z):
    """Return e^z, φ₁, φ₂ and φ₃ of complex arguments with Re z ≤ 0, each of the shape of `z`."""
    small = np.abs(z) < 1.0
    near, far = np.where(small, z, 0.0), np.where(small, 1.0, z)
    series = np.zeros_like(z)
    for n in reversed(range(SERIES_TERMS)):
        series = series * near + 1.0 / math.factorial(n + 3)
    exponential = np.exp(z)
    first = np.where(small, (series * near + 0.5) * near + 1.0, (exponential - 1.0) / far)
    second = np.where(small, series * near + 0.5, (first - 1.0) / far)
    return exponential, first, second, np.where(small, series, (second - 0.5) / far)


def doubled(exponential, first, second, third):
    """Return the functions at twice the argument."""
    return (
        exponential**2,
        0.5 * (exponential + 1.0) * first,
        0.25 * ((exponential + 1.0) * second + first),
        0.125 * ((exponential + 1.0) * third + second + 0.5 * first),
    )


class Weights(NamedTuple):
    """Weights of a step for each wave: of u, and of the fluxes in U₂, U₃, U₄ and u⁺."""

    half: np.ndarray
    whole: np.ndarray
    second: np.ndarray
    third: tuple
    fourth: tuple
    step: tuple


def _weights_of_step(equation, points, h):
    """Return the weights for a step of length h; the weights of fluxes contain −iκh."""
    kappa = wave_numbers(equation, points)
    z, derivative = h * linear_rates(equation, kappa), -1j * h * kappa
    at_half = phi_functions(0.5 * z)
    (half, half_1, half_2, _), (whole, phi_1, phi_2, phi_3) = at_half, doubled(*at_half)
    return Weights(
        half,
        whole,
        0.5 * derivative * half_1,
        (derivative * (0.5 * half_1 - half_2), derivative * half_2),
        (derivative * (phi_1 - 2.0 * phi_2), 2.0 * derivative * phi_2),
        (
            derivative * (phi_1 - 3.0 * phi_2 + 4.0 * phi_3),
            derivative * (2.0 * phi_2 - 4.0 * phi_3),
            derivative * (4.0 * phi_3 - phi_2),
        ),
    )


class Motion:
    """A wave on its way: amplitudes, slow time, and the length of the next step.

    The error of a step is at most `tolerance` in the maximum norm.  Where another motion ended its
    steps, `coarser`, this one takes two or more for each of them.  `ends` are the slow times at
    which its own steps ended, from 0 on; `accepted` and `rejected` count them.
    """

    def __init__(self, equation, amplitudes, points, tolerance, coarser=None):
        self.equation, self.tolerance, self.coarser = equation, tolerance, coarser
        self.tau, self.next_step, self.ends = 0.0, FIRST_STEP, [0.0]
        self.accepted = self.rejected = 0
        self.set_amplitudes(amplitudes, points)

    def set_amplitudes(self, amplitudes, points):
        """Go on with these amplitudes, on a number of points."""
        self.amplitudes, self.points = amplitudes, points
        self.flux = self.flux_of(amplitudes)
        self.weights, self.weights_are_for = None, 0.0

    def keep_waves(self, points):
        """Go on with the waves that so many points resolve."""
        self.set_amplitudes(self.amplitudes[: points // 2 + 1], points)

    def advance(self, stop):
        """Step to the slow time `stop`, which is met exactly."""
        while self.tau < stop:
            remaining = stop - self.tau
            # Two equal steps to the stop rather than a long and a short one.
            longest = min(self.next_step, self.half_of_coarser())
            lands = longest >= remaining or remaining < RESOLUTION * stop
            h = remaining if lands else min(longest, 0.5 * remaining)
            if h < RESOLUTION * stop and not lands:
                raise SolveError(
                    f"At slow time {self.tau:.6g} the step size collapsed to {h:.3g}: the "
                    f"tolerance {self.tolerance:g} cannot be met in double precision; raise it."
                )
            factor, accepted = self.try_step(h)
            self.accepted, self.rejected = self.accepted + accepted, self.rejected + (not accepted)
            if accepted:
                self.tau = stop if lands else self.tau + h
                self.ends.append(self.tau)
            if accepted and (lands or longest < self.next_step):
                # A step cut short says little about the next one.
                self.next_step = max(self.next_step, h * factor)
            elif not LEAST_SHRINKING < factor < LEAST_GROWTH:
                self.next_step = h * factor

    def half_of_coarser(self):
        """Return half of the step that the coarser motion took here; infinite without one."""
        if self.coarser is None:
            return math.inf
        end = min(bisect_right(self.coarser, self.tau), len(self.coarser) - 1)
        return 0.5 * (self.coarser[end] - self.coarser[end - 1])

    def try_step(self, h):
        """Take one step if its error allows; the factor for the next one, and whether it did."""
        new, last_flux = self.stages(h)
        flux = self.flux_of(new)
        difference = self.weights.step[2] * (flux - last_flux)
        largest = float(np.abs(values_on_points(difference, self.points)).max())
        ratio = largest / self.tolerance
        if not math.isfinite(ratio):
            return SMALLEST_FACTOR, False
        factor = SAFETY * max(ratio, SMALLEST_RATIO) ** -0.25
        accepted = ratio <= 1.0
        if accepted:
            self.amplitudes, self.flux = new, flux
        return min(LARGEST_FACTOR, max(SMALLEST_FACTOR, factor)), accepted

    def stages(self, h):
        """Return the amplitudes u⁺ after a step, and the flux N₄ of its last stage."""
        if h != self.weights_are_for:
            self.weights, self.weights_are_for = _weights_of_step(self.equation, self.points, h), h
        w, u, flux_1 = self.weights, self.amplitudes, self.flux
        half_way, whole_way = w.half * u, w.whole * u
        flux_2 = self.flux_of(half_way + w.second * flux_1)
        flux_3 = self.flux_of(half_way + w.third[0] * flux_1 + w.third[1] * flux_2)
        flux_4 = self.flux_of(whole_way + w.fourth[0] * flux_1 + w.fourth[1] * flux_3)
        first, middle, last = w.step
        return whole_way + first * flux_1 + middle * (flux_2 + flux_3) + last * flux_4, flux_4

    def flux_of(self, amplitudes):
        """Return the amplitudes of the flux of a wave on the present points."""
        return flux_amplitudes(self.equation, amplitudes, self.points)
