r"""A lattice with any potentials V and W, seen from a front in it; James (2021), section 2.

Let n run so that the front has c > 0 (otherwise the lattice is reflected, which swaps the states),
from the strain :math:`R_b` behind to :math:`R_a` ahead.  With :math:`R = R_a + (R_b - R_a)\,u`

.. math::

    p(u) = \frac{V'(R) - V'(R_a)}{R_b - R_a}, \qquad q(u) = \frac{W'(R) - W'(R_a)}{R_b - R_a}

are all that the front depends on; it has :math:`c^2 = p(1)`, eq. (13).

Long waves.  To first order in slow variation :math:`c^2 u = p(u) - c\,q(u)'`, of which the front is

.. math:: \xi = \int \frac{c\,q'(u)}{c^2 u - p(u)}\,(-du),

with :math:`u = 1/(1 + e^x)` as a variable.  It is good for strong damping.

Tails.  Near either state the front is :math:`e^{\lambda\xi}` with :math:`c^2\lambda^2 = (V'' -
c\lambda W'')(2\cosh\lambda - 2)`, which are the roots of `tails` with α and γ replaced by
:math:`V''/c^2` and :math:`cW''/V''`.  Where V'' and W'' vanish, ahead, the front ends faster than
any exponential.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.fronts.linear import tails
from granular_fronts.fronts.profile.window import DECAY
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import Potential

FARTHEST_ROUND_OFF, NEGLIGIBLE = 1.0e-6, 1.0e-15
START_REACH, START_POINTS = 25.0, 4001
ROOM, ROOM_OF_SHARP_END = 4.0, 8.0
LONGEST_START = 1.0e4


class Lattice(NamedTuple):
    """A lattice and the states of a front in it, seen so that the front runs to larger n.

    Attributes
    ----------
    potential, dissipation : granular_fronts.model.potentials.Potential
        V and W.
    factor : float
        What W is multiplied by.
    behind, ahead : float
        States R_b and R_a.
    speed : float
        c > 0 by eq. (13).
    """

    potential: Potential
    dissipation: Potential
    factor: float
    behind: float
    ahead: float
    speed: float

    def strain(self, u):
        """R for a value of u."""
        return self.ahead + (self.behind - self.ahead) * u

    def elastic(self, u):
        """The function p."""
        return self._scaled(self.potential.first, u)

    def viscous(self, u):
        """The function q."""
        return self.factor * self._scaled(self.dissipation.first, u)

    def stiffness(self, u):
        """Its derivative p'(u) = V''(R)."""
        return self.potential.second(self.strain(u))

    def viscosity(self, u):
        """Its derivative q'(u) = W''(R)."""
        return self.factor * self.dissipation.second(self.strain(u))

    def curvatures(self, u):
        """V'' and W'' at one value of u."""
        place = np.array([u])
        return float(self.stiffness(place)[0]), float(self.viscosity(place)[0])

    def _scaled(self, function, u):
        ahead = function(np.array([self.ahead]))
        return (function(self.strain(u)) - ahead) / (self.behind - self.ahead)


def make_lattice(potential, dissipation, R_minus, R_plus):
    """The lattice with the front's direction and speed.

    Parameters
    ----------
    potential, dissipation : granular_fronts.model.potentials.Potential
        V and W.
    R_minus, R_plus : float
        States at n → −∞ and n → +∞.

    Returns
    -------
    Lattice

    Raises
    ------
    InputError
        If `jump_conditions` excludes the front, or if it does not decay exponentially to the state
        behind, or if sound is not slower than the front ahead of it and faster behind.
    """
    theory = jump_conditions(potential, R_minus, R_plus, dissipation=dissipation)
    behind, ahead = (R_minus, R_plus) if theory.direction > 0 else (R_plus, R_minus)
    lattice = Lattice(potential, dissipation, 1.0, behind, ahead, abs(theory.speed))
    (faster, resistance), (slower, _) = lattice.curvatures(1.0), lattice.curvatures(0.0)
    if not math.isfinite(faster + resistance):
        raise InputError(
            f"V'' or W'' is infinite at R = {behind:g}, the state behind the front (V'' is "
            f"{faster:g}, W'' is {resistance:g}), and no exponential leads to it: choose a state "
            "where both are finite."
        )
    if not faster > theory.speed**2 > slower:
        raise InputError(
            f"V'' is {faster:.6g} behind the front and {slower:.6g} ahead, but a front is sought "
            f"with c² = {theory.speed**2:.6g} between them: choose states between which V''' has "
            "one sign."
        )
    return lattice


def long_wave_front(lattice):
    """The front of the equation of first order, as a function u of ξ."""
    x = np.linspace(-START_REACH, START_REACH, START_POINTS)
    u = 1.0 / (1.0 + np.exp(x))
    gap = lattice.speed**2 * u - lattice.elastic(u)
    rates = lattice.speed * lattice.viscosity(u) * u * (1.0 - u) / np.maximum(gap, 1e-300)
    # Rounding spoils the ends, where the decay is exponential or the front ends.
    good = np.abs(gap) > FARTHEST_ROUND_OFF * lattice.speed**2 * np.minimum(u, 1.0 - u)
    x, rates = x[good], rates[good]
    xi = np.concatenate([[0.0], np.cumsum(0.5 * (rates[1:] + rates[:-1]) * np.diff(x))])
    xi -= np.interp(0.0, x, xi)
    return lambda places: 1.0 / (1.0 + np.exp(np.interp(places, xi, x, left=-DECAY, right=DECAY)))


def choose_window(lattice):
    """Lengths behind and ahead of ξ = 0, in sites, from the tails of both states."""
    c = lattice.speed
    stiffness, viscosity = lattice.curvatures(1.0)
    root = tails.lowest_roots_of_all(stiffness / c**2, c * viscosity / stiffness, 1)[0]
    return ROOM + DECAY / root.real, _length_ahead(lattice)


def _length_ahead(lattice):
    c = lattice.speed
    stiffness, viscosity = lattice.curvatures(0.0)
    if stiffness == 0.0 and viscosity == 0.0:
        places = np.arange(0.0, LONGEST_START)
        return ROOM_OF_SHARP_END + float(
            places[long_wave_front(lattice)(places) > NEGLIGIBLE].max(initial=0.0)
        )
    return ROOM + DECAY / tails.rate_of_tail_ahead(stiffness, c * viscosity, c)
