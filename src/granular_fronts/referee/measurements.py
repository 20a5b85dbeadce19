"""One number of a motion that depends on its damping, and the damping that follows from it.

=============  ================================================================================
front          overshoot: first peak of u between states, over δ, in the middle of the chain
contact_loss   velocity of the last bead at the end, over δ^(5/4)
striker        peak of u between states in the middle of the chain, over δ
collision      velocity at which the beads part, over their impact velocity: restitution
plate          velocity at which the bead leaves the plate, over its impact velocity: the same
drop           velocity of the bead at the end, upward, over that of its impact
solitary_wave  speed of the pulse over the sixth root of its largest force, in the middle
=============  ================================================================================

A peak is taken from the cubic between two states that has u and its rate at both.  With states 0.5
apart it differs from the first peak of the motion by up to a share of 1.3e-4.  Results and accurate
motions are treated alike, so that the number says only the damping.  It says nothing where it does
not fall with the damping, for example in an overdamped front, which has no peak.

A solitary wave is as fast as the sixth root of its force allows, whatever its height.  Nesterenko
derived this for long waves, and Coste, Falcon and Fauve measured it in a chain of beads.
"""

import numpy as np
from scipy.interpolate import CubicHermiteSpline, KroghInterpolator

from granular_fronts.referee.settings import APART

LEAST_FALL = 1.0e-4  # of a measurement from one tabulated damping to the next, relative

NAMES = {
    "front": "overshoot between states in the middle",
    "contact_loss": "velocity of the last bead",
    "striker": "peak between states in the middle",
    "collision": "coefficient of restitution",
    "plate": "coefficient of restitution",
    "drop": "velocity at the end",
    "solitary_wave": "speed over the sixth root of the force",
}


def scale_of(problem):
    """Return the scale of the number: δ, or the velocity of the beads behind a front."""
    if problem.motion in ("front", "striker", "solitary_wave"):
        return problem.displacement
    return problem.front_velocity


def read_motion(problem, t, u, v):
    """Return number that says the damping, from u (T, N − 1) and v (T, N); NaN without a peak."""
    if problem.motion == "solitary_wave":
        return _speed_over_force(t, u, v, problem.scene.beads.count // 2)
    if problem.motion == "contact_loss":
        found = float(v[-1, -1])
    elif problem.wall:
        found = -float(v[-1, 0])
    elif problem.motion == "collision":
        found = float(v[-1, 1] - v[-1, 0])
    else:
        middle = problem.scene.beads.count // 2
        found = _peak_at(t, u, v, middle)[1]
    return found / scale_of(problem)


def _speed_over_force(t, u, v, middle):
    """The force u^(3/2) has the sixth root u^(1/4)."""
    before, after = (_peak_at(t, u, v, middle + shift)[0] for shift in (-APART, APART))
    return 2.0 * APART / (after - before) / _peak_at(t, u, v, middle)[1] ** 0.25


def _peak_at(t, u, v, contact):
    return first_peak(t, u[:, contact - 1], v[:, contact - 1] - v[:, contact])


def excess_damping(measurement, factors, table):
    """Return γ of the accurate motion with the same number, over γ, less 1; NaN if undefined.

    `table` holds the accurate numbers at the dampings `factors` times γ.
    """
    falls = np.diff(table).max() < -LEAST_FALL * abs(table[0])
    return float(excess_by_table(np.array(measurement), factors, table)) if falls else np.nan


def first_peak(t, u, rate):
    """Return time and value of the first maximum of u above half its largest; NaN without one."""
    falls = (u[1:] > 0.5 * u.max()) & (rate[1:] < 0.0) & (rate[:-1] >= 0.0)
    if not falls.any():
        return np.nan, np.nan
    state = int(np.argmax(falls))
    curve = cubic_between(t, u, rate, state)
    turns = curve.derivative().roots(extrapolate=False)
    best = turns[0] if turns.size else t[state + int(np.argmax(u[state : state + 2]))]
    return float(best), float(curve(best))


def excess_by_table(peaks, factors, table):
    """Return γ of the accurate motion with a number, over γ, less 1; NaN beyond the table."""
    within = np.clip(peaks, min(table), max(table))
    # Barycentric weights of SciPy are multiplied in random order, unlike these differences.
    logarithm = KroghInterpolator(table, np.log(factors))
    return np.where(within == peaks, np.expm1(logarithm(within)), np.nan)


def cubic_between(t, u, rate, state):
    """Return the cubic that has u and its rate at a state and at the next."""
    pair = slice(state, state + 2)
    return CubicHermiteSpline(t[pair], u[pair], rate[pair])
