"""Scenes and small solvers that several tests share."""

import numpy as np

from granular_fronts.chain import strain
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.run import load_state
from granular_fronts.chain.state import Size
from granular_fronts.numerics.runge_kutta import NEW_SLOPE

TIGHT = {"relative": 1.0e-13, "absolute": 1.0e-15}


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
    start = {"kind": "given", "relative_displacement": list(u), "velocity": list(velocity)}
    return scene | {"boundary": {"kind": "ring"}, "start": start} | changes


def smooth_ring(beads=24):
    """A compressed ring carrying a smooth wave: all contacts stay closed."""
    phase = 4.0 * np.pi * np.arange(beads) / beads
    return 1.0 + 0.5 * np.cos(phase), 0.15 * np.sin(phase / 2.0) + 0.05 * np.cos(phase)


def integrate_strain_fixed(law, u, velocity, h, steps):
    """Fixed steps of the strain form on a ring; returns u and d of all beads."""
    beads = u.size
    size = Size(beads, beads)
    state = load_state(law, size, Boundary(ring=True), u, velocity)
    strain.evaluate_slopes(law, size, state, state.u, 0, beads)
    for _ in range(steps):
        strain.try_step(law, size, state, h, beads)
        strain.evaluate_slopes(law, size, state, state.new_u, NEW_SLOPE, beads)
        strain.accept(state, beads)
    inside = slice(1, beads + 1)
    return state.u[inside].copy(), state.d[inside].copy()
