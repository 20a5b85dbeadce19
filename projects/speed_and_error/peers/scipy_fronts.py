"""SciPy on the exact fronts of the lattice, James (2021), section 6: shooting by its own tools.

Unknowns are u_n and d_n = w_n - w_{n+1} of a window of contacts in the frame δ = c = 1. They obey
u_n' = d_n + γ ΔF(u)_n and d_n' = ΔF(u)_n, F(u) = max(u, 0)^{3/2}, u = 1 behind the window and u = 0
ahead. `solve_ivp` (DOP853) moves them for one unit of time; then each has to be what its left
neighbour was, and u_0 = ½. `least_squares` takes all these equations; `root` wants as many as there
are unknowns, and the phase replaces the equation of the first contact. The Jacobian is made by
differences. All start from the front (46) of the logarithmic Burgers equation.
"""

from functools import partial

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import NoConvergence, least_squares, newton_krylov, root

from peers.runs import Run, Stopwatch

AHEAD = 6
FLOW_OVER_SOLVER, FLOW_FLOOR = 1e-4, 1e-13
MOST_ITERATIONS = 40


class Shooting:
    """The equations of a front.

    Parameters
    ----------
    gamma : float
    bead : ndarray of int
        Consecutive contacts that are asked for.
    behind : int
        Contacts of the window behind contact 0.
    tolerance : float
        Relative tolerance of the flow.
    """

    def __init__(self, gamma, bead, behind, tolerance):
        self.gamma, self.tolerance = gamma, tolerance
        self.bead = np.arange(-behind, bead[-1] + AHEAD + 1)
        self.stored = bead + behind
        self.flow_evaluations = 0

    def start(self):
        """(u, d) of eq. (46), u = [1 − (1 − 2^{−1/2}) e^ξ]₊², ξ = n/(3γ), and d = -u' - γ ΔF."""
        n = np.arange(self.bead[0] - 1.0, self.bead[-1] + 2.0)
        with np.errstate(over="ignore"):
            u = np.maximum(1.0 - (1.0 - 0.5**0.5) * np.exp(n / (3.0 * self.gamma)), 0.0) ** 2
        force = u**1.5
        change = force[2:] - 2.0 * force[1:-1] + force[:-2]
        return np.concatenate([u[1:-1], -np.gradient(u)[1:-1] - self.gamma * change])

    def rates(self, _, state):
        """Return the time derivative of (u, d)."""
        u, d = np.split(state, 2)
        force = np.concatenate([[1.0], np.maximum(u, 0.0), [0.0]])
        force *= np.sqrt(force)
        change = force[2:] - 2.0 * force[1:-1] + force[:-2]
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
        self.flow_evaluations += flow.nfev
        if not flow.success:
            raise ArithmeticError(f"the flow stopped: {flow.message}")
        u, d = np.split(state, 2)
        before = np.concatenate([[1.0], u[:-1], [0.0], d[:-1]])
        return np.append(flow.y[:, -1] - before, u[-self.bead[0]] - 0.5)

    def square_equations(self, state):
        """As many equations as unknowns, the phase first."""
        values = self.equations(state)
        return np.append(values[-1], values[1:-1])

    def fields(self, state):
        """Return u_n and velocities of the stored contacts."""
        u, d = np.split(state, 2)
        force = np.maximum(u, 0.0) ** 1.5
        w = np.flip(np.cumsum(np.flip(d)))
        velocity = w + self.gamma * (np.append(1.0, force[:-1]) - force)
        return {"relative_displacement": u[self.stored], "velocity": velocity[self.stored]}


def solve_least_squares(problem, tolerance):
    """Solve by Levenberg–Marquardt; return the state and why it failed."""
    answer = least_squares(
        problem.equations,
        problem.start(),
        method="lm",
        xtol=tolerance,
        ftol=tolerance,
        gtol=tolerance,
    )
    return answer.x, "" if answer.success else answer.message


def _solve_hybr(problem, tolerance):
    """Solve by Powell's hybrid method of MINPACK."""
    options = {"xtol": tolerance}
    answer = root(problem.square_equations, problem.start(), method="hybr", options=options)
    return answer.x, "" if answer.success else " ".join(answer.message.split())


def _solve_krylov(problem, tolerance):
    """Solve by Newton's method with Krylov subspaces."""
    try:
        state = newton_krylov(
            problem.square_equations, problem.start(), f_tol=tolerance, maxiter=MOST_ITERATIONS
        )
    except NoConvergence:
        return problem.start(), f"no convergence in {MOST_ITERATIONS} iterations"
    return state, ""


def _run_shooting(gamma, bead, behind, tolerance, solve):
    """Solve for a front by one of SciPy's solvers."""
    problem = Shooting(gamma, bead, behind, max(FLOW_OVER_SOLVER * tolerance, FLOW_FLOOR))
    with Stopwatch() as watch:
        state, reason = solve(problem, tolerance)
    if reason:
        return Run(message=f"{solve.__name__.removeprefix('solve_')} stopped: {reason}")
    work = {"right_hand_sides": problem.flow_evaluations}
    return Run(problem.fields(state), **watch.times, **work)


METHODS = {
    "scipy_least_squares": partial(_run_shooting, solve=solve_least_squares),
    "scipy_root_hybr": partial(_run_shooting, solve=_solve_hybr),
    "scipy_newton_krylov": partial(_run_shooting, solve=_solve_krylov),
}
