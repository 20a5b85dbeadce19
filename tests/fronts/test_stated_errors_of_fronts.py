"""Stated errors of fronts, against solutions of another program."""

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.fronts.solve import FIELDS
from truth import fronts, hold


def powers(alpha, beta, gamma):
    return {
        "elastic": {"kind": "hertz", "alpha": alpha},
        "viscous": {"kind": "power", "beta": beta, "gamma": gamma},
    }


FRONTS = {
    "long": (powers(2.0, 2.0, 6.0), (-1.0, -0.39)),
    "weakly nonlinear": (powers(1.024, 1.024, 0.02), (-1.0, 0.0)),
    "sharp": (powers(4.42, 1.54, 4.89), (-1.0, 0.0)),
    "toda": (
        {"elastic": {"kind": "toda", "rate": 2.6}, "viscous": {"kind": "linear", "gamma": 6.53}},
        (-1.84, 0.43),
    ),
}


def test_errors_of_fronts_and_of_their_measures_hold():
    """Each number by itself; whether errors are wide is judged by the median of all of them."""
    together = []
    for law, states in FRONTS.values():
        front = gf.solve_front(law=law, states=states)
        found = list(fronts.compare(front, law, *states, np.random.default_rng(3)))
        assert len(found) == 8
        # The same judge sees an error that is a hundred times too small.
        assert not hold([(word, 0.01 * stated, *numbers) for word, stated, *numbers in found])
        together += found
    assert hold(together)


def test_reference_knows_the_dissipated_power():
    """(α − 1)/(2(α + 1)), eq. (16), to more digits than a double has."""
    law = powers(1.5, 1.0, 0.4)
    front = gf.solve_front(law=law, states=(-1.0, 0.0))
    power = fronts.TrueFront(front, law, -1.0, 0.0).measures()["dissipated_power"]
    assert abs(power - fronts.Number(1) / 10) < 2e-18


@pytest.mark.parametrize("name", FRONTS)
def test_errors_of_measures_follow_from_that_of_the_strain(name):
    """An error η of the strain moves levels by η/|R'| and slopes by η/(4h), or more."""
    law, states = FRONTS[name]
    solved = gf.solve_front(law=law, states=states)
    front, strain = solved.attrs, solved["strain"]
    error = front["error_estimate"] * (1.0 - 1e-12)
    assert front["overshoot_error"] >= error
    way = ((strain - strain[-1]) / (strain[0] - strain[-1])).values
    slopes = np.abs(np.gradient(strain, strain["xi"]))
    flattest = min(slopes[np.flatnonzero(way >= level)[-1]] for level in (0.1, 0.9))
    assert front["width_10_90_error"] >= 0.99 * error / flattest
    assert front["slope_error"] >= 0.25 * error / front["spacing"]


@pytest.mark.parametrize("alpha", [1.5, 3.0])
def test_errors_of_a_sweep_hold(alpha):
    """Each refined front starts from the front that it judges, and finds its error all the same."""
    gammas = np.geomspace(0.05, 1.5, 41)
    sweep, found = gf.sweep_fronts(alpha, gammas), []
    for k in range(0, gammas.size, 10):
        law = powers(alpha, alpha, float(gammas[k]))
        front = gf.solve_front(law=law, states=(-1.0, 0.0))
        for name, value in fronts.TrueFront(front, law, -1.0, 0.0).measures().items():
            stated, error = float(sweep[f"{name}_error"][k]), abs(sweep[name].values[k] - value)
            found.append((name, stated, float(error), float(abs(value)), 1))
    assert hold(found)
    assert not hold([(name, 0.01 * stated, *numbers) for name, stated, *numbers in found])


def test_errors_scale_with_the_jump():
    """With β = (α + 1)/2 fronts of all sizes have one shape, and the same relative errors."""
    law = powers(1.5, 1.25, 0.3)
    large, small = (gf.solve_front(law=law, states=(-size, 0.0)) for size in (1.0, 1e-3))
    for name in FIELDS:
        large_error, small_error = (front[name].attrs["error_estimate"] for front in (large, small))
        scale = 1e-3 ** (1.25 if name == "velocity" else 1.0)
        assert small_error == pytest.approx(scale * large_error, rel=0.5)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [11, 12])
def test_errors_of_random_fronts_hold(seed):
    assert hold(fronts.cases(seed, 40), 0.995)
