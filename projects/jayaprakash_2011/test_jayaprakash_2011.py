"""Dimers: waves that leave nothing behind, the attenuation of pulses, and both ladders."""

import math
import re

import numpy as np
import pytest
from by_hand import assert_measures, estimates
from scipy.integrate import simpson

import dimer_ratios as dimers
from dimer_ratios import crossing, find_wave, rates, solve_wave, spacing, times_of
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.output.datasets import read_dataset
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from projects import run_project

TOLERANCE = {"relative": 1e-10, "absolute": 1e-12}
CELLS = [20, 30, 40]


def equal_beads(points):
    """The solitary wave of equal beads, whose cells are two beads."""
    wave = solitary_wave(1.5, 32)
    return 16.0 * np.interp(2.0 * times_of(points) + 0.5, wave.xi, wave.u, left=0.0, right=0.0)


def test_equal_masses_carry_the_solitary_wave_of_equal_beads():
    """Newton's method finds ε = 1 from another ratio; another module knows the wave."""
    guess = equal_beads(32)
    wave = solve_wave(1.5, 0.95, guess, 32)
    assert wave.ratio == pytest.approx(1.0, abs=1e-13)
    np.testing.assert_allclose(wave.u, guess, atol=1e-9)


def test_a_guess_that_is_no_wave_is_refused():
    with pytest.raises(SolveError, match="begin at a ratio where the attenuation is smaller"):
        solve_wave(1.5, 0.34, 4.0 * np.exp(-0.6 * times_of(16) ** 2), 16)


@pytest.mark.parametrize(("near", "humps"), [(0.343, 2), (0.155, 3), (0.0901, 4)])
def test_the_chain_carries_a_wave_unchanged(near, humps):
    """Each contact of a chain that starts in the wave has its values m cells and m times later."""
    wave, ratio = find_wave(1.5, near, 40, TOLERANCE)
    assert abs(ratio.value - near) < 2e-3 * near
    points, cells, crossed = 48, 24, 12
    slope = np.fft.irfft(
        2j * np.pi * np.fft.rfftfreq(wave.u.size, 1.0 / points) * np.fft.rfft(wave.u), wave.u.size
    )
    whole = np.arange(wave.u.size) % points == 0
    u, rate = np.zeros((2, 2 * cells + 8))
    # At t = 0 the wave is around cell 4: u(4 − j) before and u(j − 4) behind the light bead.
    around = np.arange(1, 8)
    at = np.flatnonzero(whole)[around]
    for offset, sign in ((0, -1), (1, 1)):
        order = at[::-1] if sign < 0 else at
        u[2 * around + offset], rate[2 * around + offset] = wave.u[order], sign * -slope[order]
    velocity = np.append(np.cumsum(rate[::-1])[::-1], 0.0)
    scene = pressed_chain(
        kuwabara_kono(1.5, 0.0),
        {"count": u.size + 1, "mass": {"cell": [1.0, ratio.value]}},
        float(crossed),
        (1e-12, 1e-14),
        {"snapshots": [float(crossed)]},
        left=0.0,
        start=(u, velocity),
    )
    later = simulate_chain(scene)["relative_displacement"].values[0, :-1]
    np.testing.assert_allclose(later[2 * crossed :], u[: -2 * crossed], atol=1e-7 * u.max())
    peaks = (wave.u[1:-1] > wave.u[:-2]) & (wave.u[1:-1] > wave.u[2:])
    assert wave.u.min() > -1e-12 * wave.u.max()
    assert np.count_nonzero(peaks & (wave.u[1:-1] > 1e-3 * wave.u.max())) <= humps


def test_the_chain_alone_finds_the_second_antiresonance_again():
    _, ratio = find_wave(1.5, 0.343, 40, TOLERANCE)
    place = crossing(lambda root: rates(1.5, root**-2.0, CELLS, TOLERANCE)[1].value, 1.7, 0.05)
    assert abs(place.value**-2.0 - ratio.value) < 4.0 * place.error * place.value**-3.0
    assert place.error < 1e-3


