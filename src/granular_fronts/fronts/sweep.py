"""Many exact fronts: one after the other along the damping, each from the ones before it.

The fronts are solved from strong to weak damping on one grid, compiled.  The window follows the
tail, and the start of each front is extrapolated from those before (`numerics.extrapolation`).  For
close neighbours two steps of Newton's iteration are left.  If the iteration does not settle, the
grid becomes too coarse or another check fails, the sweep starts anew at that damping. So it does
for a front whose error is too large. Window and grid are then new.  If this fails too, the values
are NaN with a reason, and the sweep goes on.

Accuracy.  Every front is solved again on a finer grid, by another order, on a longer window
(`profile.solve.refine`).  That iteration starts from the front itself.  It ends where the finer
equations hold to round-off, and so forgets the grid that it came from.  The differences are the
error estimates.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numba import int64

from granular_fronts.accuracy import EPSILON
from granular_fronts.arguments import sequence
from granular_fronts.fronts.linear.tails import lowest_roots_of_all
from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.equation import front_problem, power_problem, with_damping
from granular_fronts.fronts.profile.newton import Grid, Unknowns
from granular_fronts.fronts.profile.solve import (
    AT_REST,
    BELOW,
    DEFECT,
    FINER,
    LONGER,
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
from granular_fronts.fronts.properties import MEASURES, errors_of_measures, measures, with_overshoot
from granular_fronts.fronts.solve import ACCEPTED_ERROR, describe_front
from granular_fronts.fronts.validation import (
    check_alpha,
    check_beta,
    check_given_law,
    is_given_by_law,
)
from granular_fronts.model.laws import Law
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.extrapolation import REMEMBERED, predict, remember
from granular_fronts.numerics.interpolation import interpolate_all
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.quadrature import kernel_weights
from granular_fronts.output.datasets import name_variables

if TYPE_CHECKING:
    import numpy.typing as npt

PLAIN = ("residual", "speed_defect", "tail_rate", "tail_frequency")
SENSITIVITIES = tuple(f"sensitivity of {name}" for name in MEASURES)
COLUMNS = (*MEASURES, *SENSITIVITIES, *PLAIN)

MARGIN = 3.0  # sites kept ahead of where s reaches its end

ERROR_METHOD = (
    f"change in a second solution with {REFINED_ORDER} instead of {ORDER} points per polynomial, "
    f"on grids finer by {FINER} or more and windows longer by {LONGER}. If larger, what the error "
    "of the strain makes of it"
)


def sweep_fronts(
    alpha: float | None = None,
    gammas: npt.ArrayLike | None = None,
    beta: float | None = None,
    *,
    law: Law | Mapping[str, Any] | None = None,
    states: Sequence[float] | None = None,
    factors: npt.ArrayLike | None = None,
) -> xr.Dataset:
    """Measure the exact fronts of many dampings.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gammas : array_like, shape (fronts,)
        Dampings above 0 in the units of the front, in any order; close neighbours make the sweep
        fast.
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
        On `gamma`, or `factor` of a law, in the order given: `first_peak`, `largest_peak`, also
        as `overshoot`, `width_10_90`, `slope`, `dissipated_power`, as `gf.solve_front` defines
        them, each with its `…_error`; `residual`, `speed_defect`; `tail_rate`,
        `tail_frequency`, real and imaginary part of the slowest tail exponent; `converged` (0 or 1)
        and `reason`.  The `error_estimate` of the strain explains the changes of overshoot, width
        and dissipated power. Where it is too large, it is the difference of the strain.  Units
        belong to the law.

    Raises
    ------
    InputError
        If a parameter is out of range, or the jump conditions exclude the fronts.

    Examples
    --------
    >>> fronts = gf.sweep_fronts(alpha=1.5, gammas=[0.1, 0.2, 0.3])
    >>> fronts["overshoot"].values.round(6)
    array([0.195443, 0.034448, 0.      ])
    """
    limits = {"above": 0.0, "advice": "without damping there is no front"}
    powers = {"alpha": alpha, "gammas": gammas, "beta": beta}
    if is_given_by_law(powers, {"law": law, "states": states, "factors": factors}):
        law, (behind, ahead) = check_given_law(law, states)
        name, dampings = "factor", sequence("factors", factors, **limits)
        problem, attributes = front_problem(law, behind, ahead), describe_front(law, behind, ahead)
    else:
        alpha, beta = check_alpha(alpha), check_beta(alpha, beta)
        name, dampings = "gamma", sequence("gammas", gammas, **limits)
        problem, attributes = power_problem(alpha, 1.0, beta), {"alpha": alpha, "beta": beta}
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
    estimates = _estimates(problem, values, others)
    for k in np.flatnonzero(estimates > accepted):
        found, again, estimate = _alone(problem._replace(damping=dampings[k]))
        if estimate < estimates[k]:
            values[k], others[k], estimates[k] = found, again, estimate
    return values, others, estimates, reasons


def _stretch(problem, dampings):
    """Return the fronts from the first damping on that one grid carries; values on two grids."""
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
    found, again = follow(start, finer, dampings)
    reason = "" if len(found) else "the front fails a check on the grid of the sweep"
    return found, again, reason


def _alone(problem):
    """Return one front on its own window and grid: values on two grids, error of the strain."""
    start = solve_profile(problem)
    finer = refine(start) if not start.reason else start
    if not finer.reason:
        found, again = follow(start, finer, np.array([problem.damping]))
        if len(found):
            difference = float(np.abs(start.evaluate(finer.xi) - finer.s).max())
            return found[0], again[0], abs(problem.jump) * difference
    return None, None, math.inf


def _describe(problem, name, places, values, others, estimate, reasons):
    (found, sensitivities), (again, _) = _split(values), _split(others)
    errors = errors_of_measures(found, again, sensitivities, estimate / abs(problem.jump))
    accepted = ACCEPTED_ERROR * problem.size
    # The negation also holds for NaN, which compares with nothing.
    inaccurate = ~(estimate <= accepted)
    for k in np.flatnonzero(inaccurate & (reasons == "")):
        reasons[k] = f"the front errs by about {estimate[k]:.1e}, more than {accepted:g}"
        if math.isnan(estimate[k]):
            reasons[k] = "the error of the front cannot be estimated"
    values[inaccurate] = math.nan
    variables = {
        column: (name, values[:, k], {"error_method": ERROR_METHOD} if column in MEASURES else {})
        for k, column in enumerate(COLUMNS)
        if column in MEASURES + PLAIN
    }
    variables["first_peak"][2]["long_name"] = "first maximum of the strain less the state behind"
    variables["largest_peak"][2]["long_name"] = "how far the strain passes the state behind"
    variables["slope"][2]["long_name"] = "steepest slope of the strain, per site"
    variables |= {
        f"{column}_error": (name, errors[k], {"long_name": f"error of {column}"})
        for k, column in enumerate(MEASURES)
    }
    variables |= {
        "error_estimate": (name, estimate),
        "converged": (name, np.array([int(reason == "") for reason in reasons])),
        "reason": (name, reasons.astype(str)),
    }
    return name_variables(xr.Dataset(with_overshoot(variables), coords={name: places}))


def _split(values):
    """Return the measures and their sensitivities, each of shape (5, fronts)."""
    count = len(MEASURES)
    return values.T[:count], values.T[count : 2 * count]


def _estimates(problem, values, others):
    """Return the error of the strain that explains the changes of overshoot, width and power."""
    # The slope feels rounding, which differs from point to point, more than any other error.
    (found, sensitivities), (again, _) = _split(values), _split(others)
    errors = np.delete(np.abs(found - again) / sensitivities, MEASURES.index("slope"), axis=0)
    # Three numbers may agree by chance where a whole front does not.
    return np.maximum(abs(problem.jump) * errors.max(axis=0), 2.0 * EPSILON * problem.size)


def follow(start, finer, dampings):
    """Return values of the fronts that follow from a first one, on its grid, by decreasing damping.

    `finer` is the refined first front, and each is solved again on its grid.  The shape is (2,
    fronts, columns), up to the first front that fails a check on either grid.
    """
    values = np.full((2, dampings.size, len(COLUMNS)), math.nan)
    reached = _follow_on_grids(
        start.problem, dampings, _grids(start, ORDER), _grids(finer, REFINED_ORDER), start.s, values
    )
    return values[:, :reached]


def _grids(profile, order):
    """Return the grid of a profile by the rule of an order, and by its difference to another."""
    rules = (of(profile.spacing, order) for of in (kernel_weights, differences_of_rules))
    return tuple(make_grid(profile.spacing, profile.middle, weights) for weights in rules)


@kernel
def _follow_on_grids(first_problem, dampings, usual, finer, start, values):
    """Solve front after front on both grids and measure it; return how many passed all checks."""
    history, places = np.empty(STEPS + 1), np.log(dampings)
    middles = np.empty((2, dampings.size), dtype=np.int64)
    spacing, ratio = usual[0].spacing, usual[0].spacing / finer[0].spacing
    for k in range(dampings.size):
        if interrupted():
            return 0
        values[:, k, -2], values[:, k, -1] = _slowest_tail(first_problem, dampings[k])
        longer = values[0, 0, -2] / values[0, k, -2]
        if not longer * finer[0].middle <= MOST_POINTS:
            # Such a window is not even tried; the sweep starts anew there, and says so.
            dampings = dampings[:k]
            break
        middles[0, k] = math.ceil(longer * usual[0].middle)
        middles[1, k] = math.ceil(longer * finer[0].middle)
    center = usual[0].middle
    for middle in middles[0, : dampings.size]:
        center = max(center, middle)
    past = np.empty((REMEMBERED, center - usual[0].middle + start.size))
    remember(start, center - usual[0].middle, 0.0, past[0])
    for k in range(dampings.size):
        problem, middle = with_damping(first_problem, dampings[k]), middles[0, k]
        # The sweep starts from the front of the first damping.
        known = max(k, 1)
        first, margin = center - middle, int(MARGIN / spacing)
        s = predict(past, known, places[:known], places[k], first, margin)
        if not _solve(problem, usual, middle, s, history, values[0, k]):
            return k
        remember(s, first, 0.0, past[k % REMEMBERED])
        ahead = math.ceil(LONGER * ratio * (s.size - middle))
        positions = np.arange(-middles[1, k], ahead) / ratio
        refined = interpolate_all(s, positions, 1.0, 0.0, middle)
        if not _solve(problem, finer, middles[1, k], refined, history, values[1, k]):
            return k
    return dampings.size


@subroutine
def _solve(problem, grids, middle, s, history, row):
    """Solve a front from a start and measure it; return whether it passes all checks."""
    (grid, differences), unknowns = grids, Unknowns(s, np.ones(1))
    s[middle] = 0.5
    own = Grid(grid.spacing, middle, grid.hat, grid.jump)
    tolerance = TOLERANCE * problem.magnification
    count, status = newton.iterate(problem, own, tolerance, unknowns, history)
    passes = status == newton.SETTLED and _is_front(problem, own, unknowns, history[count])
    defect = newton.largest_convolution(problem, differences, s)
    if not (passes and defect <= 1.5 * DEFECT * problem.magnification):
        return False
    # Numba takes two seconds to compile what an assignment to a slice says of wrong shapes.
    for k, value in enumerate(measures(problem, grid.spacing, s)):
        row[k] = value
    row[-4], row[-3] = history[count], unknowns.speed[0] - 1.0
    return True


@subroutine
def _slowest_tail(problem, damping):
    """Return real and imaginary part of the exponent of the slowest tail behind."""
    end = problem.behind
    tail_damping = damping * end.q_slope / end.p_slope
    root = lowest_roots_of_all(end.p_slope, tail_damping, int64(1))[0]
    return root.real, root.imag


@subroutine
def _is_front(problem, grid, unknowns, residual):
    """Return whether a solution passes the checks of `profile.solve`."""
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
