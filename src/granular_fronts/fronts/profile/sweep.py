"""Many exact fronts: one after the other along the damping, each from the ones before it.

The fronts are solved from strong to weak damping on one grid, in compiled code.  The window follows
the tail; the start of each is extrapolated from those before (`numerics.extrapolation`), so that in a dense
sweep two steps of Newton's iteration are left.  Where the iteration does not settle, the grid
becomes too coarse or a front fails another check, the sweep starts anew at that damping with a window and
a grid of its own, and so does a front whose error turns out too large.  Where this fails too, the
values are NaN with a reason, and the sweep goes on.

Accuracy.  Every stretch is swept a second time on a finer grid, by another order, on a longer
window (`solve.refine`); the differences are the error estimates.
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.arguments import sequence
from granular_fronts.fronts.linear.tails import lowest_roots_of_all
from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.equation import front_problem, power_problem, with_damping
from granular_fronts.fronts.profile.newton import Grid, Unknowns
from granular_fronts.fronts.profile.solve import (
    AT_REST,
    BELOW,
    DEFECT,
    MOST_POINTS,
    ORDER,
    REFINED_ORDER,
    RESIDUAL_TOLERANCE,
    SPEED_TOLERANCE,
    STEPS,
    TOLERANCE,
    differences_of_rules,
    make_grid,
    refine,
    solve_profile,
)
from granular_fronts.fronts.properties import MEASURES, measures
from granular_fronts.fronts.solve import ACCEPTED_ERROR, RESOLUTION, describe_front
from granular_fronts.fronts.validation import check_alpha, check_beta, check_given_law
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.extrapolation import REMEMBERED, predict, remember
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.quadrature import kernel_weights

COLUMNS = (*MEASURES, "residual", "speed_defect", "tail_rate", "tail_frequency")

MARGIN = 3.0
"""Sites kept ahead of where u reaches its end."""

ERROR_METHOD = (
    f"difference to a second sweep with {REFINED_ORDER} instead of {ORDER} points per polynomial, "
    "on grids finer by 1.4 or more and windows longer by 1.1"
)


def sweep_fronts(alpha=None, gammas=None, beta=None, *, law=None, states=None, factors=None):
    """Measures of the exact fronts for many dampings.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gammas : array_like, shape (fronts,)
        Dampings above 0, in any order; close neighbours make the sweep fast.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.
    law : Law or mapping, optional
        In place of alpha, gammas and beta: a law of `make_law`, or what it takes.
    states : pair of float, optional
        Strains R_b behind and R_a ahead, with the law.
    factors : array_like, shape (fronts,)
        What W of the law is multiplied by, above 0, in any order.

    Returns
    -------
    xarray.Dataset
        On `gamma`, or `factor` of a law, in the order given: `overshoot`, `width_10_90`, `slope`,
        `dissipated_power`, each with its `…_error`; `residual`, `speed_defect`; `tail_rate`,
        `tail_frequency`, real and imaginary part of the slowest tail exponent; `error_estimate` of
        the strain, the largest of the errors of the overshoot, of the width times the slope, and
        of the dissipated power per bead, or where that is too large the difference of the strain
        itself; `converged` (0 or 1) and `reason`.  Units are those of the law.

    Raises
    ------
    InputError
        If a parameter is out of range, or the jump conditions exclude the fronts.
    """
    limits = {"above": 0.0, "advice": "without damping there is no front"}
    if law is None and states is None and factors is None:
        alpha, beta = check_alpha(alpha), check_beta(alpha, beta)
        dampings = sequence("gammas", gammas, **limits)
        problem, attributes = power_problem(alpha, 1.0, beta), {"alpha": alpha, "beta": beta}
        name = "gamma"
    else:
        law, (behind, ahead) = check_given_law(law, states, alpha, gammas, beta)
        dampings = sequence("factors", factors, **limits)
        problem, name = front_problem(law, behind, ahead), "factor"
        attributes = describe_front(law, behind, ahead)
    distinct, place = np.unique(-dampings, return_inverse=True)
    fronts = _describe(problem, name, -distinct, *_sweep(problem, problem.damping * -distinct))
    return fronts.isel({name: place}).assign_attrs(attributes)


def _sweep(problem, dampings):
    """For decreasing dampings the values on two grids, error estimates and reasons."""
    values, others = np.full((2, dampings.size, len(COLUMNS)), math.nan)
    reasons = np.full(dampings.size, "", dtype=object)
    first = 0
    while first < dampings.size:
        found, again, reason = _stretch(problem, dampings[first:])
        end = first + max(len(found), 1)
        reasons[first:end] = reason
        values[first : first + len(found)], others[first : first + len(again)] = found, again
        first = end
    accepted = ACCEPTED_ERROR * problem.size
    estimates = _estimates(problem, values, _errors(problem, values, others))
    for k in np.flatnonzero(estimates > accepted):
        found, again, estimate = _alone(problem._replace(damping=dampings[k]))
        if estimate < estimates[k]:
            values[k], others[k], estimates[k] = found, again, estimate
    return values, others, estimates, reasons


def _stretch(problem, dampings):
    """Fronts from the first damping on, as far as one grid carries; their values on two grids."""
    nothing = np.empty((0, len(COLUMNS)))
    start = solve_profile(problem._replace(damping=dampings[0]))
    if start.reason:
        return nothing, nothing, start.reason
    finer = refine(start)
    if finer.reason:
        return (
            nothing,
            nothing,
            f"the refinement that should estimate the error failed: {finer.reason}",
        )
    found = _follow(start, dampings, ORDER)
    again = _follow(finer, dampings[: len(found)], REFINED_ORDER)
    common = min(len(found), len(again))
    return found[:common], again[:common], ""


def _alone(problem):
    """One front on a window and a grid of its own: values on two grids, error of the strain."""
    start = solve_profile(problem)
    finer = refine(start) if not start.reason else start
    if finer.reason:
        return None, None, math.inf
    damping = np.array([problem.damping])
    found, again = _follow(start, damping, ORDER), _follow(finer, damping, REFINED_ORDER)
    if not (len(found) and len(again)):
        return None, None, math.inf
    difference = float(np.abs(start.evaluate(finer.xi) - finer.s).max())
    return found[0], again[0], abs(problem.jump) * difference


def _follow(start, dampings, order):
    """Values of the fronts that follow from a first one, shape (fronts, columns)."""
    spacing, middle = start.spacing, start.middle
    problem = start.problem
    slowest = lowest_roots_of_all(problem.behind.p_slope, problem.tail_damping, 1)[0].real
    values = np.empty((dampings.size, len(COLUMNS)))
    reached = follow(
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
def follow(first_problem, dampings, grid, differences, decay, start, values):
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
        values[k, 6], values[k, 7] = slowest_tail(first_problem, dampings[k])
        needed = decay / (values[k, 6] * grid.spacing)
        if not needed <= MOST_POINTS:
            # Such a window is not even tried; the sweep starts anew there, and says so.
            dampings, middles = dampings[:k], middles[:k]
            break
        middles[k] = math.ceil(needed)
    center = max(np.max(middles), grid.middle)
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
        values[k, :4] = measures(problem, grid.spacing, s)
        values[k, 4], values[k, 5] = history[count], unknowns.speed[0] - 1.0
    return dampings.size


@kernel
def slowest_tail(problem, damping):
    """Real and imaginary part of the exponent of the tail behind that decays most slowly."""
    end = problem.behind
    root = lowest_roots_of_all(end.p_slope, damping * end.q_slope / end.p_slope, 1)[0]
    return root.real, root.imag


@kernel
def is_front(problem, grid, unknowns, residual):
    """Whether a solution passes the checks of `solve.reason_against`."""
    s, rounding = unknowns.s, problem.magnification
    at_rest = max(abs(s[0] - 1.0), abs(s[-1])) <= AT_REST * rounding
    damping_number = problem.damping * problem.behind.q
    solved = residual <= RESIDUAL_TOLERANCE * rounding * (1.0 + damping_number)
    exact = abs(unknowns.speed[0] - 1.0) <= SPEED_TOLERANCE * rounding
    least, most = np.min(s), np.max(s)
    single = np.max(s[grid.middle + 1 :]) < 0.5 and least >= -BELOW * rounding
    in_domain = problem.least < least and most < problem.most
    return at_rest and solved and exact and single and in_domain


def _describe(problem, name, places, values, others, estimate, reasons):
    """The dataset of a sweep on the coordinate `name`."""
    errors = _errors(problem, values, others)
    accepted = ACCEPTED_ERROR * problem.size
    doubtful = estimate > accepted
    for k in np.nonzero(doubtful)[0]:
        reasons[k] = f"the front errs by about {estimate[k]:.1e}, more than {accepted:g}"
    values[doubtful] = math.nan
    variables = {
        column: (name, values[:, k], {"error_method": ERROR_METHOD} if column in MEASURES else {})
        for k, column in enumerate(COLUMNS)
    }
    variables["overshoot"][2]["long_name"] = "how far the strain passes the state behind"
    variables["slope"][2]["long_name"] = "steepest slope of the strain, per site"
    variables |= {f"{column}_error": (name, errors[:, k]) for k, column in enumerate(MEASURES)}
    variables |= {
        "error_estimate": (name, estimate),
        "converged": (name, np.array([int(reason == "") for reason in reasons])),
        "reason": (name, reasons.astype(str)),
    }
    return xr.Dataset(variables, coords={name: places})


def _errors(problem, values, others):
    """Differences of two computations, or the rounding of the larger state where they agree."""
    return np.maximum(np.abs(values - others), RESOLUTION * problem.size)


def _estimates(problem, values, errors):
    """Error of the strain of every front, from those of its measures."""
    overshoot, width, _, power = errors.T[: len(MEASURES)]
    return np.max([overshoot, width * values[:, 2], power / problem.power_scale], axis=0)
