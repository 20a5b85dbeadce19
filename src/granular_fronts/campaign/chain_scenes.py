"""The scene of a point of a driven chain, in units of its own; see `chain_points`."""

import math

from granular_fronts.campaign.laws import law_at
from granular_fronts.model.laws import make_law
from granular_fronts.scenes.laws import front_speed

ARRIVAL_LEVEL = 0.5
ABSOLUTE_TO_RELATIVE = 0.01


def normalised_scene(point, tolerance):
    """Return the scene of a point in units of δ and 1/c."""
    alpha, beta, delta = point["alpha"], point["beta"], point["delta"]
    beads = int(point["beads"])
    gamma = point["gamma"] * delta ** (beta - 0.5 * (alpha + 1.0))
    return {
        "law": {"alpha": alpha, "beta": beta, "gamma": gamma},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": 1.0, "right": point["delta_right"] / delta},
        "start": {"kind": "rest"},
        "end_time": point["crossings"] * beads,
        "tolerance": {"relative": tolerance, "absolute": ABSOLUTE_TO_RELATIVE * tolerance},
        "record": {"snapshots": [], "arrival_level": ARRIVAL_LEVEL, "extremes": True},
    }


def scene_of_law(point, law, tolerance):
    """Return the scene of a point with its law, and its units of length and speed."""
    law, delta, beads = make_law(law_at(law, point)), float(point["delta"]), int(point["beads"])
    c = front_speed(law, math.log10(delta))
    scene = {
        "law": law,
        "beads": beads,
        "boundary": {"kind": "pressure", "left": delta, "right": float(point["delta_right"])},
        "start": {"kind": "rest"},
        "end_time": float(point["crossings"]) * beads / c if c > 0.0 else math.inf,
        "tolerance": {
            "relative": float(tolerance),
            "absolute": float(ABSOLUTE_TO_RELATIVE * tolerance * delta),
        },
        "record": {"snapshots": [], "arrival_level": ARRIVAL_LEVEL * delta, "extremes": True},
    }
    return scene, delta, c
