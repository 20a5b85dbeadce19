"""LU factors of band matrices with a long constant stretch, without pivoting, compiled.

Row i of the matrix lies in ``band[i]``, its diagonal at index `lower`; entries outside the matrix
are zero.  There are `lower` diagonals below the main one and ``band.shape[1] - 1 - lower`` above.

Behind a front the rows of its equations hardly differ over a long stretch, and so do their factors
from some distance on.  These rows are left out: after row ``prefix - 1`` that row of the factors
stands for `skipped` more, where `skipped` is 0 or at least `lower`.
"""

from granular_fronts.compiled import kernel


@kernel(fastmath=True, error_model="numpy")
def factorise(band, lower, prefix):
    """Replace a matrix by its factors, L below the diagonal and U above, with 1/U on it."""
    rows, width = band.shape
    upper = width - 1 - lower
    for i in range(rows):
        nearest = prefix - 1 if i >= prefix else 0
        for place in range(max(0, lower - i) if i < prefix else 0, lower):
            j = max(nearest, i - lower + place)
            factor = band[i, place] * band[j, lower]
            band[i, place] = factor
            for q in range(1, upper + 1):
                band[i, place + q] -= factor * band[j, lower + q]
        band[i, lower] = 1.0 / band[i, lower]


@kernel(fastmath=True)
def substitute(band, lower, prefix, skipped, x):
    """Solve in place with the factors of `factorise`."""
    upper = band.shape[1] - 1 - lower
    for i in range(x.size):
        row = compact(i, prefix, skipped)
        total = x[i]
        for place in range(max(0, lower - i), lower):
            total -= band[row, place] * x[i + place - lower]
        x[i] = total
    for i in range(x.size - 1, -1, -1):
        row = compact(i, prefix, skipped)
        total = x[i]
        for q in range(1, min(upper, x.size - 1 - i) + 1):
            total -= band[row, lower + q] * x[i + q]
        x[i] = total * band[row, lower]


@kernel
def compact(i, prefix, skipped):
    """Where the factors of row i are."""
    return i if i < prefix else max(prefix - 1, i - skipped)