def test_the_attenuation_does_not_depend_on_the_cells_nor_on_which_bead_is_light():
    """One rate for all cells, as the chain has no scale; 1/ε is ε with the beads exchanged."""
    early, late = rates(1.5, 0.8, CELLS, TOLERANCE)
    assert late.value == pytest.approx(early.value, rel=1e-4)
    assert rates(1.5, 1.25, CELLS, TOLERANCE)[1].value == pytest.approx(late.value, rel=1e-4)
    # A negative control: away from antiresonances the pulse is attenuated, with none it is not.
    assert abs(rates(1.5, 1.0, CELLS, TOLERANCE)[1].value) < 1e-9 < 1e-3 < late.value


def test_the_limit_of_the_spacing_is_that_of_the_compact_pulse():
    """Nesterenko's pulse cos⁴ has ∫ U^(1/4) in closed form; the true one is near."""
    compact = (25.0 / 16.0) ** 0.25 * 2.0 * np.sqrt(2.5)
    found = spacing(1.5)
    assert found.value == pytest.approx(np.pi / (np.sqrt(1.5) * compact), rel=0.15)
    # Another grid and another rule, up to where u is 1e-9.
    wave = solitary_wave(1.5, 48)
    within = wave.u > 1e-9
    area = simpson(wave.u[within] ** 0.25, wave.xi[within])
    assert abs(np.pi / (np.sqrt(1.5) * area) - found.value) < 2.0 * found.error < 2e-3


# At ε^(−1/2) of 1, 2 and 3, known to rounding, and between them.
DIMERS = estimates(
    antiresonance=({"order": [1, 2, 3]}, [1.0, 1 / 4, 1 / 9]),
    antiresonance_of_chain=({"order": [1, 2, 3]}, [1.0, 0.26, 1 / 9]),
    resonance=({"resonance_order": [1, 2]}, [1.5**-2, 2.75**-2]),
    resonance_attenuation=({"resonance_order": [1, 2]}, [0.2, 0.1 * math.log(2.0)]),
    spacing=({}, 1.25),
)
NOT_IN_TURNS = estimates(
    antiresonance=({"order": [1, 2, 3]}, [1.0, 1 / 4, 1 / 16]),
    resonance=({"resonance_order": [1]}, [1 / 9]),
)


@pytest.mark.parametrize(
    ("measure", "data", "arguments", "value", "error"),
    [
        (dimers.farthest_by_chain, DIMERS, {}, 10.0, 1.0),
        # A power α + 1 of the compression, in 4 cells: 2.5 · 4 · 0.1 ln 2.
        (dimers.energy_lost, DIMERS, {"order": 2, "cells": 4}, 0.5, 5e-3),
        (dimers.interlaced, DIMERS, {}, 0.25, 0.5e-3 * 2.75**3),
        (dimers.interlaced, NOT_IN_TURNS, {}, -1.0, 0.5e-3 * 3.0**3),
        (dimers.last_spacing, DIMERS, {}, 0.8, 0.8e-3 / 1.25),
    ],
)
def test_measure_is_what_follows_by_hand(measure, data, arguments, value, error):
    assert_measures(measure, data, arguments, value, error)


# The whole project is run.
@pytest.mark.nightly
def test_the_page_shows_what_is_computed(tmp_path):
    results, readme = run_project("jayaprakash_2011", tmp_path)
    rows = re.findall(r"^\| (\d) \| ([\d.]+) \| ([^|]+) \| ([^|]+) \|$", readme, re.MULTILINE)
    found = read_dataset(results / "data/jayaprakash_2011/ratios.nc")
    assert len(rows) == found.sizes["order"] == found.sizes["resonance_order"]
    for order, (_, exact, *others) in enumerate(rows):
        assert float(exact) == pytest.approx(float(found["antiresonance"][order]), abs=1e-14)
        for shown, name in zip(others, ("resonance", "resonance_attenuation"), strict=True):
            value, error = float(found[name][order]), float(found[f"{name}_error"][order])
            if "±" not in shown:
                assert float(shown.split(",")[0]) == pytest.approx(value, rel=5e-3)
                continue
            number, stated = map(float, shown.split(" ± "))
            assert number == pytest.approx(value, abs=stated)
            assert 0.9 * error <= stated <= 2.0 * error
