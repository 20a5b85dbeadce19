r"""The chain in its textbook variables, for comparison with the strain form.

The same eighth-order pair, stepping (x, w), James (2021), eqs. (31)-(32), or (x, ẋ), eq. (28),
without window, event location or special kernels.  They show what the choice of variables buys: a
force of :math:`x_{n-1} - x_n` cancels digits, and in (x, ẋ) the right-hand side

.. math:: \ddot x_n = T_{n-1} - T_n, \qquad
    T_n = u_{n,+}^\alpha + \beta\gamma\, u_{n,+}^{\beta-1}\,\dot u_n

is only :math:`C^{\beta-1}` where a contact opens or closes, so that the observed order drops by
one.  On a ring :math:`x_{n+N} = x_n - \sum_k u_k` (eq. 26).
"""

import math

import numpy as np

from granular_fronts.chain import equations
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel

XW, XV = 0, 1

_A = np.ascontiguousarray(rk.A[: rk.STAGES, : rk.STAGES])
_B, _E5, _E3 = (weights[: rk.STAGES].copy() for weights in (rk.B, rk.ERROR_5, rk.ERROR_3))


@kernel
def derivative(form, law, ends, y, result):
    """Time derivative of y = (x, w) or (x, ẋ).

    Parameters
    ----------
    form : int
        XW or XV.
    law : state.Law
    ends : tuple (is_ring, left, right)
        Relative displacements u_0 and u_N held at the ends; on a ring `right` is −L, the sum of
        all relative displacements over one turn, and `left` is unused.
    y, result : ndarray, shape (2 N,)
    """
    is_ring, left, right = ends
    beads = y.size // 2
    x, rate = y[:beads], y[beads:]
    closing = right - (x[0] - x[beads - 1])
    u = closing if is_ring else left
    u_rate = (rate[beads - 1] - rate[0]) if is_ring else 0.0
    force, damping = contact(form, law, u, u_rate)
    for n in range(beads):
        if n < beads - 1:
            u, u_rate = x[n] - x[n + 1], rate[n] - rate[n + 1]
        else:
            u = closing if is_ring else right
            u_rate = (rate[beads - 1] - rate[0]) if is_ring else 0.0
        next_force, next_damping = contact(form, law, u, u_rate)
        if form == XW:
            result[n] = rate[n] + damping - next_damping
            result[beads + n] = force - next_force
        else:
            result[n] = rate[n]
            result[beads + n] = force + damping - next_force - next_damping
        force, damping = next_force, next_damping


@kernel
def contact(form, law, u, u_rate):
    """Elastic force, and γ u₊^β (XW) or its time derivative (XV)."""
    if u <= 0.0:
        return 0.0, 0.0
    force = u * math.sqrt(u) if law.alpha == 1.5 else u**law.alpha
    if law.gamma == 0.0:
        return force, 0.0
    damping = force if law.beta == law.alpha else u**law.beta
    if form == XW:
        return force, law.gamma * damping
    return force, law.gamma * law.beta * damping / u * u_rate


@kernel
def step(form, law, ends, y, slopes, h, relative, absolute):
    """One step of the pair; returns the new state and the error in units of the tolerance."""
    stage = np.empty_like(y)
    derivative(form, law, ends, y, slopes[0])
    for row in range(1, rk.STAGES):
        stage[:] = y
        for j in range(row):
            if _A[row, j] != 0.0:
                stage += h * _A[row, j] * slopes[j]
        derivative(form, law, ends, stage, slopes[row])
    increment, fifth, third = np.zeros_like(y), np.zeros_like(y), np.zeros_like(y)
    for j in range(rk.STAGES):
        increment += h * _B[j] * slopes[j]
        fifth += h * _E5[j] * slopes[j]
        third += h * _E3[j] * slopes[j]
    beads = y.size // 2
    fifth_norm = third_norm = 0.0
    for part in (slice(0, beads), slice(beads, 2 * beads)):
        scale = absolute + relative * np.abs(y[part]).max()
        fifth_norm = max(fifth_norm, np.abs(fifth[part]).max() / scale)
        third_norm = max(third_norm, np.abs(third[part]).max() / scale)
    if fifth_norm == 0.0:
        return y + increment, 0.0
    error = fifth_norm**2 / math.sqrt(fifth_norm**2 + 0.01 * third_norm**2)
    return y + increment, error


@kernel
def integrate_fixed(form, law, ends, y, h, steps):
    """`steps` steps of constant size h."""
    slopes = np.empty((rk.STAGES, y.size))
    for _ in range(steps):
        y, _error = step(form, law, ends, y, slopes, h, 1.0, 1.0)
    return y


@kernel
def integrate_by_stages(form, law, ends, y, h, steps, nodes, weights):
    """`steps` steps of constant size h of a method whose stages each use the one before alone.

    Euler's method has the nodes [0] and weights [1], the classical one of order 4 the nodes
    [0, 1/2, 1/2, 1] and weights [1, 2, 2, 1]/6.
    """
    slope = np.zeros_like(y)
    for _ in range(steps):
        increment = np.zeros_like(y)
        for stage in range(nodes.size):
            derivative(form, law, ends, y + h * nodes[stage] * slope, slope)
            increment += weights[stage] * slope
        y = y + h * increment
    return y


@kernel
def integrate_adaptive(form, law, ends, y, h, end_time, relative, absolute):
    """From 0 to `end_time` with error control; returns the state and the accepted steps.

    The state is NaN if the step size collapses.
    """
    slopes = np.empty((rk.STAGES, y.size))
    t, accepted = 0.0, 0
    while t < end_time:
        t_new = min(t + h, end_time)
        if t_new <= t:
            return np.full_like(y, np.nan), accepted
        trial, error = step(form, law, ends, y, slopes, t_new - t, relative, absolute)
        factor = rk.LARGEST_FACTOR
        if error > 0.0:
            factor = max(rk.SMALLEST_FACTOR, rk.SAFETY * error**rk.ERROR_EXPONENT)
        if error <= 1.0:
            t, y, accepted = t_new, trial, accepted + 1
        h *= min(rk.LARGEST_FACTOR, factor)
    return y, accepted


def pack(form, law, boundary, u, velocity):
    """State vector y of a form, and its `ends`, from relative displacements and velocities.

    Parameters
    ----------
    u, velocity : ndarray, shape (N,)
        With pressure at the ends u_N is the held value.
    """
    x = np.zeros(u.size)
    x[:-1] = np.flip(np.cumsum(np.flip(u[:-1])))
    ends = (boundary.ring, boundary.left, float(u.sum()) if boundary.ring else boundary.right)
    rate = velocity.copy()
    if form == XW:
        rate -= equations.velocity_correction(u, boundary, law.beta, law.gamma)
    return np.concatenate([x, rate]), ends


def unpack(form, law, boundary, ends, y):
    """Relative displacements and velocities, both of shape (N,), from a state vector."""
    x, rate = np.split(y, 2)
    u = np.empty(x.size)
    u[:-1] = x[:-1] - x[1:]
    u[-1] = ends[2] - (x[0] - x[-1]) if boundary.ring else boundary.right
    if form == XV:
        return u, rate
    return u, rate + equations.velocity_correction(u, boundary, law.beta, law.gamma)
