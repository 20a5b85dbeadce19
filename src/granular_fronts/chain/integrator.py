r"""Adaptive integration of a chain in strain form, with output and reductions on the way.

Step control: the eighth-order pair of `runge_kutta` with error per step, in the maximum norm over
beads (`strain.error_norm`), and steps that respect contact events (`contact_events`).  A step size
is rounded to the difference of two representable times, so that the clock carries no error.

Output.  Steps land on the `stops` (snapshots and the end); everything else is read from the
continuous extension of order 7, whose three further stages are computed only in steps that need
them.  With weights :math:`b_j(\theta)`,

.. math::

    u(\theta) = u + \theta h\,d + \sum_j \Bigl( h\gamma\, b_j g_j
        + h^2 \sum_l b_l a_{lj}\, k_j \Bigr), \qquad d(\theta) = d + h\sum_j b_j k_j .

Reductions are located on the same polynomials: first arrival of a level at each bead, largest and
smallest relative displacement over all beads and times, first opening of a contact.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import uint64

from granular_fronts.chain.contact_events import changes_sign, step_at_contact
from granular_fronts.chain.state import PAIR
from granular_fronts.chain.strain import (
    NEGLIGIBLE,
    accept,
    dissipated_energy,
    error_norm,
    evaluate_slopes,
    reach_of,
    stages_for_output,
    try_step,
)
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.polynomials import crossing, derivative, polynomial

RUNNING, FINISHED, COLLAPSED, NOT_FINITE, OPENED = range(5)

# Steps shorter than this many spacings of representable times mean that the solve has collapsed.
SHORTEST_STEP_IN_SPACINGS = 8.0


class Clock(NamedTuple):
    """Time and work so far; one-element arrays, since compiled code updates them in place."""

    t: np.ndarray
    h: np.ndarray
    reach: np.ndarray
    counts: np.ndarray
    dissipated: np.ndarray


ACCEPTED, REJECTED, REJECTED_AT_CONTACT, STAGE_COUNT, IMPLICIT = range(5)


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
    cursor : ndarray of int
        Next stop, next profile, next sample.
    level, arrival : float and ndarray, shape (columns,)
        Level whose first upward crossing is timed at each contact; NaN for none.
    first_peak, first_peak_time : ndarray, shape (columns,)
        First maximum of each contact above the level, the overshoot as the front passes.
    extremes : ndarray, shape (8,)
        Largest u, its time and bead; smallest u, its time and bead; time and bead of first opening.
    track_extremes, track_energy : bool
    """

    stops: np.ndarray
    profile_times: np.ndarray
    profile_u: np.ndarray
    profile_d: np.ndarray
    sample_times: np.ndarray
    sample_beads: np.ndarray
    samples: np.ndarray
    cursor: np.ndarray
    level: float
    arrival: np.ndarray
    first_peak: np.ndarray
    first_peak_time: np.ndarray
    extremes: np.ndarray
    track_extremes: bool
    track_energy: bool


STOP, PROFILE, SAMPLE = range(3)
LARGEST, SMALLEST, OPENING = 0, 3, 6


@kernel
def polynomial_weights(law, h, theta, weights_d, weights_g, weights_k):
    """Weights of the slopes in d(θ), and of g and k in u(θ)."""
    for j in range(rk.SLOPES):
        b = b_a = 0.0
        for power in range(rk.DEGREE, -1, -1):
            b = b * theta + rk.CONTINUOUS[power, j]
            b_a = b_a * theta + rk.CONTINUOUS_A[power, j]
        weights_d[j] = h * b
        weights_g[j] = h * law.gamma * b
        weights_k[j] = h * h * b_a


@kernel
def contact_polynomial(law, state, h, n, coefficients):
    """Coefficients of u_n(θ) in powers of θ, constant term first."""
    g = state.g if law.kind == PAIR else state.k
    coefficients[:] = 0.0
    for j in range(rk.SLOPES):
        weight_g, weight_k = h * law.gamma * g[j, n], h * h * state.k[j, n]
        for power in range(uint64(rk.DEGREE + 1)):
            coefficients[power] += rk.CONTINUOUS_OF_SLOPE[j, power] * weight_g
            coefficients[power] += rk.CONTINUOUS_A_OF_SLOPE[j, power] * weight_k
    coefficients[0] += state.u[n]
    coefficients[1] += h * state.d[n]


@kernel
def next_output(recording):
    """Time of the next profile or sample, infinite if there is none."""
    profile, sample = recording.cursor[PROFILE], recording.cursor[SAMPLE]
    t = math.inf
    if profile < recording.profile_times.size:
        t = recording.profile_times[profile]
    if sample < recording.sample_times.size:
        t = min(t, recording.sample_times[sample])
    return t


