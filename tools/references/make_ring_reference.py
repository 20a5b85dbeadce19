"""Long-double reference states of the ring of James (2021), section 4.3, α = β = 3/2.

The N = 2p − 1 = 159 beads of the ring obey the equations of `make_chain_reference` with u_0 = u_N,
eq. (26), and are integrated by `extrapolation`.  With c = δ^{1/4}, ε = 1/(3γc), γ = 0.24 and δ = 5
they start from

    u_n = δ y(ε(n − p))^{2/3},   x_n' = δ^{5/4} y(ε(n − p)),
    y(ξ) = 1 for |ξ| ≤ 10,   max(1 − (|ξ| − 10)², 10⁻⁷) beyond,                             (49)

evaluated in double precision; the doubles, extended exactly, are the problem, and are stored.

All N contacts are unknowns.  Their sum, which the equations keep, is left to the method as a check;
so is Σ x_n'.

Run ``python make_ring_reference.py --help`` for the command line.
"""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
from extrapolation import REAL, Flow, Settings, require_extended_precision
from stored_states import REFERENCES, build_dataset, solve_case

HALF_BEADS, GAMMA, DELTA = 80, 0.24, 5.0
HALF_WIDTH, FLOOR = 10.0, 1.0e-7
TIMES = (41.12, 90.0)

# Values up to 9, and forces up to 11, where the chain's stay below 0.2: a larger unit of round-off.
EVERY_SETTINGS = (
    Settings((2, 4, 6, 8, 12, 16, 24, 32), 2e-17, 1e-21),
    Settings((2, 4, 6, 8, 10, 12, 14, 16), 4e-17, 1e-20),
    Settings((2, 4, 6, 8, 10, 12, 14), 1e-16, 1e-19),
)


class Ring(Flow):
    """Right-hand side of the ring in (u_1 … u_N, w_1 … w_N), from u_n and x_n' in doubles."""

    def __init__(self, contacts, velocities):
        super().__init__(GAMMA)
        self.contacts = contacts.size
        self.initial = contacts.astype(REAL), velocities.astype(REAL)

    def start(self):
        """Return the packed start."""
        contacts, velocities = self.initial
        state = np.concatenate([contacts, velocities])
        momentum_rate, _ = self.rates(state)
        state[self.contacts :] -= self.gamma * momentum_rate
        return state

    def rates(self, state):
        """Return (w', x') for a packed state."""
        contact, momentum = self.split(state)
        force = np.maximum(contact, 0)
        force *= np.sqrt(force)
        momentum_rate = np.roll(force, 1) - force
        return momentum_rate, momentum + self.gamma * momentum_rate

    def derivative(self, state):
        """Return the time derivative of a packed state."""
        self.evaluations += 1
        momentum_rate, velocity = self.rates(state)
        return np.concatenate([velocity - np.roll(velocity, -1), momentum_rate])

    def finish(self, state):
        """Return (u_1 … u_N, x_1' … x_N')."""
        return self.split(state)[0].copy(), self.rates(state)[1]


def initial_state():
    """Return (u_n, x_n') at t = 0 in double precision."""
    speed = DELTA**0.25
    xi = (np.arange(1, 2 * HALF_BEADS) - HALF_BEADS) / (3.0 * GAMMA * speed)
    beyond = np.maximum(np.abs(xi) - HALF_WIDTH, 0.0)
    force = np.maximum(1.0 - beyond**2, FLOOR)
    return DELTA * force ** (2.0 / 3.0), DELTA * speed * force


def main():
    """Compute all states and write them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "ring_reference.nc")
    output = parser.parse_args().output
    require_extended_precision()
    start = initial_state()
    rows, log = solve_case(lambda: Ring(*start), TIMES, EVERY_SETTINGS)
    for row in rows:
        u, velocity = row["state"]
        drifts = [float(np.sum(now - then)) for now, then in ((u, start[0]), (velocity, start[1]))]
        print(f"t {row['t']}  errors {row['errors']}  drifts of the sums {drifts}")
    print(log)
    data = build_dataset(
        rows,
        [log],
        title="Long-double reference states of the ring, James (2021), sec. 4.3, alpha = 3/2",
        source="tools/references/make_ring_reference.py",
        problem="alpha = beta = 3/2, N = 159, gamma = 0.24 (the double), u_0 = u_N (ring); "
        "the start is stored as <name>_start",
        settings=json.dumps([asdict(settings) for settings in EVERY_SETTINGS]),
    ).assign_coords(gamma=GAMMA)
    for name, values in zip(("relative_displacement", "velocity"), start, strict=True):
        data[f"{name}_start"] = ("bead", values, {"long_name": f"{name} at t = 0", "units": "1"})
    data.to_netcdf(output)


if __name__ == "__main__":
    main()
