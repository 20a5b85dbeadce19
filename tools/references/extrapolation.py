"""Long-double integration of chains whose contacts open and close.

The unknowns are the contacts u_n and momenta w_n of `Flow`, in 80-bit arithmetic; the forces are
max(u_n, 0)^{3/2}. A step is Gragg's smoothed midpoint rule extrapolated in h² (Bulirsch and Stoer),
column by column until two neighbouring columns agree to the tolerance. Its weights are ratios of
integers, so that round-off is the only floor. The step advances increments, which are added with a
running compensation.

A force is only C^{3/2} where a contact opens or closes. No extrapolation holds its order across
such an instant, and an error estimate may miss it. The steps are therefore graded geometrically
towards every zero of every u_n and away from it again, and the one step that straddles the zero
must be so short that the whole contribution of the kink, (γ + h) h |Δu|^{3/2}, is below its own
tolerance.
"""

from dataclasses import dataclass

import numpy as np

REAL = np.longdouble


@dataclass(frozen=True)
class Settings:
    """Choices of one run."""

    sequence: tuple[int, ...]  # even, increasing numbers of substeps, one per column
    tolerance: float  # largest accepted difference of neighbouring columns, maximum norm
    kink_tolerance: float  # largest accepted contribution of one opening or closing contact


@dataclass
class Counts:
    """Work of one run; `straddling` counts accepted steps that hold an opening or closing."""

    accepted: int = 0
    rejected_error: int = 0
    rejected_kink: int = 0
    straddling: int = 0
    right_hand_sides: int = 0


def require_extended_precision():
    """Refuse a platform whose ``numpy.longdouble`` has no 64-bit significand."""
    bits = np.finfo(REAL).nmant + 1
    if bits < 64:
        raise RuntimeError(
            f"numpy.longdouble has a significand of {bits} bits here and 64 are needed; "
            "rebuild the reference on an x86-64 Linux machine"
        )


class Flow:
    """Motion of contacts and momenta in a packed state (u, w).

    A subclass gives `contacts` (how many of them come first in a state), `start()` (the packed
    state at t = 0), `derivative(state)` (which counts its `evaluations`) and `finish(state)` (what
    is kept of a state).  The double γ, extended exactly, is that of the problem.
    """

    def __init__(self, gamma):
        self.gamma = REAL(gamma)
        self.evaluations = 0

    def split(self, state):
        """Return views (u, w) of a packed state."""
        return state[: self.contacts], state[self.contacts :]

    def regrow(self, *packed):
        """Return the arrays, of more beads where a wave needs them."""
        return packed


def midpoint_slope(flow, state, slope, step, substeps, low, high):
    """Return the mean slope of a smoothed midpoint step from a state and its derivative.

    The number of substeps is even.  Extremes of each contact, (low, high), are widened in place.
    """
    small = step / substeps
    contacts = flow.contacts
    # Sums of slopes, not increments: the rounding of step / substeps then stays out of the result,
    # where the extrapolation would enlarge it into a drift.
    previous = np.zeros_like(state)
    current = slope.copy()
    for index in range(substeps):
        stage = state + small * current
        np.minimum(low, stage[:contacts], out=low)
        np.maximum(high, stage[:contacts], out=high)
        rate = flow.derivative(stage)
        if index < substeps - 1:
            previous += 2 * rate
            previous, current = current, previous
    return (previous + current + rate) / (2 * substeps)


def extrapolate(flow, state, slope, step, settings):
    """Return (increment, error, column, low, high) of one extrapolated step.

    `column` counts from 1; the step has failed when `error` exceeds the tolerance.
    """
    contacts = flow.contacts
    low, high = state[:contacts].copy(), state[:contacts].copy()
    squares = [substeps**2 for substeps in settings.sequence]
    above = []
    error = REAL(np.inf)
    for column, substeps in enumerate(settings.sequence):
        row = [midpoint_slope(flow, state, slope, step, substeps, low, high)]
        for back in range(1, column + 1):
            older = squares[column - back]
            difference = row[-1] - above[back - 1]
            row.append(row[-1] + older * difference / (squares[column] - older))
        if column:
            error = step * np.max(np.abs(row[-1] - row[-2]))
        above = row
        # A step that agrees after very few columns may have been lucky.
        if column >= 3 and error <= settings.tolerance:
            break
    return step * row[-1], error, column + 1, low, high


