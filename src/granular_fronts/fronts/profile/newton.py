"""Newton's iteration for the discretised profile equation of `profile`, compiled.

Unknowns are the values u at all grid points of the window, and the speed c.  On the left the
linearised operator has index +1: without further conditions it is solved by a family, the shifts of
the front.  The phase condition picks one, and one equation is left over, the one at the far left,
which determines c.  In the matrix the equations 1 … middle therefore stand one row higher than
their unknowns, the phase condition stands in row `middle`, and equation 0 and the column of c make
the border.  Thus ordered, the band matrix has well-conditioned factors without pivoting: the shift
turns the index of its left part into zero.  Ordered without the shift, it would be singular to
working precision, with solutions that satisfy all equations and are false.
"""

from typing import NamedTuple

import numpy as np
from numba import uint64

from granular_fronts.numerics.band import factorise, product, substitute
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.vector_functions import power

SETTLED, WANDERING, NOT_FINITE = range(3)


class Law(NamedTuple):
    """What the equation depends on: exponents α and β, damping γ, state ahead r, exact speed c₀."""

    alpha: float
    beta: float
    gamma: float
    ahead: float
    speed: float


# Longest change of u in one step, and the step after which the factors are kept.
LONGEST_CHANGE = 0.4
KEEP_FACTORS = 1e-5

# How close to 1 u must be for its equations to count as those of the state behind, in the matrix,
# and over how many sites their factors settle.
STEADY = 1e-4
SETTLING = 16.0

# The power is taken of normal numbers only.
SMALLEST = 1e-300

# Steps of this size that stop to shrink are round-off.
ROUND_OFF = 1e-11


@kernel(error_model="numpy")
def iterate(law, hat, jump, spacing, middle, half, tolerance, u, speed, history):
    """Solve the equations by Newton's iteration from a start.

    Parameters
    ----------
    law : Law
    hat, jump : ndarray, shape (2w + 1,)
        Weights of the two convolutions.
    spacing : float
        Distance of the points, in sites.
    middle : int
        Index of the point where u is prescribed.
    half : float
        Its value there.
    tolerance : float
        The iteration ends when the next change would be below it.
    u : ndarray, shape (points,)
        Start, then solution.
    speed : ndarray, shape (1,)
        Likewise c.
    history : ndarray, shape (steps + 1,)
        Receives the largest residual before each step and after the last.

    Returns
    -------
    steps, status : int
    """
    points, width = u.size, hat.size // 2
    force = np.empty(points + 2 * width)
    damping = np.empty(points + 2 * width)
    residual = np.empty(points)
    border = np.empty(width + 1)
    x, z = np.empty(points), np.empty(points)
    last = change = 1.0
    fresh = True
    for step in range(history.size):
        forces(law, width, u, force, damping)
        history[step] = residuals(law, hat, jump, u, speed[0], force, damping, residual)
        if not history[step] < 1e6:
            return step, NOT_FINITE
        if step > 0:
            remaining = change * change / last if step > 1 else change
            solved = history[step] < 100.0 * tolerance * (1.0 + law.gamma)
            if solved and (remaining < tolerance or 0.5 * last < change < ROUND_OFF):
                return step, SETTLED
            last = change
        if step + 1 == history.size or interrupted():
            break
        if fresh:
            steady = steady_points(u, middle, STEADY * min(1.0, last))
            prefix = width + int(SETTLING / spacing)
            skipped = steady - prefix
            if skipped <= width:
                prefix, skipped = points, 0
            band = np.empty((points - skipped, 2 * width + 2))
            corner = assemble(
                law, hat, jump, middle, u, speed[0], damping, prefix, skipped, band, border, z
            )
            factorise(band, width, prefix)
            substitute(band, width, prefix, skipped, z)
            pivot = corner - product(border, z)
        x[:middle] = residual[1 : middle + 1]
        x[middle] = u[middle] - half
        x[middle + 1 :] = residual[middle + 1 :]
        substitute(band, width, prefix, skipped, x)
        speed_change = (residual[0] - product(border, x)) / pivot
        change = 0.0
        for k in range(points):
            x[k] -= speed_change * z[k]
            change = max(change, abs(x[k]))
        factor = min(1.0, LONGEST_CHANGE / change) if change > 0.0 else 1.0
        for k in range(points):
            u[k] -= factor * x[k]
        speed[0] -= factor * speed_change
        fresh = change > KEEP_FACTORS or change > 0.01 * last
    return step, WANDERING


