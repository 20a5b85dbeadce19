r"""Steps of two lengths for a long chain: short ones in its front, long ones behind.

Behind a front that moves into beads at rest, u and d soon change little from bead to bead.  There
errors allow steps several times as long as in the front, up to the limit of stability,
:math:`\omega h \approx 6` with :math:`\omega^2 = 4 F'(u)`.

Domain of dependence.  A stage of a Runge-Kutta step takes from the earlier ones nothing but the
forces of a contact and its two neighbours.  With s stages, what is wrong at one contact therefore
reaches s contacts further within a step, and none beyond.  A chain may thus be cut anywhere and
closed there by any other motion.  In k steps only the sk contacts nearest to the cut are spoiled.

One long step.  At the time t a contact m behind the front is chosen, the last of those behind.

1. The contacts from m + 1 − sk on take k short steps, to the time T.  They are right for n > m.
2. The contacts up to m + sp go back to their state at t and take p long steps, to the same T.
   Mostly p = 1.  They are right for n ≤ m.

Every contact is then kept from the part where it is right.  Nothing is interpolated, the order is
that of the pair, and the price is s(k + p) contacts of double work.  Momentum, which steps of one
length keep to rounding, is kept up to errors of truncation.

The first part is cut off by a bead of constant velocity, the second by a wall, so that either is a
chain like others.  The short steps are at most those that the whole chain would take: what is
spoiled near the cut may shorten one.  The long steps have a step control of their own, which keeps
their errors to a small share of the tolerance.  Otherwise the growing waves of steps at the limit
of stability would add to the error of the front.
"""

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numba import int64, uint64

from granular_fronts.chain.integrator import COLLAPSED, FINISHED, RUNNING, advance, begin
from granular_fronts.chain.recorder import NEXT, Recording
from granular_fronts.chain.state import (
    ELASTIC_PARAMETERS,
    MOST_PARAMETERS,
    VISCOUS_PARAMETERS,
    D,
    U,
)
from granular_fronts.chain.strain import WINDOW_BLOCK
from granular_fronts.numerics.bits import borrowed, from_column
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.records import make_record
from granular_fronts.numerics.runge_kutta import STAGES
from granular_fronts.scenes.beads import bead_count

# Chains with fewer beads take steps of one length, and so do scenes that record one of these.
FEWEST_BEADS = 2000
NEED_ONE_LENGTH = ("grid", "probes", "sensors", "extremes", "balances")
# Contacts in short steps ahead of the cut, and the least number that moves when two lengths begin.
WIDTH, SHORTEST_WINDOW = 192, 768
# Most short steps for each long one, and parts of a long one for which an overlap is left.
MOST_SHORT_STEPS, MOST_PARTS = 16, 4
# How many short steps are first tried for a long one, and how much smaller errors behind are kept.
FIRST_RATIO, CAUTION = 4.0, 100.0
# While long steps do not pay, the next one to be tried grows slowly.
RECOVERY = 1.002
STEPS_PER_BLOCK = 2000
# Room for the ends of these steps, and of those behind; more steps behind count as a collapse.
BLOCK_SIZES = STEPS_PER_BLOCK + MOST_SHORT_STEPS, 100_000


class Behind(NamedTuple):
    """What the beads behind a front are integrated with."""

    chain: np.record  # The same chain, cut off by a wall, with a clock of its own.
    recording: Recording  # Of nothing.
    states: np.ndarray  # u and d at the start and at the end of a long step, shape (4, columns).
    overlap: int = STAGES  # Contacts that a step spoils beside a cut.


def takes_two_rates(scene: Mapping[str, Any]) -> bool:
    """Whether a scene is solved with steps of two lengths.

    What is recorded at many times, or summed over beads, needs steps of one length.  So do rings,
    short chains, and contacts with exponents of their own.
    """
    return (
        bead_count(scene) >= FEWEST_BEADS
        and scene["boundary"]["kind"] != "ring"
        and not {"alpha", "beta"} & scene.get("contacts", {}).keys()
        and not any(map(scene["record"].get, NEED_ONE_LENGTH))
    )


