r"""The dissipative chain in its variables, its boundaries, and its balance laws.

James (2021), eqs. (5) and (24)-(32), dimensionless, with beads of masses :math:`m_n` (1 in the
paper) and a body force :math:`m_n g` (0 there).  The forces of the compression u follow from the
potentials, :math:`F(u) = -V'(-u)` and :math:`G(u) = -W'(-u)`:

.. math::

    m_n (\dot x_n - w_n) = G_{n-1} - G_n, \qquad
    m_n \dot w_n = F_{n-1} - F_n + m_n g, \qquad u_n = x_n - x_{n+1} ,

where :math:`F_n = \kappa_n F(u_n)` and :math:`G_n = \chi_n G(u_n)` with factors κ_n and χ_n of
contact n (1 in the paper).  For the law (28) they are :math:`F = u_+^\alpha` and
:math:`G = \gamma u_+^\beta`.

Three sets of variables describe the same motion: (x, ẋ), (x, w), and the strain form (u, d) with
:math:`d_n = w_n - w_{n+1}` that `strain` integrates.  This module converts between them for whole
arrays of states; the last axis is the bead n = 1 … N.

Balance laws, summed over the chain with pressure at the ends.  The damping forces of the held
contacts vanish (:math:`\dot u_0 = \dot u_N = 0`), and

.. math:: \frac{d}{dt}\sum_n m_n \dot x_n = F(\delta) - F(\tilde\delta) + g \sum_n m_n .

Contact n transmits :math:`T_n = F(u_n) + \frac{d}{dt}G(u_n)`, bead n
receives :math:`T_{n-1} - T_n`, and the flux :math:`q_n = T_n \dot x_{n+1}` telescopes, so that
eq. (6) adds up to

.. math::

    \frac{d}{dt} H(\dot x, u) &= P
      - \sum_{n=1}^{N-1} \chi_n G'(u_n)\, \dot u_n^2, \\
    P &= F(\delta) \dot x_1 - F(\tilde\delta) \dot x_N + g \sum_n m_n \dot x_n, \\
    H(v, u) &= \sum_{n=1}^N \tfrac12 m_n v_n^2 + \sum_{n=1}^{N-1} \kappa_n V(-u_n) .

Where a contact opens, its dissipated power is no smoother than G', and a
quadrature over steps loses its order.  Subtracting
:math:`\tfrac{d}{dt}\sum\tfrac12 m_n(\dot x_n^2 - w_n^2)` from both sides gives the same law in the
variables (31)-(32), where all of it is as smooth as the forces:

.. math::

    \frac{d}{dt} H(w, u) = P - g\,(G_0 - G_N) - \sum_{n=1}^{N}
      \frac{(F_{n-1} - F_n)\,(G_{n-1} - G_n)}{m_n} .

Where F and G both grow with u no term of the sum is negative: the damping takes energy in these
variables too.  On a ring P is absent and both sums run over all N beads and contacts.  Before a
wall contact N counts as well, :math:`F(\tilde\delta)` is absent from P, and momentum has no law of
its own.

A prescribed force f(t) on bead 1 takes the place of :math:`F(\delta)` in all of these, with
:math:`G_0 = 0`.  Momentum grows by its integral.

A piston is bead 1 with a prescribed velocity V(t): its momentum law is :math:`\dot x_1 = V`.  With
:math:`G_0 = G_1` eq. (31) gives :math:`w_1 = V`, and the law in u and w holds with the force
:math:`F_0 = F_1 + m_1 \dot V` in place of :math:`F(\delta)`.  What drives the piston also bears
:math:`\frac{d}{dt} G_1`; that work is in neither side.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import brentq

from granular_fronts.chain.drives import Drive
from granular_fronts.errors import InputError
from granular_fronts.model.laws import Law
from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.model.potentials import Potential


class Boundary(NamedTuple):
    """Held relative displacements at the ends, eq. (25), a ring, eq. (26), a drive, a wall.

    An end where δ or δ̃ is 0 is free.  A `drive` in place of δ is the force on bead 1, or with a
    `piston` its velocity.  With a wall at x = 0 nothing is held at the right end.
    """

    ring: bool
    left: float = 0.0
    right: float = 0.0
    drive: Drive | None = None
    piston: bool = False
    wall: bool = False

    @property
    def holds_right(self) -> bool:
        """Whether u_N is held."""
        return not (self.ring or self.wall)

    @property
    def closing_drive(self) -> Drive | None:
        """The force on bead 1, or the acceleration of the piston."""
        return self.drive.derivative() if self.piston else self.drive

    def moving(self, u: np.ndarray) -> np.ndarray:
        """Return the compressions of the contacts that move, of all of shape (..., N)."""
        return u[..., :-1] if self.holds_right else u


class Beads(NamedTuple):
    """Masses m_n, factors κ_n and χ_n of the forces of contact n, each (N,) or 1; and g."""

    mass: np.ndarray | float = 1.0
    stiffness: np.ndarray | float = 1.0
    viscosity: np.ndarray | float = 1.0
    gravity: float = 0.0

    @property
    def varied(self) -> bool:
        """Whether any of them differs along the chain."""
        return any(np.ndim(values) for values in self[:3])


EQUAL = Beads()
"""The beads and contacts of the paper."""


def damping_ratio(law: Law, boundary: Boundary, beads: Beads = EQUAL) -> float | None:
    """Return γ if G = γF for every contact and beyond the ends, else None."""
    ratio, drive = law.proportional, boundary.drive
    if ratio and drive and not (boundary.piston and drive.is_constant):
        return None
    return ratio if np.array_equal(beads.stiffness, beads.viscosity) else None


def force(potential: Potential, u: npt.ArrayLike) -> np.ndarray:
    """Return the force −V'(−u) of a potential at the compression u, elementwise."""
    return -potential.first(-np.asarray(u, dtype=float))


