r"""The equations of a front in a window of contacts, their derivative and their solution.

In the frame δ = c = 1 a travelling front :math:`u_n(t) = U(n - t)` passes one contact per unit of
time.  Contacts n = 1 … M are in the state of a front if the flow Φ over that time returns it
shifted by one contact,

.. math:: \Phi(u, d)_n = (u, d)_{n-1}, \qquad n = 1 \dots M + 1 .

Ahead, contact M + 1 is untouched before and after.  Behind, contact 0 moves in the modes of the
tail (`window`), :math:`(u, d)_0 = (1, 0) + \sum_k a_k (u, d)^{(k)}`. The modes are tied to the
state of the first contacts, where :math:`(u, d)_n` equals the same sum, n = 1 … 4.  The phase
condition is u = 1/2 at the `centre`.

Unknowns are the amplitudes a, then u and d of every contact.  There are 2 (M + 1) + 8 + 1 equations
for 2 M unknowns and the few amplitudes.  They can all hold, since 1 is the speed that the jump
conditions allow between u = 1 and u = 0, James (2021), eq. (21); each must, and none is given up
for another.  In the order of the contacts the derivative is a band.

Gauss-Newton.  With r the residuals and J their derivative by the unknowns x, a step solves

.. math:: \min_{\delta x} \| J\,\delta x + r \|_2

by reflections (`banded_qr`), J being the exact derivative of the computed flow (`bead_flow`).  The
step is halved until the sum of squares falls.  There are more equations than unknowns, but all of
them hold at a front: r = 0 there, and convergence is quadratic.  A minimum where some equation does
not hold is no front, and is reported as a failure.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.shooting import bead_flow
from granular_fronts.fronts.shooting.bead_flow import PowerLaw, Stiffness
from granular_fronts.fronts.shooting.window import modes as modes_of_tail
from granular_fronts.numerics.banded_qr import band_storage, solve_least_squares
from granular_fronts.numerics.compiled import kernel

TIED_CONTACTS = 4
REST_BEHIND, REST_AHEAD = np.array([[1.0, 0.0]]), np.array([[0.0, 0.0]])

MOST_STEPS = 40
SHORTEST_FRACTION = 1.0 / 64.0  # of a step
# Convergence is quadratic: after a smaller step the next one would be lost in rounding.
SETTLED = 1.0e-8
# Above the toe, where u^(α − 1) exceeds the stiffness, u keeps at least a tenth in a step.
SMALLEST_TOE, LOWEST_STIFFNESS, LARGEST_FALL = 1.0e-12, 0.1, 0.1


class Window(NamedTuple):
    """Contacts, flow and closure of one solve."""

    law: PowerLaw
    contacts: int  # M
    centre: int  # contact, counted from 1, where u = 1/2
    steps: int  # of Runge-Kutta per bead-time
    spread: int  # contacts that influence crosses in a bead-time (`bead_flow`)
    roots: np.ndarray  # of the tail that close the window behind, complex


def count_modes(roots):
    """Return the real amplitudes of the tail: two of a complex root."""
    return len(roots) + np.count_nonzero(roots.imag)


def join(amplitudes, state):
    """Return the vector of unknowns."""
    return np.concatenate([amplitudes, state.ravel()])


def split(window, unknowns):
    """Return the amplitudes, shape (modes,), and state (u, d) of the contacts, shape (M, 2)."""
    modes = count_modes(window.roots)
    return unknowns[:modes], unknowns[modes:].reshape(-1, 2)


def driver_modes(window, times):
    """Return the motion u − 1 of contact 0 in every mode, shape (modes,) + shape of times."""
    return modes_of_tail(window.law, window.roots, -times)[:, 0]


def _tail_modes(window):
    """Return (u − 1, d) of contact 0 and of the tied contacts in every mode."""
    contacts = np.arange(TIED_CONTACTS + 1)
    return modes_of_tail(window.law, window.roots, contacts).transpose(0, 2, 1)


def flow(window, unknowns, duration=1.0, start=0.0):
    """Return the change of (u, d), shape (M, 2), in all steps of a duration, and the stiffnesses.

    At `start` contact 0 has left ξ = 0 of the modes for that time.
    """
    amplitudes, state = split(window, unknowns)
    times = start + bead_flow.stage_times(duration, window.steps)
    driver = 1.0 + np.tensordot(amplitudes, driver_modes(window, times), 1)
    at_start = np.zeros((2, window.contacts + 2))
    at_start[:, 1:-1] = state.T
    stiffness = bead_flow.make_stiffness(window.law, window.steps, window.contacts + 2)
    weights = bead_flow.make_weights(window.law, duration / window.steps)
    change = bead_flow.flow(window.law, weights, driver, *at_start, stiffness)
    return change[:, 1:-1].T, stiffness


def residual(window, unknowns):
    """Return what is left of every equation, in the order of the contacts, and the stiffnesses."""
    amplitudes, state = split(window, unknowns)
    change, stiffness = flow(window, unknowns)
    tail = REST_BEHIND + np.tensordot(amplitudes, _tail_modes(window), 1)
    tied = state[:TIED_CONTACTS] - tail[1:]
    # The difference of neighbours is small and exact, and so is the change: no digit is lost.
    to_neighbour = np.diff(np.vstack([tail[:1], state, REST_AHEAD]), axis=0)
    shifted = to_neighbour + np.vstack([change, REST_AHEAD])
    rows = np.concatenate([tied.ravel(), shifted.ravel()])
    return np.insert(rows, _phase_row(window), state[window.centre - 1, 0] - 0.5), stiffness


def jacobian(window, stiffness):
    """Return derivative of `residual` by the unknowns, in band storage, and its lower bandwidth."""
    weights = bead_flow.make_weights(window.law, 1.0 / window.steps)
    driver = driver_modes(window, bead_flow.stage_times(1.0, window.steps))
    band = bead_flow.derivative(window.law, weights, stiffness, window.spread)
    by_driver = bead_flow.derivative_by_driver(
        window.law, weights, np.ascontiguousarray(driver), stiffness
    )
    lower = 2 * (TIED_CONTACTS + window.spread) + 2
    upper = len(driver) + 2 * window.spread + 1
    rows = band_storage(2 * (TIED_CONTACTS + window.contacts + 1) + 1, lower, upper)
    place = _phase_row(window)
    tail = np.ascontiguousarray(_tail_modes(window))
    _assemble(rows, lower, place, window.centre, band, by_driver, tail)
    return rows, lower


def _phase_row(window):
    """Return the row of the phase condition, after the rows of its contact."""
    return 2 * (TIED_CONTACTS + window.centre)


@kernel
def _assemble(rows, lower, phase_row, centre, band, by_driver, tail):
    """Fill the band; column m − 2 + 2 n + i holds component i of contact n after m modes."""
    modes, spread, last = by_driver.shape[0], band.shape[1] // 2, band.shape[0] - 2
    tied = tail.shape[1] - 1
    rows[phase_row, modes - 2 + 2 * centre - phase_row + lower] = 1.0
    for row in range(2 * tied):
        n, i = row // 2 + 1, row % 2
        rows[row, modes + lower] = 1.0
        for mode in range(modes):
            rows[row, mode - row + lower] = -tail[mode, n, i]
    for equation in range(2 * (last + 1)):
        n, i = equation // 2 + 1, equation % 2
        row = 2 * tied + equation + (2 * tied + equation >= phase_row)
        shift = lower - row
        if n == 1:
            for mode in range(modes):
                rows[row, mode + shift] -= tail[mode, 0, i]
        else:
            rows[row, modes - 2 + 2 * (n - 1) + i + shift] -= 1.0
        if n <= last:
            for o in range(band.shape[1]):
                start = n + o - spread
                if 1 <= start <= last:
                    for j in range(2):
                        rows[row, modes - 2 + 2 * start + j + shift] += band[n, o, i, j]
        if n <= spread:
            for mode in range(modes):
                rows[row, mode + shift] += by_driver[mode, i, n]


class Descent(NamedTuple):
    """A run of Gauss-Newton steps, and where it ended."""

    unknowns: np.ndarray
    residuals: list  # the largest before every step and after the last
    step_sizes: list  # the largest change of an unknown in every step
    flows: int  # bead-times that the window was moved for
    reason: str  # what stopped it, empty if it settled


class Attempt(NamedTuple):
    """A damped step: the fraction taken, 0 if none helps, and where it leads."""

    fraction: float
    unknowns: np.ndarray
    rows: np.ndarray
    stiffness: Stiffness
    flows: int


def descend(window, unknowns, tolerance):
    """Take Gauss-Newton steps until residuals are within the tolerance and steps die out."""
    rows, stiffness = residual(window, unknowns)
    residuals, step_sizes, flows = [largest(rows)], [], 1
    reason = f"not settled after {MOST_STEPS} Gauss-Newton steps"
    while len(step_sizes) < MOST_STEPS:
        matrix, lower = jacobian(window, stiffness)
        step = solve_least_squares(matrix, lower, unknowns.size, -rows)
        attempt = _damped(window, unknowns, step, _norm(rows), tolerance)
        flows += attempt.flows
        if attempt.fraction == 0.0:
            reason = (
                f"no part of the Gauss-Newton step lowers the residual {residuals[-1]:.1e}: give a "
                "guess closer to the front, or a longer window"
            )
            break
        unknowns, rows, stiffness = attempt.unknowns, attempt.rows, attempt.stiffness
        residuals.append(largest(rows))
        step_sizes.append(attempt.fraction * largest(step))
        if residuals[-1] <= tolerance and step_sizes[-1] <= SETTLED:
            reason = ""
            break
    return Descent(unknowns, residuals, step_sizes, flows, reason)


def _damped(window, unknowns, step, norm, tolerance):
    """Return largest of the halved steps that lowers the norm of the residual, or satisfies all."""
    fraction, flows = 1.0, 0
    while fraction >= SHORTEST_FRACTION:
        trial = _move(window, unknowns, fraction * step)
        rows, stiffness = residual(window, trial)
        flows += 1
        if _norm(rows) < norm or largest(rows) <= tolerance:
            return Attempt(fraction, trial, rows, stiffness, flows)
        fraction *= 0.5
    return Attempt(0.0, unknowns, rows, stiffness, flows)


def _move(window, unknowns, step):
    """Add a step, but let no contact that is stiff fall more than tenfold."""
    # For α near 1 the toe of the front stays stiff down to u = 1e-12 and less. A step that took u
    # below zero would cut it off.
    moved = unknowns + step
    before, after = (split(window, each)[1][:, 0] for each in (unknowns, moved))
    toe = max(SMALLEST_TOE, LOWEST_STIFFNESS ** (1.0 / (window.law.alpha - 1.0)))
    stiff = before > toe
    after[stiff] = np.maximum(after[stiff], LARGEST_FALL * before[stiff])
    return moved


def largest(values):
    """Return the largest absolute value."""
    return float(np.abs(values).max())


def _norm(values):
    # A residual that overflows has no norm, and no step is taken towards it.
    with np.errstate(over="ignore"):
        return float(np.linalg.norm(values))
