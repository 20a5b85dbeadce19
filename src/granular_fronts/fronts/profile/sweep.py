"""Many exact fronts: one after the other along the damping, each from the ones before it.

The fronts are solved from strong to weak damping on one grid, in compiled code.  The window follows
the tail; the start of each is extrapolated from those before (`prediction`), so that in a dense
sweep two steps of Newton's iteration are left.  Where the iteration does not settle, the grid
becomes too coarse or a front fails another check, the sweep starts anew at that γ with a window and
a grid of its own, and so does a front whose error turns out too large.  Where this fails too, the
values are NaN with a reason, and the sweep goes on.

Accuracy.  Every stretch is swept a second time on a finer grid, by another order, on a longer
window (`profile.refine`); the differences are the error estimates.
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.arguments import sequence
from granular_fronts.fronts.linear.tails import lowest_roots_of_all
from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.newton import Law
from granular_fronts.fronts.profile.solve import (
    AT_REST,
    BELOW,
    DEFECT,
    MOST_POINTS,
    ORDER,
    OTHER_ORDER,
    REFINED_ORDER,
    RESIDUAL_TOLERANCE,
    SPEED_TOLERANCE,
    STEPS,
    TOLERANCE,
    make_law,
    refine,
    solve_profile,
)
from granular_fronts.fronts.properties import MEASURES, measures
from granular_fronts.fronts.solve import ACCEPTED_ERROR, RESOLUTION
from granular_fronts.fronts.validation import check_alpha, check_beta
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


def sweep_fronts(alpha, gammas, beta=None):
    """Measures of the exact fronts for many dampings.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gammas : array_like, shape (fronts,)
        Dampings above 0, in any order; close neighbours make the sweep fast.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.

    Returns
    -------
    xarray.Dataset
        On `gamma`, in the order given: `overshoot`, `width_10_90`, `slope`, `dissipated_power`,
        each with its `…_error`; `residual`, `speed_defect`; `tail_rate`, `tail_frequency`, real and
        imaginary part of the slowest tail exponent; `error_estimate` of u, the largest of the
        errors of the overshoot, of the width times the slope, and of the dissipated power, or where
        that is too large the difference of u itself;
        `converged` (0 or 1) and `reason`.

    Raises
    ------
    InputError
        If a parameter is out of range.
    """
    alpha, beta = check_alpha(alpha), check_beta(alpha, beta)
    gammas = sequence("gammas", gammas, above=0.0, advice="without damping there is no front")
    distinct, place = np.unique(-gammas, return_inverse=True)
    fronts = _describe(alpha, beta, *_sweep(alpha, beta, -distinct))
    return fronts.isel(gamma=place)


def _sweep(alpha, beta, gammas):
    """Decreasing γ, the values on two grids, error estimates and reasons."""
    values, others = np.full((2, gammas.size, len(COLUMNS)), math.nan)
    reasons = np.full(gammas.size, "", dtype=object)
    first = 0
    while first < gammas.size:
        found, again, reason = _stretch(make_law(alpha, gammas[first], beta), gammas[first:])
        end = first + max(len(found), 1)
        reasons[first:end] = reason
        values[first : first + len(found)], others[first : first + len(again)] = found, again
        first = end
    estimates = _estimates(values, _errors(values, others))
    for k in np.flatnonzero(estimates > ACCEPTED_ERROR):
        found, again, estimate = _alone(make_law(alpha, gammas[k], beta))
        if estimate < estimates[k]:
            values[k], others[k], estimates[k] = found, again, estimate
    return gammas, values, others, estimates, reasons


def _stretch(law, gammas):
    """Fronts from the first γ on, as far as one grid carries; their values on two grids."""
    nothing = np.empty((0, len(COLUMNS)))
    start = solve_profile(law)
    if start.reason:
        return nothing, nothing, start.reason
    finer = refine(start)
    if finer.reason:
        return (
            nothing,
            nothing,
            f"the refinement that should estimate the error failed: {finer.reason}",
        )
    found = _follow(start, gammas, ORDER)
    again = _follow(finer, gammas[: len(found)], REFINED_ORDER)
    common = min(len(found), len(again))
    return found[:common], again[:common], ""


def _alone(law):
    """One front on a window and a grid of its own: values on two grids, and the error of u."""
    start = solve_profile(law)
    finer = refine(start) if not start.reason else start
    if finer.reason:
        return None, None, math.inf
    gamma = np.array([law.gamma])
    found, again = _follow(start, gamma, ORDER), _follow(finer, gamma, REFINED_ORDER)
    if not (len(found) and len(again)):
        return None, None, math.inf
    return found[0], again[0], float(np.abs(start.evaluate(finer.xi) - finer.u).max())


def _follow(start, gammas, order):
    """Values of the fronts that follow from a first one, shape (fronts, columns)."""
    rule, other = kernel_weights(start.spacing, order), kernel_weights(start.spacing, OTHER_ORDER)
    more = (rule.hat.size - other.hat.size) // 2
    values = np.empty((gammas.size, len(COLUMNS)))
    lengthening = start.middle * float(start.spacing) * _tail_rate(start.law)
    reached = follow(
        start.law,
        gammas,
        float(start.spacing),
        (rule.hat, rule.jump),
        (rule.hat - np.pad(other.hat, more), rule.jump - np.pad(other.jump, more)),
        lengthening,
        start.middle,
        start.u,
        values,
    )
    return values[:reached]


def _tail_rate(law):
    return lowest_roots_of_all(law.alpha, law.beta * law.gamma / law.alpha, 1)[0].real


@kernel
def follow(start_law, gammas, spacing, rule, difference, decay, start_middle, start, values):
    """Solve front after front and measure it; return how many passed all checks.

    Parameters
    ----------
    start_law : newton.Law
        Of the first γ.
    gammas : ndarray, shape (fronts,)
        Decreasing.
    spacing : float
    rule, difference : (ndarray, ndarray)
        Weights hat and jump of the rule, and their differences to another rule.
    decay : float
        Length of the window behind times the slowest rate.
    start_middle, start : int, ndarray
        The first front.
    values : ndarray, shape (fronts, columns)
        Filled in.

    Returns
    -------
    int
    """
    history, places = np.empty(STEPS + 1), np.log(gammas)
    middles = np.empty(gammas.size, dtype=np.int64)
    for k in range(gammas.size):
        if interrupted():
            return 0
        damping = start_law.beta * gammas[k] / start_law.alpha
        root = lowest_roots_of_all(start_law.alpha, damping, 1)[0]
        values[k, 6], values[k, 7] = root.real, root.imag
        needed = decay / (root.real * spacing)
        if not needed <= MOST_POINTS:
            # Such a window is not even tried; the sweep starts anew there, and says so.
            gammas, middles = gammas[:k], middles[:k]
            break
        middles[k] = math.ceil(needed)
    center = max(np.max(middles), start_middle)
    past = np.empty((REMEMBERED, center - start_middle + start.size))
    remember(start, center - start_middle, start_law.ahead, past[0])
    for k in range(gammas.size):
        law = Law(start_law.alpha, start_law.beta, gammas[k], start_law.ahead, start_law.speed)
        # The front that the sweep starts from is that of the first γ.
        known = max(k, 1)
        first, margin = center - middles[k], int(MARGIN / spacing)
        u = predict(past, known, places[:known], places[k], first, margin)
        u[middles[k]] = 0.5
        speed = np.array([law.speed])
        count, status = newton.iterate(
            law, rule[0], rule[1], spacing, middles[k], 0.5, TOLERANCE, u, speed, history
        )
        settled = status == newton.SETTLED
        passes = settled and is_front(law, middles[k], u, speed[0], history[count])
        defect = newton.largest_convolution(law, difference[0], difference[1], u)
        if not (passes and defect <= 1.5 * DEFECT):
            return k
        remember(u, first, law.ahead, past[k % REMEMBERED])
        values[k, :4] = measures(law, spacing, u)
        values[k, 4], values[k, 5] = history[count], speed[0] / law.speed - 1.0
    return gammas.size


@kernel
def is_front(law, middle, u, speed, residual):
    """Whether a solution passes the checks of `profile.reason_against`."""
    at_rest = abs(u[0] - 1.0) <= AT_REST and abs(u[-1] - law.ahead) <= AT_REST
    solved = residual <= RESIDUAL_TOLERANCE * (1.0 + law.gamma)
    exact = abs(speed / law.speed - 1.0) <= SPEED_TOLERANCE
    highest = np.max(u[middle + 1 :])
    return at_rest and solved and exact and highest < 0.5 and np.min(u) >= law.ahead - BELOW


def _describe(alpha, beta, gammas, values, others, estimate, reasons):
    """The dataset of a sweep."""
    errors = _errors(values, others)
    doubtful = estimate > ACCEPTED_ERROR
    for k in np.nonzero(doubtful)[0]:
        reasons[k] = f"the front errs by about {estimate[k]:.1e}, more than {ACCEPTED_ERROR:g}"
    values[doubtful] = math.nan
    variables = {
        name: ("gamma", values[:, k], {"error_method": ERROR_METHOD} if name in MEASURES else {})
        for k, name in enumerate(COLUMNS)
    }
    variables["overshoot"][2]["long_name"] = "largest relative displacement, less 1"
    variables["slope"][2]["long_name"] = "steepest slope of the relative displacement, per site"
    variables |= {f"{name}_error": ("gamma", errors[:, k]) for k, name in enumerate(MEASURES)}
    variables |= {
        "error_estimate": ("gamma", estimate),
        "converged": ("gamma", np.array([int(reason == "") for reason in reasons])),
        "reason": ("gamma", reasons.astype(str)),
    }
    return xr.Dataset(variables, coords={"gamma": gammas}, attrs={"alpha": alpha, "beta": beta})


def _errors(values, others):
    """Differences of two computations, or one unit of the last digit of 1 where they agree."""
    return np.maximum(np.abs(values - others), RESOLUTION)


def _estimates(values, errors):
    """Error of u of every front, from those of its measures."""
    overshoot, width, _, power = errors.T[: len(MEASURES)]
    return np.max([overshoot, width * values[:, 2], power], axis=0)
