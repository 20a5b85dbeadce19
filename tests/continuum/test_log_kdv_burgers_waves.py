"""Exact waves of the logarithmic KdV–Burgers equation: solitary waves, fronts, the symmetry."""

import numpy as np
import pytest
from rings import slope_and_residual
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


def test_weak_damping_takes_half_of_mu_off_the_square_of_the_gaussian():
    """∫(y')² = ¼∫y² on the Gaussian, so that ∫y² falls with the rate μ/2 + O(μ²)."""
    half_length, points, end, excess = 15.0, 128, 4.0, []
    start = gaussian(points_of(half_length, points), 0.0)
    for mu in (0.04, 0.02, 0.01):
        motion = moved(start, half_length, 1e-9, end, diffusion=mu)
        square = np.sum(values_on_points(motion.amplitudes, points) ** 2)
        excess.append(np.log(square / np.sum(start**2)) / (-0.5 * mu * end) - 1.0)
    assert abs(excess[-1]) < 0.02
    assert slope_and_residual([25.0, 50.0, 100.0], np.abs(excess))[0] == pytest.approx(1.0, abs=0.1)


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


def test_travelling_front_is_kept_for_long():
    start = front_on_ring(1.9, 400.0, 4096, -160.0, -340.0)
    motion = moved(start, 400.0, 1e-8, 25.0, diffusion=1.9)
    assert front_defect(1.9, motion, -160.0) < 1e-9


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
