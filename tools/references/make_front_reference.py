"""Long-double reference fronts of the lattice, James (2021), section 6, α = β = 3/2.

In the frame δ = c = 1 a front is a state of the chain that the flow over one unit of time moves on
by one contact.  With F(u) = max(u, 0)^{3/2}, Δa_n = a_{n+1} − 2a_n + a_{n−1}, d_n = w_n − w_{n+1},

    u_n' = d_n + γ ΔF(u)_n,   d_n' = ΔF(u)_n,
    u_n(1) = u_{n−1}(0),   d_n(1) = d_{n−1}(0),   u_0(0) = ½,

for the contacts −L … R of a window, u = 1 and d = 0 behind it, u = d = 0 ahead.  L is so large that
the slowest tail behind the front has died out, R so large that the double-exponential one has.

`granular_fronts.reference_methods.extended` integrates the flow in 80-bit arithmetic.  The
equations are one more than the unknowns and are solved by Gauss-Newton's method with a Jacobian of
differences.  It starts from the package's front, which has no part in where it ends.

Each front is computed a second time, on a longer window with another tolerance; the largest
difference is the error stated for it.

Run ``python make_front_reference.py --help`` for the command line.
"""

import argparse
from pathlib import Path

import numpy as np
import xarray as xr
from stored_states import REFERENCES, store

from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.reference_methods.extended import OTHER_TOLERANCE, REAL, TOLERANCE, Motion

DAMPINGS = (0.65, 0.1)
ROUGH = REAL("1e-12")
WINDOW, LONGER_WINDOW = (-100, 14), (-112, 16)
STORED = (-30, 10)
DIFFERENCE = REAL("1e-9")
ITERATIONS = 3


def damping(gamma, u):
    """Return γ [F(u_{n-1}) - F(u_n)] of all beads of a window."""
    force = np.maximum(np.concatenate([[REAL(1)], u, [REAL(0)]]), 0)
    force *= np.sqrt(force)
    return REAL(gamma) * (force[:-1] - force[1:])


def velocities(gamma, state):
    """Return x_n' of all beads of a window, of which the last is at rest."""
    u, d = np.split(state, 2)
    w = np.append(np.cumsum(d[::-1])[::-1], REAL(0))
    return w + damping(gamma, u)


def mismatch(gamma, middle, state, tolerance):
    """Return all equations of the front at a state, whose contact 0 is at `middle`."""
    u, d = np.split(state, 2)
    scene = {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": gamma},
        "beads": u.size + 1,
        "boundary": {"kind": "pressure", "left": 1.0, "right": 0.0},
        "start": {
            "kind": "given",
            "relative_displacement": u,
            "velocity": velocities(gamma, state),
        },
        "end_time": 1.0,
    }
    (later,), (velocity,) = Motion(scene, tolerance).states([1.0])
    w = velocity - damping(gamma, later)
    before = np.concatenate([[REAL(1)], u[:-1], [REAL(0)], d[:-1]])
    after = np.concatenate([later, w[:-1] - w[1:]])
    return np.append(after - before, u[middle] - REAL(0.5))


def solve(gamma, window, tolerance):
    """Return (u_n, x_n') of the stored contacts."""
    bead = np.arange(window[0], window[1] + 1)
    state, middle = start(gamma, bead), -window[0]
    rough = mismatch(gamma, middle, state, ROUGH)
    columns = []
    for index in range(state.size):
        moved = state.copy()
        moved[index] += DIFFERENCE
        columns.append((mismatch(gamma, middle, moved, ROUGH) - rough) / DIFFERENCE)
    jacobian = np.array(columns, dtype=float).T
    for _ in range(ITERATIONS):
        residual = mismatch(gamma, middle, state, tolerance)
        scale = np.max(np.abs(residual))
        step = np.linalg.lstsq(jacobian, (-residual / scale).astype(float), rcond=None)[0]
        state = state + scale * step.astype(REAL)
        size = float(np.max(np.abs(scale * step)))
        print(f"gamma {gamma}  residual {float(scale):.1e}  correction {size:.1e}", flush=True)
    stored = slice(STORED[0] - window[0], STORED[1] - window[0] + 1)
    return state[: bead.size][stored], velocities(gamma, state)[stored]


def start(gamma, bead):
    """Return (u, d) of the package's front."""
    front = solve_front(1.5, gamma)
    u = evaluate_front(front, bead.astype(float)).astype(REAL)
    velocity = np.append(evaluate_front(front, bead.astype(float), "velocity"), 0.0)
    w = velocity - damping(gamma, u)
    return np.concatenate([u, w[:-1] - w[1:]])


def main():
    """Compute all fronts and write them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "fronts_reference.nc")
    output = parser.parse_args().output
    data = xr.Dataset(
        coords={"gamma": ("state", list(DAMPINGS)), "bead": np.arange(STORED[0], STORED[1] + 1)},
        attrs={
            "title": "Long-double reference fronts of the lattice, James (2021), sec. 6",
            "source": "tools/references/make_front_reference.py",
            "problem": "alpha = beta = 3/2, delta = c = 1, u = 1/2 at bead 0 (its contact with 1)",
            "versions": f"numpy {np.__version__}, xarray {xr.__version__}",
            "error_method": "largest difference from a longer window with another tolerance",
        },
    )
    kept = [solve(gamma, WINDOW, TOLERANCE) for gamma in DAMPINGS]
    again = [solve(gamma, LONGER_WINDOW, OTHER_TOLERANCE) for gamma in DAMPINGS]
    store(data, kept, again)
    data.to_netcdf(output)


if __name__ == "__main__":
    main()
