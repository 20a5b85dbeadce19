r"""The θ-method on a conservative chain, and the damping it brings; James (2021), section 1.

With pressure at the ends the strain form of the conservative chain is :math:`\dot u = d`,
:math:`\dot d = \Delta u_+^\alpha` (`equations` with γ = 0).  A step of length h is

.. math::

    u' = u + h\,\bigl((1-\theta)\,d + \theta\,d'\bigr), \qquad
    d' = d + h\,\bigl((1-\theta)\,\Delta u_+^\alpha + \theta\,\Delta u_+'^\alpha\bigr),

of order 1, and 2 for θ = 1/2.  With the second line in the first, u' solves

.. math:: u' - (h\theta)^2 \Delta u_+'^\alpha = u + h\,d + h^2\theta(1-\theta)\,\Delta u_+^\alpha,

a system whose Jacobian is tridiagonal and diagonally dominant by columns: Newton's method
with elimination needs no pivots.

Modified equation.  To first order in h the method solves :math:`\dot y = f + (\theta -
\tfrac12)h\,f'f`, here

.. math::

    \dot x = v + \tfrac\gamma2 F, \qquad \dot v = F + \tfrac\gamma2 \dot F, \qquad
    \gamma = (2\theta - 1)\,h,

hence :math:`\ddot x = F + \gamma\dot F`, the Kuwabara-Kono law with β = α, while the velocity v of
the method lags behind: :math:`v = \dot x - \tfrac\gamma2 F`.  The rest is of order h².
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted

NEWTON_LIMIT = 50
NEWTON_TOLERANCE = 1.0e-14
"""Largest last correction, relative to the largest relative displacement."""


class ThetaMotion(NamedTuple):
    """Relative displacements and differences of velocities, shape (N − 1,), after the last step."""

    u: np.ndarray
    d: np.ndarray
    converged: bool  # False if Newton's method failed in a step; u and d are then worth nothing.
    iterations: int  # Of Newton's method, in all steps.


def integrate_from_rest(
    alpha: float, beads: int, left: float, right: float, theta: float, step: float, steps: int
) -> ThetaMotion:
    """Integrate a conservative chain at rest, pressed at its ends (25) from t = 0 on.

    `left` and `right` are δ and δ̃, 0 or more; an α below 1, or a θ outside [1/2, 1], is an
    InputError.
    """
    if not 0.5 <= theta <= 1.0:
        raise InputError(
            f"theta is {theta}, but the method is unstable below 1/2 and undefined above 1: give "
            "a number between."
        )
    if not alpha >= 1.0:
        raise InputError(
            f"alpha is {alpha}, but Newton's method needs a finite stiffness at contact: give 1 "
            "or more."
        )
    u, d = np.zeros(beads + 1), np.zeros(beads + 1)
    u[0], u[beads] = left, right
    iterations = advance(u, d, float(alpha), float(theta), float(step), steps)
    inside = slice(1, beads)
    return ThetaMotion(u[inside], d[inside], iterations >= 0, abs(iterations))


@kernel
def advance(u, d, alpha, theta, step, steps):
    """Take steps in place, the ends of u held; Newton's iterations, negative if they fail."""
    size = u.size
    force, stiffness = np.empty(size), np.empty(size)
    target, slope = np.empty(size), np.empty(size)
    correction, factor = np.empty(size), np.empty(size)
    implicit = (step * theta) ** 2
    scale = np.abs(u).max()
    iterations = 0
    _evaluate_force(u, alpha, force, stiffness)
    for _ in range(steps):
        if interrupted():
            break
        for n in range(1, size - 1):
            slope[n] = force[n - 1] - 2.0 * force[n] + force[n + 1]
            explicit = step * d[n] + step**2 * theta * (1.0 - theta) * slope[n]
            target[n] = u[n] + explicit
            u[n] += step * d[n]
        for attempt in range(NEWTON_LIMIT):
            _evaluate_force(u, alpha, force, stiffness)
            _newton_correction(u, target, force, stiffness, implicit, correction, factor)
            largest = 0.0
            for n in range(1, size - 1):
                u[n] += correction[n]
                largest = max(largest, abs(correction[n]))
            iterations += 1
            scale = max(scale, np.abs(u).max())
            if largest <= NEWTON_TOLERANCE * scale:
                break
            if attempt == NEWTON_LIMIT - 1:
                return -iterations
        # A maximum does not see NaN; a sum does.
        if not math.isfinite(u.sum()):
            return -iterations
        _evaluate_force(u, alpha, force, stiffness)
        for n in range(1, size - 1):
            new_slope = force[n - 1] - 2.0 * force[n] + force[n + 1]
            d[n] += step * ((1.0 - theta) * slope[n] + theta * new_slope)
    return iterations


@subroutine
def _evaluate_force(u, alpha, force, stiffness):
    """u₊^α and its derivative, at every contact."""
    for n in range(u.size):
        compression = max(u[n], 0.0)
        stiffness[n] = alpha * compression ** (alpha - 1.0)
        force[n] = compression**alpha


@subroutine
def _newton_correction(u, target, force, stiffness, implicit, correction, factor):
    """Solve (1 − κΔ stiffness) correction = target − u + κΔ force by elimination, κ = implicit."""
    last = u.size - 2
    stiffness[0], stiffness[last + 1] = 0.0, 0.0
    factor[0], correction[0] = 0.0, 0.0
    for n in range(1, last + 1):
        below = -implicit * stiffness[n - 1]
        residual = target[n] - u[n] + implicit * (force[n - 1] - 2.0 * force[n] + force[n + 1])
        pivot = 1.0 + 2.0 * implicit * stiffness[n] - below * factor[n - 1]
        factor[n] = -implicit * stiffness[n + 1] / pivot
        correction[n] = (residual - below * correction[n - 1]) / pivot
    for n in range(last - 1, 0, -1):
        correction[n] -= factor[n] * correction[n + 1]
