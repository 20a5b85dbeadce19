"""The heteroclinic orbit against exact solutions, 35-digit arithmetic, and its own identities."""

import functools
import math

import mpmath as mp
import numpy as np
import pytest
from heteroclinic_reference import DIGITS, Reference

import granular_fronts as gf
from granular_fronts.accuracy import EPSILON
from granular_fronts.continuum.log_kdv_burgers.equation import (
    amplitude_of_chain,
    linear_rates,
    planar_system,
    potential,
)
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import (
    UNDERFLOW_P,
    compute_orbit,
    gaussian_centre,
    squared_slope_at_one,
    turning_points,
)
from granular_fronts.continuum.log_kdv_burgers.slow_manifold import (
    FEWER_TERMS,
    STIFF_DAMPING,
    slow_orbit,
)
from granular_fronts.continuum.log_kdv_burgers.survey import (
    measure_rates,
    survey_fronts,
    survey_heteroclinic,
)
from granular_fronts.continuum.log_kdv_burgers.traced_orbit import (
    FINER_STEPS,
    trace_orbit,
)
from granular_fronts.model.amplitude_scaling import gamma_for

ACCURACY = 1.0e-13
# Largest error of y and its slope at these dampings.
ROUND_OFF = {0.3: 4e-16, 2.0: 4e-16}
CASES = [
    (0.0, -12),
    (0.3, -30),
    (2.0 - 1.0e-8, -15),
    (2.0, -15),
    (np.nextafter(STIFF_DAMPING, 0.0), -12),
    (STIFF_DAMPING, -12),
    (1.0e-12, -12),
    pytest.param(50.0, -8, marks=pytest.mark.slow),  # mpmath takes seconds for a stiff orbit.
]


@functools.cache
def reference(mu, s_stop):
    """The orbit as far as it must reach; tests of one μ share it."""
    return Reference(mu, s_stop, p_start=40 if mu < 10 else 5)


def digits(value):
    return mp.mpf(float(value))


@pytest.mark.parametrize(("mu", "s_stop"), CASES)
def test_orbit_agrees_with_many_digits(mu, s_stop):
    exact = reference(mu, s_stop)
    s = np.linspace(s_stop + 0.25, 9.0, 25)
    front = gf.heteroclinic(mu, s)
    relative = 2.0 * front["log_rescaled_force"].attrs["relative_error_estimate"]
    for point in s:
        values = front.sel(s=point)
        p, v = exact.at(point)
        with mp.workdps(DIGITS):
            y = mp.exp(-p)
            within = ROUND_OFF.get(mu, ACCURACY)
            assert abs(digits(values["rescaled_force"]) - y) < within
            assert abs(digits(values["slope"]) + v * y) < within
            if point > 0:
                assert abs(digits(values["log_rescaled_force"]) / p + 1) < min(2.0e-14, relative)
    assert front.attrs["converged"] == 1
    assert front["rescaled_force"].attrs["error_estimate"] < ACCURACY


def test_tail_keeps_the_relative_accuracy_of_the_logarithm():
    mu = 0.3
    exact = Reference(mu, 0.0, p_start=760)
    s = np.linspace(1.0, compute_orbit(mu, 0.0).s_at(UNDERFLOW_P), 40)
    front = gf.heteroclinic(mu, s)
    p = np.array([float(exact.at(point)[0]) for point in s])
    np.testing.assert_allclose(-front["log_rescaled_force"], p, rtol=2.0e-14)
    relative = np.abs(front["log_rescaled_force"] / p + 1.0).max()
    assert relative <= 2.0 * front["log_rescaled_force"].attrs["relative_error_estimate"]
    assert 0.0 < front["rescaled_force"][-1] < 1.0e-322


def test_undamped_orbit_is_the_gaussian():
    s = np.linspace(-56.7, 50.4, 2001)
    front = gf.heteroclinic(0.0, s)
    p = 0.25 * (s - gaussian_centre()) ** 2 - 0.5
    np.testing.assert_allclose(front["rescaled_force"], np.exp(-p), rtol=0, atol=1.0e-15)
    np.testing.assert_allclose(front["log_rescaled_force"], -p, rtol=1.0e-14, atol=1.0e-15)
    assert front["turning_point"].values == pytest.approx([gaussian_centre()], abs=2.0e-15)
    assert front["overshoot"].values == pytest.approx([math.expm1(0.5)], abs=4.0e-16)
    assert squared_slope_at_one(0.0) == pytest.approx(-2.0 * potential(1.0), abs=4.0e-16)


