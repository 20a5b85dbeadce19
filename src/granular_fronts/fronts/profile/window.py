r"""How much of the line, and how finely, a front has to be computed.

Tails.  Near either state :math:`s \sim e^{\lambda\xi}` with

.. math:: \lambda^2 = (p' - \lambda q')\,(2\cosh\lambda - 2),

the dispersion relation of `fronts.linear.tails` with α = p' and αg = q'.  Behind, a window of
`DECAY`/Re λ with the slowest root reaches down to round-off.  Ahead the tail is the exponential
:math:`e^{-\kappa\xi}`; where p' and q' vanish s falls doubly exponentially after a stretch that the
long-wave front describes.  These lengths are estimates: the solution itself shows whether its ends
are at rest (`solve.needed_stretch`).

The grid.  A front falls ahead the more sharply the larger p'(1), for Hertz contacts α: there by a
factor that grows like a tower, and the sharpest part needs some (6 + 4.3α) points per site for the
last digits; a wide front with small α − 1 needs fewer.  A solution on a coarse grid shows it: the
difference of its convolutions by rules of two orders falls with the spacing like a known power.
"""

import math
from fractions import Fraction
from typing import NamedTuple

from granular_fronts.fronts.linear.tails import lowest_roots_of_all, rate_of_tail_ahead
from granular_fronts.fronts.profile.long_wave_front import long_wave_front

DECAY = 37.0
"""Natural logarithm of what is left of a tail at the end of the window."""

POINTS_COARSE = 6000


class Window(NamedTuple):
    """Lengths behind and ahead of ξ = 0, in sites."""

    behind: float
    ahead: float

    @property
    def length(self):
        """Both lengths together."""
        return self.behind + self.ahead

    def longer(self, behind=1.0, ahead=1.0):
        """The window stretched by two factors."""
        return Window(self.behind * behind, self.ahead * ahead)


def choose_window(problem):
    """Window of a problem, from the tails of its front."""
    root = lowest_roots_of_all(problem.behind.p_slope, problem.tail_damping, 1)[0]
    return Window(DECAY / root.real, _length_ahead(problem))


def _length_ahead(problem):
    long_wave = long_wave_front(problem).xi[-1]
    dispersive = 12.5 / math.sqrt(12.0 * (1.0 - 1.0 / problem.behind.p_slope))
    return max(long_wave + dispersive, DECAY / rate_ahead(problem))


def rate_ahead(problem):
    """κ of the tail ahead, s ~ e^(−κξ); infinite where s falls faster, p'(0) = q'(0) = 0."""
    stiffness, viscosity = problem.ahead.p_slope, problem.damping * problem.ahead.q_slope
    if stiffness == viscosity == 0.0:
        return math.inf
    return rate_of_tail_ahead(stiffness, viscosity, 1.0)


def coarse_spacing(problem, window):
    """Spacing of the first grid: a third of the points of a sharp front, and not too many."""
    per_site = 2.0 + 1.6 * problem.behind.p_slope
    return rational(max(1.0 / per_site, window.length / POINTS_COARSE))


def rational(spacing):
    """The spacing at or below this one that is a whole number of sites or divides a site."""
    if spacing >= 1.0:
        return Fraction(math.floor(spacing))
    return Fraction(1, math.ceil(1.0 / spacing))
