r"""The logarithmic Burgers limit of the generalised Kuwabara-Kono chain (James 2021, section 4).

The relative displacements of the chain with :math:`\beta = \alpha` (35) obey
:math:`\ddot u = (1 + \gamma\,d/dt)\,\Delta_d u_+^\alpha` (36).  Waves that vary over many beads
solve it approximately as (37),

.. math::

    u_n(t) = \delta\, y(\xi, \tau)^{1/\alpha}, \quad \xi = \varepsilon(n - ct), \quad
    \tau = \tfrac12\gamma\varepsilon^2c^2 t, \quad c = \delta^{(\alpha-1)/2}, \quad
    \varepsilon = \frac{\alpha - 1}{\alpha\gamma c},

provided that :math:`(1 - 1/\alpha)^{1/2} \ll \gamma c`.  An expansion in
:math:`\varepsilon` (38), integrated once (39), gives (40) for the rescaled force y,

.. math::

    \partial_\tau(y^{1/\alpha}) + \partial_\xi f_\alpha(y) = \partial_\xi^2 y, \qquad
    f_\alpha(y) = \frac{y - y^{1/\alpha}}{1 - 1/\alpha},

and in the limit :math:`\alpha \to 1^+`, where :math:`f_\alpha(y) \to y\ln y`, the logarithmic
Burgers equation (41), :math:`\partial_\tau y + \partial_\xi(y\ln y) = \partial_\xi^2 y`.

Fronts.  A stationary front that falls from 1 to 0 solves :math:`y' = f_\alpha(y)`.  With the phase
:math:`u(0) = \delta/2` it is

.. math:: y_\alpha(\xi) = \bigl[1 - (1 - 2^{1-\alpha})\, e^\xi\bigr]_+^{\alpha/(\alpha-1)}

of (46), zero from :math:`\xi_0 = -\ln(1 - 2^{1-\alpha})` on, and in the limit
:math:`y = 2^{-e^\xi}`.  Equation (45), :math:`y_1 = 2^{-\alpha e^\xi}`, is that limit moved by
:math:`\ln\alpha`, so that :math:`y_1^{1/\alpha} = 2^{-e^\xi}` has the phase 1/2 for the chain's own
exponent: it is u/δ of (47).

The scales and the velocities that belong to y are in `granular_fronts.model.amplitude_scaling`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular_fronts.arguments import array, scalar

if TYPE_CHECKING:
    import numpy.typing as npt


def flux(y: npt.ArrayLike, alpha: float) -> np.ndarray:
    """Return the flux f_α(y) of James (2021), eq. (40), accurate however close α is to 1.

    An InputError if α ≤ 1 or some y < 0.
    """
    alpha = _check_alpha(alpha)
    exponent = (alpha - 1.0) / alpha
    y = _check_force(y)
    with np.errstate(divide="ignore"):
        return -y * np.expm1(-exponent * np.log(np.where(y > 0.0, y, 1.0))) / exponent


def limit_flux(y: npt.ArrayLike) -> np.ndarray:
    """Return the limit y ln y of f_α for α → 1⁺, eq. (41); zero at y = 0."""
    y = _check_force(y)
    return y * np.log(np.where(y > 0.0, y, 1.0))


def log_burgers_front(xi: npt.ArrayLike, alpha: float | None = None) -> np.ndarray:
    """Return the stationary front y(ξ) from 1 at −∞ to 0 at +∞, with y^(1/α) = 1/2 at ξ = 0.

    Parameters
    ----------
    xi : array_like
        ξ = ε(n − ct).
    alpha : float, optional
        Exponent of the unlimited equation (40), whose front is James (2021), eq. (46). Without it,
        the front of the logarithmic Burgers equation (41), y = 2^(−e^ξ); eq. (45) for an exponent α
        is `log_burgers_front(xi) ** alpha`.

    Returns
    -------
    ndarray
        Shape of `xi`, from 0 to 1; of (46) accurate however close α is to 1.

    Raises
    ------
    InputError
        If α ≤ 1.

    Examples
    --------
    >>> gf.log_burgers_front([-1.0, 0.0, 1.0]).round(6)
    array([0.774921, 0.5     , 0.151955])
    """
    xi = array("xi", xi)
    if alpha is None:
        with np.errstate(over="ignore"):
            return np.exp2(-np.exp(xi))
    alpha = _check_alpha(alpha)
    taken = np.exp(np.minimum(xi - front_end(alpha), 0.0))
    with np.errstate(divide="ignore"):
        return np.exp(alpha / (alpha - 1.0) * np.log1p(-taken))


def front_end(alpha):
    """Return ξ₀ of eq. (46); the front is zero beyond it."""
    alpha = _check_alpha(alpha)
    return -np.log(-np.expm1((1.0 - alpha) * np.log(2.0)))


def _check_alpha(alpha):
    advice = "equation (40) and its front need it, so use the limit for alpha that tends to 1"
    return scalar("alpha", alpha, above=1.0, advice=advice)


def _check_force(y: npt.ArrayLike) -> np.ndarray:
    return array("y", y, least=0.0, advice="a contact cannot pull")
