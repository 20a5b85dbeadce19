r"""A chain with any potentials V and W, compiled from a user's functions; James (2021), eq. (5).

The strain :math:`r_n = x_{n+1} - x_n`, negative in compression, obeys

.. math::

    \dot r_n = d_n + (\Delta_d W'(r))_n, \qquad \dot d_n = (\Delta_d V'(r))_n,

the form of `strain` with γ = 1, of which the steps, their error estimates and the continuous
extension of the eighth-order pair are taken.  Contacts 1 … N move, :math:`r_0` and
:math:`r_{N+1}` are held, which is pressure :math:`-V'(r_0)` and :math:`-V'(r_{N+1})` on the ends.
Hence the momentum law :math:`\tfrac{d}{dt}\sum_n n\,d_n = V'(r_0) - (N+1) V'(r_N) + N V'(r_{N+1})`,
linear and kept to round-off as long as the wave is far from contact N.

Laws.  `compile_law` compiles two functions of one strain, V' and W', into one loop over all
contacts.  The engine calls it by its address, once per stage: neither is the engine compiled again
for another law, nor is a call made for each bead.  The law itself is compiled at each start of the
program, in a fraction of a second.  Contact events are not located, since the kinks of an unknown
law are unknown: laws that are not smooth are solved as accurately as the tolerance makes them,
which a run with another tolerance shows.

Active window.  Ahead of the wave :math:`r = r_{N+1}` and :math:`d = 0`; these contacts are at rest
and are not visited.  A step moves a disturbance by one contact per stage.  The window ends farther
ahead than that of the last contact that differs from rest by more than `NEGLIGIBLE`, so that every
larger disturbance is followed, wherever the wave starts.

The tolerance is absolute, the largest estimated error of a step in r and in d.
"""

import math
from typing import NamedTuple

import numba
import numpy as np
from numba import types, uint64

from granular_fronts.chain.integrator import (
    SHORTEST_STEP_IN_SPACINGS,
    contact_polynomial,
    factor_of,
)
from granular_fronts.chain.state import PAIR, Law, Size, State, make_state
from granular_fronts.chain.strain import (
    accept,
    end_of_window,
    error_norm,
    finish_range,
    laplacian,
    stage_value_pair,
)
from granular_fronts.errors import SolveError
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.polynomials import crossing

LOOP = types.void(types.float64[::1], types.float64[::1], types.int64)
"""Type of a compiled law: strains to be replaced by V', room for W', number of contacts."""

FAST = {"contract", "afn"}
"""Rules for the arithmetic of a law: a multiply and an add may fuse, and a power whose constant
exponent is a multiple of 1/2 becomes products and a square root, which vectorise and are ten times
faster.  It is good to about as many units of the last place as its exponent."""

WINDOW_MARGIN = rk.STAGES + 1
"""Contacts from the last disturbed one to the last whose slopes at the end of a step differ."""

UNIT = Law(PAIR, math.nan, math.nan, 1.0)
"""What the kernels of `strain` need to know of the law."""

FINISHED, COLLAPSED = 0, 1


class AnyChain(NamedTuple):
    """A chain on its way.

    Attributes
    ----------
    law : object
        Made by `compile_law`.
    size : Size
    state : State
        Its `u` is the strain r, its `d` is d, on the contacts 0 … N + 1.
    clock : ndarray, shape (2,)
        Time, and next step.
    reach : ndarray of int, shape (1,)
        Last contact of the active window.
    counts : ndarray of int, shape (2,)
        Steps accepted and rejected.
    """

    law: object
    size: Size
    state: State
    clock: np.ndarray
    reach: np.ndarray
    counts: np.ndarray

    @property
    def strain(self):
        """Strains r of the contacts 0 … N + 1, a copy."""
        return self.state.u[: self.size.contacts + 2].copy()

    @property
    def strain_rate(self):
        """Their rates of change; 0 at both ends."""
        contacts = self.size.contacts
        rates = np.zeros(contacts + 2)
        rates[1:-1] = self.state.d[1 : contacts + 1] + self.state.g[0, 1 : contacts + 1]
        return rates


