"""Waves of the logarithmic KdV–Burgers equation on a ring, without a scene."""

import numpy as np

from granular_fronts.continuum.log_burgers.starts import Given
from granular_fronts.continuum.log_kdv_burgers.exponential_steps import Motion
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import Equation


def points_of(half_length, count):
    return half_length * (2.0 * np.arange(count) / count - 1.0)


def moved(values, half_length, tolerance, end, diffusion=1.0, dispersion=1.0):
    """A motion from values on points, at the slow time `end`."""
    equation = Equation(half_length, diffusion, dispersion, tolerance)
    motion = Motion(equation, np.fft.rfft(values, norm="forward"), values.size, tolerance)
    motion.advance(end)
    return motion


def smooth_wave(half_length, count=65):
    """A positive smooth start, whose values at both ends agree."""
    phase = np.pi * np.linspace(-1.0, 1.0, count)
    values = 1.0 + 0.5 * np.sin(phase) + 0.2 * np.cos(2.0 * phase)
    values[-1] = values[0]
    return Given(tuple(values))
