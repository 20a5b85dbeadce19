"""The scene of a point of a driven chain, in units of its own; see `chain_points`."""

import itertools
import math
from collections.abc import Iterator, Mapping

from granular_fronts.campaign.laws import law_at
from granular_fronts.scenes.chain import size_of_chain
from granular_fronts.scenes.laws import energies_are_representable, front_speed
from granular_fronts.scenes.limits import part_errors
from granular_fronts.scenes.validation import check_scene

ARRIVAL_LEVEL = 0.5
ABSOLUTE_TO_RELATIVE = 0.01


def time_errors(grid: Mapping[str, tuple], tolerance: float) -> Iterator[str]:
    """Say of a chain at the ends of all axes that it takes too long."""
    for corner in itertools.product(*({values[0]: 0, values[-1]: 0} for values in grid.values())):
        point = dict(zip(grid, corner, strict=True))
        point["beta"] = point["beta"] or point["alpha"]
        try:
            scene = normalised_scene(point, tolerance)
        except OverflowError:
            continue
        if not any(energies_are_representable(scene)):
            for error in part_errors(scene, [*size_of_chain(scene)]):
                yield f"in units of δ and 1/c, {error}"
                return


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
    """Return the checked scene of a point with its law, and its units of length and speed."""
    law, delta, beads = law_at(law, point), float(point["delta"]), int(point["beads"])
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
    return check_scene("chain", scene, "of the point"), delta, c
