"""Pulses behind an impact: their closed form, fronts and exact ones, the end of separation."""

import doctest
import json
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.studies import impact_measures as measures
from granular_fronts.studies import impact_pulse, impact_separation
from granular_fronts.studies.impact_fronts import follow_fronts, impact_scene
from granular_fronts.studies.impact_pulse import (
    height_of_front,
    shape_of_pulse,
    share_of_momentum,
    time_of_front,
)
from granular_fronts.studies.impact_separation import count_pulses, find_separation, separates

TOLERANCE = {"relative": 1e-10, "absolute": 1e-13}
ALPHAS = pytest.mark.parametrize("alpha", [1.1, 1.5, 2.0, 3.0])


@ALPHAS
def test_the_pulse_conserves_momentum_and_length(alpha):
    """Both conservation laws, by differences along w of the closed form."""
    w = np.array([1.2, 2.0, 5.0, 30.0])
    z, U, V = shape_of_pulse(alpha, w)
    ahead, behind = (shape_of_pulse(alpha, w * (1.0 + sign * 1e-5)) for sign in (1, -1))
    slopes = [
        (one - other) / (ahead[0] - behind[0]) for one, other in zip(ahead, behind, strict=True)
    ]
    # v_t + (u^α)_n = 0 and u_t + v_n = 0 with δ ∝ N^(−2/(α+1)), c δ ∝ 1/N.
    np.testing.assert_allclose(z * V, U**alpha, rtol=1e-14)
    strain = 2.0 / (alpha + 1.0) * U + z * slopes[1]
    np.testing.assert_allclose(slopes[2], strain, rtol=1e-7)
    assert [float(one) for one in shape_of_pulse(alpha, 1.0)] == pytest.approx([1.0, 1.0, 1.0])


@ALPHAS
def test_its_momentum_agrees_with_an_integration_of_the_equation(alpha):
    """An independent method: the pulse as an initial-value problem from its front."""
    a = 2.0 / (alpha + 1.0)

    def slopes(logarithm, state):
        w = math.exp((alpha - 1.0) * state[0] - 2.0 * logarithm)
        return [(a + w) / (alpha * w - 1.0), math.exp(alpha * state[0])]

    settings = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
    found = solve_ivp(slopes, [0.0, -60.0], [0.0, 0.0], **settings)
    assert -found.y[1, -1] == pytest.approx(share_of_momentum(alpha), rel=1e-9)


def test_the_front_moves_with_the_speed_of_its_height():
    places = 300.0 * (1.0 + 1e-6 * np.array([-1.0, 1.0]))
    speed = np.diff(places) / np.diff(time_of_front(1.5, places, 1.0))
    assert speed == pytest.approx(height_of_front(1.5, 300.0, 1.0) ** 0.25, rel=1e-9)


@pytest.fixture(scope="module")
def fronts():
    return follow_fronts(1.5, [0.05, 0.3], [200, 400], TOLERANCE)


def test_fronts_approach_those_of_the_closed_form_and_exact_ones(fronts):
    """Neither the pulse nor the exact front knows anything of the chain; both become closer."""
    strong, weak = fronts.sel(gamma=0.3), fronts.sel(gamma=0.05)
    apart = abs(strong["height"] / strong["height_of_momentum"] - 1.0)
    assert (apart < 0.005).all()
    for one in (strong, weak):
        distance = abs(one["overshoot"] - one["exact_overshoot"]).values
        assert distance[1] < 0.7 * distance[0] < 0.07
    assert (weak["overshoot"] > 0.15).all()
    assert (strong["overshoot"] < 0.0).all()


def test_errors_of_fronts_bound_a_change_of_the_tolerance(fronts):
    coarse = follow_fronts(1.5, [0.05], [200], {"relative": 1e-7, "absolute": 1e-10})
    for name in ("height", "damping", "overshoot"):
        exact = float(fronts[name].sel(gamma=0.05, contact=200))
        found = measures.tabulated(coarse.isel(gamma=0, contact=0), name)
        assert abs(found.value - exact) <= 2.0 * found.error + 2.0 * float(
            fronts[f"{name}_error"].max()
        )


def test_a_weakly_damped_primary_pulse_loses_what_its_contacts_dissipate():
    """The distance to the limit is proportional to γ."""
    distances = []
    for gamma in (0.01, 0.005):
        scene = impact_scene(1.5, gamma, [100], TOLERANCE) | {"end_time": 150.0, "beads": 130}
        scene["record"] = {"snapshots": [150.0], "arrival_level": 0.01, "extremes": True}
        motion = simulate_chain(scene, "impact")
        motion.attrs["config"] = json.dumps(scene)
        distances.append(1.0 - measures.loss_of_primary(motion, 60, 100).value)
        assert measures.speed_of_primary(motion, 60).value == pytest.approx(1.0, abs=0.01)
        assert measures.decay_of_primary(motion, 60, 100).value > 0.0
    assert distances[0] / distances[1] == pytest.approx(2.0, abs=0.15)
    assert distances[1] < 0.03


@pytest.mark.parametrize("module", [impact_pulse, impact_separation])
def test_examples_give_what_they_show(module):
    found = doctest.testmod(module)
    assert found.failed == 0 < found.attempted


def test_pulses_are_counted():
    assert count_pulses(np.array([0.0, 1.0, 0.2, 0.4, 0.0])) == 1
    assert count_pulses(np.array([0.0, 1.0, 0.2, 0.5, 0.0])) == 2
    assert count_pulses(np.array([0.0, 0.5, 1.0, 0.5, 0.0])) == 1


def test_pulses_separate_below_one_damping():
    settings = 150, 140.0, 1.0, TOLERANCE
    found = find_separation(1.5, [0.06, 0.3], 0.004, *settings)
    damping, error = (
        float(found[name]) for name in ("separating_damping", "separating_damping_error")
    )
    assert error < 0.005
    assert separates(1.5, damping - 2.0 * error, *settings)
    assert not separates(1.5, damping + 2.0 * error, *settings)
    with pytest.raises(ValueError, match=r"separate at 0\.2 alone"):
        find_separation(1.5, [0.2, 0.3], 0.004, *settings)
