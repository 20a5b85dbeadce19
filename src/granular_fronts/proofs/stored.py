"""How a certificate stores its numbers: as integers, kernels and matrices by second differences."""

import math

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.proofs.balls import INVERSE_UNIT

MOST_ROWS = 19_000
"""Of the window's matrix, of which six copies, 16 GiB, are held at once while it is solved."""


def beads(length):
    """The least number of beads that a length fits into."""
    return max(1, math.ceil(length))


def require_size(rows):
    """Refuse a window's matrix that does not fit into memory."""
    if rows > MOST_ROWS:
        raise InputError(
            f"the matrix of the window would have {rows} rows, but more than {MOST_ROWS} take "
            "above 16 GiB: lower cells, or gamma."
        )


def fractions(interval):
    """Numerators and denominators of both ends."""
    return integers(*(k for end in interval for k in (end.numerator, end.denominator)))


def integers(*numbers):
    """Integers of at most 64 bits."""
    if max(map(abs, numbers)) >= 2**63:
        raise InputError("a fraction has more than 18 digits: round it.")
    return np.array(numbers, dtype=np.int64)


def kernels(rows):
    """Kernels of the inverses of both ends."""
    return np.array([differences(row, INVERSE_UNIT, np.int32) for row in rows])


def differences(values, unit, kind):
    """Second differences in integers, once along each axis of a matrix."""
    found = np.rint(values / unit).astype(np.int64)
    for axis in (0, -1):
        found = np.diff(found, axis=axis, prepend=0)
    if abs(found).max() > np.iinfo(kind).max:
        raise InputError("the window's matrix is too rough for a certificate: use more cells.")
    return found.astype(kind)
