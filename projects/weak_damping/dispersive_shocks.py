r"""Dispersive shocks of a chain without damping, and the fronts into which damping turns them.

A constant force 1 drives bead 1 of a chain of two powers, β = α.  The chain
is at rest, and behind u = 1.  A leading crest passes contact n, and others follow.

Without damping this train of crests spreads for ever.  Its *zone* ends where crests pass u = 1 by
0.1 alone: it is the time until then, since a front into a chain at rest has the speed 1 (14).
"""

import math

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from granular_fronts.accuracy import Estimate, estimate, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.output.datasets import write_dataset
from job import job

REACH = 8  # contacts on both sides between which the speed of the leading crest is measured
ZONE = 0.1  # by how much the last crest of the zone passes u = 1
SLOWEST = 0.36  # speed of the last crests that are recorded
STEP = 0.05  # time between two samples
SPLINES = "difference of splines through all and half the samples"


def follow_shocks(alpha, dampings, contacts, tolerance):
    """Follow the crests behind a constant force 1, for each damping.

    On (gamma, contact): `height` and `speed` of the leading crest, and `zone`.  On (gamma):
    `velocity_behind` in the second half of the time.  Each comes with its `…_error`.
    """
    crests, behind = [], []
    for gamma in dampings:
        motion = simulate_chain(_scene(alpha, gamma, contacts, tolerance), "shock")
        crests.append([_read_twice(motion, contact) for contact in contacts])
        velocities = motion["velocity"].values[:, :40].mean(axis=1)
        behind.append(Estimate(float(velocities.mean()), float(np.ptp(velocities))))
    method, words = "range of six times", "velocity of the driven beads"
    variables = variable_and_errors("velocity_behind", "gamma", behind, method, words)
    for place, (name, meaning) in enumerate(
        (
            ("height", "compression of the leading crest"),
            ("speed", "speed of the leading crest"),
            ("zone", "beads from the leading crest to where crests pass u = 1 by 0.1"),
        )
    ):
        table = [[crest[place] for crest in row] for row in crests]
        variables |= variable_and_errors(name, ("gamma", "contact"), table, SPLINES, meaning)
    return xr.Dataset(variables, {"gamma": dampings, "contact": contacts}, {"alpha": alpha})


def _scene(alpha, gamma, contacts, tolerance):
    """Return the scene of a constant force whose time series cover the crests at some contacts."""
    probes = {}
    for contact in contacts:
        start, samples = 0.5 * contact, 2 * int((1.0 / SLOWEST - 0.5) * contact / (2.0 * STEP))
        beads = [contact - REACH, contact, contact + REACH]
        stop = start + samples * STEP
        probes[f"n{contact}"] = {"beads": beads, "start": start, "stop": stop, "step": STEP}
    return {
        "law": {"alpha": alpha, "beta": alpha, "gamma": gamma},
        "beads": int(1.3 * stop),
        "boundary": {"kind": "force", "force": 1.0, "right": 0.0},
        "start": {"kind": "equilibrium"},
        "end_time": stop,
        "tolerance": tolerance,
        "record": {"snapshots": np.linspace(0.5 * stop, stop, 6).tolist(), "probes": probes},
    }


def _read_twice(motion, contact):
    """Return height, speed and zone at a contact, by splines through all and half the samples."""
    times = motion[f"t_n{contact}"].values
    values = motion[f"relative_displacement_n{contact}"].values
    readings = (_read(times[::every], values[::every]) for every in (1, 2))
    return [estimate(*pair) for pair in zip(*readings, strict=True)]


def _read(times, values):
    (before, _), (places, heights), (after, _) = (crests_of(times, one) for one in values.T)
    return heights[0], 2.0 * REACH / (after[0] - before[0]), zone_of(places, heights)


def crests_of(places, values):
    """Return where a curve has maxima above 1, and how high they are."""
    spline = CubicSpline(places, values)
    turns = spline.derivative().roots(extrapolate=False)
    turns = turns[(spline(turns, 2) < 0.0) & (spline(turns) > 1.0)]
    return turns, spline(turns)


def zone_of(places, heights):
    """Return how far behind the first crest the overshoot falls to `ZONE` for good."""
    last = np.flatnonzero(heights > 1.0 + ZONE)[-1]
    if last + 1 == heights.size:
        raise SolveError(
            f"The last crest recorded still passes the state behind by more than {ZONE:g}: the "
            "train is longer than what is recorded of it."
        )
    pair = slice(last, last + 2)
    return np.interp(-math.log(ZONE), -np.log(heights[pair] - 1.0), places[pair]) - places[0]


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        shocks = follow_shocks(**settings)
        write_dataset(shocks, snakemake.output.dataset, scene_id="shocks", config=settings)
