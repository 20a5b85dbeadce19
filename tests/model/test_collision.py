"""Restitution of two beads: closed forms, an independent integration, its inverse and limits."""

import math

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import granular_fronts as gf
from granular_fronts.model.collision import (
    LARGEST_STEP,
    _slow_strength,
    damping_for_restitution,
    log_restitution,
    weak_damping_slope,
)

ACCURACY = 1.0e-12
EXPONENTS = [(1.5, 1.5), (1.5, 1.0), (1.5, 2.5), (3.0, 2.0), (0.5, 1.0), (2.0, 5.0)]
by_exponents = pytest.mark.parametrize(("alpha", "beta"), EXPONENTS)


def collide(force, damping):
    """Integrate u̇ = p − 2G(u), ṗ = −2F(u) as they stand, and locate the end of the contact."""

    def slopes(_, state):
        u, p = max(state[0], 0.0), state[1]
        return [p - 2.0 * damping(u), -2.0 * force(u)]

    def end(_, state):
        return state[0]

    end.terminal, end.direction = True, -1
    precise = {"rtol": 1.0e-13, "atol": 1.0e-15, "max_step": 0.02}
    motion = solve_ivp(slopes, (0.0, 1e3), [0.0, 1.0], "DOP853", events=end, **precise)
    return -float(motion.y_events[0][0, 1])


@by_exponents
@pytest.mark.parametrize("gamma", [0.01, 0.5])
def test_agrees_with_the_equation_of_motion(alpha, beta, gamma):
    expected = collide(lambda u: u**alpha, lambda u: gamma * u**beta)
    assert gf.restitution(gamma, alpha, beta) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize("gamma", [1.0e-3, 1.0, 200.0])
def test_simon_hunt_crossley_has_a_closed_form(gamma):
    """For β = α + 1 the reduced equation is linear: 1/G − e = (1 + 1/G) exp(−G(1 + e))."""
    alpha = 1.5
    with mp.workdps(50):
        G = mp.mpf(gamma) * (alpha + 1)
        w = -mp.lambertw(-(G + 1) * mp.exp(-(G + 1)))
        exact = (1 - w) / G
        assert abs(gf.restitution(gamma, alpha, alpha + 1.0) / exact - 1) < ACCURACY


@pytest.mark.parametrize("beta", [1.0, 2.0])
@pytest.mark.parametrize("ratio", [1.0e-6, 0.6, 0.99])
def test_degenerate_exponent_is_a_damped_oscillator(beta, ratio):
    alpha = 2.0 * beta - 1.0
    gamma = ratio / math.sqrt((alpha + 1.0) / 4.0)
    exact = math.exp(-math.pi * ratio / math.sqrt(1.0 - ratio**2))
    assert gf.restitution(gamma, alpha, beta) == pytest.approx(exact, rel=2e-12)
    # The general method comes to the same from both sides.
    for nu in (0.5 - 1.0e-15, 0.5 + 1.0e-15):
        assert log_restitution(nu, 4.0 * ratio) == pytest.approx(math.log(exact), rel=1e-11)
    assert gf.restitution(1.001 * gamma / ratio, alpha, beta) == 0.0


@by_exponents
def test_smaller_steps_change_nothing(alpha, beta):
    nu = beta / (alpha + 1.0)
    for strength in (1.0e-8, 1.0, 300.0):
        one, two = (
            log_restitution(nu, strength, step) for step in (LARGEST_STEP, LARGEST_STEP / 3.0)
        )
        assert one == two or abs(one - two) < 5e-13 * max(1.0, abs(one))


@pytest.mark.parametrize(("alpha", "beta"), [(1.5, 1.5), (3.0, 2.0)])
def test_inverse_returns(alpha, beta):
    # Just below a finite γ at which e vanishes, γ alone does not determine a small e.
    assert damping_for_restitution(1.0, alpha, beta) == 0.0
    assert gf.restitution(1e-300, alpha, beta) == 1.0
    tolerance = ACCURACY if beta > (alpha + 1.0) / 2.0 else 1.0e-9
    for e in (1.0, 1.0 - 1.0e-9, 0.3, 1.0e-9):
        gamma = damping_for_restitution(e, alpha, beta)
        assert gf.restitution(gamma, alpha, beta) == pytest.approx(e, rel=tolerance)


@by_exponents
@pytest.mark.parametrize("lost", [1.0e-12, 1.0e-8])
def test_inverse_near_1_is_the_expansion_to_second_order(alpha, beta, lost):
    """ln e = −x + (ν − ½)x², x = ½G B(ν + 1, ½); e itself has lost digits there, γ has not."""
    with mp.workdps(40):
        nu, small = mp.mpf(beta) / (mp.mpf(alpha) + 1), -mp.log(mp.mpf(1.0 - lost))
        strength = 2 * (small + (nu - 0.5) * small**2) / mp.beta(nu + 1, 0.5)
        exact = strength / (4 * ((mp.mpf(alpha) + 1) / 4) ** nu)
        assert abs(damping_for_restitution(1.0 - lost, alpha, beta) / exact - 1) < ACCURACY


@by_exponents
def test_weak_damping_is_linear(alpha, beta):
    slope = weak_damping_slope(alpha, beta)
    dampings = np.array([1.0e-3, 1.0e-4])
    lost = 1.0 - np.array([gf.restitution(gamma, alpha, beta) for gamma in dampings])
    defects = np.abs(slope * lost / dampings - 1.0)
    assert defects[1] < 3.0e-4
    assert math.log10(defects[0] / defects[1]) == pytest.approx(1.0, abs=0.01)


def test_constant_of_remark_6():
    """The paper prints 0.438; to fifty digits the constant is a quotient of Gamma functions."""
    with mp.workdps(50):
        nu = mp.mpf(3) / 5
        exact = 1 / (2 * (mp.mpf(5) / 8) ** nu * mp.beta(nu + 1, mp.mpf(1) / 2))
        assert mp.nstr(exact, 10) == "0.4380244967"
        assert weak_damping_slope() == pytest.approx(float(exact), rel=1e-14)


@pytest.mark.parametrize("nu", [0.505, 0.6, 2.0])
def test_strong_damping_is_a_power_law(nu, monkeypatch):
    """Beyond the strength where it is assumed, the integration itself confirms it."""
    power = 1.0 / (2.0 * nu - 1.0)
    slow = _slow_strength(nu)
    taken = log_restitution(nu, 1.3 * slow)
    monkeypatch.setattr("granular_fronts.model.collision._slow_strength", lambda nu: 2.0 * slow)
    integrated = log_restitution(nu, 1.3 * slow)
    assert taken == pytest.approx(integrated, abs=1e-11 * power)


def test_linear_dashpot_holds_the_beads_together():
    """For β < (α + 1)/2 and a large γ the beads creep apart, and their contact never ends."""
    threshold = damping_for_restitution(1.0e-12, 1.5, 1.0)
    assert gf.restitution(threshold, 1.5, 1.0) == pytest.approx(1.0e-12, rel=0.01)
    for gamma in (1.01 * threshold, 1.0, 1.0e3):
        assert gf.restitution(gamma, 1.5, 1.0) == 0.0
    # No trial step takes a power of a negative sine, and none overflows.
    for gamma in (1.0, 1e300):
        assert gf.restitution(gamma, 100.0, 1.0) == 0.0
