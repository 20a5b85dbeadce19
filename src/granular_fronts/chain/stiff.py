r"""Implicit steps for strong damping, where stability and not accuracy limits an explicit method.

Stiffness.  The damping has eigenvalues down to :math:`-4\beta\gamma u^{\beta-1}`, and an explicit
step must stay below about six divided by that.  The front meanwhile is wide and smooth; it moves by
one contact in a time :math:`u^{(1-\alpha)/2}`.  The product

.. math:: S = 4\beta\gamma\, u^{\beta-1}\, u^{(1-\alpha)/2}

tells how many explicit steps an accurate step is cut into.  Measured on chains of 420 beads (target
`stiff_damping`), the implicit steps (`implicit_step`) win in proportion to S.  At S = 17 they lose,
at S = 67 they win at moderate accuracy and draw at errors of 1e-12; `STIFF` stands a little higher,
where they win at all of them.

Step size.  The end point is compared with the polynomial through the start and the other stages, a
difference of order 5.  The end point itself is far better: relative to the largest compression, its
error in fronts and transients stays below the difference to the power `POWER`.  What a run says of
its accuracy comes from a second run, as for the explicit pair.

Limits.  Steps end on every output, since the polynomial of the stages is of order 6 only; a contact
that opens or closes, a crowd of outputs, or a Newton iteration that fails sends the run back to the
explicit pair.  Rings, pistons, arrivals and extremes are left to it altogether.
"""

import math

from granular_fronts.chain.contact_events import changes_sign
from granular_fronts.chain.implicit_step import (
    Allowed,
    accept,
    dissipated_energy,
    estimate,
    evaluate_forces,
    finish,
    iterate,
    make_workspace,
    predict,
)
from granular_fronts.chain.integrator import (
    ACCEPTED,
    FINISHED,
    IMPLICIT,
    PROFILE,
    REJECTED,
    RUNNING,
    SAMPLE,
    STAGE_COUNT,
    STOP,
    next_output,
)
from granular_fronts.chain.strain import evaluate_slopes, reach_of
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.radau import STAGES

STIFF = 80.0
# Outputs closer together than this many explicit steps are left to the explicit pair.
EXPLICIT_STEPS_BETWEEN_OUTPUTS = 10.0
EXPLICIT_REACH = 6.0

NEWTON_SHARE, ROUNDING = 0.01, 1.0e-14
MANY_ITERATIONS = 8
# A step at which Newton's iteration failed bounds the next ones, by less with every success.
AFTER_FAILURE, RECOVERY = 0.7, 1.02
POWER = 1.5
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.85, 0.2, 5.0
SHORTEST_STEP = 1.0e-9


def stiffness(law, compression):
    """S, the explicit steps that stability asks for per contact that the front passes."""
    if law.gamma == 0.0 or compression <= 0.0:
        return 0.0
    return compression ** ((1.0 - law.alpha) / 2.0) * damping_rate(law, compression)


def damping_rate(law, compression):
    """Largest damping rate 4βγ u^(β − 1)."""
    return 4.0 * law.beta * law.gamma * compression ** (law.beta - 1.0)


def suits(run, stiff_from=STIFF):
    """Whether the implicit steps serve a run, and are expected to win.

    Parameters
    ----------
    run : chain.run.Run
    stiff_from : float, optional
        Stiffness from which they win.
    """
    recording, last = run.recording, run.size.contacts + 1
    compression = max(run.boundary.left, run.boundary.right, run.state.u[1:last].max())
    return (
        not run.boundary.ring
        and not run.boundary.piston
        and not recording.track_extremes
        and math.isnan(recording.level)
        and stiffness(run.law, compression) >= stiff_from
    )


def make_advance(run, relative, absolute):
    """The function that takes implicit steps of a run as long as they serve.

    Returns
    -------
    callable
        Without arguments; gives FINISHED, or RUNNING where the explicit pair must go on.
    """
    held = max(run.boundary.left, run.boundary.right)
    work = make_workspace(run.state.u.size)

    def advance_run():
        scale = max(held, run.state.u[1 : run.size.contacts + 1].max())
        explicit_step = EXPLICIT_REACH / damping_rate(run.law, scale)
        gap = EXPLICIT_STEPS_BETWEEN_OUTPUTS * explicit_step
        work.step[1] = 0.0
        return advance(
            run.law,
            run.size,
            run.state,
            run.clock,
            relative,
            absolute,
            run.recording,
            work,
            gap,
            held,
        )

    return advance_run