def compile_law(elastic_slope, viscous_slope):
    """One loop over the contacts from two functions of one strain.

    Parameters
    ----------
    elastic_slope, viscous_slope : callable
        V' and W', from a float to a float, in the part of Python that numba compiles.

    Returns
    -------
    object
        For `make_chain`.
    """
    elastic = numba.njit(elastic_slope, fastmath=FAST)
    viscous = numba.njit(viscous_slope, fastmath=FAST)

    @numba.cfunc(LOOP, fastmath=FAST)
    def evaluate(strain, damping, contacts):
        for n in range(uint64(1), uint64(contacts + 1)):
            r = strain[n]
            damping[n] = viscous(r)
            strain[n] = elastic(r)

    return evaluate


def make_chain(law, strain, strain_rate, step):
    """A chain at t = 0.

    Parameters
    ----------
    law : object
        Made by `compile_law`.
    strain, strain_rate : ndarray, shape (N + 2,)
        r_n and its rate of change for n = 0 … N + 1; the first and the last strain are held.
    step : float
        First step to try.

    Returns
    -------
    AnyChain
    """
    contacts = strain.size - 2
    size, state = Size(contacts + 1, contacts), make_state(contacts + 1)
    state.u[: contacts + 2] = state.force[: contacts + 2] = strain
    # The loop runs over 1 … N; shifted by one it serves the two ends as well.
    ends, damping = np.array([0.0, strain[0], strain[-1]]), np.zeros(3)
    _evaluate(law, ends, damping, 2)
    for values, held in ((state.force, ends), (state.damping, damping)):
        values[0], values[contacts + 1] = held[1:]
    _evaluate(law, state.force, state.damping, contacts)
    _slopes(state, size, 0, contacts)
    state.d[1 : contacts + 1] = strain_rate[1:-1] - state.g[0, 1 : contacts + 1]
    reach = np.array([_reach_of(state, size, contacts)])
    return AnyChain(law, size, state, np.array([0.0, step]), reach, np.zeros(2, np.int64))


def run_chain(chain, end, tolerance, level=math.nan, arrivals=None):
    """Integrate up to a time.

    Parameters
    ----------
    chain : AnyChain
        Is changed.
    end : float
    tolerance : float
        Largest error per step in r and in d.
    level, arrivals : float and ndarray, shape (N + 2,), optional
        The time at which a strain first passes the level replaces its NaN.

    Raises
    ------
    SolveError
        If the steps become too short for the clock.
    """
    arrivals = np.full(chain.size.contacts + 2, math.nan) if arrivals is None else arrivals
    status = _advance(
        chain.law,
        chain.size,
        chain.state,
        chain.clock,
        chain.reach,
        chain.counts,
        end,
        tolerance,
        level,
        arrivals,
    )
    if status == COLLAPSED:
        raise SolveError(
            f"The steps collapse at t = {chain.clock[0]:.6g} with the tolerance {tolerance:g}: "
            "give a larger tolerance, or a law that is finite and smoother."
        )


@kernel
def _evaluate(law, strain, damping, contacts):
    law(strain, damping, contacts)


@kernel
def _reach_of(state, size, start):
    """Last contact the wave can touch within one step, looking down from `start`."""
    ahead = state.u[size.contacts + 1]
    return end_of_window(state.u, state.d, ahead, WINDOW_MARGIN, start, size.contacts)


@kernel
def _slopes(state, size, row, reach):
    laplacian(state.force, state.k, row, size, reach)
    laplacian(state.damping, state.g, row, size, reach)


@kernel(fastmath={"contract"}, forceinline=True)
def _stage(law, size, state, row, on_g, on_k, h, reach):
    """Slopes of stage `row`; the sums over earlier slopes are unrolled, so that they vectorise."""
    (columns_g, a), (columns_k, a_squared) = on_g, on_k
    u, d, k, g, force = state.u, state.d, state.k, state.g, state.force
    for n in range(uint64(1), uint64(reach + 1)):
        value = u[n] + rk.C[row] * h * d[n]
        for j in range(len(a)):
            value += h * a[j] * g[columns_g[j], n]
        for j in range(len(a_squared)):
            value += h * h * a_squared[j] * k[columns_k[j], n]
        force[n] = value
    law(force, state.damping, reach)
    _slopes(state, size, row, reach)


