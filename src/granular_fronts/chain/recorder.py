r"""What is recorded of a step: states at given times, first arrivals, extremes, the first opening.

Everything is located on the continuous extension (`dense_output`).  Most steps hold nothing of
note, which loops over whole rows without a branch find out: `passes_level` looks at the contacts
that wait for their arrival, `next_extreme` at all.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import int64, uint64

from granular_fronts.chain.contact_events import rate_of
from granular_fronts.chain.dense_output import contact_polynomial, take_output_stages, write_state
from granular_fronts.chain.state import (
    ELASTIC_SLOPES,
    NEW_D,
    NEW_U,
    VISCOUS_SLOPES,
    D,
    U,
    record_type,
)
from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import subroutine
from granular_fronts.numerics.polynomials import crossing, derivative, polynomial

NEXT = record_type(*[(name, np.int64) for name in ("stop", "profile", "sample", "arrival")])
"""Index of the next stop, profile and sample, and first contact that waits for its arrival."""

EXTREMES = record_type(
    *[
        (f"{name}{part}", float)
        for name in ("largest", "smallest")
        for part in ("", "_time", "_bead")
    ],
    ("gap_time", float),
    ("gap_bead", float),
)
"""Largest and smallest u of all contacts and times, and the first opening, NaN if there is none."""


class Recording(NamedTuple):
    """What to record, and the arrays to record it in.

    Attributes
    ----------
    stops : ndarray
        Increasing times on which a step must end; the last one is the end of the run.
    profile_times, profile_u, profile_d : ndarray, shape (times,) and (times, columns)
        Whole states.
    sample_times, sample_beads, samples : ndarray, shape (samples,)
        Relative displacements of single contacts, ordered by time.
    next : record
        Of type `NEXT`.
    level : float
        Level whose first passage is timed at each contact, NaN for none; 1 if u rises through it,
        −1 if it falls.
    arrival : ndarray, shape (columns,)
        Time of that passage, or NaN.
    first_peak, first_peak_time : ndarray, shape (columns,)
        First maximum of each contact above the level, the overshoot as the front passes.
    extremes : record
        Of type `EXTREMES`.
    coefficients : ndarray, shape (8,)
        Work space, of the polynomial of a contact.
    track_extremes, track_energy : bool
    """

    stops: np.ndarray
    profile_times: np.ndarray
    profile_u: np.ndarray
    profile_d: np.ndarray
    sample_times: np.ndarray
    sample_beads: np.ndarray
    samples: np.ndarray
    next: np.record
    level: float
    side: np.ndarray
    arrival: np.ndarray
    first_peak: np.ndarray
    first_peak_time: np.ndarray
    extremes: np.record
    coefficients: np.ndarray
    track_extremes: bool
    track_energy: bool


@subroutine
def next_output(recording):
    """Time of the next profile or sample, infinite if there is none."""
    profile, sample = recording.next.profile, recording.next.sample
    t = math.inf
    if profile < recording.profile_times.size:
        t = recording.profile_times[profile]
    if sample < recording.sample_times.size:
        t = min(t, recording.sample_times[sample])
    return t


@subroutine
def write_output(chain, table, h, t_new, recording):
    """Profiles and samples that fall into (t, t_new]."""
    t, next_ = chain.clock.t, recording.next
    while (
        next_.profile < recording.profile_times.size
        and recording.profile_times[next_.profile] <= t_new
    ):
        row = next_.profile
        theta = (recording.profile_times[row] - t) / h
        write_state(chain, table, h, theta, recording.profile_u[row], recording.profile_d[row])
        next_.profile += 1
    coefficients = recording.coefficients
    while (
        next_.sample < recording.sample_times.size and recording.sample_times[next_.sample] <= t_new
    ):
        index = next_.sample
        contact_polynomial(chain, table, h, recording.sample_beads[index], coefficients)
        theta = (recording.sample_times[index] - t) / h
        recording.samples[index] = polynomial(coefficients, theta)
        next_.sample += 1


@subroutine
def passes_level(table, arrival, level, side, first, last):
    """Whether any of the contacts first … last arrives at the level in this step."""
    passages = 0
    for n in range(uint64(first), uint64(last + 1)):
        # Only NaN differs from itself.
        passages += (
            (side[n] * table[U, n] < side[n] * level)
            & (side[n] * level <= side[n] * table[NEW_U, n])
            & (arrival[n] != arrival[n])
        )
    return passages > 0


@subroutine
def write_arrivals(chain, table, h, last, have_polynomials, recording):
    """First passages of the level within the step."""
    side, level, next_ = recording.side, recording.level, recording.next
    arrival = recording.arrival
    coefficients = recording.coefficients
    for n in range(next_.arrival, last + 1):
        arrives = side[n] * table[U, n] < side[n] * level <= side[n] * table[NEW_U, n]
        if not (arrives and math.isnan(arrival[n])):
            continue
        if not have_polynomials:
            take_output_stages(chain, table, h, n, n)
        contact_polynomial(chain, table, h, n, coefficients)
        arrival[n] = chain.clock.t + h * crossing(coefficients, level)
    while next_.arrival < chain.contacts and not math.isnan(arrival[next_.arrival]):
        next_.arrival += 1


@subroutine
def next_extreme(chain, table, h, recording, first, last):
    """First of the contacts first … last that may hold an extreme or open; beyond `last` if none.

    The conditions are those of `write_extremes`, each at least as wide.
    """
    arrival, first_peak = recording.arrival, recording.first_peak
    largest, smallest = recording.extremes.largest, recording.extremes.smallest
    factor, viscous = chain.law.gamma, ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    start, end = viscous + rk.SLOT[0], viscous + rk.SLOT[rk.NEW_SLOPE]
    none = found = last + 1
    for n in range(uint64(first), uint64(last + 1)):
        u, new_u = table[U, n], table[NEW_U, n]
        rate = table[D, n] + factor * table[start, n]
        new_rate = table[NEW_D, n] + factor * table[end, n]
        margin = 0.5 * h * abs(rate - new_rate)
        high, low = max(u, new_u), min(u, new_u)
        # Only NaN differs from itself.
        counts = (
            (high + margin > largest)
            | (low - margin < smallest)
            | ((arrival[n] == arrival[n]) & (first_peak[n] != first_peak[n]))
        )
        turns = rate * new_rate <= 0.0
        holds = (turns & counts) | (high > largest) | (low < smallest) | (u * new_u < 0.0)
        found = min(found, int64(n) if holds else none)
    return found


@subroutine
def note_largest(extremes, value, t, n):
    """Keep a new largest u."""
    if value > extremes.largest:
        extremes.largest, extremes.largest_time, extremes.largest_bead = value, t, n


@subroutine
def note_smallest(extremes, value, t, n):
    """Keep a new smallest u."""
    if value < extremes.smallest:
        extremes.smallest, extremes.smallest_time, extremes.smallest_bead = value, t, n


@subroutine
def write_extremes(chain, table, h, t_new, last, have_polynomials, recording):
    """Extremes of u over the step, and the first opening."""
    n = next_extreme(chain, table, h, recording, int64(1), last)
    while n <= last:
        write_extreme(chain, table, h, t_new, n, have_polynomials, recording)
        n = next_extreme(chain, table, h, recording, n + 1, last)


@subroutine
def write_extreme(chain, table, h, t_new, n, have_polynomials, recording):
    """Extremes of contact n over the step, and its opening, if they count."""
    extremes, first_peak, t = recording.extremes, recording.first_peak, chain.clock.t
    u, new_u = table[U, n], table[NEW_U, n]
    note_largest(extremes, new_u, t_new, n)
    note_smallest(extremes, new_u, t_new, n)
    rate = rate_of(chain, table, D, int64(0), n)
    new_rate = rate_of(chain, table, NEW_D, rk.NEW_SLOPE, n)
    margin = 0.5 * h * abs(rate - new_rate)
    is_first = not math.isnan(recording.arrival[n]) and math.isnan(first_peak[n])
    peak = rate > 0.0 >= new_rate and (is_first or max(u, new_u) + margin > extremes.largest)
    trough = rate < 0.0 <= new_rate and min(u, new_u) - margin < extremes.smallest
    opens = u > NEGLIGIBLE and new_u < -NEGLIGIBLE and math.isnan(extremes.gap_time)
    if not (peak or trough or opens):
        return
    if not have_polynomials:
        take_output_stages(chain, table, h, n, n)
    coefficients = recording.coefficients
    contact_polynomial(chain, table, h, n, coefficients)
    if opens:
        extremes.gap_time, extremes.gap_bead = t + h * crossing(coefficients, 0.0), n
    if not (peak or trough):
        return
    theta = crossing(derivative(coefficients), 0.0)
    value, time = polynomial(coefficients, theta), t + h * theta
    if trough:
        note_smallest(extremes, value, time, n)
        return
    note_largest(extremes, value, time, n)
    if is_first:
        first_peak[n], recording.first_peak_time[n] = value, time


@subroutine
def record_step(chain, table, h, t_new, recording):
    """Record what an accepted step holds, before its end becomes the start of the next one."""
    due = next_output(recording) <= t_new
    if due:
        take_output_stages(chain, table, h, int64(1), chain.clock.reach)
        chain.clock.right_hand_sides += rk.SLOPES - rk.NEW_SLOPE - 1
        write_output(chain, table, h, t_new, recording)
    last = min(chain.clock.reach, chain.contacts)
    write_arrivals(chain, table, h, last, due, recording)
    if recording.track_extremes:
        write_extremes(chain, table, h, t_new, last, due, recording)
