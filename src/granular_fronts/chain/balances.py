"""Momentum law and energy balance of a run, James (2021), section 3.3 and eq. (6).

The laws stand in the docstring of `equations`.  The work of the pressure is exact, since a constant
force does work on the displacement of the bead it acts on; the dissipated energy is integrated by
the Runge-Kutta pair beside the motion.
"""

import math

import numpy as np

from granular_fronts.chain import equations


class Balances:
    """Largest drifts of both laws, noted after blocks of steps."""

    def __init__(self, run):
        self._energy_at_start, self._first_at_start, self._last_at_start = _measure(run)[1:]
        self._drift = {"momentum": 0.0, "energy": 0.0}
        self._scale = {"momentum": 0.0, "energy": self._energy_at_start}
        self._tracks_energy = run.recording.track_energy

    def check(self, run):
        """Compare the run with the exact laws at its present time."""
        velocity, energy, first, last = _measure(run)
        left = equations.force(run.boundary.left, run.law.alpha)
        right = equations.force(run.boundary.right, run.law.alpha)
        gained = (left - right) * run.clock.t[0]
        work = left * (first - self._first_at_start) - right * (last - self._last_at_start)
        stored = energy - self._energy_at_start + run.clock.dissipated[0]
        self._note("momentum", velocity.sum() - run.momentum - gained, np.abs(velocity).sum())
        self._note("energy", stored - work, energy)

    def drifts(self):
        """Largest drifts relative to Σ|ẋ_n| and to the largest energy; NaN where not tracked."""
        momentum = self._drift["momentum"] / (self._scale["momentum"] or 1.0)
        energy = self._drift["energy"] / (self._scale["energy"] or 1.0)
        return {
            "momentum_drift": float(momentum),
            "energy_drift": float(energy) if self._tracks_energy else math.nan,
        }

    def _note(self, law, drift, scale):
        self._drift[law] = max(self._drift[law], abs(drift))
        self._scale[law] = max(self._scale[law], abs(scale))


def _measure(run):
    """Velocities, energy, and positions of the first and last bead (0 on a ring)."""
    beads = slice(1, run.size.beads + 1)
    u, d, first, last = run.state.u[beads].copy(), run.state.d[beads], 0.0, 0.0
    if not run.boundary.ring:
        first, last = u.sum(), u[-1]
        u[-1] = run.boundary.right
    law = run.law
    velocity = equations.velocities(d, u, run.boundary, law.beta, law.gamma, run.momentum)
    return velocity, equations.energy(u, velocity, run.boundary, law.alpha), first, last
