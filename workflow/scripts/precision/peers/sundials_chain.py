"""CVODE of SUNDIALS (scikit-sundae) on the chain, with a numpy right-hand side.

Both methods solve for each new state by Newton's method.  They use the Jacobian and a sparse
factorisation, since the dense default costs (2N)³.
"""

import warnings
from functools import partial

import numpy as np

from peers.chain_system import STEP_LIMIT, SparseJacobian, numpy_right_hand_side
from peers.runs import Run, Stopwatch, missing_package


def _run_cvode(system, rtol, atol, method):
    """Run CVODE with Adams formulas or backward differences (BDF)."""
    absent = missing_package("sksundae")
    if absent:
        return absent
    from sksundae.cvode import CVODE

    fill, jacobian = numpy_right_hand_side(system), SparseJacobian(system)

    def fill_jacobian(_t, state, _rate, entries):
        entries[:] = jacobian.values(state)

    with warnings.catch_warnings():
        # It remarks that the pattern alone would have been enough.
        warnings.simplefilter("ignore", UserWarning)
        solver = CVODE(
            lambda _, state, out: fill(state, out),
            method=method,
            rtol=rtol,
            atol=atol,
            linsolver="sparse",
            sparsity=jacobian.pattern,
            jacfn=fill_jacobian,
            max_num_steps=STEP_LIMIT,
        )
    with Stopwatch() as watch:
        # Three times, since two would ask for every internal step.
        answer = solver.solve(np.array([0.0, 0.5, 1.0]) * system.end, system.start())
    if not answer.success:
        return Run(message=f"CVODE stopped: {answer.message}")
    return Run(system.observe(answer.y[-1]), **watch.times, right_hand_sides=answer.nfev)


METHODS = {
    "sundials_adams": partial(_run_cvode, method="Adams"),
    "sundials_bdf": partial(_run_cvode, method="BDF"),
}
