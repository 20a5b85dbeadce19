r"""The start of the next front of a sweep, extrapolated from those before, compiled.

Fronts are a smooth function of ln γ, point by point.  The start at ln γ is the polynomial through
the last ones, :math:`u = \sum_i w_i u_i` with

.. math:: w_i = \prod_{j \ne i} \frac{\ln\gamma - \ln\gamma_j}{\ln\gamma_i - \ln\gamma_j} .

Errors of the fronts are magnified by :math:`\sum_i |w_i|`, which is 15 for four at equal distances.
Fewer fronts are taken where it would be more than `LARGEST_WEIGHT`.

The fronts lie in the rows of an array, front k in row k modulo their number.  Their middles are at
the same column.  Columns behind a front hold 1, columns ahead the state there.
"""

import numpy as np

from granular_fronts.numerics.compiled import kernel, subroutine

REMEMBERED = 4
LARGEST_WEIGHT = 20.0
UNTOUCHED = 1e-17  # Distance from the state ahead below which a front has not begun.


@kernel
def remember(u, first, ahead, row):
    """Write a front into a row, its first point into column `first`."""
    row[:first] = 1.0
    for k in range(u.size):
        row[first + k] = u[k]
    row[first + u.size :] = ahead


@kernel
def predict(past, known, places, place, first, margin):
    """Return the start at a place ln γ, below the decreasing `places` of the fronts so far.

    `past` has the shape (REMEMBERED, columns), and `known` ≥ 1 fronts were written into it.  The
    start begins at column `first`, and ends `margin` columns ahead of where the last front ends.
    """
    rows, columns = past.shape
    last = past[(known - 1) % rows]
    end = columns
    while end > first + 1 and abs(last[end - 1] - last[columns - 1]) < UNTOUCHED:
        end -= 1
    end = min(end + margin, columns)
    weights = extrapolation_weights(places[max(known - rows, 0) :], place)
    u = np.zeros(end - first)
    for i in range(weights.size):
        row = past[(known - weights.size + i) % rows]
        for k in range(u.size):
            u[k] += weights[i] * row[first + k]
    return u


@kernel
def extrapolation_weights(places, place):
    """Return the weights of the last fronts, of as many as do not magnify errors too much."""
    for used in range(places.size, 1, -1):
        weights = _lagrange_weights(places[places.size - used :], place)
        magnification = 0.0
        for weight in weights:
            magnification += abs(weight)
        if magnification <= LARGEST_WEIGHT:
            return weights
    return np.ones(1)


@subroutine
def _lagrange_weights(places, place):
    """Return the values at `place` of polynomials, each 1 at one of the places, else 0."""
    weights = np.ones(places.size)
    for i in range(places.size):
        for j in range(places.size):
            if j != i:
                weights[i] *= (place - places[j]) / (places[i] - places[j])
    return weights
