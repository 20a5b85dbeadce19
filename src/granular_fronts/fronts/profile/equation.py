r"""The profile equation of a front between two states of a chain with any law.

A travelling front has the strain :math:`r_n(t) = R(\xi)`, ξ = n − ct, with :math:`R \to R_b` behind
and :math:`R \to R_a` ahead.  For the chain (5) of James (2021), section 2, of unit mass,

.. math::

    c^2 R'' = \Delta_d\Bigl[V'(R) - c\,\frac{d}{d\xi} W'(R)\Bigr], \qquad
    (\Delta_d f)(\xi) = f(\xi + 1) - 2 f(\xi) + f(\xi - 1).

Normalisation.  Let :math:`R = R_a + (R_b - R_a)\,s`, so that s falls from 1 to 0, and

.. math::

    p(s) = \frac{V'(R) - V'(R_a)}{c^2 (R_b - R_a)}, \qquad
    q(s) = \frac{W'(R) - W'(R_a)}{c\,(R_b - R_a)} .

In units of time in which the front runs one bead, p and q are all that it depends on.  The paper
integrates once, for the displacements (8).  Integrated twice, with s → 0 ahead, the equation is one
of the second kind,

.. math::

    s(\xi) = \int_{-1}^{1} (1 - |\sigma|)\, p(s(\xi - \sigma))\,d\sigma
           + \int_{-1}^{1} \operatorname{sgn}(\sigma)\, q(s(\xi - \sigma))\,d\sigma ,

whose limit far behind, p(1) = 1, is the jump condition (13), :math:`c^2 = [\![V']\!]/[\![R]\!]`.
The kernel contains no difference of neighbouring values, so that round-off stays what it is.  For
Hertz contacts from compression 1 into a chain at rest :math:`p = s_+^\alpha`,
:math:`q = \gamma s_+^\beta` and s is the relative displacement itself.

Velocity.  The momentum law :math:`\ddot x_n = f_{n-1} - f_n`, :math:`f = -V' - \tfrac{d}{dt}W'`,
integrated with :math:`\dot x \to -cR_a` ahead (eq. (12)), is

.. math::

    \dot x(\xi) = -cR_a - c\,(R_b - R_a)
        \Bigl[\int_{\xi-1}^{\xi} p(s)\,d\xi' - q(s(\xi)) + q(s(\xi - 1))\Bigr] .

Which fronts are sought.  The jump conditions admit them.  They run into the state where sound is
slower than the front, p'(0) < 1, and away from one where it is faster, p'(1) > 1 (Lax).  Both
slopes of p and q are finite there.  W acts behind, q'(1) > 0; otherwise nothing leads the front
exponentially to the state behind.

Compiled code knows a law by its row maps (`model.passes`), in the compression u = −r.  Rounding of
u is magnified in s by :math:`\max(|R_a|, |R_b|)/|R_b - R_a|`, or not at all.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import uint64

from granular_fronts.errors import InputError
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.laws import make_law
from granular_fronts.model.passes import call_row_map, row_map, row_parameters
from granular_fronts.numerics.compiled import kernel, subroutine


class Force(NamedTuple):
    """One of the functions p and q in compiled code."""

    first: int  # address of the row map −V'(−u)
    second: int  # address of the row map V''(−u)
    first_parameters: np.ndarray
    second_parameters: np.ndarray
    ahead: float  # −V'(R_a)
    scale: float  # 1/(c²(R_a − R_b)) for p, 1/(c(R_a − R_b)) for q


class End(NamedTuple):
    """p, q and their slopes at one of the two states; q for damping 1."""

    p: float
    q: float
    p_slope: float
    q_slope: float


class FrontProblem(NamedTuple):
    """A law and the states of a front, for compiled code."""

    elastic: Force  # p
    viscous: Force  # q for damping 1; p where W' = γV'
    proportional: bool  # whether W' = γV', so that q is a multiple of p
    damping: float  # what W is multiplied by; γ included where W' = γV'
    start: float  # −R_a, a compression
    jump: float  # R_a − R_b, so that u = start + jump s
    speed: float  # c of the jump conditions, above 0
    behind: End  # s = 1
    ahead: End  # s = 0
    least: float  # s at the ends of the law's domain
    most: float
    magnification: float  # of rounding of the strain in s, at least 1

    @property
    def size(self):
        """The strain that its rounding is relative to: the jump or the larger state."""
        return abs(self.jump) * self.magnification

    @property
    def damping_number(self):
        """q(1): γ for Hertz contacts between compression 1 and a chain at rest."""
        return self.damping * self.behind.q

    @property
    def tail_damping(self):
        """q'(1)/p'(1), which with p'(1) determines the tail behind."""
        return self.damping * self.behind.q_slope / self.behind.p_slope


def power_problem(alpha, gamma, beta, right_state=0.0):
    """Return the front of two powers from compression 1 to `right_state`."""
    law = make_law(alpha=alpha, beta=beta, gamma=gamma)
    return _normalise(law, -1.0, 0.0 - right_state, _power_speed(alpha, right_state))


def _power_speed(alpha, right_state):
    """Return the speed of the front of two powers from compression 1 to r, eq. (14)."""
    if right_state == 0.0:
        return 1.0
    return math.sqrt(-math.expm1(alpha * math.log(right_state)) / (1.0 - right_state))


