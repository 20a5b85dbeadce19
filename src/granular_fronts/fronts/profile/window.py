r"""How much of the line, and how finely, a front has to be computed.

Behind the front u − 1 decays like :math:`e^{\lambda\xi}` with the slowest root λ of the dispersion
relation (`tails`), so that a window of `DECAY`/Re λ reaches down to round-off.  Ahead, for r = 0
and β > 1, u falls doubly exponentially after a stretch that the long-wave front describes; for
r > 0 or β = 1 the tail is the exponential :math:`e^{-\kappa\xi}`.  These lengths are estimates: the
solution itself shows whether its ends are at rest (`profile.needed_stretch`).

The grid.  A front with exponent α falls ahead by a factor that grows like a tower, and its sharpest
part needs some (6 + 4.3α) points per site for the last digits; a wide front with small α − 1 needs
fewer.  A solution on a coarse grid shows it: the difference of its convolutions by rules of two
orders falls with the spacing like a known power.
"""

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.linear.tails import lowest_roots_of_all, rate_of_tail_ahead
from granular_fronts.fronts.profile.long_wave_front import continuum_front

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


def choose_window(law):
    """Window of a law, from its tails."""
    root = lowest_roots_of_all(
        law.alpha / law.speed**2, law.beta * law.gamma * law.speed / law.alpha, 1
    )[0]
    return Window(DECAY / root.real, _length_ahead(law))


def _length_ahead(law):
    xi, u = continuum_front(law, law.gamma)
    long_wave = xi[min(np.searchsorted(law.ahead - u, -1e-17), xi.size - 1)]
    dispersive = 12.5 / math.sqrt(12.0 * (1.0 - 1.0 / law.alpha))
    return max(long_wave + dispersive, DECAY / rate_ahead(law))


def rate_ahead(law):
    """κ of the tail ahead, u − r ~ e^(−κξ); infinite where u falls faster, r = 0 and β > 1."""
    stiffness = law.alpha * law.ahead ** (law.alpha - 1.0)
    viscosity = law.beta * law.ahead ** (law.beta - 1.0) * law.gamma * law.speed
    if stiffness == viscosity == 0.0:
        return math.inf
    return rate_of_tail_ahead(stiffness, viscosity, law.speed)


def coarse_spacing(law, window):
    """Spacing of the first grid: a third of the points of a sharp front, and not too many."""
    per_site = 2.0 + 1.6 * law.alpha
    return rational(max(1.0 / per_site, window.length / POINTS_COARSE))


def rational(spacing):
    """The spacing at or below this one that is a whole number of sites or divides a site."""
    if spacing >= 1.0:
        return Fraction(math.floor(spacing))
    return Fraction(1, math.ceil(1.0 / spacing))
