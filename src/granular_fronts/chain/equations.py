r"""The dissipative chain in its variables, its boundaries, and its balance laws.

James (2021), eqs. (5) and (24)-(32), dimensionless (m = 1), with the forces of the compression u
that follow from the potentials, :math:`F(u) = -V'(-u)` and :math:`G(u) = -W'(-u)`:

.. math::

    \dot x_n = w_n + G(u_{n-1}) - G(u_n), \qquad
    \dot w_n = F(u_{n-1}) - F(u_n), \qquad u_n = x_n - x_{n+1} .

For the law (28) they are :math:`F = u_+^\alpha` and :math:`G = \gamma u_+^\beta`.  Three sets of
variables describe the same motion: (x, ẋ), (x, w), and the strain form (u, d) with
:math:`d_n = w_n - w_{n+1}` that `strain` integrates.  This module converts between them for whole
arrays of states; the last axis is the bead n = 1 … N.

Balance laws, summed over the chain with pressure at the ends.  The damping forces of the held
contacts vanish (:math:`\dot u_0 = \dot u_N = 0`), and

.. math:: \frac{d}{dt}\sum_n \dot x_n = F(\delta) - F(\tilde\delta) .

Contact n transmits :math:`T_n = F(u_n) + \frac{d}{dt}G(u_n)`, bead n
receives :math:`T_{n-1} - T_n`, and the flux :math:`q_n = T_n \dot x_{n+1}` telescopes, so that
eq. (6) adds up to

.. math::

    \frac{d}{dt} H(\dot x, u) = P
      - \sum_{n=1}^{N-1} G'(u_n)\, \dot u_n^2, \quad
    P = F(\delta) \dot x_1 - F(\tilde\delta) \dot x_N, \quad
    H(v, u) = \sum_{n=1}^N \tfrac12 v_n^2 + \sum_{n=1}^{N-1} V(-u_n) .

Where a contact opens, its dissipated power is no smoother than G', and a
quadrature over steps loses its order.  Subtracting
:math:`\tfrac{d}{dt}\sum\tfrac12(\dot x_n^2 - w_n^2)` from both sides gives the same law in the
variables (31)-(32), where all of it is as smooth as the forces:

.. math::

    \frac{d}{dt} H(w, u) = P - \sum_{n=1}^{N}
      \bigl(F(u_{n-1}) - F(u_n)\bigr) \bigl(G(u_{n-1}) - G(u_n)\bigr) .

Where F and G both grow with u no term of the sum is negative: the damping takes energy in these
variables too.  On a ring P is absent and both sums run over all N beads and contacts.

A piston is bead 1 with a prescribed velocity V(t), constant or rising linearly from 0: what drives
it exerts the unknown force :math:`f = T_1 + \dot V`.  The momentum law is replaced by :math:`\dot
x_1 = V`, and since :math:`f = \frac{d}{dt}\sum_n\dot x_n + F(\tilde\delta)`, its work needs no
quadrature while the acceleration :math:`a = \dot V` is constant:

.. math::

    \int f\,V\,dt = \Bigl[ V \sum_n \dot x_n - a \sum_n x_n + F(\tilde\delta) x_1 \Bigr] .

The viscous part of :math:`T_1` is no smoother than the power above.  In u and w the law therefore
holds for :math:`H + V G(u_1)`, with V for the velocity of bead 1.  The sum begins with bead 2, and
:math:`a\,G(u_1)` is taken from it.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from granular_fronts.model.laws import Law
from granular_fronts.model.potentials import Potential


class Piston(NamedTuple):
    """Motion of bead 1, whose velocity rises linearly from 0 over the time `ramp`."""

    velocity: float
    ramp: float

    def velocity_at(self, t: float) -> float:
        """Return V(t)."""
        return self.velocity * min(t / self.ramp, 1.0) if self.ramp else self.velocity

    def acceleration_at(self, t: npt.ArrayLike) -> npt.ArrayLike:
        """Return the acceleration up to the time t, elementwise, the end of the ramp included."""
        return self.velocity / self.ramp * (np.asarray(t) <= self.ramp) if self.ramp else 0.0


class Boundary(NamedTuple):
    """Held relative displacements at the ends, eq. (25), a ring, eq. (26), or a piston.

    An end where δ or δ̃ is 0 is free; with a piston nothing is held at the left end.
    """

    ring: bool
    left: float = 0.0
    right: float = 0.0
    piston: Piston | None = None


def force(potential: Potential, u: npt.ArrayLike) -> np.ndarray:
    """Return the force −V'(−u) of a potential at the compression u, elementwise."""
    return -potential.first(-np.asarray(u, dtype=float))


