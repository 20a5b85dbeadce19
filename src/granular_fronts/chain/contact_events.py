r"""Opening and closing contacts: where a step must end so that the order of the method survives.

A force :math:`u_+^\alpha` is smooth in time except where its contact opens or closes.  There it
behaves like :math:`(t - t^*)_+^\alpha`, and a step of any high-order method that straddles
:math:`t^*` is wrong by about

.. math:: \kappa = h\,\gamma\, u_{max}^\beta + h^2\, u_{max}^\alpha ,

with :math:`u_{max}` the larger compression at the two ends of the step: the most that the force of
the step can contribute.  The embedded error estimate does not see this,
since its stages sit mostly near the ends of the step.  Hence:

- a step that changes the sign of a contact is accepted only if κ is below the tolerance;
- **closing** (the force is zero before :math:`t^*`, so that everything before is smooth): the step
  is cut to end just after :math:`t^*`, by so little that κ is below the tolerance; the next step
  starts on the singular side, where the stages do see the singularity and the ordinary controller
  works;
- **opening** (the singular side lies before :math:`t^*`): the steps are graded towards
  :math:`t^*`, each going the fraction `APPROACH` of the way, until the step that crosses it is
  short enough.  The geometric sequence costs about a dozen steps per opening.

The time to the crossing comes from the parabola through u, its rate, and the rejected end value.
"""

import math

from numba import uint64

from granular_fronts.chain.state import PAIR
from granular_fronts.numerics.compiled import kernel

APPROACH = 0.75
CROSSING = 1.5


@kernel
def changes_sign(state, last):
    """Whether any of the contacts 1 … last opens or closes between the ends of the step."""
    changes = 0
    for n in range(uint64(1), uint64(last + 1)):
        changes += state.u[n] * state.new_u[n] < 0.0
    return changes > 0


@kernel
def contribution(law, compression, h):
    """κ: the most that a force of this compression adds to u within a step h."""
    largest = max(compression, 0.0)
    return h * law.gamma * largest**law.beta + h * h * largest**law.alpha


@kernel
def compression_allowed(law, h, allowed):
    """A compression whose contribution to a step h is at most `allowed`."""
    by_force = (0.5 * allowed / (h * h)) ** (1.0 / law.alpha)
    if law.gamma == 0.0:
        return by_force
    return min(by_force, (0.5 * allowed / (h * law.gamma)) ** (1.0 / law.beta))


@kernel
def time_to_zero(u, rate, new_u, h):
    """First zero in (0, h) of the parabola with value u and slope `rate` at 0, value new_u at h."""
    curvature = (new_u - u - rate * h) / (h * h)
    root = math.sqrt(max(rate * rate - 4.0 * curvature * u, 0.0))
    # Of the two equal forms of the root, the one without cancellation: u and new_u differ in sign,
    # so exactly one zero lies in the interval.
    denominator = -(rate + math.copysign(root, -u))
    if denominator != 0.0:
        zero = 2.0 * u / denominator
        if 0.0 < zero < h:
            return zero
    return h * u / (u - new_u)


@kernel
def step_at_contact(law, state, h, last, allowed):
    """Step to try instead of h because of the contacts 1 … last, or h if no crossing does harm.

    Parameters
    ----------
    allowed : float
        Largest κ that may pass, the absolute tolerance on u.
    """
    proposal = h
    g = state.g if law.kind == PAIR else state.k
    for n in range(1, last + 1):
        u, new_u = state.u[n], state.new_u[n]
        if u * new_u >= 0.0 or contribution(law, max(u, new_u), h) <= allowed:
            continue
        zero = time_to_zero(u, state.d[n] + law.gamma * g[0, n], new_u, h)
        if u < 0.0:
            beyond = compression_allowed(law, h, 0.5 * allowed)
            candidate = zero + beyond * (h - zero) / new_u
        elif contribution(law, u, CROSSING * zero) <= allowed:
            candidate = CROSSING * zero
        else:
            candidate = APPROACH * zero
        proposal = min(proposal, candidate)
    return proposal
