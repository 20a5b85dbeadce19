"""Pulses in cells of spheres: the theory of dimers against dispersion, limits and chains."""

import doctest
import math

import numpy as np
import pytest
from pages import ROOT
from scipy.integrate import solve_ivp

from granular_fronts.accuracy import tabulated
from granular_fronts.errors import SolveError
from granular_fronts.model.materials import body_of
from granular_fronts.scenes.yaml_files import read_yaml
from granular_fronts.studies import periodic_chains
from granular_fronts.studies.dimer_ratios import find_wave
from granular_fronts.studies.periodic_chains import (
    _pulse,
    fastest,
    growth_of_deviation,
    speed_of_pulse,
    stretch_of_dimer,
    strike_dimers,
    strike_spheres,
    width_over_theory,
)

TOLERANCE = {"relative": 1e-9, "absolute": 1e-11}


@pytest.mark.parametrize("ratio", [0.05, 0.3428, 0.8])
def test_the_stretch_is_that_of_the_dispersion_of_a_linear_dimer(ratio):
    """An independent way to the coefficient: the acoustic branch of the diatomic chain, α = 1."""
    q, sum_, product = 1e-2, 1.0 + 1.0 / ratio, 1.0 / ratio
    square = sum_ - math.sqrt(sum_**2 - 4.0 * product * math.sin(q) ** 2)
    # ω² = q²(1 − b² q²)/m̄ with b² = (1 + 3θ²)/12, q per bead.
    coefficient = (1.0 - square * 0.5 * (1.0 + ratio) / q**2) / q**2
    assert 12.0 * coefficient == pytest.approx(stretch_of_dimer(1.0, ratio) ** 2, rel=1e-3)
    found = doctest.testmod(periodic_chains)
    assert found.failed == 0 < found.attempted


def test_a_pulse_of_known_shape_is_read():
    times = np.linspace(0.0, 20.0, 2001)
    turn, largest, width = _pulse(times, 3.0 / np.cosh(times - 8.003) ** 2)
    assert (turn, largest) == pytest.approx((8.003, 3.0), rel=1e-7)
    assert width == pytest.approx(2.0 * math.acosh(math.sqrt(2.0)), rel=1e-7)
    # A second maximum counts where it exceeds half of the first.
    second = np.exp(-((times - 5.0) ** 2)) + 0.6 * np.exp(-((times - 12.0) ** 2))
    both = 2.0 * (math.sqrt(math.log(2.0)) + math.sqrt(math.log(1.2)))
    assert _pulse(times, second)[2] == pytest.approx(both, rel=1e-6)


def test_a_lost_pulse_is_refused():
    """The highest wave is another one from contact to contact."""
    cell = {"PTFE–nylon": ["ptfe 4.76 mm", "nylon 4.76 mm"]}
    with pytest.raises(SolveError, match=r"PTFE–nylon is lost before contact 120.*nearer"):
        strike_spheres(cell, 120, TOLERANCE)


@pytest.mark.slow
def test_a_dimer_agrees_with_scipy():
    """Another integrator, with velocities and positions instead of compressions."""
    ratio, contact = 0.27225, 100
    beads = contact + 40
    mass = np.where(np.arange(beads) % 2, ratio, 1.0)

    def slopes(_, state):
        x, v = np.split(state, 2)
        force = np.maximum(x[:-1] - x[1:], 0.0) ** 1.5
        return np.append(v, (np.append(0.0, force) - np.append(force, 0.0)) / mass)

    start = np.zeros(2 * beads)
    start[beads] = 1.0
    times = np.linspace(70.0, 120.0, 10001)
    settings = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-13, "t_eval": times}
    x = solve_ivp(slopes, [0.0, times[-1]], start, **settings).y[:beads]
    near = [contact - 1, contact, contact + 15, contact + 16]
    forces = np.maximum(x[near] - x[[one + 1 for one in near]], 0.0) ** 1.5
    peaks, heights, durations = np.array([_pulse(times, force) for force in forces]).T
    speed = 32.0 / (peaks[2:] - peaks[:2]).sum()
    found = strike_dimers([ratio], contact, TOLERANCE).isel(ratio=0)
    theory = speed_of_pulse([1.0, ratio], [1.0, 1.0], heights.mean())
    assert speed / theory == pytest.approx(float(found["speed_over_theory"]), rel=2e-7)
    assert speed / theory == pytest.approx(1.008002, abs=1e-6)
    width = speed * durations.mean() / float(found["width_of_equal_spheres"])
    assert width == pytest.approx(float(found["width"]), rel=1e-6)


