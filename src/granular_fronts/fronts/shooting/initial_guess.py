r"""Where a shot starts from: continuum fronts, and other fronts.

Overdamped.  To first order in slow variation a front of :math:`\delta = c = 1` obeys

.. math::

    \gamma\,(u^\beta)' = u^\alpha - u, \qquad
    \frac{d\xi}{dp} = \frac{\beta\gamma\,e^{-(\beta-1)p}}{1 - e^{-(\alpha-1)p}}, \quad p = -\ln u,

which for β = α is the stationary equation of section 4, with the front (46), and for β = 1 has the
front :math:`[1 + (2^{\alpha-1} - 1)\,e^{(\alpha-1)\xi/\gamma}]^{-1/(\alpha-1)}`.

Underdamped.  For :math:`\mu < 2` the heteroclinic orbit of section 5, with
:math:`u = y^{1/\alpha}`, :math:`\xi = s/(2\sqrt3\,\varepsilon)` and
:math:`\varepsilon = (1 - 1/\alpha)^{1/2}`; near u = 1 only βγ matters, so that
:math:`\mu = 2\sqrt3\,(\beta\gamma/\alpha)/\varepsilon`.

The strain rate of either is :math:`d = -u' - \gamma\,\Delta_d u^\beta`.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_kdv_burgers.heteroclinic import compute_orbit

CRITICAL_MU = 2.0  # where the orbit of section 5 ceases to oscillate
P_FIRST, P_LAST, P_POINTS = 1.0e-17, 45.0, 2000  # p, from rounding at u = 1 to u = 3e-20
ORBIT_END = 600.0  # p up to which the orbit is evaluated


class Guess(NamedTuple):
    """A state of a chain near a front of δ = c = 1; arrays of shape (beads,)."""

    bead: np.ndarray  # consecutive numbers, 0 where u is near 1/2 for the first time from ahead
    relative_displacement: np.ndarray  # u_n
    strain_rate: np.ndarray  # d_n


def continuum_guess(alpha, gamma, beta, bead):
    """Return the front of section 4 or 5 at consecutive beads."""
    epsilon = math.sqrt((alpha - 1.0) / alpha)
    mu = 2.0 * math.sqrt(3.0) * beta * gamma / (alpha * epsilon)
    around = np.arange(bead[0] - 1.0, bead[-1] + 2.0)
    if mu < CRITICAL_MU:
        u, slope = _heteroclinic(alpha, mu, 2.0 * math.sqrt(3.0) * epsilon, around)
    else:
        u, slope = _overdamped(alpha, gamma, beta, around)
    return Guess(bead, u[1:-1], -slope[1:-1] - gamma * np.diff(u**beta, 2))


def overdamped_length(alpha, gamma, beta):
    """Return the distance from u = 1/2 to where the overdamped front is lost in rounding."""
    return float(_overdamped_xi(alpha, gamma, beta)[1][-1])


def fit(guess, bead):
    """Return state of shape (beads, 2) at the given beads: 1 behind the guess, 0 ahead of it."""
    state = np.zeros((bead.size, 2))
    state[bead < guess.bead[0], 0] = 1.0
    _, place, origin = np.intersect1d(bead, guess.bead, return_indices=True)
    state[place] = np.column_stack([guess.relative_displacement, guess.strain_rate])[origin]
    return state


def _overdamped_xi(alpha, gamma, beta):
    """Return both p = −ln u and ξ along the overdamped front, ξ = 0 at u = 1/2."""
    logarithm = np.linspace(math.log(P_FIRST), math.log(P_LAST), P_POINTS)
    p = np.exp(logarithm)
    rate = beta * gamma * p * np.exp(-(beta - 1.0) * p) / -np.expm1(-(alpha - 1.0) * p)
    steps = 0.5 * (rate[1:] + rate[:-1]) * np.diff(logarithm)
    xi = np.concatenate([[0.0], np.cumsum(steps)])
    return p, xi - np.interp(math.log(math.log(2.0)), logarithm, xi)


def _overdamped(alpha, gamma, beta, xi):
    p, xi_of_p = _overdamped_xi(alpha, gamma, beta)
    u = np.exp(-np.exp(np.interp(xi, xi_of_p, np.log(p))))
    u[xi > xi_of_p[-1]] = 0.0
    slope = np.zeros(u.size)
    ahead = u > 0.0
    slope[ahead] = (u[ahead] ** alpha - u[ahead]) / (beta * gamma * u[ahead] ** (beta - 1.0))
    return u, slope


def _heteroclinic(alpha, mu, scale, xi):
    """Return both u and u' of the heteroclinic orbit, moved so that u(0) = 1/2."""
    s = scale * xi
    orbit = compute_orbit(mu, min(s[0], 0.0))
    phase = orbit.s_at(alpha * math.log(2.0))
    p, v = orbit.evaluate(np.clip(s + phase, s[0], orbit.s_at(ORBIT_END)))
    u = np.exp(-p / alpha)
    return u, -(scale / alpha) * v * u
