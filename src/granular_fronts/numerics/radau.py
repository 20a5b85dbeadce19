r"""Coefficients of the five-stage Radau IIA method, order 9, and of its three linear systems.

Radau IIA is collocation at the zeros :math:`c_i` of :math:`P_5 - P_4` on [0, 1], the last of which
is 1 (Hairer, Wanner, *Solving Ordinary Differential Equations II*, second edition, section IV.5).
Its matrix A has one real eigenvalue and two conjugate pairs, all with positive real part; with
:math:`A = T\Lambda T^{-1}` the five stages of a Newton step part into one real and two complex
systems.

Real layout.  A vector of five stages is turned into five real rows: the component of the real
eigenvalue, then real and imaginary part for either pair.  `TO_ROWS` turns stages into rows, and
`TO_STAGES` turns them back.
"""

import numpy as np
from numpy.polynomial import legendre

STAGES = 5
SYSTEMS = 3


def _nodes():
    """The zeros of P_5 − P_4, moved to [0, 1]."""
    series = np.zeros(STAGES + 1)
    series[-2:] = -1.0, 1.0
    nodes = np.sort(legendre.legroots(series).real)
    nodes[-1] = 1.0
    return 0.5 * (nodes + 1.0)


def _collocation_matrix(nodes):
    """The integrals from 0 to c_i of the Lagrange polynomials, by Gauss's rule, which is exact."""
    points, weights = legendre.leggauss(STAGES)
    return np.array(
        [0.5 * c * weights @ lagrange_weights(nodes, 0.5 * c * (points + 1.0)) for c in nodes]
    )


def _real_layout(matrix):
    """Eigenvalues with imaginary part ≥ 0, and the matrices to the real rows and back."""
    values, vectors = np.linalg.eig(matrix)
    order = np.argsort(np.abs(values.imag), kind="stable")
    chosen = [i for i in order if values[i].imag > -1.0e-12]
    inverse = np.linalg.inv(vectors)[chosen]
    rows, columns = [inverse[0].real], [vectors[:, chosen[0]].real]
    for pair, index in enumerate(chosen[1:], start=1):
        rows += [inverse[pair].real, inverse[pair].imag]
        columns += [2.0 * vectors[:, index].real, -2.0 * vectors[:, index].imag]
    return values[chosen], np.array(rows), np.array(columns).T.copy()


def lagrange_weights(nodes, x):
    """Weights that evaluate, at the points x, the polynomial through values at the nodes."""
    weights = np.ones((np.size(x), len(nodes)))
    for k, node in enumerate(nodes):
        others = np.delete(nodes, k)
        weights[:, k] = np.prod((np.reshape(x, (-1, 1)) - others) / (node - others), axis=1)
    return weights


NODES = _nodes()
MATRIX = _collocation_matrix(NODES)
WEIGHTS = MATRIX[-1].copy()
EIGENVALUES, TO_ROWS, TO_STAGES = _real_layout(MATRIX)
DAMPING_TO_ROWS = TO_ROWS @ MATRIX
FORCE_TO_ROWS = TO_ROWS @ MATRIX @ MATRIX
RATE_TO_ROWS = TO_ROWS @ NODES
POINTS = np.append(0.0, NODES)
"""Start and stages of a step: where the polynomial that predicts the next step is known."""
END_FROM_OTHERS = lagrange_weights(POINTS[:-1], 1.0)[0]
"""The end point guessed from the start and the first four stages, for the error estimate."""
