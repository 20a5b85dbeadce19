r"""The θ-method on a conservative chain, compared with the damped chain that it resembles.

The method with step h damps like the Kuwabara-Kono law with :math:`\gamma = (2\theta - 1)h` (see
`reference_methods.theta_method`).  Both chains are pressed at one end.  The damped one is solved
accurately and starts as the method's own modified equation does: rest of the method, v = 0, means
:math:`\dot x_1 = \tfrac\gamma2\delta^\alpha`.  Their distance at the end,

.. math:: \max_n |u_n^{\theta} - u_n^{\gamma}|/\delta,

falls as h² where h is made smaller and γ falls with it.  The distance of the method to the
conservative chain falls as h only.  The order sets in late: behind a front of damping γ about 1/γ
oscillations follow, and their shifts add up.

Other schemes.  To first order in h any Runge-Kutta method of order 1 solves :math:`\dot y = f +
(\sum_i b_i c_i - \tfrac12)h\,f'f`, so that all schemes with :math:`\sum_i b_i c_i = \theta`
damp like this.  The explicit one of two stages,

.. math:: y' = y + h f\bigl(y + \theta h f(y)\bigr),

is compared with the θ-method.  Large steps make it unstable, so that it takes the smallest three.
"""

from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.accuracy import EPSILON
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError, SolveError
from granular_fronts.model.laws import make_law
from granular_fronts.reference_methods.position_forms import (
    XW,
    integrate_by_stages,
    pack,
    unpack,
)
from granular_fronts.reference_methods.theta_method import NEWTON_TOLERANCE, integrate_from_rest
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from granular_fronts.studies.orders import ORDER_METHOD, observed_orders

ROUNDING = {"error_estimate": EPSILON, "error_method": "rounding"}
ERROR_METHOD = "error of the damped chain, and Newton's tolerance times the number of steps"


class Case(NamedTuple):
    """A chain that is pressed at one end: α, δ, the number N of beads, the end of its motion."""

    alpha: float
    displacement: float
    beads: int
    end_time: float


def measure_numerical_damping(alpha, displacement, order, profile):
    """Run `measure_order` on one chain and `compare_profiles` on another, as configured."""
    many, one = (
        Case(alpha, displacement, part["beads"], part["end_time"]) for part in (order, profile)
    )
    distances = measure_order(many, order["thetas"], order["steps"])
    return distances.merge(compare_profiles(one, profile["theta"], profile["step"]))


def measure_order(case, thetas, steps):
    """Return the distances of the θ-method, θ > 1/2, to damped chains and to the conservative one.

    `gamma`, `damping_distance` and `conservative_distance`, relative to δ, are on (theta, step).
    On (theta,) is the observed `order` of the first distance at the last two of three or more
    falling steps.  `order_two_stages` belongs to the explicit scheme of two stages.
    """
    conservative, rounding = damped_chain(case, 0.0)
    shape = (len(thetas), len(steps))
    to_damped, to_conservative = np.empty(shape), np.empty(shape)
    errors, explicit = [rounding], np.full(shape, np.nan)
    for row, theta in enumerate(thetas):
        for column, step in enumerate(steps):
            method, newton_error = theta_chain(case, theta, step)
            damped, error = damped_chain(case, (2.0 * theta - 1.0) * step)
            to_damped[row, column] = np.abs(method - damped).max() / case.displacement
            to_conservative[row, column] = np.abs(method - conservative).max() / case.displacement
            errors.append(error + newton_error)
            if column >= len(steps) - 3:
                stages = _two_stage_chain(case, theta, step)
                explicit[row, column] = np.abs(stages - damped).max() / case.displacement
    distance = {"error_estimate": max(errors) / case.displacement, "error_method": ERROR_METHOD}
    gamma = np.outer(2.0 * np.asarray(thetas) - 1.0, steps)
    return xr.Dataset(
        {
            "gamma": (("theta", "step"), gamma, ROUNDING),
            "damping_distance": (("theta", "step"), to_damped, distance),
            "conservative_distance": (("theta", "step"), to_conservative, distance),
            "order": _last_orders(to_damped, steps),
            "order_two_stages": _last_orders(explicit, steps),
        },
        {"theta": list(thetas), "step": list(steps)},
    )


def _last_orders(distances, steps):
    """Return the observed orders at the last two steps, on (theta,)."""
    orders = observed_orders(distances[:, -3:], steps[-3:])
    change = float(np.abs(orders[:, 1] - orders[:, 0]).max())
    return "theta", orders[:, 1], {"error_estimate": change, "error_method": ORDER_METHOD}


def compare_profiles(case, theta, step):
    """Return relative displacements on (bead,) of the θ-method and both chains."""
    solved = {
        "method": theta_chain(case, theta, step),
        "damped": damped_chain(case, (2.0 * theta - 1.0) * step),
        "conservative": damped_chain(case, 0.0),
    }
    dataset = xr.Dataset(coords={"bead": np.arange(1, case.beads)})
    for name, (values, error) in solved.items():
        attributes = {"error_estimate": error, "error_method": ERROR_METHOD}
        dataset[f"relative_displacement_{name}"] = ("bead", values, attributes)
    return dataset


def theta_chain(case, theta, step):
    """Return the final relative displacements of the θ-method, and the error of its solves."""
    count = round(case.end_time / step)
    if abs(count * step - case.end_time) > 1.0e-9 * case.end_time:
        raise InputError(
            f"end_time is {case.end_time}, but no whole number of steps {step} ends there: give a "
            "multiple."
        )
    motion = integrate_from_rest(case.alpha, case.beads, case.displacement, 0.0, theta, step, count)
    if not motion.converged:
        raise SolveError(
            f"Newton's method fails for theta {theta} and step {step}: give a smaller step."
        )
    return motion.u, NEWTON_TOLERANCE * count * case.displacement


def _two_stage_chain(case, theta, step):
    """Return the relative displacements at the end by the explicit scheme of two stages."""
    law = make_law(alpha=case.alpha, gamma=0.0)
    boundary = Boundary(ring=False, left=case.displacement, right=0.0)
    at_rest = np.zeros(case.beads)
    system, state = pack(XW, law, boundary, at_rest, at_rest)
    steps = round(case.end_time / step)
    nodes, weights = np.array([0.0, theta]), np.array([0.0, 1.0])
    state = integrate_by_stages(system, state, step, steps, nodes, weights)
    return unpack(system, state)[0][:-1]


def damped_chain(case, gamma):
    """Return the relative displacements of the Kuwabara-Kono chain at the end, and their error."""
    velocity = np.zeros(case.beads)
    velocity[0] = 0.5 * gamma * case.displacement**case.alpha
    scene = pressed_chain(
        kuwabara_kono(case.alpha, gamma),
        case.beads,
        case.end_time,
        (1.0e-12, 1.0e-14),
        {"snapshots": [case.end_time]},
        left=case.displacement,
        start=(np.zeros(case.beads - 1), velocity),
    )
    motion = simulate_chain(scene, f"damped chain with gamma {gamma:g}")
    u = motion["relative_displacement"].isel(t=0)
    return u.values[:-1], float(u.attrs["error_estimate"])
