"""Scenes of chains between two held displacements, which many studies start from."""


def kuwabara_kono(alpha, gamma):
    """The law with β = α."""
    return {"alpha": alpha, "beta": alpha, "gamma": gamma}


def pressed_chain(law, beads, end_time, tolerance, record, left=1.0, right=0.0, start=None):
    """A chain with `left` and `right` held at its ends, at rest unless a start is given.

    `tolerance` is the relative one and the absolute one; `start` gives relative displacements
    (N − 1,) and velocities (N,).
    """
    relative, absolute = tolerance
    scene = {
        "law": law,
        "beads": beads,
        "boundary": {"kind": "pressure", "left": left, "right": right},
        "start": {"kind": "rest"},
        "end_time": end_time,
        "tolerance": {"relative": relative, "absolute": absolute},
        "record": record,
    }
    if start is not None:
        u, velocity = (list(map(float, part)) for part in start)
        scene["start"] = {"kind": "given", "relative_displacement": u, "velocity": velocity}
    return scene
