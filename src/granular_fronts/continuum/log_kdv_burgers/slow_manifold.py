r"""The stable manifold of the origin by an expansion, and the stiff orbit in closed form.

On the stable manifold of the origin the planar system (see `log_kdv_burgers`) is one equation for
:math:`v = -z/y`.  With :math:`r = 1/(2v + \mu)` write it as

.. math::

    v' = v\, r H(r), \qquad p = v\,(v + \mu - rH), \qquad
    e = \tfrac12 (H - 1) - \mu (v + \tfrac12 rH) .

Inserting this into :math:`v' = v^2 + \mu v - p`, :math:`p' = v` leaves

.. math::

    H = 1 + r^3 \bigl[ \mu H^2 - \tfrac12 (1 - \mu r)(H^2)' \bigr], \qquad
    h_{j+3} = \mu (1 + \tfrac{j}{2})\, a_j - \tfrac{j + 1}{2}\, a_{j+1}

for the coefficients of :math:`H = \sum h_j r^j`, with :math:`H^2 = \sum a_j r^j` and
:math:`h_0 = 1, h_1 = h_2 = 0`.  Without damping H = 1, which is the Gaussian.  The series diverges,
but it is asymptotic in :math:`r^2` uniformly in μ r ≤ 1, that is for all v ≥ 0.  With 48
coefficients its error is below round-off at the far end of the tail for every μ.  So it is on the
whole orbit for μ ≥ 12 (measured: 4e-16 in y at μ = 12, 1e-15 at 11, 2e-13 at 10).

There, near a node whose rates differ by a factor above 140, nothing needs to be integrated.  With
:math:`\lambda_\pm` the linear rates at (1, 0), :math:`1/H = \sum i_j r^j`,
:math:`Q_0 = \lambda_-/\mu` and :math:`Q_j = i_j + \mu Q_{j-1}`,

.. math::

    s = 2v + \lambda_+ \ln 2v + \lambda_- \ln(2v + \mu)
        - \sum_{j \ge 2} \frac{Q_j}{j - 1}\, r^{j-1} + \mathrm{const},

and v at a given s is found by Newton's method in ln v, where s is convex.  Powers of r are kept as
powers of :math:`r \max(\mu, 1)`, so that no coefficient overflows.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_kdv_burgers.equation import linear_rates
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.polynomials import polynomial

STIFF_DAMPING = 12.0
"""Smallest μ at which the whole orbit comes from the expansion."""

TERMS = 48
FEWER_TERMS = 40
BLOCK = 10_000
NEWTON_STEPS = 60

# The next step of Newton's method is about the square of this change of ln v.
CONVERGED_CHANGE = 1e-9

# Where y differs from 1 by less than any double.
SMALLEST_V = 1e-300


@kernel
def expand(mu, terms):
    """Return coefficients of H in powers of r max(μ, 1), constant term first, shape (terms,)."""
    scale = max(mu, 1.0)
    h, square = np.zeros(terms), np.zeros(terms)
    h[0] = square[0] = 1.0
    for k in range(1, terms):
        if k >= 3:
            j = k - 3
            h[k] = mu / scale * (1.0 + 0.5 * j) * square[j] / scale**2
            h[k] -= 0.5 * (j + 1) * square[j + 1] / scale**2
        for i in range(k + 1):
            square[k] += h[i] * h[k - i]
    return h


@kernel
def state_on_manifold(mu, h, v):
    """Return p and e of the point of the manifold with v ≥ 0, from the coefficients h of H.

    Each has relative accuracy; e also as μ → 0.
    """
    r = 1.0 / (2.0 * v + mu)
    x = r * max(mu, 1.0)
    excess = x * polynomial(h[1:], x)
    rate = r * (1.0 + excess)
    return v * (v + mu - rate), 0.5 * excess - mu * (v + 0.5 * rate)


class SlowOrbit(NamedTuple):
    """The orbit for μ ≥ `STIFF_DAMPING`, in closed form."""

    mu: float
    slow: float  # linear rates at (1, 0)
    fast: float
    h: np.ndarray  # coefficients of H in powers of μ r, shape (terms,)
    time: np.ndarray  # coefficients of the last sum in s, likewise
    v_half: float  # v at s = 0, where y = ½

    def evaluate(self, s):
        """Return both p and v at each s; see `_evaluate_slow`."""
        p, v = np.empty(s.size), np.empty(s.size)
        # In blocks, so that Ctrl-C is answered in between.
        for first in range(0, s.size, BLOCK):
            block = slice(first, first + BLOCK)
            _evaluate_slow(self, s[block], p[block], v[block])
        return p, v

    def s_at(self, p):
        """Return the s at which −ln y is p > 0."""
        v = _v_at(self.mu, self.h, p)
        return _s_between(self, self.v_half, v)

    def turning_points(self):
        """Return no extrema: the orbit is monotone."""
        return np.empty(0), np.empty(0)

    def counts(self):
        """Return the method and work, for the attributes of a dataset."""
        return {"method": "expansion of the slow manifold", "terms": self.h.size}


def slow_orbit(mu, terms=TERMS):
    """Return the orbit for strong damping, μ ≥ `STIFF_DAMPING`."""
    slow, fast = (rate.real for rate in linear_rates(mu))
    h = expand(mu, terms)
    return SlowOrbit(
        mu, slow, fast, h, _time_coefficients(mu, slow, h), _v_at(mu, h, math.log(2.0))
    )


@kernel
def _time_coefficients(mu, slow, h):
    """Return the coefficients of Σ Q_j r^(j−1)/(j − 1) in powers of μ r, for μ ≥ 1."""
    terms = h.size
    inverse, quotient, time = np.zeros(terms), np.zeros(terms), np.zeros(terms)
    inverse[0] = 1.0
    quotient[0] = slow / mu
    for k in range(1, terms):
        for i in range(1, k + 1):
            inverse[k] -= h[i] * inverse[k - i]
        quotient[k] = inverse[k] + quotient[k - 1]
        if k >= 2:
            time[k - 1] = mu * quotient[k] / (k - 1)
    return time


@kernel
def _v_at(mu, h, p):
    """Find the v ≥ 0 at which the manifold has the given p > 0, by Newton's method in v."""
    v = p / (0.5 * mu + math.sqrt(0.25 * mu * mu + p))
    for _ in range(NEWTON_STEPS):
        r = 1.0 / (2.0 * v + mu)
        value, _ = state_on_manifold(mu, h, v)
        # dp/dv = p'/v' = 1/(r H)
        step = (value - p) * r * polynomial(h, r * max(mu, 1.0))
        v -= step
        if abs(step) <= 1e-15 * v:
            break
    return v


