r"""Order of convergence through a contact that closes and opens, with and without location.

Two beads meet and part; the result is the velocity with which they part.  Three methods use the
same eighth-order pair:

- `strain_form`: adaptive steps that end at the events (`chain.contact_events`);
- `positions_and_w`: fixed steps in (x, w), blind to the events; the right-hand side is
  :math:`C^\alpha` in time, so that order :math:`\alpha + 1` is left;
- `positions_and_velocities`: fixed steps in (x, ẋ), where the damping is :math:`C^{\beta-1}` and
  order β is left.

Where in a step an event falls decides the error of that one run.  Each problem is therefore solved
for several gaps between the beads, which shift the events against the steps, and the median counts.

The slope of error against steps is the order for fixed steps.  For adaptive methods it flatters the
pair.  The first steps and the steps graded towards events are about as many at any tolerance.  A
slope of 8 or more says that the events do not cost the order.
"""

import numpy as np

from granular_fronts.chain.run import prepare
from granular_fronts.chain.simulate import solve
from granular_fronts.reference_methods import position_forms
from granular_fronts.reference_methods.extended import reference_state
from granular_fronts.studies.chain_scenes import kuwabara_kono
from granular_fronts.studies.hard_cases.contact_cases import collision
from granular_fronts.studies.orders import power_of

LAW = kuwabara_kono(1.5, 0.3)
END_TIME = 20.0
# Multiples of the golden ratio share no period with the steps.
PHASES = 1.0 + np.arange(15) * 0.6180339887498949 % 1.0
TOLERANCES = 10.0 ** -np.arange(3.0, 13.0)
STEP_COUNTS = np.unique(np.round(np.geomspace(300, 6000, 8)).astype(int))
FORMS = {"positions_and_w": position_forms.XW, "positions_and_velocities": position_forms.XV}


def measure_orders():
    """Return median steps and median error, rung by rung, under the names of the methods."""
    parting = _parting_velocity()
    curves = {"strain_form": _median_of(located, TOLERANCES, parting)}
    for name, form in FORMS.items():
        curves[name] = _median_of(lambda *run, form=form: blind(form, *run), STEP_COUNTS, parting)
    return curves


def _parting_velocity():
    """Return the relative velocity after the collision, in extended precision, for any gap."""
    half = {"end_time": END_TIME / 2.0, "record": {"snapshots": []}}
    velocity = reference_state(collision(LAW, gap=0.0) | half).velocity
    return float(velocity[1] - velocity[0])


def _median_of(method, rungs, parting):
    """Return the medians over the gaps of the steps taken and of the errors made."""
    runs = np.array([[method(gap, rung) for gap in PHASES] for rung in rungs])
    steps, velocity = runs[..., 0], runs[..., 1]
    return np.median(steps, axis=1), np.median(np.abs(velocity - parting), axis=1)


def located(gap, tolerance):
    """Return the steps and parting velocity of the strain form."""
    accuracy = {"relative": tolerance, "absolute": 1.0e-2 * tolerance}
    solution = solve(collision(LAW, gap), accuracy)
    velocity = solution.dataset["velocity"].values[-1]
    return solution.counts["steps_accepted"], velocity[1] - velocity[0]


def blind(form, gap, steps):
    """Return the steps and parting velocity of a plain form with fixed steps."""
    run = prepare(collision(LAW, gap))
    u, velocity = np.array([-gap, 0.0]), np.array([1.0, 0.0])
    system, y = position_forms.pack(form, run.law, run.boundary, u, velocity)
    y = position_forms.integrate_fixed(system, y, END_TIME / steps, steps)
    _, velocity = position_forms.unpack(system, y)
    return steps, velocity[1] - velocity[0]


def fitted_order(steps, errors, floor=1.0e-12):
    """Return the slope of log error against log steps, over the errors above `floor`."""
    above = errors > floor
    return -power_of(steps[above], errors[above])