@pytest.mark.parametrize("mu", [1.0e-12, 0.3, 1.9])
def test_overshoots_agree_with_many_digits(mu):
    s_stop = -30
    front = gf.heteroclinic(mu, [s_stop, 0.0])
    exact = [turn for turn in reference(mu, s_stop).turning_points() if turn[0] >= s_stop]
    assert front.sizes["turn"] == len(exact)
    for turn, (s, p) in enumerate(exact):
        with mp.workdps(DIGITS):
            assert abs(digits(front["overshoot"][turn]) - mp.expm1(-p)) < 1.0e-14
            assert abs(digits(front["turning_point"][turn]) - s) < 1.0e-12


@pytest.mark.parametrize("mu", [0.05, 1.0])
def test_every_resolvable_turn_is_found(mu):
    s, overshoot = turning_points(mu)
    rate, frequency = linear_rates(mu)[1].real, linear_rates(mu)[1].imag
    assert (np.sign(overshoot) == (-1.0) ** np.arange(s.size)).all()
    late = np.abs(overshoot) < 1.0e-8
    assert late.sum() > 3
    np.testing.assert_allclose(-np.diff(s[late]), math.pi / frequency, rtol=1.0e-8)
    decrement = np.diff(np.log(np.abs(overshoot[late])))
    np.testing.assert_allclose(decrement, -math.pi * rate / frequency, rtol=1.0e-7)
    assert abs(overshoot[-1]) * math.exp(decrement[-1]) < EPSILON
    assert (np.abs(overshoot) >= EPSILON).all()


def test_fronts_of_the_transition_are_monotone_and_close():
    s = np.linspace(-50.0, 20.0, 1001)
    critical = gf.heteroclinic(2.0, s)["rescaled_force"]
    for mu in (2.0 - 1.0e-8, 2.0, 2.0 + 1.0e-8):
        front = gf.heteroclinic(mu, s)
        assert front.sizes["turn"] == 0
        assert (front["slope"] <= 0.0).all()
        assert abs(front["rescaled_force"] - critical).max() < 1.0e-8
        assert squared_slope_at_one(mu) < 1.0e-40
    assert max(map(squared_slope_at_one, (11.9, 12.0, 50.0))) < 1.0e-40
    # Below, an overshoot is of size e^(−πμ/2ω), ω² = 1 − μ²/4, the last digit near μ = 1.99.
    turns = [turning_points(mu)[0].size for mu in (1.98, 1.99, 1.995, 1.999, 2.0, 3.0)]
    assert turns == [1, 1, 0, 0, 0, 0]


@pytest.mark.parametrize("mu", [0.3, 1.99])
def test_squared_slope_at_one_agrees_with_many_digits(mu):
    exact = reference(mu, -40)
    orbit = compute_orbit(mu, -40.0)
    p, v = exact.at(orbit.s_at(0.0))
    assert abs(p) < 2.0e-13 * abs(v)
    assert squared_slope_at_one(mu) == pytest.approx(float(v) ** 2, rel=1.0e-13)


@pytest.mark.parametrize("mu", [0.3, 2.5, 11.0, 50.0])
def test_rates_read_off_an_orbit_are_the_eigenvalues_within_their_errors(mu):
    rate, rate_error, frequency, frequency_error = measure_rates(mu)
    expected = linear_rates(mu)[0 if mu > 2.0 else 1]
    assert abs(rate - expected.real) < rate_error < 1e-9
    assert abs(frequency - expected.imag) <= frequency_error < 1e-9
    square = survey_fronts([mu], np.array([-1.0, 0.0]))["squared_slope_at_one"]
    # It is 0 from μ = 2 on, and what is found there the error.
    assert square.error_estimate == (np.spacing(square) if mu < 2.0 else square)


@pytest.mark.parametrize("mu", [12.0, 14.0])
def test_closed_form_and_trace_agree_where_both_hold(mu):
    closed, traced = slow_orbit(mu), trace_orbit(mu, -math.inf, FINER_STEPS)
    s = np.linspace(traced.front.end, closed.s_at(700.0), 501)
    (p, v), (p_traced, v_traced) = closed.evaluate(s), traced.evaluate(s)
    error = np.abs(np.exp(-p) - np.exp(-p_traced)).max()
    np.testing.assert_allclose(v, v_traced, rtol=2.0e-14, atol=1e-19)
    front = gf.heteroclinic(mu, np.linspace(-100.0, 20.0, 301))
    estimate = front["rescaled_force"].attrs["error_estimate"]
    fewer = slow_orbit(mu, FEWER_TERMS).evaluate(front["s"].values)[0]
    assert error < (estimate if mu == STIFF_DAMPING else 2.0e-15)
    assert np.abs(np.exp(-fewer) - front["rescaled_force"]).max() <= estimate


