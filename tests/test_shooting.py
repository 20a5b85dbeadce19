"""Fronts by shooting: the equations they solve, the laws they obey, and where they come from."""

import functools
import itertools

import numpy as np
import pytest
from chains import driven_scene
from scipy.integrate import romb

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.fronts.shooting import equations
from granular_fronts.fronts.shooting.initial_guess import Guess, chain_guess
from granular_fronts.fronts.shooting.sampling import sample_window
from granular_fronts.fronts.shooting.solve import error_estimate, shoot_front

DRIVEN = [0.06 * 0.1**0.25, 0.65 * 0.1**0.25]
LAWS = [
    (1.5, DRIVEN[0], 1.5),
    (1.5, DRIVEN[1], 1.5),
    (1.02, 0.1, 1.02),
    (1.1, 0.24, 1.1),
    (2.0, 0.1, 2.0),
    (3.0, 0.03, 3.0),
    (3.0, 2.0, 3.0),
    (1.5, 0.3, 1.0),
    (1.5, 0.1, 2.5),
]
by_law = pytest.mark.parametrize(("alpha", "gamma", "beta"), LAWS)
POINTS = 32


@functools.cache
def shot(alpha, gamma, beta):
    result = shoot_front(alpha, gamma, beta)
    assert result.converged, result.reason
    return result


@by_law
def test_flow_returns_the_front_shifted(alpha, gamma, beta):
    """With three times the steps of the solve, so that the flow's own error counts too."""
    front = shot(alpha, gamma, beta)
    window = front.window._replace(steps=3 * front.window.steps)
    rows, _ = equations.residual(window, front.unknowns)
    assert np.abs(rows).max() <= 1.0e-13


@by_law
def test_longer_window_and_finer_flow_give_the_same_front(alpha, gamma, beta):
    assert error_estimate(shot(alpha, gamma, beta)) <= 1.0e-12


@by_law
def test_dissipated_power(alpha, gamma, beta):
    """Σ W'' u̇² = (α − 1)/(2 (α + 1)) for any damping, by the trapezoidal rule over a bead-time."""
    front = shot(alpha, gamma, beta)
    profile = sample_window(front, POINTS)
    u, bead_velocity = profile.relative_displacement, profile.velocity
    rate = bead_velocity[:-POINTS] - bead_velocity[POINTS:]
    power = np.sum(beta * gamma * np.maximum(u[:-POINTS], 0.0) ** (beta - 1.0) * rate**2) / POINTS
    assert power == pytest.approx((alpha - 1.0) / (2.0 * (alpha + 1.0)), abs=1.0e-12)


@by_law
def test_convolution_form(alpha, gamma, beta):
    """u(ξ) = ∫ (1 − |s|) u^α(ξ − s) + γ sgn(s) u^β(ξ − s) ds over |s| < 1, at the beads."""
    front = shot(alpha, gamma, beta)
    u = np.maximum(sample_window(front, 128).relative_displacement, 0.0)
    s = np.linspace(0.0, 1.0, 129)
    for n in range(2, front.bead.size - 2):
        here = 128 * (n + 1) - 1
        behind, ahead = u[here - 128 : here + 1][::-1], u[here : here + 129]
        elastic = romb((1.0 - s) * (behind**alpha + ahead**alpha), 1.0 / 128.0)
        damping = gamma * romb(behind**beta - ahead**beta, 1.0 / 128.0)
        assert elastic + damping == pytest.approx(u[here], abs=1.0e-13)


@by_law
def test_velocity_behind_is_one(alpha, gamma, beta):
    """v_p = 1, James (2021), eq. (22), up to what is left of the tail."""
    front = shot(alpha, gamma, beta)
    left = np.abs(front.relative_displacement[:4] - 1.0).max()
    assert np.abs(front.velocity[:4] - 1.0).max() < 5.0 * left + 1.0e-12
    assert left < 1.0e-7


@pytest.mark.parametrize(("alpha", "gamma", "beta"), LAWS[:-2])
def test_tail_follows_its_leading_root(alpha, gamma, beta):
    """u − 1 obeys the recurrence of a real root, or of a pair, where squares are negligible.

    Not for the two last laws, whose second root is hardly faster than the first.
    """
    front = shot(alpha, gamma, beta)
    multiplier = np.exp(front.window.roots[0])
    tail = front.relative_displacement - 1.0
    if multiplier.imag == 0.0:
        defect = tail[1:] - multiplier.real * tail[:-1]
    else:
        defect = tail[2:] - 2.0 * multiplier.real * tail[1:-1] + abs(multiplier) ** 2 * tail[:-2]
    size = np.maximum.reduce([np.abs(tail[i : i + defect.size]) for i in (0, 1)])
    far = slice(4, int(np.argmax(np.abs(tail) > 1.0e-6)))
    np.testing.assert_array_less(np.abs(defect[far]), 1.0e-4 * size[far] + 1.0e-12)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.5, DRIVEN[0]), (1.5, 1.0), (3.0, 0.03)])
def test_gauss_newton_converges_quadratically(alpha, gamma):
    """A residual linear in the steps that are left over would betray an inexact derivative."""
    steps = shoot_front(alpha, gamma).step_sizes
    late = [(a, b) for a, b in itertools.pairwise(steps) if 1.0e-7 < a < 2.0e-2]
    assert late
    for before, after in late:
        assert after < 30.0 * before**2 + 1.0e-12


