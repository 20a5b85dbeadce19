"""Which fronts exist: the arguments of this wing, validated before anything is computed.

James (2021), section 2.  Every function returns plain numbers, or raises an `InputError`.
"""

import xarray as xr

from granular_fronts.arguments import instance, scalar
from granular_fronts.errors import InputError


def check_law(alpha, gamma, beta=None):
    """The law of a front as three floats, beta = alpha by default."""
    return check_alpha(alpha), check_gamma(gamma), check_beta(alpha, beta)


def check_alpha(alpha):
    """The exponent alpha as a float above 1."""
    return scalar(
        "alpha",
        alpha,
        above=1.0,
        advice="a linear chain (alpha = 1) has no fronts, eq. (18), and for alpha < 1 the front "
        "runs the other way, eq. (21)",
    )


def check_gamma(gamma):
    """The damping gamma as a float above 0."""
    return scalar(
        "gamma",
        gamma,
        above=0.0,
        advice="a conservative chain whose V''' keeps one sign has no fronts, so give a damping",
    )


def check_beta(alpha, beta=None):
    """The exponent beta as a float of at least 1, alpha by default."""
    return scalar(
        "beta",
        alpha if beta is None else beta,
        least=1.0,
        advice="below 1 the damping force is not differentiable where a contact closes",
    )


def check_right_state(right_state):
    """The relative displacement ahead, as a float in [0, 1)."""
    return scalar(
        "right_state",
        right_state,
        least=0.0,
        below=1.0,
        advice="for alpha > 1 a front leaves the larger compression, here 1, behind it, eqs. (17) "
        "and (18)",
    )


def check_front(front):
    """A front as data, unless it says itself that it has not converged."""
    instance("front", front, xr.Dataset, "take one from solve_front")
    needed = {"alpha", "beta", "gamma", "relative_displacement", "velocity", "xi"}
    if missing := sorted(needed - {*front.attrs, *front.variables}):
        raise InputError(f"front has no {', '.join(missing)}: take a front from solve_front.")
    if not front.attrs.get("converged", 1):
        raise InputError(
            f"front has not converged ({front.attrs['reason']}): there is nothing to evaluate."
        )
    return front
