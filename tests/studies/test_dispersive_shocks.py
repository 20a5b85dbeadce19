"""Dispersive shocks and weakly damped fronts: closed forms, independent methods, a control."""

import doctest
import math

import numpy as np
import pytest

from granular_fronts.accuracy import Estimate, tabulated
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.studies import dispersive_shocks
from granular_fronts.studies.dispersive_shocks import (
    _energies,
    _periodic_wave,
    _zone,
    damp_weakly,
    extrapolate,
    fitted_edges,
    follow_shocks,
    read_shock,
    shock_scene,
    slow_waves,
)
from granular_fronts.studies.shock_measures import (
    collapse,
    far_away,
    over_fitted,
    speed_over_solitary,
)

TOLERANCE = {"relative": 1e-9, "absolute": 1e-11}
ALPHAS = pytest.mark.parametrize("alpha", [1.3, 1.5, 2.0])


def test_fitting_gives_the_edges_of_korteweg_and_de_vries_for_close_states():
    """Leading crest and trailing edge: the sound ahead plus 2/3 of the jump, and minus 1 of it."""
    leading, trailing = fitted_edges(1.0, 1.0 + 1e-4)
    assert (leading - 1.0) / 1e-4 == pytest.approx(2.0 / 3.0, rel=1e-3)
    assert (trailing - 1.0) / 1e-4 == pytest.approx(-1.0, rel=1e-3)
    found = doctest.testmod(dispersive_shocks)
    assert found.failed == 0 < found.attempted


@pytest.mark.slow
def test_fitting_is_exact_for_the_toda_chain_and_not_for_beads():
    """The control of both edges: Toda's chain is integrable, that of Hertz is not."""
    sound, contacts = 1.3, [200, 400, 800]
    behind = 2.0 * math.log(sound)
    law = {"elastic": {"kind": "toda"}}
    scene = shock_scene(law, math.expm1(behind), 0.0, contacts, TOLERANCE)
    motion = simulate_chain(scene, "toda")
    readings = [read_shock(motion, contact, behind, 1.0) for contact in contacts]
    leading, trailing = fitted_edges(1.0, sound)
    _, near, far = ([one.value for one in reading] for reading in readings)
    assert 2.0 * far[1] - near[1] == pytest.approx(leading, rel=1e-4)
    assert far[3] == pytest.approx(trailing, rel=0.01)
    # The integral of the sound speed between both states.
    assert motion["velocity"][-1, :40].mean() == pytest.approx(2.0 * (sound - 1.0), rel=1e-5)
    beads = follow_shocks(1.5, [0.0], [0.2], contacts, TOLERANCE)
    assert over_fitted(beads, "speed", 0.2).value > 1.02
    assert over_fitted(beads, "trailing_edge", 0.2).value > 1.3


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
    monkeypatch.setattr(dispersive_shocks, "ITERATIONS", 2)
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


def test_a_train_that_is_cut_off_has_no_zone():
    with pytest.raises(SolveError, match="longer than what is recorded"):
        _zone(np.arange(5.0), 1.0 + np.array([0.5, 0.4, 0.35, 0.3, 0.25]))


def test_limits_and_zones_of_known_functions_are_found():
    places = np.arange(40.0)
    assert _zone(places, 1.0 + np.exp(-0.1 * places)) == pytest.approx(10.0 * math.log(10.0))
    gamma = np.array([0.08, 0.04, 0.02, 0.01])
    values = [Estimate(3.0 + g + 2.0 * g * math.log(g), 0.0) for g in gamma]
    assert extrapolate(gamma, values).value == pytest.approx(3.0)


@pytest.mark.slow
def test_damping_stops_the_spreading_at_a_front():
    found = follow_shocks(1.5, [0.0, 0.01, 0.02, 0.04], [0.0], [50, 100, 200], TOLERANCE)
    assert speed_over_solitary(found).value == pytest.approx(1.0, abs=1e-3)
    assert far_away(found, "height", 0.0).value > 1.75
    assert 0.3 < collapse(found, "height", 0.01, 200).value < 0.7
    settled = found.sel(gamma=0.04, ahead=0.0)
    exact = damp_weakly(1.5, [0.08, 0.04, 0.02, 0.01]).sel(gamma=0.04)
    assert float(settled["height"][-1]) == pytest.approx(1.0 + float(exact["overshoot"]), abs=1e-3)
    assert 0.04 * float(settled["zone"][-1]) == pytest.approx(float(exact["zone"]), rel=3e-3)
    assert float(settled["velocity_behind"]) == pytest.approx(1.0, abs=1e-5)
