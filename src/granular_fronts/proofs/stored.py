"""What the certificates of both laws have in common: sizes, and numbers stored as integers.

Kernels and matrices are stored by their second differences, which are small and compress well.
"""

import math

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front
from granular_fronts.output.files import complete_file
from granular_fronts.proofs.balls import INVERSE_UNIT, MATRIX_UNIT

NEAR_ONE = 1e-11  # the approximate front is 1 behind the last place where |u − 1| is larger
LOST = 1e-4  # ∫|g| that is cut off at either end of an inverse
DECAYS = 6.5  # the window's matrix is solved on one that is longer by so many decay lengths
BELOW_SLOWEST = 0.9  # θ in units of the slowest rate behind
DIGITS_OF_WEIGHTS = 4  # decimals of θ and other rates that a certificate names
MOST_ROWS = 19_000  # of the window's matrix: solving it holds six copies at once, 16 GiB


def beads(length):
    """Return the least number of beads that a length fits into."""
    return max(1, math.ceil(length))


def window_stiffness(front, first, last, n):
    """Return ā at the middles of the cells of [first, last], if its matrix fits into memory."""
    rows = (last - first) * n
    if rows > MOST_ROWS:
        raise InputError(
            f"the matrix of the window would have {rows} rows, but more than {MOST_ROWS} take "
            "above 16 GiB: lower cells, or gamma."
        )
    middles, exponent = (np.arange(rows) + 0.5) / n + first, front.attrs["alpha"]
    return exponent * np.maximum(evaluate_front(front, middles), 0.0) ** (exponent - 1)


def fractions(interval):
    """Return the numerators and denominators of both ends."""
    return integers(*(k for end in interval for k in (end.numerator, end.denominator)))


def integers(*numbers):
    """Return the integers of at most 64 bits."""
    if max(map(abs, numbers)) >= 2**63:
        raise InputError("a fraction has more than 18 digits: round it.")
    return np.array(numbers, dtype=np.int64)


def kernels(rows):
    """Return the kernels of inverses, a row for each power of s."""
    return np.array([_differences(row, INVERSE_UNIT, np.int32) for row in rows])


def matrix(correction):
    """Return H − 1."""
    return _differences(correction, MATRIX_UNIT, np.int16)


def _differences(values, unit, kind):
    """Return the second differences in integers, once along each axis of a matrix."""
    found = np.rint(values / unit).astype(np.int64)
    for axis in (0, -1):
        found = np.diff(found, axis=axis, prepend=0)
    if abs(found).max() > np.iinfo(kind).max:
        raise InputError("the window's matrix is too rough for a certificate: use more cells.")
    return found.astype(kind)


def write(path, fields):
    """Write a certificate, whole or not at all."""
    with complete_file(path) as unfinished, unfinished.open("wb") as file:
        np.savez_compressed(file, **fields)
