r"""Taylor series of the planar system, and an integrator that follows the orbit from its tail.

In :math:`p = -\ln y` and :math:`v = p'` the system is quadratic (see `log_kdv_burgers`), and the
Taylor coefficients of a solution about any point follow from each other,

.. math::

    p_{k+1} = \frac{v_k}{k + 1}, \qquad
    v_{k+1} = \frac{1}{k + 1} \Bigl( \sum_{j \le k} v_j v_{k-j} + \mu v_k - p_k \Bigr)

near (1, 0), where p and v keep their relative accuracy; elsewhere, with :math:`w = e + \mu v`,

.. math::

    v_{k+1} = \frac{\tfrac12 \delta_{k0} + w_k}{k + 1}, \qquad
    e_{k+1} = \frac{2}{k + 1} \sum_{j \le k} v_j w_{k-j}, \qquad p_0 = v_0^2 - \tfrac12 - e_0,

where the energy e keeps its own, however weak the damping.  A step sums such a series; the stored
series are the solution, to round-off, at every s in between.

Steps lead from large s to small.  In this direction the stable manifold of the origin attracts,
with rate :math:`2v + \mu`, and so does (1, 0). So errors contract on every monotone part.  At the
end of a step the last two terms of the series fall to the tolerance.  The step times the rate of
attraction stays below a bound.  A series of order N is stable up to about N/e over that rate.
Starts of steps are exact: a step is rounded to the difference of two representable s.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.polynomials import polynomial
from granular_fronts.numerics.records import record_type

RUNNING, ARRIVED, AT_REST = range(3)

LONGEST_STEP = 2.0

# |p| and |v| below which y is 1 beyond all resolution, and the orbit is followed no further.
REST = 1e-20

# Part of the plane where p and v are the unknowns; e is near −1/2 there and loses nothing.
NEAR = 0.25


class Accuracy(NamedTuple):
    """How a trace chooses its steps."""

    order: int  # of the Taylor series
    tolerance: float  # size of the last terms relative to the solution
    # Largest product of a step and the rate at which the orbit attracts, for stability.
    contraction: float


POINT = record_type(*((name, float) for name in "svep"))
"""A point of an orbit; e counts unless p and v are both below `NEAR`."""


def make_point(s, v, e, p):
    """Return a point from four numbers."""
    return np.array((s, v, e, p), POINT)[()]


@subroutine
def _energy_series(mu, v, e, p):
    """Fill the series of v, e and p from v[0] and e[0]."""
    order = p.size - 1
    w = np.empty(order)
    p[0] = v[0] * v[0] - 0.5 - e[0]
    w[0] = e[0] + mu * v[0]
    for k in range(order):
        p[k + 1] = v[k] / (k + 1)
        v[k + 1] = (w[k] + (0.5 if k == 0 else 0.0)) / (k + 1)
        product = 0.0
        for j in range(k + 1):
            product += v[j] * w[k - j]
        e[k + 1] = 2.0 * product / (k + 1)
        if k + 1 < order:
            w[k + 1] = e[k + 1] + mu * v[k + 1]


@subroutine
def _position_series(mu, v, p):
    """Fill the series of v and p from v[0] and p[0]."""
    for k in range(p.size - 1):
        product = 0.0
        for j in range(k + 1):
            product += v[j] * v[k - j]
        p[k + 1] = v[k] / (k + 1)
        v[k + 1] = (product + mu * v[k] - p[k]) / (k + 1)


@kernel
def series_slope(series, x):
    """Return the derivative of a polynomial, constant coefficient first."""
    value = 0.0
    for k in range(series.size - 1, 0, -1):
        value = value * x + k * series[k]
    return value


@subroutine
def _step_of_series(series, scale, tolerance):
    """Return the length at which each of the last two terms is at most tolerance × scale."""
    length = LONGEST_STEP
    for k in range(series.size - 2, series.size):
        if series[k] != 0.0:
            length = min(length, (tolerance * scale / abs(series[k])) ** (1.0 / k))
    return length


@kernel
def follow(mu, accuracy, point, s_stop, p_stop, starts, jets, energies):
    """Follow a solution towards smaller s, until s ≤ s_stop, p ≤ p_stop, or there is no room left.

    Fill in the s at the start of each step, the series of p in powers of s − start, and the last
    series of e.  The series of p have the shape (steps, order + 1).  Moves `point`; returns the
    number of steps and a status.
    """
    v = np.empty(jets.shape[1])
    for step in range(starts.size):
        if point.s <= s_stop or point.p <= p_stop:
            return step, ARRIVED
        if abs(point.v) + abs(point.p) < REST:
            return step, AT_REST
        p = jets[step]
        starts[step] = point.s
        v[0] = point.v
        near = abs(point.v) < NEAR and abs(point.p) < NEAR
        if near:
            p[0] = point.p
            _position_series(mu, v, p)
            length = _step_of_series(v, abs(v[0]) + abs(p[0]), accuracy.tolerance)
        else:
            energies[0] = point.e
            _energy_series(mu, v, energies, p)
            energy_scale = abs(energies[0]) + mu * (1.0 + abs(v[0]))
            length = min(
                _step_of_series(v, 1.0 + abs(v[0]), accuracy.tolerance),
                _step_of_series(energies, energy_scale, accuracy.tolerance),
            )
        length = min(length, accuracy.contraction / max(abs(2.0 * v[0] + mu), 1.0))
        s_new = point.s - length
        h = s_new - point.s
        point.s = s_new
        point.v = polynomial(v, h)
        if near:
            point.p = polynomial(p, h)
            point.e = point.v * point.v - point.p - 0.5
        else:
            point.e = polynomial(energies, h)
            point.p = point.v * point.v - 0.5 - point.e
    return starts.size, RUNNING


@kernel
def evaluate_steps(starts, jets, end, s, p, v):
    """Fill p and v at each s from the series stored at decreasing starts; (1, 0) beyond the end."""
    for i in range(s.size):
        if s[i] < end:
            p[i] = v[i] = 0.0
            continue
        low, high = 0, starts.size
        while high - low > 1:
            middle = (low + high) // 2
            if s[i] <= starts[middle]:
                low = middle
            else:
                high = middle
        p[i] = polynomial(jets[low], s[i] - starts[low])
        v[i] = series_slope(jets[low], s[i] - starts[low])


@kernel
def locate(series, level, end):
    """Return x in [end, 0] where an increasing polynomial meets a level, by safeguarded Newton."""
    left, right = end, 0.0
    x = 0.5 * end
    for _ in range(200):
        value = polynomial(series, x) - level
        if value > 0.0:
            right = x
        else:
            left = x
        slope = series_slope(series, x)
        newton = x - value / slope if slope != 0.0 else left
        new = newton if left < newton < right else 0.5 * (left + right)
        if abs(new - x) <= 1e-16 * abs(end) or new in (left, right):
            return new
        x = new
    return x


@kernel
def locate_turns(starts, jets, end, s, p):
    """Fill s and p of the zeros of v, in the order of the steps; return how many there are."""
    count = 0
    derivative = np.empty(jets.shape[1] - 1)
    for step in range(starts.size):
        span = (starts[step + 1] if step + 1 < starts.size else end) - starts[step]
        first, last = jets[step, 1], series_slope(jets[step], span)
        if (first > 0.0) == (last > 0.0):
            continue
        sign = 1.0 if first > 0.0 else -1.0
        for k in range(derivative.size):
            derivative[k] = sign * (k + 1) * jets[step, k + 1]
        x = locate(derivative, 0.0, span)
        s[count] = starts[step] + x
        p[count] = polynomial(jets[step], x)
        count += 1
    return count
