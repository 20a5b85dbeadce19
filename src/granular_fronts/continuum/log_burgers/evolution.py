r"""From a scene to a dataset: the amplitude equation (41) in the form (50), or (40).

A scene is the mapping that the configuration holds under `scenes: periodic:`; its keys are
described in `workflow/schemas/config.schema.yaml`.  Times of a scene are times t of the chain;
:math:`\tau = \tfrac12\gamma\varepsilon^2 c^2 t`.  How the equations are solved is described in
`solution`.

Accuracy.  Every scene is solved a second time with twice the cells, at all times since both runs
join cells at the same times, and a tenth of the tolerance; the largest difference between both is
the error estimate.  Space is of sixth order and steps of fourth, so that the estimate is close to
the error itself.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.accuracy import error_attributes, with_refinement
from granular_fronts.continuum.log_burgers.solution import SMOOTH_CELLS, SOLVER, solve, start_levels
from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.output.datasets import name_variables
from granular_fronts.scenes.validation import check_scene

LOGARITHMIC, UNLIMITED = "logarithmic", "unlimited"
CELL_REFINEMENT, TOLERANCE_REFINEMENT = 2, 0.1
ERROR_METHOD = (
    f"largest difference to a second run with {CELL_REFINEMENT} times the cells and "
    f"{TOLERANCE_REFINEMENT:g} times the tolerance"
)


def evolve_log_burgers(scene: Mapping[str, Any], name: str = "given") -> xr.Dataset:
    """Solve the logarithmic Burgers equation, James (2021), eq. (50), for a periodic scene.

    Parameters
    ----------
    scene : mapping
        One entry of `scenes.periodic` of the configuration.
    name : str, optional
        What error messages call the scene.

    Returns
    -------
    xarray.Dataset
        `rescaled_force` Y on (t, xi): snapshot times of the chain, centres of the cells in
        ξ̃ = ξ − τ; coordinate `slow_time` τ on (t). With `error_estimate`, counts and drifts.

    Raises
    ------
    InputError
        If the scene is impossible; the sentence names key, value, limit and the way out.
    SolveError
        If the start has negative averages, or the step size collapses.
    """
    return _evolve(scene, name, LOGARITHMIC)


def evolve_unlimited(scene: Mapping[str, Any], name: str = "given") -> xr.Dataset:
    """Solve James (2021), eq. (40), before the limit α → 1, for a periodic scene.

    Parameters, result (with y for Y) and errors as of `evolve_log_burgers`.
    """
    return _evolve(scene, name, UNLIMITED)


def _evolve(scene, name, equation):
    scene = check_scene("periodic", scene, name)
    times = np.asarray(scene["record"]["snapshots"], dtype=float)
    solutions = solve_refined(scene, equation, times)
    solution = solutions.usual
    cells, half_length = scene["equations"][equation]["cells"], solution.half_length
    xi = half_length * (2.0 * np.arange(cells) + 1.0 - cells) / cells
    rows = range(times.size)
    forces = solutions.map(
        lambda solved: np.array([solved.rescaled_force(row, xi) for row in rows])
    )
    attributes = error_attributes(*forces, ERROR_METHOD)
    return name_variables(
        xr.Dataset(
            {"rescaled_force": (("t", "xi"), forces.usual, attributes)},
            {"t": times, "xi": xi, "slow_time": ("t", scaling_of(scene).slow_rate * times)},
            attrs=describe(solution),
        )
    )


def solve_refined(scene, equation, times):
    """Solve one of the equations of a checked scene, and once more on a finer grid.

    Parameters
    ----------
    scene : mapping
    equation : str
        Key under `equations` of the scene: LOGARITHMIC or UNLIMITED.
    times : sequence of float
        Times t of the chain, at least 0.

    Returns
    -------
    accuracy.Refined of Evolution
    """
    resolution = scene["equations"][equation]
    alpha = 1.0 if equation == LOGARITHMIC else scene["law"]["alpha"]
    cells, tolerance = resolution["cells"], resolution["tolerance"]
    usual = {"cells": cells, "tolerance": tolerance, "smooth_cells": SMOOTH_CELLS}
    finer = {
        "cells": CELL_REFINEMENT * cells,
        "tolerance": TOLERANCE_REFINEMENT * tolerance,
        "smooth_cells": CELL_REFINEMENT * SMOOTH_CELLS,
    }
    return with_refinement(
        lambda resolution: solve(scene, alpha, times, **resolution), usual, finer
    )


def describe(solution):
    """Attributes that say how an equation was solved."""
    finer = 2 ** start_levels(solution.alpha)
    return {
        "solver": f"{SOLVER}, {finer} times finer cells at the start",
        **solution.counts,
        "mean_drift": solution.mean_drift,
        "largest_shortfall": solution.largest_shortfall,
    }
