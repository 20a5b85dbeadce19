"""Front initiation of James (2021), section 3.3, up to a stored long-double state.

An absolute tolerance is a hundredth of the relative one for every method.
"""

from functools import partial

from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare
from peers import diffrax_chain, lammps_chain, numbalsoda_chain, scilab_chain, scipy_chain
from peers.chain_system import ChainSystem
from peers.runs import Run, Stopwatch
from problems.problem import FIELDS, Problem, stored_answers

ABSOLUTE_OVER_RELATIVE = 1.0e-2
PEERS = {
    **scilab_chain.METHODS,
    **scipy_chain.METHODS,
    **numbalsoda_chain.METHODS,
    **diffrax_chain.METHODS,
    **lammps_chain.METHODS,
}


def make_chain(settings, states):
    """Return a driven chain with its stored state."""
    gamma, end = settings["gamma"], settings["end_time"]
    system = ChainSystem(gamma, end)
    methods = {
        "strain_form": partial(_run_strain_form, system),
        **{name: partial(_run_peer, solve, system) for name, solve in PEERS.items()},
    }
    return Problem(stored_answers(states, gamma=gamma, t=end), methods)


def _run_peer(solve, system, tolerance):
    """Somebody else's integrator."""
    return solve(system, tolerance, ABSOLUTE_OVER_RELATIVE * tolerance)


def _run_strain_form(system, tolerance):
    """Our integrator."""
    run = prepare(system.scene())
    with Stopwatch() as watch:
        integrate(run, {"relative": tolerance, "absolute": ABSOLUTE_OVER_RELATIVE * tolerance})
    final = collect(run).dataset.isel(t=-1)
    return Run({name: final[name].values for name in FIELDS}, **watch.times)
