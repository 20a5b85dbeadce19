"""Scenes of chains from which many studies start."""


def kuwabara_kono(alpha, gamma):
    """Return the law with β = α."""
    return {"alpha": alpha, "beta": alpha, "gamma": gamma}


def chain_scene(law, beads, boundary, end_time, tolerance, record, start):
    """Return a chain at rest, unless `start` gives relative displacements and velocities.

    `tolerance` is the relative one and the absolute one.
    """
    relative, absolute = tolerance
    scene = {
        "law": law,
        "beads": beads,
        "boundary": boundary,
        "start": {"kind": "rest"},
        "end_time": end_time,
        "tolerance": {"relative": relative, "absolute": absolute},
        "record": record,
    }
    if start is not None:
        u, velocity = (list(map(float, part)) for part in start)
        scene["start"] = {"kind": "given", "relative_displacement": u, "velocity": velocity}
    return scene


def pressed_chain(law, beads, end_time, tolerance, record, left=1.0, right=0.0, start=None):
    """Return a chain with `left` and `right` held at its ends; the rest as of `chain_scene`."""
    boundary = {"kind": "pressure", "left": left, "right": right}
    return chain_scene(law, beads, boundary, end_time, tolerance, record, start)
