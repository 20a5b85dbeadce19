r"""Fronts driven by a piston, at once or by a ramp; James (2021), eqs. (22) and (23).

Theory.  A piston is a first bead of velocity V (`chain.equations`).  Far from it the front has
:math:`v_p = V`, hence (22) the compression :math:`\delta = V^{2/(\alpha+1)}` and (23) the speed
:math:`c = V^{(\alpha-1)/(\alpha+1)}`, whatever the damping and however the piston got to V.

Transient.  What the start leaves behind are long waves between piston and front.  They run at the
speed of sound :math:`c_s = \sqrt\alpha\,c`.  With small changes :math:`u', v'` of compression and
velocity, :math:`v' \pm c_s u'` is constant along rays to the right and to the left.  At the piston
:math:`v' = 0`.  At the front, which stays a jump between equilibria, (12) and (14) give

.. math:: v' = \tfrac{\alpha+1}{2}\,c\,u' .

A ray that leaves the front at the distance n from the piston comes back to it at the distance λn.
Its amplitude has changed by the factor :math:`-\rho`, with

.. math::

    \lambda = \frac{c_s + c}{c_s - c} = \frac{\sqrt\alpha + 1}{\sqrt\alpha - 1}, \qquad
    \rho = \frac{\alpha + 1 - 2\sqrt\alpha}{\alpha + 1 + 2\sqrt\alpha} = \lambda^{-2} .

Every disturbance, also of the front's slowness 1/c, thus repeats itself at λ times the distance and
time, times :math:`-\lambda^{-2}`.  It decays as :math:`n^{-2}`, and keeps changing its sign.

Measurement.  The same rule removes it.  If a quantity is :math:`q` at some distance and time and
:math:`q_\lambda` at λ times both, its limit is

.. math:: q_\infty = \frac{\lambda^2 q_\lambda + q}{\lambda^2 + 1},

up to the spreading of the waves by damping and dispersion and the width of the front that reflects
them.  Both are smaller by a power of n.  The slowness is taken from the times at which the front (u
= δ/2) passes two beads.  Compression and velocity are taken on the ray :math:`x = ct/4` behind it.
Here t counts from the time at which a piston without a ramp would have had to start.  The error
estimate adds two largest changes of the limit over the last doubling of distance and time.  One is
its own, one that if :math:`q` is taken further ahead by the front's width.
"""

import math
import operator
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from granular_fronts.accuracy import Estimate
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import make_potential
from granular_fronts.studies.chain_scenes import chain_scene

ERROR_METHOD = (
    "largest change over the last doubling of the distance from the piston, and change by the "
    "width of the front"
)

ESTIMATED = {"error_estimate": 0.0, "error_method": "an estimate itself"}
EXACT = {"error_estimate": 4.0e-16, "error_method": "rounding of a closed formula"}
QUANTITIES = {
    "front_speed": "speed",
    "compression_behind": "compression",
    "velocity_behind": "velocity",
}
"""Quantities of a `DrivenFront` by their names in the dataset."""

ARRIVED = 0.9
"""Part of the chain that the front has crossed at the end."""

FAR = 0.88
"""Farthest contact of the measurement of speed, as a part of the chain."""

WINDOW = 1.25
"""Ratio of the distances between which the slowness is measured."""

BEHIND = 0.25
"""Distance from the piston at which compression and velocity are measured; the front is at 1."""

FRONT = (0.01, 0.99)
"""Compressions over δ between which the front is."""

SCALES = 2.0 ** -np.linspace(0.0, 1.0, 9)
"""Distances and times over the largest ones: the last doubling."""


class DrivenFront(NamedTuple):
    """Front ahead of a piston, its limits far from the piston, and what theory says."""

    speed: Estimate  # c in beads per unit of time
    compression: Estimate  # δ behind the front
    velocity: Estimate  # v_p of the beads behind the front
    # By (23) and (22), through `granular_fronts.model.jump_conditions`.
    expected_speed: float
    expected_compression: float
    expected_velocity: float
    # Largest change of the piston's own velocity from what is prescribed, relative.
    velocity_drift: float


def repetition(alpha):
    """Return λ, the factor in distance and time after which a disturbance repeats itself; α > 1."""
    return (math.sqrt(alpha) + 1.0) / (math.sqrt(alpha) - 1.0)


def limit(far, near, alpha):
    """Return limit of a quantity from its values `near` the piston and λ times as `far` from it."""
    weight = repetition(alpha) ** 2
    return (weight * far + near) / (weight + 1.0)


