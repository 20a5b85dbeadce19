"""Points of a chunk solved one after the other, each by itself; one that fails leaves a reason."""

import numpy as np

from granular_fronts.campaign.kinds import Solved
from granular_fronts.output.progress import counted


def solve_one_by_one(points, sizes, measure, error_method, activity):
    """Solve the points of a chunk.

    Parameters
    ----------
    points : dict of str to ndarray, shape (lines, fast)
        Parameters.
    sizes : mapping of str to tuple of int
        What is recorded, and its shape at one point: () for a number.
    measure : callable
        From the parameters of a point, its number and the number of all points, to a value and its
        error (NaN where none is estimated) of all that is recorded.
    error_method, activity : str
        How errors are estimated, and what the progress bar says.

    Returns
    -------
    Solved
    """
    shape = next(iter(points.values())).shape
    values = {name: np.full((*shape, *size), np.nan) for name, size in sizes.items()}
    reasons, errors = np.full(shape, "", dtype=object), dict.fromkeys(sizes, np.nan)
    indices = list(np.ndindex(shape))
    for number, index in enumerate(counted(indices, activity, "point")):
        point = {name: value[index] for name, value in points.items()}
        try:
            measured = measure(point, number, len(indices))
        except (ValueError, ArithmeticError) as error:
            reasons[index] = str(error)
            continue
        for name, value in values.items():
            value[index], error = measured[name]
            errors[name] = np.fmax(errors[name], error)
    return Solved(values, reasons, errors, error_method)
