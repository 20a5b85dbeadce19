r"""How a window of beads ends behind a front: the tail in modes.

Linearised at u = 1 a front is a sum of modes (James 2021, section 6)

.. math::

    u = 1 + \sum_k a_k e^{\lambda_k \xi}, \qquad
    d = \sum_k a_k \bigl( -\lambda_k - \beta\gamma\,(2\cosh\lambda_k - 2) \bigr) e^{\lambda_k\xi},
    \qquad \xi = n - t,

    \lambda^2 = \alpha\,\bigl(1 - \tfrac{\beta\gamma}{\alpha}\lambda\bigr)\,(2\cosh\lambda - 2),
    \qquad \operatorname{Re}\lambda > 0 .

The window is closed where the squares of the slowest modes are lost in rounding, half as far behind
the front as where the modes themselves are.  Roots with more than `FASTER` times the smallest real
part have died out there.
"""

import math

import numpy as np

from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.linear.tails import MOST_ROOTS, tail_roots

NEGLIGIBLE_SQUARE = 2.0e-17
SEPARATION = 1e-4
FASTER = 2.1


def tail_length(roots):
    """Distance behind the front from which the squares of the modes are lost in rounding."""
    return -0.5 * math.log(NEGLIGIBLE_SQUARE) / roots[0].real


def slow_roots(alpha, gamma, beta):
    """The roots that matter where a window ends, one of each conjugate pair."""
    count = 4
    roots = tail_roots(alpha, gamma, beta, count)
    while roots[-1].real <= FASTER * roots[0].real:
        count *= 2
        if count > MOST_ROOTS:
            raise NoFrontError(f"the tail has more than {MOST_ROOTS} modes of like decay")
        roots = tail_roots(alpha, gamma, beta, count)
    return separate(roots[roots.real <= FASTER * roots[0].real])


def separate(roots):
    """Roots moved apart to a relative distance of `SEPARATION` where they almost coincide.

    Parameters
    ----------
    roots : ndarray of complex, shape (roots,)
        Ordered by real part, one of each conjugate pair.

    Returns
    -------
    ndarray of complex, shape (roots,)
    """
    distance = SEPARATION * roots[0].real
    close = (roots.imag > 0.0) & (roots.imag < distance)
    apart = np.where(close, roots.real + 1j * distance, roots)
    for k in range(1, apart.size):
        if abs(apart[k] - apart[k - 1]) < distance:
            middle = 0.5 * (apart[k - 1] + apart[k])
            apart[k - 1 : k + 1] = middle - 0.5 * distance, middle + 0.5 * distance
    return apart


def modes(law, roots, xi):
    """Real basis of the tail, 1 in size at ξ = 0.

    Parameters
    ----------
    law : bead_flow.PowerLaw
    roots : ndarray of complex, shape (roots,)
    xi : array_like
        Distances from the driven contact.

    Returns
    -------
    ndarray, shape (modes, 2) + shape of xi
        u − 1 and d of each mode; a complex root has two.
    """
    xi = np.asarray(xi, dtype=float)
    basis = []
    for root in roots:
        u = np.exp(root * xi)
        d = -(root + law.beta * law.gamma * (2.0 * np.cosh(root) - 2.0)) * u
        basis.append([u.real, d.real])
        if root.imag != 0.0:
            basis.append([u.imag, d.imag])
    return np.array(basis)
