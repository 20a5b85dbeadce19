r"""From a scene to a dataset: front initiation and every other driven or periodic chain.

A scene is the mapping that the configuration holds under `scenes: chain:`, or the `Chain` that
`granular_fronts.scenes.chain` makes of it, where its keys are described.  The motion is integrated
in strain form (`strain`) with the adaptive pair of `integrator`.

Accuracy.  Every scene is integrated again, with two steps for each of the first run.  The runs thus
differ from the first step on.  An error of truncation is smaller by 2⁸ in the second run.  The
error estimate of an array is the largest difference between them.  Single numbers, which may agree
by chance, take theirs from all events near them (`event_errors`).  The estimates come from an
independent refinement and not from the step controller; they are no bounds.
"""

import functools
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from tqdm.auto import tqdm

from granular_fronts.accuracy import largest_difference, rounding_floor
from granular_fronts.chain.balances import Balances
from granular_fronts.chain.event_errors import event_errors
from granular_fronts.chain.recorder import Recording
from granular_fronts.chain.recording import Recorded, collect
from granular_fronts.chain.run import integrate, integrate_in_halves, prepare, work_done
from granular_fronts.errors import SolveError
from granular_fronts.output.datasets import name_variables
from granular_fronts.scenes.chain import Chain, Periodic

SOLVER = "DOP853 in strain form, order 8(5,3), steps located at contact events"
ERROR_METHOD = "largest difference to a run that takes each step in two halves"
EVENT_METHOD = "differences of the events nearby to a run that takes each step in two halves"
# A sum over beads is no more exact than its terms.
TERMS = {
    "mean_relative_displacement": "relative_displacement_grid",
    "total_velocity": "velocity_grid",
}


class Solution(NamedTuple):
    """One integration of a scene."""

    recorded: Recorded
    counts: dict  # Steps accepted, rejected, cut at contacts; right-hand sides.
    drifts: dict  # Largest relative drift of the balance laws.
    recording: Recording  # As the integrator left it.
    ends: np.ndarray  # Times at which the steps ended.

    @property
    def dataset(self):
        """What the run has recorded, as a dataset."""
        return self.recorded.dataset


def simulate_chain(scene: Mapping[str, Any] | Chain, name: str = "given") -> xr.Dataset:
    """Integrate one chain scene and estimate the errors of what it records.

    Parameters
    ----------
    scene : mapping or granular_fronts.Chain
        Law, beads, boundary, start, end_time, tolerance, record; contacts and gravity if wanted.
        Dimensionless, James (2021), eq. (28), with masses if `beads` names them.
    name : str, optional
        What error messages and progress bars call the scene.

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on (t, bead) at the snapshot times, and what else the
        scene records (see `granular_fronts.chain.recording`).  Every variable carries
        `error_estimate` and `error_method`; the dataset carries counts and drifts.

    Raises
    ------
    InputError
        If the scene is impossible; the sentence names key, value, limit and the way out.
    SolveError
        If the step size collapses, the state is no longer finite, or a contact opens for α < 1.

    Examples
    --------
    >>> motion = gf.simulate_chain(
    ...     {
    ...         "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.06},
    ...         "beads": 20,
    ...         "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
    ...         "start": {"kind": "rest"},
    ...         "end_time": 20.0,
    ...         "tolerance": {"relative": 1e-10, "absolute": 1e-12},
    ...         "record": {"snapshots": [20.0]},
    ...     }
    ... )
    >>> round(motion["relative_displacement"].sel(t=20.0, bead=1).item(), 6)
    0.099168
    """
    scene = Chain.read(scene, name)
    solution = solve(scene, activity=f"scene {name}, solving")
    refined = refine(scene, solution, f"scene {name}, estimating the error")
    return _with_error_estimates(scene, solution, refined)


def simulate_once(scene, name="given"):
    """Integrate like `simulate_chain`, but once, for measures with error estimates of their own."""
    return solve(Chain.read(scene, name), activity=f"scene {name}, solving").dataset


def solve(scene, tolerance=None, activity="solving"):
    """Integrate a scene once, at its tolerance per step or at another.

    The activity heads the progress line and the sentence of a failure.
    """
    scene = Chain.read(scene)
    return _follow(scene, activity, integrate, tolerance or scene.tolerance)


def refine(scene, solution, activity="estimating the error"):
    """Integrate a scene again, with two steps for each of a `Solution`; the rest as in `solve`."""
    scene = Chain.read(scene)
    in_halves = functools.partial(integrate_in_halves, ends=solution.ends)
    return _follow(scene, activity, in_halves, scene.tolerance)


def _follow(scene, activity, integrate, tolerance):
    """Integrate a scene to its end by a function of `run` and the tolerance."""
    try:
        run = prepare(scene)
        balances = Balances(run)
        # The times themselves have too many digits to be shown.
        style = "{desc}: {percentage:3.0f}%|{bar}| [{elapsed}<{remaining}]"
        total = scene.end_time
        with tqdm(total=total, desc=activity, bar_format=style, delay=2.0, disable=None) as bar:

            def after_block(run):
                # Summed differences may end below the total, which a notebook shows as a failure.
                bar.n = run.clock.t
                bar.update(0)
                balances.check(run)

            ends = integrate(run, tolerance, after_block=after_block)
    except SolveError as error:
        raise SolveError(f"{activity}: {error}") from error
    return Solution(collect(run), work_done(run), balances.drifts(), run.recording, ends)


def _with_error_estimates(scene, solution, refined):
    """Return dataset of a solution of a scene, each variable with its error by a refined one."""
    own, other = solution.recorded, refined.recorded
    recordings = solution.recording, refined.recording
    events = event_errors(scene, *recordings, own.attributes["contacts"])
    for name, (dims, values) in own.variables.items():
        error, method = largest_difference(values, other.values(name)), ERROR_METHOD
        if name.startswith("velocity"):
            error = max(error, own.rounding_of_velocity)
        if name in TERMS:
            error = max(error, _error_of_sum(scene, own, other, name))
        if name in events:
            if dims:
                # An event in only one of the runs is not certain to have happened.
                values[np.isnan(other.values(name))] = np.nan
            # Nothing is known of a number without an error.
            error = np.inf if np.isnan(events[name]) else events[name]
            error, method = float(np.maximum(error, rounding_floor(values))), EVENT_METHOD
        own.variables[name] = dims, values, {"error_estimate": error, "error_method": method}
    own.attributes.update(
        solver=SOLVER,
        relative_tolerance=scene.tolerance.relative,
        absolute_tolerance=scene.tolerance.absolute,
        **solution.counts,
        **solution.drifts,
    )
    return name_variables(own.dataset)


def _error_of_sum(scene, own, other, name):
    """Return the least error of a sum over beads, on which two runs may agree by chance."""
    error = 4.0 * rounding_floor(own.values(TERMS[name]))
    if name == "mean_relative_displacement":
        # The rounding of the rates adds up as time goes on.
        error += scene.end_time * rounding_floor(own.values("velocity_grid"))
        if not isinstance(scene.boundary, Periodic):
            # The mean belongs to x_1 - x_N; the neighbours of these beads give further samples.
            difference = other.values(TERMS[name]) - own.values(TERMS[name])
            difference = difference[:, : own.attributes["contacts"]]
            total = difference.sum(axis=1)
            ends = (total, total - difference[:, 0], total - difference[:, -1])
            error += np.abs(ends).max() / scene.beads.count
    return error
