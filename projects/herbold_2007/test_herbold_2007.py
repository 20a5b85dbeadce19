"""Fronts with linear dashpots: the long-wave tail, the settling width, and measures."""

import numpy as np
import pytest
from by_hand import assert_measures, estimates

import steady_shocks as shocks
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import evaluate_front, solve_front
from projects import assert_readme_shows_statements


@pytest.mark.parametrize("alpha", [1.01, 1.5, 3.0])
def test_at_the_critical_damping_the_long_wave_tail_has_a_double_root(alpha):
    """And for α → 1 it is that of the chain."""
    gamma = shocks.long_wave_critical_damping(alpha)
    first, second = np.roots([alpha / 12.0, -gamma, alpha - 1.0])
    assert first == pytest.approx(second, rel=1e-6)
    assert (alpha > 1.01) or gamma == pytest.approx(critical_damping(alpha, 1.0), rel=0.01)


def settling_width(gamma, level):
    """From u = ε to where u stays within ε of 1, on a fine grid."""
    xi = np.arange(-60.0, 20.0, 1e-3)
    u = evaluate_front(solve_front(1.5, gamma, 1.0), xi)
    return xi[u > level].max() - xi[abs(u - 1.0) > level].min()


@pytest.mark.parametrize("level", [0.1, 1e-3])
def test_the_settling_width_is_least_where_the_overshoot_is_its_level(level):
    critical = critical_damping(1.5, 1.0)
    least = shocks.overshooting(level, critical)
    before, at, after = (settling_width(least * part, level) for part in (0.999, 1.001, 1.02))
    assert before > at + 0.2
    assert at < after < settling_width(critical, level)


# Peaks are far from that of the front up to contact 2, or 3.
SHOCKS = estimates(
    {"critical_damping": 0.4},
    width=({"gamma": [0.1, 0.4, 0.5]}, [1.5, 3.0, 4.0]),
    least_settling=({"level": [0.1]}, [0.3]),
    transient=({"contact": [1, 2, 3, 4]}, [-0.2, -0.06, 0.02, 0.005]),
    pulse=({}, 4.0),
)


@pytest.mark.parametrize(
    ("measure", "arguments", "value", "error"),
    [
        (shocks.width_over_least, {}, 2.0, 3e-3 / 1.5),
        (shocks.least_settling_over_critical, {"level": 0.1}, 0.75, 1e-3 / 0.4),
        (shocks.travelled, {"within": 0.05}, 0.75, 0.75e-3 / 4.0),
        (shocks.travelled, {"within": 0.01}, 1.0, 1e-3 / 4.0),
    ],
)
def test_measure_is_what_follows_by_hand(measure, arguments, value, error):
    assert_measures(measure, SHOCKS, arguments, value, error)


def test_long_waves_over_the_chain():
    assert shocks.long_wave_over_exact(SHOCKS).value == pytest.approx(1.25, rel=1e-14)


@pytest.mark.slow
def test_the_page_shows_what_is_computed(tmp_path):
    assert_readme_shows_statements("herbold_2007", tmp_path)
