r"""The flow of a window of beads over a time, and the exact derivative of what is computed.

Equations.  A window holds the contacts n = 1 … M of a chain in strain form,

.. math::

    \dot u_n = d_n + \gamma\,(\Delta_d u_+^\beta)_n, \qquad
    \dot d_n = (\Delta_d u_+^\alpha)_n ,

with a driven contact :math:`u_0(t)` behind, which is prescribed, and :math:`u_{M+1} = 0` ahead.

Discretisation.  S equal steps h of the eighth-order method of `numerics.runge_kutta`,
in its strain form

.. math::

    U_i = u + c_i h\, d + \sum_j \bigl( h\gamma\, a_{ij}\, g_j + h^2 (A^2)_{ij}\, k_j \bigr),
    \qquad k_j = \Delta_d (U_j)_+^\alpha,\; g_j = \Delta_d (U_j)_+^\beta .

The step is fixed, so that the computed map is a smooth function of its start where u > 0.  Its
derivative is the derivative of a formula and errs by rounding only, whatever S.

Rounding.  An error of a force pushes two neighbours apart and changes neither Σ d nor Σ n d, which
a front of α near 1 forgives.  It magnifies an error of these sums by 1/(α − 1) times the length of
the window.  Neighbouring forces are almost equal, so that their difference is exact.  So the
Laplacian is the difference of two such differences, and small changes are summed before they are
added.

Tangent.  A perturbation (δu, δd) obeys the same formulae with

.. math:: \delta k_j = \Delta_d \bigl( \alpha (U_j)_+^{\alpha-1}\, \delta U_j \bigr)

and the like for g.  `flow` notes the stiffnesses :math:`\alpha U^{\alpha-1}` and
:math:`\beta U^{\beta-1}` of every stage, and `_push` moves a perturbation through them.

Band.  Contact j moves contact n after a time t by at most about
:math:`(\sqrt{\alpha}\,t)^{2|n-j|}/(2|n-j|)! + (\alpha\gamma t)^{|n-j|}/|n-j|!`: faster than any
exponential.  Perturbations of every (2w + 1)-th contact, w the `spread` beyond which nothing
arrives, are pushed together, and the whole derivative costs 2(2w + 1) pushes for any M.

Arrays run over n = 0 … M + 1, so that an index is the number of the contact in the window.
"""

from typing import NamedTuple

import numpy as np
from numba import int64

from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted

STAGES = rk.STAGES
_CONTRACT = {"contract"}
WHOLE_STEP = rk.NEW_SLOPE
FORGOTTEN = 1.0e-15
WIDEST_SPREAD = 150


class PowerLaw(NamedTuple):
    """Contact law (28) in the frame δ = c = 1: exponents of both forces, and the damping."""

    alpha: float
    beta: float
    gamma: float


class Weights(NamedTuple):
    """Weights of the slopes for a step h, shape (13, 12); row 12 is the end of the step."""

    h: float
    on_k: np.ndarray  # what k adds to U; all for one nonlinearity
    on_g: np.ndarray  # what g adds


class Stiffness(NamedTuple):
    """Derivatives of the forces at every stage, each of shape (steps, 12, M + 2)."""

    elastic: np.ndarray
    damping: np.ndarray


class Stages(NamedTuple):
    """What a step computes with: slopes of all stages, one stage value, and its forces."""

    k: np.ndarray  # Laplacians of the elastic force, shape (12, M + 2)
    g: np.ndarray  # of the viscous force; the same array where β = α
    value: np.ndarray  # shape (M + 2,)
    force: np.ndarray


@subroutine
def _make_stages(law, columns):
    """Return the slopes and forces of nothing, for M + 2 columns."""
    k = np.zeros((rk.STAGES, columns))
    g = np.zeros((rk.STAGES, columns)) if law.alpha != law.beta else k
    return Stages(k, g, np.zeros(columns), np.zeros(columns))


