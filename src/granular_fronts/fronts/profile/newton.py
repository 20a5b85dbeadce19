"""Newton's iteration for the discretised profile equation of `equation`, compiled.

Unknowns are the values s at all grid points of the window, and the speed σ in units of the exact
one.  With the weights of the two convolutions the equations are σ² s = hat * p + σ jump * q.  On
the left the linearised operator has index +1: without further conditions it is solved by a family,
the shifts of the front.  The phase condition, s = 1/2 at ξ = 0, picks one, and one equation is left
over, the one at the far left, which determines σ.  In the matrix the equations 1 … middle are
therefore one row higher than their unknowns.  The phase condition is in row `middle`, and equation
0 and the column of σ make the border.  Thus ordered, the band matrix has well-conditioned factors
without pivoting: the shift turns the index of its left part into zero.  Ordered without the shift,
it would be singular to working precision, with solutions that satisfy all equations and are false.
"""

from typing import NamedTuple

import numpy as np
from numba import int64, uint64

from granular_fronts.fronts.profile.equation import evaluate, evaluate_slopes
from granular_fronts.numerics.band import factorise, product, substitute
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted

SETTLED, WANDERING, NOT_FINITE = range(3)


class Grid(NamedTuple):
    """A uniform grid, and weights of the two convolutions of shape (2w + 1,)."""

    spacing: float  # in sites
    middle: int  # index of the point ξ = 0
    hat: np.ndarray
    jump: np.ndarray


class Unknowns(NamedTuple):
    """The unknowns s, shape (points,), and σ, shape (1,)."""

    s: np.ndarray
    speed: np.ndarray


class Forces(NamedTuple):
    """p and q, or their slopes, at the points and at w more on either side, where s is given."""

    p: np.ndarray
    q: np.ndarray


# Longest change of s in one step, and the step after which the factors are kept.
LONGEST_CHANGE = 0.4
KEEP_FACTORS = 1e-5

# How close to 1 s must be for its equations to count in the matrix as those of the state behind.
# Over how many sites their factors settle.
STEADY = 1e-4
SETTLING = 16.0

# Steps of this size that shrink no more are round-off.
ROUND_OFF = 1e-11


@kernel(error_model="numpy")
def iterate(problem, grid, tolerance, unknowns, history):
    """Iterate from the unknowns to the solution; return the steps taken and how it ended.

    It settles when the next change would be below the tolerance.  The history, one longer than the
    steps allowed, receives the largest residual before each step and after the last.
    """
    s, speed = unknowns
    points, width, middle = s.size, grid.hat.size // 2, grid.middle
    forces = make_forces(points, width)
    residual, x, z = np.empty(points), np.empty(points), np.empty(points)
    border = np.empty(width + 1)
    damping_number = problem.damping * problem.behind.q
    last = change = 1.0
    fresh = True
    for step in range(history.size):
        fill_forces(problem, s, forces)
        history[step] = residuals(problem, grid, unknowns, forces, residual)
        if not history[step] < 1e6:
            return step, NOT_FINITE
        if step > 0:
            # One step with new factors is taken to leave a share by which they could be kept.
            remaining = change * (change / last if step > 1 else KEEP_FACTORS)
            solved = history[step] < 100.0 * tolerance * (1.0 + damping_number)
            if solved and (remaining < tolerance or 0.5 * last < change < ROUND_OFF):
                return step, SETTLED
            last = change
        if step + 1 == history.size or interrupted():
            break
        if fresh:
            steady = _steady_points(s, middle, STEADY * min(1.0, last))
            prefix = width + int(SETTLING / grid.spacing)
            skipped = steady - prefix
            if skipped <= width:
                prefix, skipped = points, 0
            band = np.empty((points - skipped, 2 * width + 2))
            corner = _assemble(problem, grid, unknowns, forces, prefix, band, border, z)
            factorise(band, width, prefix)
            substitute(band, width, prefix, skipped, z)
            pivot = corner - product(border, z)
        for k in range(points):
            x[k] = residual[k + 1 if k < middle else k]
        x[middle] = s[middle] - 0.5
        substitute(band, width, prefix, skipped, x)
        speed_change = (residual[0] - product(border, x)) / pivot
        change = 0.0
        for k in range(points):
            x[k] -= speed_change * z[k]
            change = max(change, abs(x[k]))
        factor = min(1.0, LONGEST_CHANGE / change) if change > 0.0 else 1.0
        for k in range(points):
            s[k] -= factor * x[k]
        speed[0] -= factor * speed_change
        fresh = change > KEEP_FACTORS or change > 0.01 * last
    return step, WANDERING


