r"""The eighth-order Dormand-Prince pair, written for chains in strain form.

A chain in strain form (see `granular_fronts.chain.strain`) reads

.. math:: \dot u = d + \gamma\, g(u), \qquad \dot d = k(u),

so that only :math:`u` enters the nonlinear terms.  An explicit Runge-Kutta method
:math:`(A, b, c)` with step :math:`h` then needs no stage value of :math:`d` at all:

.. math::

    U_i = u + c_i h\, d + \sum_j \bigl( h\gamma\, a_{ij}\, g_j + h^2 (A^2)_{ij}\, k_j \bigr),
    \qquad k_j = k(U_j),\; g_j = g(U_j),

    u^+ = u + h\, d + \sum_j \bigl( h\gamma\, b_j\, g_j + h^2 (bA)_j\, k_j \bigr),
    \qquad d^+ = d + h \sum_j b_j k_j .

It is the same method, rounded differently: half of the stored slopes and half of the memory
traffic disappear.  The error estimates of the pair and its continuous extension of order 7 are
linear in the slopes too, and go through the same algebra: for a weight vector :math:`e` the
combination in :math:`u` has the weights :math:`h\gamma e` on :math:`g` and :math:`h^2 eA` on
:math:`k`.

The coefficients are those of the code DOP853 (Hairer, Norsett, Wanner, *Solving Ordinary
Differential Equations I*, second edition, section II.10), read from `scipy.integrate.DOP853`.

Continuous extension.  With :math:`\theta = (t - t_0)/h \in [0, 1]` the solution is
:math:`y_0 + h\sum_j b_j(\theta) K_j` with polynomials :math:`b_j` of degree 7 over sixteen slopes:
the twelve stages, the slope at the new point, and three stages computed only where output falls.
"""

import numpy as np
from numpy.polynomial import Polynomial
from scipy.integrate import DOP853

STAGES = 12
SLOPES = 16
NEW_SLOPE = 12
DEGREE = 7
ROUNDING = 1.0e-15
BLOCK = 4
ERROR_EXPONENT = -1.0 / 8.0
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.9, 0.2, 10.0


def _coefficient_matrix():
    """A for all sixteen slopes; row 12 is the new point, whose weights are b."""
    matrix = np.zeros((SLOPES, SLOPES))
    matrix[:STAGES, :STAGES] = DOP853.A
    matrix[NEW_SLOPE, :STAGES] = DOP853.B
    matrix[NEW_SLOPE + 1 :] = DOP853.A_EXTRA
    return matrix


def _continuous_weights():
    r"""Monomial coefficients of :math:`b_j(\theta)`, shape (DEGREE + 1, SLOPES).

    DOP853 nests its interpolant as θ(F₀ + (1 − θ)(F₁ + θ(F₂ + …))); here the nest is unfolded once.
    """
    b = np.zeros(SLOPES)
    b[:STAGES] = DOP853.B
    first, new = np.eye(SLOPES)[0], np.eye(SLOPES)[NEW_SLOPE]
    nested = np.vstack([b, first - b, 2 * b - (first + new), DOP853.D])
    theta = Polynomial([0.0, 1.0])
    basis, factor = [], Polynomial([1.0])
    for level in range(len(nested)):
        factor = factor * (theta if level % 2 == 0 else 1 - theta)
        basis.append(factor)
    weights = np.zeros((DEGREE + 1, SLOPES))
    for polynomial, row in zip(basis, nested, strict=True):
        weights[: len(polynomial.coef)] += np.outer(polynomial.coef, row)
    return weights


def _sparse(*weights):
    """Columns where any of the weights is not zero, and the weights there, as tuples.

    Compiled loops unroll a tuple by its length, and skip the zeros, a third of all coefficients.
    """
    columns = np.flatnonzero(np.any(np.abs(weights) > 0.0, axis=0))
    values = (tuple(map(float, np.asarray(row)[columns])) for row in weights)
    return tuple(map(int, columns)), *values


def _in_blocks():
    """For each stage: columns with weights, padded by column 0 to whole blocks; A and A² there."""
    columns, ends = np.zeros((SLOPES, SLOPES), np.int64), np.zeros(SLOPES, np.int64)
    on_g, on_k = np.zeros((2, SLOPES, SLOPES))
    for row in range(SLOPES):
        found = np.flatnonzero((A[row, :row] != 0.0) | (A_SQUARED[row, :row] != 0.0))
        ends[row] = BLOCK * -(-found.size // BLOCK)
        columns[row, : found.size] = found
        on_g[row, : found.size], on_k[row, : found.size] = A[row, found], A_SQUARED[row, found]
    return columns, ends, on_g, on_k


def _times_matrix(weights):
    """Weights times A; sums that the order conditions make zero are set to zero."""
    product = weights @ A
    return np.where(np.abs(product) < ROUNDING, 0.0, product)


A = _coefficient_matrix()
A_SQUARED = _times_matrix(A)
STAGE_ROWS = tuple(_sparse(A[row, :row], A_SQUARED[row, :row]) for row in range(SLOPES))
# The columns of A and of A² apart, where each has slopes of its own.  The first stages have no A².
A_ROWS = tuple(_sparse(A[row, :row]) for row in range(SLOPES))
A_SQUARED_ROWS = (((0,), (0.0,)),) * 2 + tuple(
    _sparse(A_SQUARED[row, :row]) for row in range(2, SLOPES)
)
# The same row by row in blocks, the last of which is filled up with weights 0.
COLUMNS, ENDS, A_IN_BLOCKS, A_SQUARED_IN_BLOCKS = _in_blocks()
C = np.concatenate([DOP853.C, [1.0], DOP853.C_EXTRA])
B = A[NEW_SLOPE]
ERROR_5, ERROR_3 = (
    np.pad(weights, (0, SLOPES - weights.size)) for weights in (DOP853.E5, DOP853.E3)
)
B_ROW, B_A_ROW = _sparse(B), _sparse(_times_matrix(B))
ERROR_5_ROW, ERROR_5_A_ROW = _sparse(ERROR_5), _sparse(_times_matrix(ERROR_5))
ERROR_3_ROW, ERROR_3_A_ROW = _sparse(ERROR_3), _sparse(_times_matrix(ERROR_3))
CONTINUOUS = _continuous_weights()
CONTINUOUS_A = CONTINUOUS @ A
# The same by slope: the coefficients of one contact's polynomial then add up in vector registers.
CONTINUOUS_OF_SLOPE = np.ascontiguousarray(CONTINUOUS.T)
CONTINUOUS_A_OF_SLOPE = np.ascontiguousarray(CONTINUOUS_A.T)
