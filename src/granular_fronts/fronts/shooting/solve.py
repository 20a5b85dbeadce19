r"""Exact fronts by shooting, James (2021), section 6.

A front of δ = c = 1 solves the over-determined `equations`: the flow of a window over one
bead-time, shifted back by one contact, returns the window.

They are solved from an `initial_guess`, in a `window` as long as the tails need.  That u is below
`UNTOUCHED` at the last contact, and below 1/2 everywhere ahead of bead 0, is checked.

Accuracy.  The residual falls to a few units of the last digit.  For α near 1 one combination of the
equations, the conserved sums over the window, hardly depends on u.  `bead_flow` takes care of the
rounding in it, and the front is found to 1e-12 for α ≥ 1.02.

Steps.  The flow is repeated with twice the steps.  If it differs by more than `FLOW_ERROR`, the
steps are doubled and the solve goes on.

Between.  While a window flows, contact n passes through all of the front between n and n − 1,
:math:`u_n(t) = U(n - t)`, exact to the integrator.

Behind.  The window ends where the tail is a sum of modes to round-off (`window`), with amplitudes
that the shot has found.  A mode of u that goes like :math:`e^{\lambda\xi}` has the velocity

.. math:: \dot x - 1 = \frac{\lambda}{e^{\lambda} - 1}\, e^{\lambda\xi},

since :math:`\dot x(\xi) - \dot x(\xi + 1) = \dot u = -u'`.

The rest of section 6 is not in our copy of the paper: closure, window and band are ours.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.shooting import bead_flow, equations, initial_guess
from granular_fronts.fronts.shooting.bead_flow import PowerLaw
from granular_fronts.fronts.shooting.equations import Window, descend, join, largest, split
from granular_fronts.fronts.shooting.window import (
    check_window,
    choose_beads,
    missing_beads,
    slow_roots,
    tail_length,
)
from granular_fronts.fronts.validation import check_law

TOLERANCE = 1.0e-13  # largest residual of any equation
FEWEST_STEPS, MOST_STEPS = 16, 512  # per bead-time
# An explicit method resolves what decays at the rate 4βγ only with short enough steps.
LARGEST_DECAY_PER_STEP = 3.0
# Below this γ a continuum front may be too far from the front of the lattice.
WEAK_DAMPING, CONTINUATION = 0.03, 1.25
FLOW_ERROR = 2.0e-14
UNTOUCHED = 1.0e-15  # u of the last bead
LONGER_BEHIND, LONGER_AHEAD = 1.25, 4  # of a refined window: factor, and beads

ERROR_METHOD = (
    "largest difference to a solution with twice the time steps, in a window longer by "
    f"{LONGER_BEHIND:g} behind and {LONGER_AHEAD} beads ahead, on a finer grid"
)


class Shot(NamedTuple):
    """A front in the frame δ = c = 1, as a state of beads; arrays of shape (beads,)."""

    bead: np.ndarray  # consecutive numbers; u = 1/2 at bead 0
    relative_displacement: np.ndarray  # u_n
    strain_rate: np.ndarray  # d_n
    velocity: np.ndarray  # ẋ_n
    converged: bool
    reason: str  # why or why not, in words
    residuals: np.ndarray  # the largest before every Gauss-Newton step and after the last
    step_sizes: np.ndarray  # the largest change of an unknown in every step
    counts: dict  # right_hand_sides belong to the flow, without tangents
    flow_error: float  # largest change of the flow over a bead-time when its steps are doubled
    window: Window
    unknowns: np.ndarray


def shoot_front(alpha, gamma, beta=None, *, beads=None, guess=None, tolerance=TOLERANCE):
    """Return the `Shot` of the front with u = 1 behind, u = 0 ahead and u = 1/2 at bead 0.

    `beads` are those behind and ahead of bead 0, by default as many as the tails need.  `guess`, a
    `Guess` or `Shot`, is by default a continuum front, or where that fails the front of a stronger
    damping; `tolerance` is the largest residual of any equation.  An InputError says that the law
    has no front or that the window is too short for its tail.  A NoFrontError says that the front
    would need too many beads or steps.
    """
    alpha, gamma, beta = check_law(alpha, gamma, beta)
    law = PowerLaw(alpha, beta, gamma)
    _check_steps(law)
    roots = slow_roots(law.alpha, law.gamma, law.beta)
    behind, ahead = choose_beads(law, roots) if beads is None else check_window(roots, *beads)
    shot = _shoot_in_window(law, roots, np.arange(-behind, ahead + 1), guess, tolerance)
    missing = missing_beads(roots, shot.relative_displacement)
    if beads is None and missing:
        window = behind + missing, ahead
        return shoot_front(alpha, gamma, beta, beads=window, guess=guess, tolerance=tolerance)
    return shot


def _decay(law):
    """Return the rate at which the damping of the compressed chain smooths, per bead-time."""
    return 4.0 * law.beta * law.gamma


def _check_steps(law):
    if _decay(law) > LARGEST_DECAY_PER_STEP * MOST_STEPS:
        raise NoFrontError(
            f"the damping rate 4 beta gamma is {_decay(law):.3g}, more than {MOST_STEPS} explicit "
            'steps per bead-time resolve: use method "profile"'
        )


def _shoot_in_window(law, roots, bead, guess, tolerance):
    steps = max(FEWEST_STEPS, math.ceil(_decay(law) / LARGEST_DECAY_PER_STEP))
    if guess is not None:
        return _shoot(law, roots, bead, guess, steps, tolerance)
    start = initial_guess.continuum_guess(law.alpha, law.gamma, law.beta, bead)
    shot = _shoot(law, roots, bead, start, steps, tolerance)
    if shot.converged or law.gamma >= WEAK_DAMPING:
        return shot
    stronger = shoot_front(law.alpha, CONTINUATION * law.gamma, law.beta, tolerance=tolerance)
    return _shoot(law, roots, bead, stronger, steps, tolerance)


def refine(shot):
    """Return the same front from a longer window and a finer flow, for an error estimate."""
    window = shot.window
    behind, ahead = math.ceil(-LONGER_BEHIND * shot.bead[0]), shot.bead[-1] + LONGER_AHEAD
    bead = np.arange(-behind, ahead + 1)
    return _shoot(window.law, window.roots, bead, shot, 2 * window.steps, TOLERANCE)


def _shoot(law, roots, bead, guess, steps, tolerance):
    """Solve by Gauss-Newton from a guess, with steps of the flow doubled as long as they matter."""
    state = initial_guess.fit(guess, bead)
    unknowns = join(np.zeros(equations.count_modes(roots)), state)
    residuals, step_sizes, evaluations = [], [], 0
    while True:
        compression = max(1.0, float(state[:, 0].max()))
        spread = bead_flow.spread_of(law, steps, compression)
        window = Window(law, bead.size, int(1 - bead[0]), steps, spread, roots)
        descent = descend(window, unknowns, tolerance)
        unknowns = descent.unknowns
        residuals += descent.residuals
        step_sizes += descent.step_sizes
        flow_error = _flow_error(window, unknowns)
        evaluations += (descent.flows + 3) * steps * bead_flow.STAGES
        if descent.reason or flow_error <= FLOW_ERROR or 2 * steps > MOST_STEPS:
            break
        steps *= 2
    amplitudes, state = split(window, unknowns)
    reason = descent.reason or _reason_against(bead, state, flow_error)
    # A state that has failed may be far beyond what a power of it can hold.
    with np.errstate(over="ignore", invalid="ignore"):
        velocity = _bead_velocities(window, amplitudes, state, 0.0)
    return Shot(
        bead=bead,
        relative_displacement=state[:, 0],
        strain_rate=state[:, 1],
        velocity=velocity,
        converged=not reason,
        reason=reason or f"every equation holds to {residuals[-1]:.1e}",
        residuals=np.array(residuals),
        step_sizes=np.array(step_sizes),
        counts={
            "gauss_newton_steps": len(step_sizes),
            "right_hand_sides": evaluations,
            "steps_per_bead_time": steps,
        },
        flow_error=flow_error,
        window=window,
        unknowns=unknowns,
    )


def _flow_error(window, unknowns):
    finer = window._replace(steps=2 * window.steps)
    changes = [equations.flow(each, unknowns)[0] for each in (window, finer)]
    return largest(changes[0] - changes[1])


def _reason_against(bead, state, flow_error):
    """Return why a settled state is still no front, or nothing."""
    if flow_error > FLOW_ERROR:
        return (
            f"the flow over a bead-time is only known to {flow_error:.1e} with {MOST_STEPS} steps"
        )
    if abs(state[-1, 0]) > UNTOUCHED:
        return (
            f"u is {state[-1, 0]:.1e} at the last bead, {bead[-1]}, above {UNTOUCHED}: give more "
            "beads ahead"
        )
    if np.any(state[bead > 0, 0] >= 0.5):
        return "u exceeds 1/2 ahead of bead 0, which is not the foot of the front: change the guess"
    return ""


def _bead_velocities(window, amplitudes, state, time):
    """Return ẋ_n from the strain form: w_n is a sum over the beads ahead, eq. (31) gives ẋ_n."""
    law = window.law
    modes = equations.driver_modes(window, np.asarray(time))
    u = np.concatenate([[1.0 + amplitudes @ modes], state[:, 0]])
    w = np.cumsum(state[::-1, 1])[::-1]
    return w - law.gamma * np.diff(np.maximum(u, 0.0) ** law.beta)


class Sample(NamedTuple):
    """A front on uniform ξ = n − t: u and ẋ, each of shape (points,)."""

    xi: np.ndarray
    relative_displacement: np.ndarray
    velocity: np.ndarray


def sample_front(shot, points_per_site):
    """Return the front from where its tail is lost in rounding to its last bead."""
    window = sample_window(shot, points_per_site)
    length = math.ceil(tail_length(shot.window.roots))
    count = length * points_per_site
    xi = window.xi[0] - np.arange(count, 0, -1) / points_per_site
    tail = _sample_tail(shot, xi)
    return Sample(*(np.concatenate(pair) for pair in zip(tail, window, strict=True)))


def sample_window(shot, points_per_site):
    """Return the front from less than one site behind the first bead of a shot to its last."""
    duration = 1.0 / points_per_site
    window = shot.window
    part = window._replace(steps=math.ceil(window.steps * duration))
    amplitudes, state = split(window, shot.unknowns)
    values = np.empty((2, shot.bead.size, points_per_site))
    for j in range(points_per_site):
        time = j * duration
        values[:, :, -1 - j] = state[:, 0], _bead_velocities(window, amplitudes, state, time)
        change, _ = equations.flow(part, join(amplitudes, state), duration, time)
        state = state + change
    fractions = (np.arange(points_per_site) + 1.0) * duration - 1.0
    xi = (shot.bead[:, np.newaxis] + fractions).ravel()
    return Sample(xi, *values.reshape(2, -1))


def _sample_tail(shot, xi):
    amplitudes, _ = split(shot.window, shot.unknowns)
    distance = xi - (shot.bead[0] - 1)
    u, velocity, used = np.ones(xi.size), np.ones(xi.size), 0
    for root in shot.window.roots:
        real = amplitudes[used]
        imaginary = amplitudes[used + 1] if root.imag else 0.0
        used += 2 if root.imag else 1
        mode = (real - 1j * imaginary) * np.exp(root * distance)
        u += mode.real
        velocity += (root / (np.exp(root) - 1.0) * mode).real
    return Sample(xi, u, velocity)
