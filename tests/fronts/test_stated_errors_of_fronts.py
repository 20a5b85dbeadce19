"""Stated errors of fronts, and what they follow from."""

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.fronts.solve import FIELDS


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


def test_errors_scale_with_the_jump():
    """With β = (α + 1)/2 fronts of all sizes have one shape, and the same relative errors."""
    law = powers(1.5, 1.25, 0.3)
    large, small = (gf.solve_front(law=law, states=(-size, 0.0)) for size in (1.0, 1e-3))
    for name in FIELDS:
        large_error, small_error = (front[name].attrs["error_estimate"] for front in (large, small))
        scale = 1e-3 ** (1.25 if name == "velocity" else 1.0)
        assert small_error == pytest.approx(scale * large_error, rel=0.5)
