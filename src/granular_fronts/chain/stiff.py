r"""Implicit steps for strong damping, where stability and not accuracy limits an explicit method.

Stiffness.  The damping has eigenvalues down to :math:`-4G'(u)`, and an explicit step must stay
below about six divided by that.  The front meanwhile is wide and smooth; it moves by one contact in
a time :math:`(F(u)/u)^{-1/2}`, eq. (14) for a chain uncompressed ahead of it.  The product

.. math:: S = 4 G'(u) \sqrt{\frac{u}{F(u)}}
        = 4\beta\gamma\, u^{\beta-1}\, u^{(1-\alpha)/2} \quad\text{for the law (28)}

is the number of explicit steps an accurate step is cut into. Measured on chains of 420 beads
(target `stiff_damping`), the implicit steps (`implicit_step`) win in proportion to S. At S = 17
they lose, at S = 67 they win at moderate accuracy and draw at errors of 1e-12; `STIFF` stands a
little higher, where they win at all of them.

Step size.  The end point is compared with the polynomial through the start and the other stages, a
difference of order 5.  The end point itself is far better: relative to the largest compression, its
error in fronts and transients stays below the difference to the power `POWER`.  What a run says of
its accuracy comes from a second run, as for the explicit pair.

Limits.  Steps end on every output, since the polynomial of the stages is of order 6 only; a contact
that opens or closes, a crowd of outputs, or a Newton iteration that fails sends the run back to the
explicit pair.  Rings, pistons, arrivals and extremes are left to it altogether.
"""

import math
from typing import NamedTuple

from granular_fronts.chain import equations
from granular_fronts.chain.contact_events import passes_any_kink
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
from granular_fronts.chain.integrator import FINISHED, RUNNING, begin
from granular_fronts.chain.recorder import next_output
from granular_fronts.chain.state import D, U
from granular_fronts.chain.strain import end_of_window
from granular_fronts.numerics.compiled import kernel, subroutine
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


def stiffness(law, u):
    """S, the explicit steps that stability asks for per contact that the front passes."""
    force = equations.force(law.elastic, u)
    if u * force <= 0.0:
        return 0.0
    return float(damping_rate(law, u) * math.sqrt(u / force))


def damping_rate(law, u):
    """Largest damping rate 4G'(u)."""
    return 4.0 * float(law.viscous.second(-u))


def suits(run, stiff_from=STIFF):
    """Whether the implicit steps serve a run, and are expected to win.

    Parameters
    ----------
    run : chain.run.Run
    stiff_from : float, optional
        Stiffness from which they win.
    """
    recording = run.recording
    return (
        not run.boundary.ring
        and not run.boundary.piston
        and not recording.track_extremes
        and math.isnan(recording.level)
        and max(stiffness(run.law, u) for u in _range(run)) >= stiff_from
    )


def _range(run):
    """Smallest and largest compression of all contacts, held ones included."""
    moving = run.table[U, 1 : run.chain.contacts + 1]
    held = run.boundary.left, run.boundary.right
    return min(*held, moving.min()), max(*held, moving.max())


class ImplicitSteps:
    """Implicit steps of a run, with their memory of the last one.

    Parameters
    ----------
    run : chain.run.Run
    """

    def __init__(self, run):
        self._held = max(abs(run.boundary.left), abs(run.boundary.right))
        self._work = make_workspace(run.law, run.table.shape[1])

    def advance(self, run, tolerance):
        """Take implicit steps of the run as long as they serve.

        Parameters
        ----------
        run : chain.run.Run
        tolerance : mapping
            `relative` and `absolute`.

        Returns
        -------
        int
            FINISHED, or RUNNING where the explicit pair must go on.
        """
        rate = max(damping_rate(run.law, u) for u in _range(run))
        explicit_step = EXPLICIT_REACH / rate if rate > 0.0 else math.inf
        needs = Needs(
            float(tolerance["relative"]),
            float(tolerance["absolute"]),
            EXPLICIT_STEPS_BETWEEN_OUTPUTS * explicit_step,
            self._held,
        )
        self._work.steps.last = 0.0
        return advance(run.chain, run.table, run.recording, self._work, needs)


