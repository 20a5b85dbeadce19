r"""Opening and closing contacts: where a step must end so that the order of the method survives.

A force :math:`u_+^\alpha` is smooth in time except where its contact opens or closes.  Any force is
smooth except where its compression passes a *kink* u*, which the law declares.  There, at the time
t*, a step of any high-order method that straddles t* is wrong by about

.. math:: \kappa = h\,\lvert G(u) - G(u^*)\rvert + h^2\,\lvert F(u) - F(u^*)\rvert,

at whichever end of the step this is larger: the most that the force of the step beyond the kink can
contribute.  The embedded error estimate does not see this, since its stages sit mostly near the
ends of the step.  Hence:

- a step that takes a contact through a kink is accepted only if κ is below the tolerance;
- **closing**, where κ is larger at the end of the step.  The force of an open contact is zero, so
  that everything before t* is smooth.  The step is cut to end just after t*, by so little that κ
  is below the tolerance.  The next step starts on the singular side, where the stages do see the
  singularity and the ordinary controller works;
- **opening**, where κ is larger at its start (the singular side lies before t*).  The steps are
  graded towards t*, each going the fraction `APPROACH` of the way, until the step that crosses it
  is short enough.  The geometric sequence costs about a dozen steps per opening.

The time to the crossing comes from the parabola through u, its rate, and the rejected end value.
"""

import math

from numba import int64, uint64

from granular_fronts.chain.state import (
    ELASTIC_SLOPES,
    MOBILITY,
    NEW_U,
    STIFFNESS,
    VISCOSITY,
    VISCOUS_SLOPES,
    D,
    U,
)
from granular_fronts.model.passes import call_row_map
from granular_fronts.numerics.compiled import subroutine
from granular_fronts.numerics.runge_kutta import SLOT

# Share of the way to an opening that a step goes, and how far one goes that may cross it.
APPROACH = 0.75
CROSSING = 1.5
# A step cut at a closing leaves κ between this share of what is allowed and all of it.
MOST_TRIALS, SMALLEST_SHARE = 8, 0.1


@subroutine
def _passes_kink(table, kink, last):
    """Return whether any of the contacts 1 … last passes the kink between the ends of the step."""
    passages = 0
    for n in range(uint64(1), uint64(last + 1)):
        passages += (table[U, n] - kink) * (table[NEW_U, n] - kink) < 0.0
    return passages > 0


@subroutine
def passes_any_kink(chain, table, last):
    """Return whether any of the contacts 1 … last passes any kink of the law."""
    passages = 0
    for i in range(chain.law.kink_count):
        passages += _passes_kink(table, chain.law.kinks[i], last)
    return passages > 0


@subroutine
def _forces_at(chain, u):
    """Return F and G of one compression."""
    law, probe = chain.law, chain.probe
    probe[0] = u
    call_row_map(law.elastic, probe, probe[1:], 0, 0, law.elastic_parameters)
    if law.single:
        return probe[1], law.gamma * probe[1]
    call_row_map(law.viscous, probe, probe[2:], 0, 0, law.viscous_parameters)
    return probe[1], probe[2]


@subroutine
def _contribution(chain, table, n, u, kink, h):
    """Return κ: the most that the force of this compression adds to u_n within a step h."""
    force, damping = _forces_at(chain, u)
    force_at_kink, damping_at_kink = _forces_at(chain, kink)
    elastic, viscous = h * h * abs(force - force_at_kink), h * abs(damping - damping_at_kink)
    if not chain.varied:
        return viscous + elastic
    mobility = 0.5 * (table[MOBILITY, n] + table[MOBILITY, n + 1])
    return mobility * (table[VISCOSITY, n] * viscous + table[STIFFNESS, n] * elastic)


@subroutine
def _compression_allowed(chain, table, n, u, kink, h, allowed):
    """Return a compression near the kink with κ at most `allowed`, but not much smaller.

    κ is taken for a power of the distance from the kink, with the exponent of the last two trials.
    """
    distance, kappa, exponent = u - kink, _contribution(chain, table, n, u, kink, h), 1.0
    for _ in range(MOST_TRIALS):
        if SMALLEST_SHARE * allowed <= kappa <= allowed or kappa == 0.0:
            break
        nearer = distance * (0.5 * allowed / kappa) ** (1.0 / exponent)
        kappa_there = _contribution(chain, table, n, kink + nearer, kink, h)
        if kappa_there > 0.0 and kappa_there != kappa:
            exponent = math.log(kappa_there / kappa) / math.log(nearer / distance)
        distance, kappa = nearer, kappa_there
    return kink + distance


@subroutine
def _time_to_kink(u, rate, new_u, h):
    """Return the first zero in (0, h) of the parabola with u and `rate` at 0 and new_u at h."""
    curvature = (new_u - u - rate * h) / (h * h)
    root = math.sqrt(max(rate * rate - 4.0 * curvature * u, 0.0))
    # Of the two equal forms of the root, this one has no cancellation. Exactly one zero lies in the
    # interval, since u and new_u differ in sign.
    denominator = -(rate + math.copysign(root, -u))
    if denominator != 0.0:
        zero = 2.0 * u / denominator
        if 0.0 < zero < h:
            return zero
    return h * u / (u - new_u)


@subroutine
def _rate_of(chain, table, d_row, stage, n):
    """Return the rate of change of u_n from d in a row and the slopes of a stage."""
    slopes = ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    return table[d_row, n] + chain.law.gamma * table[slopes + SLOT[stage], n]


@subroutine
def _step_at_kink(chain, table, kink, h, last, allowed):
    """Step to try instead of h because of the contacts 1 … last, or h if no passage does harm."""
    proposal = h
    for n in range(1, last + 1):
        u, new_u = table[U, n], table[NEW_U, n]
        if (u - kink) * (new_u - kink) >= 0.0:
            continue
        before = _contribution(chain, table, n, u, kink, h)
        after = _contribution(chain, table, n, new_u, kink, h)
        if max(before, after) <= allowed:
            continue
        zero = _time_to_kink(u - kink, _rate_of(chain, table, D, int64(0), n), new_u - kink, h)
        if after >= before:
            reached = _compression_allowed(chain, table, n, new_u, kink, h, 0.5 * allowed)
            beyond = reached - kink
            candidate = zero + beyond * (h - zero) / (new_u - kink)
        elif _contribution(chain, table, n, u, kink, CROSSING * zero) <= allowed:
            candidate = CROSSING * zero
        else:
            candidate = APPROACH * zero
        proposal = min(proposal, candidate)
    return proposal


@subroutine
def step_at_contact(chain, table, h, last, allowed):
    """Step to try instead of h because of all kinks of the law."""
    proposal = h
    for i in range(chain.law.kink_count):
        kink = chain.law.kinks[i]
        proposal = min(proposal, _step_at_kink(chain, table, kink, h, last, allowed))
    return proposal
