"""Exact waves of the logarithmic KdV–Burgers equation: solitary waves, fronts, the symmetry."""

import numpy as np
import pytest
from waves_on_rings import moved, points_of, smooth_wave

import granular_fronts as gf
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import values_at, values_on_points


def gaussian(s, c):
    """Solitary wave of speed c for μ = 0, Remark 8 and the symmetry of the equation."""
    return np.exp(0.5 + c - 0.25 * s**2)


@pytest.mark.parametrize(
    ("c", "end", "tolerance"), [(-1.0, 20.0, 1e-7), (0.5, 20.0, 1e-7), (0.0, 50.0, 1e-9)]
)
def test_gaussian_solitary_wave_keeps_shape_and_speed(c, end, tolerance):
    """Without damping, rounding and steps leave waves of some tolerances about it."""
    half_length, points = 15.0, 128
    s = points_of(half_length, points)
    motion = moved(gaussian(s, c), half_length, tolerance, end, diffusion=0.0)
    place = np.mod(s - c * end + half_length, 2.0 * half_length) - half_length
    found = values_on_points(motion.amplitudes, points)
    np.testing.assert_allclose(found, gaussian(place, c), atol=3.0 * tolerance)


def front_on_ring(mu, half_length, points, place, rise):
    """A plateau that ends in the front of (56) at `place`, in s; it rises at `rise`."""
    s = points_of(half_length, points)
    values, near = np.zeros(points), s < place + 25.0
    values[near] = gf.heteroclinic(mu, s[near] - place)["rescaled_force"].values
    return values / (1.0 + np.exp(-2.0 * (s - rise)))


def front_defect(mu, motion, place):
    """Largest distance to the front at `place`."""
    near = np.linspace(-8.0, 8.0, 161)
    found = values_at(motion.amplitudes, motion.equation.half_length, place + near)
    return np.abs(found - gf.heteroclinic(mu, near)["rescaled_force"].values).max()


@pytest.mark.parametrize("mu", [0.3, 2.0, 4.0])
def test_travelling_front_is_kept(mu):
    """In the units of section 5, where diffusion is μ and dispersion 1."""
    start = front_on_ring(mu, 160.0, 1024, -30.0, -110.0)
    motion = moved(start, 160.0, 1e-6, 8.0, diffusion=mu)
    assert front_defect(mu, motion, -30.0) < 5e-7
    assert front_defect(mu, motion, -29.99) > 5e-4


def test_waves_of_any_height_are_alike():
    """With y also λ y(ξ − τ ln|λ|) is a solution, for λ of either sign."""
    half_length, end = 8.0, 2.0
    x = points_of(half_length, 64)
    start = smooth_wave(half_length).values(x, half_length)
    reference = moved(start, half_length, 1e-8, end).amplitudes
    for factor in (7.0, -0.2):
        scaled = moved(factor * start, half_length, 1e-8 * abs(factor), end).amplitudes
        exact = factor * values_at(reference, half_length, x - end * np.log(abs(factor)))
        np.testing.assert_allclose(values_on_points(scaled, 64), exact, atol=1e-7 * abs(factor))
