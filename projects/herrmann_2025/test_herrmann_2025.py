"""Overdamped fronts: rates with their errors, the limit, and measures."""

import numpy as np
import pytest
from by_hand import assert_measures, estimates
from scipy.integrate import quad

import overdamped_fronts as overdamped
from projects import assert_readme_shows_statements


@pytest.mark.parametrize(("level", "power"), [overdamped.BEHIND, overdamped.AHEAD])
def test_a_rate_errs_as_it_says(level, power):
    xi = np.arange(0.0, 40.0, 0.01)
    found = overdamped.decay(
        xi, np.exp(-0.7 * xi) * (1.0 + np.exp(-0.7 * power * xi)), level, power
    )
    assert 0.5 * found.error < abs(found.value - 0.7) < 2.0 * found.error


@pytest.mark.parametrize("gamma", [0.5, 3.0])
def test_overdamped_fronts_fall_with_the_rates_of_their_roots(gamma):
    rise, width, *rates = overdamped.look_at(gamma)
    assert rise.value <= rise.error
    assert width.value == pytest.approx(1.0, abs=0.02 / gamma**2)
    for rate, root in zip(rates, overdamped.roots(gamma).values(), strict=True):
        assert 0.5 * rate.error < abs(rate.value - root) < 2.0 * rate.error


def test_a_front_below_the_critical_damping_rises(monkeypatch):
    monkeypatch.setattr(overdamped, "decay", lambda *tail: None)
    rise = overdamped.look_at(0.3)[0]
    assert rise.value > 0.0136511375253008, "what docs/certificates/dashpots.npz proves"


def test_the_limit_obeys_its_equation():
    """γ u' = u^α − u, integrated from u = 0.1 to 0.9."""
    width, _ = quad(lambda u: 2.0 / (u - u**1.5), 0.1, 0.9)
    assert overdamped.width_of_limit(2.0) == pytest.approx(width, rel=1e-12)


def damping_of_rate(rate):
    """Return γ whose tail behind decays with a rate: α (1 − γλ/α)(2 cosh λ − 2) = λ², α = 3/2."""
    return (1.5 - rate**2 / (2.0 * np.cosh(rate) - 2.0)) / rate


GAMMAS = [damping_of_rate(1.0), damping_of_rate(0.5)]
FRONTS = estimates(
    rise=({"gamma": GAMMAS}, [0.1, 0.2]),
    width=({"gamma": GAMMAS}, [0.4, 0.1]),
    behind=({"gamma": GAMMAS}, [1.04, 0.49]),
).assign_coords(certificate=[0.3, GAMMAS[0]])


@pytest.mark.parametrize(
    ("measure", "arguments", "value", "error"),
    [
        (overdamped.largest_rise, {}, 0.2, 1e-3),
        (overdamped.over_root, {"tail": "behind"}, 1.04, 1e-3),
        (overdamped.width_where_proved, {}, 0.4, 1e-3),
    ],
)
def test_measure_is_what_follows_by_hand(measure, arguments, value, error):
    assert_measures(measure, FRONTS, arguments, value, error)


# It proves fronts, for twenty seconds.
@pytest.mark.nightly
def test_the_page_shows_what_is_computed(tmp_path):
    assert_readme_shows_statements("herrmann_2025", tmp_path)