def kink_contribution(flow, size, step):
    """Return (γ + h) h |Δu|^{3/2}, the most that a kink of depth `size` adds within one step."""
    return (flow.gamma + step) * step * size * np.sqrt(size)


def largest_kink(flow, low, high, step):
    """Return the largest contribution of a contact that changes sign between `low` and `high`."""
    depth = np.maximum(np.minimum(high, -low), 0)
    # Noise around zero ahead of the wave is no crossing.
    crossing = kink_contribution(flow, depth, step) > REAL("1e-28")
    if not crossing.any():
        return REAL(0)
    return np.max(kink_contribution(flow, (high - low)[crossing], step))


def limit_to_crossings(flow, state, slope, step, settings):
    """Shorten `step` so that it ends before the next opening or closing, or only just beyond it."""
    contact, _ = flow.split(state)
    rate, _ = flow.split(slope)
    nearing = contact * rate < 0
    size = np.abs(contact[nearing])
    ahead = size / np.abs(rate[nearing])
    harmful = kink_contribution(flow, size, step) > settings.kink_tolerance
    relevant = harmful & (ahead < 2 * step)
    if not relevant.any():
        return step
    size, ahead = size[relevant], ahead[relevant]
    crossable = kink_contribution(flow, 2 * size, 2 * ahead) < settings.kink_tolerance
    return min(step, np.min(np.where(crossable, REAL(1.5), REAL(0.6)) * ahead))


def integrate(flow, times, settings):
    """Integrate a flow; return what it keeps at each of increasing times, and counts."""
    counts = Counts()
    state = flow.start()
    carry = np.zeros_like(state)
    now, step = REAL(0), REAL("1e-7")
    states = []
    for goal in map(REAL, times):
        while now < goal:
            slope = flow.derivative(state)
            wanted = on_clock(limit_to_crossings(flow, state, slope, step, settings))
            trial = min(wanted, goal - now)
            increment, error, column, low, high = extrapolate(flow, state, slope, trial, settings)
            kink = largest_kink(flow, low, high, trial)
            if error > settings.tolerance:
                counts.rejected_error += 1
                step = trial * shrink_factor(error, settings)
                continue
            if kink > settings.kink_tolerance:
                counts.rejected_kink += 1
                step = trial / 2
                continue
            counts.accepted += 1
            counts.straddling += bool(kink)
            carry += increment
            advanced = state + carry
            carry -= advanced - state
            state = advanced
            now = goal if trial == goal - now else now + trial
            grown = trial * growth_factor(error, column, settings)
            step = max(grown, wanted) if trial < wanted else grown
            state, carry = flow.regrow(state, carry)
        states.append(flow.finish(state))
    counts.right_hand_sides = flow.evaluations
    return states, counts


def on_clock(step):
    """Round a step to a multiple of 2⁻⁵⁰, so that the sum of all steps carries no error."""
    return max(np.floor(step * REAL(2) ** 50), REAL(1)) / REAL(2) ** 50


def shrink_factor(error, settings):
    """Return the factor for a step whose last column missed the tolerance by `error`."""
    power = 1 / (2 * len(settings.sequence) - 1)
    return REAL(max(0.1, 0.8 * float(settings.tolerance / error) ** power))


def growth_factor(error, column, settings):
    """Return the factor after a step accepted at `column`."""
    missing = len(settings.sequence) - column
    if missing >= 2:
        return REAL(2)
    if missing == 1:
        return REAL(1.15)
    power = 1 / (2 * column - 1)
    return REAL(min(1.1, 0.9 * float(settings.tolerance / max(error, REAL("1e-22"))) ** power))
