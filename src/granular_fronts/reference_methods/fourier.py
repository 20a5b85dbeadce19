r"""A Fourier method for the logarithmic Burgers equation: a second opinion that shares no scheme.

In the frame :math:`\tilde\xi = \xi - \tau` the amplitudes of :math:`Y = \sum_k \hat Y_k
e^{i\kappa_k\tilde\xi}`, :math:`\kappa_k = \pi k/\ell`, obey, from James (2021), eq. (50),

.. math:: \dot{\hat Y}_k = -\kappa_k^2\,\hat Y_k - i\kappa_k\,\widehat{(Y\ln Y - Y)}_k .

Diffusion is integrated exactly and the flux to fourth order in the step (ETDRK4 of Cox and
Matthews, *J. Comput. Phys.* 176 (2002) 430-455); the coefficients, differences of exponentials that
cancel where :math:`\kappa^2 h` is small, are means over a circle around each of their arguments
(Kassam and Trefethen, *SIAM J. Sci. Comput.* 26 (2005) 1214-1233).  Space is exact to all orders
once diffusion has smoothed the start.

Kinks of the start.  The amplitudes at :math:`\tau = 0` are exact but for an aliasing error of third
order (`fourier_waves.start_amplitudes`).  The first steps use `START_REFINEMENT`
times as many as asked for, and half of the waves are dropped whenever diffusion has taken a factor
:math:`e^{-40}` off all of them.  Steps grow with time: `STEPS_PER_DOUBLING` whenever τ doubles,
until they are as long as asked for.

Where the sum of waves is below the smallest value of the start, as beside the kinks at first, or
below rounding, the logarithm is frozen.
"""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from scipy import fft

from granular_fronts.continuum.log_burgers.solution import SMALLEST_ARGUMENT
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import start_amplitudes
from granular_fronts.model.amplitude_scaling import scaling_of

START_REFINEMENT = 16
STEPS_PER_DOUBLING = 16
EXTINCTION = 40.0
FIRST_DOUBLINGS = 10
CIRCLE = np.exp(1j * np.pi * (np.arange(16) + 0.5) / 16)


class FourierRun(NamedTuple):
    """Points ξ̃_j = −ℓ + 2ℓ j/M, values Y there at the end, and how many steps led to them."""

    xi: np.ndarray
    values: np.ndarray
    steps: int


class Step(NamedTuple):
    """Coefficients of one step for each wave: of ETDRK4, and of the flux."""

    whole: np.ndarray
    half: np.ndarray
    to_half: np.ndarray
    first: np.ndarray
    middle: np.ndarray
    last: np.ndarray
    derivative: np.ndarray


def evolve_fourier(scene: Mapping[str, Any], points: int, longest_step: float) -> FourierRun:
    """Solve (50) for a checked periodic scene up to its end, on M points there, M even.

    No step is longer than `longest_step`, in τ.
    """
    scaling, start = scaling_of(scene), make_start(scene["start"])
    half_length = scaling.half_length(scene["half_beads"])
    end = scaling.slow_rate * scene["end_time"]
    now = START_REFINEMENT * points
    amplitudes = start_amplitudes(start, half_length, now)
    tau, steps, floor = 0.0, 0, max(start.floor, SMALLEST_ARGUMENT)
    first = _smoothing_time(half_length, now) / 2**FIRST_DOUBLINGS
    while tau < end:
        stop = min(end, max(2.0 * tau, first))
        while now > points and stop > 2.0 * _smoothing_time(half_length, now // 2):
            now //= 2
        count = max(STEPS_PER_DOUBLING, math.ceil((stop - tau) / longest_step))
        coefficients = make_step(half_length, now, (stop - tau) / count)
        amplitudes = amplitudes[: now // 2 + 1]
        for _ in range(count):
            amplitudes = _take_step(coefficients, amplitudes, now, floor)
        tau, steps = stop, steps + count
    xi = half_length * (2.0 * np.arange(points) / points - 1.0)
    values = fft.irfft(amplitudes[: points // 2 + 1], points, norm="forward")
    return FourierRun(xi, values, steps)


def _smoothing_time(half_length, points):
    """τ at which diffusion has extinguished the shortest wave on that many points."""
    return EXTINCTION / (0.5 * np.pi * points / half_length) ** 2


def make_step(half_length, points, step):
    """Coefficients of a step of a given length."""
    wave_numbers = np.pi * np.arange(points // 2 + 1) / half_length
    z = -step * wave_numbers**2
    w = z[:, None] + CIRCLE
    e = np.exp(w)
    weights = (
        np.expm1(0.5 * w) / w,
        (-4.0 - w + e * (4.0 - 3.0 * w + w**2)) / w**3,
        (4.0 + 2.0 * w + e * (-4.0 + 2.0 * w)) / w**3,
        (-4.0 - 3.0 * w - w**2 + e * (4.0 - w)) / w**3,
    )
    means = [weight.mean(axis=1).real for weight in weights]
    return Step(np.exp(z), np.exp(0.5 * z), *means, -1j * step * wave_numbers)


def _take_step(step, amplitudes, points, floor):
    """Amplitudes after one step."""

    def rates(waves):
        y = fft.irfft(waves, points, norm="forward")
        flux = y * (np.log(np.maximum(y, floor)) - 1.0)
        return step.derivative * fft.rfft(flux, norm="forward")

    at_start = rates(amplitudes)
    a = step.half * amplitudes + step.to_half * at_start
    at_a = rates(a)
    b = step.half * amplitudes + step.to_half * at_a
    at_b = rates(b)
    c = step.half * a + step.to_half * (2.0 * at_b - at_start)
    at_c = rates(c)
    moved = step.first * at_start + step.middle * (at_a + at_b) + step.last * at_c
    return step.whole * amplitudes + moved
