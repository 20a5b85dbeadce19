"""Long-double reference states of the granular chain of James (2021), section 3.3.

Beads n = 1 … N obey eqs. (31)–(32) of G. James, Nonlinearity 34 (2021) 1758, with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

where u_n = x_n - x_{n+1}. The left end is pressed (u_0 = δ), the right end is free (u_N = 0), and
the chain is at rest and just touching at t = 0: u_n = 0 and x_n' = 0, so that w_1 = -γ F(δ) and
all other w_n = 0.

Method. The unknowns are (u_n, w_n), with u_n' = x_n' - x_{n+1}', in 80-bit arithmetic. A step is
Gragg's smoothed midpoint rule extrapolated in h² (Bulirsch and Stoer), column by column until two
neighbouring columns agree to the tolerance. Its weights are ratios of integers, so that round-off
is the only floor. The step advances increments, which are added with a running compensation.

F is only C^{3/2} where a contact opens or closes. No extrapolation holds its order across such an
instant, and an error estimate may miss it. The steps are therefore graded geometrically towards
every zero of every u_n and away from it again, and the one step that straddles the zero must be so
short that the whole contribution of the kink, (γ + h) h |Δu|^{3/2}, is below a tolerance of its own.

Each state is computed twice, with another sequence of substeps, another number of columns and
other tolerances. The largest difference of the two is the error stated for it.

Run ``python make_chain_reference.py --help`` for the command line.
"""

import argparse
import json
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import xarray as xr

REAL = np.longdouble
BEADS = 420
DELTA = 0.1
NEGLIGIBLE = REAL("1e-60")
WINDOW_MARGIN = 8
CASES = {0.06: (700.0, 2600.0, 3000.0), 0.65: (700.0,)}


@dataclass(frozen=True)
class Settings:
    """Choices of one run.

    Attributes
    ----------
    sequence : tuple of int
        Even, increasing numbers of substeps, one per extrapolation column.
    tolerance : float
        Largest accepted difference of neighbouring columns in one step, maximum norm.
    kink_tolerance : float
        Largest accepted contribution of one opening or closing contact.
    """

    sequence: tuple[int, ...]
    tolerance: float
    kink_tolerance: float


FINE = Settings((2, 4, 6, 8, 10, 12, 14, 16, 18, 20), 3e-19, 1e-21)
CHECK = Settings((2, 4, 6, 8, 12, 16, 24, 32), 2e-18, 1e-20)


@dataclass
class Counts:
    """Work of one run: steps accepted, steps rejected (error, kink), right-hand sides."""

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


class Chain:
    """Right-hand side of the chain in (u_1 … u_{N-1}, w_1 … w_N), cut to the beads in motion.

    Parameters
    ----------
    gamma : float
        Damping; its double value, extended exactly, defines the problem. So do those of `delta`.
    delta : float
        Compression held at the left end.
    beads : int
        N.
    """

    def __init__(self, gamma, delta=DELTA, beads=BEADS):
        self.gamma = REAL(gamma)
        self.delta = REAL(delta)
        self.beads = beads
        self.evaluations = 0
        self.resize(min(beads, WINDOW_MARGIN))

    def resize(self, active):
        """Keep the first `active` beads; the contact to the right of the last one carries nothing."""
        self.active = active
        self.force = np.zeros(active + 1, dtype=REAL)
        self.force[0] = self.delta * np.sqrt(self.delta)

    def rest(self):
        """Return the start: every contact closed without force, every bead at rest."""
        state = np.zeros(2 * self.active - 1, dtype=REAL)
        state[self.active - 1] = -self.gamma * self.force[0]
        return state

    def split(self, state):
        """Return views (u, w) of a packed state."""
        return state[: self.active - 1], state[self.active - 1 :]

    def rates(self, state):
        """Return (w', x') for a packed state."""
        contact, momentum = self.split(state)
        inner = self.force[1:-1]
        np.maximum(contact, 0, out=inner)
        inner *= np.sqrt(inner)
        momentum_rate = self.force[:-1] - self.force[1:]
        return momentum_rate, momentum + self.gamma * momentum_rate

    def derivative(self, state):
        """Return the time derivative of a packed state."""
        self.evaluations += 1
        momentum_rate, velocity = self.rates(state)
        out = np.empty_like(state)
        np.subtract(velocity[:-1], velocity[1:], out=out[: self.active - 1])
        out[self.active - 1 :] = momentum_rate
        return out

    def regrow(self, *packed):
        """Cut negligible tails and widen the window ahead of the wave; return the new arrays."""
        parts = [[part.copy() for part in self.split(state)] for state in packed]
        contact, momentum = parts[0]
        contact[np.abs(contact) < NEGLIGIBLE] = 0
        momentum[np.abs(momentum) < NEGLIGIBLE] = 0
        moving = np.flatnonzero(contact)
        reached = moving[-1] + 2 if moving.size else 1
        wanted = min(self.beads, reached + WINDOW_MARGIN)
        if wanted <= self.active:
            return [np.concatenate(pair) for pair in parts]
        extra = np.zeros(wanted - self.active, dtype=REAL)
        self.resize(wanted)
        return [np.concatenate([u, extra, w, extra]) for u, w in parts]

    def finish(self, state):
        """Return (u_1 … u_N, x_1' … x_N') of the whole chain."""
        contact, _ = self.split(state)
        _, velocity = self.rates(state)
        whole = np.zeros((2, self.beads), dtype=REAL)
        whole[0, : contact.size] = contact
        whole[1, : velocity.size] = velocity
        return whole[0], whole[1]


