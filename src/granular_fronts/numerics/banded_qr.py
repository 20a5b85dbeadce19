r"""Least squares with a banded matrix, by Householder reflections.

Minimise :math:`\|Ax - b\|_2` for a matrix of m rows and n ≤ m columns with
:math:`a_{ij} = 0` outside :math:`-p \le j - i \le q`.  Column by column a reflection of the p + 1
rows j … j + p clears what lies below the diagonal.  So R has p + q diagonals above it, and the work
is of order :math:`n\,p\,(p + q)`.  The normal equations would square the condition number, and
would lose half of the digits of a front whose tail is long.

Storage.  Row i holds its entries from column i − p on: `rows[i, j - i + p]`, of width 2p + q + 1,
the last p of which are room for R.
"""

import numpy as np

from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted


def band_storage(rows, lower, upper):
    """Return the zeros for a matrix with this many rows, and bandwidths p = lower, q = upper."""
    return np.zeros((rows, 2 * lower + upper + 1))


@kernel(fastmath={"contract", "reassoc", "nsz"})
def solve_least_squares(rows, lower, columns, right):
    """Minimise |A x − b|; the matrix in band storage and b, shape (m,), are overwritten.

    `lower` is the number p of diagonals below the main one, `columns` the number n of unknowns.
    The solution, shape (n,), is not finite where the matrix has not full rank.
    """
    width = rows.shape[1] - lower
    vector, products = np.zeros(lower + 1), np.zeros(width)
    for j in range(columns):
        height = min(lower + 1, rows.shape[0] - j)
        reach = min(width, columns - j)
        length_squared = 0.0
        for i in range(height):
            vector[i] = rows[j + i, lower - i]
            length_squared += vector[i] * vector[i]
        diagonal = -np.copysign(np.sqrt(length_squared), vector[0])
        vector[0] -= diagonal
        scale = -1.0 / (diagonal * vector[0]) if diagonal != 0.0 else 0.0
        products[:] = 0.0
        product = 0.0
        for i in range(height):
            product += vector[i] * right[j + i]
            row = rows[j + i, lower - i :]
            for k in range(1, reach):
                products[k] += vector[i] * row[k]
        for i in range(height):
            factor = scale * vector[i]
            right[j + i] -= factor * product
            row = rows[j + i, lower - i :]
            for k in range(1, reach):
                row[k] -= factor * products[k]
        rows[j, lower] = diagonal
        if interrupted():
            break
    return _back_substitute(rows, lower, columns, right)


@subroutine
def _back_substitute(rows, lower, columns, right):
    """Solve R x = b."""
    solution = np.empty(columns)
    for j in range(columns - 1, -1, -1):
        total = right[j]
        for k in range(1, min(rows.shape[1] - lower, columns - j)):
            total -= rows[j, lower + k] * solution[j + k]
        solution[j] = total / rows[j, lower] if rows[j, lower] != 0.0 else np.nan
    return solution
