r"""The jump conditions of section 2 of James (2021) against fronts that are solved and driven.

For any V and W the speed (13), the direction (17), the jump of the velocity (12) and the power lost
(16) follow from the two states.  They are measured here in three ways.

Exact front (`fronts.solve`): its speed is an unknown of the equations, and its power an integral
over the profile.  The discrete equations imply (13) as the exact ones do.  So this speed shows
whether the front reaches both states, and the power whether it is resolved.  Error: change on a
finer grid, by another order, on a longer window, and rounding.

Travelling front: the exact front is put into a chain of beads (`chain.simulate`) and travels.  Its
speed is the slope of the times at which the contacts pass the middle between the states.  No code
is shared with the profile.  Error: what the error of these times can do to the slope, and rounding.

Driven front: the chain starts from a short straight ramp between the two states.  Each bead has the
velocity −c times the mean strain of its two contacts.  Strain and velocity are conserved and would
all be in the front, but the front must first find its inner structure.  (A sharp jump would open
the contacts of a softening law.)  This transient dies out about as the inverse square of the
distance, and limits the accuracy of driven speeds.  The speed is the slope of the times of passage
over the second half of the way.  The jump of the velocity and the power are measured at its end.
They span the passage of one bead and the contacts of the front.  Error: the change on the last
doubling of the way, or a quarter of the change on the doubling before, and rounding. For the
inverse square the change is three times the error that is left. Weakly nonlinear or strongly damped
fronts form slowly, at an exponential rate; they need a longer way, or have larger errors.  The
chain behind the ramp is so long that nothing that its held end reflects reaches the front.

A front that runs to smaller n is measured in the reflected chain, with the states exchanged.
"""

import math

import numpy as np
import xarray as xr

from granular_fronts.accuracy import EPSILON, Estimate
from granular_fronts.chain.simulate import simulate_chain, simulate_once
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.laws import make_law
from granular_fronts.studies.chain_scenes import pressed_chain

ROOM_BEHIND = 60
RAMP = 4
"""Contacts over which a driven front starts."""

TRAVEL, TRAVEL_TOLERANCE = 40, 1.0e-14
SAMPLES = 16
"""Instants within the passage of one bead, whose powers are averaged."""

PROFILE_XI = np.arange(-15.0, 15.01, 0.1)

ESTIMATED = {"error_estimate": 0.0, "error_method": "an estimate itself"}
ERROR_METHODS = {
    "expected": "rounding and quadrature, by granular_fronts.model.jump_conditions",
    "exact": "change on a finer grid, by another order, on a longer window; and rounding",
    "travelling": "what the errors of the times of passage can do to their slope",
    "driven": "change on the last doubling of the way, or a quarter of that before",
}


def measure_jumps(cases, beads, tolerance):
    """Measure the fronts of several lattices; driven ones run over `beads`.

    Each case has `elastic` and `dissipation`, kinds of potentials with their parameters
    (`model.kinds`), and `states`, R₋ and R₊.  On (law,): `state_minus`, `state_plus`, `direction`,
    and `speed_…`, `velocity_jump_…` and `power_…`, each with its `…_error`.  Their endings are
    `expected`, `exact`, `travelling` and `driven`, as far as they are measured.  On (law, xi) it
    holds the `profile` of the exact front.  Without a front it raises an InputError or a
    NoFrontError.
    """
    rows = [_measure(name, case, beads, tolerance) for name, case in cases.items()]
    variables = {}
    for name in rows[0][0]:
        values, errors = map(np.array, zip(*(row[name] for row, _ in rows), strict=True))
        method = ERROR_METHODS.get(name.rpartition("_")[2], "none: given or a sign")
        attributes = {"error_estimate": float(errors.max()), "error_method": method}
        variables[name] = ("law", values, attributes)
        if method in ERROR_METHODS.values():
            variables[f"{name}_error"] = ("law", errors, dict(ESTIMATED))
    profiles = {"error_estimate": 1e-13, "error_method": "interpolation, checked by its tests"}
    variables["profile"] = (("law", "xi"), np.array([profile for _, profile in rows]), profiles)
    coordinate = {"long_name": "bead number n - |c| t from the middle of the front"}
    return xr.Dataset(variables, {"law": list(cases), "xi": ("xi", PROFILE_XI, coordinate)})


def _measure(name, case, beads, tolerance):
    """Return everything of one lattice, by the name of the variable, and its profile."""
    law = make_law(elastic=case["elastic"], viscous=case["dissipation"])
    states = tuple(map(float, case["states"]))
    theory = jump_conditions(law, *states)
    sign, jump = theory.direction, states[1] - states[0]
    # Reflected where the front runs to smaller n, so that it runs to larger n.
    front = solve_front(law=law, states=states[::sign])
    if not front.attrs["converged"]:
        raise NoFrontError(f"The front of {name} is not found: {front.attrs['reason']}.")
    power_error = theory.dissipated_power * (
        theory.speed_error / abs(theory.speed) + theory.energy_error / theory.energy_per_bead
    )
    driven = drive_front(law, front, beads, tolerance)
    row = {
        "state_minus": (states[0], 0.0),
        "state_plus": (states[1], 0.0),
        "direction": (sign, 0.0),
        "speed_expected": (theory.speed, theory.speed_error),
        "speed_exact": _signed(sign, _exact_speed(front)),
        "speed_travelling": _signed(sign, travelling_speed(law, front)),
        "speed_driven": _signed(sign, driven["speed"]),
        "velocity_jump_expected": (theory.velocity_jump, theory.speed_error * abs(jump)),
        "velocity_jump_driven": driven["velocity_jump"],
        "power_expected": (theory.dissipated_power, power_error),
        "power_exact": _rounded(*(front.attrs[f"dissipated_power{end}"] for end in ("", "_error"))),
        "power_driven": driven["power"],
    }
    behind, ahead = states[::sign]
    return row, (evaluate_front(front, PROFILE_XI, "strain") - ahead) / (behind - ahead)


