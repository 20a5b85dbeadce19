r"""Fronts behind an impact, exact fronts of the same height, and when there is one pulse.

One bead strikes a chain at rest (:math:`m = v_0 = 1`), whose law is a power α and a dashpot, β = 1,
that acts in contact.  At some contacts n the front is compared with theory.

Speed and height.  c follows from the times at which u passes half of its largest value at the
contacts n − s and n + s.  By (14) a front into a chain at rest has the height
:math:`\delta = c^{2/(\alpha-1)}`.

Damping.  Over its height and its speed the front obeys (30) with δ = c = 1 and the damping

.. math:: \gamma_\delta = \gamma\,\delta^{-(\alpha-1)/2} ,

which grows while the front sinks.  The exact front of this damping has an overshoot, and so has u
at the contact.

Momentum.  P is that of all beads that move forwards.  At small damping it exceeds that of the
striker, since the first beads rebound.  `impact_pulse` gives the height.

One pulse.  Two pulses are apart if, at some time, u has two maxima along the chain, of which the
lower has a part of the higher.  This ceases at a damping, and at another one the front of a contact
ceases to overshoot.

Errors.  A time series is read from a cubic spline, and once more from a spline through every other
point.  The error is the difference, and what the error of the chain's motion makes of it.  It does
not say how far a front that sinks is from one that travels for ever: that is what is measured.
"""

from functools import cache

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.optimize import bisect, brentq

from granular_fronts.accuracy import Estimate, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.studies.strikers import struck_chain
from impact_pulse import height_of_front, time_of_front

ALPHA = 1.5
"""Exponent of beads."""

REACH = 8
"""Contacts s on both sides between which the speed is measured."""

WINDOW = 60.0
"""Beads before and after the front that a time series covers."""

SAMPLES_PER_BEAD = 20.0
"""Samples while the front moves by one bead."""

SHOWN = np.linspace(-25.0, 6.0, 621)
"""ξ at which fronts are kept, in beads."""

METHOD = "half the samples, and the error of the motion"

BETWEEN, SOUGHT = (0.07, 0.17), 1e-4
"""Dampings between which pulses cease to be apart and fronts to overshoot, and how exactly."""

CROSSED, STEP = 150, 0.1
"""Contacts that an impact crosses in which two pulses are sought, and the step in time."""

NEGLIGIBLE = 1e-3
"""Compression of no pulse, below that of any front until CROSSED."""


def follow_impact(**scene):
    """Return the motion behind an impact."""
    return simulate_chain(scene, "impact")


def follow_fronts(dampings, contacts, early_contacts, parts, tolerance):
    """Compare fronts at contacts with exact ones, for each damping; find when there is one pulse.

    On (gamma, contact): `height`, `height_of_momentum`, `damping` in units of the front,
    `overshoot` and `exact_overshoot`; on (gamma, contact, xi): `front`, `exact_front`, u over the
    height.  Dampings, on (part): `one_pulse`; on (early_contact): `no_overshoot`.  Numbers have
    `…_error`.
    """
    found = []
    for gamma in dampings:
        motion = simulate_chain(impact_scene(gamma, contacts, tolerance), "impact")
        momentum = _forward_momentum(motion)
        found.append([_compare(motion, gamma, contact, momentum) for contact in contacts])

    def all_of(name):
        return [[front[name] for front in fronts] for fronts in found]

    one_pulse = [one_pulse_from(part, tolerance) for part in parts]
    no_overshoot = [no_overshoot_from(contact, tolerance) for contact in early_contacts]
    variables, place = {}, ("gamma", "contact")
    for name, dims, numbers, meaning in (
        ("height", place, None, "height of the front by its speed, eq. (14)"),
        ("height_of_momentum", place, None, "height of the front by the momentum of the pulse"),
        ("damping", place, None, "damping in units of the front"),
        ("overshoot", place, None, "overshoot of u at a contact over the height of the front"),
        ("exact_overshoot", place, None, "overshoot of the exact front of the same damping"),
        ("one_pulse", "part", one_pulse, "damping from which there is one pulse"),
        ("no_overshoot", "early_contact", no_overshoot, "damping from which no front overshoots"),
    ):
        variables |= variable_and_errors(name, dims, numbers or all_of(name), METHOD, meaning)
    heights = np.array(all_of("height"))
    attributes = {
        "error_estimate": float((heights[..., 1] / heights[..., 0]).max()),
        "error_method": METHOD,
    }
    for name, meaning in (("front", "u of the chain"), ("exact_front", "u of the exact front")):
        words = {"long_name": f"{meaning} over the height"}
        variables[name] = ((*place, "xi"), np.array(all_of(name)), words | attributes)
    coordinates = {
        "gamma": dampings,
        "contact": contacts,
        "early_contact": ("early_contact", early_contacts, {"long_name": "number of the contact"}),
        "part": ("part", parts, {"long_name": "least lower over higher maximum of two pulses"}),
        "xi": SHOWN,
    }
    return xr.Dataset(variables, coordinates, {"critical_damping": critical_damping(ALPHA, 1.0)})


