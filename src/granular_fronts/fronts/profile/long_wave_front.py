r"""A start for Newton's iteration: the front of the chain without its inertia of long waves.

For waves that vary over many sites :math:`K * u` is u and its derivative, and the profile equation
(see `profile`) becomes

.. math::

    c^2 (u - r) = u^\alpha - r^\alpha - \gamma c\,(u^\beta)' ,

for β = α and r = 0 the equation behind James (2021), eq. (46), and for β = 1 the front

.. math::

    u = [1 + (2^{\alpha-1} - 1)\, e^{(\alpha-1)\xi/\gamma}]^{-1/(\alpha-1)} .

It is solved for ξ(u) by one integral.  Where damping is weak the front is never steeper than the
one at about critical damping, which serves as a start there.
"""

import numpy as np

# Up to 36, beyond which u is 1 to the last digit and the integrand has no value.
LOGITS = np.linspace(-36.0, 36.0, 721)


def continuum_front(law, damping):
    """The front of the long-wave equation, inverted.

    Parameters
    ----------
    law : newton.Law
    damping : float
        γ to use.

    Returns
    -------
    xi, u : ndarray, shape (721,)
        Increasing ξ with decreasing u from 1 to r; u is half-way between at ξ = 0.
    """
    share = 1.0 / (1.0 + np.exp(LOGITS))
    lacking = 1.0 / (1.0 + np.exp(-LOGITS))
    jump = 1.0 - law.ahead
    u = law.ahead + jump * share
    from_behind = -np.expm1(law.alpha * np.log1p(-jump * lacking)) - law.speed**2 * jump * lacking
    if law.ahead > 0.0:
        rise = law.ahead**law.alpha * np.expm1(law.alpha * np.log1p(jump * share / law.ahead))
    else:
        rise = u**law.alpha
    from_ahead = law.speed**2 * jump * share - rise
    pull = np.where(share > 0.5, from_behind, from_ahead)
    slope = damping * law.speed * law.beta * u ** (law.beta - 1.0) * jump * share * lacking / pull
    xi = np.concatenate([[0.0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * np.diff(LOGITS))])
    return xi - xi[LOGITS.size // 2], u