@kernel
def write_profile(law, state, h, theta, reach, row_u, row_d):
    """u(θ) and d(θ) of all beads of the active window; at θ = 1 the new state itself."""
    if theta == 1.0:
        for n in range(1, reach + 1):
            row_u[n] = state.new_u[n]
            row_d[n] = state.new_d[n]
        return
    weights_d, weights_g, weights_k = np.empty(rk.SLOPES), np.empty(rk.SLOPES), np.empty(rk.SLOPES)
    polynomial_weights(law, h, theta, weights_d, weights_g, weights_k)
    g = state.g if law.kind == PAIR else state.k
    for n in range(1, reach + 1):
        row_u[n] = state.u[n] + theta * h * state.d[n]
        row_d[n] = state.d[n]
    for j in range(rk.SLOPES):
        for n in range(1, reach + 1):
            row_u[n] += weights_g[j] * g[j, n] + weights_k[j] * state.k[j, n]
            row_d[n] += weights_d[j] * state.k[j, n]


@kernel
def write_output(law, state, t, h, t_new, reach, recording):
    """Profiles and samples that fall into (t, t_new]."""
    cursor = recording.cursor
    while (
        cursor[PROFILE] < recording.profile_times.size
        and recording.profile_times[cursor[PROFILE]] <= t_new
    ):
        row = cursor[PROFILE]
        theta = (recording.profile_times[row] - t) / h
        write_profile(
            law, state, h, theta, reach, recording.profile_u[row], recording.profile_d[row]
        )
        cursor[PROFILE] += 1
    coefficients = np.empty(rk.DEGREE + 1)
    while (
        cursor[SAMPLE] < recording.sample_times.size
        and recording.sample_times[cursor[SAMPLE]] <= t_new
    ):
        index = cursor[SAMPLE]
        contact_polynomial(law, state, h, recording.sample_beads[index], coefficients)
        theta = (recording.sample_times[index] - t) / h
        recording.samples[index] = polynomial(coefficients, theta)
        cursor[SAMPLE] += 1


@kernel
def write_arrivals(law, state, t, h, last, recording):
    """First upward crossings of the level within the step."""
    coefficients = np.empty(rk.DEGREE + 1)
    for n in range(1, last + 1):
        if state.u[n] < recording.level <= state.new_u[n] and math.isnan(recording.arrival[n]):
            contact_polynomial(law, state, h, n, coefficients)
            recording.arrival[n] = t + h * crossing(coefficients, recording.level)


@kernel
def level_is_crossed(u, new_u, level, last):
    """Whether any of the contacts 1 … last rises through the level in this step.

    This and `holds_extreme` look at every step, and most often find nothing: loops without a
    branch, so that they vectorise, over bare arrays, whose references cost less to count.
    """
    crossings = 0
    for n in range(uint64(1), uint64(last + 1)):
        crossings += (u[n] < level) & (level <= new_u[n])
    return crossings > 0


@kernel
def holds_extreme(u, new_u, d, new_d, g, first_peak, h, gamma, level, largest, smallest, last):
    """Whether `write_extremes` can find anything: its conditions, each at least as wide."""
    found = 0
    for n in range(uint64(1), uint64(last + 1)):
        rate = d[n] + gamma * g[0, n]
        new_rate = new_d[n] + gamma * g[rk.NEW_SLOPE, n]
        margin = 0.5 * h * abs(rate - new_rate)
        # Only NaN differs from itself.
        first = (u[n] > level) & (first_peak[n] != first_peak[n])
        higher = first | (max(u[n], new_u[n]) + margin > largest)
        lower = min(u[n], new_u[n]) - margin < smallest
        turns = ((rate > 0.0) & (new_rate <= 0.0) & higher) | (
            (rate < 0.0) & (new_rate >= 0.0) & lower
        )
        opens = (u[n] > 0.0) & (new_u[n] < 0.0)
        found += turns | opens | (new_u[n] > largest) | (new_u[n] < smallest)
    return found > 0


@kernel
def record_extremum(kind, sign, value, t, n, recording):
    """Keep the value if it is a new largest (sign 1) or smallest (sign −1) one."""
    if sign * value > sign * recording.extremes[kind]:
        recording.extremes[kind] = value
        recording.extremes[kind + 1] = t
        recording.extremes[kind + 2] = n


@kernel
def write_extremes(law, size, state, t, h, reach, have_polynomials, recording):
    """Extremes of u over the step, and the first opening; whether output stages are computed."""
    g = state.g if law.kind == PAIR else state.k
    extremes, first_peak = recording.extremes, recording.first_peak
    coefficients = np.empty(rk.DEGREE + 1)
    for n in range(1, min(reach, size.contacts) + 1):
        u, new_u = state.u[n], state.new_u[n]
        record_extremum(LARGEST, 1.0, new_u, t + h, n, recording)
        record_extremum(SMALLEST, -1.0, new_u, t + h, n, recording)
        rate = state.d[n] + law.gamma * g[0, n]
        new_rate = state.new_d[n] + law.gamma * g[rk.NEW_SLOPE, n]
        margin = 0.5 * h * abs(rate - new_rate)
        first = u > recording.level and math.isnan(first_peak[n])
        peak = rate > 0.0 >= new_rate and (first or max(u, new_u) + margin > extremes[LARGEST])
        trough = rate < 0.0 <= new_rate and min(u, new_u) - margin < extremes[SMALLEST]
        opens = u > NEGLIGIBLE and new_u < -NEGLIGIBLE and math.isnan(extremes[OPENING])
        if not (peak or trough or opens):
            continue
        if not have_polynomials:
            stages_for_output(law, size, state, h, reach)
            have_polynomials = True
        contact_polynomial(law, state, h, n, coefficients)
        if opens:
            extremes[OPENING] = t + h * crossing(coefficients, 0.0)
            extremes[OPENING + 1] = n
        if not (peak or trough):
            continue
        theta = crossing(derivative(coefficients), 0.0)
        value, time = polynomial(coefficients, theta), t + h * theta
        if trough:
            record_extremum(SMALLEST, -1.0, value, time, n, recording)
            continue
        record_extremum(LARGEST, 1.0, value, time, n, recording)
        if first:
            first_peak[n], recording.first_peak_time[n] = value, time
    return have_polynomials


