"""The scene of a point of a driven chain, in units of its own; see `chain_points`."""

import math

from granular_fronts.campaign.numbers import law_at
from granular_fronts.model.laws import make_law
from granular_fronts.scenes.laws import front_speed

ARRIVAL_LEVEL = 0.5
ABSOLUTE_TO_RELATIVE = 0.01


def scene_of(point, law, tolerance):
    """Return the scene of a point, and its units of length and speed; δ and c without a law."""
    delta, beads = float(point["delta"]), int(point["beads"])
    if law is None:
        alpha, beta, length, c = point["alpha"], point["beta"], 1.0, 1.0
        gamma = point["gamma"] * delta ** (beta - 0.5 * (alpha + 1.0))
        law, right = {"alpha": alpha, "beta": beta, "gamma": gamma}, point["delta_right"] / delta
    else:
        law, length, right = make_law(law_at(law, point)), delta, point["delta_right"]
        c = front_speed(law, math.log10(delta))
    scene = {
        "law": law,
        "beads": beads,
        "boundary": {"kind": "pressure", "left": length, "right": right},
        "start": {"kind": "rest"},
        "end_time": point["crossings"] * beads / c if c > 0.0 else math.inf,
        "tolerance": {"relative": tolerance, "absolute": ABSOLUTE_TO_RELATIVE * tolerance * length},
        "record": {"snapshots": [], "arrival_level": ARRIVAL_LEVEL * length, "extremes": True},
    }
    return scene, length, c
