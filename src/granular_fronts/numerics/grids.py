"""Evenly spaced points that end where they should."""

import numpy as np

ROUNDING = 1e-12
"""How far a stop may lie beyond the last point, relative to the range, and still count as met."""


def regular_points(start, stop, step):
    """start, start + step, … up to and including a stop that the step hits up to rounding."""
    return start + step * np.arange(int(np.floor((stop - start) / step * (1 + ROUNDING))) + 1)
