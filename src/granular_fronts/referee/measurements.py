"""One number of a motion that depends on its damping, and the damping that follows from it.

=============  ================================================================================
front          overshoot: first peak of u between states, over δ, in the middle of the chain
contact_loss   velocity of the last bead at the end, over δ^(5/4)
striker        peak of u between states in the middle of the chain, over δ
collision      velocity at which the beads part, over their impact velocity: restitution
=============  ================================================================================

A peak is taken from the cubic between two states that has u and its rate at both.  With states 0.5
apart it differs from the first peak of the motion by up to a share of 1.3e-4.  Results and accurate
motions are treated alike, so that the number says only the damping.  It says nothing where it does
not fall with the damping, for example in an overdamped front, which has no peak.
"""

import numpy as np

from granular_fronts.studies.half_step_damping import excess_by_table
from granular_fronts.studies.half_step_motions import cubic_between

LEAST_FALL = 1.0e-4  # of a measurement from one tabulated damping to the next, relative

NAMES = {
    "front": "overshoot between states in the middle",
    "contact_loss": "velocity of the last bead",
    "striker": "peak between states in the middle",
    "collision": "coefficient of restitution",
}


def scale_of(problem):
    """Return the scale of the number: δ, or the velocity of the beads behind a front."""
    if problem.motion in ("front", "striker"):
        return problem.displacement
    return velocity_scale(problem)


def velocity_scale(problem):
    """Return δ^((α + 1)/2)."""
    return problem.displacement ** (0.5 * (problem.scene["law"]["alpha"] + 1.0))


def read_motion(problem, t, u, v):
    """Return number that says the damping, from u (T, N − 1) and v (T, N); NaN without a peak."""
    if problem.motion == "contact_loss":
        found = float(v[-1, -1])
    elif problem.motion == "collision":
        found = float(v[-1, 1] - v[-1, 0])
    else:
        middle = problem.scene["beads"] // 2
        found = first_peak(t, u[:, middle - 1], v[:, middle - 1] - v[:, middle])
    return found / scale_of(problem)


def excess_damping(measurement, factors, table):
    """Return γ of the accurate motion with the same number, over γ, less 1; NaN if undefined.

    `table` holds the accurate numbers at the dampings `factors` times γ.
    """
    falls = np.diff(table).max() < -LEAST_FALL * abs(table[0])
    return float(excess_by_table(np.array(measurement), factors, table)) if falls else np.nan


def first_peak(t, u, rate):
    """Return first maximum of u, after it has come to half its largest value; NaN without one."""
    falls = (u[1:] > 0.5 * u.max()) & (rate[1:] < 0.0) & (rate[:-1] >= 0.0)
    if not falls.any():
        return np.nan
    state = int(np.argmax(falls))
    curve = cubic_between(t, u, rate, state)
    turns = curve.derivative().roots(extrapolate=False)
    return float(curve(turns[:1])[0]) if turns.size else float(u[state : state + 2].max())
