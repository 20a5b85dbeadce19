"""Rings of section 4.3 on coarse grids, and orders of convergence."""

import copy
from pathlib import Path

import numpy as np
from numpy.polynomial import Polynomial

from granular_fronts.continuum.log_burgers.solution import solve
from granular_fronts.scenes.ring import Ring
from granular_fronts.scenes.yaml_files import load_configuration

CONFIGURATION = load_configuration(Path(__file__).parents[2] / "config" / "default.yaml")
SCENES = CONFIGURATION["scenes"]["periodic"]


def scene_with(name="weak", **changes):
    """A paper scene on coarse grids; `law__gamma=…` reaches into it."""
    scene = copy.deepcopy(SCENES[name])
    tolerances = {"logarithmic": 1.0e-6, "unlimited": 1.0e-5, "dispersive": 1.0e-6}
    for equation, tolerance in tolerances.items():
        scene["equations"][equation] = {"cells": 512, "tolerance": tolerance}
    for path, value in changes.items():
        *parents, last = path.split("__")
        node = scene
        for parent in parents:
            node = node[parent]
        node[last] = value
    if "record__snapshots" not in changes:
        ends = [t for t in scene["record"]["snapshots"] if t <= scene["end_time"]]
        scene["record"]["snapshots"] = ends or [scene["end_time"]]
    return scene


def slope_and_residual(sizes, errors):
    """Observed order and the scatter about it, in powers of ten."""
    x, y = np.log10(sizes), np.log10(errors)
    line = Polynomial.fit(x, y, 1).convert()
    return -line.coef[1], np.abs(line(x) - y).max()


def assert_order(sizes, errors, expected, within, scatter=0.05):
    """The observed order is as expected, and the errors lie on a line."""
    order, found = slope_and_residual(sizes, errors)
    assert abs(order - expected) <= within, f"order {order:.3f}, not {expected}"
    assert found < scatter, f"scatter {found:.3f}"


def at_end(scene, alpha, cells, tolerance):
    """Cell averages at the end of a scene."""
    return solve(Ring.read(scene), alpha, [scene["end_time"]], cells, tolerance).averages[0]


def coarsen(averages, cells):
    return averages.reshape(cells, -1).mean(axis=1)
