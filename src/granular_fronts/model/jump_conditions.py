r"""Jump conditions of fronts between two uniform states; James (2021), section 2.

A front :math:`x_n(t) = X(n - ct)` of the lattice :math:`m\ddot x = \delta^-(V'(\delta^+x) +
\tfrac{d}{dt}W'(\delta^+x))` joins the states :math:`X'(\pm\infty) = R_\pm`.  With
:math:`[\![f]\!] = f(R_+) - f(R_-)`,

.. math::

    mc^2 [\![R]\!] = [\![V']\!], \qquad
    \sigma = \operatorname{sign} c = \operatorname{sign} S, \quad
    S = [\![V]\!] - \tfrac12[\![R]\!]\,(V'(R_-) + V'(R_+)), \qquad
    \lim_{n\to\pm\infty}\dot x_n = -cR_\pm,

eqs. (13), (17) and (12): the speed does not depend on W.  Generalised Hertz with :math:`R_- =
-\delta`, :math:`R_+ = 0` gives (21)-(23).  A uniform velocity may be added to all beads.

Dissipation.  The balance (9), integrated over the front, is :math:`S/c = \int (\delta^+X')^2\,
W''(\delta^+X)\,d\xi \ge 0` (16).  Hence the power lost in the whole front, :math:`\sum_n
(\delta^+\dot x_n)^2\, W''(\delta^+x_n)` averaged over the passage of one bead, is :math:`cS =
|cS|`.  Each bead that the front passes costs the energy :math:`|S|`, whatever W; for Hertz
:math:`\delta^{\alpha+1}|\alpha-1|k/(2(\alpha+1))`.

Close states.  The differences above lose all digits as :math:`[\![R]\!] \to 0`.  With
:math:`r(s) = R_- + s[\![R]\!]` they are integrals, where nothing cancels:

.. math::

    mc^2 = \int_0^1 V''(r(s))\,ds, \qquad
    S = -[\![R]\!]^2 \int_0^1 (s - \tfrac12)\,V''(r(s))\,ds
      = -\tfrac12 [\![R]\!]^3 \int_0^1 s(1-s)\,V'''(r(s))\,ds .

The last is the signed area (19), and shows σ = −sign([[R]] V''') where V''' has one sign.  Gauss
quadrature on one interval and on two estimates its own error.  So a kink between the states is
noticed, and the differences are taken there instead.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from granular_fronts.accuracy import EPSILON, Estimate
from granular_fronts.arguments import double_precision, instance, scalar
from granular_fronts.errors import InputError
from granular_fronts.model.laws import Law, make_law
from granular_fronts.model.potentials import Potential

NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)  # Exact for polynomials of degree 47.
SPLIT = 0.4  # Where an interval is cut in two: in the middle symmetry would hide a kink.
ROUNDING = 4.0 * EPSILON  # Of a power, whose exponent is rounded too.
CLOSE_ENOUGH = 1.0e-13  # Relative error at which the first of several ways is good enough.


class JumpConditions(NamedTuple):
    """What the states at infinity say of a front, in the units of the potential.

    Attributes
    ----------
    R_minus, R_plus : float
        x_(n+1) − x_n far behind (n → −∞) and far ahead (n → +∞); negative in compression.
    direction : int
        σ, +1 if the front runs towards n → +∞ and −1 otherwise.
    speed : float
        c in beads per unit of time, of the sign σ.
    speed_error : float
        Estimate of its absolute error.
    velocity_minus, velocity_plus : float
        Velocities of the beads at n → −∞ and at n → +∞, −cR₋ and −cR₊.
    energy_per_bead : float
        Energy |S| that the front dissipates at each bead it passes.
    energy_error : float
        Estimate of its absolute error.
    sound_minus, sound_plus : float
        Sound speeds (V''(R)/m)^(1/2) of both states; NaN where V'' < 0.
    """

    R_minus: float
    R_plus: float
    direction: int
    speed: float
    speed_error: float
    velocity_minus: float
    velocity_plus: float
    energy_per_bead: float
    energy_error: float
    sound_minus: float
    sound_plus: float

    @property
    def velocity_jump(self) -> float:
        """[[ẋ]] = −c[[R]]: velocity at n → +∞ less that at n → −∞."""
        return -self.speed * (self.R_plus - self.R_minus)

    @property
    def velocity_behind(self) -> float:
        """Velocity of the beads that the front has passed."""
        return self.velocity_minus if self.direction > 0 else self.velocity_plus

    @property
    def velocity_ahead(self) -> float:
        """Velocity of the beads that the front has yet to reach."""
        return self.velocity_plus if self.direction > 0 else self.velocity_minus

    @property
    def dissipated_power(self) -> float:
        """|c|·|S|, the power that the whole front dissipates."""
        return abs(self.speed) * self.energy_per_bead


def jump_conditions(
    law: Law | Mapping[str, Any] | Potential,
    R_minus: float,
    R_plus: float,
    *,
    mass: float = 1.0,
    dissipation: Potential | None = None,
) -> JumpConditions:
    """Compute speed, direction, velocities and losses of a front between two states.

    The conditions are necessary; they do not say that a front exists.

    Parameters
    ----------
    law : Law, Mapping or Potential
        A law, a mapping for `granular_fronts.make_law`, or only V.
    R_minus, R_plus : float
        States at n → −∞ and n → +∞; negative in compression.
    mass : float, optional
        m, above 0.
    dissipation : Potential, optional
        W, if law is only V.  None means some convex potential that acts between the states; the
        results depend on nothing else.  A law without damping makes a conservative chain.

    Returns
    -------
    JumpConditions

    Raises
    ------
    InputError
        If the states exclude a front, with the statement of James (2021) that excludes it; or if
        an argument is impossible.

    Examples
    --------
    >>> front = gf.jump_conditions({"alpha": 1.5, "gamma": 0.1}, -0.0625, 0.0)
    >>> front.direction, front.speed
    (1, 0.5)
    """
    potential, dissipation = _potentials(law, dissipation)
    mass = scalar("mass", mass, above=0.0, advice="give the bead's mass")
    R_minus, R_plus = _check_states(potential, dissipation, R_minus=R_minus, R_plus=R_plus)
    with double_precision("The front", "bring the states and the mass closer to 1"):
        return _conditions(potential, R_minus, R_plus, mass, dissipation)


def _conditions(potential, R_minus, R_plus, mass, dissipation):
    _check_curvature(potential, _stiffnesses(potential, R_minus, R_plus))
    square = _squared_speed(potential, R_minus, R_plus)
    _check_squared_speed(potential, square, R_minus, R_plus)
    area = signed_area(potential, R_minus, R_plus)
    if dissipation is not None:
        _check_dissipation(potential, dissipation, area, R_minus, R_plus)
    _check_area(potential, area, R_minus, R_plus)
    direction = 1 if area.value > 0.0 else -1
    speed = direction * math.sqrt(square.value / mass)
    sounds = [_sound_speed(potential, R, mass) for R in (R_minus, R_plus)]
    return JumpConditions(
        R_minus,
        R_plus,
        direction,
        speed,
        0.5 * abs(speed) * square.error / square.value + EPSILON * abs(speed),
        0.0 - speed * R_minus,
        0.0 - speed * R_plus,
        abs(area.value),
        # [[R]] rounds and is cubed: three halves of a unit, and one of the cube and the product.
        area.error + 2.5 * EPSILON * abs(area.value),
        *sounds,
    )


def signed_area(potential, R_minus, R_plus):
    """Return S of eq. (17), the signed area (19) between the force and its chord, an `Estimate`."""
    jump = R_plus - R_minus

    def from_third_derivative():
        mean = _mean(lambda s: s * (1.0 - s) * potential.third(R_minus + s * jump))
        return mean * (-0.5 * jump**3)

    def from_second_derivative():
        mean = _mean(lambda s: (s - 0.5) * potential.second(R_minus + s * jump))
        return mean * (-(jump**2))

    def from_differences():
        energy = _difference(potential.value, R_minus, R_plus)
        forces = [_at(potential.first, R) for R in (R_minus, R_plus)]
        work = 0.5 * jump * (forces[0] + forces[1])
        rounding = ROUNDING * abs(0.5 * jump) * (abs(forces[0]) + abs(forces[1]))
        return Estimate(energy.value - work, energy.error + rounding)

    ways = [from_second_derivative, from_differences]
    # Where V'' jumps, V''' is blind to the jump; quadrature of V'' is not.
    if potential.third is not None and _is_good(_mean_stiffness(potential, R_minus, R_plus)):
        ways.insert(0, from_third_derivative)
    return _first_good(ways)


def _mean_stiffness(potential, R_minus, R_plus):
    return _mean(lambda s: potential.second(R_minus + s * (R_plus - R_minus)))


def _squared_speed(potential, R_minus, R_plus):
    """Return [[V']]/[[R]] of eq. (13)."""
    jump = R_plus - R_minus
    return _first_good(
        [
            lambda: _mean_stiffness(potential, R_minus, R_plus),
            lambda: _difference(potential.first, R_minus, R_plus) * (1.0 / jump),
        ]
    )


def _difference(function, R_minus, R_plus):
    before, after = _at(function, R_minus), _at(function, R_plus)
    return Estimate(after - before, ROUNDING * (abs(before) + abs(after)))


def _mean(function):
    """Return ∫ of a function from 0 to 1 by Gauss quadrature, its error from a cut in two."""
    whole, _ = _quadrature(function, 0.0, 1.0)
    (left, size_left), (right, size_right) = (
        _quadrature(function, *panel) for panel in ((0.0, SPLIT), (SPLIT, 1.0))
    )
    both = left + right
    return Estimate(both, abs(both - whole) + 2.0 * EPSILON * (size_left + size_right))


def _quadrature(function, start, stop):
    """Return the integral from start to stop, and the integral of the absolute values."""
    half = 0.5 * (stop - start)
    terms = half * WEIGHTS * function(start + half * (1.0 + NODES))
    return float(terms.sum()), float(np.abs(terms).sum())


def _first_good(ways):
    """Return the first way that is good enough, in an order of trust, or else the best of all."""
    estimates = []
    for way in ways:
        estimate = way()
        if not math.isfinite(estimate.value + estimate.error):
            continue
        if _is_good(estimate):
            return estimate
        estimates.append(estimate)
    return min(estimates, key=lambda estimate: estimate.error)


def _is_good(estimate):
    return estimate.error <= CLOSE_ENOUGH * abs(estimate.value)


def _at(function, R):
    return float(function(np.array([R]))[0])


def _stiffnesses(potential, R_minus, R_plus):
    """Return V'' at the nodes between the states, after checking that V is finite."""
    between = R_minus + 0.5 * (1.0 + NODES) * (R_plus - R_minus)
    and_ends = np.array([R_minus, *between, R_plus])
    _finite(potential, "V", potential.value, and_ends)
    _finite(potential, "V'", potential.first, and_ends)
    return _finite(potential, "V''", potential.second, between)


def _finite(potential, symbol, function, points):
    with np.errstate(all="ignore"):
        values = np.asarray(function(points), dtype=float)
    if not np.isfinite(values).all():
        bad = int(np.argmin(np.isfinite(values)))
        raise InputError(
            f"{symbol} of {potential.name} is {values[bad]} at r = {points[bad]:.6g}, in the range "
            "of the states: correct the potential, or choose states where it is finite."
        )
    return values


def _sound_speed(potential, R, mass):
    stiffness = _at(potential.second, R)
    return math.sqrt(stiffness / mass) if stiffness >= 0.0 else math.nan


def _potentials(law, dissipation):
    """Return V and W (None if W is not given) of a law or of a potential."""
    if dissipation is not None:
        instance("dissipation", dissipation, Potential, "make one with granular_fronts.Potential")
    if isinstance(law, Potential):
        return law, dissipation
    law = make_law(law)
    if dissipation is not None:
        raise InputError(
            f"dissipation is {dissipation.name}, but the law has a viscous potential already, "
            f"{law.viscous.name}: leave dissipation out, or give only the elastic potential."
        )
    return law.elastic, law.viscous


def _check_states(*potentials, **states):
    """Return two different states inside the domains of the potentials, as floats."""
    for potential in potentials:
        if potential is None:
            continue
        low, high = potential.domain
        advice = f"{potential.name} is defined from {low:g} to {high:g}, so give a state inside"
        states = {
            name: scalar(name, R, least=low, most=high, advice=advice) for name, R in states.items()
        }
    R_minus, R_plus = states.values()
    if R_minus == R_plus:
        raise InputError(
            f"R_minus and R_plus are both {R_minus}, but a front joins two different states "
            "(James 2021, section 2): give two."
        )
    return R_minus, R_plus


def _check_curvature(potential, stiffnesses):
    spread = stiffnesses.max() - stiffnesses.min()
    # A few roundings of V'' are no curvature.
    if spread <= 8.0 * EPSILON * np.abs(stiffnesses).max():
        raise InputError(
            f"{potential.name} is quadratic between the states (V'' is {stiffnesses[0]:.6g} "
            "throughout), and then there is no front (James 2021, Remark 3): choose states "
            "between which V'' changes."
        )
    if (stiffnesses < 0.0).all():
        raise InputError(
            f"{potential.name} is strictly concave between the states, and then there is no front "
            "(James 2021, Remark 1): choose states between which V'' is positive."
        )


def _check_squared_speed(potential, square, R_minus, R_plus):
    if square.value <= square.error:
        raise InputError(
            f"[[V']]/[[R]] of {potential.name} is {square.value:.6g} between {R_minus:g} and "
            f"{R_plus:g}, but it is the square of a speed (James 2021, eq. 13) and must be above "
            "0: choose states with the force [[V']] of the sign of [[R]]."
        )


def _check_area(potential, area, R_minus, R_plus):
    if abs(area.value) <= area.error:
        raise InputError(
            f"[[V]] - [[R]] (V'(R_-) + V'(R_+))/2 of {potential.name} vanishes between {R_minus:g} "
            f"and {R_plus:g} (it is {area.value:.1e}, with an error of {area.error:.1e}), and then "
            "there is no dissipative front (James 2021, eq. 18): choose other states."
        )


def _check_dissipation(potential, dissipation, area, R_minus, R_plus):
    resistances = _stiffnesses(dissipation, R_minus, R_plus)
    if (resistances < 0.0).any():
        raise InputError(
            f"W'' of {dissipation.name} is {resistances.min():.6g} somewhere between the states, "
            "but W must be convex, or it would feed the front (James 2021, eq. 6): correct W."
        )
    if (resistances > 0.0).any():
        return
    if abs(area.value) > area.error:
        raise InputError(
            "Nothing dissipates between the states.  A front of a conservative chain needs "
            f"the signed area (20) to be 0, but it is {area.value:.6g}, as for V''' of one "
            "sign (James 2021, Remark 4): add dissipation."
        )
    raise InputError(
        "Nothing dissipates between the states, and the signed area (20) is 0.  If a front of "
        f"speed {math.sqrt(max(_squared_speed(potential, R_minus, R_plus).value, 0.0)):.6g} "
        "(for mass 1) exists, it may run either way (James 2021, Remark 4): add dissipation."
    )
