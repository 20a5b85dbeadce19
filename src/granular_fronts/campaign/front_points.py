"""Points of exact fronts: of two powers with δ = c = 1, James (2021), section 6, or of any law.

Fronts of one law are swept along the damping, each from the ones before it, whichever axis is the
fast one; see `fronts.sweep` for the method and its error estimates.  The slowest
tail is a root of the dispersion relation and knows nothing of the solution; a front is monotone
where it is real.
"""

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from granular_fronts.campaign.kinds import KINDS, Solved
from granular_fronts.campaign.laws import law_at
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.fronts.sweep import ERROR_METHOD, sweep_fronts
from granular_fronts.model.laws import make_law
from granular_fronts.output.progress import count_bar

SWEPT_AS = {"profile_error": "error_estimate"}
"""Scalars that the sweep knows by another name."""

EXACT_TO_ROUNDING = ("tail_rate", "tail_frequency")


def solve_chunk(points, settings, activity):
    """Solve fronts.

    Parameters
    ----------
    points : dict of str to ndarray, shape (lines, fast)
        Parameters of kind ``front``.
    settings : dict
        `scalars`, `profile` in ξ, and `law`, if any; a front is always solved to round-off.
    activity : str
        What the progress bar says.

    Returns
    -------
    Solved
    """
    groups = _groups_of_law(points, settings["law"]) if "law" in settings else _groups(points)
    size = next(iter(points.values())).size
    values = {name: np.full(size, np.nan) for name in settings["scalars"]}
    reasons, errors = np.full(size, "", dtype=object), dict.fromkeys(values, np.nan)
    if settings["profile"] is not None:
        xi = KINDS["front"].profile_points(settings["profile"])
        values["relative_displacement"] = np.full((size, xi.size), np.nan)
        errors["relative_displacement"] = np.nan
    with count_bar(activity, size, "point") as bar:
        for group in groups:
            sweep = group.sweep()
            reasons[group.members] = sweep["reason"].values
            for name in settings["scalars"]:
                values[name][group.members] = sweep[SWEPT_AS.get(name, name)]
                errors[name] = np.fmax(errors[name], _error(sweep, name))
            if settings["profile"] is not None:
                _add_profiles(group, xi, values, errors, reasons)
            bar.update(group.members.size)
    for value in values.values():
        value[reasons != ""] = np.nan
    shape = next(iter(points.values())).shape
    shaped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return Solved(shaped, reasons.reshape(shape), errors, ERROR_METHOD)


class Group(NamedTuple):
    """Points that differ in the damping only, and so are swept together.

    Attributes
    ----------
    members : ndarray of int
        Places of the points.
    sweep : callable
        Without arguments, the dataset of `sweep_fronts`.
    front : callable
        The dataset of `solve_front` for the damping of a point.
    dampings : ndarray
        γ, or the factor of the viscous potential.
    """

    members: np.ndarray
    sweep: Callable
    front: Callable
    dampings: np.ndarray


def _groups(points):
    """The groups of fronts of two powers."""
    alpha, beta, gamma = (points[name].ravel() for name in ("alpha", "beta", "gamma"))
    for members, (first, second) in _equal_columns(alpha, beta):
        yield Group(
            members,
            functools.partial(sweep_fronts, first, gamma[members], second),
            functools.partial(solve_front, first, beta=second),
            gamma[members],
        )


def _groups_of_law(points, law):
    """The groups of fronts of a law between two states."""
    damping = points["damping"].ravel()
    others = {name: value.ravel() for name, value in points.items() if name != "damping"}
    for members, column in _equal_columns(*others.values()):
        point = dict(zip(others, column, strict=True))
        made, states = make_law(law_at(law, point)), (point["behind"], point["ahead"])
        yield Group(
            members,
            functools.partial(sweep_fronts, law=made, states=states, factors=damping[members]),
            functools.partial(_front_of_law, made, states),
            damping[members],
        )


def _front_of_law(law, states, factor):
    return solve_front(law=law.with_damping(factor), states=states)


def _equal_columns(*rows):
    """For each different column of some rows: where it stands, and its numbers as floats."""
    columns, column_of_point = np.unique(np.stack(rows), axis=1, return_inverse=True)
    for number, column in enumerate(columns.T):
        yield np.flatnonzero(column_of_point.ravel() == number), tuple(map(float, column))


def _error(sweep, name):
    """Largest error of a scalar over the solved fronts, NaN for what is an error itself."""
    if name in EXACT_TO_ROUNDING:
        return np.spacing(np.nanmax(sweep[name].values, initial=0.0))
    if f"{name}_error" not in sweep:
        return np.nan
    solved = sweep[f"{name}_error"].values[sweep["converged"].values == 1]
    return np.max(solved, initial=0.0)


def _add_profiles(group, xi, values, errors, reasons):
    """Solve the fronts of a group once more, each by itself, for u at the wanted ξ."""
    name = "relative_displacement"
    for index, damping in zip(group.members, group.dampings, strict=True):
        if reasons[index]:
            continue
        front = group.front(float(damping))
        if front.attrs["converged"]:
            values[name][index] = evaluate_front(front, xi)
            errors[name] = np.fmax(errors[name], front.attrs["error_estimate"])
        else:
            reasons[index] = front.attrs["reason"]
