r"""The jump conditions of section 2 of James (2021) against fronts that are solved and driven.

For any V and W the speed (13), the direction (17), the jump of the velocity (12) and the power lost
(16) follow from the two states alone.  They are measured here in three ways.

Exact front (`fronts.solve`): its speed is an unknown of the equations, and its
power an integral over the profile.  The discrete equations imply (13) as the exact ones do, so that
this speed tells whether the front reaches both states, and the power whether it is resolved.
Error: change on a finer grid, by another order, on a longer window, and rounding.

Travelling front: the exact front, put into a chain of beads (`granular_fronts.chain.any_law`),
travels; its speed is the slope of the times at which the contacts pass the middle between the
states.  No code is shared with the profile.  Error: change with a tolerance a hundred times larger,
and rounding of the times.

Driven front: the chain starts from a jump between the two states, sharp and symmetric: beads
behind and ahead have their velocities, one contact between them has the mean strain.  With
the velocities :math:`-cR_\pm` such a start leaves nothing behind: strain and velocity are conserved
and would all be in the front, were it not for the inner structure that the front has to find.  This
transient dies out algebraically, about as the inverse square of the distance, which is why driven
speeds are no better than they are.  The speed is the slope of the times of passage over the
second half of the way; the jump of the velocity and the power are measured at its end, over the
passage of one bead and the contacts of the front.  Error: the change on the last doubling of the
way, which for the inverse square is three times the error that is left, or a quarter of the change
on the doubling before, and rounding.
Weakly nonlinear or strongly damped fronts form slowly, at an exponential rate; they need a longer
way, or have larger errors.  The chain behind the jump is so long that nothing that its held end
reflects reaches the front.
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.accuracy import Measured
from granular_fronts.chain.any_law import compile_law, make_chain, run_chain
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.laws import make_law
from granular_fronts.model.named_potentials import make_slope
from granular_fronts.model.potentials import make_potential

EPSILON = float(np.finfo(float).eps)
ROOM_BEHIND = 60
TRAVEL, TRAVEL_TOLERANCE = 40, 1.0e-14
SAMPLES = 16
"""Instants within the passage of one bead, whose powers are averaged."""

PROFILE_XI = np.arange(-15.0, 15.01, 0.1)

ERROR_METHODS = {
    "expected": "rounding and quadrature, by granular_fronts.model.jump_conditions",
    "exact": "change on a finer grid, by another order, on a longer window; and rounding",
    "travelling": "change with a tolerance 100 times larger, and rounding of the times",
    "driven": "change on the last doubling of the way, or a quarter of that before",
}


def measure_jumps(cases, beads, tolerance):
    """Measure the fronts of several lattices.

    Parameters
    ----------
    cases : mapping
        For each name `elastic` and `dissipation`, potentials for `named_potentials`, and `states`,
        R₋ and R₊.
    beads : int
        How far driven fronts run.
    tolerance : float
        Largest error per step of the driven chains.

    Returns
    -------
    xarray.Dataset
        On (law,): `state_minus`, `state_plus`, `direction`, and `speed_…`, `velocity_jump_…` and
        `power_…` with the endings `expected`, `exact`, `travelling` and `driven` as far as they
        are measured, each with its `…_error`; on (law, xi) the `profile` of the exact front.

    Raises
    ------
    InputError
        If a front does not exist.
    NoFrontError
        If it is not found.
    """
    rows = [_measure(name, case, beads, tolerance) for name, case in cases.items()]
    variables = {}
    for name in rows[0][0]:
        values, errors = map(np.array, zip(*(row[name] for row, _ in rows), strict=True))
        method = ERROR_METHODS.get(name.rpartition("_")[2], "none: given or a sign")
        attributes = {"error_estimate": float(errors.max()), "error_method": method}
        variables[name] = ("law", values, attributes)
        if method in ERROR_METHODS.values():
            attributes = {"error_estimate": 0.0, "error_method": "an estimate itself"}
            variables[f"{name}_error"] = ("law", errors, attributes)
    profiles = {"error_estimate": 1e-13, "error_method": "interpolation, checked by its tests"}
    variables["profile"] = (("law", "xi"), np.array([profile for _, profile in rows]), profiles)
    coordinate = {"long_name": "bead number n - |c| t from the middle of the front"}
    return xr.Dataset(variables, {"law": list(cases), "xi": ("xi", PROFILE_XI, coordinate)})


def _measure(name, case, beads, tolerance):
    """Everything of one lattice, by the name of the variable, and its profile."""
    potential, dissipation = (make_potential(**case[part]) for part in ("elastic", "dissipation"))
    law = make_law(elastic=potential, viscous=dissipation)
    states = tuple(map(float, case["states"]))
    theory = jump_conditions(potential, *states, dissipation=dissipation)
    sign = theory.direction
    # Reflected where the front runs to smaller n, so that it runs to larger n.
    front = solve_front(law=law, states=states[::sign])
    if not front.attrs["converged"]:
        raise NoFrontError(f"The front of {name} is not found: {front.attrs['reason']}.")
    compiled = compile_law(make_slope(case["elastic"]), make_slope(case["dissipation"]))
    power_error = theory.dissipated_power * (
        theory.speed_error / abs(theory.speed) + theory.energy_error / theory.energy_per_bead
    )
    driven = drive_front(compiled, law, front, beads, tolerance)
    row = {
        "state_minus": (states[0], 0.0),
        "state_plus": (states[1], 0.0),
        "direction": (sign, 0.0),
        "speed_expected": (theory.speed, theory.speed_error),
        "speed_exact": _signed(sign, exact_speed(front)),
        "speed_travelling": _signed(sign, travelling_speed(compiled, front)),
        "speed_driven": _signed(sign, driven["speed"]),
        "velocity_jump_expected": (
            theory.velocity_jump,
            theory.speed_error * abs(states[1] - states[0]),
        ),
        "velocity_jump_driven": driven["velocity_jump"],
        "power_expected": (theory.dissipated_power, power_error),
        "power_exact": _rounded(
            front.attrs["dissipated_power"], front.attrs["dissipated_power_error"]
        ),
        "power_driven": driven["power"],
    }
    behind, ahead = states[::sign]
    return row, (evaluate_front(front, PROFILE_XI, "strain") - ahead) / (behind - ahead)


def exact_speed(front):
    """Speed at which the profile equation has the front.

    Parameters
    ----------
    front : xarray.Dataset
        From `fronts.solve.solve_front`.

    Returns
    -------
    Measured
    """
    speed = front.attrs["speed"]
    return _rounded(
        speed * (1.0 + front.attrs["speed_defect"]), speed * front.attrs["speed_defect_error"]
    )


def _rounded(value, error):
    return Measured(value, error + 8.0 * EPSILON * abs(value))


def _signed(sign, measurement):
    return Measured(sign * measurement.value, measurement.error)


def travelling_speed(compiled, front):
    """Speed of an exact front in a chain.

    Parameters
    ----------
    compiled : object
        Compiled law of the chain.
    front : xarray.Dataset
        From `fronts.solve.solve_front`.

    Returns
    -------
    Measured
    """
    behind, ahead, speed = (front.attrs[name] for name in ("state_behind", "state_ahead", "speed"))
    xi = front["xi"].values
    sites = np.arange(math.floor(xi[0]), TRAVEL + math.ceil(xi[-1]) + 1.0)
    strain = evaluate_front(front, sites, "strain")
    strain[0], strain[-1] = behind, ahead
    velocity = evaluate_front(front, np.append(sites, sites[-1] + 1.0), "velocity")
    level, scale = 0.5 * (behind + ahead), abs(behind - ahead)
    speeds = []
    for tolerance in (TRAVEL_TOLERANCE, 100.0 * TRAVEL_TOLERANCE):
        chain = make_chain(compiled, strain, np.diff(velocity), 0.01)
        arrivals = np.full(sites.size, math.nan)
        run_chain(chain, TRAVEL / speed, tolerance * scale, level, arrivals)
        passed = np.flatnonzero(~np.isnan(arrivals) & (sites > 0.0))
        speeds.append(_slope(arrivals[passed]))
    strict, loose = speeds
    # The passages are 1/c apart and good to some units of rounding of the strain.
    return Measured(strict, abs(strict - loose) + 32.0 * EPSILON * strict)


def drive_front(compiled, law, front, beads, tolerance):
    """Start a chain from a jump between the states and measure the front that forms.

    Parameters
    ----------
    compiled : object
        Compiled law of the chain.
    law : granular_fronts.model.laws.Law
    front : xarray.Dataset
        The exact front, for states, speed and lengths.
    beads : int
        How far the front runs.
    tolerance : float
        Largest error per step.

    Returns
    -------
    dict
        `speed`, `velocity_jump` (ahead less behind) and `power`, each a `Measured`.
    """
    behind, ahead, c = (front.attrs[name] for name in ("state_behind", "state_ahead", "speed"))
    window_behind, window_ahead = np.abs(front["xi"].values[[0, -1]])
    origin = _room_behind(law, behind, c, beads)
    contacts = origin + beads + math.ceil(window_ahead)
    level, error = 0.5 * (behind + ahead), tolerance * abs(behind - ahead)
    strain = np.where(np.arange(contacts + 2) < origin, behind, ahead)
    strain[origin] = level
    rate = np.zeros(contacts + 2)
    rate[origin] = c * (behind - ahead)
    chain = make_chain(compiled, strain, rate, 0.01)
    arrivals = np.full(contacts + 2, math.nan)

    def run(chain, time):
        run_chain(chain, time, error, level, arrivals)

    ways = (beads // 4, beads // 2, beads)
    # Farther behind, what is left of the front is smaller than what the start has left there.
    length = math.ceil(0.5 * window_behind)
    velocity_jumps, powers = zip(
        *(_measure_at(chain, law, c, way, max(origin + way - length, 0), run) for way in ways),
        strict=True,
    )
    times = arrivals[origin : origin + beads - 2]
    speeds = [_slope(times[way // 2 : way]) for way in ways]
    return {
        "speed": _settling(*speeds),
        "velocity_jump": _settling(*velocity_jumps),
        "power": _settling(*powers),
    }


def _settling(early, halfway, late):
    """The last of three values, at a quarter, half and the whole of the way, and its error.

    What follows the inverse square changes four times as much in the first doubling of the way; a
    change that happens to vanish in the second is caught by this.
    """
    change = max(abs(late - halfway), 0.25 * abs(halfway - early))
    return Measured(late, change + 8.0 * EPSILON * abs(late))


def _room_behind(law, behind, speed, beads):
    """Contacts behind the jump, so that no reflection from the end catches the front.

    Waves run back at the speed of sound there, return at it, and spread by diffusion meanwhile.
    """
    lead = 0.5 * beads * (math.sqrt(law.elastic.second(behind)) / speed - 1.0)
    spread = 5.0 * math.sqrt(law.viscous.second(behind) * beads / speed)
    return ROOM_BEHIND + math.ceil(lead + spread)


def _measure_at(chain, law, speed, way, first, run):
    """Velocity jump and power of a front about to have run a way, over the contacts from `first`.

    Both are means over the passage of the last bead.
    """
    velocity_jumps, powers = [], []
    for k in range(SAMPLES):
        run(chain, (way - 1.0 + (k + 1.0) / SAMPLES) / speed)
        strain, rate = chain.strain[first:], chain.strain_rate[first:]
        velocity_jumps.append(rate.sum())
        powers.append((law.viscous.second(strain) * rate**2).sum())
    return float(np.mean(velocity_jumps)), float(np.mean(powers))


def _slope(times):
    """Sites passed per time."""
    sites = np.arange(times.size) - 0.5 * (times.size - 1)
    return float(1.0 / (sites @ times / (sites @ sites)))
