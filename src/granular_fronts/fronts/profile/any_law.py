r"""The exact front of any lattice with potentials V and W; James (2021), section 2.

The strain :math:`r_n = x_{n+1} - x_n = R(n - ct)` of a front of the lattice (5) obeys
:math:`c^2 R'' = \Delta_d(V'(R) - c\,\tfrac{d}{d\xi} W'(R))`.  In the variable u and with the
functions p and q of `lattice` u falls from 1 to 0 and obeys the convolution form of `profile`, of
which this is the general case,

.. math::

    c^2 u = \int_{-1}^{1} (1 - |s|)\, p(u(\xi - s))\,ds
          + c \int_{-1}^{1} \operatorname{sgn}(s)\, q(u(\xi - s))\,ds .

Far behind it says :math:`c^2 = p(1)`, eq. (13).  Discretisation, unknowns and phase condition are
those of `profile` and `newton`: c is an unknown, and its distance to (13) measures the solution.

Start.  The long-wave front of `lattice` is good for strong damping; where it is not good enough, W
is first enlarged and then followed back.

Power.  The front loses :math:`c^2 \int W''(R) R'^2\,d\xi`, which eq. (16) says to be |cS|.
"""

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from scipy.linalg import solve_banded

from granular_fronts.fronts.profile.lattice import Lattice, choose_window, long_wave_front
from granular_fronts.numerics import interpolation
from granular_fronts.numerics.quadrature import kernel_weights

ORDER, OTHER_ORDER, REFINED_ORDER = 20, 16, 22
FIRST_SPACING, FINER = Fraction(1, 8), 1.3
ADJUSTMENTS = 12
DEFECT = 2.0e-13
"""Largest difference of two quadrature rules on the final grid."""

AT_REST = 1.0e-13
SPEED_TOLERANCE = 1.0e-12
STEPS, LONGEST_CHANGE, SETTLED, ROUND_OFF = 60, 0.4, 1.0e-15, 1.0e-11
STRONGEST, LONGEST_RATIO, SHORTEST_RATIO = 32.0, 2.0, 1.01


class AnyFront(NamedTuple):
    """A front on its grid.

    Attributes
    ----------
    lattice : Lattice
    spacing : Fraction
        Distance of the points, in sites.
    middle : int
        Index of ξ = 0, where u = 1/2.
    u : ndarray, shape (points,)
    speed : float
    residual : float
        Largest residual of the equations.
    reason : str
        Why this is not a front; empty if it is one.
    """

    lattice: Lattice
    spacing: Fraction
    middle: int
    u: np.ndarray
    speed: float
    residual: float = math.nan
    reason: str = ""

    @property
    def xi(self):
        """Coordinates of the points, shape (points,)."""
        return float(self.spacing) * np.arange(-self.middle, self.u.size - self.middle)

    @property
    def strain(self):
        """R at the points, shape (points,)."""
        return self.lattice.strain(self.u)

    @property
    def strain_slope(self):
        """R' at the points, shape (points,)."""
        return self._slope() * (self.lattice.behind - self.lattice.ahead)

    def _slope(self):
        return interpolation.derivative(self.u, 1.0, 0.0) / float(self.spacing)

    def evaluate(self, xi):
        """Values of u at any positions, 1-D."""
        return interpolation.interpolate_all(
            self.u, xi / float(self.spacing) + self.middle, 1.0, 0.0
        )

    def evaluate_slope(self, xi):
        """Values of u' at any positions, 1-D."""
        return interpolation.interpolate_all(
            self._slope(), xi / float(self.spacing) + self.middle, 0.0, 0.0
        )

    def dissipated_power(self):
        """Power that the whole front loses; the trapezoidal rule is spectral here."""
        # W'' may be infinite where nothing moves any more.
        moving = np.abs(self.strain_slope) > 0.0
        viscosity = self.lattice.viscosity(self.u[moving])
        losses = viscosity * self.strain_slope[moving] ** 2
        return self.speed**2 * float(self.spacing) * float(losses.sum())


def solve_any_front(lattice):
    """The front of a lattice from nothing.

    Parameters
    ----------
    lattice : Lattice

    Returns
    -------
    AnyFront
        With a `reason` if it is not the front.
    """
    window = choose_window(lattice)
    front = _from_long_wave(lattice, window)
    if front.reason:
        front = _from_stronger_damping(lattice, window)
    for _ in range(ADJUSTMENTS):
        if front.reason:
            return front
        longer, spacing = lacking_window(front, window), front.spacing
        if longer == window:
            if quadrature_defect(front) <= DEFECT:
                return front
            spacing = Fraction(1, math.ceil(FINER / front.spacing))
        window = longer
        front = solve_on_grid(lattice, window, spacing, ORDER, front.evaluate)
    return front._replace(
        reason=f"{ADJUSTMENTS} adjustments of window and grid are not enough: the front is too "
        "sharp, or decays too slowly"
    )


def refine(front):
    """The same front on a finer grid, by another order, on a longer window."""
    spacing = Fraction(1, math.ceil(1.4 / front.spacing))
    window = (-1.15 * front.xi[0], 1.15 * front.xi[-1])
    return solve_on_grid(front.lattice, window, spacing, REFINED_ORDER, front.evaluate)


def _from_long_wave(lattice, window):
    start = long_wave_front(lattice)
    return solve_on_grid(lattice, window, FIRST_SPACING, ORDER, start)


