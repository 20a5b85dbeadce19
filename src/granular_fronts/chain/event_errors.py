r"""Errors of located events, from the events of two runs.

Two runs may agree on a single number by chance, on many they do not.  Every event of a contact is a
sample of the error of u or u̇.  The value of an extreme is wrong by :math:`\delta u`, its time by
:math:`\delta\dot u/|\ddot u|`, the time of a passage by :math:`\delta u/|\dot u|`.  The states at a
few times are samples too, those of d for u̇.  An event takes the largest of the samples near it, of
contacts at most `NEAR` away and of times within a factor of `RECENT`. More than `FEW` events of one
kind are enough: each takes the largest difference of those near it.

Of few passages of a level below the error of u, as in the foot of a front, the stated error is a
bound, up to 2000 times the true error, and at most the length of the motion.

The extreme of all contacts and times is the best of many candidates.  Where others come as close to
it as the errors allow, its time and bead are as uncertain as the candidates differ.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.chain.recorder import END, END_TIME, STEEPNESS, TIME, VALUE
from granular_fronts.chain.recording import (
    candidates,
    extremes_of_all,
    front_speed_and_error,
    monitor_times,
    rounding_of,
)
from granular_fronts.numerics.compiled import kernel

# States are compared at times a factor of 2 apart: one of them is always near.
NEAR, RECENT, FEW = 2, math.sqrt(2.0), 5
# Two events are one if u changes by less than this share of its largest from the one to the other.
SAME = 0.01


class Samples(NamedTuple):
    """Errors at the times of events, each of shape (events, contacts), or NaN."""

    time: np.ndarray
    of_u: np.ndarray
    of_rate: np.ndarray
    size: float
    """Largest |u| of the motion."""

    def near_turns(self, time, steepness):
        """Errors of u̇ near turns; that of u over their time scale, (size/|ü|)^½, is a sample."""
        from_u = _near(self.time, self.of_u, time) * np.sqrt(steepness / self.size)
        return np.fmax(_near(self.time, self.of_rate, time), from_u)


def event_errors(scene, recording, refined, contacts):
    """Return the absolute errors, by name, of all variables that hold events.

    `recording` belongs to a run and `refined` to its refinement; `contacts` is how many move.
    """
    if np.isnan(recording.level) and not recording.track_extremes:
        return {}
    names = ("arrival", "opening", "first_peak", "largest", "smallest")
    runs, every = (recording, refined), np.s_[:, 1 : scene.beads.count + 1]
    events = {name: tuple(getattr(one, name)[every] for one in runs) for name in names}
    profiles = [of[every] for one in runs for of in (one.profile_u, one.profile_d)]
    rows = np.searchsorted(recording.profile_times, monitor_times(scene))
    states = [
        (recording.profile_times[row], *(profile[row] for profile in profiles)) for row in rows
    ]
    rounding = 4.0 * np.spacing(np.abs(recording.profile_d[rows]).max(initial=0.0))
    errors, samples = {}, _take_samples(events, states, rounding)
    if not np.isnan(recording.level):
        arrival = _error_of_passage(samples, *events["arrival"])
        times = [one[TIME] for one in events["arrival"]]
        speeds, (speed, *_) = zip(
            *(front_speed_and_error(one, arrival) for one in times), strict=True
        )
        speed = np.fmax(speed, abs(speeds[0] - speeds[1]))
        errors |= {"arrival_time": _largest(arrival), "front_speed": speed}
        peak, other = events["first_peak"]
        errors["first_peak"] = _largest(
            _of_several(
                np.abs(peak[VALUE] - other[VALUE]),
                _near(samples.time, samples.of_u, peak[TIME]),
                peak[TIME],
            )
        )
        errors["first_peak_time"] = _largest(
            _error_of_time(peak, other, samples.near_turns(peak[TIME], peak[STEEPNESS]))
        )
    if recording.track_extremes:
        both = [extremes_of_all(one, contacts) for one in runs]
        rounding = rounding_of(recording, contacts)
        deepest = [np.fmin(one[VALUE], one[END]) for one in events["smallest"]]
        errors |= _of_first_opening(samples, deepest, *events["opening"], *both)
        for kind in ("largest", "smallest"):
            event = events[kind][0][:, :contacts]
            u = np.array([own[:contacts] for _, own, *_ in states])
            errors |= _of_extreme(kind, samples, event, (monitor_times(scene), u), rounding, *both)
    # No time is wrong by more than the motion lasts.
    return {
        name: min(error, scene.end_time) if name.endswith("_time") and error < np.inf else error
        for name, error in errors.items()
    }


def _take_samples(events, states, rounding):
    """Return the errors of u and u̇ that two runs show."""
    ends = [events[name][0][END] for name in ("largest", "smallest")]
    size = max(np.abs(u).max() for u in [*ends, *(u for _, u, *_ in states)])
    none, rows = np.full(ends[0].size, np.nan), []
    for name, (own, other) in events.items():
        moved = np.abs(own[TIME] - other[TIME])
        if name in ("arrival", "opening"):
            change = own[STEEPNESS] * moved
            rows.append((own[TIME], np.where(change < SAME * size, change, np.nan), none))
            continue
        same = own[STEEPNESS] * moved**2 < SAME * size
        of_rate = np.where(same, own[STEEPNESS] * moved, np.nan)
        with np.errstate(invalid="ignore"):  # Infinite where neither has turned.
            change = np.abs(own[VALUE] - other[VALUE])
        rows.append((own[TIME], change, of_rate))
        if name in ("largest", "smallest"):
            # Ends of steps are comparable at the start and the end of the motion.
            change = np.where(own[END_TIME] == other[END_TIME], own[END] - other[END], np.nan)
            rows.append((own[END_TIME], np.abs(change), none))
    for time, u, d, other_u, other_d in states:
        rows.append((np.full(u.size, time), np.abs(u - other_u), np.abs(d - other_d)))
    time, of_u, of_rate = map(np.array, zip(*rows, strict=True))
    size = float(max(size, np.finfo(float).tiny))
    return Samples(time, np.maximum(of_u, np.spacing(size)), np.fmax(of_rate, rounding), size)


def _error_of_passage(samples, own, other):
    """Return the errors of the times at which contacts pass a level."""
    return _error_of_time(own, other, _near(samples.time, samples.of_u, own[TIME]))


def _error_of_time(own, other, error):
    """Return the errors of the times of events, from errors of the quantity that locates them."""
    moved = np.abs(own[TIME] - other[TIME])
    return _of_several(moved, error / own[STEEPNESS], own[TIME])


def _of_several(differences, through, time):
    """Return the errors of events of one kind from differences or, if these are few, samples."""
    several = _near(time[np.newaxis], differences[np.newaxis], time)
    is_few = np.count_nonzero(np.isfinite(differences)) <= FEW
    return np.fmax(several, through) if is_few else several


@kernel
def _near(times, errors, time):
    """Return the largest error near each contact at its own time, shape (contacts,), or NaN."""
    largest = np.full(time.size, np.nan)
    for n in range(time.size):
        if not math.isfinite(time[n]):
            continue
        largest[n] = 0.0
        for m in range(max(0, n - NEAR), min(time.size, n + NEAR + 1)):
            for row in range(len(times)):
                there, error = times[row, m], errors[row, m]
                is_near = there <= RECENT * time[n] and time[n] <= RECENT * there
                if is_near and math.isfinite(error):
                    largest[n] = max(largest[n], error)
    return largest


def _of_first_opening(samples, deepest, own, other, found, refined):
    """Return the errors of the first opening, those of all contacts; infinite if uncertain."""
    names = ("first_gap_time", "first_gap_bead", "first_gap_velocity")
    if np.isnan(found["first_gap_time"]):
        return dict.fromkeys(names, np.nan)
    if np.isnan(refined["first_gap_time"]):
        return dict.fromkeys(names, np.inf)
    first = int(found["first_gap_bead"]) - 1
    of_u = _near(samples.time, samples.of_u, own[TIME])[first]
    width, other_width = (-one[first] for one in deepest)
    if width <= 2.0 * max(of_u, abs(width - other_width)):
        return dict.fromkeys(names, np.inf)  # It touches: the gap is no wider than its error.
    # No other opening may be near the first one, on which alone two runs agree by chance.
    through = of_u / own[STEEPNESS, first]
    error = np.fmax(_error_of_passage(samples, own, other)[first], through)
    rivals = np.flatnonzero(own[TIME] <= found["first_gap_time"] + 2.0 * error)
    rates = np.abs(own[STEEPNESS] - other[STEEPNESS])
    several = _near(own[TIME][np.newaxis], rates[np.newaxis], own[TIME])
    of_rate = np.fmax(several, _near(samples.time, samples.of_rate, own[TIME]))[first]
    beads = 1.0 + np.arange(own[TIME].size)
    return {
        name: max([least, abs(found[name] - refined[name]), *abs(values[rivals] - found[name])])
        for name, least, values in zip(
            names, (error, 0.0, of_rate), (own[TIME], beads, -own[STEEPNESS]), strict=True
        )
    }


def _of_extreme(kind, samples, own, states, rounding, found, refined):
    """Return the errors of value, time and bead of an extreme of all contacts.

    Of a contact that stands still at its extreme the states, times and u, are rivals.
    """
    name = f"{kind}_relative_displacement"
    extreme, time, bead = (found[f"{name}{part}"] for part in ("", "_time", "_bead"))
    n = int(bead) - 1
    moment = np.full(samples.time.shape[1], time)
    of_u = _near(samples.time, samples.of_u, moment)[n] if time > 0.0 else rounding
    steepness = own[STEEPNESS, n]
    of_rate = samples.near_turns(moment, steepness)[n]
    # The best end of a step may pass for a turn by rounding.
    turns = abs(own[VALUE, n] - extreme) <= rounding and steepness > 0.0
    through = of_rate / steepness if turns else 0.0
    moments, u = states
    everywhere = u, np.repeat(moments, u.shape[1]), np.tile(1.0 + np.arange(u.shape[1]), len(u))
    value, times, beads = map(np.append, candidates(own), everywhere)
    distance = np.abs(value - extreme)
    # What rounding adds to an extreme of the start is no rival of it.
    rivals = (distance <= max(2.0 * of_u, 4.0 * rounding)) & (time > 0.0)
    errors = {
        name: [of_u],
        f"{name}_time": [through, *abs(times[rivals] - time)],
        f"{name}_bead": [0.0, *abs(beads[rivals] - bead)],
    }
    return {
        part: float(max(*several, abs(found[part] - refined[part])))
        for part, several in errors.items()
    }


def _largest(errors):
    """Return the largest error that is a number, or NaN."""
    return float(np.fmax.reduce(errors, initial=np.nan))
