r"""The dissipative chain in its variables, its boundaries, and its balance laws.

James (2021), eqs. (24)-(32), dimensionless (m = k = 1):

.. math::

    \dot x_n = w_n + \gamma\,(u_{n-1,+}^\beta - u_{n,+}^\beta), \qquad
    \dot w_n = u_{n-1,+}^\alpha - u_{n,+}^\alpha, \qquad u_n = x_n - x_{n+1} .

Three sets of variables describe the same motion: (x, ẋ), (x, w), and the strain form (u, d) with
:math:`d_n = w_n - w_{n+1}` that `strain` integrates.  This module converts between them for whole
arrays of states; the last axis is the bead n = 1 … N.

Balance laws, summed over the chain with pressure at the ends.  The damping forces of the held
contacts vanish (:math:`\dot u_0 = \dot u_N = 0`), and

.. math:: \frac{d}{dt}\sum_n \dot x_n = \delta^\alpha - \tilde\delta^\alpha .

Contact n transmits :math:`T_n = u_{n,+}^\alpha + \gamma\,\frac{d}{dt}u_{n,+}^\beta`, bead n
receives :math:`T_{n-1} - T_n`, and the flux :math:`q_n = T_n \dot x_{n+1}` telescopes, so that
eq. (6) adds up to

.. math::

    \frac{d}{dt} H(\dot x, u) = P
      - \sum_{n=1}^{N-1} \beta\gamma\, u_{n,+}^{\beta-1}\, \dot u_n^2, \quad
    P = \delta^\alpha \dot x_1 - \tilde\delta^\alpha \dot x_N, \quad
    H(v, u) = \sum_{n=1}^N \tfrac12 v_n^2 + \sum_{n=1}^{N-1} \frac{u_{n,+}^{\alpha+1}}{\alpha+1} .

Where a contact opens, its dissipated power is no smoother than :math:`u_+^{\beta-1}`, and a
quadrature over steps loses its order.  Subtracting
:math:`\tfrac{d}{dt}\sum\tfrac12(\dot x_n^2 - w_n^2)` from both sides gives the same law in the
variables (31)-(32), where all of it is as smooth as the forces:

.. math::

    \frac{d}{dt} H(w, u) = P - \gamma \sum_{n=1}^{N}
      \bigl(u_{n-1,+}^\alpha - u_{n,+}^\alpha\bigr) \bigl(u_{n-1,+}^\beta - u_{n,+}^\beta\bigr) .

No term of the sum is negative: the damping takes energy in these variables too.  On a ring P is
absent and both sums run over all N beads and contacts.

A piston is bead 1 with a prescribed velocity V(t), constant or rising linearly from 0: what drives
it exerts the unknown force :math:`f = T_1 + \dot V`.  In place of the momentum law stands
:math:`\dot x_1 = V`, and since :math:`f = \frac{d}{dt}\sum_n\dot x_n + \tilde\delta^\alpha`, its
work needs no quadrature while the acceleration :math:`a = \dot V` is constant:

.. math::

    \int f\,V\,dt = \Bigl[ V \sum_n \dot x_n - a \sum_n x_n + \tilde\delta^\alpha x_1 \Bigr] .

The viscous part of :math:`T_1` is no smoother than the power above.  In u and w the law therefore
holds for :math:`H + \gamma V u_{1,+}^\beta`, with V for the velocity of bead 1; the sum begins with
bead 2, and :math:`a\,u_{1,+}^\beta` is taken from it.
"""

from typing import NamedTuple

import numpy as np


class Piston(NamedTuple):
    """Prescribed motion of bead 1.

    Attributes
    ----------
    velocity : float
        V at the end of the ramp and ever after.
    ramp : float
        Time over which the velocity rises linearly from 0; 0 for a constant velocity.
    """

    velocity: float
    ramp: float

    def velocity_at(self, t):
        """V(t)."""
        return self.velocity * min(t / self.ramp, 1.0) if self.ramp else self.velocity

    def acceleration_at(self, t):
        """Acceleration up to the time t, elementwise; at the end of the ramp that of the ramp."""
        return self.velocity / self.ramp * (np.asarray(t) <= self.ramp) if self.ramp else 0.0


class Boundary(NamedTuple):
    """Held relative displacements at the ends, eq. (25), a ring, eq. (26), or a piston.

    Attributes
    ----------
    ring : bool
    left, right : float
        δ and δ̃, the relative displacements held at the ends; 0 is a free end, unused on a ring.
    piston : Piston, optional
        Motion of bead 1, for which nothing is held at the left end.
    """

    ring: bool
    left: float = 0.0
    right: float = 0.0
    piston: Piston | None = None


def force(u, exponent):
    """The contact force u₊^exponent, elementwise."""
    return np.maximum(u, 0.0) ** exponent


def forces_on_both_sides(u, boundary, exponent, t=0.0):
    """Forces of the contacts n − 1 and n of every bead, each of the shape of `u`.

    Parameters
    ----------
    u : ndarray, shape (..., N)
        Relative displacements; with pressure at the ends u_N is the held value.
    t : float or ndarray, shape (...), optional
        Time, on which the force behind a piston depends.
    """
    ahead = force(u, exponent)
    behind = np.roll(ahead, 1, axis=-1)
    if boundary.piston:
        behind[..., 0] = ahead[..., 0] + boundary.piston.acceleration_at(t)
    elif not boundary.ring:
        behind[..., 0] = force(boundary.left, exponent)
    return behind, ahead


def velocity_correction(u, boundary, beta, gamma, t=0.0):
    """ẋ − w of every bead, eq. (31)."""
    behind, ahead = forces_on_both_sides(u, boundary, beta, t)
    return gamma * (behind - ahead)


def strain_rates(velocity, u, boundary, beta, gamma):
    """d_n = w_n − w_{n+1} at t = 0 from velocities; with an end on the right d_N = w_N."""
    w = velocity - velocity_correction(u, boundary, beta, gamma)
    ahead = np.roll(w, -1, axis=-1)
    if not boundary.ring:
        ahead[..., -1] = 0.0
    return w - ahead


def velocities(d, u, boundary, beta, gamma, momentum=0.0, t=0.0):
    """Velocities ẋ_n from the strain form.

    Parameters
    ----------
    momentum : float
        As in `generalised_velocities`.
    t : float or ndarray, shape (...), optional
        Time, which matters to a piston.
    """
    correction = velocity_correction(u, boundary, beta, gamma, t)
    return generalised_velocities(d, boundary, momentum) + correction


def generalised_velocities(d, boundary, momentum=0.0):
    """w_n from d_n: a suffix sum.

    Parameters
    ----------
    momentum : float
        Σẋ_n = Σw_n on a ring, where d leaves a common velocity free; not used otherwise.
    """
    if boundary.ring:
        # Rounding leaves a sum over one turn that grows with N; the exact sum is zero.
        d = d - d.mean(axis=-1, keepdims=True)
    w = np.flip(np.cumsum(np.flip(d, axis=-1), axis=-1), axis=-1)
    if boundary.ring:
        w = w + (momentum - w.sum(axis=-1, keepdims=True)) / w.shape[-1]
    return w


def energy(u, velocity, boundary, alpha):
    """H(v, u): kinetic energy of the velocities, ẋ or w, and elastic one of the moving contacts."""
    moving = u if boundary.ring else u[..., :-1]
    kinetic = 0.5 * np.sum(velocity**2, axis=-1)
    return kinetic + np.sum(force(moving, alpha + 1.0), axis=-1) / (alpha + 1.0)
