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

NEGLIGIBLE_SQUARE = 2.0e-17
FASTER = 2.1


def tail_length(roots):
    """Distance behind the front from which the squares of the modes are lost in rounding."""
    return -0.5 * math.log(NEGLIGIBLE_SQUARE) / roots[0].real


def slow_roots(alpha, gamma, beta):
    """The roots that matter where a window ends, one of each conjugate pair."""
    roots = _tail_roots(alpha, gamma, beta)
    return roots[roots.real <= FASTER * roots[0].real]


def modes(law, roots, xi):
    """Real basis of the tail, 1 in size at ξ = 0.

    Parameters
    ----------
    law : chain.state.Law
    roots : ndarray of complex, shape (roots,)
    xi : array_like
        Distances from the rear contact.

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


def _tail_roots(alpha, gamma, beta, most=8):
    """Leading roots by Newton's method from a grid of starts."""
    ratio = beta * gamma / alpha

    def defect(root):
        half = np.sinh(0.5 * root) / (0.5 * root)
        slope = half * (np.cosh(0.5 * root) / np.sinh(0.5 * root) - 2.0 / root)
        value = 1.0 - alpha * (1.0 - ratio * root) * half**2
        return value, alpha * (ratio * half**2 - (1.0 - ratio * root) * half * slope)

    real, imaginary = np.geomspace(1e-4, 6.0, 80), np.linspace(0.0, 12.0, 60)
    root = (real[:, np.newaxis] + 1j * imaginary).ravel()
    with np.errstate(all="ignore"):
        for _ in range(60):
            value, slope = defect(root)
            root = root - value / slope
        value, slope = defect(root)
        distance = np.abs(value / slope)
    found = (root.real > 1e-7) & (root.imag > -1e-12) & (distance < 1e-10)
    root = root[found]
    root = np.where(np.abs(root.imag) < 1e-10, root.real, root)
    root = root[np.argsort(root.real)]
    kept = []
    for candidate in root:
        if all(abs(candidate - other) > 1e-7 for other in kept):
            kept.append(candidate)
    return np.array(kept[:most])
