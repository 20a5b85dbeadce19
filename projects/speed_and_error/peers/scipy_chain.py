"""SciPy's DOP853 on the chain, with a numpy right-hand side.

`solve_ivp` raises a relative tolerance below 100 units of round-off with no more than a warning.
"""

import numpy as np
from scipy.integrate import solve_ivp

from peers.runs import Run, Stopwatch

RTOL_FLOOR = 100 * np.finfo(float).eps


def _make_right_hand_side(system):
    """Return f(t, state) in vectorised numpy; it works in buffers of its own."""
    beads, gamma = system.beads, system.gamma
    contacts, roots = np.zeros(beads + 1), np.empty(beads + 1)
    contacts[0] = system.left

    def right_hand_side(_, state):
        out = np.empty_like(state)
        np.subtract(state[: beads - 1], state[1:beads], out=contacts[1:-1])
        np.maximum(contacts, 0.0, out=roots)
        np.sqrt(roots, out=roots)
        # The held contact keeps its compression: the force goes to another buffer.
        forces = np.multiply(contacts, roots)
        momentum_rate = out[beads:]
        np.subtract(forces[:-1], forces[1:], out=momentum_rate)
        np.multiply(momentum_rate, gamma, out=out[:beads])
        out[:beads] += state[beads:]
        return out

    return right_hand_side


def run_dop853(system, rtol, atol):
    """Run SciPy's DOP853."""
    right_hand_side = _make_right_hand_side(system)
    raised = rtol < RTOL_FLOOR
    with Stopwatch() as watch:
        answer = solve_ivp(
            right_hand_side,
            (0.0, system.end),
            system.start(),
            "DOP853",
            t_eval=[system.end],
            rtol=max(rtol, RTOL_FLOOR),
            atol=atol,
        )
    if not answer.success:
        return Run(message=f"solve_ivp stopped: {answer.message}")
    message = f"rtol raised to {RTOL_FLOOR:.1e}" if raised else ""
    fields = system.observe(answer.y[:, -1])
    return Run(fields, **watch.times, right_hand_sides=answer.nfev, message=message)


METHODS = {"scipy_dop853": run_dop853}
