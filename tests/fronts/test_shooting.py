"""Fronts by shooting: the equations they solve, the laws they obey, and where they come from."""

import functools
import itertools

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.fronts.shooting import equations
from granular_fronts.fronts.shooting.initial_guess import Guess
from granular_fronts.fronts.shooting.solve import (
    _reason_against,
    refine,
    sample_window,
    shoot_front,
)
from granular_fronts.fronts.shooting.window import slow_roots

WEAK = 0.06 * 0.1**0.25
LAWS = [
    (1.5, WEAK, 1.5),
    (1.02, 0.1, 1.02),
    (1.1, gf.critical_damping(1.1), 1.1),  # whose tail is longer than its slowest root says
    (3.0, 2.0, 3.0),
    (1.5, 0.3, 1.0),
    (1.5, 0.1, 2.5),
    (1.5, 0.2, 4.0),
]
by_law = pytest.mark.parametrize(("alpha", "gamma", "beta"), LAWS)


@functools.cache
def shot(alpha, gamma, beta):
    result = shoot_front(alpha, gamma, beta)
    assert result.converged, result.reason
    return result


def distance_to_refined(front):
    """Largest difference of u and ẋ to the front of a longer window and a finer flow."""
    other = refine(front)
    assert other.converged, other.reason
    common = slice(front.bead[0] - other.bead[0], front.bead[-1] - other.bead[0] + 1)
    return max(
        np.abs(getattr(front, name) - getattr(other, name)[common]).max()
        for name in ("relative_displacement", "velocity")
    )


@by_law
def test_flow_returns_the_front_shifted_and_another_window_the_front(alpha, gamma, beta):
    """With three times the steps of the solve, so that the flow's own error counts too."""
    front = shot(alpha, gamma, beta)
    window = front.window._replace(steps=3 * front.window.steps)
    rows, _ = equations.residual(window, front.unknowns)
    assert np.abs(rows).max() <= 1.0e-13
    assert distance_to_refined(front) <= 1.0e-12


@by_law
def test_shooting_and_the_profile_equation_find_one_front(alpha, gamma, beta):
    """Two methods that share no code differ by no more than both say that they err."""
    shooting, profile = (
        gf.solve_front(alpha, gamma, beta, method=method) for method in ("shooting", "profile")
    )
    for name in ("relative_displacement", "velocity"):
        other = gf.evaluate_front(profile, shooting["xi"].values, name)
        error = shooting[name].attrs["error_estimate"] + profile[name].attrs["error_estimate"]
        assert np.abs(shooting[name].values - other).max() <= 2.0 * error < 4.0e-13
    for name in ("slope", "width_10_90", "first_peak"):
        error = shooting.attrs[f"{name}_error"] + profile.attrs[f"{name}_error"]
        assert abs(shooting.attrs[name] - profile.attrs[name]) <= 2.0 * error
    power = (alpha - 1.0) / (2.0 * (alpha + 1.0))
    assert shooting.attrs["dissipated_power"] == pytest.approx(power, abs=3.0e-14)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.5, WEAK), (3.0, 0.03)])
def test_gauss_newton_converges_quadratically(alpha, gamma):
    """A residual linear in the steps that are left over would betray an inexact derivative."""
    steps = shoot_front(alpha, gamma).step_sizes
    late = [(a, b) for a, b in itertools.pairwise(steps) if 1.0e-7 < a < 2.0e-2]
    assert late
    for before, after in late:
        assert after < 30.0 * before**2 + 1.0e-12


@pytest.mark.parametrize(("alpha", "gamma"), [(1.5, WEAK), (1.02, 0.3655)])
def test_front_of_another_damping_is_a_guess(alpha, gamma):
    guess = shoot_front(alpha, 1.05 * gamma)
    continued = shoot_front(alpha, gamma, guess=guess)
    assert continued.converged, continued.reason
    cold = shot(alpha, gamma, alpha).relative_displacement
    np.testing.assert_allclose(continued.relative_displacement, cold, rtol=0, atol=1.0e-12)


def test_sampling_is_consistent():
    front = shot(1.5, WEAK, 1.5)
    coarse, fine = sample_window(front, 3), sample_window(front, 12)
    assert fine.xi[-1] == front.bead[-1]
    np.testing.assert_allclose(fine.xi[3::4], coarse.xi, rtol=0, atol=1.0e-14 * coarse.xi.size)
    for name in ("relative_displacement", "velocity"):
        at_beads = getattr(coarse, name)[2::3]
        np.testing.assert_array_equal(at_beads, getattr(front, name))
        np.testing.assert_allclose(
            getattr(fine, name)[3::4], getattr(coarse, name), rtol=0, atol=1.0e-13
        )


def test_short_windows_wild_guesses_and_strict_tolerances_give_no_front():
    with pytest.raises(InputError, match=r"beads behind is 10, .* at least 34"):
        shoot_front(1.5, 0.1, beads=(10, 15))
    bead = np.arange(-30, 10)
    noise = np.random.default_rng(5).uniform(-3.0, 3.0, size=(2, bead.size))
    wild = shoot_front(1.5, 0.3, guess=Guess(bead, *noise))
    strict = shoot_front(1.5, 0.3, tolerance=1.0e-18)
    overflowing = shoot_front(1.5, 0.3, guess=Guess(bead, *(1.0e250 * noise)))
    for front in (shoot_front(1.5, 0.3, beads=(30, 3)), wild, strict, overflowing):
        assert not front.converged
        assert front.reason
    assert "residual" in strict.reason or "settled" in strict.reason
    assert wild.residuals[-1] > 1.0e-13


def test_a_settled_state_may_still_be_no_front():
    front = shot(1.5, 0.3, 1.0)
    state, error = np.column_stack([front.relative_displacement, front.strain_rate]), 1.0e-15
    assert not _reason_against(front.bead, state, error)
    assert "is only known to" in _reason_against(front.bead, state, 1.0e-13)
    for bead, u, words in ((front.bead[-1], 1.0e-14, "last bead"), (1, 0.6, "ahead of bead 0")):
        other = np.where((front.bead == bead)[:, np.newaxis], u, state)
        assert words in _reason_against(front.bead, other, error)


def test_a_window_ends_in_all_modes_that_decay_like_the_slowest():
    many = gf.tail_roots(20.0, 4.0, count=20)
    slow = slow_roots(20.0, 4.0, 20.0)
    assert slow.size == np.count_nonzero(many.real <= 2.1 * many[0].real) > 4
    np.testing.assert_array_equal(slow, many[: slow.size])


# Of the weakest continuum fronts are too far away; their windows have a thousand beads.
EXTREME = [(1.02, 0.03), (1.5, 0.003)]


@pytest.mark.parametrize(("alpha", "gamma"), EXTREME)
def test_fronts_of_extreme_laws_are_found(alpha, gamma):
    front = shoot_front(alpha, gamma)
    assert front.converged, front.reason
    assert front.residuals[-1] <= 1.0e-13
    assert distance_to_refined(front) <= (1.0e-11 if gamma < 0.01 else 1.0e-12)
