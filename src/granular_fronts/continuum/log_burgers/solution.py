r"""Solving the amplitude equations (40) and (41) of a periodic scene, kinks and all.

Both equations are solved in the frame :math:`\tilde\xi = \xi - \tau` on
:math:`-\ell \le \tilde\xi \le \ell`, with the sixth-order finite volumes of `finite_volumes` and
the fourth-order steps of `time_steps`.

Kinks of the start.  On cells of width :math:`\Delta` a kink leaves an error of order
:math:`\Delta^3`, even from exact averages.  No later smoothness removes it, and the rest is of
order six.  But diffusivity :math:`D` smooths the kink over :math:`\sqrt{D\tau}`, which soon exceeds
a cell.  A run therefore begins on cells that are :math:`2^L` times finer, L = `start_levels`, and
pairs of cells are joined, by their exact mean, whenever

.. math:: \tau = (s\Delta)^2 / D_{min},

where :math:`\Delta` is the present width, s = `SMOOTH_CELLS`, and :math:`D_{min} = \alpha
v_{min}^{\alpha-1}` the least diffusivity, 1 for the logarithmic equation. Each level covers a
quarter of the time of the next, so all together cost little. The error of the kink falls by
:math:`8^L`.

Foot of the wave.  A front (46) of (40) ends on zero as :math:`v \sim (\xi_0 - \xi)^{1/(\alpha-1)}`,
for :math:`\alpha = 3/2` with a jump of its second derivative.  The floor of the start rounds it
only over :math:`D_{min}`, a hundredth of a cell.  Only about the foot the error therefore stays of
second order, however fine the start.  Two levels are enough, and a third would last long, since
:math:`D_{min}` is small.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_burgers import finite_volumes, time_steps
from granular_fronts.continuum.log_burgers.starts import Given, Plateau, make_start
from granular_fronts.errors import SolveError

START_LEVELS, LEVELS_WITH_FOOT, SMOOTH_CELLS = 3, 2, 2.0
# Below it F(y) = y ln y − y is smaller than the rounding of a sum of order 1.
SMALLEST_ARGUMENT = 1.0e-16
# Diffusivity of (40), relative to that at v = 1, below which it is frozen.
SMALLEST_DIFFUSIVITY = 1.0e-3
FIRST_STEP = 1.0e-6
SOLVER = "sixth-order finite volumes, strong-stability-preserving Runge-Kutta steps of order 4"


class Evolution(NamedTuple):
    """Cell averages of v = y^(1/α) at some times; α = 1 for the logarithmic equation."""

    start: Plateau | Given
    times: np.ndarray  # times t of the chain, shape (times,)
    averages: list  # one for each time, over as many cells as the run had then
    half_length: float  # ℓ
    alpha: float  # exponent of the equation
    counts: dict  # steps and right-hand sides
    mean_drift: float  # largest change of the mean
    # How far an average had to be lifted to the smallest value of the start.
    largest_shortfall: float

    def rescaled_force(self, row, xi):
        """Return the rescaled force at the points ξ̃ (any shape, modulo 2ℓ) at the time of a row.

        The start itself is not reconstructed from its averages, since it has kinks.
        """
        points = np.asarray(xi, dtype=float)
        if self.times[row] == 0.0:
            return self.start.values(points, self.half_length)
        floor = self.start.floor ** (1.0 / self.alpha)
        values = finite_volumes.point_values(
            self.averages[row], self.half_length, points.ravel(), floor
        )
        return values.reshape(points.shape) ** self.alpha

    def facts(self):
        """Return the attributes that say how the equation was solved."""
        return {
            "solver": f"{SOLVER}, {2 ** start_levels(self.alpha)} times finer cells at the start",
            **self.counts,
            "mean_drift": self.mean_drift,
            "largest_shortfall": self.largest_shortfall,
        }


def solve(scene, alpha, times, cells, tolerance, levels=None, smooth_cells=SMOOTH_CELLS):
    """Solve (40) for an exponent α, or its limit (50) for α = 1, once.

    Parameters
    ----------
    scene : mapping
        A checked periodic scene.
    alpha : float
        Exponent of the equation, 1 or more.
    times : sequence of float
        Times t of the chain, in any order, at least 0.
    cells : int
        Over which the run goes on once the kinks of the start are smooth.
    tolerance : float
        Error per step, in v.
    levels : int, optional
        L: the run begins on 2^L times as many cells; `start_levels` if none is given.
    smooth_cells : float, optional
        s: cells that a kink must be smooth over before they are joined.

    Returns
    -------
    Evolution

    Raises
    ------
    SolveError
        If the start has negative averages, or the step size collapses.
    """
    times = np.asarray(times, dtype=float)
    levels = start_levels(alpha) if levels is None else levels
    scaling, start, half_length = scene.scaling, make_start(scene.start), scene.half_length
    slow_times = scaling.slow_rate * times
    averages = start.averages(cells * 2**levels, half_length, alpha)
    mean, clock = averages.mean(), time_steps.make_clock(FIRST_STEP)
    ahead, kept = list(np.argsort(times, kind="stable")), [None] * times.size
    while ahead:
        equation = _make_equation(alpha, averages, start.floor, 2.0 * half_length / averages.size)
        state = time_steps.make_state(averages)
        joins = np.inf if averages.size == cells else _smoothing_time(equation, smooth_cells)
        while ahead and slow_times[ahead[0]] <= joins:
            row = ahead.pop(0)
            _advance(equation, state, clock, tolerance, slow_times[row])
            kept[row] = state.averages.copy()
        if ahead:
            _advance(equation, state, clock, tolerance, joins)
            averages = state.averages.reshape(-1, 2).mean(axis=1)
    mean_drift = max(abs(row.mean() - mean) for row in kept)
    counts, shortfall = time_steps.work_done(clock), float(clock.shortfall)
    return Evolution(start, times, kept, half_length, alpha, counts, float(mean_drift), shortfall)


def start_levels(alpha):
    """Return L that the exponent of an equation needs; only (40), α above 1, has a foot."""
    return START_LEVELS if alpha == 1.0 else LEVELS_WITH_FOOT


def _make_equation(alpha, averages, lowest, width):
    """Return the equation of the kernels; y ≥ `lowest` bounds averages from below anywhere."""
    smallest = float(averages.min())
    if smallest < 0.0:
        raise SolveError(
            f"The smallest cell average of the start is {smallest:.3g}, but a rescaled force is 0 "
            "or more: give a smoother start, or more of its points."
        )
    degenerate = 0.0 if alpha == 1.0 else SMALLEST_DIFFUSIVITY ** (1.0 / (alpha - 1.0))
    bound = lowest ** (1.0 / alpha)
    floor = max(bound, SMALLEST_ARGUMENT, degenerate)
    return finite_volumes.Equation(alpha, floor, bound, width)


def _smoothing_time(equation, smooth_cells):
    """Return the slow time at which the least diffusivity smooths a kink over some cells."""
    least_diffusivity = equation.alpha * equation.floor ** (equation.alpha - 1.0)
    return (smooth_cells * equation.width) ** 2 / least_diffusivity


def _advance(equation, state, clock, tolerance, slow_time):
    status = time_steps.advance(equation, state, clock, tolerance, slow_time)
    if status == time_steps.COLLAPSED:
        raise SolveError(
            f"At slow time {clock.t:.6g} the step size collapsed to {clock.h:.3g}: the "
            f"tolerance {tolerance:g} cannot be met in double precision; raise it."
        )
