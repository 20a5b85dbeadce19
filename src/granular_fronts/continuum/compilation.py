"""Compile every kernel of the amplitude equations once, on problems as small as can be."""

from granular_fronts.continuum.log_burgers.solution import solve
from granular_fronts.continuum.log_kdv_burgers.survey import survey_heteroclinic
from granular_fronts.scenes.ring import Ring

RING = {
    "law": {"alpha": 1.5, "gamma": 0.24},
    "displacement": 5.0,
    "half_beads": 20,
    "start": {"kind": "plateau", "half_width": 4.0, "floor": 1.0e-7},
    "end_time": 0.1,
    "tolerance": {"relative": 1.0e-4, "absolute": 1.0e-4},
    "equations": {"logarithmic": {"cells": 128, "tolerance": 1.0e-4}},
    "record": {"snapshots": [0.1], "grid": {"step": 0.1}},
}
FRONTS = {
    # Underdamped, critical and overdamped fronts, and one strong enough for the slow manifold.
    "mu": [0.0, 0.3, 2.0, 3.0, 15.0],
    "profile": {"start": -5.0, "stop": 5.0, "step": 1.0},
    "portrait": {"mu": 0.3, "starts": [[0.5, 0.0]], "span": 1.0, "step": 0.5, "limit": 2.0},
}


def compile_kernels():
    """Compile every kernel, so that jobs which run side by side find them in the cache."""
    ring = Ring.read(RING)
    for alpha in (1.0, ring.law.alpha):
        solve(ring, alpha, [0.1], 128, 1.0e-4)
    survey_heteroclinic(FRONTS)