def _forward_momentum(motion):
    """Return the momentum of all beads that move forwards at the end."""
    velocity = motion["velocity"][-1]
    ahead = np.maximum(velocity.values, 0.0)
    return Estimate(float(ahead.sum()), velocity.attrs["error_estimate"] * np.count_nonzero(ahead))


def impact_scene(gamma, contacts, tolerance):
    """Return the scene of an impact whose time series cover the front at some contacts."""
    probes = {}
    for contact in contacts:
        time = float(time_of_front(ALPHA, contact, 1.0))
        speed = float(height_of_front(ALPHA, contact, 1.0) ** (0.5 * (ALPHA - 1.0)))
        step = 1.0 / (SAMPLES_PER_BEAD * speed)
        # The front of a young pulse is late or early by some beads.
        first = max(time - WINDOW / speed, 0.0)
        samples = 2 * int((time + WINDOW / speed - first) / (2.0 * step))
        stop = first + samples * step
        beads = [contact - REACH, contact, contact + REACH]
        probes[f"n{contact}"] = {"beads": beads, "start": first, "stop": stop, "step": step}
    end = max(probe["stop"] for probe in probes.values())
    beads, record = int(max(contacts) + 2.0 * WINDOW), {"snapshots": [end], "probes": probes}
    return struck_chain((ALPHA, 1.0, gamma), beads, end, tolerance, record)


def _compare(motion, gamma, contact, momentum):
    """Return what is known of the front at a contact."""
    usual, coarse = (_read(motion, contact, every) for every in (1, 2))
    moved = _read(motion, contact, error=1.0)
    error = {
        key: abs(usual[key] - coarse[key]) + abs(usual[key] - moved[key])
        for key in ("height", "peak")
    }
    height, power = Estimate(usual["height"], error["height"]), 0.5 * (ALPHA - 1.0)
    damping = height**-power * gamma
    exact = solve_front(ALPHA, damping.value, beta=1.0)
    clock = usual["time"] - SHOWN / height.value**power
    spline = usual["spline"]
    return {
        "height": height,
        "height_of_momentum": height_of_front(ALPHA, contact, momentum),
        "damping": damping,
        "overshoot": Estimate(usual["peak"], error["peak"]) / height - 1.0,
        "exact_overshoot": Estimate(exact.attrs["overshoot"], exact.attrs["overshoot_error"]),
        "front": np.where(clock <= spline.x[-1], spline(clock) / height.value, np.nan),
        "exact_front": evaluate_front(exact, SHOWN),
    }


def _read(motion, contact, every=1, error=0.0):
    """Return height, peak, time and spline of a front, with some times the error of the motion."""
    series = motion[f"relative_displacement_n{contact}"]
    values = series.values[::every] + error * series.attrs["error_estimate"]
    splines = [CubicSpline(motion[f"t_n{contact}"][::every], column) for column in values.T]
    peaks = [np.nanmax(one(one.derivative().roots(extrapolate=False))) for one in splines]
    first, _, last = map(_passage, splines, 0.5 * np.array(peaks))
    height = (2.0 * REACH / (last - first)) ** (2.0 / (ALPHA - 1.0))
    time = _passage(splines[1], 0.5 * height)
    return {"height": height, "peak": peaks[1], "time": time, "spline": splines[1]}


def _passage(spline, level):
    """Return when a spline first has a level."""
    after = np.argmax(spline(spline.x) >= level)
    return brentq(lambda time: spline(time) - level, spline.x[after - 1], spline.x[after])


@cache
def _crossing(gamma, **tolerance):
    """Return u on (time, contact) until an impact has crossed CROSSED contacts."""
    end = float(time_of_front(ALPHA, CROSSED, 1.0))
    record = {"snapshots": [], "grid": {"step": STEP}}
    scene = struck_chain((ALPHA, 1.0, gamma), 2 * CROSSED, end, tolerance, record)
    return simulate_chain(scene, "impact")["relative_displacement_grid"].values


def apart(u, part):
    """Return whether at some time u has two maxima of which the lower has a part of the higher."""
    inner = u[:, 1:-1]
    tops = np.where((inner > u[:, :-2]) & (inner >= u[:, 2:]), inner, 0.0)
    lower, higher = np.partition(tops, -2, axis=1)[:, -2:].T
    return bool(np.any(lower > np.maximum(part * higher, NEGLIGIBLE)))


def one_pulse_from(part, tolerance):
    """Return the damping from which an impact makes one pulse."""
    return _ceasing(lambda gamma, every: apart(_crossing(gamma, **tolerance)[::every], part) - 0.5)


def no_overshoot_from(contact, tolerance):
    """Return the damping from which the front does not overshoot at a contact."""

    def excess(gamma, every):
        front = _read(simulate_chain(impact_scene(gamma, [contact], tolerance)), contact, every)
        return front["peak"] / front["height"] - 1.0

    return _ceasing(excess)


def _ceasing(excess):
    """Return where a function of the damping passes 0, with all samples and with half of them."""
    own, other = (bisect(excess, *BETWEEN, args=(every,), xtol=SOUGHT) for every in (1, 2))
    return Estimate(own, abs(own - other) + SOUGHT)
