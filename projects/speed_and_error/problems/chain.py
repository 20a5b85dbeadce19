"""Front initiation of James (2021), section 3.3, up to a stored long-double state.

Our integrator solves it in strain form, and the same pair in (x, w) and (x, ẋ), without window and
event location.  An absolute tolerance is a hundredth of the relative one for every method.  For
LAMMPS, a discrete-element code, the tolerance is the step.
"""

from functools import partial

from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import (
    FIRST_STEP,
    initial_state,
    integrate,
    make_boundary,
    prepare,
    work_done,
)
from granular_fronts.numerics.runge_kutta import STAGES
from granular_fronts.reference_methods import position_forms
from granular_fronts.scenes.chain import Chain
from peers import diffrax_chain, lammps_chain, numbalsoda_chain, scilab_chain, scipy_chain
from peers.chain_system import ChainSystem
from peers.runs import Run, Stopwatch
from problems.problem import Problem, read_reference, stored_state

OURS = "strain_form"
FIELDS = ("relative_displacement", "velocity")
ABSOLUTE_OVER_RELATIVE = 1.0e-2
PEERS = {
    **scilab_chain.METHODS,
    **scipy_chain.METHODS,
    **numbalsoda_chain.METHODS,
    **diffrax_chain.METHODS,
}


def make_problem(problem, states):
    """Return the driven chain of one entry of ``precision.chain``, with its stored reference."""
    gamma, end = problem["gamma"], problem["end_time"]
    state = stored_state(states, "chain", gamma=gamma, t=end)
    system = ChainSystem(gamma, end)
    scene = {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": gamma},
        "beads": system.beads,
        "boundary": {"kind": "pressure", "left": system.left, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": end,
        "record": {"snapshots": [end]},
    }
    peers = PEERS | lammps_chain.METHODS
    forms = {"positions_and_w": position_forms.XW, "positions_and_velocities": position_forms.XV}
    methods = {
        OURS: partial(_run_strain_form, scene),
        **{name: partial(_run_plain_form, form, scene) for name, form in forms.items()},
        **{name: partial(_run_peer, solve, system) for name, solve in peers.items()},
    }
    return Problem(OURS, read_reference(state, FIELDS), methods)


def _run_peer(solve, system, tolerance):
    """Somebody else's integrator."""
    return solve(system, tolerance, ABSOLUTE_OVER_RELATIVE * tolerance)


def _run_strain_form(scene, tolerance):
    """Run our integrator."""
    run = prepare(scene)
    with Stopwatch() as watch:
        integrate(run, {"relative": tolerance, "absolute": ABSOLUTE_OVER_RELATIVE * tolerance})
    final = collect(run).dataset.isel(t=-1)
    work = work_done(run)
    return Run(
        {name: final[name].values for name in FIELDS},
        **watch.times,
        right_hand_sides=work["right_hand_sides"],
        steps=work["steps_accepted"],
    )


def _run_plain_form(form, scene, tolerance):
    """Run the same pair in (x, w) or (x, ẋ)."""
    scene = Chain.read(scene)
    law, boundary = scene.law, make_boundary(scene)
    system, y = position_forms.pack(form, law, boundary, *initial_state(scene, law, boundary))
    absolute, end = ABSOLUTE_OVER_RELATIVE * tolerance, scene.end_time
    with Stopwatch() as watch:
        y, accepted = position_forms.integrate_adaptive(
            system, y, FIRST_STEP, end, tolerance, absolute
        )
    fields = dict(zip(FIELDS, position_forms.unpack(system, y), strict=True))
    return Run(fields, **watch.times, right_hand_sides=STAGES * accepted, steps=accepted)