@kernel
def make_forces(points, width):
    """Return the room for p and q."""
    return Forces(np.zeros(points + 2 * width), np.zeros(points + 2 * width))


@kernel
def fill_forces(problem, s, forces):
    """Write p and q at the points, and of the states of both ends beyond them."""
    p, q = forces
    width = (p.size - s.size) // 2
    p[:width], q[:width] = problem.behind.p, problem.damping * problem.behind.q
    evaluate(problem, s, p[width:-width], q[width:-width])
    p[p.size - width :] = q[p.size - width :] = 0.0


@kernel(fastmath=True)
def residuals(problem, grid, unknowns, forces, residual):
    """Fill in the residuals of all equations; return the largest."""
    s, speed = unknowns.s, unknowns.speed[0]
    p, q = forces
    largest = 0.0
    drag = speed * grid.jump
    if problem.proportional:
        both = grid.hat + problem.damping * problem.speed * drag
        for k in range(s.size):
            total = 0.0
            for j in range(both.size):
                total += both[j] * p[k + j]
            residual[k] = speed * speed * s[k] - total
    else:
        for k in range(s.size):
            total = 0.0
            for j in range(drag.size):
                total += grid.hat[j] * p[k + j] + drag[j] * q[k + j]
            residual[k] = speed * speed * s[k] - total
    for k in range(s.size):
        # A NaN must not be lost in the comparison.
        if not abs(residual[k]) <= largest:
            largest = abs(residual[k])
    return largest


@kernel
def largest_convolution(problem, grid, s):
    """Return the largest value of hat * p + jump * q for any weights."""
    forces = make_forces(s.size, grid.hat.size // 2)
    fill_forces(problem, s, forces)
    nothing = Unknowns(np.zeros(s.size), np.ones(1))
    return residuals(problem, grid, nothing, forces, np.empty(s.size))


@subroutine(fastmath=True)
def _assemble(problem, grid, unknowns, forces, prefix, band, border, column):
    """Fill in the matrix, the border row of equation 0 and the column of σ; return the corner."""
    # After row ``prefix - 1`` of the band as many rows are left out as it is short of the points.
    s, speed, middle = unknowns.s, unknowns.speed[0], grid.middle
    points, width = s.size, grid.hat.size // 2
    skipped = points - band.shape[0]
    slopes = make_forces(points, width)
    evaluate_slopes(problem, s, slopes.p[width:-width], slopes.q[width:-width])
    drag = speed * grid.jump
    for i in range(band.shape[0]):
        k = i if i < prefix else i + skipped
        shift = 1 if k < middle else 0
        equation = k + shift
        band[i, 0] = band[i, 2 * width + 1] = 0.0
        row, elastic, viscous = band[i, shift:], slopes.p[equation:], slopes.q[equation:]
        for j in range(uint64(drag.size)):
            row[j] = -(grid.hat[j] * elastic[j] + drag[j] * viscous[j])
        row[width] += speed * speed
    band[middle - skipped, :] = 0.0
    band[middle - skipped, width] = 1.0
    for k in range(points):
        column[k] = _speed_slope(grid, unknowns, forces, k + 1 if k < middle else k)
    column[middle] = 0.0
    for j in range(width, 2 * width + 1):
        border[j - width] = -(grid.hat[j] * slopes.p[j] + drag[j] * slopes.q[j])
    border[0] += speed * speed
    return _speed_slope(grid, unknowns, forces, int64(0))


@subroutine(fastmath=True)
def _speed_slope(grid, unknowns, forces, equation):
    """Return the derivative of one equation with respect to σ."""
    viscous = product(grid.jump, forces.q[equation:])
    return 2.0 * unknowns.speed[0] * unknowns.s[equation] - viscous


@subroutine
def _steady_points(s, middle, tolerance):
    """Return how many points at the left end have s = 1 within a tolerance."""
    for k in range(middle):
        if abs(s[k] - 1.0) > tolerance:
            return k
    return middle
