"""How wrong a number can be: a measured one, and one that was computed twice.

The modules named `measures` hold the measurements.
"""

from typing import NamedTuple

import numpy as np


class Measured(NamedTuple):
    """A value and an estimate of its absolute error."""

    value: float
    error: float


def error_attributes(value, other, method):
    """Attributes that say how wrong a variable can be.

    Parameters
    ----------
    value, other : ndarray, same shape
        Two computations; where they agree, one unit of the last digit stands in.
    method : str
        How the second was made.

    Returns
    -------
    dict
        `error_estimate` and `error_method`.
    """
    largest = _largest(value)
    estimate = max(_largest(value - other), float(np.spacing(largest)) if largest else 0.0)
    return {"error_estimate": estimate, "error_method": method}


def _largest(values):
    return float(np.max(np.abs(values), initial=0.0))
