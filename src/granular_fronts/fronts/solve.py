"""Exact fronts of the lattice as data: the public face of this wing.

Units are those of the front, δ = c = 1 for a chain at rest ahead; γ from a run at another δ with
β = α is multiplied by δ^((α − 1)/2), James (2021), eq. (30).
"""

import math
from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.arguments import array, choice
from granular_fronts.errors import InputError, NoFrontError
from granular_fronts.fronts.profile.newton import Law
from granular_fronts.fronts.profile.solve import (
    ORDER,
    REFINED_ORDER,
    make_law,
    refine,
    solve_profile,
)
from granular_fronts.fronts.properties import MEASURES, measure, velocity
from granular_fronts.fronts.shooting import solve as shooting
from granular_fronts.fronts.shooting.sampling import sample_front
from granular_fronts.fronts.validation import check_front, check_law, check_right_state
from granular_fronts.numerics.interpolation import interpolate_all

ACCEPTED_ERROR = 1e-12
"""Error estimate of u up to which a front is called converged."""

ERROR_METHODS = {
    "profile": f"largest difference to a solution with {REFINED_ORDER} instead of {ORDER} points "
    "per polynomial, on a grid finer by 1.4 or more and a window longer by 1.1",
    "shooting": "largest difference to a solution with twice the time steps, in a window longer by "
    f"{shooting.LONGER_BEHIND:g} behind and {shooting.LONGER_AHEAD} beads ahead",
}

RESOLUTION = 2.0**-52


class Solution(NamedTuple):
    """A front by either method.

    Attributes
    ----------
    law : newton.Law
    spacing : float
    xi, u, velocity : ndarray, shape (points,)
        On a uniform grid.
    residuals : ndarray
        Largest residual before each step and after the last.
    speed_defect : float
    """

    law: Law
    spacing: float
    xi: np.ndarray
    u: np.ndarray
    velocity: np.ndarray
    residuals: np.ndarray
    speed_defect: float


def solve_front(alpha, gamma, beta=None, method="profile", right_state=0.0):
    """The travelling front from compression 1 behind to `right_state` ahead.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gamma : float
        Damping, above 0, in the units of the front.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.
    method : {"profile", "shooting"}
        By the advance–delay equation, see `profile`; or by the motion of a window of beads, see
        `shooting`, which knows a chain at rest ahead only.
    right_state : float, optional
        Compression r ahead, 0 ≤ r < 1; the speed is c = ((1 − r^α)/(1 − r))^(1/2), eq. (14).

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on `xi` = n − ct, a uniform grid where u(0) is
        (1 + r)/2, and beyond which u is 1 or r to round-off; both with `error_estimate` and
        `error_method`.  `residual_history` on `iteration`, the largest residual before each step
        and after the last.  Attributes: the law, `method`, `speed`, `converged` (0 or 1) and
        `reason`, `residual`, `speed_defect` (the speed found over the exact one, less 1; shooting
        prescribes it), `error_estimate` of u, `overshoot`, `width_10_90`, `slope`,
        `dissipated_power`, and `…_error` of these four.  Where converged is 0, all but the law and
        the reason are NaN.

    Raises
    ------
    InputError
        If a parameter is out of range, or no such front exists.
    """
    choice("method", method, METHODS)
    alpha, gamma, beta = check_law(alpha, gamma, beta)
    law = make_law(alpha, gamma, beta, check_right_state(right_state))
    try:
        return _describe(method, *METHODS[method](law))
    except NoFrontError as failure:
        return _describe_failure(method, law, str(failure))


def evaluate_front(front, xi, name="relative_displacement"):
    """The relative displacement, or the velocity, of a front anywhere.

    Parameters
    ----------
    front : xarray.Dataset
        From `solve_front`, converged.
    xi : array_like
        Positions n − ct.
    name : {"relative_displacement", "velocity"}, optional

    Returns
    -------
    ndarray
        Shape of `xi`, by local polynomials through 20 points; the states of both ends beyond the
        grid.

    Raises
    ------
    InputError
        If the front has not converged.
    """
    check_front(front)
    xi = array("xi", xi, advice="leave that point out")
    ends = _ends(front.attrs["speed"], front.attrs["right_state"])
    choice("name", name, ends)
    positions = _positions(front["xi"].values, xi.ravel())
    return interpolate_all(front[name].values, positions, *ends[name]).reshape(xi.shape)


