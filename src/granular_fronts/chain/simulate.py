r"""From a scene to a dataset: front initiation and every other driven or periodic chain.

A scene is the mapping that the configuration holds under `scenes: chain:`; its keys are described
in `workflow/schemas/config.schema.yaml`.  The motion is integrated in strain form (`strain`) with
the adaptive pair of `integrator`, or with the implicit steps of `stiff` where damping is strong.

Accuracy.  Every scene is integrated a second time, with the tolerance divided by `REFINEMENT` until
more steps are taken; the largest difference between the two runs is the error estimate of each
recorded variable.  It comes from an independent refinement and not from the step controller.  It is
an estimate and no bound: where the error shrinks with the tolerance it is about nine tenths of the
error or more, and where both runs consist of rounding it may be half of it.
"""

import sys
from collections.abc import Mapping
from typing import Any, NamedTuple

import xarray as xr

from granular_fronts.accuracy import error_attributes
from granular_fronts.chain.balances import Balances
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare, work_done
from granular_fronts.errors import SolveError
from granular_fronts.output.datasets import name_variables
from granular_fronts.output.progress import time_bar
from granular_fronts.scenes.constraints import RELATIVE_TOLERANCE_FLOOR
from granular_fronts.scenes.limits import show_time
from granular_fronts.scenes.sizes import size_of_chain
from granular_fronts.scenes.validation import check_scene

REFINEMENT = 10.0
LONG = 60.0
"""Seconds from which on the least time of a scene is said before."""
SOLVER = "DOP853 in strain form, order 8(5,3), steps located at contact events"
STIFF_SOLVER = f"Radau IIA of order 9 in strain form where damping is stiff, else {SOLVER}"
ERROR_METHOD = (
    f"largest difference to a run of more steps, with the tolerance divided by {REFINEMENT:g}"
)


class Solution(NamedTuple):
    """One integration of a scene.

    Attributes
    ----------
    dataset : xarray.Dataset
        Everything recorded.
    counts : dict
        Work: steps accepted, rejected, cut at contacts; right-hand sides.
    drifts : dict
        Largest relative drift of the balance laws.
    """

    dataset: xr.Dataset
    counts: dict
    drifts: dict


def simulate_chain(scene: Mapping[str, Any], name: str = "given") -> xr.Dataset:
    """Integrate one chain scene and estimate the errors of what it records.

    Parameters
    ----------
    scene : mapping
        Law, beads, boundary, start, end_time, tolerance, record; dimensionless, James (2021),
        eq. (28).
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
    """
    scene = check_scene("chain", scene, name)
    seconds = sum(part.seconds for part in size_of_chain(scene))
    if seconds > LONG:
        print(f"Scene {name} takes at least {show_time(seconds)} on one core.", file=sys.stderr)
    solution = solve(scene, scene["tolerance"], f"scene {name}, solving")
    refined = refine(scene, solution, f"scene {name}, estimating the error")
    return _with_error_estimates(solution, refined.dataset, scene["tolerance"])


def simulate_once(scene, name="given"):
    """Integrate one chain scene at its tolerance, for measures with error estimates of their own.

    Parameters, result and errors are those of `simulate_chain`, but that no variable carries an
    error estimate.
    """
    scene = check_scene("chain", scene, name)
    return solve(scene, scene["tolerance"], f"scene {name}, solving").dataset


def refine(scene, solution, activity):
    """Integrate a scene again, more accurately.

    The tolerance is divided until more steps are taken than before: in a short motion the first
    steps grow as fast as they may at either tolerance, and two equal runs say nothing of the error.

    Parameters
    ----------
    scene : mapping
        Checked.
    solution : Solution
    activity : str
        As of `solve`.

    Returns
    -------
    Solution
    """
    finer = scene["tolerance"]
    while True:
        finer = {
            "relative": max(finer["relative"] / REFINEMENT, RELATIVE_TOLERANCE_FLOOR),
            "absolute": finer["absolute"] / REFINEMENT,
        }
        refined = solve(scene, finer, activity)
        takes_more = refined.counts["steps_accepted"] > solution.counts["steps_accepted"]
        if takes_more or finer["relative"] <= RELATIVE_TOLERANCE_FLOOR:
            return refined


def solve(scene, tolerance, activity="solving"):
    """Integrate a checked scene once, at the given tolerance.

    Parameters
    ----------
    scene : mapping
    tolerance : mapping
        `relative` and `absolute`, per step, in the maximum norm over beads.
    activity : str
        What the progress line and a failure are headed with.

    Returns
    -------
    Solution
    """
    try:
        run = prepare(scene)
        balances = Balances(run)
        with time_bar(activity, scene["end_time"]) as show_time:

            def after_block(run):
                show_time(run.clock.t)
                balances.check(run)

            integrate(run, tolerance, after_block)
    except SolveError as error:
        raise SolveError(f"{activity}: {error}") from error
    return Solution(collect(scene, run), work_done(run.clock), balances.drifts())


def _with_error_estimates(solution, refined, tolerance):
    """The dataset of `solution`, each variable with its largest difference to `refined`."""
    dataset = solution.dataset
    for name, variable in dataset.data_vars.items():
        variable.attrs |= error_attributes(variable, refined[name], ERROR_METHOD)
    dataset.attrs |= {
        "solver": STIFF_SOLVER if solution.counts["steps_implicit"] else SOLVER,
        "relative_tolerance": float(tolerance["relative"]),
        "absolute_tolerance": float(tolerance["absolute"]),
        **solution.counts,
        **solution.drifts,
    }
    return name_variables(dataset)
