r"""Fronts of the pulse behind an impact, and exact fronts of the same height.

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

Errors.  A time series is read from a cubic spline, and once more from a spline through every other
point.  The error is the difference, and what the error of the chain's motion makes of it.  It does
not say how far a front that sinks is from one that travels for ever: that is what is measured.
"""

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, minimize_scalar

from granular_fronts.accuracy import Estimate, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.strikers import struck_chain
from impact_pulse import height_of_front, time_of_front
from job import job

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

METHOD = "difference of splines through all and half the samples, and the error of the motion"


def follow_fronts(dampings, contacts, tolerance):
    """Compare fronts at contacts with exact ones, for each damping.

    On (gamma, contact): `height`, `height_of_momentum`, `damping` in units of the front,
    `overshoot` and `exact_overshoot`, each with its `…_error`; on (gamma, contact, xi): `front`,
    `exact_front`, u over the height.
    """
    found = []
    for gamma in dampings:
        motion = simulate_chain(impact_scene(gamma, contacts, tolerance), "impact")
        momentum = _forward_momentum(motion)
        found.append([_compare(motion, gamma, contact, momentum) for contact in contacts])

    def all_of(name):
        return [[front[name] for front in fronts] for fronts in found]

    variables = {}
    for name, meaning in (
        ("height", "height of the front by its speed, eq. (14)"),
        ("height_of_momentum", "height of the front by the momentum of the pulse"),
        ("damping", "damping in units of the front"),
        ("overshoot", "overshoot of u at a contact over the height of the front"),
        ("exact_overshoot", "overshoot of the exact front of the same damping"),
    ):
        variables |= variable_and_errors(name, ("gamma", "contact"), all_of(name), METHOD, meaning)
    heights = np.array(all_of("height"))
    attributes = {
        "error_estimate": float((heights[..., 1] / heights[..., 0]).max()),
        "error_method": METHOD,
    }
    for name, meaning in (("front", "u of the chain"), ("exact_front", "u of the exact front")):
        words = {"long_name": f"{meaning} over the height"}
        variables[name] = (("gamma", "contact", "xi"), np.array(all_of(name)), words | attributes)
    coordinates = {"gamma": dampings, "contact": contacts, "xi": SHOWN}
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
    series = motion[f"relative_displacement_n{contact}"]
    times, values = motion[f"t_n{contact}"].values, series.values
    usual, coarse = (_read(times[::every], values[::every]) for every in (1, 2))
    moved = _read(times, values + series.attrs["error_estimate"])
    error = {
        key: abs(usual[key] - coarse[key]) + abs(usual[key] - moved[key])
        for key in ("height", "peak")
    }
    height, power = Estimate(usual["height"], error["height"]), 0.5 * (ALPHA - 1.0)
    damping = height**-power * gamma
    exact = solve_front(ALPHA, damping.value, beta=1.0)
    clock = usual["time"] - SHOWN / height.value**power
    u = CubicSpline(times, values[:, 1])(clock) / height.value
    return {
        "height": height,
        "height_of_momentum": height_of_front(ALPHA, contact, momentum),
        "damping": damping,
        "overshoot": Estimate(usual["peak"], error["peak"]) / height - 1.0,
        "exact_overshoot": Estimate(exact.attrs["overshoot"], exact.attrs["overshoot_error"]),
        "front": np.where(clock <= times[-1], u, np.nan),
        "exact_front": evaluate_front(exact, SHOWN),
    }


def _read(times, values):
    """Return height, peak and time of a front in the series of three contacts."""
    splines = [CubicSpline(times, column) for column in values.T]
    peaks = [_largest(spline) for spline in splines]
    first, _, last = (
        _passage(spline, 0.5 * peak) for spline, peak in zip(splines, peaks, strict=True)
    )
    height = (2.0 * REACH / (last - first)) ** (2.0 / (ALPHA - 1.0))
    return {"height": height, "peak": peaks[1], "time": _passage(splines[1], 0.5 * height)}


def _largest(spline):
    """Return the largest value of a spline."""
    high = spline.x[np.argmax(spline(spline.x))]
    step = spline.x[1] - spline.x[0]
    found = minimize_scalar(
        lambda time: -spline(time),
        bounds=(high - step, high + step),
        options={"xatol": 1e-9 * step},
    )
    return -float(found.fun)


def _passage(spline, level):
    """Return when a spline first has a level."""
    after = np.argmax(spline(spline.x) >= level)
    return brentq(lambda time: spline(time) - level, spline.x[after - 1], spline.x[after])


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        fronts = follow_fronts(**settings)
        write_dataset(fronts, snakemake.output.dataset, scene_id="fronts", config=settings)
