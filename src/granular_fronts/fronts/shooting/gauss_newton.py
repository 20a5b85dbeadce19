r"""Gauss-Newton for the equations of a front.

With r the residuals and J their derivative by the unknowns x, a step solves

.. math:: \min_{\delta x} \| J\,\delta x + r \|_2

by reflections (`banded_qr`), J being the exact derivative of the computed flow (`bead_flow`).  The
step is halved until the sum of squares falls.  There are more equations than unknowns, but all of
them hold at a front: r = 0 there, and convergence is quadratic.  A minimum where some equation does
not hold is no front, and is reported as a failure.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.shooting import equations
from granular_fronts.fronts.shooting.bead_flow import Stiffness
from granular_fronts.fronts.shooting.equations import split
from granular_fronts.numerics.banded_qr import solve_least_squares

MOST_STEPS = 40
SHORTEST_FRACTION = 1.0 / 64.0
# Convergence is quadratic: after a smaller step the next one would be lost in rounding.
SETTLED = 1.0e-8
SMALLEST_TOE, LOWEST_STIFFNESS, LARGEST_FALL = 1.0e-12, 0.1, 0.1


class Descent(NamedTuple):
    """A run of Gauss-Newton steps.

    Attributes
    ----------
    unknowns : ndarray
        Where it ended.
    residuals : list of float
        Largest residual before every step and after the last.
    step_sizes : list of float
        Largest change of an unknown in every step.
    flows : int
        Bead-times that the window was moved for.
    reason : str
        What stopped it, empty if it settled.
    """

    unknowns: np.ndarray
    residuals: list
    step_sizes: list
    flows: int
    reason: str


class Attempt(NamedTuple):
    """A damped step: the fraction taken, 0 if none helps, and where it leads."""

    fraction: float
    unknowns: np.ndarray
    rows: np.ndarray
    stiffness: Stiffness
    flows: int


def descend(window, unknowns, tolerance):
    """Gauss-Newton steps until all equations hold and the steps have died out.

    Parameters
    ----------
    window : equations.Window
    unknowns : ndarray
        Where to start.
    tolerance : float
        Largest residual of any equation.

    Returns
    -------
    Descent
    """
    rows, stiffness = equations.residual(window, unknowns)
    residuals, step_sizes, flows = [largest(rows)], [], 1
    reason = f"not settled after {MOST_STEPS} Gauss-Newton steps"
    while len(step_sizes) < MOST_STEPS:
        matrix, lower = equations.jacobian(window, stiffness)
        step = solve_least_squares(matrix, lower, unknowns.size, -rows)
        attempt = _damped(window, unknowns, step, _norm(rows), tolerance)
        flows += attempt.flows
        if attempt.fraction == 0.0:
            reason = (
                f"no part of the Gauss-Newton step lowers the residual {residuals[-1]:.1e}: give a "
                "guess closer to the front, or a longer window"
            )
            break
        unknowns, rows, stiffness = attempt.unknowns, attempt.rows, attempt.stiffness
        residuals.append(largest(rows))
        step_sizes.append(attempt.fraction * largest(step))
        if residuals[-1] <= tolerance and step_sizes[-1] <= SETTLED:
            reason = ""
            break
    return Descent(unknowns, residuals, step_sizes, flows, reason)


def _damped(window, unknowns, step, norm, tolerance):
    """The largest of the halved steps that lowers the norm of the residual, or satisfies all."""
    fraction, flows = 1.0, 0
    while fraction >= SHORTEST_FRACTION:
        trial = _move(window, unknowns, fraction * step)
        rows, stiffness = equations.residual(window, trial)
        flows += 1
        if _norm(rows) < norm or largest(rows) <= tolerance:
            return Attempt(fraction, trial, rows, stiffness, flows)
        fraction *= 0.5
    return Attempt(0.0, unknowns, rows, stiffness, flows)


def _move(window, unknowns, step):
    """Add a step, but let no contact that is stiff fall more than tenfold.

    For α near 1 the toe of the front stays stiff down to u = 1e-12 and less; a step that took u
    below zero there would cut it off.
    """
    moved = unknowns + step
    before, after = (split(window, each)[1][:, 0] for each in (unknowns, moved))
    toe = max(SMALLEST_TOE, LOWEST_STIFFNESS ** (1.0 / (window.law.alpha - 1.0)))
    stiff = before > toe
    after[stiff] = np.maximum(after[stiff], LARGEST_FALL * before[stiff])
    return moved


def largest(values):
    """Largest absolute value."""
    return float(np.abs(values).max())


def _norm(values):
    # A residual that overflows has no norm, and no step is taken towards it.
    with np.errstate(over="ignore"):
        return float(np.linalg.norm(values))
