r"""The front of long waves: where Newton's iteration starts, and how long a front is.

For waves that vary over many sites the convolutions of `equation` are the function and its
derivative, and the profile equation becomes

.. math:: s = p(s) - \frac{d}{d\xi} q(s) ,

for Hertz contacts with β = α the equation behind James (2021), eq. (46), and for β = 1 the front

.. math::

    s = [1 + (2^{\alpha-1} - 1)\, e^{(\alpha-1)\xi/\gamma}]^{-1/(\alpha-1)} .

It is solved for ξ by one integral, with the variable x in :math:`s = 1/(1 + e^x)`,

.. math:: \xi = \int_0^x \frac{q'(s)\, s\,(1 - s)}{s - p(s)}\,dx .

Next to both ends :math:`p(1) - p(s)` and p(s) lose their digits; slopes of p replace them. The
front is good for strong damping.  For weak damping it is never steeper than at about critical
damping, where the slowest tail of long waves has a double root, :math:`q'(1)^2 = p'(1)\,(p'(1) -
1)/3`.  That front is the start for weak damping.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.profile.equation import evaluate, evaluate_slopes
from granular_fronts.numerics.compiled import kernel

# Up to 36, beyond which s is 1 to the last digit and the integrand has no value.
X = np.linspace(-36.0, 36.0, 721)

CLOSE = 1.0e-5  # distance of s from an end below which a slope of p replaces a difference of p


class LongWaveFront(NamedTuple):
    """Increasing ξ with ξ = 0 at s = 1/2, and x with s = 1/(1 + e^x), shape (points,) each."""

    xi: np.ndarray
    x: np.ndarray

    def evaluate(self, xi):
        """Return the values of s at any ξ, 1-D."""
        return 1.0 / (1.0 + np.exp(np.interp(xi, self.xi, self.x)))


def long_wave_front(problem):
    """Return front of long waves; none, with ξ infinite or falling, where p crosses its chord."""
    return LongWaveFront(integrate(problem, X), X)


def at_least_critically_damped(problem):
    """Return the problem, or where its damping is weak the same with about critical damping."""
    stiffness, viscosity = problem.behind.p_slope, problem.behind.q_slope
    critical = math.sqrt(stiffness * (stiffness - 1.0) / 3.0) / viscosity
    return problem._replace(damping=max(problem.damping, critical))


@kernel(error_model="numpy")
def integrate(problem, x):
    """Return ξ at the points x, by the trapezoidal rule; 0 in the middle."""
    s, rest = 1.0 / (1.0 + np.exp(x)), 1.0 / (1.0 + np.exp(-x))
    p, q, slope, q_slope, mean_slope = [np.empty(x.size) for _ in range(5)]
    evaluate(problem, s, p, q)
    evaluate_slopes(problem, s, slope, q_slope)
    rate, halfway = np.empty(x.size), np.empty(x.size)
    for k in range(x.size):
        # To the end nearby.
        halfway[k] = 1.0 - 0.5 * rest[k] if s[k] > 0.5 else 0.5 * s[k]
    evaluate_slopes(problem, halfway, mean_slope, slope)
    for k in range(x.size):
        if rest[k] < CLOSE:
            pull = (mean_slope[k] - 1.0) * rest[k]
        elif s[k] < CLOSE and problem.elastic.ahead != 0.0:
            pull = (1.0 - mean_slope[k]) * s[k]
        elif s[k] > 0.5:
            pull = (problem.behind.p - p[k]) - rest[k]
        else:
            pull = s[k] - p[k]
        rate[k] = q_slope[k] * s[k] * rest[k] / pull
    xi = np.zeros(x.size)
    for k in range(1, x.size):
        xi[k] = xi[k - 1] + 0.5 * (rate[k - 1] + rate[k]) * (x[k] - x[k - 1])
    return xi - xi[x.size // 2]
