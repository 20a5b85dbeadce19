"""Scenes and small solvers that several tests share."""

import numpy as np

from granular_fronts.chain import run
from granular_fronts.chain.recording import collect
from granular_fronts.chain.simulate import solve

TIGHT = {"relative": 1.0e-13, "absolute": 1.0e-15}
FREE, WALL = {"kind": "pressure", "left": 0.0, "right": 0.0}, {"kind": "wall", "left": 0.0}
REST, STRIKER = {"kind": "rest"}, {"kind": "striker", "beads": 1, "velocity": 1.0}
TODA = {"elastic": {"kind": "toda", "strength": 1.0, "rate": 1.0}, "viscous": {"kind": "none"}}


def driven_scene(gamma=0.06, beads=40, end_time=60.0, alpha=1.5, beta=None, delta=0.1, **changes):
    """Constant pressure on a chain at rest, as in section 3.3."""
    scene = {
        "law": {"alpha": alpha, "beta": alpha if beta is None else beta, "gamma": gamma},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": delta, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": end_time,
        "tolerance": TIGHT,
        "record": {"snapshots": [end_time]},
    }
    return scene | changes


def ring_scene(u, velocity, gamma=0.1, alpha=1.5, beta=None, end_time=10.0, **changes):
    """A ring with a given start."""
    scene = driven_scene(gamma, len(u), end_time, alpha, beta)
    return scene | {"boundary": {"kind": "ring"}, "start": given(u, velocity)} | changes


def free_scene(law, u, velocity, end_time, relative=1.0e-9, **record):
    """A chain of given start with free ends."""
    start = given(u, velocity)
    scene = driven_scene(beads=len(velocity), end_time=end_time, delta=0.0, start=start, law=law)
    tolerance = {"relative": relative, "absolute": 1.0e-3 * relative}
    return scene | {"tolerance": tolerance, "record": scene["record"] | record}


def smooth_ring(beads=24):
    """A compressed ring carrying a smooth wave: all contacts stay closed."""
    phase = 4.0 * np.pi * np.arange(beads) / beads
    return 1.0 + 0.5 * np.cos(phase), 0.15 * np.sin(phase / 2.0) + 0.05 * np.cos(phase)


def given(u, velocity):
    """A start, as scenes have it."""
    return {"kind": "given", "relative_displacement": list(u), "velocity": list(velocity)}


def last_state(scene):
    """u and velocity of all beads at the last snapshot of one integration."""
    return _last(solve(scene).dataset)


def after_steps(scene, ends):
    """The same after steps that end at given times, each taken in two halves."""
    part = run.prepare(scene)
    run.integrate_in_halves(part, scene["tolerance"], np.array(ends))
    return _last(collect(part).dataset)


def _last(motion):
    last = motion.isel(t=-1)
    return np.concatenate([last["relative_displacement"], last["velocity"]])
