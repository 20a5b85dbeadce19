"""Pulses behind an impact: their closed form, fronts beside exact ones, and measures."""

import doctest
import math

import numpy as np
import pytest
from by_hand import ANY, assert_measures, dataset, estimates
from scipy.integrate import solve_ivp

import impact_measures as measures
import impact_pulse
from granular_fronts.accuracy import tabulated
from granular_fronts.chain.measures import peak_decay
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.solitary_waves import solitary_wave
from impact_fronts import apart, follow_fronts, impact_scene
from impact_pulse import height_of_front, shape_of_pulse, share_of_momentum, time_of_front
from projects import assert_readme_shows_statements

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
    return follow_fronts([0.05, 0.3], [200, 400], [200], [0.2, 0.8], TOLERANCE)


@pytest.mark.slow
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


@pytest.mark.slow
def test_errors_of_fronts_bound_a_change_of_the_tolerance(fronts):
    coarse = {"relative": 1e-7, "absolute": 1e-10}
    changed = follow_fronts([0.05], [200], [200], [0.8], coarse).squeeze()
    fine = fronts.sel(gamma=0.05, contact=200, early_contact=200, part=0.8)
    for name in ("height", "damping", "overshoot", "one_pulse", "no_overshoot"):
        apart = tabulated(changed, name) - tabulated(fine, name)
        assert abs(apart.value) <= 2.0 * apart.error, name


@pytest.mark.slow
def test_pulses_cease_to_be_apart_where_their_front_ceases_to_overshoot(fronts):
    """Whatever part of the height counts, at nearly one damping."""
    critical = np.append(fronts["one_pulse"], fronts["no_overshoot"])
    assert critical.max() < 1.25 * critical.min()
    assert (np.diff(fronts["one_pulse"]) <= 0.0).all()


def test_two_maxima_are_apart_if_the_lower_is_high_enough():
    u = np.array([[0.0, 0.4, 0.1, 1.0, 0.0], [0.0, 0.1, 0.2, 1.0, 0.0]])
    assert apart(u, 0.3)
    assert not apart(u, 0.5)
    assert not apart(u[1:], 0.1)
    assert not apart(1e-4 * u, 0.3)


def test_an_undamped_impact_makes_a_solitary_wave():
    """Of its own height, as another module computes it, and without decay."""
    scene = impact_scene(0.0, [100], TOLERANCE) | {"end_time": 150.0, "beads": 130}
    scene["record"] = {"snapshots": [150.0], "arrival_level": 0.01, "extremes": True}
    motion = simulate_chain(scene, "impact")
    assert measures.speed_of_primary(motion, 60).value == pytest.approx(1.0, abs=1e-4)
    assert abs(peak_decay(motion, 60, 100).value) < 1e-6


def test_the_example_holds():
    found = doctest.testmod(impact_pulse)
    assert found.failed == 0 < found.attempted


HEIGHT = solitary_wave(1.5).u.max()
# The primary peak falls by e², the secondary by e; at t = 1 the first is between two beads.
BEADS = np.arange(1.0, 41.0)
PEAKS_AT = [[(35.0, -1.0), (20.0, -2.0)], [(38.25, -3.0), (22.0, -3.0)]]
MOTION_AT = {"t": [0.0, 1.0], "bead": BEADS}
PULSES = dataset(
    velocity=(MOTION_AT, [sum(np.exp(h - (BEADS - n) ** 2) for n, h in two) for two in PEAKS_AT]),
    relative_displacement=(MOTION_AT, [np.where(BEADS > 1.0, 1 / 16, -1.0)] * 2),
    first_peak=({"bead": BEADS}, np.full(40, 16.0 * HEIGHT)),
    first_peak_time=({"bead": BEADS}, BEADS / 4.0),
)
FRONT_AT = {"gamma": [0.3], "contact": [100]}
FRONT = estimates(
    height=(FRONT_AT, [[4.0]]),
    height_of_momentum=(FRONT_AT, [[5.0]]),
    overshoot=(FRONT_AT, [[0.3]]),
    exact_overshoot=(FRONT_AT, [[0.1]]),
    one_pulse=({"part": [0.5]}, [0.6]),
    no_overshoot=({"early_contact": [200]}, [0.5]),
)
ONE, BOTH = {"gamma": 0.3, "contact": 100}, {"part": 0.5, "contact": 200}
SOUND = math.sqrt(1.5) / 2


@pytest.mark.parametrize(
    ("measure", "data", "arguments", "value", "error"),
    [
        # At 16 times the height of the wave of speed 1 a wave has the speed 2; the pulse has 4.
        (measures.speed_of_primary, PULSES, {"contact": 20}, 2.0, ANY),
        (measures.persistence, PULSES, {"early": 0.0, "late": 1.0}, 2.0, 0.0625),
        (measures.sound_behind, PULSES, {"time": 0.0, "contact": 2}, SOUND, 4e-3 * SOUND),
        (measures.sound_behind, PULSES, {"time": 0.0, "contact": 1}, 0.0, 0.0),
        (measures.one_pulse_over_no_overshoot, FRONT, BOTH, 1.2, 2.2e-3 / 0.5),
        (measures.overshoot_less_exact, FRONT, ONE, 0.2, 2e-3),
        (measures.height_over_theory, FRONT, ONE, 0.8, 1.8e-3 / 5),
    ],
)
def test_measure_is_what_follows_by_hand(measure, data, arguments, value, error):
    assert_measures(measure, data, arguments, value, error)


# The whole project is run.
@pytest.mark.nightly
def test_the_page_shows_what_is_computed(tmp_path):
    assert_readme_shows_statements("rosas_2007", tmp_path)
