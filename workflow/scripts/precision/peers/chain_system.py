r"""The chain of James (2021) as other people's integrators take it: a system in (x, w).

Equations (31)–(32) with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

with u_n = x_n - x_{n+1}. Between two ends u_0 = δ is held and u_N = 0 is free (25); on a ring
u_0 = u_N = -L - (x_1 - x_N), where -L is the sum of all relative displacements (26).
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.sparse import csc_array

STEP_LIMIT = 10_000_000


@dataclass(frozen=True)
class ChainSystem:
    """A motion to solve."""

    gamma: float  # damping
    end: float  # final time
    contacts: np.ndarray  # u_1 … u_N at t = 0
    velocities: np.ndarray  # likewise
    left: float = 0.0  # compression δ held at the left end; unused on a ring
    ring: bool = False

    @property
    def beads(self):
        """N."""
        return self.contacts.size

    @property
    def turn(self):
        """Sum of all relative displacements, which a ring keeps."""
        return float(self.contacts.sum())

    def start(self):
        """Return (x, w) at t = 0, shape (2N,), with x_N = 0."""
        positions = np.zeros(self.beads)
        positions[:-1] = np.flip(np.cumsum(np.flip(self.contacts[:-1])))
        return np.concatenate([positions, self.velocities - self._damping(positions)])

    def observe(self, state):
        """Return u_1 … u_N and the velocities of a state (x, w)."""
        positions, momenta = state[: self.beads], state[self.beads :]
        return {
            "relative_displacement": self._all_contacts(positions)[1:],
            "velocity": momenta + self._damping(positions),
        }

    def _all_contacts(self, positions):
        """Return u_0 … u_N."""
        closing = self.turn - (positions[0] - positions[-1])
        ends = (closing, closing) if self.ring else (self.left, 0.0)
        return np.concatenate([ends[:1], positions[:-1] - positions[1:], ends[1:]])

    def _damping(self, positions):
        """Return γ [F(u_{n-1}) - F(u_n)]."""
        forces = np.maximum(self._all_contacts(positions), 0.0) ** 1.5
        return self.gamma * (forces[:-1] - forces[1:])


def front_initiation(gamma, end, beads=420, delta=0.1):
    """Section 3.3: constant pressure on a chain at rest, whose contacts just touch."""
    rest = np.zeros(beads)
    return ChainSystem(gamma, end, rest, rest, left=delta)


def numpy_right_hand_side(system):
    """Return f(state, out) in vectorised numpy; it works in buffers of its own."""
    beads, gamma, turn = system.beads, system.gamma, system.turn
    contacts, roots = np.zeros(beads + 1), np.empty(beads + 1)
    contacts[0] = system.left

    def right_hand_side(state, out):
        np.subtract(state[: beads - 1], state[1:beads], out=contacts[1:-1])
        if system.ring:
            contacts[0] = contacts[-1] = turn - (state[0] - state[beads - 1])
        np.maximum(contacts, 0.0, out=roots)
        np.sqrt(roots, out=roots)
        # The held contact keeps its compression: the force goes to another buffer.
        forces = np.multiply(contacts, roots)
        momentum_rate = out[beads:]
        np.subtract(forces[:-1], forces[1:], out=momentum_rate)
        np.multiply(momentum_rate, gamma, out=out[:beads])
        out[:beads] += state[beads:]

    return right_hand_side


class SparseJacobian:
    """Derivative of the right-hand side, [[γD, 1], [D, 0]]; D is tridiagonal, on a ring cyclic."""

    def __init__(self, system):
        self.system = system
        beads = system.beads
        here = np.arange(beads)
        behind, ahead = (here - 1) % beads, (here + 1) % beads
        columns = np.concatenate([behind, here, ahead, beads + here, behind, here, ahead])
        rows = np.concatenate([here, here, here, here, *[beads + here] * 3])
        entries = np.arange(rows.size)
        template = csc_array((entries + 1.0, (rows, columns)), shape=(2 * beads, 2 * beads))
        self._order = (template.data - 1.0).astype(int)
        # SUNDIALS takes no longer integers.
        self._indices = template.indices.astype(np.int32)
        self._starts = template.indptr.astype(np.int32)

    @property
    def pattern(self):
        """The matrix with a one wherever it may not vanish."""
        return self._matrix(np.ones(self._order.size))

    def values(self, state):
        """Return the entries by columns, and within a column by rows."""
        beads, gamma = self.system.beads, self.system.gamma
        contacts = self.system._all_contacts(state[:beads])
        stiffness = 1.5 * np.sqrt(np.maximum(contacts, 0.0))
        if not self.system.ring:
            stiffness[[0, -1]] = 0.0
        lower, upper = stiffness[:-1], stiffness[1:]
        rows = np.concatenate([lower, -lower - upper, upper])
        return np.concatenate([gamma * rows, np.ones(beads), rows])[self._order]

    def matrix(self, state):
        """Return the matrix at a state."""
        return self._matrix(self.values(state))

    def _matrix(self, values):
        return csc_array((values, self._indices, self._starts))


@cache
def compiled_kernel():
    """Return the numba kernel (state, out, force, parameters): (x, w) to its derivative."""
    import numba

    @numba.njit(error_model="numpy")
    def kernel(state, out, force, gamma, left, is_ring, turn):
        # Slices that start at zero let the compiler use contiguous vector loads.
        beads = state.size // 2
        before, after, momenta = state[: beads - 1], state[1:beads], state[beads:]
        position_rate, momentum_rate = out[:beads], out[beads:]
        inner = force[1:beads]
        for n in range(beads - 1):
            compression = max(before[n] - after[n], 0.0)
            inner[n] = compression * np.sqrt(compression)
        closing = max(turn - (state[0] - state[beads - 1]), 0.0) if is_ring else 0.0
        first = closing if is_ring else left
        force[0] = first * np.sqrt(first)
        force[beads] = closing * np.sqrt(closing)
        behind, ahead = force[:beads], force[1:]
        for n in range(beads):
            difference = behind[n] - ahead[n]
            momentum_rate[n] = difference
            position_rate[n] = momenta[n] + gamma * difference

    return kernel


def kernel_parameters(system):
    """Return what the kernel takes after its arrays."""
    return system.gamma, system.left, float(system.ring), system.turn
