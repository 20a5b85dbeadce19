"""The integrators of numbalsoda on the chain, with a compiled right-hand side.

Traps met: numbalsoda hands back what it has when it gives up (NaN from lsoda), and only its flag
shows it. Its step limit between two output times is 10 000, and lifted here. In contacts and
momenta (u, w) instead of (x, w) its dop853 was 10 % faster at errors above 1e-9 and 8 % slower
below 1e-11.  The choice of unknowns does not decide the comparison.
"""

from functools import cache, partial

import numpy as np

from peers.chain_system import STEP_LIMIT, compiled_kernel, kernel_parameters
from peers.runs import Run, Stopwatch, missing_package

# Data of the callback: calls, N, parameters of the kernel, scratch for the forces.
_HEAD = 6


@cache
def _compiled_callback():
    """Return the C callback for numbalsoda."""
    import numba
    from numbalsoda import lsoda_sig

    kernel = compiled_kernel()

    @numba.cfunc(lsoda_sig)
    def right_hand_side(_, state, out, data):
        head = numba.carray(data, _HEAD)
        beads = int(head[1])
        head[0] += 1.0
        force = numba.carray(data, _HEAD + beads + 1)[_HEAD:]
        size = 2 * beads
        parameters = (head[2], head[3], head[4], head[5])
        kernel(numba.carray(state, size), numba.carray(out, size), force, *parameters)

    return right_hand_side


def _run_numbalsoda(system, rtol, atol, solver):
    """Run one solver of numbalsoda."""
    absent = missing_package("numbalsoda")
    if absent:
        return absent
    import numbalsoda

    address = _compiled_callback().address
    data = np.zeros(_HEAD + system.beads + 1)
    data[1:_HEAD] = system.beads, *kernel_parameters(system)
    times = np.array([0.0, system.end])
    with Stopwatch() as watch:
        states, success = getattr(numbalsoda, solver)(
            address, system.start(), times, data, rtol=rtol, atol=atol, mxstep=STEP_LIMIT
        )
    if not success:
        return Run(message=f"numbalsoda.{solver} reported failure")
    return Run(system.observe(states[-1]), **watch.times, right_hand_sides=data[0])


METHODS = {
    "numbalsoda_lsoda": partial(_run_numbalsoda, solver="lsoda"),
    "numbalsoda_dop853": partial(_run_numbalsoda, solver="dop853"),
}