def front_problem(law, behind, ahead):
    """Return front of a law between two strains, or an InputError where none is to be sought."""
    theory = jump_conditions(law.elastic, behind, ahead, dissipation=law.viscous)
    if theory.direction < 0:
        raise InputError(
            f"states is ({behind:g}, {ahead:g}), but the front between them leaves R = {ahead:g} "
            f"behind it, eq. (17): give ({ahead:g}, {behind:g})."
        )
    with np.errstate(all="ignore"):
        problem = _normalise(law, behind, ahead, theory.speed)
    _check_ends(problem, behind, ahead)
    return problem


def _normalise(law, behind, ahead, speed):
    """Return the problem of a law and two states with the speed that the jump conditions give."""
    jump, proportional = ahead - behind, law.proportional
    elastic, p_behind, p_ahead = _force(law.elastic, behind, ahead, speed**2)
    if proportional is None:
        viscous, q_behind, q_ahead = _force(law.viscous, behind, ahead, speed)
    else:
        viscous = elastic
        q_behind, q_ahead = ((speed * p, speed * slope) for p, slope in (p_behind, p_ahead))
    least, most = sorted((ahead - end) / jump for end in law.domain)
    return FrontProblem(
        elastic=elastic,
        viscous=viscous,
        proportional=proportional is not None,
        damping=1.0 if proportional is None else proportional,
        start=-ahead,
        jump=jump,
        speed=speed,
        behind=End(p_behind[0], q_behind[0], p_behind[1], q_behind[1]),
        ahead=End(p_ahead[0], q_ahead[0], p_ahead[1], q_ahead[1]),
        least=least,
        most=most,
        magnification=max(1.0, abs(ahead / jump), abs(behind / jump)),
    )


def _force(potential, behind, ahead, speeds):
    """Return the function p or q with its value and slope at both states; `speeds` is c² or c."""
    first, second = (row_map(potential, order) for order in (1, 2))
    parameters = [row_parameters(potential, order) for order in (1, 2)]
    scale = 1.0 / (speeds * (ahead - behind))
    force_behind, force_ahead = _two_forces(first, parameters[0], -behind, -ahead)
    # Where V'' jumps, as at the end of a contact, the slope is taken on the compressed side.
    slopes = potential.second(np.array([behind, ahead])) / speeds
    force = Force(first, second, *parameters, force_ahead, scale)
    return force, (scale * (force_behind - force_ahead), float(slopes[0])), (0.0, float(slopes[1]))


def _check_ends(problem, behind, ahead):
    c = problem.speed
    for place, R, end in (("behind", behind, problem.behind), ("ahead of", ahead, problem.ahead)):
        if not math.isfinite(end.p_slope + end.q_slope):
            raise InputError(
                f"V'' or W'' is infinite at R = {R:g}, the state {place} the front (V'' is "
                f"{c**2 * end.p_slope:g}, W'' is {c * problem.damping * end.q_slope:g}), and no "
                "exponential leads to it: choose a state where both are finite."
            )
    if not problem.behind.p_slope > 1.0 > problem.ahead.p_slope:
        raise InputError(
            f"V'' is {c**2 * problem.behind.p_slope:.6g} behind the front and "
            f"{c**2 * problem.ahead.p_slope:.6g} ahead, but a front is sought with c² = "
            f"{c**2:.6g} between them: choose states between which V''' has one sign."
        )
    if not problem.damping * problem.behind.q_slope > 0.0:
        raise InputError(
            f"W'' is 0 at R = {behind:g}, the state behind the front, and waves there never decay: "
            "choose a W that is strictly convex there."
        )


@kernel
def _two_forces(address, parameters, behind, ahead):
    """Return a row map of two compressions."""
    u, forces = np.array([behind, ahead]), np.empty(2)
    call_row_map(address, u, forces, 0, 1, parameters)
    return forces[0], forces[1]


@subroutine
def with_damping(problem, damping):
    """Return the problem with W multiplied by another number, for compiled code."""
    return FrontProblem(
        problem.elastic,
        problem.viscous,
        problem.proportional,
        damping,
        problem.start,
        problem.jump,
        problem.speed,
        problem.behind,
        problem.ahead,
        problem.least,
        problem.most,
        problem.magnification,
    )


@kernel
def evaluate(problem, s, p, q):
    """Write p and q of every s; arrays of shape (points,)."""
    u = problem.start + problem.jump * s
    _write_force(problem.elastic, u, p)
    if problem.proportional:
        _write_multiple(problem.damping * problem.speed, p, q)
    else:
        _write_force(problem.viscous, u, q)
        _write_multiple(problem.damping, q, q)


@subroutine
def evaluate_slopes(problem, s, p_slope, q_slope):
    """Write p' and q' of every s; arrays as of `evaluate`."""
    u = problem.start + problem.jump * s
    _write_slope(problem.elastic, problem.jump, u, p_slope)
    if problem.proportional:
        _write_multiple(problem.damping * problem.speed, p_slope, q_slope)
    else:
        _write_slope(problem.viscous, problem.damping * problem.jump, u, q_slope)


@subroutine
def _write_multiple(factor, values, result):
    """Write a multiple of the values into another array, or into the same."""
    for k in range(uint64(values.size)):
        result[k] = factor * values[k]


@subroutine
def _write_force(force, u, result):
    """Write p, or q for damping 1, at the compressions u."""
    call_row_map(force.first, u, result, 0, u.size - 1, force.first_parameters)
    for k in range(uint64(u.size)):
        result[k] = force.scale * (result[k] - force.ahead)


@subroutine
def _write_slope(force, factor, u, result):
    """Write a multiple of scale·F'(u)."""
    call_row_map(force.second, u, result, 0, u.size - 1, force.second_parameters)
    for k in range(uint64(u.size)):
        result[k] *= factor * force.scale
