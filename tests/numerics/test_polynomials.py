"""Where a polynomial meets a level."""

import numpy as np
import pytest

from granular_fronts.numerics.polynomials import crossing, derivative, polynomial

RANDOM = np.random.default_rng(5)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_crossing_is_a_root_to_the_last_bits(sign):
    for coefficients in RANDOM.normal(size=(50, 8)):
        level = 0.5 * (coefficients[0] + coefficients.sum())
        theta = crossing(sign * coefficients, sign * level)
        shifted = np.polynomial.Polynomial(coefficients) - level
        roots = shifted.roots()
        inside = roots.real[np.abs(roots.imag) < 1e-12]
        slope = np.abs(shifted.deriv()(theta))
        assert 0.0 <= theta <= 1.0
        assert np.abs(inside - theta).min() < 1e-14 * (1.0 + np.abs(coefficients).sum() / slope)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_level_that_rounding_keeps_out_of_reach_is_met_at_the_end(sign):
    """The value at 1 falls short of the level by one unit of its last place."""
    coefficients = sign * np.array([0.0, 0.5, 0.5 - 2.0**-53])
    assert abs(polynomial(coefficients, 1.0)) < 1.0
    assert crossing(coefficients, sign) == 1.0


def test_derivative_is_exact():
    coefficients = RANDOM.integers(-9, 9, size=8).astype(float)
    expected = np.polynomial.Polynomial(coefficients).deriv().coef
    np.testing.assert_array_equal(derivative(coefficients), expected)
