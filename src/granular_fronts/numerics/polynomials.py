"""Polynomials in θ, constant coefficient first: value, derivative, where one meets a level."""

import math

import numpy as np

from granular_fronts.numerics.compiled import kernel

MOST_ITERATIONS = 200

# After a Newton step this short the next one would be shorter than the last bit.
SHORT_STEP = 1.0e-9


@kernel
def polynomial(coefficients, theta):
    """Return the value of a polynomial, constant coefficient first."""
    value = 0.0
    for power in range(coefficients.size - 1, -1, -1):
        value = value * theta + coefficients[power]
    return value


@kernel
def crossing(coefficients, level, low=0.0, high=1.0):
    """Return a θ from `low` to `high` where the polynomial meets `level`, to the last bit.

    Newton's method, kept inside a bracket that each value narrows; where it would leave the bracket
    the bracket is halved.  The polynomial must start on one side of the level and end on the other.
    If rounding keeps it from the level, the place is its end.
    """
    start, end = polynomial(coefficients, low), polynomial(coefficients, high)
    rising = start < level
    share = (level - start) / (end - start) if end != start else 0.5
    theta = low + (high - low) * min(1.0, max(0.0, share))
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
    """Return the coefficients of the derivative of a polynomial."""
    result = np.empty(coefficients.size - 1)
    for power in range(1, coefficients.size):
        result[power - 1] = power * coefficients[power]
    return result