def push_chain(law, velocity, ramp, beads, tolerance):
    """Drive a front with a piston of velocity V > 0 into some hundreds of beads, and measure it.

    The piston rises to V over the time `ramp`.
    """
    alpha = law["alpha"]
    delta = velocity ** (2.0 / (alpha + 1.0))
    theory = jump_conditions(make_potential("hertz", alpha=alpha), -delta, 0.0)
    far = ARRIVED * beads / theory.speed * SCALES
    times = 0.5 * ramp + np.append(far, far / repetition(alpha))
    boundary = {"kind": "piston", "velocity": velocity, "ramp": ramp, "right": 0.0}
    record = {"snapshots": np.sort(times), "arrival_level": 0.5 * delta}
    tolerances = tolerance["relative"], tolerance["absolute"]
    scene = chain_scene(dict(law), beads + 1, boundary, times.max(), tolerances, record)
    motion = simulate_chain(scene, "piston")
    compressions, velocities = motion["relative_displacement"], motion["velocity"]
    width = front_width(compressions.isel(t=-1).values / delta)
    clock = theory.speed * (times - 0.5 * ramp)
    return DrivenFront(
        _limiting_speed(motion["arrival_time"], FAR * beads * SCALES, width, alpha),
        _limit_behind(compressions.sel(t=times), 0.5, BEHIND * clock, width, alpha),
        _limit_behind(velocities.sel(t=times), 0.0, BEHIND * clock, width, alpha),
        theory.speed,
        delta,
        theory.velocity_behind,
        motion.attrs["momentum_drift"],
    )


def front_width(profile):
    """Return the beads between the last contacts above the two levels of `FRONT`."""
    ahead, behind = (np.flatnonzero(profile > level)[-1] for level in FRONT)
    return int(ahead - behind)


def _limiting_speed(arrivals, distances, width, alpha):
    """Return the speed from arrival times; contact n is n − 1/2 beads away from the piston."""
    passed = np.isfinite(arrivals.values)
    arrival = CubicSpline(arrivals["bead"].values[passed] - 0.5, arrivals.values[passed])

    def slowness(distance):
        return (arrival(distance) - arrival(distance / WINDOW)) / (distance - distance / WINDOW)

    near = distances / repetition(alpha)
    speeds, shifted = (
        1.0 / limit(slowness(distances), slowness(place), alpha) for place in (near, near + width)
    )
    length = (1.0 - 1.0 / WINDOW) * distances[0]
    return _last(speeds, shifted, 2.0 * arrivals.error_estimate / length * speeds[0] ** 2)


def _limit_behind(field, first, places, width, alpha):
    """Return the limit of a field behind the front; its first bead or contact is `first`."""
    distances = first + np.arange(field.sizes["bead"] - 1)
    profiles = [CubicSpline(distances, row[: distances.size]) for row in field.values]

    def behind(shift):
        pairs = zip(profiles, places, strict=True)
        return np.split(np.array([profile(place + shift) for profile, place in pairs]), 2)

    (far, near), (_, shifted) = behind(0.0), behind(width)
    return _last(limit(far, near, alpha), limit(far, shifted, alpha), field.error_estimate)


def _last(limits, shifted, error):
    """Return the limit from the farthest measurement, with the error of the integration."""
    changes = np.abs(limits - limits[0]).max() + np.abs(shifted - limits).max()
    return Estimate(float(limits[0]), float(changes + error))


def measure_pistons(cases, velocity, ramps, beads, tolerance):
    """Return the fronts of several laws, each driven with several ramps.

    `front_speed`, `compression_behind` and `velocity_behind` on (law, ramp), each with its
    `…_error` and `…_expected`, and `velocity_drift`.
    """
    fronts = [
        [push_chain(law, velocity, ramp, beads, tolerance) for ramp in ramps]
        for law in cases.values()
    ]
    variables = {"velocity_drift": _gather(fronts, "velocity_drift", ESTIMATED)}
    for name, quantity in QUANTITIES.items():
        errors = _gather(fronts, f"{quantity}.error", ESTIMATED)
        measured = {"error_estimate": float(errors[1].max()), "error_method": ERROR_METHOD}
        variables |= {
            name: _gather(fronts, f"{quantity}.value", measured),
            f"{name}_error": errors,
            f"{name}_expected": _gather(fronts, f"expected_{quantity}", EXACT),
        }
    return xr.Dataset(variables, {"law": list(cases), "ramp": [float(ramp) for ramp in ramps]})


def _gather(fronts, path, attributes):
    """Return the variable of one number of each front, named by its dotted path."""
    read = operator.attrgetter(path)
    values = np.array([[read(front) for front in row] for row in fronts])
    return ("law", "ramp"), values, dict(attributes)