def by_profile(law):
    """A front and its refinement by the profile equation."""
    profile = solve_profile(law)
    if profile.reason:
        raise NoFrontError(profile.reason)
    refined = refine(profile)
    if refined.reason:
        raise NoFrontError(
            f"the refinement that should estimate the error failed: {refined.reason}"
        )
    return [
        Solution(
            law,
            float(found.spacing),
            found.xi,
            found.u,
            velocity(found, order),
            found.residuals,
            found.speed_defect,
        )
        for found, order in ((profile, ORDER), (refined, REFINED_ORDER))
    ]


def by_shooting(law):
    """A front and its refinement by shooting, on a grid fine enough for local polynomials."""
    if law.ahead > 0.0:
        raise InputError(
            f"right_state is {law.ahead}, but shooting closes its window on a chain at rest: use "
            'method "profile".'
        )
    shot = shooting.shoot_front(law.alpha, law.gamma, law.beta)
    if not shot.converged:
        raise NoFrontError(shot.reason)
    refined = shooting.refine(shot)
    if not refined.converged:
        raise NoFrontError(
            f"the refinement that should estimate the error failed: {refined.reason}"
        )
    points = math.ceil(6.0 + 4.3 * law.alpha)
    return [
        Solution(law, 1.0 / points, *sample_front(found, points), found.residuals, 0.0)
        for found in (shot, refined)
    ]


METHODS = {"profile": by_profile, "shooting": by_shooting}


def _describe(method, solution, refined):
    """The dataset of a front, its errors the differences to the refined one."""
    law, ends = solution.law, _ends(solution.law.speed, solution.law.ahead)
    positions = _positions(solution.xi, refined.xi)
    pairs = {
        "relative_displacement": (solution.u, refined.u),
        "velocity": (solution.velocity, refined.velocity),
    }
    errors = {
        name: _difference(interpolate_all(values, positions, *ends[name]), others)
        for name, (values, others) in pairs.items()
    }
    error = errors["relative_displacement"]
    if error > ACCEPTED_ERROR:
        raise NoFrontError(f"u errs by about {error:.1e}, more than {ACCEPTED_ERROR:g}")
    found, found_again = measure(solution), measure(refined)
    return _dataset(
        method,
        law,
        solution.xi,
        {name: (values, errors[name]) for name, (values, _) in pairs.items()},
        solution.residuals,
        converged=1,
        reason="",
        residual=float(solution.residuals[-1]),
        speed_defect=solution.speed_defect,
        error_estimate=error,
        **found,
        **{f"{name}_error": abs(found[name] - found_again[name]) for name in MEASURES},
    )


def _describe_failure(method, law, reason):
    """The dataset of a law whose front was not found: NaN at ξ = 0."""
    nothing = np.full(1, math.nan), math.nan
    fields = dict.fromkeys(("relative_displacement", "velocity"), nothing)
    unknown = ("residual", "speed_defect", "error_estimate", *MEASURES)
    unknown += tuple(f"{name}_error" for name in MEASURES)
    values = dict.fromkeys(unknown, math.nan)
    return _dataset(
        method, law, np.zeros(1), fields, np.empty(0), converged=0, reason=reason, **values
    )


def _dataset(method, law, xi, fields, residuals, **attributes):
    variables = {
        name: ("xi", values, {"error_estimate": error, "error_method": ERROR_METHODS[method]})
        for name, (values, error) in fields.items()
    }
    variables["residual_history"] = ("iteration", residuals)
    described = {
        "alpha": law.alpha,
        "beta": law.beta,
        "gamma": law.gamma,
        "right_state": law.ahead,
        "speed": law.speed,
        "method": method,
    }
    coordinate = {"xi": ("xi", xi, {"long_name": "distance from the front, n - ct"})}
    return xr.Dataset(variables, coords=coordinate, attrs=described | attributes)


def _positions(grid, xi):
    """Positions in units of the spacing of a grid, 0 at its first point."""
    middle = int(np.argmin(np.abs(grid)))
    # Counted from ξ = 0, a position near the front has no rounding error of a far end.
    return xi / grid[middle + 1] + middle


def _ends(speed, ahead):
    """Values of each field behind and ahead of its grid."""
    return {"relative_displacement": (1.0, ahead), "velocity": (speed, speed * ahead)}


def _difference(values, others):
    """Largest difference, or one unit of the last digit where they agree."""
    return max(float(np.abs(values - others).max()), RESOLUTION)
