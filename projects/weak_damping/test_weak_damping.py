"""Dispersive shocks and weakly damped fronts: closed forms, independent methods, a control."""

import math

import numpy as np
import pytest
from by_hand import assert_measures, estimates

import weakly_damped_fronts
from dispersive_shocks import follow_shocks, zone_of
from granular_fronts.accuracy import Estimate, tabulated
from granular_fronts.errors import SolveError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solitary_waves import solitary_wave
from projects import assert_readme_shows_statements
from shock_measures import collapse, far_away, speed_over_solitary
from weakly_damped_fronts import _energies, _periodic_wave, damp_weakly, extrapolate, slow_waves

TOLERANCE = {"relative": 1e-9, "absolute": 1e-11}
ALPHAS = pytest.mark.parametrize("alpha", [1.3, 2.0])


@ALPHAS
def test_periodic_waves_solve_the_equation_and_join_both_ends(alpha):
    """Their energy flux runs from 0 to that of (16), and they end with the tail of the front."""
    waves = slow_waves(alpha, 64, 100)
    assert waves["crest"][0] == pytest.approx(solitary_wave(alpha).u.max(), rel=1e-9)
    height = np.log(waves["crest"] - waves["trough"])
    rate = np.diff(height)[-1] / np.diff(waves["damped_distance_wave"])[-1]
    assert -rate == pytest.approx(tail_roots(alpha, 1e-5, count=1)[0].real / 1e-5, rel=2e-3)
    period, solitary = 5.0, solitary_wave(alpha)
    sites = np.abs(np.linspace(-0.5, 0.5, 64, endpoint=False))
    u = _periodic_wave(alpha, np.interp(period * sites, solitary.xi, solitary.u), period)
    # The same as the difference equation of the chain, u'' = Δ u^α.
    turns, k = np.fft.rfft(u), 2.0 * np.pi * np.fft.rfftfreq(64, period / 64)
    bend = np.fft.irfft(-(k**2) * turns, 64)
    shifted = np.fft.irfft(np.fft.rfft(u**alpha) * (2.0 * np.cos(k) - 2.0), 64)
    np.testing.assert_allclose(bend, shifted, atol=1e-6)
    assert np.ptp(u) > 0.1
    flux, loss = _energies(alpha, np.ones(64), period)
    assert flux == pytest.approx((alpha - 1.0) / (2.0 * (alpha + 1.0)), rel=1e-12)
    assert loss == pytest.approx(0.0, abs=1e-20)


def test_a_guess_too_far_from_a_wave_ends_in_a_sentence(monkeypatch):
    monkeypatch.setattr(weakly_damped_fronts, "ITERATIONS", 2)
    with pytest.raises(SolveError, match=r"period 5 .*alpha = 1\.5"):
        _periodic_wave(1.5, 1.0 + 0.5 * np.cos(2.0 * np.pi * np.arange(64) / 64), 5.0)


@ALPHAS
def test_exact_fronts_tend_to_slowly_changing_waves(alpha):
    """Two independent methods, with a distance that falls with γ."""
    found = damp_weakly(alpha, [0.04, 0.02, 0.01, 0.005])
    for name in ("zone", "overshoot"):
        limit, extrapolated = (
            tabulated(found, f"{name}_{end}") for end in ("limit", "extrapolated")
        )
        assert abs(limit.value - extrapolated.value) < 2.0 * (limit.error + extrapolated.error)
        apart = limit.value - found[name].values
        assert (apart[:-1] / apart[1:] > 1.8).all()


def test_a_train_that_is_cut_off_has_nozone_of():
    with pytest.raises(SolveError, match="longer than what is recorded"):
        zone_of(np.arange(5.0), 1.0 + np.array([0.5, 0.4, 0.35, 0.3, 0.25]))


def test_limits_and_zones_of_known_functions_are_found():
    places = np.arange(40.0)
    assert zone_of(places, 1.0 + np.exp(-0.1 * places)) == pytest.approx(10.0 * math.log(10.0))
    gamma = np.array([0.08, 0.04, 0.02, 0.01])
    values = [Estimate(3.0 + g + 2.0 * g * math.log(g), 0.0) for g in gamma]
    assert extrapolate(gamma, values).value == pytest.approx(3.0)


@pytest.mark.slow
def test_damping_stops_the_spreading_at_a_front():
    found = follow_shocks(1.5, [0.0, 0.01, 0.02, 0.04], [50, 100, 200], TOLERANCE)
    assert speed_over_solitary(found).value == pytest.approx(1.0, abs=1e-3)
    assert far_away(found, "height").value > 1.75
    assert 0.3 < collapse(found, "height", 0.01, 200).value < 0.7
    settled = found.sel(gamma=0.04)
    exact = damp_weakly(1.5, [0.08, 0.04, 0.02, 0.01]).sel(gamma=0.04)
    assert float(settled["height"][-1]) == pytest.approx(1.0 + float(exact["overshoot"]), abs=1e-3)
    assert 0.04 * float(settled["zone"][-1]) == pytest.approx(float(exact["zone"]), rel=3e-3)
    assert float(settled["velocity_behind"]) == pytest.approx(1.0, abs=1e-5)


# Without damping 1, 2, 9/4 tends to 5/2, and one contact before to 3.
SHOCK_AT = {"gamma": [0.0, 0.1, 0.2, 0.4], "contact": [50, 100, 200]}
HEIGHTS = np.array([[1.0, 2.0, 2.25], [0.0, 0.0, 8.0], [0.0, 4.0, 0.0], [2.0, 0.0, 0.0]])
SHOCKS = estimates({"alpha": 3.0}, height=(SHOCK_AT, HEIGHTS), speed=(SHOCK_AT, 2.0 * HEIGHTS))
CREST, FALL = solitary_wave(3.0).u.max(), {"name": "height", "gamma": 0.1, "contact": 200}


@pytest.mark.parametrize(
    ("measure", "arguments", "value", "error"),
    [
        (far_away, {"name": "height"}, 2.5, 1.003),
        (speed_over_solitary, {}, 2.0 * CREST, 4.009 * CREST / 2.5),
        (collapse, FALL, 2.0, (2e-3 + 2.0 * 2e-3) / 2.0),
    ],
)
def test_measure_is_what_follows_by_hand(measure, arguments, value, error):
    assert_measures(measure, SHOCKS, arguments, value, error)


# The whole project is run.
@pytest.mark.nightly
def test_the_page_shows_what_is_computed(tmp_path):
    assert_readme_shows_statements("weak_damping", tmp_path)
