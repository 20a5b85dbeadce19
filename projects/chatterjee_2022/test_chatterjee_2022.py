"""A ball on a plate: its first order, its guard, and measures of published points."""

import numpy as np
import pytest
from by_hand import assert_measures, estimates
from scipy.integrate import quad
from scipy.special import beta as euler_beta

import ball_on_plate as balls
from granular_fronts.errors import InputError
from granular_fronts.model.collision import damping_for_restitution
from projects import assert_readme_shows_statements

TOLERANCE = {"relative": 1e-12, "absolute": 1e-14}
LAWS = [
    {"alpha": alpha, "beta": beta}
    for alpha, beta in ((1.5, 1.0), (1.5, 1.25), (1.5, 1.5), (1.5, 2.5), (1.0, 1.0))
]


@pytest.mark.parametrize("law", LAWS)
def test_the_first_order_is_the_loss_on_the_undamped_path(law):
    """By quadrature over the velocity, and by the slope of the exact collision."""
    alpha, beta = law["alpha"], law["beta"]

    def lost(angle):
        """∫ x^(β − 1) ẋ dx with ẋ = cos θ, x^(α + 1) = (α + 1)/2 sin² θ."""
        x = (0.5 * (alpha + 1.0) * np.sin(angle) ** 2) ** (1.0 / (alpha + 1.0))
        return np.cos(angle) ** 2 * np.sin(angle) * x ** (beta - 1.0 - alpha)

    area = quad(lost, 0.0, 0.5 * np.pi, epsabs=1e-13)[0]
    slope = balls.slope_at_rest(law)
    assert balls.first_order(**law) == pytest.approx(2.0 * beta * area, rel=1e-9)
    assert abs(slope.value - balls.first_order(**law)) <= slope.error < 1e-7


@pytest.mark.parametrize("law", LAWS)
def test_a_light_load_adds_what_the_toolbox_says(law):
    """e = 1 − γ(C₀ + g C₁ + …), with C₁ in closed form, Chatterjee et al. (2022)."""
    alpha, beta = law["alpha"], law["beta"]
    gamma, load = 1e-4, 1e-3
    free, pressed = (balls.fall(law, g, gamma, TOLERANCE).value for g in (0.0, load))
    power = (beta - alpha) / (alpha + 1.0)
    of_load = beta * (0.5 * (alpha + 1.0)) ** power * euler_beta((beta + 1.0) / (alpha + 1.0), 0.5)
    assert (1.0 - free) / gamma == pytest.approx(balls.first_order(**law), rel=1e-3)
    assert (free - pressed) / (gamma * load) == pytest.approx(of_load, rel=0.01)


def test_a_ball_that_is_not_in_flight_is_refused():
    for load, gamma in ((0.1, 3.0), (3.0, 0.1)):
        with pytest.raises(InputError, match=f"load {load:g} .* lower load or damping"):
            balls.fall(LAWS[0], load, gamma, TOLERANCE)


# Two laws, two dampings; one point is published.
PLACES = {"law": ["a", "b"], "load": [0.0, 0.05], "damping": [0.1, 0.2]}
E = np.array([[[0.8, 0.7], [0.75, 0.65]], [[0.9, 0.85], [0.88, 0.83]]])
PUBLISHED = np.where(E == 0.75, 0.76, np.nan)
WITHOUT_LOAD = {"law": PLACES["law"], "damping": PLACES["damping"]}
FALLS = estimates(
    restitution=(PLACES, E),
    published=(PLACES, PUBLISHED),
    two_beads=(WITHOUT_LOAD, E[:, 0] - [[0.0, 0.0], [0.02, 0.0]]),
    slope=({"law": PLACES["law"]}, [2.0, 1.6]),
    first_order=({"law": PLACES["law"]}, [2.0, 1.25]),
)
# R^(1/2) = 1/4, so that the stiffness is the mass: γ₀ = γ.
STEEL = {"restitution": 0.9, "velocity": 1.0, "radius": 1 / 16, "mass": 1.0, "modulus": 3.0}
FIRST = 0.43802446 * 0.1


@pytest.mark.parametrize(
    ("measure", "arguments", "value", "error"),
    [
        (balls.farthest_from_published, {}, 0.01, 1e-3),
        (balls.farthest_from_two_beads, {}, 0.02, 2e-3),
        (balls.farthest_from_first_order, {}, 0.28, 1e-3 / 1.25),
    ],
)
def test_measure_is_what_follows_by_hand(measure, arguments, value, error):
    assert_measures(measure, FALLS, arguments, value, error)


def test_the_steel_of_the_first_order():
    """By its inverse: at the exact damping for e the exact e would be e itself."""
    assert balls.viscous_time(FALLS, **STEEL).value == pytest.approx(FIRST, rel=1e-7)
    # On a plate the same damping counts as less by 2^(2/5).
    for plate, factor in ((False, 1.0), (True, 2.0**-0.4)):
        e = balls.restitution_of_first_order(FALLS, 0.9, plate).value
        assert damping_for_restitution(e) == pytest.approx(factor * FIRST, rel=1e-7)


@pytest.mark.slow
def test_the_page_shows_what_is_computed(tmp_path):
    assert_readme_shows_statements("chatterjee_2022", tmp_path)
