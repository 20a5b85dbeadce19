"""A light intruder: the law of its frequency, scaling, stated errors, controls."""

import numpy as np
import pytest

from granular_fronts.studies.light_intruder import (
    edge_of_spectrum,
    find_oscillations,
    least_over_edge,
    power_of_force,
    ratio,
)

TOLERANCE = {"relative": 1e-9, "absolute": 1e-12}


def test_the_edge_of_the_spectrum_is_that_of_the_gaussian_for_alpha_near_1():
    """|F̂|² is a Gaussian of the variance 3(1 − 1/α), which has 99 % within 2.5758 deviations."""
    found = edge_of_spectrum(1.02)
    assert found.value == pytest.approx(2.5758 * np.sqrt(3.0 * (1.0 - 1.0 / 1.02)), rel=0.01)


@pytest.mark.slow
def test_the_chain_tends_to_the_law_and_scales_exactly():
    sizes = [0.2, 0.3, 0.4, 0.5]
    found = find_oscillations(1.5, sizes, [1, 2], TOLERANCE)
    apart = [abs(ratio(found, "frequency", "law", size).value - 1.0) for size in sizes]
    assert np.all(np.diff(apart) > 0.0)
    assert apart[0] < 3e-4
    for name, power in (("frequency", 1), ("before", 4), ("force_after", 6), ("law", 1)):
        slow, fast = (found[name].sel(speed=speed).values for speed in (1, 2))
        error = found[f"{name}_error"].sel(speed=2).values
        assert np.all(abs(fast - 2.0**power * slow) < 4.0 * error + 1e-12 * fast), name
    assert power_of_force(found, 0.5).value == pytest.approx(1.0 / 6.0, abs=1e-8)
    enhanced = [ratio(found, "after", "before", size).value for size in sizes]
    assert np.all(np.diff(enhanced) < 0.0)
    assert ratio(found, "force_after", "force_before", 0.5).value < 1.0


@pytest.mark.slow
@pytest.mark.parametrize("alpha", [1.5, 2.0])
def test_stated_errors_are_those_to_a_finer_run(alpha):
    found, finer = (
        find_oscillations(alpha, [0.2, 0.3, 0.5], [1], {"relative": one, "absolute": 1e-3 * one})
        for one in (1e-9, 1e-12)
    )
    for name in ("frequency", "law", "before", "after", "force_before", "force_after"):
        assert np.all(abs(found[name] - finer[name]) <= 2.0 * found[f"{name}_error"]), name


@pytest.mark.slow
def test_an_intruder_that_is_hardly_lighter_does_not_exceed_the_spectrum():
    """A negative control, in which its contacts do not close again either."""
    found = find_oscillations(1.5, [0.8], [1], TOLERANCE)
    assert least_over_edge(found).value < 1.0
    assert found["after"].item() == 0.0
