"""The scene of an impact, which several studies share."""


def struck_chain(law, beads, end_time, tolerance, record):
    """Return the scene of a chain at rest whose first bead hits it with the velocity 1.

    No force acts on the ends.  All arguments are as in a scene of a chain; `law` is (α, β, γ).
    """
    return {
        "law": dict(zip(("alpha", "beta", "gamma"), law, strict=True)),
        "beads": beads,
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": {"kind": "striker", "beads": 1, "velocity": 1.0},
        "end_time": end_time,
        "tolerance": tolerance,
        "record": record,
    }
