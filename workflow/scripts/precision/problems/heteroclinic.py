"""The front of the logarithmic KdV–Burgers equation, James (2021), section 5.2.

The results are y and y' at given s.  Ours are the Taylor series traced from the tail.  For strong
damping it is the expansion of the slow manifold, which knows no tolerance.
"""

from functools import partial

import numpy as np

from granular_fronts.continuum.log_kdv_burgers.slow_manifold import STIFF_DAMPING, slow_orbit
from granular_fronts.continuum.log_kdv_burgers.traced_orbit import USUAL_STEPS, trace_orbit
from peers import scipy_heteroclinic
from peers.runs import Run, Stopwatch
from problems.problem import Problem, read_reference, stored_state


def make_problem(problem, states):
    """Return the orbit of one entry of ``precision.heteroclinic``, with its stored reference."""
    mu, s = problem["mu"], states["s"].values
    state = stored_state(states, "heteroclinic", mu=mu)
    peers = scipy_heteroclinic.METHODS.items()
    return Problem(
        ours="slow_manifold" if mu >= STIFF_DAMPING else "taylor_series",
        reference=read_reference(state, ("rescaled_force", "slope")),
        methods={
            "taylor_series": partial(_run_taylor_series, mu, s),
            "slow_manifold": partial(_run_slow_manifold, mu, s),
            **{name: partial(solve, mu, s) for name, solve in peers},
        },
    )


def _run_taylor_series(mu, s, tolerance):
    """Solve by Taylor series from the far end of the tail."""
    with Stopwatch() as watch:
        orbit = trace_orbit(mu, s[0], USUAL_STEPS._replace(tolerance=tolerance))
        p, v = orbit.evaluate(s)
    return finished(p, v, watch, orbit.counts()["steps"])


def _run_slow_manifold(mu, s, _tolerance):
    """Expand the slow manifold, for strong damping."""
    with Stopwatch() as watch:
        p, v = slow_orbit(mu).evaluate(s)
    return finished(p, v, watch, np.nan)


def finished(p, v, watch, steps):
    """Return a run that ended in p and v."""
    y = np.exp(-p)
    return Run({"rescaled_force": y, "slope": -v * y}, **watch.times, steps=steps)
