r"""A front that a chain has formed by itself, seen in the frame of the exact front.

A semi-infinite chain at rest is pressed on by δ = 1.  After many beads the front no longer feels
the sudden start; what is left of the transient decays only algebraically.  In units of δ = c = 1
the strength of the viscous force is the γc of (30).
"""

from granular_fronts.chain.simulate import simulate_chain, simulate_once

BEADS_AHEAD = 60
"""Beads between the one looked at and the free end, which the front has not reached by then."""

TOLERANCE = {"relative": 1e-12, "absolute": 1e-14}


def drive_front(alpha, gamma, bead, name="driven"):
    """Press on a chain at rest and look at the front when it has come to a bead.

    Parameters
    ----------
    alpha, gamma : float
        Exponent of both forces, and γc.
    bead : int
        Number n₀ of the bead.
    name : str, optional
        What error messages and progress bars call the scene.

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on `xi` = n − n₀, with u = 1/2 at ξ = 0.

    Raises
    ------
    SolveError
        If the chain cannot be integrated.
    """
    scene = {
        "law": {"alpha": alpha, "beta": alpha, "gamma": gamma},
        "beads": bead + BEADS_AHEAD,
        "boundary": {"kind": "pressure", "left": 1.0, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": 1.1 * bead,
        "tolerance": TOLERANCE,
        "record": {"snapshots": [], "arrival_level": 0.5},
    }
    moment = float(simulate_once(scene, name)["arrival_time"].sel(bead=bead))
    scene |= {"end_time": moment, "record": {"snapshots": [moment]}}
    snapshot = simulate_chain(scene, name).isel(t=0, drop=True)
    return snapshot.assign_coords(bead=snapshot["bead"] - bead).rename(bead="xi")