@kernel
def _s_between(orbit, v_from, v_to):
    """Return the change of s from one v to another, by the closed form."""
    x_from, x_to = orbit.mu / (2.0 * v_from + orbit.mu), orbit.mu / (2.0 * v_to + orbit.mu)
    return (
        2.0 * (v_to - v_from)
        + orbit.fast * math.log(v_to / v_from)
        + orbit.slow * math.log(x_from / x_to)
        - (polynomial(orbit.time, x_to) - polynomial(orbit.time, x_from))
    )


@kernel
def _evaluate_slow(orbit, s, p, v):
    """Both p and v at each s, by Newton's method in ln v."""
    # They are filled in, since numba makes a SystemError of Ctrl-C where it hands out new arrays.
    mu, h, v_half = orbit.mu, orbit.h, orbit.v_half
    rate_half = polynomial(h, mu / (2.0 * v_half + mu)) / (2.0 * v_half + mu)
    for i in range(s.size):
        # From v too large the iteration is monotone: d(ln v)/ds lies between the rate at y = ½
        # and λ₋, and dv/ds below ½.
        if s[i] < 0.0:
            current = max(v_half * math.exp(s[i] * rate_half), SMALLEST_V)
        else:
            current = v_half * math.exp(min(orbit.slow * s[i], math.log1p(0.5 * s[i] / v_half)))
        for _ in range(NEWTON_STEPS):
            r = 1.0 / (2.0 * current + mu)
            distance = s[i] - _s_between(orbit, v_half, current)
            change = distance * r * polynomial(h, r * mu)
            current = max(current * math.exp(change), SMALLEST_V)
            if abs(change) < CONVERGED_CHANGE:
                break
        v[i] = current
        p[i], _ = state_on_manifold(mu, h, current)
