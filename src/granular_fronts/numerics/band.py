"""LU factors of band matrices with a long constant stretch, without pivoting, compiled.

Row i of the matrix lies in ``band[i]``, its diagonal at index `lower`; entries outside the matrix
are zero.  There are `lower` diagonals below the main one and ``band.shape[1] - 1 - lower`` above.

Behind a front the rows of its equations hardly differ over a long stretch, and so do their factors
from some distance on.  These rows are left out: after row ``prefix - 1`` that row of the factors
replaces `skipped` more, where `skipped` is at least `lower`.  Or nothing is left out, and `prefix`
is the number of rows.

A row that is ready is subtracted from all rows below it before the next one.  These differ, so that
no entry waits for the one before.  Unknowns are found in blocks: what they take from outside of
their block waits for none of it.  Loops run over slices with unsigned indices. So the compiler sees
that neighbouring entries lie side by side in memory.
"""

from numba import int64, uint64

from granular_fronts.numerics.compiled import kernel, subroutine

BLOCK = 4
"""Unknowns that are found together, at most as many as diagonals on either side of the
main one."""


@kernel(fastmath=True, error_model="numpy")
def factorise(band, lower, prefix):
    """Replace a matrix by its factors, L below the diagonal and U above, with 1/U on it."""
    rows = band.shape[0]
    _eliminate(band, lower, int64(0), prefix)
    for i in range(prefix, min(prefix + lower, rows)):
        for place in range(lower - (i - prefix)):
            _subtract(band, lower, prefix - 1, i, place)
    _eliminate(band, lower, prefix, rows)


@subroutine(fastmath=True, error_model="numpy")
def _eliminate(band, lower, first, end):
    """Factors of the rows first … end − 1, from which those above are subtracted already."""
    for j in range(first, end):
        band[j, lower] = 1.0 / band[j, lower]
        for i in range(j + 1, min(j + lower + 1, end)):
            _subtract(band, lower, j, i, lower - (i - j))


@subroutine(fastmath=True, forceinline=True)
def _subtract(band, lower, ready, i, place):
    """Subtract a row that is ready from row i so that the entry at `place` vanishes."""
    factor = band[i, place] * band[ready, lower]
    band[i, place] = factor
    top = band[ready, lower + 1 :]
    row = band[i, place + 1 :]
    for q in range(uint64(top.size)):
        row[q] -= factor * top[q]


@kernel(fastmath=True)
def substitute(band, lower, prefix, skipped, x):
    """Solve in place with the factors of `factorise`."""
    for start in range(0, x.size, BLOCK):
        for i in range(start, min(start + BLOCK, x.size)):
            row, ready = _compact(i, prefix, skipped), uint64(i - start)
            first, near = max(0, lower - i), lower - (i - start)
            total = product(band[row, first:near], x[i - lower + first : start])
            for k in range(ready):
                total += band[row, near + k] * x[start + k]
            x[i] -= total
    for start in range(x.size, 0, -BLOCK):
        for i in range(start - 1, max(start - BLOCK, 0) - 1, -1):
            row, ready = _compact(i, prefix, skipped), uint64(start - 1 - i)
            total = product(band[row, lower + start - i :], x[start:])
            for k in range(ready):
                total += band[row, lower + 1 + k] * x[i + 1 + k]
            x[i] = (x[i] - total) * band[row, lower]


@subroutine
def _compact(i, prefix, skipped):
    """Return where the factors of row i are."""
    return i if i < prefix else max(prefix - 1, i - skipped)


@subroutine(fastmath=True, forceinline=True)
def product(row, x):
    """Sum of products, as far as both reach."""
    total = 0.0
    for k in range(uint64(min(row.size, x.size))):
        total += row[k] * x[k]
    return total
