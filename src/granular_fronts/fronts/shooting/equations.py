r"""The equations of a front in a window of contacts, and their derivative.

In the frame δ = c = 1 a travelling front :math:`u_n(t) = U(n - t)` passes one contact per unit of
time.  Contacts n = 1 … M are in the state of a front if the flow Φ over that time returns it
shifted by one contact,

.. math:: \Phi(u, d)_n = (u, d)_{n-1}, \qquad n = 1 \dots M + 1 .

Ahead, contact M + 1 is untouched before and after.  Behind, contact 0 moves in the modes of the
tail (`tail_closure`), :math:`(u, d)_0 = (1, 0) + \sum_k a_k (u, d)^{(k)}`, and the modes are tied
to the state of the first contacts, where :math:`(u, d)_n` equals the same sum, n = 1 … 4.  The
phase is fixed by the phase condition u = 1/2 at the `centre`.

Unknowns are the amplitudes a, then u and d of every contact.  There are 2 (M + 1) + 8 + 1 equations
for 2 M unknowns and the few amplitudes.  They can all hold, since 1 is the speed that the jump
conditions allow between u = 1 and u = 0, James (2021), eq. (21); each must, and none is given up
for another.  In the order of the contacts the derivative is a band.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.shooting import bead_flow, tail_closure
from granular_fronts.fronts.shooting.bead_flow import PowerLaw
from granular_fronts.numerics.banded_qr import band_storage
from granular_fronts.numerics.compiled import kernel

TIED_CONTACTS = 4
REST_BEHIND, REST_AHEAD = np.array([[1.0, 0.0]]), np.array([[0.0, 0.0]])


class Window(NamedTuple):
    """Contacts, flow and closure of one solve.

    Attributes
    ----------
    law : bead_flow.PowerLaw
    contacts : int
        Number M of contacts in the window.
    centre : int
        Contact, counted from 1, where u = 1/2.
    steps, spread : int
        Runge-Kutta steps per bead-time, and contacts that influence crosses in it (`bead_flow`).
    roots : ndarray of complex
        Roots of the tail that close the window behind.
    """

    law: PowerLaw
    contacts: int
    centre: int
    steps: int
    spread: int
    roots: np.ndarray


def count_modes(roots):
    """Real amplitudes of the tail: two of a complex root."""
    return len(roots) + np.count_nonzero(roots.imag)


def join(amplitudes, state):
    """The vector of unknowns."""
    return np.concatenate([amplitudes, state.ravel()])


def split(window, unknowns):
    """Amplitudes, shape (modes,), and state (u, d) of the contacts, shape (M, 2)."""
    modes = count_modes(window.roots)
    return unknowns[:modes], unknowns[modes:].reshape(-1, 2)


def driver_modes(window, times):
    """Motion u − 1 of contact 0 in every mode, shape (modes,) + shape of times."""
    return tail_closure.modes(window.law, window.roots, -times)[:, 0]


def tail_modes(window):
    """(u − 1, d) of contact 0 and of the tied contacts in every mode."""
    contacts = np.arange(TIED_CONTACTS + 1)
    return tail_closure.modes(window.law, window.roots, contacts).transpose(0, 2, 1)


def flow(window, unknowns, duration=1.0, start=0.0):
    """Move the window for a time.

    Parameters
    ----------
    window : Window
    unknowns : ndarray
    duration : float, optional
        Time of all its steps.
    start : float, optional
        Time since contact 0 was at ξ = 0 of the modes.

    Returns
    -------
    change : ndarray, shape (M, 2)
        Of u and d.
    stiffness : bead_flow.Stiffness
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
    """What is left of every equation, in the order of the contacts.

    Parameters
    ----------
    window : Window
    unknowns : ndarray, shape (modes + 2 M,)

    Returns
    -------
    rows : ndarray, shape (2 (M + 1) + 9,)
    stiffness : bead_flow.Stiffness
        What `jacobian` needs.
    """
    amplitudes, state = split(window, unknowns)
    change, stiffness = flow(window, unknowns)
    tail = REST_BEHIND + np.tensordot(amplitudes, tail_modes(window), 1)
    tied = state[:TIED_CONTACTS] - tail[1:]
    # The difference of neighbours is small and exact, and so is the change: no digit is lost.
    to_neighbour = np.diff(np.vstack([tail[:1], state, REST_AHEAD]), axis=0)
    shifted = to_neighbour + np.vstack([change, REST_AHEAD])
    rows = np.concatenate([tied.ravel(), shifted.ravel()])
    return np.insert(rows, phase_row(window), state[window.centre - 1, 0] - 0.5), stiffness


def jacobian(window, stiffness):
    """Derivative of `residual` by the unknowns.

    Returns
    -------
    rows : ndarray
        In band storage, see `banded_qr`.
    lower : int
        Its lower bandwidth.
    """
    weights = bead_flow.make_weights(window.law, 1.0 / window.steps)
    driver = driver_modes(window, bead_flow.stage_times(1.0, window.steps))
    band = bead_flow.derivative(window.law, weights, stiffness, window.spread)
    by_driver = bead_flow.derivative_by_driver(
        window.law, weights, np.ascontiguousarray(driver), stiffness
    )
    lower = 2 * (TIED_CONTACTS + window.spread) + 2
    upper = len(driver) + 2 * window.spread + 1
    rows = band_storage(2 * (TIED_CONTACTS + window.contacts + 1) + 1, lower, upper)
    place = phase_row(window)
    tail = np.ascontiguousarray(tail_modes(window))
    _assemble(rows, lower, place, window.centre, band, by_driver, tail)
    return rows, lower


def phase_row(window):
    """Row of the phase condition: after those of its contact."""
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
