r"""Points of a driven chain: constant pressure on a chain at rest, James (2021), section 3.3.

Every point is solved in its own units of length δ and time 1/c, with :math:`c = \delta^{(\alpha -
1)/2}` of eq. (21).  There the pressure is δ = 1, and the front has speed 1 and u = 1 behind it.
The damping follows from eq. (29) with :math:`v_0 = v_p = \delta^{(\alpha+1)/2}`,

.. math:: \hat\gamma = \gamma\, \delta^{\beta - (\alpha + 1)/2} .

One tolerance then means the same at every δ, and the recorded numbers compare across the grid.  A
law by the kinds of its potentials has no such units.  It is solved in its own units.  Lengths are
divided by δ, and speeds by :math:`c = (-V'(-\delta)/\delta)^{1/2}`, the speed (13) of a front into
contacts at rest.  The front crosses the chain in the time N/c, and the motion ends after
`crossings` such times.

Errors.  Of a chunk of more than `REFINED_EVERY` points, one of each so many in a row is solved
again with steps halved, drawn at random since axes repeat themselves, and always the first and the
last; of a smaller chunk, all are.  See `chain.event_errors`.
"""

import functools
import zlib
from typing import NamedTuple

import numpy as np

from granular_fronts.accuracy import largest_difference, refined_by, rounding_floor
from granular_fronts.campaign.chain_scenes import scene_of
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.points import single_points, solve_groups
from granular_fronts.chain.event_errors import event_errors
from granular_fronts.chain.recorder import END, TIME, VALUE
from granular_fronts.chain.recording import extremes_of_all, fitted_speed
from granular_fronts.chain.run import Run, integrate, integrate_in_halves, prepare
from granular_fronts.chain.state import U
from granular_fronts.errors import SolveError
from granular_fronts.scenes.chain import Chain

REFINED_EVERY = 25
ERROR_METHOD = (
    "largest difference to solving points with each step in two halves, all of a small chunk and "
    f"one in {REFINED_EVERY} of a large one"
)


def solve_chunk(points, settings, activity):
    """Solve driven chains one after the other, to a tolerance per step; a profile is in beads."""
    beads = KINDS["chain"].profile_points(settings["profile"])
    sizes = dict.fromkeys(settings["scalars"], ())
    if beads is not None:
        sizes["relative_displacement"] = (beads.size,)
    shape = points["beads"].shape
    refined = _refined(points)

    def groups():
        for number, (index, point) in enumerate(single_points(points)):
            yield index, functools.partial(_measure, point, settings, beads, refined[number])

    return solve_groups(shape, sizes, groups(), ERROR_METHOD, activity)


def _refined(points):
    """Return which of the points of a chunk are solved again, in their order."""
    count = points["beads"].size
    refined = np.full(count, count <= REFINED_EVERY)
    random = np.random.default_rng([zlib.crc32(value.tobytes()) for value in points.values()])
    first = np.arange(0, count, REFINED_EVERY)
    drawn = first + random.integers(np.minimum(REFINED_EVERY, count - first))
    refined[[0, *drawn, -1]] = True
    return refined


class _Motion(NamedTuple):
    """A run that has ended, its scene, ends of steps, units of length and speed."""

    run: Run
    scene: Chain
    ends: np.ndarray
    length: float
    speed: float


def _measure(point, settings, beads, refined):
    """Return the values of a point, and their errors where it is solved again."""
    motion = _solve_point(point, settings.get("law"), settings["tolerance"])
    if refined:
        return _with_errors(refined_by(_solve_in_halves, motion), beads)
    return {name: (value, np.nan) for name, value in _measures(motion, beads).items()}


def _solve_point(point, law, tolerance):
    """Follow one chain, a `_Motion`."""
    scene, length, c = scene_of(point, law, tolerance)
    run = prepare(scene)
    return _Motion(run, run.scene, integrate(run, run.scene.tolerance), length, c)


def _solve_in_halves(motion):
    """Follow the chain of a `_Motion` again, with two steps for each of its own."""
    run = prepare(motion.scene)
    ends = integrate_in_halves(run, motion.scene.tolerance, motion.ends)
    return motion._replace(run=run, ends=ends)


# By measure: the variable of the chain, and the powers of its units of length and speed.
UNITS = {
    "front_speed": ("front_speed", 0, -1),
    "first_peak": ("first_peak", -1, 0),
    "largest_peak": ("largest_peak", -1, 0),
    "largest_overshoot": ("largest_relative_displacement", -1, 0),
    "smallest_compression": ("smallest_relative_displacement", -1, 0),
    "first_gap_time": ("first_gap_time", 0, 1),
    "first_gap_bead": ("first_gap_bead", 0, 0),
}


def _in_units(variables, motion):
    """Return the variables of the chain as measures in units of δ and 1/c."""
    return {
        name: variables[variable] * motion.length**length * motion.speed**speed
        for name, (variable, length, speed) in UNITS.items()
    }


def _measures(motion, beads):
    """Return measures of one chain in units of δ and 1/c, and its final u at the given beads."""
    recording, count = motion.run.recording, motion.scene.beads.count
    speed = fitted_speed(recording.arrival[TIME, 1 : count + 1])
    peak = recording.first_peak[VALUE, count // 2]
    if not np.isfinite([speed, peak]).all():
        raise SolveError(
            "The front has not passed the middle of the chain at the end: raise crossings."
        )
    variables = extremes_of_all(recording, int(motion.run.chain.contacts))
    # The largest u of a contact that only rises is that of the last step.
    largest = recording.largest[[VALUE, END], count // 2].max()
    peaks = {"first_peak": peak, "largest_peak": largest}
    measured = _in_units(variables | {"front_speed": speed} | peaks, motion)
    for name in (*peaks, "largest_overshoot"):
        measured[name] -= 1.0
    measured["overshoot"] = measured["largest_peak"]
    if beads is not None:
        measured["relative_displacement"] = np.where(
            beads < count,
            motion.run.row(U)[np.minimum(beads, count) - 1] / motion.length,
            np.nan,
        )
    return measured


def _with_errors(motions, beads):
    """Return measures of a chain with their errors, by name, from the chain and its refinement."""
    found, refined = motions.map(lambda motion: _measures(motion, beads))
    recordings = motions.map(lambda motion: motion.run.recording)
    motion = motions.usual
    events = event_errors(motion.scene, *recordings, int(motion.run.chain.contacts))
    errors = _in_units(events | {"largest_peak": events["first_peak"]}, motion)
    # A later peak may be less exact than the first one.
    change = abs(found["largest_peak"] - refined["largest_peak"])
    errors["overshoot"] = errors["largest_peak"] = np.maximum(errors["largest_peak"], change)
    return {
        name: (
            value,
            np.maximum(np.nan_to_num(errors[name], nan=np.inf), rounding_floor(value))
            if name in errors
            else largest_difference(value, refined[name]),
        )
        for name, value in found.items()
    }
