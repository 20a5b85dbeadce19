r"""Reference states of a driven chain in extended precision, by another method in other variables.

The unknowns are :math:`(u_n, w_n)`, James (2021), eqs. (31)-(32),

.. math:: \dot u_n = \dot x_n - \dot x_{n+1}, \qquad
    \dot x_n = w_n + \gamma\,(u_{n-1,+}^\beta - u_{n,+}^\beta), \qquad
    \dot w_n = u_{n-1,+}^\alpha - u_{n,+}^\alpha ,

with pressure at the ends.  A step is Gragg's smoothed midpoint rule, extrapolated in :math:`h^2`
(Hairer, Norsett, Wanner, *Solving Ordinary Differential Equations I*, section II.9), in
`longdouble` arithmetic.  Its weights are ratios of integers, so that no coefficient is rounded to a
double.  It shares no code, no variables and no formula with the integrator of
`granular_fronts.chain`.

Events.  No step is aware of a contact that opens or closes; the method serves motions whose
contacts stay closed once they have closed.  Everything is solved twice, with other columns and
another tolerance; the difference is the error of the reference.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.accuracy import with_refinement
from granular_fronts.errors import SolveError

REAL = np.longdouble
SEQUENCE, OTHER_SEQUENCE = (2, 4, 6, 8, 12, 16, 24, 32), (2, 4, 6, 8, 10, 12, 14)
TOLERANCE, OTHER_TOLERANCE = REAL("1e-17"), REAL("1e-16")
FEWEST_COLUMNS = 4
FIRST_STEP = REAL("1e-4")
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.8, 0.1, 2.0


class Reference(NamedTuple):
    """Relative displacements and velocities at the end, both of shape (N,), and their error."""

    relative_displacement: np.ndarray
    velocity: np.ndarray
    error: float


class Motion(NamedTuple):
    """A driven chain.

    Attributes
    ----------
    law : mapping
        Exponents `alpha`, `beta` and damping `gamma`.
    left, right : float
        Relative displacements held at the ends.
    relative_displacement, velocity : ndarray, shape (N - 1,) and (N,)
        At t = 0.
    """

    law: dict
    left: float
    right: float
    relative_displacement: np.ndarray
    velocity: np.ndarray


def reference_state(motion, end_time):
    """State at `end_time` with an error estimate.

    Raises
    ------
    SolveError
        If `numpy.longdouble` has no 64-bit significand here.
    """
    if np.finfo(REAL).nmant < 63:
        raise SolveError(
            f"numpy.longdouble has a significand of {np.finfo(REAL).nmant + 1} bits here and 64 "
            "are needed for a reference: measure the hard cases on an x86-64 machine."
        )
    kept, other = with_refinement(
        lambda resolution: _integrate(motion, REAL(end_time), *resolution),
        (SEQUENCE, TOLERANCE),
        (OTHER_SEQUENCE, OTHER_TOLERANCE),
    )
    error = max(float(np.abs(a - b).max()) for a, b in zip(kept, other, strict=True))
    return Reference(*(part.astype(float) for part in kept), error)


def _contact_forces(motion, u, exponent):
    """The forces of the contacts 0 … N, the ends held; shape (N + 1,)."""
    closed = np.maximum(np.concatenate([[motion.left], u, [motion.right]]).astype(REAL), 0)
    return closed ** REAL(exponent)


def _velocities(motion, u, w):
    damping = _contact_forces(motion, u, motion.law["beta"])
    return w + REAL(motion.law["gamma"]) * (damping[:-1] - damping[1:])


def _derivative(motion, state):
    u, w = state[: motion.velocity.size - 1], state[motion.velocity.size - 1 :]
    force = _contact_forces(motion, u, motion.law["alpha"])
    velocity = _velocities(motion, u, w)
    return np.concatenate([velocity[:-1] - velocity[1:], force[:-1] - force[1:]])


def _integrate(motion, end_time, sequence, tolerance):
    u = np.asarray(motion.relative_displacement, dtype=REAL)
    w = np.asarray(motion.velocity, dtype=REAL)
    w = 2 * w - _velocities(motion, u, w)
    state, now, h = np.concatenate([u, w]), REAL(0), FIRST_STEP
    scale = max(1.0, motion.left)
    while now < end_time:
        step = min(h, end_time - now)
        increment, error = _extrapolate(motion, state, step, sequence, tolerance * scale)
        if error <= tolerance * scale:
            state = state + increment
            now = end_time if step == end_time - now else now + step
        power = 1.0 / (2 * len(sequence) - 1)
        factor = SAFETY * float(tolerance * scale / max(error, REAL("1e-30"))) ** power
        grown = step * REAL(min(LARGEST_FACTOR, max(SMALLEST_FACTOR, factor)))
        h = max(h, grown) if step < h else grown
    u, w = state[: u.size], state[u.size :]
    return np.append(u, REAL(motion.right)), _velocities(motion, u, w)


def _extrapolate(motion, state, step, sequence, tolerance):
    """Increment over a step and the difference of the last two columns."""
    slope, above, error = _derivative(motion, state), [], REAL(np.inf)
    for column, substeps in enumerate(sequence):
        row = [_midpoint(motion, state, slope, step, substeps)]
        for back in range(1, column + 1):
            ratio = REAL(substeps) / sequence[column - back]
            row.append(row[-1] + (row[-1] - above[back - 1]) / (ratio**2 - 1))
        if column:
            error = step * np.max(np.abs(row[-1] - row[-2]))
        above = row
        # A step that agrees after very few columns may have been lucky.
        if column >= FEWEST_COLUMNS and error <= tolerance:
            break
    return step * above[-1], error


def _midpoint(motion, state, slope, step, substeps):
    """Mean slope over a step of the smoothed midpoint rule."""
    small = step / substeps
    previous, current = np.zeros_like(state), slope
    for _ in range(substeps - 1):
        rate = _derivative(motion, state + small * current)
        previous, current = current, previous + 2 * rate
    rate = _derivative(motion, state + small * current)
    return (previous + current + rate) / (2 * substeps)