def make_weights(law, h):
    """Return the weights of a step h for a law."""
    rows = slice(0, rk.STAGES + 1)
    a, a_squared = rk.A[rows, : rk.STAGES], rk.A_SQUARED[rows, : rk.STAGES]
    on_k, on_g = h * h * a_squared, h * law.gamma * a
    if law.alpha == law.beta:
        return Weights(h, on_k + on_g, 0.0 * on_g)
    return Weights(h, on_k, on_g)


def stage_times(duration, steps):
    """Return the times of all stages, shape (steps, 12)."""
    return (np.arange(steps)[:, np.newaxis] + rk.C[: rk.STAGES]) * (duration / steps)


def make_stiffness(law, steps, columns):
    """Return the room for the stiffnesses of a flow; one array serves both where β = α."""
    elastic = np.zeros((steps, rk.STAGES, columns))
    return Stiffness(elastic, elastic.copy() if law.alpha != law.beta else elastic)


@subroutine(fastmath=_CONTRACT)
def _gather(d, weights, row, c, stages):
    """Write U − u of a stage, or of the end of the step, into the stage value."""
    value, last = stages.value, d.size - 1
    for n in range(1, last):
        value[n] = c * weights.h * d[n]
    for j in range(min(row, rk.STAGES)):
        on_k, on_g = weights.on_k[row, j], weights.on_g[row, j]
        if on_k != 0.0:
            for n in range(1, last):
                value[n] += on_k * stages.k[j, n]
        if on_g != 0.0:
            for n in range(1, last):
                value[n] += on_g * stages.g[j, n]


@subroutine(fastmath=_CONTRACT)
def _laplacian(force, slope):
    """Write f_{n-1} − 2 f_n + f_{n+1} of the contacts 1 … M into `slope`, as differences."""
    for n in range(1, force.size - 1):
        slope[n] = (force[n + 1] - force[n]) - (force[n] - force[n - 1])


@subroutine(fastmath=_CONTRACT)
def _add_slopes(weights, k, change, d):
    """Add the change of d over a step, for which `change` is room."""
    last = d.size - 1
    for n in range(1, last):
        change[n] = 0.0
    for j in range(rk.STAGES):
        b = weights.h * rk.B[j]
        if b != 0.0:
            for n in range(1, last):
                change[n] += b * k[j, n]
    _add(change, d)


@subroutine(fastmath=_CONTRACT)
def _add(change, to):
    """Add to the contacts 1 … M."""
    for n in range(1, to.size - 1):
        to[n] += change[n]


@subroutine(fastmath=_CONTRACT)
def _forces(exponent, u, force, stiffness):
    """Contact forces u₊^exponent and their derivatives."""
    for n in range(u.size - 1):
        compression = u[n] if u[n] > NEGLIGIBLE else 0.0
        if exponent == 1.5:
            root = np.sqrt(compression)
            force[n] = compression * root
            stiffness[n] = 1.5 * root
        else:
            force[n] = compression**exponent
            stiffness[n] = exponent * force[n] / compression if compression > 0.0 else 0.0


@kernel(fastmath=_CONTRACT)
def flow(law, weights, driver, u, d, stiffness):
    """Return the changes of u and d of a window in the time of all steps, shape (2, M + 2).

    The driver holds u_0 at the times of all stages, shape (steps, 12); the stiffnesses are written.
    The change is summed apart from the state, so that it is not rounded to the last digit of 1 in
    every step.
    """
    change, d_now = np.zeros((2, u.size)), d.copy()
    stages = _make_stages(law, u.size)
    value, force = stages.value, stages.force
    for step in range(driver.shape[0]):
        for row in range(rk.STAGES):
            _gather(d_now, weights, row, rk.C[row], stages)
            value[0] = driver[step, row]
            _add(change[0], value)
            _add(u, value)
            _forces(law.alpha, value, force, stiffness.elastic[step, row])
            _laplacian(force, stages.k[row])
            if law.alpha != law.beta:
                _forces(law.beta, value, force, stiffness.damping[step, row])
                _laplacian(force, stages.g[row])
        _gather(d_now, weights, int64(WHOLE_STEP), 1.0, stages)
        _add(value, change[0])
        _add_slopes(weights, stages.k, value, change[1])
        for n in range(d.size):
            d_now[n] = d[n] + change[1, n]
    return change