class Needs(NamedTuple):
    """What implicit steps must keep to.

    Attributes
    ----------
    relative, absolute : float
        Tolerance.
    shortest_gap : float
        Outputs closer than this end the implicit steps.
    largest_u : float
        Scale of u where the chain itself is still uncompressed: the largest held displacement.
    """

    relative: float
    absolute: float
    shortest_gap: float
    largest_u: float


@subroutine
def write_output(table, t, reach, recording):
    """Profiles and samples due at t."""
    next_ = recording.next
    while (
        next_.profile < recording.profile_times.size and recording.profile_times[next_.profile] <= t
    ):
        for n in range(1, reach + 1):
            recording.profile_u[next_.profile, n] = table[U, n]
            recording.profile_d[next_.profile, n] = table[D, n]
        next_.profile += 1
    while next_.sample < recording.sample_times.size and recording.sample_times[next_.sample] <= t:
        recording.samples[next_.sample] = table[U, recording.sample_beads[next_.sample]]
        next_.sample += 1


@subroutine
def largest_compression(chain, table, last, held):
    """Largest u of the contacts 1 … last and of those held; of |u| if the law acts in extension."""
    largest = held
    for n in range(1, last + 1):
        largest = max(largest, table[U, n], -chain.law.attraction * table[U, n])
    return largest


@kernel
def advance(chain, table, recording, work, needs):
    """Integrate until the last stop, or until the explicit pair is the better choice.

    Returns
    -------
    int
        FINISHED, or RUNNING where the explicit pair must go on.
    """
    clock, next_, stops, steps = chain.clock, recording.next, recording.stops, work.steps
    status = RUNNING
    rejected = False
    while True:
        if next_.stop == stops.size:
            status = FINISHED
            break
        t, reach = clock.t, clock.reach
        last = min(reach, chain.contacts)
        target = min(stops[next_.stop], next_output(recording))
        if target - t < needs.shortest_gap or steps.next < SHORTEST_STEP:
            break
        wanted = min(steps.next, steps.longest)
        landing = t + wanted >= target
        h = target - t if landing else wanted
        scale = largest_compression(chain, table, last, needs.largest_u)
        if scale == 0.0:
            break
        tolerance = needs.absolute + needs.relative * scale
        predict(table, work, h, reach)
        allowed = Allowed(NEWTON_SHARE * tolerance, ROUNDING * scale)
        iterations, converged = iterate(chain, table, work, h, allowed, reach)
        clock.right_hand_sides += STAGES * iterations
        if not converged:
            clock.rejected += 1
            rejected = True
            steps.next, steps.longest = 0.5 * h, AFTER_FAILURE * h
            continue
        error = scale / tolerance * (estimate(chain, table, work, reach) / scale) ** POWER
        factor = LARGEST_FACTOR
        if error > 0.0:
            factor = min(LARGEST_FACTOR, max(SMALLEST_FACTOR, SAFETY * error ** (-0.2 / POWER)))
        if error > 1.0:
            clock.rejected += 1
            rejected = True
            steps.next = h * factor
            continue
        evaluate_forces(chain, table, work, reach)
        finish(table, work, h, reach)
        if passes_any_kink(chain, table, last):
            break
        if recording.track_energy:
            clock.dissipated += dissipated_energy(chain, work, h, reach)
        accept(table, work, h, reach)
        clock.t = target if landing else t + h
        write_output(table, clock.t, reach, recording)
        clock.reach = max(reach, end_of_window(chain, table, last))
        clock.accepted += 1
        clock.implicit += 1
        if stops[next_.stop] <= clock.t:
            next_.stop += 1
        slow = rejected or iterations > MANY_ITERATIONS
        grown = h * (min(1.0, factor) if slow else factor)
        steps.next = max(grown, steps.next) if landing else grown
        steps.longest *= RECOVERY
        rejected = False
        if interrupted():
            break
    begin(chain, table)
    return status
