"""Exact fronts of the lattice as data: the public face of this wing.

Units are those of the front, δ = c = 1 for a chain at rest ahead; γ from a run at another δ with
β = α is multiplied by δ^((α − 1)/2), James (2021), eq. (30).
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.configuration import ConfigurationError
from granular_fronts.fronts.interpolation import interpolate_all
from granular_fronts.fronts.measures import MEASURES, measure, velocity
from granular_fronts.fronts.profile import ORDER, REFINED_ORDER, make_law, refine, solve_profile
from granular_fronts.fronts.refusals import check_law, check_right_state

ACCEPTED_ERROR = 1e-12
"""Error estimate of u up to which a front is called converged."""

ERROR_METHOD = (
    f"largest difference to a solution with {REFINED_ORDER} instead of {ORDER} points per "
    "polynomial, on a grid finer by 1.4 or more and a window longer by 1.1"
)

RESOLUTION = 2.0**-52


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
    method : {"profile"}
        By the advance–delay equation, see `profile`.
    right_state : float, optional
        Compression r ahead, 0 ≤ r < 1; the speed is c = ((1 − r^α)/(1 − r))^(1/2), eq. (14).

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on `xi` = n − ct, a uniform grid where u(0) is
        (1 + r)/2, and beyond which u is 1 or r to round-off; both with `error_estimate` and
        `error_method`.  Attributes: the law, `method`, `speed`, `converged` (0 or 1) and `reason`,
        `residual` of the equation, `speed_defect` (the speed found over the exact one, less 1),
        `error_estimate` of u, `overshoot`, `width_10_90`, `slope`, `dissipated_power`, and
        `…_error` of these four.  Where converged is 0, all but the law and the reason are NaN.

    Raises
    ------
    ConfigurationError
        If a parameter is out of range, or no such front exists.
    """
    if method not in METHODS:
        raise ConfigurationError(
            f"method is {method!r}, but must be one of {', '.join(METHODS)}: choose one of these."
        )
    alpha, gamma, beta = check_law(alpha, gamma, beta)
    return METHODS[method](make_law(alpha, gamma, beta, check_right_state(right_state)))


def evaluate_front(front, xi):
    """The relative displacement of a front anywhere.

    Parameters
    ----------
    front : xarray.Dataset
        From `solve_front`, converged.
    xi : array_like
        Positions n − ct.

    Returns
    -------
    ndarray
        Shape of `xi`, by local polynomials through 20 points; 1 or r beyond the grid.

    Raises
    ------
    ConfigurationError
        If the front has not converged.
    """
    if not front.attrs["converged"]:
        raise ConfigurationError(
            f"The front has not converged ({front.attrs['reason']}): there is nothing to evaluate."
        )
    xi = np.asarray(xi, dtype=float)
    grid = front["xi"].values
    spacing = (grid[-1] - grid[0]) / (grid.size - 1)
    u = front["relative_displacement"].values
    values = interpolate_all(u, (xi.ravel() - grid[0]) / spacing, 1.0, front.attrs["right_state"])
    return values.reshape(xi.shape)


def solve_by_profile(law):
    """A front with its measures and errors, by the profile equation."""
    profile = solve_profile(law)
    if profile.reason:
        return _failure(law, profile.reason)
    refined = refine(profile)
    if refined.reason:
        return _failure(law, f"the refinement that should tell the error failed: {refined.reason}")
    error = _difference(profile.evaluate(refined.xi), refined.u)
    if error > ACCEPTED_ERROR:
        return _failure(law, f"u errs by about {error:.1e}, more than {ACCEPTED_ERROR:g}")
    return _describe(profile, refined, error)


METHODS = {"profile": solve_by_profile}


def _describe(profile, refined, error):
    """The dataset of a converged front."""
    law, v = profile.law, velocity(profile, ORDER)
    rest = law.speed, law.speed * law.ahead
    v_refined = velocity(refined, REFINED_ORDER)
    v_error = _difference(interpolate_all(v, profile.positions(refined.xi), *rest), v_refined)
    found, found_again = measure(profile), measure(refined)
    errors = {f"{name}_error": abs(found[name] - found_again[name]) for name in MEASURES}
    return _dataset(
        law,
        profile.xi,
        (profile.u, error),
        (v, v_error),
        converged=1,
        reason="",
        residual=float(profile.residuals[-1]),
        speed_defect=profile.speed_defect,
        error_estimate=error,
        **found,
        **errors,
    )


def _failure(law, reason):
    """The dataset of a law whose front was not found: NaN at ξ = 0."""
    nothing = np.full(1, math.nan), math.nan
    unknown = ("residual", "speed_defect", "error_estimate", *MEASURES)
    unknown += tuple(f"{name}_error" for name in MEASURES)
    return _dataset(
        law,
        np.zeros(1),
        nothing,
        nothing,
        converged=0,
        reason=reason,
        **dict.fromkeys(unknown, math.nan),
    )


def _dataset(law, xi, displacement, velocity, **attributes):
    variables = {
        name: ("xi", values, {"error_estimate": error, "error_method": ERROR_METHOD})
        for name, (values, error) in (
            ("relative_displacement", displacement),
            ("velocity", velocity),
        )
    }
    described = {
        "alpha": law.alpha,
        "beta": law.beta,
        "gamma": law.gamma,
        "right_state": law.ahead,
        "speed": law.speed,
        "method": "profile",
    }
    coordinate = {"xi": ("xi", xi, {"long_name": "distance from the front, n - ct"})}
    return xr.Dataset(variables, coords=coordinate, attrs=described | attributes)


def _difference(values, others):
    """Largest difference, or one unit of the last digit where they agree."""
    return max(float(np.abs(values - others).max()), RESOLUTION)
