"""How wrong a number computed twice is said to be."""

import numpy as np
import pytest

from granular_fronts.accuracy import error_attributes


def estimate(value, other):
    return error_attributes(np.array(value), np.array(other), "twice")["error_estimate"]


def test_error_is_the_largest_difference_of_two_computations():
    assert estimate([1.0, -2.0], [1.25, -2.5]) == 0.5


@pytest.mark.parametrize("size", [1.0, 3.0e5, 2.0e-9])
def test_last_digit_of_the_largest_stands_in_where_two_computations_agree(size):
    assert size + estimate([-size, 0.0], [-size, 0.0]) == np.nextafter(size, np.inf)


def test_zeros_and_no_values_at_all_have_no_error():
    assert estimate([0.0], [0.0]) == estimate([], []) == 0.0