def forces_on_both_sides(
    u: np.ndarray, boundary: Boundary, potential: Potential, shift: npt.ArrayLike = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Return forces of the contacts n − 1 and n of every bead, each of the shape (..., N) of `u`.

    With pressure at the ends u_N is the held value.  Behind a piston the force is larger by
    `shift`, shape (...), than ahead of it.
    """
    ahead = force(potential, u)
    behind = np.roll(ahead, 1, axis=-1)
    if boundary.piston:
        behind[..., 0] = ahead[..., 0] + shift
    elif not boundary.ring:
        behind[..., 0] = force(potential, boundary.left)
    return behind, ahead


def velocity_correction(
    u: np.ndarray, boundary: Boundary, law: Law, t: npt.ArrayLike = 0.0
) -> np.ndarray:
    """Return ẋ − w of every bead, eq. (31), from u of shape (..., N).

    The convention for w of a piston depends on the time (`strain`).
    """
    shift = 0.0
    if boundary.piston:
        shift = (law.proportional or 0.0) * boundary.piston.acceleration_at(t)
    behind, ahead = forces_on_both_sides(u, boundary, law.viscous, shift)
    return behind - ahead


def strain_rates(velocity: np.ndarray, u: np.ndarray, boundary: Boundary, law: Law) -> np.ndarray:
    """Return d_n = w_n − w_{n+1} at t = 0 from velocities; with an end on the right d_N = w_N."""
    w = velocity - velocity_correction(u, boundary, law)
    ahead = np.roll(w, -1, axis=-1)
    if not boundary.ring:
        ahead[..., -1] = 0.0
    return w - ahead


def velocities(
    d: np.ndarray,
    u: np.ndarray,
    boundary: Boundary,
    law: Law,
    momentum: npt.ArrayLike = 0.0,
    t: npt.ArrayLike = 0.0,
) -> np.ndarray:
    """Return velocities ẋ_n at the times t from the strain form; see `generalised_velocities`."""
    correction = velocity_correction(u, boundary, law, t)
    return generalised_velocities(d, boundary, momentum) + correction


def generalised_velocities(
    d: np.ndarray, boundary: Boundary, momentum: npt.ArrayLike = 0.0
) -> np.ndarray:
    """Return w_n from d_n: a suffix sum.

    On a ring d leaves a common velocity free, and the momentum Σẋ_n = Σw_n gives it.
    """
    if boundary.ring:
        # Rounding leaves a sum over one turn that grows with N; the exact sum is zero.
        d = d - d.mean(axis=-1, keepdims=True)
    w = np.flip(np.cumsum(np.flip(d, axis=-1), axis=-1), axis=-1)
    if boundary.ring:
        w = w + (momentum - w.sum(axis=-1, keepdims=True)) / w.shape[-1]
    return w


def energy(
    u: np.ndarray, velocity: np.ndarray, boundary: Boundary, potential: Potential
) -> np.ndarray:
    """Return H(v, u), the kinetic energy of ẋ or w and the elastic energy of moving contacts."""
    moving = u if boundary.ring else u[..., :-1]
    kinetic = 0.5 * np.sum(velocity**2, axis=-1)
    return kinetic + np.sum(potential.value(-moving), axis=-1)
