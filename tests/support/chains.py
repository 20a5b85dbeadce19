"""Scenes and small solvers that several tests share."""

import numpy as np
from kernels import from_python

from granular_fronts.chain import integrator, strain
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.run import make_chain
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.state import NEW_U, D, U
from granular_fronts.numerics.runge_kutta import NEW_SLOPE, SLOT

try_step, take_slopes, accept = map(
    from_python, (strain.try_step, strain.take_slopes, strain.accept)
)

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
    return scene | {"boundary": {"kind": "ring"}, "start": given(u, velocity)} | changes


def smooth_ring(beads=24):
    """A compressed ring carrying a smooth wave: all contacts stay closed."""
    phase = 4.0 * np.pi * np.arange(beads) / beads
    return 1.0 + 0.5 * np.cos(phase), 0.15 * np.sin(phase / 2.0) + 0.05 * np.cos(phase)


def given(u, velocity):
    """A start, as scenes have it."""
    return {"kind": "given", "relative_displacement": list(u), "velocity": list(velocity)}


def last_state(scene):
    """u and velocity of all beads at the last snapshot of one integration."""
    last = solve(scene).dataset.isel(t=-1)
    return np.concatenate([last["relative_displacement"], last["velocity"]])


def integrate_strain_fixed(law, u, velocity, h, steps):
    """Fixed steps of the strain form on a ring; returns u and d of all beads."""
    chain, table = make_chain(law, Boundary(ring=True), u, velocity)
    integrator.begin(chain, table)
    for _ in range(steps):
        try_step(chain, table, h, chain.beads, False)
        take_slopes(chain, table, NEW_U, SLOT[NEW_SLOPE], chain.beads, False)
        accept(chain, table, chain.beads)
    inside = slice(1, u.size + 1)
    return table[U, inside].copy(), table[D, inside].copy()