def forces_on_both_sides(
    u: np.ndarray,
    boundary: Boundary,
    potential: Potential,
    factor: np.ndarray | float = 1.0,
) -> tuple[np.ndarray, np.ndarray]:
    """Return forces of the contacts n − 1 and n of every bead, each of the shape (..., N) of `u`.

    With pressure at the ends u_N is the held value.  Behind a piston the force is the one ahead of
    it.  The `factor` is the one of each contact.
    """
    ahead = factor * force(potential, u)
    behind = np.roll(ahead, 1, axis=-1)
    if boundary.piston:
        behind[..., 0] = ahead[..., 0]
    elif not boundary.ring:
        behind[..., 0] = force(potential, boundary.left)
    return behind, ahead


def velocity_correction(
    u: np.ndarray,
    boundary: Boundary,
    law: Law,
    beads: Beads = EQUAL,
) -> np.ndarray:
    """Return ẋ − w of every bead, eq. (31), from u of shape (..., N)."""
    behind, ahead = forces_on_both_sides(u, boundary, law.viscous, beads.viscosity)
    return (behind - ahead) / beads.mass


def strain_rates(
    velocity: np.ndarray, u: np.ndarray, boundary: Boundary, law: Law, beads: Beads = EQUAL
) -> np.ndarray:
    """Return d_n = w_n − w_{n+1} at t = 0 from velocities; with an end on the right d_N = w_N."""
    w = velocity - velocity_correction(u, boundary, law, beads)
    ahead = np.roll(w, -1, axis=-1)
    if not boundary.ring:
        ahead[..., -1] = _shift_of_last(law, boundary, beads)
    return w - ahead


def _shift_of_last(law, boundary, beads):
    """Return w_N − d_N, a convention of `strain`."""
    return (damping_ratio(law, boundary, beads) or 0.0) * beads.gravity


def velocities(
    d: np.ndarray,
    u: np.ndarray,
    boundary: Boundary,
    law: Law,
    momentum: npt.ArrayLike = 0.0,
    beads: Beads = EQUAL,
) -> np.ndarray:
    """Return velocities ẋ_n from the strain form; see `generalised_velocities`."""
    correction = velocity_correction(u, boundary, law, beads)
    return generalised_velocities(d, boundary, law, momentum, beads) + correction


def generalised_velocities(
    d: np.ndarray,
    boundary: Boundary,
    law: Law,
    momentum: npt.ArrayLike = 0.0,
    beads: Beads = EQUAL,
) -> np.ndarray:
    """Return w_n from d_n: a suffix sum.

    On a ring d leaves a common velocity free, and the momentum Σm_nẋ_n = Σm_nw_n gives it.
    """
    if boundary.ring:
        # Rounding leaves a sum over one turn that grows with N; the exact sum is zero.
        d = d - d.mean(axis=-1, keepdims=True)
    w = np.flip(np.cumsum(np.flip(d, axis=-1), axis=-1), axis=-1)
    if boundary.ring:
        mass = np.broadcast_to(beads.mass, w.shape[-1])
        return w + (momentum - (mass * w).sum(axis=-1, keepdims=True)) / mass.sum()
    return w + _shift_of_last(law, boundary, beads)


