r"""Points of a driven chain: constant pressure on a chain at rest, James (2021), section 3.3.

Every point is solved in its own units of length δ and time 1/c, with :math:`c = \delta^{(\alpha -
1)/2}` of eq. (21).  There the pressure is δ = 1, the front has speed 1 behind which u = 1, and the
damping is, from eq. (29) with :math:`v_0 = v_p = \delta^{(\alpha+1)/2}`,

.. math:: \hat\gamma = \gamma\, \delta^{\beta - (\alpha + 1)/2} .

One tolerance then means the same at every δ, and the recorded numbers compare across the grid.  A
law by the kinds of its potentials has no such units; it is solved in its own, and what is recorded
is divided by δ and by :math:`c = (-V'(-\delta)/\delta)^{1/2}`, eq. (13), the speed of a front into
contacts at rest.  The motion ends after `crossings` times N/c, in which the front crosses the
chain.

Errors.  One point in `REFINED_EVERY`, at least the first and the last of a chunk, is solved again
with the tolerance divided by `REFINEMENT`; the largest difference is the error estimate.
"""

import functools

import numpy as np

from granular_fronts.accuracy import largest_difference, with_refinement
from granular_fronts.campaign.chain_scenes import normalised_scene, scene_of_law
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.one_by_one import solve_one_by_one
from granular_fronts.chain.recording import fitted_speed
from granular_fronts.chain.run import integrate, prepare
from granular_fronts.chain.state import U
from granular_fronts.errors import SolveError

REFINED_EVERY = 25
REFINEMENT = 10.0
ERROR_METHOD = (
    f"largest difference to solving one point in {REFINED_EVERY} with the tolerance divided by "
    f"{REFINEMENT:g}"
)


def solve_chunk(points, settings, activity):
    """Solve driven chains one after the other.

    Parameters
    ----------
    points : dict of str to ndarray, shape (lines, fast)
        Parameters of kind ``chain``.
    settings : dict
        `tolerance` (relative, per step), `scalars`, `profile` in bead numbers, and `law`, if any.
    activity : str
        What the progress bar says.

    Returns
    -------
    Solved
    """
    profile, tolerance = settings["profile"], settings["tolerance"]
    beads = None if profile is None else KINDS["chain"].profile_points(profile)
    sizes = dict.fromkeys(settings["scalars"], ())
    if beads is not None:
        sizes["relative_displacement"] = (beads.size,)

    def measure(point, number, count):
        solve = functools.partial(_solve_point, point, settings.get("law"), beads)
        if number % REFINED_EVERY and number < count - 1:
            return {name: (value, np.nan) for name, value in solve(tolerance).items()}
        measured, refined = with_refinement(solve, tolerance, tolerance / REFINEMENT)
        return {
            name: (value, largest_difference(value, refined[name]))
            for name, value in measured.items()
        }

    return solve_one_by_one(points, sizes, measure, ERROR_METHOD, activity)


def _solve_point(point, law, beads, tolerance):
    """Measures of one chain in units of δ and 1/c, and its final u at the given beads.

    Raises
    ------
    SolveError
        If the motion cannot be followed, or if the front does not reach the far end of the range
        its speed is fitted over.
    """
    if law is None:
        scene, length, c = normalised_scene(point, tolerance), 1.0, 1.0
    else:
        scene, length, c = scene_of_law(point, law, tolerance)
    run = prepare(scene)
    integrate(run, scene["tolerance"])
    recording, count = run.recording, scene["beads"]
    speed = fitted_speed(recording.arrival[1 : count + 1])
    peak = recording.first_peak[count // 2]
    if not np.isfinite([speed, peak]).all():
        raise SolveError(
            "The front has not passed the middle of the chain at the end: raise crossings."
        )
    extremes = recording.extremes
    measured = {
        "front_speed": speed / c,
        "overshoot": peak / length - 1.0,
        "largest_overshoot": extremes.largest / length - 1.0,
        "smallest_compression": extremes.smallest / length,
        "first_gap_time": extremes.gap_time * c,
        "first_gap_bead": extremes.gap_bead,
    }
    if beads is not None:
        measured["relative_displacement"] = np.where(
            beads < count, run.row(U)[np.minimum(beads, count) - 1] / length, np.nan
        )
    return measured