def _exact_speed(front):
    """Return the speed at which the profile equation has the front."""
    speed, defect, error = (front.attrs[f"speed{end}"] for end in ("", "_defect", "_defect_error"))
    return _rounded(speed * (1.0 + defect), speed * error)


def _rounded(value, error):
    return Estimate(value, error + 8.0 * EPSILON * abs(value))


def _signed(sign, estimate):
    return Estimate(sign * estimate.value, estimate.error)


def travelling_speed(law, front):
    """Return the speed of an exact front of a law in a chain."""
    xi, speed = front["xi"].values, front.attrs["speed"]
    first = math.floor(xi[0])
    sites = np.arange(first, TRAVEL + math.ceil(xi[-1]) + 1.0)
    u, velocity = evaluate_front(front, sites), evaluate_front(front, sites, "velocity")
    scene = _scene(law, front, u, velocity, TRAVEL_TOLERANCE, snapshots=[TRAVEL / speed])
    arrival = simulate_chain(scene)["arrival_time"]
    passed = slice(1 - first, TRAVEL - first)
    # The passages are 1/c apart and good to some units of rounding of the strain.
    time_error = arrival.attrs["error_estimate"] + 8.0 * EPSILON / speed
    return _speed(arrival.values[passed], time_error)


def drive_front(law, front, beads, tolerance):
    """Estimate `speed`, `velocity_jump` (ahead less behind) and `power` of a front from a ramp.

    The exact front gives states, speed and lengths; the tolerance is in units of the jump.
    """
    behind, ahead, c = (front.attrs[name] for name in ("state_behind", "state_ahead", "speed"))
    window_behind, window_ahead = np.abs(front["xi"].values[[0, -1]])
    # The contact in the middle of the ramp.
    origin = _room_behind(law, behind, c, beads)
    contact = np.arange(origin + beads + math.ceil(window_ahead) + 2)
    share = np.clip(0.5 - (contact - origin) / RAMP, 0.0, 1.0)
    strain = ahead + (behind - ahead) * share
    velocity = -0.5 * c * (strain[:-1] + strain[1:])
    ways = (beads // 4, beads // 2, beads)
    moments = [(way - 1.0 + np.arange(1, SAMPLES + 1) / SAMPLES) / c for way in ways]
    scene = _scene(law, front, -strain[1:], velocity, tolerance, snapshots=np.concatenate(moments))
    motion = simulate_once(scene)
    # Farther behind, what is left of the front is smaller than what the start has left there.
    length = math.ceil(0.5 * window_behind)
    velocity_jumps, powers = zip(
        *(
            _measure_at(motion.sel(t=times), law, slice(max(origin + way - length, 1), None))
            for way, times in zip(ways, moments, strict=True)
        ),
        strict=True,
    )
    times = motion["arrival_time"].sel(bead=slice(origin, origin + beads - 3)).values
    speeds = [_speed(times[way // 2 : way], 0.0).value for way in ways]
    return {
        "speed": _settling(*speeds),
        "velocity_jump": _settling(*velocity_jumps),
        "power": _settling(*powers),
    }


def _scene(law, front, u, velocity, tolerance, snapshots):
    """Return a chain between the states of a front, with given displacements and velocities."""
    behind, ahead = front.attrs["state_behind"], front.attrs["state_ahead"]
    return pressed_chain(
        law,
        velocity.size,
        float(snapshots[-1]),
        (tolerance, tolerance * abs(behind - ahead)),
        {"snapshots": list(map(float, snapshots)), "arrival_level": -0.5 * (behind + ahead)},
        left=-behind,
        right=-ahead,
        start=(u[:-1], velocity),
    )


def _settling(early, halfway, late):
    """Return the last of three values, at a quarter, half and all of the way, and its error."""
    # What follows the inverse square changes four times as much in the first doubling of the way.
    # This catches a change that happens to vanish in the second.
    change = max(abs(late - halfway), 0.25 * abs(halfway - early))
    return Estimate(late, change + 8.0 * EPSILON * abs(late))


def _room_behind(law, behind, speed, beads):
    """Return the contacts behind the ramp, so that no reflection from the end catches the front."""
    # Waves run back at the speed of sound there, return at it, and spread by diffusion meanwhile.
    lead = 0.5 * beads * (math.sqrt(law.elastic.second(behind)) / speed - 1.0)
    spread = 5.0 * math.sqrt(law.viscous.second(behind) * beads / speed)
    return ROOM_BEHIND + math.ceil(lead + spread)


def _measure_at(motion, law, front):
    """Return velocity jump and power of a front over some contacts, means over the snapshots."""
    strain = -motion["relative_displacement"].sel(bead=front).values[:, :-1]
    rate = np.diff(motion["velocity"].sel(bead=front).values, axis=1)
    power = (law.viscous.second(strain) * rate**2).sum(axis=1)
    return float(rate.sum(axis=1).mean()), float(power.mean())


def _speed(times, time_error):
    """Return the sites passed per time, from the times of neighbouring sites and their error."""
    sites = np.arange(times.size) - 0.5 * (times.size - 1)
    slowness = float(sites @ times / (sites @ sites))
    error = time_error * float(np.abs(sites).sum() / (sites @ sites))
    return Estimate(1.0 / slowness, error / slowness**2)
