r"""What the variables (x, w) buy against (x, ẋ); James (2021), section 3.2.

Smoothness.  A contact is brought from just open to a compression h while its beads approach.  The
largest change of the right-hand side, divided by h, is :math:`\propto h^{\beta-2}` in (x, ẋ): not
Lipschitz for β < 2, and a jump for β = 1.  It is :math:`\propto h^{\min(\alpha,\beta)-1}` in
(x, w): bounded, and for β > 1 going to zero, the derivative of an open contact.

Order.  Two beads meet and part under Euler's method and the classical Runge-Kutta method of order 4
with fixed steps.  The place in a step where a contact opens or closes decides the error of one run.
So the median over several gaps between the beads is taken; the order is the slope of its logarithm.
The velocity with which the beads part is known from the reduced collision (`collision`).

Conservation.  Behind a front in an infinite chain the limit of :math:`w_n` is conserved and equal
to that of :math:`\dot x_n` (34).  Consider a chain whose left part has the compression 1 and the
velocity of (22), with pressure 1 on its end.  It is the left half of an infinite chain until waves
come back to its first beads.
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import Estimate, estimated_variable, variable_and_errors
from granular_fronts.chain.equations import Boundary, velocity_correction
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.model.collision import restitution
from granular_fronts.model.laws import make_law
from granular_fronts.reference_methods.position_forms import (
    XV,
    XW,
    integrate_by_stages,
    make_system,
    right_hand_side,
)
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from granular_fronts.studies.orders import power_of

FORMS = {"positions_and_velocities": XV, "positions_and_w": XW}
SCHEMES = {
    "euler": (np.array([0.0]), np.array([1.0])),
    "runge_kutta_4": (np.array([0.0, 0.5, 0.5, 1.0]), np.array([1.0, 2.0, 2.0, 1.0]) / 6.0),
}
"""Nodes and weights of methods in which each stage uses only the one before it."""

FREE = Boundary(ring=False)
"""Ends of a chain on which nothing presses."""

COMPRESSIONS = 2.0 ** -np.arange(10.0, 31.0, 2.0)
# Multiples of the golden ratio share no period with the steps.
GAPS = 1.0 + np.arange(101) * 0.6180339887498949 % 1.0
COLLISION_END = 12.0
STEP_COUNTS = (400, 800, 1600, 3200, 6400, 12800)
POWER = "power of h in a difference quotient"
ORDER = "observed order of convergence"
DRIFT = "largest distance of w_n to v_p far behind a front"
FITTED = "change from the first half of the points to the second"
CHAIN_METHOD = "of the relative displacements and velocities of the chain"
BEADS, COMPRESSED, FAR, END_TIME = 200, 150, 10, 16.0


def compare_variables(alpha, betas, gamma):
    """Compare both sets of variables: smoothness, order and conservation, α > 1, 1 ≤ β ≤ 2.

    `quotient_power` on (form, beta); `observed_order` on (form, scheme) and
    `conserved_velocity_drift`, largest distance of w_n to v_p in the left part of the chain,
    both for β = α.
    """
    laws = [make_law(alpha=alpha, beta=beta, gamma=gamma) for beta in betas]
    powers = [[quotient_power(form, law) for law in laws] for form in FORMS.values()]
    law = make_law(alpha=alpha, gamma=gamma)
    orders = [[observed_order(form, law, scheme) for scheme in SCHEMES] for form in FORMS.values()]
    drift = estimated_variable(
        (), conserved_velocity_drift(alpha, gamma), CHAIN_METHOD, long_name=DRIFT
    )
    return xr.Dataset(
        {
            **variable_and_errors("quotient_power", ("form", "beta"), powers, FITTED, POWER),
            **variable_and_errors("observed_order", ("form", "scheme"), orders, FITTED, ORDER),
            "conserved_velocity_drift": drift,
        },
        {
            "form": ("form", list(FORMS), {"long_name": "variables of the chain"}),
            "beta": list(betas),
            "scheme": list(SCHEMES),
        },
    )


def slope(x, y):
    """Return slope of a line through the logarithms, and how much it differs between two halves."""
    middle = x.size // 2
    whole, first, second = (
        power_of(x[part], y[part]) for part in (slice(None), slice(middle + 1), slice(middle, None))
    )
    return Estimate(whole, abs(first - second))


def quotient_power(form, law):
    """Return the power of h in the difference quotient of the rates where a contact closes."""
    system, quotients = make_system(form, law, FREE, 2), []
    for compression in COMPRESSIONS:
        opened, closed = (
            right_hand_side(system, np.array([h, 0.0, 1.0, 0.0])) for h in (0.0, compression)
        )
        quotients.append(np.abs(closed - opened).max() / compression)
    return slope(COMPRESSIONS, np.array(quotients))


def observed_order(form, law, scheme):
    """Return the order of the velocity after a collision, and the spread of two halves."""
    parting = -restitution(law.gamma, law.alpha, law.beta)
    system = make_system(form, law, FREE, 2 * GAPS.size)
    errors = [np.median(np.abs(_part_pairs(system, scheme, n) - parting)) for n in STEP_COUNTS]
    return -slope(np.array(STEP_COUNTS, dtype=float), np.array(errors))


def _part_pairs(system, scheme, steps):
    """Return ẋ_1 − ẋ_2 after bead 1 has come with velocity 1, for each of `GAPS`."""
    # The pairs are in one chain, too far apart to meet.
    place = (COLLISION_END + GAPS.max()) * (np.arange(GAPS.size) - GAPS.size // 2)
    start = np.stack([place - GAPS, place], axis=1).ravel()
    velocity = np.tile([1.0, 0.0], GAPS.size)
    h = COLLISION_END / steps
    state = integrate_by_stages(
        system, np.concatenate([start, velocity]), h, steps, *SCHEMES[scheme]
    )
    return -np.diff(state[start.size :].reshape(-1, 2), axis=1)[:, 0]


def conserved_velocity_drift(alpha, gamma):
    """Return largest |w_n − v_p| far behind a front, at all times, and the error of the chain."""
    compressed = np.arange(BEADS) < COMPRESSED
    scene = pressed_chain(
        kuwabara_kono(alpha, gamma),
        BEADS,
        END_TIME,
        (1.0e-13, 1.0e-15),
        {"snapshots": list(np.linspace(0.0, END_TIME, 9))},
        start=(compressed[:-1], compressed),
    )
    motion = simulate_chain(scene, "choice of variables")
    boundary = Boundary(ring=False, left=1.0, right=0.0)
    law = make_law(alpha=alpha, gamma=gamma)
    w = [
        velocity - velocity_correction(u, boundary, law)
        for u, velocity in zip(
            motion["relative_displacement"].values, motion["velocity"].values, strict=True
        )
    ]
    error = max(motion[name].attrs["error_estimate"] for name in motion.data_vars)
    return float(np.abs(np.array(w)[:, :FAR] - 1.0).max()), (1.0 + 4.0 * gamma * alpha) * error
