r"""The heteroclinic orbit for weak and moderate damping, traced from the far end of its tail.

The orbit starts on the expansion of the stable manifold (`slow_manifold`) beyond the p at which
:math:`y = e^{-p}` underflows, and Taylor steps (`taylor`) carry it towards (1, 0).  At y = ½, which
is s = 0 by definition, s is set to zero and the steps start anew.  So the s of every later step is
exact, however many turns follow.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_kdv_burgers.slow_manifold import expand, state_on_manifold
from granular_fronts.continuum.log_kdv_burgers.taylor import (
    AT_REST,
    RUNNING,
    Accuracy,
    evaluate_steps,
    follow,
    locate,
    locate_turns,
    make_point,
    series_slope,
)
from granular_fronts.errors import InputError
from granular_fronts.numerics.polynomials import polynomial

START_P = 760.0
"""p at which the trace starts: y = e^(−745) is the last double above zero."""

START_TERMS = 24
MOST_STEPS = 200_000
ROOM = 512


USUAL_STEPS = Accuracy(order=20, tolerance=1e-17, contraction=6.0)
FINER_STEPS = Accuracy(order=26, tolerance=1e-20, contraction=5.0)
"""For error estimates: another order, and steps of another length."""


class Steps(NamedTuple):
    """Stored Taylor steps towards smaller s."""

    starts: np.ndarray  # s at the start of each step, decreasing, shape (steps,)
    jets: np.ndarray  # series of p in powers of s − start, shape (steps, order + 1)
    end: float  # s at the end of the last step


class TracedOrbit(NamedTuple):
    """The orbit for μ < `slow_manifold.STIFF_DAMPING`, from its tail to the last s asked for."""

    mu: float
    tail: Steps  # the part in s ≥ 0, where y ≤ ½
    front: Steps  # the part in s ≤ 0
    # Whether the orbit has come within `taylor.REST` of (1, 0), where the front then ends.
    at_rest: bool

    def evaluate(self, s):
        """Return p and v at each s, which must be traced or lie beyond the rest of the orbit."""
        p, v = np.empty(s.size), np.empty(s.size)
        ahead = s >= 0.0
        for steps, part in ((self.tail, ahead), (self.front, ~ahead)):
            p_part, v_part = np.empty(part.sum()), np.empty(part.sum())
            evaluate_steps(*steps, s[part], p_part, v_part)
            p[part], v[part] = p_part, v_part
        return p, v

    def s_at(self, p):
        """Return the largest s at which −ln y is p < `START_P`; the last one traced if none is."""
        steps = self.tail if p > math.log(2.0) else self.front
        below = np.flatnonzero(steps.jets[1:, 0] <= p)
        index = below[0] if below.size else len(steps.starts) - 1
        ends = np.append(steps.starts[1:], steps.end)
        return steps.starts[index] + locate(steps.jets[index], p, ends[index] - steps.starts[index])

    def turning_points(self):
        """Return the positions and p of every traced extremum of y, from the first maximum on."""
        s, p = np.empty(self.front.starts.size), np.empty(self.front.starts.size)
        count = locate_turns(*self.front, s, p)
        return s[:count], p[:count]

    def counts(self):
        """Return the method and work, for the attributes of a dataset."""
        return {
            "method": "Taylor series from the far tail",
            "steps": len(self.tail.starts) + len(self.front.starts),
            "order": self.front.jets.shape[1] - 1,
        }


def trace_orbit(mu, s_stop, accuracy=USUAL_STEPS):
    """Trace the orbit for μ ≥ 0 from the far end of its tail to `s_stop`; −inf is all there is.

    An s_stop that is more than `MOST_STEPS` steps away is an InputError.
    """
    v = math.sqrt(START_P + 0.5 + 0.25 * mu**2) - 0.5 * mu
    p, e = state_on_manifold(mu, expand(mu, START_TERMS), v)
    energies = np.empty(accuracy.order + 1)
    tail, _ = _collect(mu, accuracy, make_point(0.0, v, e, p), -math.inf, math.log(2.0), energies)
    half = locate(tail.jets[-1], math.log(2.0), tail.end - tail.starts[-1])
    v, e = series_slope(tail.jets[-1], half), polynomial(energies, half)
    at_half = make_point(0.0, v, e, math.log(2.0))
    # Differences of the clock are exact; its sum with a small s would not be.
    tail = Steps((tail.starts - tail.starts[-1]) - half, tail.jets, 0.0)
    front, status = _collect(mu, accuracy, at_half, s_stop, -math.inf, energies)
    return TracedOrbit(mu, tail, front, status == AT_REST)


def _collect(mu, accuracy, point, s_stop, p_stop, energies):
    """Return the steps from a point to a stop, and the status they end with."""
    starts, jets, total, status, room = [], [], 0, RUNNING, ROOM
    while status == RUNNING:
        if total >= MOST_STEPS:
            raise InputError(
                f"For mu = {mu} the orbit turns so often that {MOST_STEPS} steps lead only to "
                f"s = {point.s:.6g}: ask for nothing before that, or for a larger mu."
            )
        more_starts, more_jets = np.empty(room), np.empty((room, accuracy.order + 1))
        steps, status = follow(
            mu, accuracy, point, s_stop, p_stop, more_starts, more_jets, energies
        )
        starts.append(more_starts[:steps])
        jets.append(more_jets[:steps])
        total += steps
        room = min(2 * room, 8192)
    return Steps(np.concatenate(starts), np.concatenate(jets), float(point.s)), status
