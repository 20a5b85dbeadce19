"""Long-double reference states of the granular chain of James (2021), section 3.3.

Beads n = 1 … N obey eqs. (31)–(32) of G. James, Nonlinearity 34 (2021) 1758, with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

where u_n = x_n - x_{n+1}. The left end is pressed (u_0 = δ), the right end is free (u_N = 0), and
the chain is at rest and just touching at t = 0.

`granular_fronts.reference_methods.extended` integrates them in 80-bit arithmetic; the error of a
state is its change by a tolerance ten times larger.  Positions up to 40 leave no smaller ones.

Run ``python make_chain_reference.py --help`` for the command line.
"""

import argparse
from pathlib import Path

import numpy as np
import xarray as xr
from stored_states import REFERENCES, store

from granular_fronts.reference_methods.extended import OTHER_TOLERANCE, REAL, Motion

BEADS = 420
DELTA = 0.1
CASES = {0.06: (700.0, 2600.0, 3000.0), 0.65: (700.0,)}


def solve(gamma, times, tolerance):
    """Return (u_1 … u_N, x_1' … x_N') at each time."""
    scene = {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": gamma},
        "beads": BEADS,
        "boundary": {"kind": "pressure", "left": DELTA, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": times[-1],
    }
    u, velocity = Motion(scene, tolerance).states(times)
    return list(zip(np.pad(u, [(0, 0), (0, 1)]), velocity, strict=True))


def momentum_defect(instant, velocity):
    """Return Σ x_n' - δ^{3/2} t, which the exact solution keeps at zero."""
    return float(velocity.sum() - REAL(DELTA) * np.sqrt(REAL(DELTA)) * REAL(instant))


def read_arguments():
    """Return the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "chain_reference.nc")
    parser.add_argument(
        "--until", type=float, default=3000.0, help="leave out later states (700: a few minutes)"
    )
    return parser.parse_args()


def main():
    """Compute all states and write them."""
    arguments = read_arguments()
    places, kept, again = [], [], []
    for gamma, times in CASES.items():
        times = [instant for instant in times if instant <= arguments.until]
        places += [(gamma, instant) for instant in times]
        kept += solve(gamma, times, OTHER_TOLERANCE)
        again += solve(gamma, times, 10 * OTHER_TOLERANCE)
    gammas, instants = zip(*places, strict=True)
    data = xr.Dataset(
        coords={
            "t": ("state", list(instants)),
            "bead": np.arange(1, BEADS + 1),
            "gamma": ("state", list(gammas)),
        },
        attrs={
            "title": "Long-double reference states of the front initiation, James (2021), sec. 3.3",
            "source": "tools/references/make_chain_reference.py",
            "problem": "alpha = beta = 3/2, N = 420, delta = 0.1, u_0 = delta, u_N = 0 (free end); "
            "at t = 0 all u_n = 0 and all velocities 0; delta and gamma are the double values",
            "versions": f"numpy {np.__version__}, xarray {xr.__version__}",
            "error_method": "largest difference from a run with another tolerance",
        },
    )
    store(data, kept, again)
    defects = map(momentum_defect, instants, (velocity for _, velocity in kept))
    data["momentum_defect"] = "state", list(defects)
    data.to_netcdf(arguments.output)


if __name__ == "__main__":
    main()
