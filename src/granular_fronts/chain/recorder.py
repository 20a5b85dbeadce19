r"""What is recorded of a step: states at given times, and five events of every contact.

Events of u are its first passage through a level and its first maximum after that.  Others are the
first opening, where u turns negative, and its largest and smallest value of all times, t = 0
included. Everything is located on the continuous extension of the step, of order 7.

Continuous extension.  With weights :math:`b_j(\theta)` of the sixteen slopes,

.. math::

    u(\theta) = u + \theta h\,d + \sum_j \Bigl( h\, b_j g_j
        + h^2 \sum_l b_l a_{lj}\, k_j \Bigr), \qquad d(\theta) = d + h\sum_j b_j k_j .

Three of the slopes belong to stages that nothing else uses.  A slope depends only on the
neighbouring contacts.  So the polynomial of contact n needs the first of the three stages on the
contacts n ± 3, the second on n ± 2 and the third on n ± 1.  Only these are computed.

Most steps hold nothing of note.  Loops over whole rows without a branch find this out:
`next_passage` looks at the contacts that wait for their arrival, `next_turn` at all.  Between the
ends of a step u exceeds both by no more than about :math:`h|\dot u(t + h) - \dot u(t)|/2`; where
this may matter, the polynomial of the contact decides.

Of a contact that turns twice within a step the rates at both ends have one sign.  The cubic through
the ends then turns twice, and :math:`|\dot u|` first falls, which the first stage shows.  In the
foot of a front u grows by orders of magnitude within a step.  The cubic swings there as well, but
:math:`|\dot u|` grows at once.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import int64, uint64

from granular_fronts.chain.state import (
    DAMPING,
    ELASTIC_SLOPES,
    FORCE,
    NEW_D,
    NEW_U,
    VISCOUS_SLOPES,
    D,
    U,
)
from granular_fronts.chain.state import VALUE as STAGE_VALUE
from granular_fronts.chain.strain import laplacian, take_drive, take_forces
from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import subroutine
from granular_fronts.numerics.polynomials import crossing, derivative, polynomial
from granular_fronts.numerics.records import record_type

NEXT = record_type(*[(name, np.int64) for name in ("stop", "profile", "sample", "arrival")])
"""Index of the next stop, profile and sample, and first contact that waits for its arrival."""

VALUE, TIME, STEEPNESS, RIVAL, RIVAL_TIME, END, END_TIME = range(7)
"""Rows of an event: u, t, and how steeply the quantity that locates it passes zero, |u̇| or |ü|.

