"""SciPy's integrators on the chain.

`solve_ivp` calls a numpy right-hand side; Radau is given the sparse Jacobian, without which each of
its factorisations would be dense. `odeint` is LSODA again, on a compiled right-hand side.

Traps met: LSODA may change to its stiff method, whose Jacobian is dense and made by differences.
After contact loss, at t = 3000, it did, and a solve of two seconds took 7 minutes (rtol 1e-13).
`solve_ivp` raises a relative tolerance below 100 units of round-off with no more than a warning.
"""

from functools import cache, partial

import numpy as np
from scipy.integrate import odeint, solve_ivp

from peers.chain_system import (
    STEP_LIMIT,
    SparseJacobian,
    compiled_kernel,
    kernel_parameters,
    numpy_right_hand_side,
)
from peers.runs import Run, Stopwatch

RTOL_FLOOR = 100 * np.finfo(float).eps


def _run_solve_ivp(system, rtol, atol, method):
    """Run one method of SciPy's solve_ivp."""
    fill = numpy_right_hand_side(system)

    def right_hand_side(_, state):
        out = np.empty_like(state)
        fill(state, out)
        return out

    options = {}
    if method == "Radau":
        jacobian = SparseJacobian(system)
        options["jac"] = lambda _, state: jacobian.matrix(state)
    raised = rtol < RTOL_FLOOR
    with Stopwatch() as watch:
        answer = solve_ivp(
            right_hand_side,
            (0.0, system.end),
            system.start(),
            method,
            t_eval=[system.end],
            rtol=max(rtol, RTOL_FLOOR),
            atol=atol,
            **options,
        )
    if not answer.success:
        return Run(message=f"solve_ivp stopped: {answer.message}")
    message = f"rtol raised to {RTOL_FLOOR:.1e}" if raised else ""
    fields = system.observe(answer.y[:, -1])
    return Run(fields, **watch.times, right_hand_sides=answer.nfev, message=message)


@cache
def _compiled_odeint_function():
    """Return the numba function f(y, t, force, …) for SciPy's odeint."""
    import numba

    kernel = compiled_kernel()

    @numba.njit
    def right_hand_side(state, _, force, gamma, left, is_ring, turn):
        out = np.empty_like(state)
        kernel(state, out, force, gamma, left, is_ring, turn)
        return out

    return right_hand_side


def _run_odeint(system, rtol, atol):
    """Run SciPy's odeint on a compiled right-hand side."""
    function = _compiled_odeint_function()
    extra = (np.zeros(system.beads + 1), *kernel_parameters(system))
    function(system.start(), 0.0, *extra)
    with Stopwatch() as watch:
        states, log = odeint(
            function,
            system.start(),
            np.array([0.0, system.end]),
            args=extra,
            rtol=rtol,
            atol=atol,
            mxstep=STEP_LIMIT,
            full_output=True,
        )
    if log["message"] != "Integration successful.":
        return Run(message=f"odeint stopped: {log['message']}")
    message = "changed to the stiff method" if log["mused"][-1] == 2 else ""
    work = {"right_hand_sides": log["nfe"][-1], "steps": log["nst"][-1]}
    return Run(system.observe(states[-1]), **watch.times, **work, message=message)


METHODS = {
    "scipy_rk45": partial(_run_solve_ivp, method="RK45"),
    "scipy_dop853": partial(_run_solve_ivp, method="DOP853"),
    "scipy_lsoda": partial(_run_solve_ivp, method="LSODA"),
    "scipy_radau": partial(_run_solve_ivp, method="Radau"),
    "scipy_odeint": _run_odeint,
}
