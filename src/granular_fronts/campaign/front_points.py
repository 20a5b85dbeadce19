"""Points of exact fronts: of two powers with δ = c = 1, James (2021), section 6, or of any law.

Fronts of one law are swept along the damping, each from the ones before it, whichever axis is the
fast one.  `fronts.sweep` describes the method and its error estimates.  The slowest tail is a root
of the dispersion relation, independent of the solution.  A front is monotone where this root is
real.
"""

import functools

import numpy as np

from granular_fronts.arguments import double_precision
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.numbers import law_at
from granular_fronts.campaign.points import REASON, groups_along, solve_groups
from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.fronts.sweep import ERROR_METHOD, sweep_fronts
from granular_fronts.model.laws import make_law

SWEPT_AS = {"profile_error": "error_estimate"}
"""Scalars that the sweep knows by another name."""

EXACT_TO_ROUNDING = ("tail_rate", "tail_frequency")
PROFILE = "relative_displacement"


def solve_chunk(points, settings, activity):
    """Solve fronts to round-off, all of one law together; a profile is in ξ."""
    damping = "damping" if "law" in settings else "gamma"
    xi = KINDS["front"].profile_points(settings["profile"])
    sizes = dict.fromkeys(settings["scalars"], ()) | ({} if xi is None else {PROFILE: (xi.size,)})
    groups = (
        (members, functools.partial(_measure, point, dampings, settings, xi))
        for members, point, dampings in groups_along(points, damping)
    )
    return solve_groups(points[damping].shape, sizes, groups, ERROR_METHOD, activity)


def _measure(point, dampings, settings, xi):
    """Return the values, errors and reasons of the fronts that differ in their damping."""
    with double_precision("A front of this law", "bring its numbers and states nearer to 1"):
        sweep, front = _fronts(point, dampings, settings.get("law"))
    reasons = np.array(sweep["reason"].values, dtype=object)
    measured = {
        name: (np.array(sweep[SWEPT_AS.get(name, name)], dtype=float), _error(sweep, name))
        for name in settings["scalars"]
    }
    if xi is not None:
        measured[PROFILE] = _profiles(front, dampings, xi, reasons)
    for value, _ in measured.values():
        value[reasons != ""] = np.nan
    return measured | {REASON: reasons}


def _fronts(point, dampings, law):
    """Return the sweep along the dampings, and a function that solves one front by itself."""
    if law is None:
        alpha, beta = point["alpha"], point["beta"]
        return sweep_fronts(alpha, dampings, beta), functools.partial(solve_front, alpha, beta=beta)
    made, states = make_law(law_at(law, point)), (point["behind"], point["ahead"])
    sweep = sweep_fronts(law=made, states=states, factors=dampings)
    return sweep, lambda factor: solve_front(law=made.with_damping(factor), states=states)


def _error(sweep, name):
    """Return largest error of a scalar over the solved fronts, NaN for what is an error itself."""
    if name in EXACT_TO_ROUNDING:
        return np.spacing(np.nanmax(sweep[name].values, initial=0.0))
    if f"{name}_error" not in sweep:
        return np.nan
    solved = sweep[f"{name}_error"].values[sweep["converged"].values == 1]
    return np.max(solved, initial=0.0)


def _profiles(front, dampings, xi, reasons):
    """Return profiles of fronts, each solved once more, and their errors; extend the reasons."""
    profiles = np.full((dampings.size, xi.size), np.nan)
    errors = np.full(dampings.size, np.nan)
    for index, damping in enumerate(dampings):
        if reasons[index]:
            continue
        try:
            found = front(float(damping))
        except InputError as error:
            reasons[index] = str(error)
            continue
        if found.attrs["converged"]:
            profiles[index] = evaluate_front(found, xi)
            errors[index] = found.attrs["error_estimate"]
        else:
            reasons[index] = found.attrs["reason"]
    return profiles, errors
