"""A light intruder: the law of its frequency, scaling, stated errors, controls."""

import numpy as np
import pytest
from scipy.integrate import quad

from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.studies.light_intruder import (
    edge_of_spectrum,
    find_oscillations,
    frequency_at,
    power_of_force,
    power_of_size,
    ratio,
)

TOLERANCE = {"relative": 1e-9, "absolute": 1e-12}


def test_the_edge_of_the_spectrum_is_that_of_the_gaussian_for_alpha_near_1():
    """|F̂|² is a Gaussian of the variance 3(1 − 1/α), which has 99 % within 2.5758 deviations."""
    found = edge_of_spectrum(1.02, 0.99)
    assert found.value == pytest.approx(2.5758 * np.sqrt(3.0 * (1.0 - 1.0 / 1.02)), rel=0.01)


@pytest.mark.parametrize("share", [0.99, 0.999])
def test_the_edge_of_the_spectrum_agrees_with_adaptive_quadrature(share):
    wave = solitary_wave(1.5, 64)
    force = np.maximum(wave.u, 0.0) ** 1.5
    found = edge_of_spectrum(1.5, share)

    def energy(low, high):
        return quad(lambda k: (force @ np.cos(k * wave.xi)) ** 2, low, high, epsrel=1e-10)[0]

    whole = energy(0.0, 20.0)
    low, high = (
        energy(0.0, found.value + sign * found.error) - share * whole for sign in (-1.0, 1.0)
    )
    assert low < 0.0 < high
    wide = energy(0.0, found.value + 10.0 * found.error) - share * whole
    assert high - low > 0.1 * (wide - low)


@pytest.mark.parametrize("late", [0.0, 0.03])
def test_the_frequency_at_a_time_is_the_slope_of_the_phase(late):
    """Of the phase 20t − t³/3; zeros in one direction that come late are covered by the error."""
    times = np.linspace(-2.5, 2.5, 100_001)
    zeros = np.interp(np.arange(-13, 14) * np.pi, 20.0 * times - times**3 / 3.0, times)
    zeros[::2] += late
    for time in (-0.11, 0.0, 0.2):
        found = frequency_at(time, zeros)
        assert abs(found.value - (20.0 - time**2)) < found.error + 1e-3
        assert (found.error > 0.1) == (late > 0.0)


@pytest.mark.slow
def test_the_chain_has_the_frequency_of_the_law_within_the_mass_and_the_stated_error():
    sizes = np.linspace(0.15, 0.6, 19).round(3).tolist()
    found = find_oscillations(1.5, sizes, [1], TOLERANCE)
    for size in sizes:
        over_law = ratio(found, "frequency", "law", size)
        assert abs(over_law.value - 1.0) < over_law.error
        assert over_law.error < size**3
    # A negative control: the law of a size that is 2 % larger.
    wrong = find_oscillations(1.5, [1.02 * sizes[0]], [1], TOLERANCE)
    law = wrong["law"].item() / found["law"].values[0, 0]
    assert abs(law - 1.0) > sizes[0] ** 3


@pytest.mark.slow
def test_frequencies_scale_with_the_speed_of_the_wave():
    found = find_oscillations(1.5, [0.25, 0.5], [1, 2], TOLERANCE)
    for name in ("frequency", "law"):
        slow, fast = found[name].values
        np.testing.assert_allclose(fast, 2.0 * slow, rtol=1e-7)
    assert power_of_force(found, 0.5).value == pytest.approx(1.0 / 6.0, abs=1e-8)
    assert power_of_size(found, 0.25, 0.5).value < -1.0


@pytest.mark.slow
@pytest.mark.parametrize("alpha", [1.5, 2.0])
def test_stated_errors_of_the_law_are_those_to_a_finer_run(alpha):
    found, finer = (
        find_oscillations(alpha, [0.2, 0.3, 0.5], [1], {"relative": one, "absolute": 1e-3 * one})
        for one in (1e-9, 1e-12)
    )
    largest, stated = abs(found["law"] - finer["law"]).max(), found["law_error"].max()
    assert 0.5 * largest < stated < 10.0 * largest
    assert np.all(abs(found["frequency"] - finer["frequency"]) < 1e-3 * found["frequency_error"])


@pytest.mark.slow
def test_an_intruder_that_is_hardly_lighter_does_not_exceed_the_spectrum():
    """A negative control at size 0.8, where the law is below the edge of 99 %."""
    found = find_oscillations(1.5, [0.5, 0.8], [1], TOLERANCE)
    assert ratio(found, "law", "edge", 0.8).value < 1.0
    light = ratio(found, "frequency", "edge", 0.5, 0.999)
    assert light.value - light.error > 1.0