@kernel
def forces(law, width, u, force, damping):
    """Fill in u₊^α − r^α and u₊^β − r^β, the states of both ends included."""
    rest, drag = law.ahead**law.alpha, law.ahead**law.beta
    for k in range(width):
        force[k], damping[k] = 1.0 - rest, 1.0 - drag
        force[force.size - 1 - k] = damping[force.size - 1 - k] = 0.0
    inside = slice(width, width + u.size)
    raise_to(law.alpha, u, force[inside])
    if law.beta == law.alpha:
        damping[inside] = force[inside]
    else:
        raise_to(law.beta, u, damping[inside])
    force[inside] -= rest
    damping[inside] -= drag


@kernel(fastmath={"contract"})
def raise_to(exponent, u, result):
    """Write u₊^exponent, by roots where they do and else by the vectorised power."""
    if exponent == 1.5:
        for k in range(uint64(u.size)):
            value = max(u[k], 0.0)
            result[k] = value * np.sqrt(value)
    elif exponent == 0.5:
        for k in range(uint64(u.size)):
            result[k] = np.sqrt(max(u[k], 0.0))
    elif exponent == 0.0:
        result[:] = 1.0
    else:
        for k in range(uint64(u.size)):
            whole = power(u[k], exponent)
            result[k] = whole if u[k] > SMALLEST else 0.0


@kernel(fastmath=True)
def residuals(law, hat, jump, u, speed, force, damping, residual):
    """Fill in the residuals of all equations; return the largest."""
    largest = 0.0
    drag = law.gamma * speed * jump
    if law.beta == law.alpha:
        both = hat + drag
        for k in range(u.size):
            total = 0.0
            for j in range(hat.size):
                total += both[j] * force[k + j]
            residual[k] = speed * speed * (u[k] - law.ahead) - total
    else:
        for k in range(u.size):
            total = 0.0
            for j in range(hat.size):
                total += hat[j] * force[k + j] + drag[j] * damping[k + j]
            residual[k] = speed * speed * (u[k] - law.ahead) - total
    for k in range(u.size):
        # A NaN must not be lost in the comparison.
        if not abs(residual[k]) <= largest:
            largest = abs(residual[k])
    return largest


@kernel
def largest_convolution(law, hat, jump, u):
    """Largest value of hat * P + γc₀ jump * Q for any weights."""
    width = hat.size // 2
    force, damping = np.empty(u.size + 2 * width), np.empty(u.size + 2 * width)
    forces(law, width, u, force, damping)
    at_rest = np.full(u.size, law.ahead)
    return residuals(law, hat, jump, at_rest, law.speed, force, damping, np.empty(u.size))


@kernel(fastmath=True)
def assemble(law, hat, jump, middle, u, speed, damping, prefix, skipped, band, border, column):
    """Fill in the matrix, the border row of equation 0 and the column of c; return the corner."""
    points, width = u.size, hat.size // 2
    stiffness, viscosity = np.empty(points + 2 * width), np.empty(points + 2 * width)
    slopes(law, width, u, stiffness, viscosity)
    drag = law.gamma * speed * jump
    for i in range(band.shape[0]):
        k = i if i < prefix else i + skipped
        shift = 1 if k < middle else 0
        equation = k + shift
        band[i, 0] = band[i, 2 * width + 1] = 0.0
        row, elastic, viscous = band[i, shift:], stiffness[equation:], viscosity[equation:]
        for j in range(uint64(hat.size)):
            row[j] = -(hat[j] * elastic[j] + drag[j] * viscous[j])
        row[width] += speed * speed
    band[middle - skipped, :] = 0.0
    band[middle - skipped, width] = 1.0
    for k in range(points):
        column[k] = speed_slope(law, jump, u, speed, damping, k + 1 if k < middle else k)
    column[middle] = 0.0
    for j in range(width, 2 * width + 1):
        border[j - width] = -(hat[j] * stiffness[j] + drag[j] * viscosity[j])
    border[0] += speed * speed
    return speed_slope(law, jump, u, speed, damping, 0)


@kernel(fastmath=True)
def slopes(law, width, u, stiffness, viscosity):
    """Fill in αu₊^(α−1) and βu₊^(β−1); zero outside the window, where u is given."""
    stiffness[:] = 0.0
    viscosity[:] = 0.0
    inside = slice(width, width + u.size)
    raise_to(law.alpha - 1.0, u, stiffness[inside])
    stiffness[inside] *= law.alpha
    if law.beta == law.alpha:
        viscosity[inside] = stiffness[inside]
    else:
        raise_to(law.beta - 1.0, u, viscosity[inside])
        viscosity[inside] *= law.beta


@kernel(fastmath=True)
def speed_slope(law, jump, u, speed, damping, equation):
    """Derivative of one equation with respect to c."""
    drag = law.gamma * product(jump, damping[equation:])
    return 2.0 * speed * (u[equation] - law.ahead) - drag


@kernel
def steady_points(u, middle, tolerance):
    """How many points at the left end have u = 1 within a tolerance."""
    for k in range(middle):
        if abs(u[k] - 1.0) > tolerance:
            return k
    return middle
