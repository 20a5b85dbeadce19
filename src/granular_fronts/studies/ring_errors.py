r"""Distances between two waves on a ring, given at equally spaced places, a row for each time.

The *place* of both waves is where each falls for the last time, within half a turn of the model's
highest point, through the middle between the model's extremes, by linear interpolation; the
*height* of a wave is the vertex of the parabola through its three highest places.  Both are
interpolated alike in the two waves that are compared, so that what interpolation adds all but
cancels.
"""

import numpy as np


def largest(chain, model):
    """Largest difference at each time."""
    return np.abs(chain - model).max(axis=1)


def root_mean_square(chain, model):
    """Root mean square of the difference at each time."""
    return np.sqrt(((chain - model) ** 2).mean(axis=1))


def heights(rows):
    """Largest value at each time."""
    return np.array([_height(row) for row in np.atleast_2d(rows)])


def _height(row):
    i = int(np.argmax(row))
    left, top, right = (row[(i + k) % row.size] for k in (-1, 0, 1))
    curvature = left - 2.0 * top + right
    return top - (left - right) ** 2 / (8.0 * curvature) if curvature < 0.0 else top


def relative_decay(model, chain, start):
    """Loss of height since the start, of the model over that of the chain, minus 1."""
    [first] = heights(start)
    with np.errstate(divide="ignore", invalid="ignore"):
        return (first - heights(model)) / (first - heights(chain)) - 1.0


def lead(model, chain, spacing):
    """By how much the model is ahead of the chain at each time; NaN where there is no such fall.

    Parameters
    ----------
    model, chain : ndarray, shape (times, sites)
    spacing : float
        Of the sites.
    """
    return np.array([_lead(*rows) * spacing for rows in zip(model, chain, strict=True)])


def _lead(model, chain):
    half = model.size // 2
    turn, level = half - int(np.argmax(model)), 0.5 * (model.max() + model.min())
    return _last_fall(np.roll(model, turn), level) - _last_fall(np.roll(chain, turn), level)


def _last_fall(row, level):
    """Index, interpolated, of the last fall of a row through a level."""
    falls = np.flatnonzero((row[:-1] >= level) & (row[1:] < level))
    if not falls.size:
        return np.nan
    last = falls[-1]
    return last + (row[last] - level) / (row[last] - row[last + 1])


def first_passage(times, errors, level):
    """First time at which an error that is 0 at time 0 exceeds a level; NaN if it does not."""
    above = np.flatnonzero(errors > level)
    if not above.size:
        return np.nan
    t, e = np.append(0.0, times), np.append(0.0, errors)
    row = above[0] + 1
    return float(t[row - 1] + (t[row] - t[row - 1]) * (level - e[row - 1]) / (e[row] - e[row - 1]))