def prepare_behind(chain: np.record, recording: Recording) -> Behind:
    """Return what a chain needs for steps of two lengths."""
    none = np.empty(0)
    nothing = recording._replace(
        stops=np.zeros(1), profile_times=none, level=np.nan, next=make_record(NEXT, arrival=1)
    )
    behind = chain.copy()
    behind["clock"]["h"] = 0.0
    return Behind(behind, nothing, np.zeros((4, recording.side.size)))


@subroutine
def _short_steps(clock, slow):
    """Return how many short steps to take for a long one."""
    # The state at t = 0 is recorded in the first step, and only ends of long steps are completed.
    if clock.t == 0.0 or clock.reach < SHORTEST_WINDOW:
        return int64(1)
    if slow.h == 0.0:
        slow.h = FIRST_RATIO * clock.h
    return max(int64(1), min(int64(MOST_SHORT_STEPS), int64(slow.h / clock.h)))


@subroutine
def _steps_to_common_end(ends, ends_behind):
    """Return how many of the prescribed steps lie before the next time at which both end."""
    short = parts = 0
    while ends[short] != ends_behind[parts]:
        if ends[short] < ends_behind[parts]:
            short += 1
        else:
            parts += 1
    return short + 1, parts + 1


@subroutine
def _copy(source, first, target, other, start, end):
    """Copy two neighbouring rows from column `start` on, up to but not including `end`."""
    for row in range(2):
        for n in range(uint64(start), uint64(end)):
            target[other + row, n] = source[first + row, n]


@subroutine
def _advance_behind(chain, table, behind, absolute, ends, m, room, prescribed):
    """Take the beads up to m from the state at the start of a long step to its end."""
    cut, nothing, states = behind.chain, behind.recording, behind.states
    clock = cut.clock
    start, accepted, columns = clock.t, clock.accepted, states.shape[1]
    nothing.stops[0] = chain.clock.t
    _copy(table, U, states, 2, m + 1, columns)
    end = (m + room * behind.overlap + WINDOW_BLOCK - 1) // WINDOW_BLOCK * WINDOW_BLOCK
    end, status = min(end, chain.clock.reach), RUNNING
    while status == RUNNING:
        # A held contact is never the first beyond a cut, which changes the force there.
        end = chain.beads if end >= chain.contacts else end
        _copy(states, 0, table, U, 0, end + 1)
        cut.beads, cut.contacts, clock.reach = end, min(end, chain.contacts), end
        clock.t, clock.accepted, nothing.next.stop = start, accepted, 0
        if not prescribed:
            # Equal parts, a tenth longer than wanted rather than one more.
            whole = chain.clock.t - start
            clock.h = whole / max(1.0, math.ceil(whole / clock.h - 0.1))
        begin(cut, table)
        status = advance(cut, table, nothing, nothing.stops, 0.0, absolute, ends[:room], prescribed)
        if status == RUNNING and room == ends.size:
            return COLLAPSED
        # Without a cut nothing is spoiled, however many steps it takes.
        end, room = chain.clock.reach, ends.size
    _copy(states, 2, table, U, m + 1, columns)
    return status


@subroutine
def _number_from(chain, next_, skipped):
    """Number the beads anew, from the first that is not skipped."""
    chain.beads -= skipped
    chain.contacts -= skipped
    chain.clock.reach -= skipped
    next_.arrival -= skipped