def _from_stronger_damping(lattice, window):
    """Follow the front from strong damping, by steps as long as Newton's iteration allows."""
    strong = lattice._replace(factor=STRONGEST * lattice.factor)
    known = _from_long_wave(strong, choose_window(strong))
    ratio = LONGEST_RATIO
    while not known.reason and ratio > SHORTEST_RATIO:
        weaker = lattice._replace(factor=max(lattice.factor, known.lattice.factor / ratio))
        there = window if weaker == lattice else choose_window(weaker)
        attempt = solve_on_grid(weaker, there, FIRST_SPACING, ORDER, known.evaluate)
        if attempt.reason:
            ratio = math.sqrt(ratio)
            continue
        if weaker == lattice:
            return attempt
        known = attempt
    return known._replace(reason=known.reason or "no way leads from strong damping to this one")


def lacking_window(front, window):
    """The window, longer at the ends that are not at rest."""
    behind = np.abs(front.u[:4] - 1.0).max() > AT_REST
    ahead = np.abs(front.u[-4:]).max() > AT_REST
    return window[0] * (1.2 if behind else 1.0), window[1] * (1.3 if ahead else 1.0)


def quadrature_defect(front):
    """Largest difference of the right-hand sides by rules of orders 20 and 16, over c²."""
    fine, other = (kernel_weights(front.spacing, order) for order in (ORDER, OTHER_ORDER))
    more = (fine.hat.size - other.hat.size) // 2
    hat, jump = fine.hat - np.pad(other.hat, more), fine.jump - np.pad(other.jump, more)
    difference = _right_side(front.lattice, hat, jump, front.u, front.speed)
    return float(np.abs(difference).max()) / front.speed**2


def solve_on_grid(lattice, window, spacing, order, start):
    """The front on one grid, by Newton's iteration.

    Parameters
    ----------
    lattice : Lattice
    window : tuple of float
        Lengths behind and ahead.
    spacing : Fraction
    order : int
        Points of the local polynomials.
    start : callable
        u at given ξ.

    Returns
    -------
    AnyFront
    """
    middle = math.ceil(window[0] / spacing)
    points = middle + 1 + math.ceil(window[1] / spacing)
    front = AnyFront(lattice, spacing, middle, np.empty(points), lattice.speed)
    u = start(front.xi)
    u[middle] = 0.5
    c, before = lattice.speed, math.inf
    weights = kernel_weights(spacing, order)
    for _ in range(STEPS):
        try:
            # A wild iterate overflows, and is noticed by its residual.
            with np.errstate(all="ignore"):
                step, change, residual = _newton_step(lattice, weights, middle, u, c)
        except np.linalg.LinAlgError:
            break
        largest = float(np.abs(step).max())
        part = min(1.0, LONGEST_CHANGE / largest)
        u, c = u + part * step, c + part * change
        if largest <= SETTLED or (largest < ROUND_OFF and largest >= 0.5 * before):
            return _judge(front._replace(u=u, speed=c, residual=residual))
        before = largest
    return front._replace(u=u, speed=c, reason="Newton's iteration does not settle")


def _judge(front):
    """The front, with the reason why it is none if it is none."""
    defect = front.speed / front.lattice.speed - 1.0
    if abs(defect) > SPEED_TOLERANCE:
        return front._replace(reason=f"the speed is wrong by {defect:.1e}: this is not a front")
    if front.u[front.middle + 1 :].max() >= 0.5:
        return front._replace(reason="another part of the wave is at xi = 0")
    return front


def _right_side(lattice, hat, jump, u, c):
    half = hat.size // 2
    padded = np.pad(u, half, constant_values=(1.0, 0.0))
    convolved = np.correlate(lattice.elastic(padded), hat, "valid")
    return convolved + c * np.correlate(lattice.viscous(padded), jump, "valid")


def _newton_step(lattice, weights, middle, u, c):
    """Change of u and of c, and the largest residual; equations ordered as `newton` explains."""
    hat, jump = weights.hat, weights.jump
    half, points = hat.size // 2, u.size
    residuals = c**2 * u - _right_side(lattice, hat, jump, u, c)
    if not np.isfinite(residuals).all():
        raise np.linalg.LinAlgError("no finite residuals")
    of_speed = 2.0 * c * u - _right_side(lattice, 0.0 * hat, jump, u, 1.0)
    stiffness, viscosity = lattice.stiffness(u), c * lattice.viscosity(u)
    band = np.zeros((2 * half + 2, points))
    border = np.zeros(points)
    border[0] = c**2
    for offset in range(-half, half + 1):
        # The coefficient of u_j in equation i = j − offset.
        weight = half + offset
        column = -hat[weight] * stiffness - jump[weight] * viscosity
        if offset == 0:
            column = column + c**2
        if offset >= 0:
            border[offset] = column[offset]
        equation = np.arange(points) - offset
        early = (equation >= 1) & (equation <= middle)
        late = (equation > middle) & (equation < points)
        band[half - offset, early] = column[early]
        band[half + 1 - offset, late] = column[late]
    band[half + 1, middle] = 1.0
    right = np.column_stack([-residuals, of_speed])
    right[:middle] = right[1 : middle + 1]
    right[middle] = 0.5 - u[middle], 0.0
    solution = solve_banded((half, half + 1), band, right)
    first = border @ solution
    change = (-residuals[0] - first[0]) / (of_speed[0] - first[1])
    return solution[:, 0] - change * solution[:, 1], change, float(np.abs(residuals).max())
