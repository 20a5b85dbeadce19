"""Points of exact fronts of the lattice, in their own units δ = c = 1: James (2021), section 6.

Fronts of one law are swept along the damping, each from the ones before it, whichever axis is the
fast one; see `fronts.sweep` for the method and its error estimates.  The slowest
tail is a root of the dispersion relation and knows nothing of the solution; a front is monotone
where it is real.
"""

import numpy as np

from granular_fronts.campaign.kinds import KINDS, Solved
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.fronts.sweep import ERROR_METHOD, sweep_fronts
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
        `scalars`, and `profile` in ξ; a front is always solved to round-off.
    activity : str
        What the progress bar says.

    Returns
    -------
    Solved
    """
    alpha, beta, gamma = (points[name].ravel() for name in ("alpha", "beta", "gamma"))
    values = {name: np.full(gamma.size, np.nan) for name in settings["scalars"]}
    reasons, errors = np.full(gamma.size, "", dtype=object), dict.fromkeys(values, np.nan)
    laws, law_of_point = np.unique(np.stack([alpha, beta]), axis=1, return_inverse=True)
    with count_bar(activity, gamma.size, "point") as bar:
        for number, (law_alpha, law_beta) in enumerate(laws.T):
            members = np.flatnonzero(law_of_point.ravel() == number)
            sweep = sweep_fronts(law_alpha, gamma[members], law_beta)
            for name in values:
                values[name][members] = sweep[SWEPT_AS.get(name, name)]
                errors[name] = np.fmax(errors[name], _error(sweep, name))
            reasons[members] = sweep["reason"].values
            bar.update(members.size)
    if settings["profile"] is not None:
        _add_profiles(values, errors, (alpha, gamma, beta), reasons, settings["profile"])
    for value in values.values():
        value[reasons != ""] = np.nan
    shape = points["gamma"].shape
    shaped = {name: value.reshape(*shape, *value.shape[1:]) for name, value in values.items()}
    return Solved(shaped, reasons.reshape(shape), errors, ERROR_METHOD)


def _error(sweep, name):
    """Largest error of a scalar over the solved fronts, NaN for what is an error itself."""
    if name in EXACT_TO_ROUNDING:
        return np.spacing(np.nanmax(sweep[name].values, initial=0.0))
    if f"{name}_error" not in sweep:
        return np.nan
    solved = sweep[f"{name}_error"].values[sweep["converged"].values == 1]
    return np.max(solved, initial=0.0)


def _add_profiles(values, errors, law, reasons, profile):
    """Solve the fronts once more, each by itself, for u at the wanted ξ."""
    xi = KINDS["front"].profile_points(profile)
    profiles, worst = np.full((reasons.size, xi.size), np.nan), np.nan
    for index in np.flatnonzero(reasons == ""):
        front = solve_front(*(float(parameter[index]) for parameter in law))
        if front.attrs["converged"]:
            profiles[index] = evaluate_front(front, xi)
            worst = np.fmax(worst, front.attrs["error_estimate"])
        else:
            reasons[index] = front.attrs["reason"]
    values["relative_displacement"], errors["relative_displacement"] = profiles, worst
