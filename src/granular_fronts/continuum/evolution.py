r"""From a scene to a dataset: the amplitude equations (50), (40) and (55) on a ring.

A scene is the mapping that the configuration holds under `scenes: periodic:`; its keys are
described in `granular_fronts.scenes.ring`.  Times of a scene are times t of the chain;
:math:`\tau = \tfrac12\gamma\varepsilon^2 c^2 t`.  How the equations are solved is described in
`log_burgers.solution` and `log_kdv_burgers.solution`.

Accuracy.  Every scene is solved again with twice the cells, or points, and a tenth of the
tolerance.  The largest difference is the error estimate.  Both runs of (50) and (40) join cells at
the same times.  They are of sixth order in space and of fourth in time, so that the estimate is
close to the error.  The second run of (55) takes steps at most half as long.  Otherwise both would
take the same steps where the tolerance does not limit them.
"""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.accuracy import error_attributes, refined_by
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers import solution as log_kdv_burgers
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import name_variables
from granular_fronts.scenes.ring import Ring

LOGARITHMIC, UNLIMITED, DISPERSIVE = "logarithmic", "unlimited", "dispersive"
"""Keys under `equations` of a scene: (50), the limit of (40); (40) itself; (55)."""

CELL_REFINEMENT, TOLERANCE_REFINEMENT = 2, 0.1
ERROR_METHOD = (
    f"largest difference to a second run with {CELL_REFINEMENT} times the cells and "
    f"{TOLERANCE_REFINEMENT:g} times the tolerance"
)
DISPERSIVE_ERROR_METHOD = (
    f"largest difference to a second run with {CELL_REFINEMENT} times the points, "
    f"{TOLERANCE_REFINEMENT:g} times the tolerance, and steps at most half as long"
)


def evolve_log_burgers(scene: Mapping[str, Any] | Ring, name: str = "given") -> xr.Dataset:
    """Solve the logarithmic Burgers equation, James (2021), eq. (50), for a periodic scene.

    Parameters
    ----------
    scene : mapping or granular_fronts.Ring
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
        If the scene is impossible, or does not name the equation; the sentence names key, value,
        limit and the way out.
    SolveError
        If the start has negative averages, or the step size collapses.

    Examples
    --------
    >>> scene = {
    ...     "law": {"alpha": 1.1, "gamma": 0.24},
    ...     "displacement": 5.0,
    ...     "half_beads": 40,
    ...     "start": {"kind": "plateau", "half_width": 5.0, "floor": 0.1},
    ...     "end_time": 5.0,
    ...     "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    ...     "equations": {"logarithmic": {"cells": 64, "tolerance": 1e-5}},
    ...     "record": {"snapshots": [5.0], "grid": {"step": 5.0}},
    ... }
    >>> wave = gf.evolve_log_burgers(scene)
    >>> round(wave["rescaled_force"].max().item(), 3)
    1.0
    """
    return _evolve(scene, name, LOGARITHMIC)


def evolve_unlimited(scene: Mapping[str, Any] | Ring, name: str = "given") -> xr.Dataset:
    """Solve James (2021), eq. (40), before the limit α → 1, for a periodic scene.

    Parameters, result (with y for Y) and errors as of `evolve_log_burgers`.
    """
    return _evolve(scene, name, UNLIMITED)


def evolve_log_kdv_burgers(scene: Mapping[str, Any] | Ring, name: str = "given") -> xr.Dataset:
    """Solve the logarithmic KdV–Burgers equation, James (2021), eq. (55), for a periodic scene.

    Parameters
    ----------
    scene : mapping or granular_fronts.Ring
        One entry of `scenes.periodic` of the configuration.
    name : str, optional
        What error messages call the scene.

    Returns
    -------
    xarray.Dataset
        `rescaled_force` Y, of either sign, on (t, xi): snapshot times of the chain, centres of the
        cells in ξ̃ = ξ − τ; coordinate `slow_time` τ on (t). With `error_estimate`, counts, `mu`,
        `mean_drift` and `smallest_value`.

    Raises
    ------
    InputError
        If the scene is impossible, or does not name the equation; the sentence names key, value,
        limit and the way out.
    SolveError
        If the step size collapses.

    Examples
    --------
    >>> scene = {
    ...     "law": {"alpha": 1.1, "gamma": 0.24},
    ...     "displacement": 5.0,
    ...     "half_beads": 40,
    ...     "start": {"kind": "plateau", "half_width": 5.0, "floor": 0.1},
    ...     "end_time": 5.0,
    ...     "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    ...     "equations": {"dispersive": {"cells": 64, "tolerance": 1e-5}},
    ...     "record": {"snapshots": [5.0], "grid": {"step": 5.0}},
    ... }
    >>> wave = gf.evolve_log_kdv_burgers(scene)
    >>> round(wave["rescaled_force"].max().item(), 3)
    1.004
    """
    return _evolve(scene, name, DISPERSIVE)


def _evolve(scene, name, equation):
    scene = Ring.read(scene, name)
    resolution = getattr(scene.equations, equation)
    if resolution is None:
        raise InputError(
            f"Scene {name}: equations.{equation} is missing, but its solution is wanted: give its "
            "cells and tolerance."
        )
    times = np.asarray(scene.record.snapshots, dtype=float)
    solutions = solve_refined(scene, equation, times)
    solution, scaling, cells = solutions.usual, scene.scaling, resolution.cells
    xi = solution.half_length * (2.0 * np.arange(cells) + 1.0 - cells) / cells
    forces = solutions.map(
        lambda solved: np.array([solved.rescaled_force(row, xi) for row in range(times.size)])
    )
    dispersive = equation == DISPERSIVE
    method = DISPERSIVE_ERROR_METHOD if dispersive else ERROR_METHOD
    parameter = {"mu": scaling.dispersion**-0.5} if dispersive else {}
    return name_variables(
        xr.Dataset(
            {"rescaled_force": (("t", "xi"), forces.usual, error_attributes(*forces, method))},
            {"t": times, "xi": xi, "slow_time": ("t", scaling.slow_rate * times)},
            attrs=parameter | solution.facts(),
        )
    )


def solve(scene, equation, times, cells, tolerance, levels=None, coarser=None, **accuracy):
    """Solve an equation of a periodic scene once, at times t ≥ 0 of the chain in any order.

    `coarser` is a run of (55) whose steps are halved; more in the `solve` of each equation.
    """
    if equation == DISPERSIVE:
        return log_kdv_burgers.solve(scene, times, cells, tolerance, levels, coarser)
    alpha = 1.0 if equation == LOGARITHMIC else scene.scaling.alpha
    return log_burgers.solve(scene, alpha, times, cells, tolerance, levels, **accuracy)


def solve_refined(scene, equation, times):
    """Solve an equation of a checked scene, and once more on a finer grid; `Refined`."""
    resolution = getattr(scene.equations, equation)
    cells, tolerance = resolution.cells, resolution.tolerance
    finer = partial(
        solve, scene, equation, times, CELL_REFINEMENT * cells, TOLERANCE_REFINEMENT * tolerance
    )

    def refine(found):
        if equation == DISPERSIVE:
            return finer(coarser=found)
        # Cells are joined at the same times in both runs.
        return finer(smooth_cells=CELL_REFINEMENT * log_burgers.SMOOTH_CELLS)

    return refined_by(refine, solve(scene, equation, times, cells, tolerance))
