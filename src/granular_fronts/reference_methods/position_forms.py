r"""The chain in its textbook variables, for comparison with the strain form.

The same method of order eight, stepping (x, w), James (2021), eqs. (31)-(32), or (x, ẋ), eq. (28),
without window, event location or fused loops.  They show what the choice of variables buys: a
force of :math:`x_{n-1} - x_n` cancels digits, and in (x, ẋ) the right-hand side

.. math:: \ddot x_n = T_{n-1} - T_n, \qquad T_n = F(u_n) + G'(u_n)\,\dot u_n

is only as smooth as G', :math:`C^{\beta-1}` for the law (28), where a contact opens or closes, so
that the observed order drops by one.  On a ring :math:`x_{n+N} = x_n - \sum_k u_k` (eq. 26).
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.chain import equations
from granular_fronts.chain.equations import Boundary
from granular_fronts.model.laws import Law
from granular_fronts.model.passes import call_row_map, row_map, row_parameters
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel

XW, XV = 0, 1

_A = np.ascontiguousarray(rk.A[: rk.STAGES, : rk.STAGES])
_B = rk.B[: rk.STAGES].copy()


class Contacts(NamedTuple):
    """What the kernels know of a system."""

    form: int  # XW or XV.
    ring: bool
    # Relative displacements u_0 and u_N held at the ends.  On a ring `right` is −L, the sum of all
    # relative displacements over one turn, and `left` is unused.
    left: float
    right: float
    # Addresses of the row maps F, and G (XW) or G' (XV), and what they take.
    elastic: int
    viscous: int
    elastic_parameters: np.ndarray
    viscous_parameters: np.ndarray
    # Work space: contacts 0 … N, their rates, F, and G or G'.
    u: np.ndarray
    rate: np.ndarray
    force: np.ndarray
    damping: np.ndarray


class System(NamedTuple):
    """A chain in positions, its boundary no piston."""

    form: int
    law: Law
    boundary: Boundary
    contacts: Contacts


def make_system(form: int, law: Law, boundary: Boundary, beads: int, turn: float = 0.0) -> System:
    """Return a chain in positions; on a ring `turn` is the sum of all relative displacements."""
    order = 1 if form == XW else 2
    contacts = Contacts(
        form,
        boundary.ring,
        boundary.left,
        turn if boundary.ring else boundary.right,
        row_map(law.elastic, 1),
        row_map(law.viscous, order),
        row_parameters(law.elastic, 1),
        row_parameters(law.viscous, order),
        *np.zeros((4, beads + 1)),
    )
    return System(form, law, boundary, contacts)


def pack(
    form: int, law: Law, boundary: Boundary, u: np.ndarray, velocity: np.ndarray
) -> tuple[System, np.ndarray]:
    """Return a system and its state, shape (2 N,), from relative displacements and velocities.

    Both have the shape (N,); with pressure at the ends u_N is the held value.
    """
    x = np.zeros(u.size)
    x[:-1] = np.flip(np.cumsum(np.flip(u[:-1])))
    rate = velocity
    if form == XW:
        rate = velocity - equations.velocity_correction(u, boundary, law)
    system = make_system(form, law, boundary, u.size, float(u.sum()))
    return system, np.concatenate([x, rate])


def unpack(system, y):
    """Return the relative displacements and velocities, both of shape (N,), from a state vector."""
    x, rate = np.split(y, 2)
    u = np.append(x[:-1] - x[1:], system.contacts.right)
    if system.boundary.ring:
        u[-1] -= x[0] - x[-1]
    if system.form == XV:
        return u, rate
    return u, rate + equations.velocity_correction(u, system.boundary, system.law)


def right_hand_side(system, y):
    """Return the time derivative of a state vector."""
    result = np.empty_like(y)
    _derivative(system.contacts, y, result)
    return result


def integrate_fixed(system, y, h, steps):
    """Return `steps` steps of constant size h, from and to a state vector."""
    return _integrate_fixed(system.contacts, y, h, steps)


def integrate_by_stages(system, y, h, steps, nodes, weights):
    """Take `steps` steps of constant size h, by a method whose stages each use only the one before.

    Euler's method has the nodes [0] and weights [1], the classical one of order 4 the nodes
    [0, 1/2, 1/2, 1] and weights [1, 2, 2, 1]/6.
    """
    return _integrate_by_stages(system.contacts, y, h, steps, nodes, weights)


@kernel
def _derivative(contacts, y, result):
    """Time derivative of y = (x, w) or (x, ẋ)."""
    u, u_rate, force, damping = contacts.u, contacts.rate, contacts.force, contacts.damping
    beads = y.size // 2
    x, rate = y[:beads], y[beads:]
    for n in range(1, beads):
        u[n], u_rate[n] = x[n - 1] - x[n], rate[n - 1] - rate[n]
    u[0], u[beads], u_rate[0], u_rate[beads] = contacts.left, contacts.right, 0.0, 0.0
    if contacts.ring:
        u[beads] = u[0] = contacts.right - (x[0] - x[beads - 1])
        u_rate[beads] = u_rate[0] = rate[beads - 1] - rate[0]
    call_row_map(contacts.elastic, u, force, 0, beads, contacts.elastic_parameters)
    call_row_map(contacts.viscous, u, damping, 0, beads, contacts.viscous_parameters)
    if contacts.form == XW:
        for n in range(beads):
            result[n] = rate[n] + damping[n] - damping[n + 1]
            result[beads + n] = force[n] - force[n + 1]
        return
    for n in range(beads + 1):
        force[n] += damping[n] * u_rate[n]
    for n in range(beads):
        result[n] = rate[n]
        result[beads + n] = force[n] - force[n + 1]


@kernel
def _integrate_fixed(contacts, y, h, steps):
    slopes = np.empty((rk.STAGES, y.size))
    for _ in range(steps):
        _derivative(contacts, y, slopes[0])
        for row in range(1, rk.STAGES):
            stage = y.copy()
            for j in range(row):
                if _A[row, j] != 0.0:
                    stage += h * _A[row, j] * slopes[j]
            _derivative(contacts, stage, slopes[row])
        increment = np.zeros_like(y)
        for j in range(rk.STAGES):
            increment += h * _B[j] * slopes[j]
        y = y + increment
    return y


@kernel
def _integrate_by_stages(contacts, y, h, steps, nodes, weights):
    slope = np.zeros_like(y)
    for _ in range(steps):
        increment = np.zeros_like(y)
        for stage in range(nodes.size):
            _derivative(contacts, y + h * nodes[stage] * slope, slope)
            increment += weights[stage] * slope
        y = y + h * increment
    return y