@pytest.mark.parametrize("gamma", [0.06, 0.65])
def test_driven_chain_and_continuum_lead_to_one_front(gamma):
    """A chain at rest pushed with δ = 0.1, its front cut out at t = 300."""
    scene = driven_scene(gamma, beads=300, end_time=300.0)
    last = gf.simulate_chain(scene).isel(t=-1)
    snapshot = last["relative_displacement"].values, last["velocity"].values
    guess = chain_guess(*snapshot, delta=0.1, alpha=1.5, gamma=gamma)
    gamma_of_front = gamma * 0.1**0.25
    driven = shoot_front(1.5, gamma_of_front, guess=guess)
    assert driven.converged, driven.reason
    assert driven.residuals[0] > 1.0e-4
    front = shot(1.5, gamma_of_front, 1.5)
    for name in ("relative_displacement", "strain_rate", "velocity"):
        np.testing.assert_allclose(getattr(driven, name), getattr(front, name), atol=3.0e-13)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.5, DRIVEN[0]), (1.02, 0.3655), (2.0, 1.0)])
def test_front_of_another_damping_is_a_guess(alpha, gamma):
    guess = shoot_front(alpha, 1.05 * gamma)
    continued = shoot_front(alpha, gamma, guess=guess)
    assert continued.converged, continued.reason
    cold = shot(alpha, gamma, alpha).relative_displacement
    np.testing.assert_allclose(continued.relative_displacement, cold, atol=1.0e-12)


def test_sampling_is_consistent():
    front = shot(1.5, DRIVEN[0], 1.5)
    coarse, fine = sample_window(front, 3), sample_window(front, 12)
    assert fine.xi[-1] == front.bead[-1]
    np.testing.assert_allclose(fine.xi[3::4], coarse.xi, atol=1.0e-14 * coarse.xi.size)
    for name in ("relative_displacement", "velocity"):
        at_beads = getattr(coarse, name)[2::3]
        np.testing.assert_array_equal(at_beads, getattr(front, name))
        np.testing.assert_allclose(getattr(fine, name)[3::4], getattr(coarse, name), atol=1.0e-13)


def test_overshoot_of_weak_damping_and_none_of_strong():
    """James (2021), section 3.3: 1.6 times the applied pressure for γ = 0.06 (a transient)."""
    weak = sample_window(shot(1.5, DRIVEN[0], 1.5), 16).relative_displacement.max()
    strong = sample_window(shot(1.5, DRIVEN[1], 1.5), 16).relative_displacement.max()
    assert 1.3 < weak**1.5 < 1.7
    assert strong <= 1.0 + 1.0e-13


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"alpha": 1.0, "gamma": 0.1}, "above 1"),
        ({"alpha": 1.5, "gamma": 0.0}, "conservative chain"),
        ({"alpha": 1.5, "gamma": 0.1, "beta": 0.5}, "at least 1"),
        ({"alpha": 1.5, "gamma": 0.1, "beads": (10, 15)}, "beads behind is 10, .* at least 34"),
    ],
)
def test_impossible_input_is_refused_in_words(arguments, words):
    with pytest.raises(InputError, match=words):
        shoot_front(**arguments)


def test_short_window_ahead_is_no_front():
    result = shoot_front(1.5, 0.3, beads=(30, 3))
    assert not result.converged
    assert result.reason


def test_failed_solve_is_a_record():
    """A guess far from any front, and a tolerance that rounding forbids."""
    bead = np.arange(-30, 10)
    noise = np.random.default_rng(5).uniform(-3.0, 3.0, size=(2, bead.size))
    wild = shoot_front(1.5, 0.3, guess=Guess(bead, *noise))
    strict = shoot_front(1.5, 0.3, tolerance=1.0e-18)
    assert not strict.converged
    assert "residual" in strict.reason or "settled" in strict.reason
    assert np.isnan(error_estimate(strict))
    overflowing = shoot_front(1.5, 0.3, guess=Guess(bead, *(1.0e250 * noise)))
    assert not overflowing.converged
    assert not wild.converged
    assert wild.residuals[-1] > 1.0e-13


@pytest.mark.parametrize(("alpha", "gamma"), [(1.5, 0.003), (3.0, 0.004)])
@pytest.mark.slow
def test_weak_damping_is_reached_from_stronger(alpha, gamma):
    """Continuum fronts are too far away there; windows of a thousand beads."""
    front = shoot_front(alpha, gamma)
    assert front.converged, front.reason
    assert front.residuals[-1] <= 1.0e-13
    assert error_estimate(front) < 1.0e-11


@pytest.mark.parametrize("alpha", [1.02, 1.1, 1.2, 1.5, 2.0, 3.0])
@pytest.mark.parametrize("gamma", [0.03, 0.06 * 0.1**0.25, 0.1, 0.24, 0.65 * 0.1**0.25, 1.0, 2.0])
@pytest.mark.slow
def test_range_of_laws(alpha, gamma):
    front = shoot_front(alpha, gamma)
    assert front.converged, front.reason
    assert error_estimate(front) <= 1.0e-12