def transmitted_forces(
    u: np.ndarray, velocity: np.ndarray, boundary: Boundary, law: Law, beads: Beads = EQUAL
) -> np.ndarray:
    """Return the forces T_n of all contacts, of the shape (..., N) of `u` and `velocity`."""
    rate = differences(velocity, boundary)
    elastic = beads.stiffness * force(law.elastic, u)
    # G'(u); of a contact that just touches on the side to which it moves.
    strain = -(u - NEGLIGIBLE * (rate < 0.0))
    slope = law.viscous.second(strain)
    return elastic + beads.viscosity * slope * rate


def forces_behind(
    transmitted: np.ndarray, boundary: Boundary, law: Law, beads: Beads, t: npt.ArrayLike
) -> np.ndarray:
    """Return the forces T_(n−1) behind all beads, from those of all contacts at times t."""
    behind = np.roll(transmitted, 1, axis=-1)
    if boundary.drive:
        behind[..., 0] = boundary.closing_drive.value(t)
        if boundary.piston:
            behind[..., 0] = transmitted[..., 0] + np.ravel(beads.mass)[0] * behind[..., 0]
    elif not boundary.ring:
        behind[..., 0] = force(law.elastic, boundary.left)
    return behind


def accelerations(
    u: np.ndarray, velocity: np.ndarray, boundary: Boundary, law: Law, beads: Beads, t: float
) -> np.ndarray:
    """Return ẍ_n of all beads at the time t."""
    ahead = transmitted_forces(u, velocity, boundary, law, beads)
    behind = forces_behind(ahead, boundary, law, beads, t)
    return (behind - ahead) / beads.mass + beads.gravity


def differences(values: np.ndarray, boundary: Boundary) -> np.ndarray:
    """Return what each bead has more than the next one; a wall has 0, a free end what it ends."""
    ahead = np.roll(values, -1, axis=-1)
    if not boundary.ring:
        ahead[..., -1] = 0.0 if boundary.wall else values[..., -1]
    return values - ahead


def energy(
    u: np.ndarray,
    velocity: np.ndarray,
    boundary: Boundary,
    potential: Potential,
    beads: Beads = EQUAL,
) -> np.ndarray:
    """Return H(v, u), the kinetic energy of ẋ or w and the elastic energy of moving contacts."""
    kinetic = 0.5 * np.sum(beads.mass * velocity**2, axis=-1)
    elastic = boundary.moving(beads.stiffness * potential.value(-u))
    return kinetic + np.sum(elastic, axis=-1)


def equilibrium(law: Law, boundary: Boundary, beads: Beads, count: int) -> np.ndarray:
    r"""Return the static compressions u_1 … u_N, where every contact bears what lies behind it.

    Contact n exerts :math:`\kappa_n F(u_n) = F(\delta) + g \sum_{k \le n} m_k`, in a branch on
    which the force grows with u.  Before a wall f(0) of a drive takes the place of F(δ); without a
    wall δ̃ that of δ.  It is an InputError if the law exerts no such force.
    """
    weight = beads.gravity * np.cumsum(np.broadcast_to(beads.mass, count))
    load = force(law.elastic, boundary.left if boundary.wall else boundary.right)
    if boundary.wall and boundary.drive:
        load = boundary.drive.value(0.0)
    needed = (load + weight) / beads.stiffness
    if needed.min() < 0.0:
        raise InputError(
            f"In equilibrium a contact would bear the force {needed.min():.6g}, which pulls: press "
            "the chain at t = 0."
        )
    return np.array([_compression_of(float(one), law) for one in needed])


def _compression_of(needed: float, law: Law) -> float:
    """Return the smallest compression of 0 or more with this force, to the last bit or two."""
    if needed == 0.0:
        return 0.0
    end = -law.domain[0]
    trials = np.logspace(-150, 100, 8001)
    if np.isfinite(end):
        near_end = end * np.logspace(-12, -0.31, 400)
        trials = np.concatenate([trials[trials < 0.49 * end], end - near_end[::-1]])
    with np.errstate(over="ignore", invalid="ignore"):
        enough = force(law.elastic, trials) >= needed
    if not enough.any():
        raise InputError(
            f"In equilibrium a contact bears the force {needed:.6g}, more than {law.elastic.name} "
            "exerts: lower the load or the body force."
        )
    # The first of them is the end of the branch that begins at rest.
    first = int(np.argmax(enough))
    low = trials[first - 1] if first else 0.0
    return brentq(
        lambda u: force(law.elastic, u) - needed, low, trials[first], xtol=1.0e-300, rtol=1.0e-15
    )
