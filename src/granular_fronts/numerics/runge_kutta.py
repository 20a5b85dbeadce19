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
linear in the slopes too.  They go through the same algebra: for a weight vector :math:`e` the
combination in :math:`u` has the weights :math:`h\gamma e` on :math:`g` and :math:`h^2 eA` on
:math:`k`.

Storage.  The slopes of the stages are in adjacent rows, in *slots*.  The first two stages change
places, since from stage 5 on no stage uses the second one.  A stage then sums `SHORT` or `LONG`
neighbouring rows from `FIRST_SLOT` on, which a compiler unrolls and vectorises.  Weights of rows
that it does not use are zero.  The new state and the error estimates use only the slopes of
`FINAL_STAGES`.

Step control.  Where the state travels from one bead to the next the error of a step oscillates.
The step therefore grows by :math:`0.9\,e^{-1/16}` only, with e the error in units of the tolerance.
It grows by the square of this where e is below `SMALL_ERROR`, and shrinks by :math:`0.9\,e^{-1/8}`
after a rejection.

The coefficients are those of the code DOP853 of Hairer, Nørsett and Wanner (1993),
*Solving Ordinary Differential Equations I*, section II.10, read from `scipy.integrate.DOP853`.

Continuous extension.  With :math:`\theta = (t - t_0)/h \in [0, 1]` the solution is
:math:`y_0 + h\sum_j b_j(\theta) K_j` with polynomials :math:`b_j` of degree 7 over sixteen slopes.
These are the twelve stages, the slope at the new point, and three stages computed only where output
falls.
"""

import numpy as np
from numpy.polynomial import Polynomial
from scipy.integrate import DOP853

STAGES = 12
SLOPES = 16
NEW_SLOPE = 12
DEGREE = 7
ROUNDING = 1.0e-15  # Of sums that the order conditions make zero.
SHORT, LONG = 5, 10
SLOT = np.array([1, 0, *range(2, SLOPES)])
FIRST_SLOT = np.array([0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1])
TERMS = np.array([SHORT] * 7 + [LONG] * 5)
ERROR_EXPONENT = -1.0 / 8.0
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.9, 0.2, 10.0
CAUTION, SMALL_ERROR = 0.5, 0.02


def _coefficient_matrix():
    """Return a for all sixteen slopes; row 12 is the new point, whose weights are b."""
    matrix = np.zeros((SLOPES, SLOPES))
    matrix[:STAGES, :STAGES] = DOP853.A
    matrix[NEW_SLOPE, :STAGES] = DOP853.B
    matrix[NEW_SLOPE + 1 :] = DOP853.A_EXTRA
    return matrix


def _continuous_weights():
    r"""Return the monomial coefficients of :math:`b_j(\theta)`, shape (DEGREE + 1, SLOPES)."""
    # DOP853 nests its interpolant as θ(F₀ + (1 − θ)(F₁ + θ(F₂ + …))); here the nest is unfolded
    # once.
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


def _in_slots(matrix):
    """Return the rows of a matrix over slopes with the columns in the order of their slots."""
    reordered = np.zeros_like(matrix)
    reordered[:, SLOT] = matrix
    return np.ascontiguousarray(reordered)


def _windows(matrix):
    """For each stage the weights of the slots in its window, ten of them, shape (STAGES, 10)."""
    slots = _in_slots(matrix)
    return np.array(
        [
            np.where(np.arange(LONG) < TERMS[row], slots[row, first : first + LONG], 0.0)
            for row, first in enumerate(FIRST_SLOT)
        ]
    )


def _times_matrix(weights):
    """Return the weights times A; sums that the order conditions make zero are set to zero."""
    product = weights @ A
    return np.where(np.abs(product) < ROUNDING, 0.0, product)


A = _coefficient_matrix()
A_SQUARED = _times_matrix(A)
C = np.concatenate([DOP853.C, [1.0], DOP853.C_EXTRA])
B = A[NEW_SLOPE]
ERROR_5, ERROR_3 = (
    np.pad(weights, (0, SLOPES - weights.size)) for weights in (DOP853.E5, DOP853.E3)
)
B_A = _times_matrix(B)
A_WINDOWS, A_SQUARED_WINDOWS = _windows(A), _windows(A_SQUARED)
A_SLOTS, A_SQUARED_SLOTS = _in_slots(A), _in_slots(A_SQUARED)
FINAL_STAGES = (0, 5, 6, 7, 8, 9, 10, 11)
FINAL_SLOTS = tuple(map(int, SLOT[list(FINAL_STAGES)]))
FINAL_B, FINAL_B_A, FINAL_5, FINAL_3_LESS_B = (
    tuple(map(float, weights[list(FINAL_STAGES)])) for weights in (B, B_A, ERROR_5, ERROR_3 - B)
)
CONTINUOUS = _continuous_weights()
CONTINUOUS_A = CONTINUOUS @ A
# The same by slot: the coefficients of one contact's polynomial then add up in vector registers.
CONTINUOUS_OF_SLOT = np.ascontiguousarray(_in_slots(CONTINUOUS).T)
CONTINUOUS_A_OF_SLOT = np.ascontiguousarray(_in_slots(CONTINUOUS_A).T)
