"""SciPy's DOP853 on the chain, with a numpy right-hand side.

`solve_ivp` raises a relative tolerance below 100 units of round-off with no more than a warning.
"""

import numpy as np
from scipy.integrate import solve_ivp

from peers.runs import Run, Stopwatch

RTOL_FLOOR = 100 * np.finfo(float).eps


def run_dop853(system, rtol, atol):
    """Run SciPy's DOP853."""
    beads, gamma = system.beads, system.gamma
    contacts = np.zeros(beads + 1)
    contacts[0] = system.left

    def right_hand_side(_, state):
        np.subtract(state[: beads - 1], state[1:beads], out=contacts[1:-1])
        compressions = np.maximum(contacts, 0.0)
        forces = compressions * np.sqrt(compressions)
        momentum_rate = forces[:-1] - forces[1:]
        return np.concatenate([state[beads:] + gamma * momentum_rate, momentum_rate])

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
    return Run(system.observe(answer.y[:, -1]), **watch.times)


METHODS = {"scipy_dop853": run_dop853}