@pytest.mark.slow
def test_stated_errors_bound_those_by_smaller_steps(monkeypatch):
    found = strike_dimers([0.02, 0.25], 200, TOLERANCE)
    monkeypatch.setattr(periodic_chains, "STEP", 0.025 / 8.0)
    finer = strike_dimers([0.02, 0.25], 200, {"relative": 1e-12, "absolute": 1e-14})
    for name in periodic_chains.READ:
        assert np.all(abs(found[name] - finer[name]) < found[f"{name}_error"])
    assert found["width_error"].max() < 2e-6


@pytest.mark.slow
def test_the_exact_wave_of_a_dimer_has_the_criteria_of_the_findings():
    """Newton's method instead of a chain; a cell, two beads, is passed in the time 1."""
    wave, _ = find_wave(1.5, 0.3428, 20, {"relative": 1e-9, "absolute": 1e-12})
    fine = 32 * wave.u.size
    u = np.fft.irfft(np.fft.rfft(wave.u), fine) * 32.0
    times = wave.t[0] + np.arange(fine) * (wave.t[1] - wave.t[0]) / 32.0
    _, force, duration = _pulse(times, np.maximum(u, 0.0) ** 1.5)
    speed = 2.0 / speed_of_pulse([1.0, wave.ratio], [1.0, 1.0], force)
    findings = read_yaml(ROOT / "papers/porter_2008/findings.yaml")
    exact = [one["criterion"] for one in findings if "the exact wave" in one["criterion"]]
    assert exact[0].startswith(f"{speed:.7f}")
    equal = periodic_chains._width_of_equal_spheres(128)
    assert exact[1].startswith(f"{2.0 * duration / equal:.7f}")


@pytest.mark.slow
def test_dimers_approach_the_theory_at_both_ends_and_nowhere_else():
    found = strike_dimers([0.01, 0.02, 0.3428, 0.95, 1.0], 120, TOLERANCE)
    between, alike, equal = (
        width_over_theory(found, ratio=ratio).value - 1.0 for ratio in (0.3428, 0.95, 1.0)
    )
    assert growth_of_deviation(found, 0.01, 0.02).value == pytest.approx(2.0, rel=0.02)
    assert between > 0.4
    assert abs(alike) < 1e-3
    assert equal == pytest.approx(0.0, abs=2e-6)
    assert fastest(found, 0.0).value < 1.01
    assert tabulated(found, "speed_over_theory", ratio=1.0).value == pytest.approx(1.0, abs=1e-6)


@pytest.mark.slow
def test_speeds_of_equal_spheres_are_those_of_their_material():
    """In SI units, and a dimer of one material and one size is no dimer."""
    words = "glass 8 mm"
    found = strike_spheres({"one": [words], "two": [words, words]}, 80, TOLERANCE)
    body = body_of(words)
    stiffness = 2.0 / 3.0 * 70.0e9 / (1.0 - 0.22**2) * math.sqrt(0.5 * body.radius)
    unit = 2.0 * body.radius * stiffness ** (1.0 / 3.0) / math.sqrt(body.mass)
    expected = unit * 1.4873593743**-0.25 * 10.0 ** (1.0 / 6.0)
    assert found["speed_at_10_newtons"].values == pytest.approx([expected, expected], rel=1e-5)