@kernel
def write_output(state, t, reach, recording):
    """Profiles and samples due at t."""
    cursor = recording.cursor
    while (
        cursor[PROFILE] < recording.profile_times.size
        and recording.profile_times[cursor[PROFILE]] <= t
    ):
        for n in range(1, reach + 1):
            recording.profile_u[cursor[PROFILE], n] = state.u[n]
            recording.profile_d[cursor[PROFILE], n] = state.d[n]
        cursor[PROFILE] += 1
    while (
        cursor[SAMPLE] < recording.sample_times.size and recording.sample_times[cursor[SAMPLE]] <= t
    ):
        recording.samples[cursor[SAMPLE]] = state.u[recording.sample_beads[cursor[SAMPLE]]]
        cursor[SAMPLE] += 1


@kernel
def advance(law, size, state, clock, relative, absolute, recording, work, shortest_gap, largest_u):
    """Integrate until the last stop, or until the explicit pair is the better choice.

    Parameters
    ----------
    shortest_gap : float
        Outputs closer than this end the implicit steps.
    largest_u : float
        Scale of u where the chain itself is still uncompressed: the largest held displacement.

    Returns
    -------
    int
        FINISHED, or RUNNING where the explicit pair must go on.
    """
    counts, cursor, stops, reach = clock.counts, recording.cursor, recording.stops, clock.reach[0]
    status = RUNNING
    rejected = False
    while True:
        if cursor[STOP] == stops.size:
            status = FINISHED
            break
        t = clock.t[0]
        target = min(stops[cursor[STOP]], next_output(recording))
        if target - t < shortest_gap or work.step[0] < SHORTEST_STEP:
            break
        wanted = min(work.step[0], work.step[2])
        landing = t + wanted >= target
        h = target - t if landing else wanted
        scale = max(largest_u, state.u[1 : min(reach, size.contacts) + 1].max())
        tolerance = absolute + relative * scale
        predict(state, work, h, reach)
        allowed = Allowed(NEWTON_SHARE * tolerance, ROUNDING * scale)
        iterations, converged = iterate(law, size, state, work, h, allowed, reach)
        counts[STAGE_COUNT] += STAGES * iterations
        if not converged:
            counts[REJECTED] += 1
            rejected = True
            work.step[0], work.step[2] = 0.5 * h, AFTER_FAILURE * h
            continue
        error = scale / tolerance * (estimate(size, state, work, reach) / scale) ** POWER
        factor = LARGEST_FACTOR
        if error > 0.0:
            factor = min(LARGEST_FACTOR, max(SMALLEST_FACTOR, SAFETY * error ** (-0.2 / POWER)))
        if error > 1.0:
            counts[REJECTED] += 1
            rejected = True
            work.step[0] = h * factor
            continue
        evaluate_forces(law, size, state, work, reach)
        finish(state, work, h, reach)
        if changes_sign(state, min(reach, size.contacts)):
            break
        if recording.track_energy:
            clock.dissipated[0] += dissipated_energy(law, work, h, reach)
        accept(state, work, h, reach)
        clock.t[0] = target if landing else t + h
        write_output(state, clock.t[0], reach, recording)
        reach = max(reach, reach_of(size, state.u, state.d, reach))
        counts[ACCEPTED] += 1
        counts[IMPLICIT] += 1
        if stops[cursor[STOP]] <= clock.t[0]:
            cursor[STOP] += 1
        hesitates = rejected or iterations > MANY_ITERATIONS
        grown = h * (min(1.0, factor) if hesitates else factor)
        work.step[0] = max(grown, work.step[0]) if landing else grown
        work.step[2] *= RECOVERY
        rejected = False
        if interrupted():
            break
    clock.reach[0] = reach
    evaluate_slopes(law, size, state, state.u, 0, reach)
    return status