@kernel
def record_step(law, size, state, t, h, t_new, reach, recording):
    """Everything to be recorded of an accepted step; whether output stages were computed."""
    last = min(reach, size.contacts)
    due = next_output(recording) <= t_new
    arrives = level_is_crossed(state.u, state.new_u, recording.level, last)
    have_polynomials = due or arrives
    if have_polynomials:
        stages_for_output(law, size, state, h, reach)
    if due:
        write_output(law, state, t, h, t_new, reach, recording)
    if arrives:
        write_arrivals(law, state, t, h, last, recording)
    if recording.track_extremes:
        return write_extremes(law, size, state, t, h, reach, have_polynomials, recording)
    return have_polynomials


@kernel
def factor_of(error):
    """Change of step size that brings the next error to the tolerance."""
    if error == 0.0:
        return rk.LARGEST_FACTOR
    return min(rk.LARGEST_FACTOR, max(rk.SMALLEST_FACTOR, rk.SAFETY * error**rk.ERROR_EXPONENT))


@kernel
def advance(law, size, state, clock, relative, absolute, recording, most_steps):
    """Integrate until the last stop, or until `most_steps` further steps are accepted.

    Returns
    -------
    int
        RUNNING, FINISHED, or why it stopped: COLLAPSED, NOT_FINITE, OPENED.
    """
    counts, cursor, stops = clock.counts, recording.cursor, recording.stops
    output_time = next_output(recording)
    after_rejection = False
    steps = 0
    while steps < most_steps and not interrupted():
        if cursor[STOP] == stops.size:
            return FINISHED
        t, stop = clock.t[0], stops[cursor[STOP]]
        landing = t + clock.h[0] >= stop
        t_new = stop if landing else t + clock.h[0]
        h = t_new - t
        if h < SHORTEST_STEP_IN_SPACINGS * np.spacing(t) and not landing:
            return COLLAPSED
        reach = clock.reach[0]
        last = min(reach, size.contacts)
        largest = try_step(law, size, state, h, reach)
        counts[STAGE_COUNT] += rk.STAGES
        error = error_norm(largest, relative, absolute)
        if not error <= 1.0:
            counts[REJECTED] += 1
            after_rejection = True
            if math.isnan(error) and h < 1e3 * SHORTEST_STEP_IN_SPACINGS * np.spacing(t):
                return NOT_FINITE
            clock.h[0] = h * (0.1 if math.isnan(error) else min(1.0, factor_of(error)))
            continue
        if changes_sign(state, last):
            if law.alpha < 1.0:
                return OPENED
            allowed = absolute + relative * largest.compression
            at_contact = step_at_contact(law, state, h, last, allowed)
            if at_contact < h and at_contact > SHORTEST_STEP_IN_SPACINGS * np.spacing(t):
                counts[REJECTED_AT_CONTACT] += 1
                clock.h[0] = at_contact
                continue
        evaluate_slopes(law, size, state, state.new_u, rk.NEW_SLOPE, reach)
        noteworthy = output_time <= t_new or level_is_crossed(
            state.u, state.new_u, recording.level, last
        )
        if recording.track_extremes and not noteworthy:
            noteworthy = holds_extreme(
                state.u,
                state.new_u,
                state.d,
                state.new_d,
                state.g if law.kind == PAIR else state.k,
                recording.first_peak,
                h,
                law.gamma,
                recording.level,
                recording.extremes[LARGEST],
                recording.extremes[SMALLEST],
                last,
            )
        if noteworthy:
            if record_step(law, size, state, t, h, t_new, reach, recording):
                counts[STAGE_COUNT] += rk.SLOPES - rk.NEW_SLOPE - 1
            output_time = next_output(recording)
        if recording.track_energy:
            clock.dissipated[0] += dissipated_energy(law, size, state, h, reach)
        accept(state, reach)
        clock.t[0] = t_new
        clock.reach[0] = max(reach, reach_of(size, state.u, state.d, reach))
        counts[ACCEPTED] += 1
        steps += 1
        if landing:
            cursor[STOP] += 1
            clock.h[0] = max(clock.h[0], h)
        growth = factor_of(error)
        if not landing or growth < 1.0:
            clock.h[0] = h * (min(1.0, growth) if after_rejection else growth)
        after_rejection = False
    return RUNNING
