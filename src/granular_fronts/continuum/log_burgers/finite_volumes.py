r"""Sixth-order finite volumes for the amplitude equations of section 4.

In the frame :math:`\tilde\xi = \xi - \tau` equations (40) and (41) of James (2021) are conservation
laws for :math:`v = y^{1/\alpha}`,

.. math::

    \partial_\tau v + \partial_{\tilde\xi} F(v) = \partial^2_{\tilde\xi} v^\alpha, \qquad
    F(v) = f_\alpha(v^\alpha) - v
         = v\,\Bigl(\alpha\,\frac{v^{\alpha-1} - 1}{\alpha - 1} - 1\Bigr),

whose limit :math:`\alpha \to 1^+` is :math:`F = v\ln v - v` with linear diffusion, that is, the
advective form (50), since :math:`\partial F = \ln v\;\partial v`.  Here `alpha` = 1 means the
limit.

Discretisation.  The unknowns are averages of v over N equal cells of a ring of length
:math:`2\ell`.  Their exact rates of change are differences of the flux :math:`F(v) - \alpha
v^{\alpha-1}\partial v` at the cells' edges. There v and its derivative are reconstructed from the
six nearest averages:

.. math::

    v_{i+1/2} &\approx \tfrac{1}{60}\bigl[37(\bar v_i + \bar v_{i+1})
        - 8(\bar v_{i-1} + \bar v_{i+2}) + (\bar v_{i-2} + \bar v_{i+3})\bigr], \\
    \Delta\, v'_{i+1/2} &\approx \tfrac{49}{36}(\bar v_{i+1} - \bar v_i)
        - \tfrac{5}{36}(\bar v_{i+2} - \bar v_{i-1}) + \tfrac{1}{90}(\bar v_{i+3} - \bar v_{i-2}).

Both are of sixth order in the cell width :math:`\Delta`.  A flux leaves one cell and enters the
next, so that the mean of v is kept to round-off whatever the flux.

Small values.  Below `floor` the logarithm (or the power) in F is frozen at the floor.  This changes
F by at most floor/e, for a floor of 1e-16 less than the rounding of F.  It makes a start that
vanishes identically harmless.

Lower bound.  The exact solution stays above the smallest value of its start, but a reconstruction
need not.  `lift` fills cells that fell below the bound from the nearest cells that can spare it,
and so keeps the mean.
"""

import functools
from typing import NamedTuple

import numpy as np

from granular_fronts.numerics.compiled import subroutine
from granular_fronts.numerics.vector_functions import exponential_less_one, logarithm

GHOSTS = 3
VALUE_WEIGHTS = (37.0 / 60.0, -8.0 / 60.0, 1.0 / 60.0)
SLOPE_WEIGHTS = (49.0 / 36.0, -5.0 / 36.0, 1.0 / 90.0)
# Largest eigenvalue of the discrete second derivative, times −Δ².
DIFFUSION_RADIUS = 272.0 / 45.0


class Equation(NamedTuple):
    """What is solved, and on which cells."""

    alpha: float  # exponent of (40), above 1; exactly 1 means its limit (41)
    floor: float  # where logarithm and power are frozen; positive
    bound: float  # lower bound of v, at least 0
    width: float  # of a cell


class Work(NamedTuple):
    """Arrays of one right-hand side over the edges; `padded` holds the cells and their ghosts."""

    padded: np.ndarray
    value: np.ndarray
    gradient: np.ndarray


def make_work(cells):
    """Return the work space for a number of cells."""
    return Work(np.zeros(cells + 2 * GHOSTS), np.zeros(cells + 1), np.zeros(cells + 1))


def symbols(angle):
    """Return what the differences of this scheme make of a wave of a given angle per cell.

    −Δ² times the discrete second derivative, and Δ/i times the first, each of the shape of
    `angle`.
    """
    odd = np.multiply.outer(np.asarray(angle), np.arange(GHOSTS) + 0.5)
    over_cell = 4.0 * np.sin(0.5 * np.asarray(angle))
    return over_cell * (np.sin(odd) @ SLOPE_WEIGHTS), over_cell * (np.cos(odd) @ VALUE_WEIGHTS)