def test_points_may_come_in_any_order_and_alone():
    s = np.array([3.0, -20.0, 0.0, 7.0])
    together = gf.heteroclinic(0.3, s)["rescaled_force"].values
    alone = [float(gf.heteroclinic(0.3, point)["rescaled_force"][0]) for point in s]
    np.testing.assert_allclose(alone, together, rtol=0, atol=1.0e-16)
    assert together[2] == pytest.approx(0.5, abs=2.0e-16)
    # A turn outside the range of s is not listed.
    turn = float(gf.heteroclinic(0.3, [-3.0, 0.0])["turning_point"][0])
    assert gf.heteroclinic(0.3, [turn + 1.0e-3, 0.0]).sizes["turn"] == 0


@pytest.mark.parametrize("mu", [0.0, 0.3, 50.0])
def test_default_range_covers_both_tails_and_far_behind_the_force_is_one(mu):
    y = gf.heteroclinic(mu)["rescaled_force"]
    assert y[-1] < 1.0e-15
    assert abs(y[0] - (mu > 0.0)) < (2.0e-5 if mu == 0.3 else 1.0e-14)
    assert y.size == 1001
    if mu > 0.0:
        far = gf.heteroclinic(mu, [-1.0e12])
        assert far["rescaled_force"] == 1.0
        assert abs(far["slope"]) < 1.0e-250


def test_amplitude_of_a_chain_has_the_coefficients_of_the_paper():
    """(52)–(54), and the critical damping γ_c c = ((1 − 1/α)/3)^(1/2)."""
    alpha, gamma, delta = 1.1, 0.06, 0.1
    c, epsilon = delta**0.05, math.sqrt(1.0 - 1.0 / alpha)
    expected = (2.0 * math.sqrt(3.0) * gamma * c / epsilon, c, math.sqrt(12.0) * epsilon)
    amplitude = amplitude_of_chain(alpha, gamma, delta)
    assert amplitude == pytest.approx((*expected, math.sqrt(3.0) * c * epsilon**3), rel=1.0e-15)
    assert gamma_for(alpha, delta, mu=amplitude.mu) == pytest.approx(gamma, rel=1.0e-15)
    assert gamma_for(1.5, 1.0, mu=2.0) == pytest.approx(1.0 / 3.0, rel=1.0e-15)


@pytest.mark.parametrize("mu", [0.0, 0.3, 2.0 - 1e-8, 2.0, 2.0 + 1e-8, 50.0, 1.0e9])
def test_linear_rates_are_the_roots_without_cancellation(mu):
    with mp.workdps(40):
        root = mp.sqrt(mp.mpc(mp.mpf(mu) ** 2 - 4))
        exact = [complex((mu - root) / 2), complex((mu + root) / 2)]
    np.testing.assert_allclose(linear_rates(mu), exact, rtol=1.0e-15)


def test_planar_system_is_the_force_of_the_potential():
    y, step = np.array([-1.4, -0.3, 0.2, 1.0, 1.5]), 1.0e-5
    force = (potential(y + step) - potential(y - step)) / (2.0 * step)
    slope, acceleration = planar_system(0.0, np.array([y, 0.2 * y]), 0.3)
    np.testing.assert_allclose(slope, 0.2 * y)
    np.testing.assert_allclose(acceleration, 0.06 * y - force, rtol=0, atol=1.0e-9)
    assert potential(0.0) == 0.0
    assert (planar_system(0.0, np.zeros(2), 0.3) == 0.0).all()


def test_trajectories_of_the_portrait_lead_through_their_starts_and_gain_energy():
    scene = {"mu": [0.3], "profile": {"start": 0.0, "stop": 1.0, "step": 1.0}}
    starts = [[0.5, 0.0], [-0.4, 0.1]]
    portrait = {"mu": 0.3, "starts": starts, "span": 4.0, "step": 0.5, "limit": 2.0}
    well = {"limit": 1.5, "step": 0.5}
    survey = survey_heteroclinic(scene | {"portrait": portrait, "well": well})
    np.testing.assert_array_equal(survey["potential"], potential(np.arange(-1.5, 1.6, 0.5)))
    y, z = (survey[f"{name}_portrait"].values for name in ("rescaled_force", "slope"))
    np.testing.assert_array_equal(np.transpose([y[:, 8], z[:, 8]]), starts)
    energy = 0.5 * z**2 + potential(y)
    assert np.isfinite(energy).all()
    assert (np.diff(energy) > 0.0).all()
