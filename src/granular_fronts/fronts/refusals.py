"""Which fronts exist: what is refused before anything is computed (James 2021, section 2)."""

import math

from granular_fronts.scenes.errors import ConfigurationError


def check_law(alpha, gamma, beta=None):
    """The law of a front as three floats, beta = alpha by default.

    Raises
    ------
    ConfigurationError
        If no front of the kind sought exists for it.
    """
    alpha = check_alpha(alpha)
    beta = check_beta(alpha, beta)
    if not (math.isfinite(gamma) and gamma > 0.0):
        raise ConfigurationError(
            f"gamma is {gamma}, but must be above 0 and finite: a conservative chain whose V''' "
            "keeps one sign has no fronts, so give a damping above 0."
        )
    return alpha, float(gamma), beta


def check_alpha(alpha):
    """The exponent alpha as a float above 1."""
    if not (math.isfinite(alpha) and alpha > 1.0):
        raise ConfigurationError(
            f"alpha is {alpha}, but must be above 1 and finite: a linear chain (alpha = 1) has no "
            "fronts, eq. (18), and for alpha < 1 the front runs the other way, eq. (21)."
        )
    return float(alpha)


def check_beta(alpha, beta=None):
    """The exponent beta as a float of at least 1, alpha by default."""
    beta = alpha if beta is None else beta
    if not (math.isfinite(beta) and beta >= 1.0):
        raise ConfigurationError(
            f"beta is {beta}, but must be at least 1 and finite: below 1 the damping force is not "
            "differentiable where a contact closes."
        )
    return float(beta)


def check_right_state(right_state):
    """The relative displacement ahead, as a float in [0, 1)."""
    if not 0.0 <= right_state < 1.0:
        raise ConfigurationError(
            f"right_state is {right_state}, but must lie in [0, 1): for alpha > 1 a front leaves "
            "the larger compression, here 1, behind it, eqs. (17) and (18)."
        )
    return float(right_state)
