"""Values with their errors: refinement, rounding floor, propagation."""

import math

import numpy as np
import pytest
import xarray as xr

from granular_fronts.accuracy import (
    Estimate,
    certain_sign,
    largest_difference,
    rounded,
    sampled_maximum,
    variable_and_errors,
    with_refinement,
)
from granular_fronts.errors import NoFrontError


@pytest.mark.parametrize(
    ("values", "others", "error"),
    [
        ([1.0, -2.0], [1.25, -2.5], 0.5),
        ([0.0], [0.0], 0.0),
        ([], [], 0.0),
        # What one of them lacks does not count.
        ([1.0, math.nan], [1.5, 3.0], 0.5),
        ([math.nan], [math.nan], math.nan),
        # Where they agree, the last digit of the largest stands in.
        *(([-size, 0.0], [-size, 0.0], np.spacing(size)) for size in (1.0, 3.0e5, 2.0e-9)),
    ],
)
def test_error_is_the_largest_difference_of_two_computations(values, others, error):
    assert largest_difference(values, others) == pytest.approx(error, rel=0.0, abs=0.0, nan_ok=True)


def test_a_sign_is_certain_beyond_the_error_alone():
    values = [-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, math.nan]
    variable = xr.DataArray(values, attrs={"error_estimate": 1.0})
    assert certain_sign(variable).values.tolist() == [-1, 0, 0, 0, 0, 0, 1, 0]
    assert (certain_sign(variable.assign_attrs(error_estimate=math.nan)) == 0).all()


def trapezoidal(points):
    x = np.linspace(0.0, 1.0, points)
    return float(np.trapezoid(np.exp(x), x))


def test_difference_to_a_refinement_estimates_the_error():
    """Half the spacing: the error of the trapezoidal rule is 4/3 of the difference."""
    found = with_refinement(trapezoidal, 11, 21).estimate()
    true_error = abs(found.value - (math.e - 1.0))
    assert found.error == pytest.approx(0.75 * true_error, rel=1e-2)
    useless = with_refinement(trapezoidal, 11, 11).estimate()
    assert useless.error == np.spacing(useless.value) < 1e-12 * true_error


def test_failed_refinement_is_called_so_and_a_failed_solution_is_not():
    def solve(order):
        if order > 4:
            raise NoFrontError("no convergence at order 6")
        return order

    with pytest.raises(
        NoFrontError, match=r"^the refinement that should estimate the error failed"
    ):
        with_refinement(solve, 4, 6)
    with pytest.raises(NoFrontError, match=r"^no convergence"):
        with_refinement(solve, 6, 4)


CORNERS = [(x, y) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]


@pytest.mark.parametrize(
    "combine",
    [
        lambda a, b: a + b,
        lambda a, b: a - b,
        lambda a, b: a * b,
        lambda a, b: a / b,
        lambda a, b: np.float64(2.0) * a - b / 3.0,
        lambda a, b: 1.0 + -a * b,
        lambda a, b: b**-2.0 + (-a) ** 0.25,
    ],
)
def test_errors_propagate_to_first_order_in_the_worst_case(combine):
    """The corners of the box of errors lie within the estimate, and one of them on its edge."""
    a, b = Estimate(-3.0, 1e-7), Estimate(2.0, 2e-7)
    found = combine(a, b)
    assert isinstance(found, Estimate)
    assert found.value == combine(a.value, b.value)
    distances = [
        abs(combine(a.value + x * a.error, b.value + y * b.error) - found.value) for x, y in CORNERS
    ]
    assert max(distances) == pytest.approx(found.error, rel=1e-5)


def test_a_variable_states_the_largest_error_of_its_values_and_holds_each_beside_them():
    estimates = [Estimate(1.0, 0.5), Estimate(2.0, 0.25)]
    (dims, values, attributes), (_, errors, _) = variable_and_errors(
        "x", "n", estimates, "by hand", "place"
    ).values()
    assert (dims, values.tolist(), errors.tolist()) == ("n", [1.0, 2.0], [0.5, 0.25])
    assert attributes["error_estimate"] == 0.5
    assert attributes["error_method"] == "by hand"


def test_closed_formula_is_known_to_some_units_of_its_last_place():
    assert rounded(-3.0, units=4.0) == Estimate(-3.0, 4.0 * np.spacing(3.0))


@pytest.mark.parametrize("place", [0.0, 0.1, 0.25, 0.5])
def test_a_maximum_between_samples_is_the_vertex_of_a_parabola(place):
    """It exceeds them by h²/4 at most, the error; what is masked or at the ends has none beside."""
    x = np.linspace(-3.0, 3.0, 25)
    found = sampled_maximum(np.where(x < -2.0, np.nan, 1.0 - (x - place * 0.25) ** 2))
    assert found == pytest.approx((1.0, 0.25**2 / 4.0), rel=1e-12)
    assert sampled_maximum(x) == (3.0, 2.0**-51)
