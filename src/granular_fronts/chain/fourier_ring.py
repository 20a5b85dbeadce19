r"""A smooth wave on a ring of many beads, by Fourier series in the bead number.

The dissipative chain in strain form with :math:`\beta = \alpha`, James (2021), eq. (36),

.. math::

    \dot u_n = d_n + \gamma\,\Delta_d\,u_n^\alpha, \qquad \dot d_n = \Delta_d\,u_n^\alpha,

holds for every n, whole or not, if it holds for functions :math:`u(n, t)` and :math:`d(n, t)` of a
real n with period N.  Each offset :math:`n_0 \in [0, 1)` is a chain by itself.  A start that is
smooth in n stays so while all contacts are compressed.  Then a few Fourier coefficients, far fewer
than there are beads, hold all chains at once.  They obey the same equations with

.. math:: \Delta_d \to -\omega_k^2, \qquad \omega_k = 2\sin(k/2), \qquad k = 2\pi j/N,

exactly, and :math:`u^\alpha` is taken at M equally spaced places.  On the values there
:math:`\Delta_d` is a circulant matrix.  Waves with an even number of turns have one sign at places
half a ring apart, the others have both.  Sums and differences of such places are therefore
multiplied apart, each by a matrix of half the size.  No long-wave expansion enters: this is the
chain itself and not another model of it.  The coefficients that are left out fall exponentially for
an analytic wave.  The sum of u over the ring is kept to round-off.

Cost.  The explicit steps of order 8 (DOP853) are as long as the shortest wave kept allows, about
:math:`5/k_{max}`, against about 1 for the beads.  A wave of :math:`2\ell/\varepsilon` beads over
the time :math:`2\tau/(\gamma\varepsilon^2c^2)` so costs :math:`1/(\varepsilon\gamma c) =
\alpha/(\alpha - 1)` times a constant, and bead by bead :math:`1/\varepsilon^2` times as much.

A contact that opens ends the run: the force is no longer smooth.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import uint64
from scipy.fft import irfft, rfft, rfftfreq
from scipy.linalg import circulant

from granular_fronts.accuracy import Estimate
from granular_fronts.errors import SolveError
from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.vector_functions import power

_CONTRACT = {"contract"}

# Weights of the new state and of both error estimates.
FINAL = np.stack([rk.B, rk.ERROR_5, rk.ERROR_3])

FIRST_STEP = 1e-3
SHORTEST_STEP = 1e-14  # In units of the time to be reached.
SMALLEST_ERROR = 1e-12  # In units of the tolerance.

OPEN = (
    "At t = {time:.6g} a contact of the ring opens, where its wave is not smooth: follow the beads "
    "themselves."
)


class GapError(SolveError):
    """A contact opens, where a Fourier series no longer converges."""


class Wave(NamedTuple):
    """A wave at some times and equally spaced sites, shape (times, sites), the first at n = 0."""

    relative_displacement: np.ndarray
    velocity: np.ndarray
    smallest: Estimate  # Relative displacement of all places and times.


class FourierRing(NamedTuple):
    """A ring of period N in the bead number, with δ = c = 1."""

    alpha: float
    gamma: float
    beads: int  # N.
    points: int  # M, a multiple of 8; waves up to M/2 turns are kept.

    @property
    def wave_numbers(self):
        """Wave numbers k of the coefficients 0 … M/2."""
        return 2.0 * np.pi * rfftfreq(self.points, self.beads / self.points)

    @property
    def second_difference(self):
        """Matrices of Δ_d on sums and on differences of places half a ring apart, each halved."""
        half = self.points // 2
        rows = circulant(irfft(-4.0 * np.sin(0.5 * self.wave_numbers) ** 2, self.points))[:half]
        near, far = 0.5 * rows[:, :half], 0.5 * rows[:, half:]
        return np.array([near + far, near - far])

    def strain_rates(self, u, velocity):
        """Return the values of d = w_n − w_{n+1} from u and ẋ, eq. (31)."""
        shift, force = np.exp(1j * self.wave_numbers), rfft(u**self.alpha)
        rates = (1.0 - shift) * (rfft(velocity) - self.gamma * (1.0 / shift - 1.0) * force)
        return irfft(rates, self.points)

    def velocities(self, u, d, mean):
        """Return the values of ẋ from u, d and the mean of ẋ."""
        shift, force = np.exp(1j * self.wave_numbers), rfft(u**self.alpha)
        velocity = self.gamma * (1.0 / shift - 1.0) * force
        velocity[1:] += rfft(d)[1:] / (1.0 - shift[1:])
        velocity[0] = mean * self.points
        return irfft(velocity, self.points)


def solve_fourier_ring(
    ring: FourierRing, u: np.ndarray, velocity: np.ndarray, times: np.ndarray, tolerance: float
) -> Wave:
    """Follow a smooth compressed wave on a ring; a contact that opens is a GapError.

    u and the velocity start at equally spaced sites, the first at n = 0.  With more sites than
    coefficients a smooth start loses nothing.  Times increase from 0 or later, in units of 1/c, and
    the tolerance is the relative error per step.
    """
    first, speed = (_resampled(row, ring.points) for row in (u, velocity))
    if not first.min() > 0.0:
        raise GapError(OPEN.format(time=0.0))
    start = np.concatenate([first, ring.strain_rates(first, speed)])
    states, turn = _integrate(ring, start, times, tolerance)
    velocities = [ring.velocities(*state, speed.mean()) for state in states]
    return Wave(
        np.array([_resampled(u_then, u.size) for u_then, _ in states]),
        np.array([_resampled(velocity_then, u.size) for velocity_then in velocities]),
        Estimate(*_smallest(*turn, u.size)),
    )


def _integrate(ring, start, times, tolerance):
    """Return u and d at the given times; the times and u of the lowest step and of both beside it.

    A time is NaN where there is no such step.
    """
    matrices, state, states = ring.second_difference, start.copy(), []
    moments, rows = np.array([math.nan, 0.0, math.nan]), np.full((3, ring.points), math.nan)
    rows[1] = start[: ring.points]
    t, h = 0.0, FIRST_STEP
    for stop in times:
        clock, turn = (t, h, stop), (moments, rows)
        t, h = _advance(matrices, ring.alpha, ring.gamma, state, clock, turn, tolerance)
        if not _lowest.py_func(rows[1]) > 0.0:
            raise GapError(OPEN.format(time=t))
        if t < stop:
            raise SolveError(f"At t = {t:.6g} of a ring the step size collapsed to {h:.3g}.")
        states.append(state.reshape(2, ring.points).copy())
    return states, (moments, rows)


def _smallest(moments, rows, sites):
    """Return the smallest u of all places and times, and an error from above.

    Between steps the parabola through the least values of three of them is taken.  The lowest step
    is found by its M places, which miss what lies between them.
    """
    before, least, after = (_lowest.py_func(_resampled(row, sites)) for row in rows)
    missed, depth = abs(least - _lowest.py_func(rows[1])), 0.0
    if np.isfinite(moments).all():
        backward, forward = np.diff(moments)
        fall, rise = (least - before) / backward, (after - least) / forward
        curvature = (rise - fall) / (backward + forward)
        if curvature > 0.0:
            depth = (fall + curvature * backward) ** 2 / (4.0 * curvature)
    return least - depth, missed + depth


@kernel
def _advance(matrices, alpha, gamma, state, clock, turn, tolerance):
    """Step u and d in place up to a stop, to a gap, or to where the steps become too short.

    The clock holds time, step and stop; the turn is what `_integrate` says of the lowest step.  The
    result is the time and the next step.
    """
    (t, h, stop), (moments, rows), points = clock, turn, state.size // 2
    slopes, stage = np.empty((rk.STAGES, state.size)), np.empty(state.size)
    ends, parts = np.empty((3, state.size)), np.empty((2, state.size // 4))
    smallest = _lowest(rows[1])
    while t < stop and smallest > 0.0 and not interrupted():
        landing = t + h >= stop
        # Two equal steps to the stop rather than a long and a short one.
        step = stop - t if landing else min(h, 0.5 * (stop - t))
        if step < SHORTEST_STEP * stop and not landing:
            break
        for row in range(rk.STAGES):
            _combine(state, 1.0, step, rk.A[row], slopes, stage)
            _rates(matrices, alpha, gamma, stage, parts, slopes[row])
        for k in range(3):
            _combine(state, 1.0 if k == 0 else 0.0, step, FINAL[k], slopes, ends[k])
        error = _norm(state, ends, tolerance)
        factor = rk.SMALLEST_FACTOR  # Also where the error is not a number.
        if error < math.inf:
            growth = rk.SAFETY * max(error, SMALLEST_ERROR) ** rk.ERROR_EXPONENT
            factor = min(rk.LARGEST_FACTOR, max(rk.SMALLEST_FACTOR, growth))
        accepted = error <= 1.0
        if accepted:
            lowest, before, t = _lowest(ends[0, :points]), t, stop if landing else t + step
            if lowest < smallest:
                smallest = lowest
                moments[:] = before, t, math.nan
                rows[0], rows[1] = state[:points], ends[0, :points]
            elif math.isnan(moments[2]):
                moments[2], rows[2] = t, ends[0, :points]
            for n in range(uint64(state.size)):
                state[n] = ends[0, n]
        if not (accepted and landing):
            h = step * factor
    return t, h


@subroutine
def _lowest(row):
    """Return the least value of the parabola through the three lowest places of a closed row."""
    n = row.argmin()
    left, middle, right = row[n - 1], row[n], row[(n + 1) % row.size]
    curvature = left - 2.0 * middle + right
    return middle - (left - right) ** 2 / (8.0 * curvature) if curvature > 0.0 else middle


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _rates(matrices, alpha, gamma, state, parts, result):
    """Time derivatives of u and d; `parts` is work space for half a ring."""
    half = uint64(parts.shape[1])
    u, d = state[: 2 * half], state[2 * half :]
    change, force = result[: 2 * half], result[2 * half :]
    for n in range(uint64(d.size)):
        whole = power(u[n], alpha)
        force[n] = whole if u[n] > NEGLIGIBLE else 0.0
    for n in range(half):
        near, far = force[n], force[n + half]
        parts[0, n], parts[1, n] = near + far, near - far
    _multiply(matrices, parts, force)
    for n in range(half):
        even, odd = force[n], force[n + half]
        force[n], force[n + half] = even + odd, even - odd
    _subtract_mean(force)
    for n in range(uint64(d.size)):
        change[n] = d[n] + gamma * force[n]
    _subtract_mean(change)


@subroutine(fastmath={"reassoc"}, forceinline=True)
def _subtract_mean(row):
    """Subtract the mean of a row, which is zero, but whose rounding would add up in a long time."""
    total = 0.0
    for n in range(uint64(row.size)):
        total += row[n]
    mean = total / row.size
    for n in range(uint64(row.size)):
        row[n] -= mean


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _multiply(matrices, parts, products):
    """Write both symmetric matrices times their halves of a row, four rows of each at a time."""
    half = uint64(parts.shape[1])
    for part in range(uint64(2)):
        rows, values, first = matrices[part], parts[part], part * half
        for n in range(half):
            products[first + n] = 0.0
        for block in range(half // uint64(4)):
            j = uint64(4) * block
            a, b, c, e = values[j], values[j + 1], values[j + 2], values[j + 3]
            for n in range(half):
                products[first + n] += (a * rows[j, n] + b * rows[j + 1, n]) + (
                    c * rows[j + 2, n] + e * rows[j + 3, n]
                )


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _combine(start, share, step, weights, slopes, result):
    """Write a share of a row plus a step along a weighted sum of slopes."""
    for n in range(uint64(result.size)):
        result[n] = share * start[n]
    for row in range(rk.STAGES):
        weight = step * weights[row]
        if weight != 0.0:
            for n in range(uint64(result.size)):
                result[n] += weight * slopes[row, n]


@subroutine(fastmath={"contract", "reassoc"}, forceinline=True)
def _norm(old, ends, tolerance):
    """Error of a step in units of the tolerance, from both estimates as DOP853 weighs them."""
    new, fifth, third = ends[0], ends[1], ends[2]
    total, lower = 0.0, 0.0
    for n in range(uint64(old.size)):
        scale = tolerance * (0.01 + max(abs(old[n]), abs(new[n])))
        total += (fifth[n] / scale) ** 2
        lower += (third[n] / scale) ** 2
    if total == 0.0:
        return 0.0
    return total / math.sqrt((total + 0.01 * lower) * old.size)


def _resampled(values, points):
    """Return the same wave at another number of places, the waves that both resolve."""
    kept = (min(values.size, points) + 1) // 2
    coefficients = np.zeros(points // 2 + 1, dtype=complex)
    coefficients[:kept] = rfft(values)[:kept]
    return irfft(coefficients, points) * (points / values.size)
