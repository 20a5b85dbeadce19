"""LU factors of band matrices, without pivoting, compiled.

Row i of the matrix lies in ``band[i]``, its diagonal at index `lower`; entries outside the matrix are
zero.  There are `lower` diagonals below the main one and ``band.shape[1] - 1 - lower`` above.
"""

from granular_fronts.compiled import kernel

SAME = 1e-13
"""Largest difference of two rows of factors that are called equal."""


@kernel(fastmath=True)
def factorise(band, lower, steady):
    """Replace a matrix by its factors, L below the diagonal and U above, with 1/U on it.

    The first `steady` rows may be taken for equal, as those of a Toeplitz matrix; once the factors
    repeat themselves there they are copied instead of computed.
    """
    size, width = band.shape
    upper = width - 1 - lower
    repeats = False
    for i in range(size):
        if repeats and i < steady:
            for q in range(width):
                band[i, q] = band[i - 1, q]
            continue
        for j in range(max(0, i - lower), i):
            place = j - i + lower
            factor = band[i, place] * band[j, lower]
            band[i, place] = factor
            for q in range(1, upper + 1):
                band[i, place + q] -= factor * band[j, lower + q]
        band[i, lower] = 1.0 / band[i, lower]
        repeats = lower < i < steady and same_rows(band[i], band[i - 1])


@kernel
def same_rows(one, other):
    """Whether two rows of factors are equal to about round-off."""
    for q in range(one.size):
        if abs(one[q] - other[q]) > SAME:
            return False
    return True


@kernel(fastmath=True)
def substitute(band, lower, x):
    """Solve in place with the factors of `factorise`."""
    size, width = band.shape
    upper = width - 1 - lower
    for i in range(size):
        total = x[i]
        for place in range(max(0, lower - i), lower):
            total -= band[i, place] * x[i + place - lower]
        x[i] = total
    for i in range(size - 1, -1, -1):
        total = x[i]
        for q in range(1, min(upper, size - 1 - i) + 1):
            total -= band[i, lower + q] * x[i + q]
        x[i] = total * band[i, lower]
