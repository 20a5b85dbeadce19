"""Evenly spaced points that end where they should."""

import numpy as np

# How far a stop may lie beyond the last point, relative to the range, and still count as met.
ROUNDING = 1e-12


def regular_points(start, stop, step):
    """Return start, start + step, … up to a stop, itself included if a step hits it."""
    count = int(np.floor((stop - start) / step * (1 + ROUNDING)))
    points = start + step * np.arange(count + 1)
    # Rounding may carry the last point beyond the stop, or leave it short of it.
    if abs(stop - points[-1]) <= ROUNDING * abs(stop - start):
        points[-1] = stop
    return points
