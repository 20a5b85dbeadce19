r"""The steps of discrete-element codes: velocity Verlet with velocities of half steps, and others.

LAMMPS's ``fix nve``, LIGGGHTS and YADE evaluate the forces once in each step h,

.. math::

    v_{n+1/2} = v_n + \tfrac h2 a_n, \qquad x_{n+1} = x_n + h\,v_{n+1/2}, \qquad
    a_{n+1} = a(x_{n+1}, v_{n+1/2}), \qquad v_{n+1} = v_{n+1/2} + \tfrac h2 a_{n+1}.

Without damping this is the velocity Verlet method, of order 2.  With it the viscous forces take the
velocity of half a step before, the latest one known, and the order is 1.

Leading error.  The viscous force at time t sees :math:`v - \tfrac h2\dot v`, all else is right to
order h².  Up to h² the method therefore solves the chain whose contacts carry

.. math::

    u_+^\alpha + g\,\dot u - \tfrac h2\,g\,\ddot u, \qquad g = \gamma\beta u_+^{\beta-1}.

Two free beads obey :math:`\ddot u = -2(\ldots)`, and their contact is, elastic and viscous force
alike, stronger by the factor :math:`1/(1 - hg) \approx 1 + hg`.  In a chain ü depends on the
neighbours too, and there is no such factor.  To first order in γ the force is no damping of a
collision: its work,

.. math:: -\tfrac h2 \int g(u)\,\ddot u\,\dot u\,dt,

vanishes if u(t) is symmetric about its maximum, as it is without damping.  A linear contact with
:math:`\omega^2 = 2s` has the damping ratio ζ(1 + hg/2), ζ = g/ω.

Stability.  Linearised at the stiffness s and the viscous coefficient g, the shortest wave of a
chain has multipliers z, :math:`z^2 - (2 - 4h^2s - 4hg)z + 1 - 4hg = 0`.  Their modulus is at most 1
if and only if :math:`h^2 s + 2hg \le 1`.

Other steps.  A `Scheme` says what differs.  LAMMPS's ``fix mvv/dpd 1.0`` lets forces see the
predicted velocity :math:`v_{n+1/2} + \tfrac h2 a_n` and has order 2.  Symplectic Euler gives
velocities the whole of :math:`h a_n` before the positions, and has order 1 without damping too.  So
has a code that keeps velocities of half steps, if its output takes them for those of whole steps.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from granular_fronts.arguments import count, scalar, sequence
from granular_fronts.errors import InputError
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted


class Chain(NamedTuple):
    """α, β and γ of the law, and the relative displacements δ and δ̃ held at the ends (25).

    A wall at the right end, in place of δ̃, touches the last bead at x = 0.
    """

    alpha: float
    beta: float
    gamma: float
    left: float = 0.0
    right: float = 0.0
    wall: bool = False


class Motion(NamedTuple):
    """Positions and velocities of the beads followed, (time, bead), after 0, 1, 2 … steps."""

    t: np.ndarray
    x: np.ndarray
    v: np.ndarray


class Scheme(NamedTuple):
    """Share of h a that velocities have before the positions move, and that forces see besides."""

    before: float
    ahead: float


LAGGED_VERLET = Scheme(0.5, 0.0)

SCHEMES = {
    "lagged_verlet": LAGGED_VERLET,
    "predicted_verlet": Scheme(0.5, 0.5),
    "symplectic_euler": Scheme(1.0, 0.0),
}


def integrate(
    chain: Chain,
    x: npt.ArrayLike,
    v: npt.ArrayLike,
    step: float,
    steps: int,
    follow: Sequence[int] | None = None,
    scheme: Scheme = LAGGED_VERLET,
) -> Motion:
    """Advance a chain by equal steps h > 0; an InputError names an argument out of range.

    α is above 0, β 1 or more, and γ, δ and δ̃ are 0 or more.  At t = 0 the beads have displacements
    x, zero where they just touch, and velocities v, both of shape (N,).  `follow` holds the indices
    of the beads whose motion is returned; all by default.  `scheme` is one of `SCHEMES`.
    """
    alpha = scalar("alpha", chain.alpha, above=0.0, advice="give an exponent")
    beta = scalar("beta", chain.beta, least=1.0, advice="give an exponent")
    law = alpha, beta, scalar("gamma", chain.gamma, least=0.0, advice="give a damping")
    left, right = (
        scalar(end, getattr(chain, end), least=0.0, advice="press, or leave it free")
        for end in ("left", "right")
    )
    ends = left**alpha, right**alpha, chain.wall
    x, v = np.array(sequence("x", x)), np.array(sequence("v", v))
    if v.size != x.size:
        raise InputError(f"v holds {v.size} numbers, but x {x.size}: give one for each bead.")
    step = scalar("step", step, above=0.0, advice="give a step")
    steps = count("steps", steps)
    follow = np.arange(x.size) if follow is None else np.asarray(follow, np.int64)
    if not np.isin(follow, np.arange(x.size)).all():
        raise InputError(
            f"follow is {[*follow]}, but beads are 0 to {x.size - 1}: choose of these."
        )
    followed_x, followed_v = np.full((2, steps + 1, follow.size), np.nan)
    advance(x, v, law, ends, (step, *scheme), follow, followed_x, followed_v)
    return Motion(step * np.arange(steps + 1), followed_x, followed_v)


@kernel
def advance(x, v, law, ends, scheme, follow, followed_x, followed_v):
    """Take steps in place and keep what is followed, one row a step."""
    step, before, ahead = scheme
    a, seen = np.zeros_like(x), v.copy()
    for i in range(followed_x.shape[0]):
        if interrupted():
            break
        if i > 0:
            for n in range(x.size):
                v[n] += before * step * a[n]
                x[n] += step * v[n]
                seen[n] = v[n] + ahead * step * a[n]
        _accelerate(x, seen, law, ends, a)
        if i > 0:
            for n in range(x.size):
                v[n] += (1.0 - before) * step * a[n]
        for j in range(follow.size):
            followed_x[i, j] = x[follow[j]]
            followed_v[i, j] = v[follow[j]]


@kernel
def _accelerate(x, v, law, ends, a):
    """Right-hand side of (28), with the forces `ends` at the ends, or a wall at the right one."""
    alpha, beta, gamma = law
    before, right, wall = ends
    for n in range(x.size):
        u, rate, after = x[n], v[n], 0.0
        if n < x.size - 1:
            u, rate = u - x[n + 1], rate - v[n + 1]
        elif not wall:
            u, after = 0.0, right
        if u > 0.0:
            after = u**alpha + gamma * beta * u ** (beta - 1.0) * rate
        a[n] = before - after
        before = after
