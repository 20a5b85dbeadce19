"""Front after front along the damping, each from the ones before it, compiled.

From strong to weak damping on one grid: the window follows the tail, and the start of each front is
extrapolated from those before (`numerics.extrapolation`), so that for close neighbours two steps of
Newton's iteration are left.
"""

import math

import numpy as np
from numba import int64

from granular_fronts.fronts.linear.tails import lowest_roots_of_all
from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.equation import with_damping
from granular_fronts.fronts.profile.newton import Grid, Unknowns
from granular_fronts.fronts.profile.solve import (
    AT_REST,
    BELOW,
    DEFECT,
    MOST_POINTS,
    RESIDUAL_TOLERANCE,
    SPEED_TOLERANCE,
    STEPS,
    TOLERANCE,
    differences_of_rules,
    make_grid,
)
from granular_fronts.fronts.properties import MEASURES, measures
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.extrapolation import REMEMBERED, predict, remember
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.quadrature import kernel_weights

PLAIN = ("residual", "speed_defect", "tail_rate", "tail_frequency")
SENSITIVITIES = tuple(f"sensitivity of {name}" for name in MEASURES)
COLUMNS = (*MEASURES, *SENSITIVITIES, *PLAIN)

MARGIN = 3.0
"""Sites kept ahead of where s reaches its end."""


def follow(start, dampings, order):
    """Values of the fronts that follow from a first one.

    Parameters
    ----------
    start : solve.Profile
        The front of the first damping; its grid is that of all.
    dampings : ndarray, shape (fronts,)
        Decreasing.
    order : int
        Points of the local polynomials.

    Returns
    -------
    ndarray, shape (fronts solved, columns)
        The columns of `COLUMNS`, up to the first front that fails a check.
    """
    spacing, middle = start.spacing, start.middle
    problem = start.problem
    slowest = lowest_roots_of_all(problem.behind.p_slope, problem.tail_damping, 1)[0].real
    values = np.full((dampings.size, len(COLUMNS)), math.nan)
    reached = follow_on_grid(
        problem,
        dampings,
        make_grid(spacing, middle, kernel_weights(spacing, order)),
        make_grid(spacing, middle, differences_of_rules(spacing, order)),
        middle * float(spacing) * slowest,
        start.s,
        values,
    )
    return values[:reached]


@kernel
def follow_on_grid(first_problem, dampings, grid, differences, decay, start, values):
    """Solve front after front and measure it; return how many passed all checks.

    Parameters
    ----------
    first_problem : equation.FrontProblem
        That of the first damping.
    dampings : ndarray, shape (fronts,)
        Decreasing.
    grid, differences : newton.Grid
        The grid of the first front, and the same with the differences of two rules as weights.
    decay : float
        Length of the window behind times the slowest rate.
    start : ndarray, shape (points,)
        The first front.
    values : ndarray, shape (fronts, columns)
        Filled in.

    Returns
    -------
    int
    """
    history, places = np.empty(STEPS + 1), np.log(dampings)
    middles = np.empty(dampings.size, dtype=np.int64)
    for k in range(dampings.size):
        if interrupted():
            return 0
        values[k, 10], values[k, 11] = slowest_tail(first_problem, dampings[k])
        needed = decay / (values[k, 10] * grid.spacing)
        if not needed <= MOST_POINTS:
            # Such a window is not even tried; the sweep starts anew there, and says so.
            dampings, middles = dampings[:k], middles[:k]
            break
        middles[k] = math.ceil(needed)
    center = grid.middle
    for middle in middles:
        center = max(center, middle)
    past = np.empty((REMEMBERED, center - grid.middle + start.size))
    remember(start, center - grid.middle, 0.0, past[0])
    for k in range(dampings.size):
        problem = with_damping(first_problem, dampings[k])
        # The front that the sweep starts from is that of the first damping.
        known = max(k, 1)
        first, margin = center - middles[k], int(MARGIN / grid.spacing)
        s = predict(past, known, places[:known], places[k], first, margin)
        s[middles[k]] = 0.5
        unknowns = Unknowns(s, np.ones(1))
        own = Grid(grid.spacing, middles[k], grid.hat, grid.jump)
        tolerance = TOLERANCE * problem.magnification
        count, status = newton.iterate(problem, own, tolerance, unknowns, history)
        passes = status == newton.SETTLED and is_front(problem, own, unknowns, history[count])
        defect = newton.largest_convolution(problem, differences, s)
        if not (passes and defect <= 1.5 * DEFECT * problem.magnification):
            return k
        remember(s, first, 0.0, past[k % REMEMBERED])
        values[k, :8] = measures(problem, grid.spacing, s)
        values[k, 8], values[k, 9] = history[count], unknowns.speed[0] - 1.0
    return dampings.size


@subroutine
def slowest_tail(problem, damping):
    """Real and imaginary part of the exponent of the tail behind that decays most slowly."""
    end = problem.behind
    tail_damping = damping * end.q_slope / end.p_slope
    root = lowest_roots_of_all(end.p_slope, tail_damping, int64(1))[0]
    return root.real, root.imag


@subroutine
def is_front(problem, grid, unknowns, residual):
    """Whether a solution passes the checks of `solve.reason_against`."""
    s, rounding = unknowns.s, problem.magnification
    at_rest = max(abs(s[0] - 1.0), abs(s[-1])) <= AT_REST * rounding
    damping_number = problem.damping * problem.behind.q
    solved = residual <= RESIDUAL_TOLERANCE * rounding * (1.0 + damping_number)
    exact = abs(unknowns.speed[0] - 1.0) <= SPEED_TOLERANCE * rounding
    least = most = s[0]
    highest_ahead = s[-1]
    for k in range(s.size):
        least, most = min(least, s[k]), max(most, s[k])
        if k > grid.middle:
            highest_ahead = max(highest_ahead, s[k])
    single = highest_ahead < 0.5 and least >= -BELOW * rounding
    in_domain = problem.least < least and most < problem.most
    return at_rest and solved and exact and single and in_domain
