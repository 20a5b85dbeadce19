"""Long-double reference states of the granular chain of James (2021), section 3.3.

Beads n = 1 … N obey eqs. (31)–(32) of G. James, Nonlinearity 34 (2021) 1758, with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

where u_n = x_n - x_{n+1}. The left end is pressed (u_0 = δ), the right end is free (u_N = 0), and
the chain is at rest and just touching at t = 0: u_n = 0 and x_n' = 0, so that w_1 = -γ F(δ) and
all other w_n = 0.

The unknowns are (u_n, w_n), with u_n' = x_n' - x_{n+1}'. `extrapolation` integrates them in 80-bit
arithmetic; `stored_states` says how errors are found.

Run ``python make_chain_reference.py --help`` for the command line.
"""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
from extrapolation import REAL, Flow, Settings, require_extended_precision
from stored_states import REFERENCES, build_dataset, solve_case

BEADS = 420
DELTA = 0.1
NEGLIGIBLE = REAL("1e-60")
WINDOW_MARGIN = 8
CASES = {0.06: (700.0, 2600.0, 3000.0), 0.65: (700.0,)}
# More columns would cost less work but enlarge round-off: the weights of ten columns sum to 150.
EVERY_SETTINGS = (
    Settings((2, 4, 6, 8, 12, 16, 24, 32), 5e-19, 1e-23),
    Settings((2, 4, 6, 8, 10, 12, 14, 16), 1e-18, 1e-22),
    Settings((2, 4, 6, 8, 10, 12, 14), 3e-18, 1e-21),
)


class Chain(Flow):
    """Right-hand side of the chain in (u_1 … u_{N-1}, w_1 … w_N), cut to the beads in motion.

    The doubles γ and δ, the compression held at the left end, extended exactly, are the problem.
    """

    def __init__(self, gamma, delta=DELTA, beads=BEADS):
        super().__init__(gamma)
        self.delta = REAL(delta)
        self.beads = beads
        self.resize(min(beads, WINDOW_MARGIN))

    def resize(self, active):
        """Keep the first `active` beads; the contact right of the last one is open."""
        self.active = active
        self.force = np.zeros(active + 1, dtype=REAL)
        self.force[0] = self.delta * np.sqrt(self.delta)

    @property
    def contacts(self):
        """Number of moving contacts, which come first in a packed state."""
        return self.active - 1

    def start(self):
        """Return the start: every contact closed without force, every bead at rest."""
        state = np.zeros(2 * self.active - 1, dtype=REAL)
        state[self.active - 1] = -self.gamma * self.force[0]
        return state

    def rates(self, state):
        """Return (w', x') for a packed state."""
        contact, momentum = self.split(state)
        inner = self.force[1:-1]
        np.maximum(contact, 0, out=inner)
        inner *= np.sqrt(inner)
        momentum_rate = self.force[:-1] - self.force[1:]
        return momentum_rate, momentum + self.gamma * momentum_rate

    def derivative(self, state):
        """Return the time derivative of a packed state."""
        self.evaluations += 1
        momentum_rate, velocity = self.rates(state)
        out = np.empty_like(state)
        np.subtract(velocity[:-1], velocity[1:], out=out[: self.active - 1])
        out[self.active - 1 :] = momentum_rate
        return out

    def regrow(self, *packed):
        """Cut negligible tails and widen the window ahead of the wave; return the new arrays."""
        parts = [[part.copy() for part in self.split(state)] for state in packed]
        contact, momentum = parts[0]
        contact[np.abs(contact) < NEGLIGIBLE] = 0
        momentum[np.abs(momentum) < NEGLIGIBLE] = 0
        moving = np.flatnonzero(contact)
        reached = moving[-1] + 2 if moving.size else 1
        wanted = min(self.beads, reached + WINDOW_MARGIN)
        if wanted <= self.active:
            return [np.concatenate(pair) for pair in parts]
        extra = np.zeros(wanted - self.active, dtype=REAL)
        self.resize(wanted)
        return [np.concatenate([u, extra, w, extra]) for u, w in parts]

    def finish(self, state):
        """Return (u_1 … u_N, x_1' … x_N') of the whole chain."""
        contact, _ = self.split(state)
        _, velocity = self.rates(state)
        whole = np.zeros((2, self.beads), dtype=REAL)
        whole[0, : contact.size] = contact
        whole[1, : velocity.size] = velocity
        return whole[0], whole[1]


def momentum_defect(instant, velocity, delta=DELTA):
    """Return Σ x_n' - δ^{3/2} t, which the exact solution keeps at zero."""
    return velocity.sum() - REAL(delta) * np.sqrt(REAL(delta)) * REAL(instant)


def read_arguments():
    """Return the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "chain_reference.nc")
    parser.add_argument(
        "--until", type=float, default=3000.0, help="leave out later states (700: fifteen seconds)"
    )
    return parser.parse_args()


def main():
    """Compute all states and write them."""
    arguments = read_arguments()
    require_extended_precision()
    rows, logs = [], []
    for gamma, times in CASES.items():
        times = [instant for instant in times if instant <= arguments.until]
        case, log = solve_case(lambda gamma=gamma: Chain(gamma), times, EVERY_SETTINGS)
        for row in case:
            row["gamma"] = gamma
            u_error, v_error = row["errors"]
            print(f"gamma {gamma}  t {row['t']:.0f}  error u {u_error:.1e}  velocity {v_error:.1e}")
        rows += case
        logs.append({"gamma": gamma, **log})
        print(log, flush=True)
    data = build_dataset(
        rows,
        logs,
        title="Long-double reference states of the front initiation, James (2021), sec. 3.3",
        source="tools/references/make_chain_reference.py",
        problem="alpha = beta = 3/2, N = 420, delta = 0.1, u_0 = delta, u_N = 0 (free end); "
        "at t = 0 all u_n = 0 and all velocities 0; delta and gamma are the double values",
        settings=json.dumps([asdict(settings) for settings in EVERY_SETTINGS]),
    )
    data = data.assign_coords(gamma=("state", [row["gamma"] for row in rows]))
    data["momentum_defect"] = (
        "state",
        [float(momentum_defect(row["t"], row["state"][1])) for row in rows],
    )
    data.to_netcdf(arguments.output)


if __name__ == "__main__":
    main()
