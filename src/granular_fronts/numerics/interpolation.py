"""Values between the points of a uniform grid, by local polynomials of high degree, compiled."""

import math

import numpy as np

from granular_fronts.numerics.compiled import kernel, subroutine

NODES = 20  # Points of each local polynomial, half of them on either side.
# Barycentric weights of equidistant points.
WEIGHTS = np.array([(-1.0) ** j * math.comb(NODES - 1, j) for j in range(NODES)])
NOISE = 1e-15  # Relative height of crests that are round-off.
# Weights of (u(ξ + kh) − u(ξ − kh))/h in u'(ξ), of order 2 REACH.
REACH = 10
DIFFERENCES = np.array(
    [
        (-1.0) ** (k + 1) * math.comb(2 * REACH, REACH - k) / (k * math.comb(2 * REACH, REACH))
        for k in range(1, REACH + 1)
    ]
)


@subroutine
def _interpolate(values, position, behind, ahead, origin):
    """Return the local polynomial at one position."""
    if position < -NODES - origin:
        return behind
    if position > values.size + NODES - origin:
        return ahead
    nearest = round(position)
    if position == nearest and 0 <= nearest + origin < values.size:
        return values[nearest + origin]
    first = math.floor(position) - NODES // 2 + 1
    above = below = 0.0
    for j in range(NODES):
        k = first + j + origin
        value = behind if k < 0 else ahead if k >= values.size else values[k]
        if position == first + j:
            return value
        weight = WEIGHTS[j] / (position - (first + j))
        above += weight * value
        below += weight
    return above / below


@kernel
def interpolate_all(values, positions, behind, ahead, origin=0):
    """Return the local polynomials at many positions, shape of `positions` (1-D)."""
    result = np.empty(positions.size)
    for k in range(positions.size):
        result[k] = _interpolate(values, positions[k], behind, ahead, origin)
    return result


@subroutine
def derivative(values, behind, ahead):
    """Return the derivative at all points, per spacing, by central differences of order 20."""
    result = np.zeros(values.size)
    for k in range(values.size):
        for j in range(1, REACH + 1):
            right = values[k + j] if k + j < values.size else ahead
            left = values[k - j] if k - j >= 0 else behind
            result[k] += DIFFERENCES[j - 1] * (right - left)
    return result


@subroutine
def find_level(values, level, behind, ahead):
    """Return where decreasing values pass a level for the last time, k + fraction, by bisection.

    The fraction is NaN if there is no such place.
    """
    for k in range(values.size - 2, -1, -1):
        if values[k] >= level > values[k + 1]:
            left, right = 0.0, 1.0
            for _ in range(53):
                middle = 0.5 * (left + right)
                if _interpolate(values, middle, behind, ahead, k) >= level:
                    left = middle
                else:
                    right = middle
            return k, 0.5 * (left + right)
    return 0, math.nan


@kernel
def largest(values, behind, ahead):
    """Return the largest value of the interpolant.

    It is sought next to high points above their neighbours.  A point is high if the interpolant,
    rising as steeply beyond it as towards it, could exceed the largest value on the grid.
    """
    top = values[0]
    for value in values:
        top = max(top, value)
    highest = top
    for k in range(1, values.size - 1):
        rise = values[k] - min(values[k - 1], values[k + 1])
        crest = values[k] >= values[k - 1] and values[k] >= values[k + 1]
        if crest and rise > NOISE * abs(top) and values[k] + rise > top:
            highest = max(highest, _crest_value(values, k, behind, ahead))
    return highest


@kernel
def last_crests(values, last, count, behind, ahead):
    """Return the values of the interpolant at its last crests up to a point, the last first.

    Where there is none it is `behind`.
    """
    crests, found = np.full(count, behind), 0
    for k in range(last, 0, -1):
        rise = values[k] - min(values[k - 1], values[k + 1])
        crest = values[k] >= values[k - 1] and values[k] >= values[k + 1]
        if crest and rise > NOISE * abs(behind):
            crests[found] = _crest_value(values, k, behind, ahead)
            found += 1
            if found == crests.size:
                break
    return crests


@subroutine
def _crest_value(values, k, behind, ahead):
    """Return the maximum of the interpolant next to a point, by ternary search."""
    left, right = -1.0, 1.0
    # The value is flat at the crest, so that half the digits of its place suffice.
    for _ in range(45):
        third = (right - left) / 3.0
        a, b = left + third, right - third
        if _interpolate(values, a, behind, ahead, k) < _interpolate(values, b, behind, ahead, k):
            left = a
        else:
            right = b
    return _interpolate(values, 0.5 * (left + right), behind, ahead, k)
