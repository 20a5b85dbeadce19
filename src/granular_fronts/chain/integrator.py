r"""Adaptive integration of a chain in strain form, with output and reductions on the way.

Step control: the eighth-order pair of `numerics.runge_kutta` with error per step, in the maximum
norm over beads (`strain`), and steps that respect contact events (`contact_events`).  A
step size is rounded to the difference of two representable times, so that the clock carries no
error.

Output.  Steps land on the `stops` (snapshots, break points of a drive, the end); everything else is
read from the continuous extension (`recorder`).
"""

import math

import numpy as np

from granular_fronts.chain.contact_events import passes_any_kink, step_at_contact
from granular_fronts.chain.recorder import note_ends, record_step
from granular_fronts.chain.state import NEW_U, U
from granular_fronts.chain.strain import (
    accept,
    end_of_window,
    error_norm,
    forget_slopes,
    take_drive,
    take_slopes,
    try_step,
)
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.bits import borrowed
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted

RUNNING, FINISHED, COLLAPSED, NOT_FINITE, OPENED = range(5)

# Steps shorter than this many spacings of representable times mean that the solve has collapsed.
SHORTEST_STEP_IN_SPACINGS = 8.0

# A step is cut at a contact only if it becomes shorter by more than rounding.
LONGEST_CUT = 0.999


@kernel
def begin(chain, table):
    """Slopes and dissipated power of the state at the start of a step."""
    clock = chain.clock
    take_drive(chain, clock.t)
    clock.power = take_slopes(chain, table, U, rk.SLOT[0], clock.reach, bool(1))


@subroutine
def _growth_of(error):
    """Change of step size after an accepted step."""
    if error == 0.0:
        return rk.LARGEST_FACTOR
    factor = rk.SAFETY * error ** (rk.CAUTION * rk.ERROR_EXPONENT)
    return min(rk.LARGEST_FACTOR, factor * factor if error < rk.SMALL_ERROR else factor)


@subroutine
def _reduction_of(error):
    """Change of step size after a rejected step."""
    if math.isnan(error):
        return 0.1
    return max(rk.SMALLEST_FACTOR, min(1.0, rk.SAFETY * error**rk.ERROR_EXPONENT))


@subroutine(forceinline=True)
def _complete(chain, table, recording, h, t_new, energy):
    """Record a step that counts, and make its end the start of the next one."""
    clock, next_, reach = chain.clock, recording.next, chain.clock.reach
    last = min(reach, chain.contacts)
    clock.dissipated += energy
    take_drive(chain, t_new)
    clock.power = take_slopes(
        chain, table, NEW_U, rk.SLOT[rk.NEW_SLOPE], reach, recording.track_energy
    )
    if recording.track_extremes:
        note_ends(chain, table, 1.0, t_new, recording.largest)
        note_ends(chain, table, -1.0, t_new, recording.smallest)
    record_step(chain, table, h, t_new, recording)
    accept(chain, table, reach)
    clock.t = t_new
    clock.reach = max(reach, end_of_window(chain, table, last))
    clock.accepted += 1
    if t_new >= recording.stops[next_.stop]:
        next_.stop += 1


@kernel
def advance(chain, table, recording, relative, absolute, ends, prescribed):
    """Integrate until the last of the stops, or for as many further steps as `ends` holds.

    The ends of these steps are written into `ends`; prescribed, they are read from there, no step
    is rejected, and one that is cut at a contact goes on to its end in further steps.  The result
    is RUNNING, FINISHED, or why it stopped: COLLAPSED, NOT_FINITE, OPENED.
    """
    table, recording, ends = borrowed((table, recording, ends))
    law, clock, next_, stops = chain.law, chain.clock, recording.next, recording.stops
    after_rejection = False
    steps = 0
    if prescribed:
        clock.h = math.inf
    while steps < ends.size and next_.stop < stops.size and not interrupted():
        t, reach = clock.t, clock.reach
        stop = ends[steps] if prescribed else stops[next_.stop]
        landing = t + clock.h >= stop
        t_new = stop if landing else t + clock.h
        h, shortest = t_new - t, SHORTEST_STEP_IN_SPACINGS * np.spacing(t)
        if h < shortest and not landing:
            return COLLAPSED
        last = min(reach, chain.contacts)
        largest, energy = try_step(chain, table, h, reach, recording.track_energy)
        clock.right_hand_sides += rk.STAGES
        error = error_norm(law, largest, h, relative, absolute)
        if prescribed and math.isnan(error):
            return NOT_FINITE
        if not (prescribed or error <= 1.0):
            clock.rejected += 1
            after_rejection = True
            if math.isnan(error):
                forget_slopes(chain, table)
                if h < 1e3 * shortest:
                    return NOT_FINITE
            clock.h = h * _reduction_of(error)
            continue
        if passes_any_kink(chain, table, last):
            if law.has_stiff_kinks:
                return OPENED
            allowed = absolute + relative * largest.compression
            at_contact = step_at_contact(chain, table, h, last, allowed)
            if shortest < at_contact < LONGEST_CUT * h:
                clock.cut += 1
                clock.h = at_contact
                continue
        _complete(chain, table, recording, h, t_new, energy)
        if prescribed:
            steps += landing
            clock.h = math.inf
            continue
        ends[steps] = t_new
        steps += 1
        growth, shortened = _growth_of(error), landing and h < clock.h
        if growth < 1.0 or not shortened:
            clock.h = h * (min(1.0, growth) if after_rejection else growth)
        after_rejection = False
    return FINISHED if next_.stop == stops.size else RUNNING
