"""Momentum law and energy balance of a run, James (2021), section 3.3 and eq. (6).

`equations` states the laws.  Energy is measured in u and w, where openings of contacts do no harm.
A constant force does work on the displacement of its bead, and the impulse of a drive is its
integral; both are exact.  The work of a drive and the dissipated energy are integrated with the
motion, by the method of each step.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.chain import equations
from granular_fronts.chain.state import D, U


class _State(NamedTuple):
    velocity: np.ndarray
    momentum: float
    largest_momentum: float  # Were all beads to move the same way.
    energy: float
    positions: np.ndarray  # 0 on a ring.


class Balances:
    """Largest drifts of both laws, noted after blocks of steps."""

    def __init__(self, run):
        self._start = _measure(run)
        self._drift = {"momentum": 0.0, "energy": 0.0}
        self._scale = {"momentum": 0.0, "energy": self._start.energy}
        self._tracks_energy = run.recording.track_energy

    def check(self, run):
        """Compare the run with the exact laws at its present time."""
        now = _measure(run)
        stored = now.energy - self._start.energy + run.clock.dissipated
        if run.boundary.ring:
            self._note("momentum", now.momentum - run.momentum, now.largest_momentum)
            self._note("energy", stored, now.energy)
        else:
            self._check_ends(run, now, stored)

    def _check_ends(self, run, now, stored):
        t, boundary = run.clock.t, run.boundary
        # The work of a drive is part of what is stored.
        left = 0.0 if boundary.drive else equations.force(run.law.elastic, boundary.left)
        right = equations.force(run.law.elastic, boundary.right)
        mass = np.broadcast_to(run.beads.mass, run.chain.beads)
        moved = now.positions - self._start.positions
        work = left * moved[0] - right * moved[-1] + run.beads.gravity * (mass @ moved)
        if boundary.piston:
            exact = float(boundary.drive.value(t))
            self._note("momentum", now.velocity[0] - exact, abs(exact))
            self._note("energy", stored - work, max(now.energy, 0.5 * mass[0] * exact**2))
            return
        self._note("energy", stored - work, now.energy)
        gained = (left - right + run.beads.gravity * mass.sum()) * t
        gained += boundary.drive.integral(t) if boundary.drive else 0.0
        # The force of a wall is not known beforehand.
        drift = math.nan if boundary.wall else now.momentum - run.momentum - gained
        self._note("momentum", drift, now.largest_momentum)

    def drifts(self):
        """Return the largest relative drifts of momentum and energy; NaN where not tracked.

        With a piston the first is the drift of its velocity.
        """
        momentum = self._drift["momentum"] / (self._scale["momentum"] or 1.0)
        energy = self._drift["energy"] / (self._scale["energy"] or 1.0)
        return {
            "momentum_drift": float(momentum),
            "energy_drift": float(energy) if self._tracks_energy else math.nan,
        }

    def _note(self, law, drift, scale):
        # Unlike max, the maximum of numpy is NaN where one of the two is.
        self._drift[law] = np.maximum(self._drift[law], abs(drift))
        self._scale[law] = np.maximum(self._scale[law], abs(scale))


def _measure(run):
    """Return the state at the present time."""
    law, boundary = run.law, run.boundary
    u, d, positions = run.row(U).copy(), run.row(D), np.zeros(run.chain.beads)
    if not boundary.ring:
        positions = np.flip(np.cumsum(np.flip(u)))
    if boundary.holds_right:
        u[-1] = boundary.right
    w = equations.generalised_velocities(d, boundary, law, run.momentum, run.beads)
    velocity = w + equations.velocity_correction(u, boundary, law, run.beads)
    energy = equations.energy(u, w, boundary, law.elastic, run.beads)
    momenta = run.beads.mass * velocity
    return _State(velocity, momenta.sum(), np.abs(momenta).sum(), energy, positions)
