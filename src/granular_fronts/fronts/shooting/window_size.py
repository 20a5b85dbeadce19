r"""How many beads behind and ahead of its centre a front needs in double precision.

Behind, a window may end where the squares of the slowest modes of the tail are lost in rounding,
:math:`19.2/\operatorname{Re}\lambda` beads from the centre (`tail_closure`): half as many as the
modes themselves would need.

Ahead u falls super-exponentially.  For β > 1, :math:`p = -\ln u` grows at least by the factor
min(α, β) from bead to bead once the overdamped front of `initial_guess` has come to its end; for β
= 1, :math:`u \sim e^{-\kappa\xi}` with :math:`\kappa = 4\gamma\sinh^2(\kappa/2)`.
"""

import math

import numpy as np

from granular_fronts.arguments import count
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.linear.tails import rate_of_tail_ahead
from granular_fronts.fronts.shooting import initial_guess, tail_closure

UNTOUCHED_P = 45.0
FEWEST_BEHIND, MARGIN_AHEAD = 10, 3
MOST_BEADS = 10_000
SMALL_TAIL, LARGEST_TAIL = 1.0e-8, 1.0e-2


def choose_beads(law, roots):
    """Beads behind and ahead of the centre that the tails need.

    Parameters
    ----------
    law : bead_flow.PowerLaw
    roots : ndarray of complex
        Roots of the tail, the slowest first.

    Returns
    -------
    behind, ahead : int

    Raises
    ------
    NoFrontError
        If they are more than `MOST_BEADS`.
    """
    with np.errstate(all="ignore"):
        # A law beyond double precision has no length.
        length = tail_closure.tail_length(roots) + _length_ahead(law)
    if not length <= MOST_BEADS:
        raise NoFrontError(
            f"the window would need {length:.2g} beads, more than {MOST_BEADS}: bring gamma "
            'closer to 1, or use method "profile"'
        )
    return _beads_behind(roots), math.ceil(_length_ahead(law)) + MARGIN_AHEAD


def check_window(roots, behind, ahead):
    """Beads behind and ahead, unless the window ends where the tail is not yet a sum of modes."""
    advice = f"the tail decays like exp({roots[0].real:.3g} xi): give more, or leave beads out"
    needed = _beads_behind(roots)
    return (
        count("beads behind", behind, least=needed, advice=advice),
        count("beads ahead", ahead, advice="give more, or leave beads out"),
    )


def missing_beads(roots, relative_displacement):
    """Beads missing behind, where the tail is larger than the slowest root predicts.

    Near critical damping a tail is an exponential times a polynomial.

    Parameters
    ----------
    roots : ndarray of complex
        Roots of the tail, the slowest first.
    relative_displacement : ndarray, shape (beads,)
        A front that has, or has almost, been found.

    Returns
    -------
    int
        0 where the square of u − 1 is small enough at the first bead, or u is no tail there.
    """
    tail = abs(relative_displacement[0] - 1.0)
    if not SMALL_TAIL < tail < LARGEST_TAIL:
        return 0
    decay = math.log(tail) - 0.5 * math.log(tail_closure.NEGLIGIBLE_SQUARE)
    return math.ceil(decay / roots[0].real) + 1


def _beads_behind(roots):
    return max(FEWEST_BEHIND, math.ceil(tail_closure.tail_length(roots)))


def _length_ahead(law):
    """Distance from u = 1/2 to where u is lost in rounding, from above."""
    if law.beta == 1.0:
        return UNTOUCHED_P / rate_of_tail_ahead(0.0, law.gamma, 1.0)
    growth = math.log(min(law.alpha, law.beta))
    double_exponential = math.log(UNTOUCHED_P / math.log(2.0)) / growth
    return initial_guess.overdamped_length(law.alpha, law.gamma, law.beta) + double_exponential
