"""Polynomials in θ, constant coefficient first: value, derivative, where one meets a level."""

import math

import numpy as np

from granular_fronts.numerics.compiled import kernel

MOST_ITERATIONS = 200

# After a Newton step this short the next one would be shorter than the last bit.
SHORT_STEP = 1.0e-9


@kernel
def polynomial(coefficients, theta):
    """Value of a polynomial, constant coefficient first."""
    value = 0.0
    for power in range(coefficients.size - 1, -1, -1):
        value = value * theta + coefficients[power]
    return value


@kernel
def crossing(coefficients, level):
    """A θ in [0, 1] where the polynomial meets `level`, to the last bit.

    Newton's method, kept inside a bracket that each value narrows; where it would leave the bracket
    the bracket is halved.  The polynomial must start on one side of the level and end on the other;
    where rounding keeps it from the level, the place is its end.
    """
    low, high, end = 0.0, 1.0, polynomial(coefficients, 1.0)
    rising = coefficients[0] < level
    theta = 0.5
    if end != coefficients[0]:
        theta = min(1.0, max(0.0, (level - coefficients[0]) / (end - coefficients[0])))
    for _ in range(MOST_ITERATIONS):
        value, slope = 0.0, 0.0
        for power in range(coefficients.size - 1, -1, -1):
            slope = slope * theta + value
            value = value * theta + coefficients[power]
        if (value > level) == rising:
            high = theta
        else:
            low = theta
        step = (level - value) / slope if slope != 0.0 else math.inf
        new = theta + step
        if low <= new <= high and abs(step) <= SHORT_STEP:
            return new
        if not low < new < high:
            new = 0.5 * (low + high)
            if not low < new < high:
                return new
        theta = new
    return theta


@kernel
def derivative(coefficients):
    """Coefficients of the derivative of a polynomial."""
    result = np.empty(coefficients.size - 1)
    for power in range(1, coefficients.size):
        result[power - 1] = power * coefficients[power]
    return result