@subroutine(fastmath=_CONTRACT)
def _push(law, weights, driver, stiffness, u, d, stages):
    """Move a perturbation (u, d) of the window, and `driver` of its driven contact, in place."""
    value, force = stages.value, stages.force
    for step in range(driver.shape[0]):
        for row in range(rk.STAGES):
            _gather(d, weights, row, rk.C[row], stages)
            _add(u, value)
            value[0] = driver[step, row]
            for n in range(u.size - 1):
                force[n] = stiffness.elastic[step, row, n] * value[n]
            _laplacian(force, stages.k[row])
            if law.alpha != law.beta:
                for n in range(u.size - 1):
                    force[n] = stiffness.damping[step, row, n] * value[n]
                _laplacian(force, stages.g[row])
        _gather(d, weights, int64(WHOLE_STEP), 1.0, stages)
        _add(value, u)
        _add_slopes(weights, stages.k, value, d)


@kernel
def derivative(law, weights, stiffness, spread):
    """Return derivative of the flow by its start, as a band of shape (M + 2, 2 spread + 1, 2, 2).

    Entry [n, o, i, j] derives (u, d)[i] of contact n by (u, d)[j] of contact n + o − spread.
    """
    steps, _, columns = stiffness.elastic.shape
    stride, last = 2 * spread + 1, columns - 2
    band, stages = np.zeros((columns, stride, 2, 2)), _make_stages(law, columns)
    driver, moved = np.zeros((steps, rk.STAGES)), np.zeros((2, columns))
    for colour in range(min(stride, last)):
        for j in range(2):
            moved[:] = 0.0
            moved[j, 1 + colour : last + 1 : stride] = 1.0
            _push(law, weights, driver, stiffness, moved[0], moved[1], stages)
            for start in range(1 + colour, last + 1, stride):
                for n in range(max(1, start - spread), min(last, start + spread) + 1):
                    band[n, start - n + spread, 0, j] = moved[0, n]
                    band[n, start - n + spread, 1, j] = moved[1, n]
        if interrupted():
            break
    return band


@kernel
def derivative_by_driver(law, weights, driver, stiffness):
    """Return the derivative of (u, d) by changes of the driver, shape (changes, 2, M + 2)."""
    columns = stiffness.elastic.shape[2]
    stages, moved = _make_stages(law, columns), np.zeros((driver.shape[0], 2, columns))
    for i in range(driver.shape[0]):
        _push(law, weights, driver[i], stiffness, moved[i, 0], moved[i, 1], stages)
    return moved


def spread_of(law, steps, compression):
    """Return how many contacts a perturbation crosses in a bead-time of a chain compressed by u.

    Contacts further away receive less than `FORGOTTEN` of it; u is at least the largest of the
    window.
    """
    columns = 2 * WIDEST_SPREAD + 3
    stiffness = make_stiffness(law, steps, columns)
    stiffness.damping[:] = law.beta * compression ** (law.beta - 1.0)
    stiffness.elastic[:] = law.alpha * compression ** (law.alpha - 1.0)
    weights = make_weights(law, 1.0 / steps)
    column = _contact_column(law, weights, stiffness, WIDEST_SPREAD + 1)
    return max(2, WIDEST_SPREAD + 1 - int(np.argmax(np.any(column > FORGOTTEN, axis=0))))


@kernel
def _contact_column(law, weights, stiffness, contact):
    """Return the change of all contacts by one, moved in u, then in d: (4, M + 2), absolute."""
    steps, _, columns = stiffness.elastic.shape
    stages = _make_stages(law, columns)
    driver, moved = np.zeros((steps, rk.STAGES)), np.zeros((4, columns))
    for j in range(2):
        moved[3 * j, contact] = 1.0
        _push(law, weights, driver, stiffness, moved[2 * j], moved[2 * j + 1], stages)
    return np.abs(moved)