@subroutine
def _advance_front(chain, table, recording, skipped, relative, absolute, ends, prescribed):
    """Take the beads that are not skipped some steps ahead, at most to the next stop."""
    next_ = recording.next
    stops = recording.stops[: next_.stop + 1]
    if skipped == 0:
        return advance(chain, table, recording, stops, relative, absolute, ends, prescribed)
    piston, driven = chain.piston, chain.driven
    chain.piston, chain.driven, chain.clock.drive = 1.0, False, 0.0
    _number_from(chain, next_, skipped)
    front = from_column(table, skipped)
    for n in range(MOST_PARAMETERS):
        # The law finds its parameters where their rows begin.
        front[ELASTIC_PARAMETERS, n] = table[ELASTIC_PARAMETERS, n]
        front[VISCOUS_PARAMETERS, n] = table[VISCOUS_PARAMETERS, n]
    front_recording = Recording(
        recording.stops,
        recording.profile_times,
        from_column(recording.profile_u, skipped),
        from_column(recording.profile_d, skipped),
        recording.sample_times,
        recording.sample_beads,
        recording.samples,
        recording.next,
        recording.level,
        from_column(recording.side, skipped),
        from_column(recording.arrival, skipped),
        from_column(recording.first_peak, skipped),
        from_column(recording.opening, skipped),
        from_column(recording.largest, skipped),
        from_column(recording.smallest, skipped),
        recording.extremes,
        recording.coefficients,
        recording.track_extremes,
        recording.track_energy,
    )
    begin(chain, front)
    status = advance(chain, front, front_recording, stops, relative, absolute, ends, prescribed)
    _number_from(chain, next_, -skipped)
    chain.piston, chain.driven = piston, driven
    return status


@subroutine
def _write_profiles(table, recording, first, m):
    """Complete the profiles from the index `first` on by the beads behind."""
    for row in range(first, recording.next.profile):
        for n in range(1, m + 1):
            recording.profile_u[row, n], recording.profile_d[row, n] = table[U, n], table[D, n]


@kernel
def advance_two_rates(chain, table, recording, behind, relative, absolute, ends, prescribed):
    """Integrate like `integrator.advance`, for `STEPS_PER_BLOCK` steps or a few more.

    The ends of the steps in front and of those behind are written into two arrays, or read there.
    """
    table, recording, behind, ends = borrowed((table, recording, behind, ends))
    clock, slow, next_, stops = chain.clock, behind.chain.clock, recording.next, recording.stops
    first, first_behind, have_slopes = clock.accepted, slow.accepted, False
    while (
        clock.accepted - first < STEPS_PER_BLOCK and next_.stop < stops.size and not interrupted()
    ):
        in_front = ends[0][clock.accepted - first :]
        in_back = ends[1][slow.accepted - first_behind :]
        short = _short_steps(clock, slow)
        parts = int64(MOST_PARTS if short > 1 else 1)
        if prescribed:
            short, parts = _steps_to_common_end(in_front, in_back)
        m, profile = clock.reach - WIDTH, next_.profile
        if not math.isnan(recording.level):
            # Contacts that wait for their arrival are followed in front alone.
            m = min(m, next_.arrival - 1)
        skipped = (m - short * behind.overlap) // WINDOW_BLOCK * WINDOW_BLOCK
        if max(short, parts) == 1 or skipped < 1:
            skipped = int64(0)
            if not prescribed:
                short, parts, slow.h = int64(1), int64(1), RECOVERY * slow.h
            if not have_slopes:
                begin(chain, table)
        else:
            slow.t = clock.t
            _copy(table, U, behind.states, 0, 0, table.shape[1])
        status = _advance_front(
            chain, table, recording, skipped, relative, absolute, in_front[:short], prescribed
        )
        have_slopes = skipped == 0
        if have_slopes:
            in_back[parts - 1] = clock.t
            slow.accepted += parts
        elif status <= FINISHED:
            allowed = (absolute + relative * clock.rate) / CAUTION
            status = _advance_behind(chain, table, behind, allowed, in_back, m, parts, prescribed)
            _write_profiles(table, recording, profile, m)
        if status > FINISHED:
            return status
    return FINISHED if next_.stop == stops.size else RUNNING
