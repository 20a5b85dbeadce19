"""Long-double reference fronts of the lattice, James (2021), section 6, α = β = 3/2.

In the frame δ = c = 1 a front is a state of the chain that the flow over one unit of time moves on
by one contact.  With F(u) = max(u, 0)^{3/2}, Δa_n = a_{n+1} − 2a_n + a_{n−1}, d_n = w_n − w_{n+1},

    u_n' = d_n + γ ΔF(u)_n,   d_n' = ΔF(u)_n,
    u_n(1) = u_{n−1}(0),   d_n(1) = d_{n−1}(0),   u_0(0) = ½,

for the contacts −L … R of a window, u = 1 and d = 0 behind it, u = d = 0 ahead.  L is so large that
the slowest tail behind the front has died out, R so large that the double-exponential one has.

The flow is integrated by `extrapolation`.  The equations are one more than the unknowns and are
solved by Gauss-Newton's method with a Jacobian of differences, from the front (46) of the
logarithmic Burgers equation at strong damping, and from there by continuation in γ.

Each front is computed a second time, on a longer window with another flow; the largest difference
is the error stated for it.

Run ``python make_front_reference.py --help`` for the command line.
"""

import argparse
import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
import xarray as xr
from extrapolation import REAL, Flow, Settings, integrate, require_extended_precision
from stored_states import REFERENCES, largest_differences, store

DAMPINGS = (0.65, 0.1)
# On the way from one to the next.
BETWEEN = {0.1: (0.45, 0.32, 0.22, 0.15)}
KEPT = Settings((2, 4, 6, 8, 12, 16, 24, 32), 1e-18, 1e-22)
CHECK = Settings((2, 4, 6, 8, 10, 12, 14, 16), 2e-18, 1e-22)
ROUGH = Settings((2, 4, 6, 8, 10, 12), 1e-12, 1e-14)
WINDOW, LONGER_WINDOW = (-100, 14), (-112, 16)
STORED = (-30, 10)
DIFFERENCE = REAL("1e-9")
ITERATIONS = 12


class Window(Flow):
    """Right-hand side of the contacts first … last in (u, d), from a state of longdoubles."""

    def __init__(self, gamma, first, last, state):
        super().__init__(gamma)
        self.contacts = last - first + 1
        self.initial = state

    def start(self):
        """Return the start."""
        return self.initial.copy()

    def derivative(self, state):
        """Return the time derivative of (u, d)."""
        self.evaluations += 1
        u, d = self.split(state)
        force = np.concatenate([[REAL(1)], np.maximum(u, 0), [REAL(0)]])
        force *= np.sqrt(force)
        change = force[2:] - 2 * force[1:-1] + force[:-2]
        return np.concatenate([d + self.gamma * change, change])

    def finish(self, state):
        """Return (u, d)."""
        return self.split(state)


def mismatch(gamma, window, state, settings):
    """Return all equations of the front at a state."""
    (after,), _ = integrate(Window(gamma, *window, state), (1.0,), settings)
    u, d = np.split(state, 2)
    shifted_u, shifted_d = np.append(REAL(1), u[:-1]), np.append(REAL(0), d[:-1])
    return np.concatenate([after[0] - shifted_u, after[1] - shifted_d, [u[-window[0]] - REAL(0.5)]])


def solve(gamma, window, state, settings, enough):
    """Return the front near a state, once a correction is below `enough`."""
    for _ in range(ITERATIONS):
        residual = mismatch(gamma, window, state, settings)
        columns = []
        for index in range(state.size):
            moved = state.copy()
            moved[index] += DIFFERENCE
            columns.append((mismatch(gamma, window, moved, settings) - residual) / DIFFERENCE)
        jacobian = np.array(columns, dtype=float).T
        scale = np.max(np.abs(residual))
        step = np.linalg.lstsq(jacobian, (-residual / scale).astype(float), rcond=None)[0]
        state = state + scale * step.astype(REAL)
        size = float(np.max(np.abs(scale * step)))
        print(f"gamma {gamma}  residual {float(scale):.1e}  correction {size:.1e}", flush=True)
        if size < enough:
            return state
    raise ArithmeticError(f"gamma = {gamma}: corrections are still {size:.1e}.")


def burgers_front(gamma, window):
    """Return (u, d) of eq. (46), u = [1 − (1 − 2^{−1/2}) e^ξ]₊², ξ = n/(3γ)."""
    n = np.arange(window[0] - 1, window[1] + 2, dtype=REAL)
    inside = 1 - (1 - REAL(2) ** REAL(-0.5)) * np.exp(n / (3 * REAL(gamma)))
    u = np.maximum(inside, 0) ** 2
    force = u * np.sqrt(u)
    slope = np.gradient(u)[1:-1]
    change = force[2:] - 2 * force[1:-1] + force[:-2]
    return np.concatenate([u[1:-1], -slope - REAL(gamma) * change])


def extend(state, window, longer):
    """Return a state on a longer window, at rest where it is new."""
    behind, ahead = window[0] - longer[0], longer[1] - window[1]
    u, d = np.split(state, 2)
    zeros, ones = np.zeros(ahead, REAL), np.ones(behind, REAL)
    return np.concatenate([ones, u, zeros, 0 * ones, d, zeros])


def fields(gamma, window, state):
    """Return u_n and x_n' of the stored contacts."""
    u, d = np.split(state, 2)
    force = np.maximum(u, 0)
    force *= np.sqrt(force)
    w = np.cumsum(d[::-1])[::-1]
    velocity = w + REAL(gamma) * (np.append(REAL(1), force[:-1]) - force)
    stored = slice(STORED[0] - window[0], STORED[1] - window[0] + 1)
    return u[stored], velocity[stored]


def main():
    """Compute all fronts and write them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "fronts_reference.nc")
    output = parser.parse_args().output
    require_extended_precision()
    state = burgers_front(DAMPINGS[0], WINDOW)
    kept, again = [], []
    for gamma in DAMPINGS:
        for between in (*BETWEEN.get(gamma, ()), gamma):
            state = solve(between, WINDOW, state, ROUGH, 1e-6)
        front = solve(gamma, WINDOW, state, KEPT, 1e-14)
        kept.append(fields(gamma, WINDOW, front))
        longer = extend(front, WINDOW, LONGER_WINDOW)
        again.append(
            fields(gamma, LONGER_WINDOW, solve(gamma, LONGER_WINDOW, longer, CHECK, 1e-14))
        )
    data = xr.Dataset(
        coords={"gamma": ("state", list(DAMPINGS)), "bead": np.arange(STORED[0], STORED[1] + 1)},
        attrs={
            "title": "Long-double reference fronts of the lattice, James (2021), sec. 6",
            "source": "tools/references/make_front_reference.py",
            "problem": "alpha = beta = 3/2, delta = c = 1, u = 1/2 at bead 0 (its contact with 1)",
            "settings": json.dumps([asdict(settings) for settings in (KEPT, CHECK)]),
            "versions": f"numpy {np.__version__}, xarray {xr.__version__}",
            "error_method": "largest difference from a longer window with another flow",
        },
    )
    errors = [largest_differences(front, [other]) for front, other in zip(kept, again, strict=True)]
    store(data, kept, errors)
    data.to_netcdf(output)
    print(data["relative_displacement_error"].values, data["velocity_error"].values)


if __name__ == "__main__":
    main()
