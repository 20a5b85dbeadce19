"""One integration of a scene: its arrays at t = 0, and the loop that advances them.

Rest means ẋ = 0, James (2021), section 3.3: where a boundary holds a contact compressed at t = 0,
the generalised velocity starts at w_1(0) = −γ δ^β.

A piston that rises to its velocity is integrated in two parts, since its acceleration jumps at the
end of the ramp: a step lands there, and w_1 takes up the jump (see `strain`).
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.chain import equations, integrator, stiff
from granular_fronts.chain.equations import Boundary, Piston
from granular_fronts.chain.recording import make_recording
from granular_fronts.chain.state import Law, Size, State, make_law, make_state
from granular_fronts.chain.strain import evaluate_slopes, reach_of
from granular_fronts.errors import SolveError

FIRST_STEP = 1.0e-6
STEPS_PER_BLOCK = 2000
# Where a stiff run needs the explicit pair for a while, it tries the implicit steps this often.
STEPS_BETWEEN_ATTEMPTS = 100


class Run(NamedTuple):
    """Everything that one integration works on.

    Attributes
    ----------
    law : state.Law
    size : state.Size
    boundary : equations.Boundary
    state : state.State
    clock : integrator.Clock
    recording : integrator.Recording
    momentum : float
        Σẋ_n at t = 0.
    """

    law: Law
    size: Size
    boundary: Boundary
    state: State
    clock: integrator.Clock
    recording: integrator.Recording
    momentum: float


def prepare(scene):
    """The run of a checked scene, ready at t = 0.

    Raises
    ------
    SolveError
        If the forces of the start or the boundary overflow.
    """
    law = make_law(**scene["law"])
    boundary = make_boundary(scene)
    u, velocity = initial_state(scene, boundary)
    size = make_size(scene["beads"], boundary)
    with np.errstate(over="ignore", invalid="ignore"):
        state = load_state(law, size, boundary, u, velocity)
    if not (np.isfinite(state.d).all() and np.isfinite(state.force).all()):
        raise SolveError(
            "The forces at t = 0 overflow double precision: scale the boundary values and the "
            "start down, eq. (27)."
        )
    clock = start_clock(size, state)
    evaluate_slopes(law, size, state, state.u, 0, clock.reach[0])
    record = make_recording(scene, state.u.size)
    return Run(law, size, boundary, state, clock, record, float(velocity.sum()))


def integrate(run, tolerance, after_block=lambda run: None, stiff_from=stiff.STIFF):
    """Advance a run to its end.

    Parameters
    ----------
    run : Run
    tolerance : mapping
        `relative` and `absolute`, per step, in the maximum norm over beads.
    after_block : callable, optional
        Called with the run after every `STEPS_PER_BLOCK` steps and at the end.
    stiff_from : float, optional
        Stiffness from which implicit steps are taken, infinite for never; see `chain.stiff`.

    Raises
    ------
    SolveError
        If the step size collapses, the state is no longer finite, or a contact opens for α < 1.
    """
    ramp = run.boundary.piston.ramp if run.boundary.piston else 0.0
    stops = run.recording.stops
    if 0.0 < ramp < stops[-1]:
        rising = run.recording._replace(stops=stops[stops <= ramp])
        _advance(run._replace(recording=rising), tolerance, after_block, stiff_from)
        run = end_ramp(run)
    _advance(run, tolerance, after_block, stiff_from)


def end_ramp(run):
    """The run without the acceleration of its piston, whose velocity ẋ_1 stays as it is."""
    run.state.d[1] += run.law.gamma * run.size.acceleration
    size = run.size._replace(acceleration=0.0)
    evaluate_slopes(run.law, size, run.state, run.state.u, 0, run.clock.reach[0])
    return run._replace(size=size)


def _advance(run, tolerance, after_block, stiff_from):
    """Advance a run to the last of its stops."""
    relative, absolute = float(tolerance["relative"]), float(tolerance["absolute"])
    is_stiff = stiff.suits(run, stiff_from)
    advance_stiff = stiff.make_advance(run, relative, absolute) if is_stiff else None
    steps = STEPS_BETWEEN_ATTEMPTS if is_stiff else STEPS_PER_BLOCK
    status = integrator.RUNNING
    while status == integrator.RUNNING:
        if is_stiff:
            status = advance_stiff()
        if status == integrator.RUNNING:
            status = integrator.advance(
                run.law,
                run.size,
                run.state,
                run.clock,
                relative,
                absolute,
                run.recording,
                steps,
            )
        after_block(run)
    if status != integrator.FINISHED:
        raise SolveError(_cause(status, run))


def make_boundary(scene):
    """Boundary conditions (25) or (26) of a scene, or its piston."""
    boundary = scene["boundary"]
    if boundary["kind"] == "ring":
        return Boundary(ring=True)
    if boundary["kind"] == "piston":
        piston = Piston(float(boundary["velocity"]), float(boundary.get("ramp", 0.0)))
        return Boundary(ring=False, right=float(boundary.get("right", 0.0)), piston=piston)
    return Boundary(ring=False, left=float(boundary["left"]), right=float(boundary["right"]))


def make_size(beads, boundary):
    """What the kernels need to know of the boundary."""
    if boundary.piston:
        return Size(beads, beads - 1, True, float(boundary.piston.acceleration_at(0.0)))
    return Size(beads, beads if boundary.ring else beads - 1)


def initial_state(scene, boundary):
    """Relative displacements and velocities at t = 0, both of shape (N,)."""
    beads, start = scene["beads"], scene["start"]
    u, velocity = np.zeros(beads), np.zeros(beads)
    if start["kind"] == "given":
        given = np.asarray(start["relative_displacement"], dtype=float)
        u[: given.size] = given
        velocity[:] = start["velocity"]
    elif boundary.piston:
        velocity[0] = boundary.piston.velocity_at(0.0)
    if not boundary.ring:
        u[-1] = boundary.right
    return u, velocity


def load_state(law, size, boundary, u, velocity):
    """Arrays of the integrator at t = 0, with the forces of held contacts in place."""
    state = make_state(size.beads)
    beads = slice(1, size.beads + 1)
    state.u[beads] = u
    state.d[beads] = equations.strain_rates(velocity, u, boundary, law.beta, law.gamma)
    if not boundary.ring:
        state.u[size.beads] = 0.0
        for forces, exponent in ((state.force, law.alpha), (state.damping, law.beta)):
            forces[0] = equations.force(boundary.left, exponent)
            forces[size.beads :] = equations.force(boundary.right, exponent)
    return state


def start_clock(size, state):
    """A clock at t = 0; the first step is small and grows tenfold while the error allows it."""
    return integrator.Clock(
        t=np.zeros(1),
        h=np.array([FIRST_STEP]),
        reach=np.array([_first_reach(size, state)]),
        counts=np.zeros(5, dtype=np.int64),
        dissipated=np.zeros(1),
    )


def _first_reach(size, state):
    """The whole chain unless its right part is at rest, untouched and free."""
    if size.contacts == size.beads or state.force[size.beads] > 0.0:
        return size.beads
    return reach_of(size, state.u, state.d, size.beads)


def work_done(clock):
    """Steps and right-hand sides so far, as a dict."""
    return {
        "steps_accepted": int(clock.counts[integrator.ACCEPTED]),
        "steps_rejected": int(clock.counts[integrator.REJECTED]),
        "steps_cut_at_contacts": int(clock.counts[integrator.REJECTED_AT_CONTACT]),
        "steps_implicit": int(clock.counts[integrator.IMPLICIT]),
        "right_hand_sides": int(clock.counts[integrator.STAGE_COUNT]),
    }


def _cause(status, run):
    """The sentence for a solve that stopped."""
    t, state = run.clock.t[0], run.state
    contacts = slice(1, run.size.contacts + 1)
    if status == integrator.OPENED:
        bead = 1 + int(np.argmin(state.new_u[contacts]))
        return (
            f"At t = {t:.6g} the contact of beads {bead} and {bead + 1} opens. For alpha < 1 the "
            "force is not differentiable there and the motion is not known to be unique: "
            "precompress the chain, lower the load, or end the run earlier."
        )
    if status == integrator.NOT_FINITE:
        bead = 1 + int(np.argmax(~np.isfinite(state.new_u[contacts])))
        return (
            f"At t = {t:.6g} the state of bead {bead} is not a finite number however short the "
            "step: the start or the boundary values are too large for double precision."
        )
    bead = 1 + int(np.argmax(np.abs(state.new_u[contacts] - state.u[contacts])))
    return (
        f"At t = {t:.6g} the step size collapsed to {run.clock.h[0]:.3g}, with the fastest change "
        f"at bead {bead}: the tolerance cannot be met in double precision; raise "
        "tolerance.relative or tolerance.absolute."
    )