def midpoint_slope(chain, state, slope, step, substeps, low, high):
    """Return the mean slope of a smoothed midpoint step and widen (low, high) to its contacts.

    Parameters
    ----------
    chain : Chain
    state, slope : ndarray of longdouble
        State at the start of the step and its derivative.
    step : longdouble
    substeps : int
        Even.
    low, high : ndarray of longdouble
        Extremes of each contact over all stages, updated in place.

    Returns
    -------
    ndarray of longdouble
        Increment of the state divided by `step`.
    """
    small = step / substeps
    contacts = chain.active - 1
    # Sums of slopes, not increments: the rounding of step / substeps then stays out of the result,
    # where the extrapolation would enlarge it into a drift.
    previous = np.zeros_like(state)
    current = slope.copy()
    for index in range(substeps):
        stage = state + small * current
        np.minimum(low, stage[:contacts], out=low)
        np.maximum(high, stage[:contacts], out=high)
        rate = chain.derivative(stage)
        if index < substeps - 1:
            previous += 2 * rate
            previous, current = current, previous
    return (previous + current + rate) / (2 * substeps)


def extrapolate(chain, state, slope, step, settings):
    """Return (increment, error, column, low, high) of one extrapolated step.

    `column` counts from 1; the step has failed when `error` exceeds the tolerance.
    """
    contacts = chain.active - 1
    low, high = state[:contacts].copy(), state[:contacts].copy()
    squares = [substeps**2 for substeps in settings.sequence]
    above = []
    error = REAL(np.inf)
    for column, substeps in enumerate(settings.sequence):
        row = [midpoint_slope(chain, state, slope, step, substeps, low, high)]
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


def kink_size(chain, low, high, step):
    """Return the largest contribution of a contact that changes sign between `low` and `high`."""
    depth = np.minimum(high, -low)
    depth = np.maximum(depth, 0)
    truly = chain_kink(chain, depth, step) > 1e-28
    if not truly.any():
        return REAL(0)
    return np.max(chain_kink(chain, (high - low)[truly], step))


def chain_kink(chain, size, step):
    """Return (γ + h) h |Δu|^{3/2}, what a kink adds to the state within one step."""
    return (chain.gamma + step) * step * size * np.sqrt(size)


def limit_to_crossings(chain, state, slope, step, settings):
    """Shorten `step` so that it stops short of the next opening or closing, or just straddles it."""
    contact = state[: chain.active - 1]
    rate = slope[: chain.active - 1]
    nearing = contact * rate < 0
    size = np.abs(contact[nearing])
    ahead = size / np.abs(rate[nearing])
    relevant = (ahead < 2 * step) & (chain_kink(chain, size, step) > settings.kink_tolerance)
    if not relevant.any():
        return step
    size, ahead = size[relevant], ahead[relevant]
    jump = chain_kink(chain, 2 * size, 2 * ahead) < settings.kink_tolerance
    return min(step, np.min(np.where(jump, REAL(1.5), REAL(0.6)) * ahead))


def integrate(gamma, times, settings, delta=DELTA, beads=BEADS, verbose=False):
    """Integrate the chain from rest.

    Parameters
    ----------
    gamma : float
        Damping, ≥ 0.
    times : sequence of float
        Increasing output times.
    settings : Settings
    delta, beads : float, int
        Boundary compression and number of beads.
    verbose : bool
        Print the progress.

    Returns
    -------
    states : list of (ndarray, ndarray)
        (u_1 … u_N, x_1' … x_N') at each time, longdouble, shape (N,) each.
    counts : Counts
    """
    chain = Chain(gamma, delta, beads)
    counts = Counts()
    state = chain.rest()
    carry = np.zeros_like(state)
    now, step = REAL(0), REAL("1e-7")
    states = []
    for goal in map(REAL, times):
        while now < goal:
            slope = chain.derivative(state)
            wanted = limit_to_crossings(chain, state, slope, step, settings)
            trial = min(on_clock(wanted), goal - now)
            increment, error, column, low, high = extrapolate(chain, state, slope, trial, settings)
            kink = kink_size(chain, low, high, trial)
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
            step = max(trial * growth_factor(error, column, settings), step if trial < wanted else 0)
            state, carry = chain.regrow(state, carry)
            if verbose and counts.accepted % 500 == 0:
                print(f"t = {float(now):.3f}  h = {float(trial):.2e}  {counts}", flush=True)
        states.append(chain.finish(state))
    counts.right_hand_sides = chain.evaluations
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


if __name__ == "__main__":
    t0 = time.time()
    integrate(0.06, (100.0,), FINE, verbose=True)
    print(time.time() - t0)