@subroutine
def _reconstruct(width, averages, work):
    """Values and derivatives of v at the edges, into `work`; edge i lies left of cell i."""
    n = averages.size
    for i in range(n):
        work.padded[GHOSTS + i] = averages[i]
    for i in range(GHOSTS):
        work.padded[i], work.padded[n + GHOSTS + i] = averages[n - GHOSTS + i], averages[i]
    far_left, left, near_left = work.padded[:-5], work.padded[1:-4], work.padded[2:-3]
    near_right, right, far_right = work.padded[3:-2], work.padded[4:-1], work.padded[5:]
    v0, v1, v2 = VALUE_WEIGHTS
    s0, s1, s2 = SLOPE_WEIGHTS[0] / width, SLOPE_WEIGHTS[1] / width, SLOPE_WEIGHTS[2] / width
    value, gradient = work.value, work.gradient
    for i in range(n + 1):
        inner, middle = near_left[i] + near_right[i], left[i] + right[i]
        value[i] = v0 * inner + v1 * middle + v2 * (far_left[i] + far_right[i])
        inner, middle = near_right[i] - near_left[i], right[i] - left[i]
        gradient[i] = s0 * inner + s1 * middle + s2 * (far_right[i] - far_left[i])


@subroutine
def evaluate_rates(equation, averages, work, rates):
    """Time derivative of the cell averages, into `rates`."""
    _reconstruct(equation.width, averages, work)
    value, gradient, flux = work.value, work.gradient, work.value
    if equation.alpha == 1.0:
        for i in range(value.size):
            wind = logarithm(max(value[i], equation.floor))
            flux[i] = value[i] * (wind - 1.0) - gradient[i]
    else:
        alpha, excess = equation.alpha, equation.alpha - 1.0
        steepness = alpha / excess
        for i in range(value.size):
            growth = exponential_less_one(excess * logarithm(max(value[i], equation.floor)))
            advected = value[i] * (steepness * growth - 1.0)
            flux[i] = advected - alpha * (growth + 1.0) * gradient[i]
    per_width = 1.0 / equation.width
    for i in range(averages.size):
        rates[i] = (flux[i] - flux[i + 1]) * per_width


@subroutine
def advection_and_diffusion(equation, smallest, largest):
    """Return the largest c²/D and largest D over values between two extremes.

    Both c = dF/dv and D = α v^(α−1) grow with v, and c²/D is largest at one of the ends.
    """
    excess = equation.alpha - 1.0
    strength, diffusion = 0.0, 0.0
    for v in (max(smallest, equation.floor), max(largest, equation.floor)):
        growth = np.expm1(excess * np.log(v))
        d = equation.alpha * (growth + 1.0)
        c = np.log(v) if excess == 0.0 else equation.alpha * (d - 1.0) / excess - 1.0
        strength, diffusion = max(strength, c * c / d), max(diffusion, d)
    return strength, diffusion


@subroutine
def lift(averages, bound):
    """Raise every average to the bound at the expense of the nearest that can spare it.

    Returns the largest shortfall met.
    """
    n, worst = averages.size, 0.0
    for i in range(n):
        missing = bound - averages[i]
        if missing <= 0.0:
            continue
        worst = max(worst, missing)
        averages[i] = bound
        for distance in range(1, n // 2 + 1):
            for donor in ((i + distance) % n, (i - distance) % n):
                given = min(missing, max(averages[donor] - bound, 0.0))
                averages[donor] -= given
                missing -= given
            if missing <= 0.0:
                break
    return worst


@functools.cache
def _polynomial_weights():
    """Return monomial coefficients on a cell, |s| ≤ 1/2, from averages around it."""
    cells = np.arange(-GHOSTS, GHOSTS + 1)
    powers = np.arange(1, cells.size + 1)
    left, right = cells[:, None] - 0.5, cells[:, None] + 0.5
    integrals = (right**powers - left**powers) / powers
    return np.linalg.inv(integrals)


def point_values(averages, half_length, xi, floor):
    """Return the values of v at any points, taken modulo 2ℓ, of seventh order in the cell width.

    The polynomial of degree 6 has the averages of the nearest seven cells, and is raised to the
    floor where it is below.
    """
    place = np.mod((np.asarray(xi) + half_length) / (2.0 * half_length), 1.0) * averages.size
    cell = np.minimum(place.astype(int), averages.size - 1)
    neighbours = np.arange(-GHOSTS, GHOSTS + 1)
    nearby = averages[np.mod(np.add.outer(cell, neighbours), averages.size)]
    coefficients = nearby @ _polynomial_weights().T
    values = np.polynomial.polynomial.polyval(place - cell - 0.5, coefficients.T, tensor=False)
    return np.maximum(values, floor)