@kernel
def _stages(law, size, state, h, reach):
    a, a_squared = rk.A_ROWS, rk.A_SQUARED_ROWS
    _stage(law, size, state, 1, a[1], a_squared[1], h, reach)
    _stage(law, size, state, 2, a[2], a_squared[2], h, reach)
    _stage(law, size, state, 3, a[3], a_squared[3], h, reach)
    _stage(law, size, state, 4, a[4], a_squared[4], h, reach)
    _stage(law, size, state, 5, a[5], a_squared[5], h, reach)
    _stage(law, size, state, 6, a[6], a_squared[6], h, reach)
    _stage(law, size, state, 7, a[7], a_squared[7], h, reach)
    _stage(law, size, state, 8, a[8], a_squared[8], h, reach)
    _stage(law, size, state, 9, a[9], a_squared[9], h, reach)
    _stage(law, size, state, 10, a[10], a_squared[10], h, reach)
    _stage(law, size, state, 11, a[11], a_squared[11], h, reach)


@kernel
def _stages_for_output(law, size, state, h, reach):
    for row in range(rk.NEW_SLOPE + 1, rk.SLOPES):
        a, a_squared = rk.A[row, :row], rk.A_SQUARED[row, :row]
        for n in range(1, reach + 1):
            state.force[n] = stage_value_pair(state, a, a_squared, rk.C[row], h, h, n)
        law(state.force, state.damping, reach)
        _slopes(state, size, row, reach)


@kernel
def _level_is_passed(u, new_u, level, last):
    """Whether any of the contacts 1 … last passes the level: without a branch, in vector code."""
    passages = 0
    for n in range(uint64(1), uint64(last + 1)):
        passages += (u[n] < level) ^ (new_u[n] < level)
    return passages > 0


@kernel
def _write_arrivals(law, size, state, t, h, reach, level, arrivals):
    """Times of first passage through the level within the step."""
    if not _level_is_passed(state.u, state.new_u, level, reach):
        return
    have_polynomials = False
    coefficients = np.empty(rk.DEGREE + 1)
    for n in range(1, reach + 1):
        passes = (state.u[n] < level) != (state.new_u[n] < level)
        if not (passes and math.isnan(arrivals[n])):
            continue
        if not have_polynomials:
            _stages_for_output(law, size, state, h, reach)
            have_polynomials = True
        contact_polynomial(UNIT, state, h, n, coefficients)
        arrivals[n] = t + h * crossing(coefficients, level)


@kernel
def _advance(law, size, state, clock, window, counts, end, tolerance, level, arrivals):
    """Integrate up to `end`; FINISHED or COLLAPSED."""
    while clock[0] < end and not interrupted():
        t = clock[0]
        landing = t + clock[1] >= end
        t_new = end if landing else t + clock[1]
        h = t_new - t
        if h < SHORTEST_STEP_IN_SPACINGS * np.spacing(t) and not landing:
            return COLLAPSED
        reach = window[0]
        _stages(law, size, state, h, reach)
        largest = finish_range(UNIT, state, h, 1, reach)
        error = error_norm(largest, 0.0, tolerance)
        if not error <= 1.0:
            counts[1] += 1
            clock[1] = h * (0.1 if math.isnan(error) else min(1.0, factor_of(error)))
            continue
        for n in range(uint64(1), uint64(reach + 1)):
            state.force[n] = state.new_u[n]
        law(state.force, state.damping, reach)
        _slopes(state, size, rk.NEW_SLOPE, reach)
        _write_arrivals(law, size, state, t, h, reach, level, arrivals)
        accept(state, reach)
        window[0] = max(reach, _reach_of(state, size, reach))
        clock[0] = t_new
        counts[0] += 1
        growth = factor_of(error)
        if not landing or growth < 1.0:
            clock[1] = h * growth
    return FINISHED
