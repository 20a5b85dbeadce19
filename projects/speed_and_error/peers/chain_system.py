r"""The chain of James (2021) as other people's integrators take it: a system in (x, w).

Equations (31)–(32) with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

with u_n = x_n - x_{n+1}.  u_0 = δ is held and u_N = 0 is free (25).
"""

from dataclasses import dataclass

import numpy as np

from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain


@dataclass(frozen=True)
class ChainSystem:
    """Section 3.3: constant pressure on a chain at rest, whose contacts just touch."""

    gamma: float  # damping
    end: float  # final time
    beads: int = 420  # N
    left: float = 0.1  # compression δ held at the left end

    def start(self):
        """Return (x, w) at t = 0, shape (2N,); the held contact gives w_1."""
        state = np.zeros(2 * self.beads)
        state[self.beads] = -self.gamma * self.left**1.5
        return state

    def scene(self):
        """Return the same as the package takes it."""
        law, record = kuwabara_kono(1.5, self.gamma), {"snapshots": [self.end]}
        return pressed_chain(law, self.beads, self.end, (1e-9, 1e-11), record, self.left)

    def observe(self, state):
        """Return u_1 … u_N and the velocities of a state (x, w)."""
        positions, momenta = state[: self.beads], state[self.beads :]
        contacts = np.concatenate([[self.left], positions[:-1] - positions[1:], [0.0]])
        forces = np.maximum(contacts, 0.0) ** 1.5
        return {
            "relative_displacement": contacts[1:],
            "velocity": momenta + self.gamma * (forces[:-1] - forces[1:]),
        }
