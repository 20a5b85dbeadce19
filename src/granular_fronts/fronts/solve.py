"""Exact fronts of a chain as data: the public functions.

Two powers are given by their exponents and γ, in units where the compression behind is 1. For β =
α, γ of a run at another δ is multiplied by δ^((α − 1)/2), James (2021), eq. (30).  Any law is given
as such, together with the strains that its front joins.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.accuracy import EPSILON, refined_by
from granular_fronts.arguments import array, choice
from granular_fronts.errors import InputError, NoFrontError
from granular_fronts.fronts.profile.equation import FrontProblem, front_problem, power_problem
from granular_fronts.fronts.profile.solve import (
    ORDER,
    REFINED_ORDER,
    refine,
    solve_profile,
)
from granular_fronts.fronts.properties import (
    MEASURES,
    errors_of_measures,
    measure,
    velocity,
    with_overshoot,
)
from granular_fronts.fronts.validation import (
    check_front,
    check_given_law,
    check_grid,
    check_law,
    check_right_state,
    is_given_by_law,
)
from granular_fronts.model.laws import Law, make_law
from granular_fronts.numerics.interpolation import interpolate_all
from granular_fronts.output.datasets import name_variables

if TYPE_CHECKING:
    import numpy.typing as npt

ACCEPTED_ERROR = 1e-12  # of the strain of a converged front, relative to the larger state

FIELDS = ("relative_displacement", "velocity", "strain")


class _Sought(NamedTuple):
    """A law, the strains R_b behind and R_a ahead, and their problem."""

    law: Law
    behind: float
    ahead: float
    problem: FrontProblem


class Solution(NamedTuple):
    """A front by either method, on a uniform grid."""

    problem: FrontProblem
    spacing: float
    xi: np.ndarray
    s: np.ndarray
    velocity: np.ndarray  # ẋ in the units of the law
    residuals: np.ndarray  # the largest before each step and after the last
    speed_defect: float


def solve_front(
    alpha: float | None = None,
    gamma: float | None = None,
    beta: float | None = None,
    method: str = "profile",
    right_state: float = 0.0,
    *,
    law: Law | Mapping[str, Any] | None = None,
    states: Sequence[float] | None = None,
) -> xr.Dataset:
    """Solve a travelling front of two powers, or of any law between two states.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gamma : float
        Damping, above 0, in the units of the front.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.
    method : {"profile", "shooting"}
        By the advance–delay equation, see `profile.equation`; or by the motion of a window of
        beads, see `shooting`.  Shooting knows only two powers and a chain at rest ahead.
    right_state : float, optional
        Compression r ahead of a front of two powers from compression 1, 0 ≤ r < 1; the speed is
        c = ((1 − r^α)/(1 − r))^(1/2), eq. (14).
    law : Law or mapping, optional
        In place of alpha, gamma, beta and right_state: a law of `make_law`, or what it takes.
    states : pair of float, optional
        Strains R_b behind and R_a ahead, with the law, negative in compression.

    Returns
    -------
    xarray.Dataset
        `strain`, `relative_displacement` (its negative) and `velocity` on `xi` = n − ct, each with
        `error_estimate` and `error_method`.  The grid is uniform; the strain is half-way between
        R_b and R_a at ξ = 0, and equal to them beyond the grid, to round-off.  Velocities are −cR
        behind and ahead, eq. (12); a uniform one may be added. `residual_history` on `iteration`,
        the largest residual before each step and after the last.  Attributes: `law` as JSON,
        `state_behind`, `state_ahead`, for two powers from compression 1 `alpha`, `beta`, `gamma`,
        `right_state`; `method`, `speed`, `converged` (0 or 1) and `reason`, `residual`,
        `error_estimate` of the strain, `spacing` of the grid.  `speed_defect` is the speed found
        over the exact one, less 1 (shooting prescribes it).  Measures are `first_peak` and
        `largest_peak`, the first and the largest maximum less the state behind, `width_10_90`,
        `slope` and `dissipated_power`; these and the defect have an `…_error`.  `overshoot` is
        `largest_peak`. Where converged is 0, all but the law and the reason are NaN.

    Raises
    ------
    InputError
        If a parameter is out of range, or no such front exists.

    Examples
    --------
    >>> front = gf.solve_front(
    ...     law={
    ...         "elastic": {"kind": "toda"},
    ...         "viscous": {"kind": "linear", "gamma": 0.3},
    ...     },
    ...     states=(-2.0, 0.0),
    ... )
    >>> round(front.attrs["speed"], 3)
    1.787
    """
    choice("method", method, METHODS)
    powers = {"alpha": alpha, "gamma": gamma, "beta": beta}
    right_state = check_right_state(right_state)
    if is_given_by_law(powers, {"law": law, "states": states}):
        given, (behind, ahead) = check_given_law(law, states)
        if right_state > 0.0:
            raise InputError(
                f"right_state is {right_state}, but the states of the law say what is ahead: leave "
                "it out."
            )
        sought = _Sought(given, behind, ahead, front_problem(given, behind, ahead))
    else:
        alpha, gamma, beta = check_law(alpha, gamma, beta)
        given = make_law(alpha=alpha, beta=beta, gamma=gamma)
        problem = power_problem(alpha, gamma, beta, right_state)
        sought = _Sought(given, -1.0, 0.0 - right_state, problem)
    try:
        return _describe(method, sought, *METHODS[method](sought))
    except NoFrontError as failure:
        return _describe_failure(method, sought, str(failure))


def evaluate_front(
    front: xr.Dataset, xi: npt.ArrayLike, name: str = "relative_displacement"
) -> np.ndarray:
    """Evaluate the relative displacement, the velocity or the strain of a front anywhere.

    Parameters
    ----------
    front : xarray.Dataset
        From `solve_front`, converged.
    xi : array_like
        Positions n − ct.
    name : {"relative_displacement", "velocity", "strain"}, optional

    Returns
    -------
    ndarray
        Shape of `xi`, by local polynomials through 20 points.  Beyond the grid it has the values of
        both states, to round-off.

    Raises
    ------
    InputError
        If the front has not converged, or was thinned, cropped or shifted.

    Examples
    --------
    >>> front = gf.solve_front(alpha=1.5, gamma=0.3)
    >>> gf.evaluate_front(front, [-30.0, 0.0]).round(9)
    array([1. , 0.5])
    """
    check_front(front)
    xi = array("xi", xi, advice="leave that point out")
    choice("name", name, [field for field in FIELDS if field in front])
    check_grid(front)
    values = front[name].values
    positions, middle = _positions(front["xi"].values, xi.ravel())
    return interpolate_all(values, positions, values[0], values[-1], middle).reshape(xi.shape)


def _by_profile(sought):
    profiles = refined_by(
        lambda found: _settled(refine(found)), _settled(solve_profile(sought.problem))
    )
    return [
        Solution(
            found.problem,
            float(found.spacing),
            found.xi,
            found.s,
            velocity(found, order),
            found.residuals,
            found.speed_defect,
        )
        for found, order in zip(profiles, (ORDER, REFINED_ORDER), strict=True)
    ]


def _settled(profile):
    if profile.reason:
        raise NoFrontError(profile.reason)
    return profile


def _by_shooting(sought):
    """Return a front and its refinement by shooting, on a grid for local polynomials."""
    from granular_fronts.fronts.shooting import solve as shooting  # only this method needs it

    law = sought.law
    if not (law.is_power and sought.behind == -1.0):
        raise InputError(
            f"law is {json.dumps(law.describe(), default=str)} and the states are "
            f"{sought.behind:g} and {sought.ahead:g}, but shooting takes only the law (28), "
            'from compression 1 into a chain at rest: use method "profile".'
        )
    if sought.ahead < 0.0:
        raise InputError(
            f"right_state is {-sought.ahead}, but shooting needs a chain at rest ahead: "
            'use method "profile".'
        )
    shots = refined_by(
        lambda found: _converged(shooting.refine(found)),
        _converged(shooting.shoot_front(law.alpha, law.gamma, law.beta)),
    )
    points = math.ceil(6.0 + 4.3 * max(law.alpha, law.beta))
    # The refined front has points of its own, so that errors between points are seen.
    return [
        Solution(
            sought.problem,
            1.0 / number,
            *shooting.sample_front(found, number),
            found.residuals,
            0.0,
        )
        for found, number in zip(shots, (points, points + points // 2), strict=True)
    ]


def _converged(shot):
    if not shot.converged:
        raise NoFrontError(shot.reason)
    return shot


METHODS = {"profile": _by_profile, "shooting": _by_shooting}


def _describe(method, sought, solution, refined):
    """Return the dataset of a front, its errors the differences to the refined one."""
    problem = sought.problem
    size = problem.size
    positions, middle = _positions(solution.xi, refined.xi)
    again = interpolate_all(solution.s, positions, 1.0, 0.0, middle)
    error = max(abs(problem.jump) * _largest(again - refined.s), EPSILON * size)
    if error > ACCEPTED_ERROR * size:
        raise NoFrontError(f"the strain errs by {error:.1e}, more than {ACCEPTED_ERROR * size:g}")
    ends = (-problem.speed * R for R in (sought.behind, sought.ahead))
    again = interpolate_all(solution.velocity, positions, *ends, middle)
    velocity_error = max(_largest(again - refined.velocity), EPSILON * problem.speed * size)
    u = problem.start + problem.jump * solution.s
    (values, sensitivities), (others, _) = measure(solution), measure(refined)
    errors = errors_of_measures(values, others, sensitivities, error / abs(problem.jump))
    defects = solution.speed_defect, refined.speed_defect
    return _dataset(
        method,
        sought,
        solution.xi,
        {
            "relative_displacement": (u, error),
            "velocity": (solution.velocity, velocity_error),
            "strain": (-u, error),
        },
        solution.residuals,
        converged=1,
        reason="",
        residual=float(solution.residuals[-1]),
        speed_defect=solution.speed_defect,
        # Both would be 0 without rounding.
        speed_defect_error=max(EPSILON, *map(abs, defects)),
        error_estimate=error,
        spacing=solution.spacing,
        **with_overshoot(_named(values, errors)),
    )


def _named(values, errors):
    """Return measures by name, each with its error."""
    return dict(zip(MEASURES, values, strict=True)) | {
        f"{name}_error": value for name, value in zip(MEASURES, errors, strict=True)
    }


def _describe_failure(method, sought, reason):
    """Return the dataset of a front that was not found: NaN at ξ = 0."""
    nothing = np.full(1, math.nan), math.nan
    unknown = ("residual", "speed_defect", "speed_defect_error", "error_estimate", "spacing")
    nothing_measured = np.full(len(MEASURES), math.nan)
    return _dataset(
        method,
        sought,
        np.zeros(1),
        dict.fromkeys(FIELDS, nothing),
        np.empty(0),
        converged=0,
        reason=reason,
        **dict.fromkeys(unknown, math.nan),
        **with_overshoot(_named(nothing_measured, nothing_measured)),
    )


def _dataset(method, sought, xi, fields, residuals, **attributes):
    error_method = import_module(f"granular_fronts.fronts.{method}.solve").ERROR_METHOD
    variables = {
        name: ("xi", values, {"error_estimate": error, "error_method": error_method})
        for name, (values, error) in fields.items()
    }
    variables["residual_history"] = ("iteration", residuals)
    coordinate = {"xi": ("xi", xi, {"long_name": "distance from the front, n - ct"})}
    described = describe_front(sought.law, sought.behind, sought.ahead)
    described |= {"speed": sought.problem.speed, "method": method}
    return name_variables(xr.Dataset(variables, coordinate, described | attributes))


def describe_front(law, behind, ahead):
    """Return the law and states as attributes of a dataset."""
    described = {
        "law": json.dumps(law.describe(), default=str),
        "state_behind": behind,
        "state_ahead": ahead,
    }
    if not (law.is_power and behind == -1.0):
        return described
    powers = {"alpha": law.alpha, "beta": law.beta, "gamma": law.gamma}
    return described | powers | {"right_state": 0.0 - ahead}


def _positions(grid, xi):
    """Return positions in units of the spacing of a grid, 0 at ξ = 0, and the index of ξ = 0."""
    middle = int(np.argmin(np.abs(grid)))
    return xi / grid[middle + 1], middle


def _largest(differences):
    return float(np.abs(differences).max())
