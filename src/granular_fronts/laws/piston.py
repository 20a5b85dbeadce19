r"""Fronts driven by a piston of constant velocity; James (2021), eqs. (22) and (23).

A piston is a bead that moves at the velocity V whatever its neighbour does.  No boundary of its own
is needed: let it be the middle one of 2N + 1 beads, with N beads at rest ahead of it and N beads
that move at 2V behind it.  With :math:`x_{-n} - x_0 = -(x_n - x_0)` both halves mirror each other,
the forces on the middle bead cancel, and it keeps V: the right half is the chain with a piston.

Theory.  Far from the piston the front has :math:`v_p = V`, hence (22) the compression :math:`\delta
= V^{2/(\alpha+1)}` and (23) the speed :math:`c = V^{(\alpha-1)/(\alpha+1)}`, whatever the damping.

Measurement.  The speed is taken from the times at which the front (u = δ/2) passes two beads, the
second twice as far as the first.  The sudden start leaves a transient that dies out algebraically;
the changes on two doublings of the distance, and for the compression behind the front on one of the
time, tell how much of it is left, which is the error estimate.
"""

from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.contact import generalised_hertz
from granular_fronts.jumps import jump_conditions

SPEED_ERROR = "change from a quarter to half to the whole distance from the piston"
COMPRESSION_ERROR = "difference to the same measurement at half the time"

ARRIVED = 0.9
"""Part of the chain that the front has crossed at the end."""

FAR = 0.8
"""Farthest bead of the measurement, as a part of the chain."""


class DrivenFront(NamedTuple):
    """Front ahead of a piston, and what theory says.

    Attributes
    ----------
    speed, speed_error : float
        c in beads per unit of time.
    compression, compression_error : float
        δ behind the front.
    expected_speed, expected_compression : float
        By (23) and (22), through `granular_fronts.jumps`.
    velocity_drift : float
        Largest change of the piston's velocity, relative; rounding, by symmetry.
    """

    speed: float
    speed_error: float
    compression: float
    compression_error: float
    expected_speed: float
    expected_compression: float
    velocity_drift: float


def push_chain(law, velocity, beads, tolerance):
    """Drive a front with a piston and measure it.

    Parameters
    ----------
    law : mapping
        `alpha`, above 1, `beta` and `gamma`.
    velocity : float
        V of the piston, above 0.
    beads : int
        N, the beads ahead of the piston; some dozens or more.
    tolerance : mapping
        `relative` and `absolute`, of the integration.

    Returns
    -------
    DrivenFront
    """
    delta = velocity ** (2.0 / (law["alpha"] + 1.0))
    theory = jump_conditions(generalised_hertz(law["alpha"]), -delta, 0.0)
    end_time = ARRIVED * beads / theory.speed
    motion = simulate_chain(
        {
            "law": dict(law),
            "beads": 2 * beads + 1,
            "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
            "start": {
                "kind": "given",
                "relative_displacement": [0.0] * (2 * beads),
                "velocity": [2.0 * velocity] * beads + [velocity] + [0.0] * beads,
            },
            "end_time": end_time,
            "tolerance": dict(tolerance),
            "record": {"snapshots": [0.5 * end_time, end_time], "arrival_level": 0.5 * delta},
        },
        "piston",
    )
    return _measure(motion, beads, velocity, theory, delta)


def _measure(motion, beads, velocity, theory, delta):
    ahead = slice(beads, 2 * beads)
    arrivals = motion["arrival_time"].values[ahead]
    earlier, compression = motion["relative_displacement"].values[:, beads + beads // 8]
    velocities = motion["velocity"].values[:, beads]
    far = round(FAR * beads)
    windows = (far // 2, far // 4, far // 8)
    speed, nearer, nearest = (n / (arrivals[2 * n] - arrivals[n]) for n in windows)
    return DrivenFront(
        float(speed),
        float(abs(speed - nearer) + abs(nearer - nearest)),
        float(compression),
        float(abs(compression - earlier)) + motion["relative_displacement"].error_estimate,
        theory.speed,
        delta,
        float(np.abs(velocities / velocity - 1.0).max()),
    )


def measure_pistons(cases, velocity, beads, tolerance):
    """Fronts of several laws.

    Parameters
    ----------
    cases : mapping
        Laws by name.
    velocity, beads, tolerance
        As in `push_chain`.

    Returns
    -------
    xarray.Dataset
        `front_speed` and `compression_behind` on (law,), each with its `…_error` and
        `…_expected`, and `velocity_drift`.
    """
    fronts = [push_chain(law, velocity, beads, tolerance) for law in cases.values()]
    speeds, speed_errors, compressions, errors, expected, deltas, drifts = map(
        np.array, zip(*fronts, strict=True)
    )
    exact = {"error_estimate": 4e-16, "error_method": "rounding of a closed formula"}
    estimated = {"error_estimate": 0.0, "error_method": "an estimate itself"}
    return xr.Dataset(
        {
            "front_speed": ("law", speeds, _error(speed_errors, SPEED_ERROR)),
            "front_speed_error": ("law", speed_errors, estimated),
            "front_speed_expected": ("law", expected, exact),
            "compression_behind": ("law", compressions, _error(errors, COMPRESSION_ERROR)),
            "compression_behind_error": ("law", errors, estimated),
            "compression_behind_expected": ("law", deltas, exact),
            "velocity_drift": ("law", drifts, estimated),
        },
        {"law": list(cases)},
    )


def _error(estimates, method):
    return {"error_estimate": float(estimates.max()), "error_method": method}
