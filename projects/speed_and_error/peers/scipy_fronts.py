"""SciPy on the exact fronts of the lattice, James (2021), section 6: shooting by its own tools.

Unknowns are u_n and d_n = w_n - w_{n+1} of a window of contacts in the frame δ = c = 1. They obey
u_n' = d_n + γ ΔF(u)_n and d_n' = ΔF(u)_n, F(u) = max(u, 0)^{3/2}, u = 1 behind the window and u = 0
ahead. `solve_ivp` (DOP853) moves them for one unit of time; then each has to be what its left
neighbour was, and u_0 = ½. `least_squares` takes all these equations, with a Jacobian by
differences, from the front (46) of the logarithmic Burgers equation. `root` (hybr) is no faster,
and `newton_krylov` does not converge.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

from peers.runs import Run, Stopwatch

AHEAD = 6
FLOW_OVER_SOLVER, FLOW_FLOOR = 1e-4, 1e-13


class _Shooting:
    """The equations of a front whose consecutive contacts `bead` are asked for."""

    def __init__(self, gamma, bead, behind, tolerance):
        self.gamma, self.tolerance = gamma, tolerance
        self.bead = np.arange(-behind, bead[-1] + AHEAD + 1)
        self.stored = bead + behind

    def start(self):
        """(u, d) of eq. (46), u = [1 − (1 − 2^{−1/2}) e^ξ]₊², ξ = n/(3γ), and d = -u' - γ ΔF."""
        n = np.arange(self.bead[0] - 1.0, self.bead[-1] + 2.0)
        with np.errstate(over="ignore"):
            u = np.maximum(1.0 - (1.0 - 0.5**0.5) * np.exp(n / (3.0 * self.gamma)), 0.0) ** 2
        change = np.diff(u**1.5, 2)
        return np.concatenate([u[1:-1], -np.gradient(u)[1:-1] - self.gamma * change])

    def rates(self, _, state):
        """Return the time derivative of (u, d)."""
        u, d = np.split(state, 2)
        force = np.concatenate([[1.0], np.maximum(u, 0.0), [0.0]])
        force *= np.sqrt(force)
        change = np.diff(force, 2)
        return np.concatenate([d + self.gamma * change, change])

    def equations(self, state):
        """Return all equations, shape (2 contacts + 1,)."""
        flow = solve_ivp(
            self.rates,
            (0.0, 1.0),
            state,
            "DOP853",
            t_eval=[1.0],
            rtol=self.tolerance,
            atol=self.tolerance,
        )
        if not flow.success:
            raise ArithmeticError(f"the flow stopped: {flow.message}")
        u, d = np.split(state, 2)
        before = np.concatenate([[1.0], u[:-1], [0.0], d[:-1]])
        return np.append(flow.y[:, -1] - before, u[-self.bead[0]] - 0.5)

    def fields(self, state):
        """Return u_n and velocities of the stored contacts."""
        u, d = np.split(state, 2)
        force = np.maximum(u, 0.0) ** 1.5
        w = np.flip(np.cumsum(np.flip(d)))
        velocity = w + self.gamma * (np.append(1.0, force[:-1]) - force)
        return {"relative_displacement": u[self.stored], "velocity": velocity[self.stored]}


def solve(gamma, bead, behind, tolerance):
    """Solve for a front by Levenberg–Marquardt."""
    problem = _Shooting(gamma, bead, behind, max(FLOW_OVER_SOLVER * tolerance, FLOW_FLOOR))
    stop = dict.fromkeys(("xtol", "ftol", "gtol"), tolerance)
    with Stopwatch() as watch:
        answer = least_squares(problem.equations, problem.start(), method="lm", **stop)
    if not answer.success:
        return Run(message=f"least_squares stopped: {answer.message}")
    return Run(problem.fields(answer.x), **watch.times)


METHODS = {"scipy_least_squares": solve}