An extreme of all times is the best turn of u within steps, or the best end of a step.  It has rows
for both, and for the second best turn, which another solution may take for the best.
"""

_CONTRACT = {"contract"}

# A turn that is second to one of its contact counts if it comes as close to the extreme of all.
CLOSE = 1.0e-3
# The share of itself by which |u̇| may grow until the first stage, if u is to turn twice.
MOST_GROWTH = 0.1


class Recording(NamedTuple):
    """What to record, and the arrays to record it in."""

    # Increasing times on which a step must end; the last one is the end of the run.
    stops: np.ndarray
    # Whole states, shape (times, columns).
    profile_times: np.ndarray
    profile_u: np.ndarray
    profile_d: np.ndarray
    # Relative displacements of single contacts, ordered by time.
    sample_times: np.ndarray
    sample_beads: np.ndarray
    samples: np.ndarray
    # A record of type `NEXT`.
    next: np.record
    # Level whose first passage is timed at each contact, NaN for none. For each contact 1 if u
    # rises through it, −1 if it falls.
    level: float
    side: np.ndarray
    # Passage of the level, first maximum after it, first passage of 0 from above, shape
    # (3, columns); NaN where there is none.
    arrival: np.ndarray
    first_peak: np.ndarray
    opening: np.ndarray
    # Extremes of each contact, shape (7, columns); infinite where it has not turned.
    largest: np.ndarray
    smallest: np.ndarray
    # Largest and smallest u of all contacts at the start and where they have turned.
    extremes: np.ndarray
    # Work space, of the polynomial of a contact.
    coefficients: np.ndarray
    track_extremes: bool
    track_energy: bool


@subroutine(forceinline=True)
def _take_output_stages(chain, table, h, first, last):
    """The three stages that only dense output uses, as far as the contacts first … last need them.

    The rows `VALUE`, `FORCE` and `DAMPING` are left as the last stage needs them.
    """
    if chain.ring:
        first, last = 1, chain.beads
    law, clock = chain.law, chain.clock
    for row in range(rk.NEW_SLOPE + 1, rk.SLOPES):
        distance = rk.SLOPES - row
        low, high = max(1, first - distance), min(clock.reach, last + distance)
        contacts = min(high, chain.contacts)
        take_drive(chain, clock.t + h * rk.C[row])
        _sum_all_slots(chain, table, row, h, low, contacts)
        take_forces(law, table, STAGE_VALUE, low, contacts)
        slot = rk.SLOT[row]
        laplacian(chain, table, FORCE, ELASTIC_SLOPES + slot, low, high)
        if not law.single:
            laplacian(chain, table, DAMPING, VISCOUS_SLOPES + slot, low, high)


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _sum_all_slots(chain, table, row, h, low, high):
    """U of an output stage on the contacts low … high."""
    single, h_gamma, h_squared = chain.law.single, h * chain.law.gamma, h * h
    for n in range(uint64(low), uint64(high + 1)):
        table[STAGE_VALUE, n] = table[U, n] + h * rk.C[row] * table[D, n]
    for slot in range(rk.SLOPES - 1):
        on_g, on_k = h_gamma * rk.A_SLOTS[row, slot], h_squared * rk.A_SQUARED_SLOTS[row, slot]
        if single:
            on_k += on_g
        for n in range(uint64(low), uint64(high + 1)):
            table[STAGE_VALUE, n] += on_k * table[ELASTIC_SLOPES + slot, n]
        if not single:
            for n in range(uint64(low), uint64(high + 1)):
                table[STAGE_VALUE, n] += on_g * table[VISCOUS_SLOPES + slot, n]


@subroutine
def _contact_polynomial(chain, table, h, n, coefficients):
    """Coefficients of u_n(θ) in powers of θ, constant term first."""
    viscous = ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    h_gamma, h_squared = h * chain.law.gamma, h * h
    coefficients[:] = 0.0
    for slot in range(rk.SLOPES):
        on_g = h_gamma * table[viscous + slot, n]
        on_k = h_squared * table[ELASTIC_SLOPES + slot, n]
        for power in range(uint64(rk.DEGREE + 1)):
            coefficients[power] += rk.CONTINUOUS_OF_SLOT[slot, power] * on_g
            coefficients[power] += rk.CONTINUOUS_A_OF_SLOT[slot, power] * on_k
    coefficients[0] += table[U, n]
    coefficients[1] += h * table[D, n]


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _write_state(chain, table, h, theta, row_u, row_d):
    """u(θ) and d(θ) of all beads of the active window; at θ = 1 the new state itself."""
    reach = chain.clock.reach
    if theta == 1.0:
        for n in range(1, reach + 1):
            row_u[n] = table[NEW_U, n]
            row_d[n] = table[NEW_D, n]
        return
    for n in range(1, reach + 1):
        row_u[n] = table[U, n] + theta * h * table[D, n]
        row_d[n] = table[D, n]
    viscous = ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    powers = theta ** np.arange(rk.DEGREE + 1)
    for slot in range(rk.SLOPES):
        b = np.sum(rk.CONTINUOUS_OF_SLOT[slot] * powers)
        on_g = h * chain.law.gamma * b
        on_k = h * h * np.sum(rk.CONTINUOUS_A_OF_SLOT[slot] * powers)
        for n in range(uint64(1), uint64(reach + 1)):
            k = table[ELASTIC_SLOPES + slot, n]
            row_u[n] += on_g * table[viscous + slot, n] + on_k * k
            row_d[n] += h * b * k


@subroutine
def next_output(recording):
    """Return the time of the next profile or sample, or infinity."""
    profile, sample = recording.next.profile, recording.next.sample
    t = math.inf
    if profile < recording.profile_times.size:
        t = recording.profile_times[profile]
    if sample < recording.sample_times.size:
        t = min(t, recording.sample_times[sample])
    return t


@subroutine(forceinline=True)
def _write_output(chain, table, h, t_new, recording):
    """Profiles and samples that fall into (t, t_new]."""
    t, next_ = chain.clock.t, recording.next
    while (
        next_.profile < recording.profile_times.size
        and recording.profile_times[next_.profile] <= t_new
    ):
        row = next_.profile
        theta = (recording.profile_times[row] - t) / h
        _write_state(chain, table, h, theta, recording.profile_u[row], recording.profile_d[row])
        next_.profile += 1
    coefficients = recording.coefficients
    while (
        next_.sample < recording.sample_times.size and recording.sample_times[next_.sample] <= t_new
    ):
        index = next_.sample
        _contact_polynomial(chain, table, h, recording.sample_beads[index], coefficients)
        theta = (recording.sample_times[index] - t) / h
        recording.samples[index] = polynomial(coefficients, theta)
        next_.sample += 1


@subroutine(forceinline=True)
def _rate_slopes(chain):
    """Return the first row of the slopes that u̇ takes times γ."""
    return ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES


@subroutine(forceinline=True)
def _rate_rows(chain):
    """Return the factor γ, and the rows of its slopes at the start and at the end of the step."""
    slopes = _rate_slopes(chain)
    return chain.law.gamma, slopes + rk.SLOT[0], slopes + rk.SLOT[rk.NEW_SLOPE]


@subroutine(forceinline=True)
def rates(table, rows, n):
    """Return the rate of change of u_n at the start and end of the step, from `_rate_rows`."""
    factor, start, end = rows
    return table[D, n] + factor * table[start, n], table[NEW_D, n] + factor * table[end, n]


@subroutine(forceinline=True)
def _middle_rate(u, new_u, rate, new_rate, h):
    """Return h times the middle Bézier coefficient of the slope of the cubic through both ends."""
    return 3.0 * (new_u - u) - h * (rate + new_rate)


@subroutine
def next_passage(chain, table, h, recording, first, last):
    """Return the first of the contacts that may arrive at the level, or one beyond `last`."""
    side, level, arrival = recording.side, recording.level, recording.arrival
    rows = _rate_rows(chain)
    none = found = last + 1
    for n in range(uint64(first), uint64(last + 1)):
        rate, new_rate = rates(table, rows, n)
        turns = (side[n] * rate > 0.0) & (side[n] * new_rate <= 0.0)
        margin = 0.5 * h * abs(rate - new_rate) if turns else 0.0
        highest = max(side[n] * table[U, n], side[n] * table[NEW_U, n]) + margin
        # Only NaN differs from itself.
        arrives = (arrival[TIME, n] != arrival[TIME, n]) & (side[n] * level <= highest)
        found = min(found, int64(n) if arrives else none)
    return found


@subroutine(forceinline=True)
def _write_arrivals(chain, table, h, last, have_polynomials, recording):
    """First passages of the level within the step."""
    next_, arrival = recording.next, recording.arrival
    n = next_passage(chain, table, h, recording, next_.arrival, last)
    while n <= last:
        if not have_polynomials:
            _take_output_stages(chain, table, h, n, n)
        _contact_polynomial(chain, table, h, n, recording.coefficients)
        _write_passage(chain, table, h, n, recording.level, recording.side[n], recording, arrival)
        n = next_passage(chain, table, h, recording, n + 1, last)
    while next_.arrival < chain.contacts and not math.isnan(arrival[TIME, next_.arrival]):
        next_.arrival += 1


@subroutine
def _write_passage(chain, table, h, n, level, side, recording, event):
    """First passage of a level, upwards if side is 1, before a turn of u or before the end."""
    coefficients = recording.coefficients
    if not side * table[U, n] < side * level:
        return
    end, new_u = 1.0, table[NEW_U, n]
    rate, new_rate = rates(table, _rate_rows(chain), n)
    if side * new_u < side * level and side * rate > 0.0 >= side * new_rate:
        end = crossing(derivative(coefficients), 0.0)
        new_u = polynomial(coefficients, end)
    if side * new_u < side * level:
        return
    theta = crossing(coefficients, level, 0.0, end)
    event[VALUE, n], event[TIME, n] = level, chain.clock.t + h * theta
    event[STEEPNESS, n] = abs(polynomial(derivative(coefficients), theta)) / h


@subroutine
def note_ends(chain, table, side, t_new, event):
    """Largest u of every contact at the ends of steps so far, or smallest if side is −1."""
    for n in range(uint64(1), uint64(min(chain.clock.reach, chain.contacts) + 1)):
        u = table[NEW_U, n]
        exceeds = side * u > side * event[END, n] + NEGLIGIBLE
        event[END_TIME, n] = t_new if exceeds else event[END_TIME, n]
        event[END, n] = u if exceeds else event[END, n]


@subroutine
def next_turn(chain, table, h, recording, first, last):
    """Return first of the contacts first … last that may turn or open; beyond `last` if none."""
    arrival, first_peak = recording.arrival, recording.first_peak
    largest, smallest = recording.largest, recording.smallest
    rows, (upper, lower) = _rate_rows(chain), (recording.extremes[0], recording.extremes[1])
    upper, lower = upper - CLOSE * abs(upper), lower + CLOSE * abs(lower)
    start, first_stage, slopes = rk.SLOT[0], rk.SLOT[1], _rate_slopes(chain)
    driven, factor, h_squared = h * rk.C[1], chain.law.gamma, h * h
    none = found = last + 1
    for n in range(uint64(first), uint64(last + 1)):
        u, new_u = table[U, n], table[NEW_U, n]
        rate, new_rate = rates(table, rows, n)
        margin = 0.5 * h * abs(rate - new_rate)
        high, low = max(u, new_u) + margin, min(u, new_u) - margin
        # Only NaN differs from itself.
        counts = (
            (high > largest[END, n])
            | (low < smallest[END, n])
            | (high > upper)
            | (low < lower)
            | (
                (arrival[TIME, n] == arrival[TIME, n])
                & (first_peak[TIME, n] != first_peak[TIME, n])
            )
        )
        falls = (rate < 0.0) & (new_rate >= 0.0)
        middle = _middle_rate(u, new_u, rate, new_rate, h)
        early = driven * table[ELASTIC_SLOPES + start, n] + factor * (
            table[slopes + first_stage, n] - table[slopes + start, n]
        )
        both = rate * new_rate
        twice = (both > 0.0) & (middle * rate < 0.0) & (middle * middle > h_squared * both)
        twice &= early * rate < MOST_GROWTH * (rate * rate)
        turns = ((rate > 0.0) & (new_rate <= 0.0)) | falls | twice
        opens = (u > 0.0) & ((new_u < 0.0) | (falls & (low < 0.0)))
        holds = (turns & counts) | opens
        found = min(found, int64(n) if holds else none)
    return found


@subroutine(forceinline=True)
def _write_turns(chain, table, h, last, have_polynomials, recording):
    """Turns of u at an extreme within the step, and first openings."""
    n = next_turn(chain, table, h, recording, int64(1), last)
    while n <= last:
        if not have_polynomials:
            _take_output_stages(chain, table, h, n, n)
        _contact_polynomial(chain, table, h, n, recording.coefficients)
        if table[U, n] > NEGLIGIBLE and math.isnan(recording.opening[TIME, n]):
            _write_passage(chain, table, h, n, -NEGLIGIBLE, -1.0, recording, recording.opening)
        _write_turn(chain, table, h, n, recording)
        n = next_turn(chain, table, h, recording, n + 1, last)


@subroutine
def _write_turn(chain, table, h, n, recording):
    """The turns of contact n within the step that count: one, or two if the cubic has as many."""
    slope = derivative(recording.coefficients)
    rate, new_rate = rates(table, _rate_rows(chain), n)
    inner = _middle_rate(table[U, n], table[NEW_U, n], rate, new_rate, h) / h
    turns_twice = rate * new_rate > 0.0 > inner * rate
    # Where the slope of the cubic is least: its Bézier coefficients are the rates and `inner`.
    middle = (rate - inner) / (rate - 2.0 * inner + new_rate) if turns_twice else 1.0
    inner_rate = polynomial(slope, middle) if middle < 1.0 else new_rate
    _write_turn_between(chain, h, n, recording, slope, (0.0, middle), (rate, inner_rate))
    if middle < 1.0:
        _write_turn_between(chain, h, n, recording, slope, (middle, 1.0), (inner_rate, new_rate))


@subroutine
def _write_turn_between(chain, h, n, recording, slope, ends, rates_there):
    """The turn of contact n between two θ, if there is one and it counts."""
    first_peak = recording.first_peak
    rises = rates_there[0] > 0.0 >= rates_there[1]
    if not (rises or rates_there[0] < 0.0 <= rates_there[1]):
        return
    theta = crossing(slope, 0.0, ends[0], ends[1])
    value, time = polynomial(recording.coefficients, theta), chain.clock.t + h * theta
    if abs(value) <= NEGLIGIBLE:
        value = 0.0
    curvature = abs(polynomial(derivative(slope), theta)) / (h * h)
    if rises and math.isnan(first_peak[TIME, n]) and time >= recording.arrival[TIME, n]:
        first_peak[VALUE, n], first_peak[TIME, n] = value, time
        first_peak[STEEPNESS, n] = curvature
    event, side = (recording.largest, 1.0) if rises else (recording.smallest, -1.0)
    extremes, which = recording.extremes, 0 if rises else 1
    extremes[which] = side * max(side * value, side * extremes[which])
    if side * value > side * event[VALUE, n]:
        event[RIVAL, n], event[RIVAL_TIME, n] = event[VALUE, n], event[TIME, n]
        event[VALUE, n], event[TIME, n], event[STEEPNESS, n] = value, time, curvature
    elif side * value > side * event[RIVAL, n]:
        event[RIVAL, n], event[RIVAL_TIME, n] = value, time


@subroutine(forceinline=True)
def record_step(chain, table, h, t_new, recording):
    """Record what an accepted step holds, before its end becomes the start of the next one."""
    due = next_output(recording) <= t_new
    if due:
        _take_output_stages(chain, table, h, int64(1), chain.clock.reach)
        chain.clock.right_hand_sides += rk.SLOPES - rk.NEW_SLOPE - 1
        _write_output(chain, table, h, t_new, recording)
    last = min(chain.clock.reach, chain.contacts)
    if not math.isnan(recording.level):
        _write_arrivals(chain, table, h, last, due, recording)
    if recording.track_extremes:
        _write_turns(chain, table, h, last, due, recording)
