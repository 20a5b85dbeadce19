r"""Where a window of beads ends around a front: behind in modes of the tail, ahead untouched.

Behind.  Linearised at u = 1 a front is a sum of modes (James 2021, section 6)

.. math::

    u = 1 + \sum_k a_k e^{\lambda_k \xi}, \qquad
    d = \sum_k a_k \bigl( -\lambda_k - \beta\gamma\,(2\cosh\lambda_k - 2) \bigr) e^{\lambda_k\xi},
    \qquad \xi = n - t,

    \lambda^2 = \alpha\,\bigl(1 - \tfrac{\beta\gamma}{\alpha}\lambda\bigr)\,(2\cosh\lambda - 2),
    \qquad \operatorname{Re}\lambda > 0 .

The window is closed where the squares of the slowest modes are lost in rounding.  The modes
themselves are lost twice as far behind the front.  Roots with more than `FASTER` times the smallest
real part have died out there.

Ahead.  u falls super-exponentially.  For β > 1, :math:`p = -\ln u` grows at least by the factor
min(α, β) from bead to bead beyond the overdamped front of `initial_guess`.  For β = 1, :math:`u
\sim e^{-\kappa\xi}` with :math:`\kappa = 4\gamma\sinh^2(\kappa/2)`.
"""

import math

import numpy as np

from granular_fronts.arguments import count
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.linear.tails import MOST_ROOTS, rate_of_tail_ahead, tail_roots
from granular_fronts.fronts.shooting import initial_guess

NEGLIGIBLE_SQUARE = 2.0e-17  # of a mode, where a window may end
FASTER = 2.1  # a little more than a squared mode
SEPARATION = 1e-4  # of roots, relative to the slowest, so that modes stay independent
FEWEST_BEHIND, MARGIN_AHEAD = 10, 3  # beads
MOST_BEADS = 10_000
UNTOUCHED_P = 45.0  # −ln u where u is lost in rounding
SMALL_TAIL, LARGEST_TAIL = 1.0e-8, 1.0e-2  # u − 1 at the first bead that more beads can cure


def tail_length(roots):
    """Return distance behind the front from which the squares of the modes are lost in rounding."""
    return -0.5 * math.log(NEGLIGIBLE_SQUARE) / roots[0].real


def slow_roots(alpha, gamma, beta):
    """Return the roots that matter where a window ends, one of each conjugate pair."""
    number = 4
    roots = tail_roots(alpha, gamma, beta, number)
    while roots[-1].real <= FASTER * roots[0].real:
        number *= 2
        if number > MOST_ROOTS:
            raise NoFrontError(f"the tail has more than {MOST_ROOTS} modes of like decay")
        roots = tail_roots(alpha, gamma, beta, number)
    return _separate(roots[roots.real <= FASTER * roots[0].real])


def _separate(roots):
    """Return the roots, moved apart to a relative distance of at least `SEPARATION`."""
    distance = SEPARATION * roots[0].real
    close = (roots.imag > 0.0) & (roots.imag < distance)
    apart = np.where(close, roots.real + 1j * distance, roots)
    for k in range(1, apart.size):
        if abs(apart[k] - apart[k - 1]) < distance:
            middle = 0.5 * (apart[k - 1] + apart[k])
            apart[k - 1 : k + 1] = middle - 0.5 * distance, middle + 0.5 * distance
    return apart


def modes(law, roots, xi):
    """Return relative displacement u − 1 and strain rate d of each real mode, 1 in size at ξ = 0.

    The shape is (modes, 2) + the shape of xi, which counts from the driven contact.  A complex root
    has two modes.
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


def choose_beads(law, roots):
    """Return the beads behind and ahead of the centre that the tails need, at most `MOST_BEADS`."""
    with np.errstate(all="ignore"):
        # A law beyond double precision has no length.
        length = tail_length(roots) + _length_ahead(law)
    if not length <= MOST_BEADS:
        raise NoFrontError(
            f"the window would need {length:.2g} beads, more than {MOST_BEADS}: bring gamma "
            'closer to 1, or use method "profile"'
        )
    return _beads_behind(roots), math.ceil(_length_ahead(law)) + MARGIN_AHEAD


def check_window(roots, behind, ahead):
    """Return the beads behind and ahead, if the tail at the end is a sum of modes."""
    advice = f"the tail decays like exp({roots[0].real:.3g} xi): give more, or leave beads out"
    needed = _beads_behind(roots)
    return (
        count("beads behind", behind, least=needed, advice=advice),
        count("beads ahead", ahead, advice="give more, or leave beads out"),
    )


def missing_beads(roots, relative_displacement):
    """Return the beads missing behind, if the tail is larger than its slowest root predicts.

    Near critical damping a tail is an exponential times a polynomial.  None are missing where the
    square of u − 1 is small enough at the first bead, or u is no tail there.
    """
    tail = abs(relative_displacement[0] - 1.0)
    if not SMALL_TAIL < tail < LARGEST_TAIL:
        return 0
    decay = math.log(tail) - 0.5 * math.log(NEGLIGIBLE_SQUARE)
    return math.ceil(decay / roots[0].real) + 1


def _beads_behind(roots):
    return max(FEWEST_BEHIND, math.ceil(tail_length(roots)))


def _length_ahead(law):
    """Return the distance from u = 1/2 to where u is lost in rounding, from above."""
    if law.beta == 1.0:
        return UNTOUCHED_P / rate_of_tail_ahead(0.0, law.gamma, 1.0)
    growth = math.log(min(law.alpha, law.beta))
    double_exponential = math.log(UNTOUCHED_P / math.log(2.0)) / growth
    return initial_guess.overdamped_length(law.alpha, law.gamma, law.beta) + double_exponential
