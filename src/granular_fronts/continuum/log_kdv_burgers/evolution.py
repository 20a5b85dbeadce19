r"""The logarithmic KdV–Burgers equation in time: from a scene to a dataset.

Section 5 of James (2021) takes the slow variables :math:`s = 2\sqrt3\,\varepsilon_5(n - ct)` and
:math:`\tau_5 = \sqrt3\,\varepsilon_5^3 ct` with :math:`\varepsilon_5 = (1 - 1/\alpha)^{1/2}`.
Those of section 4 are shorter by one factor, :math:`s = \mu\xi` and :math:`\tau_5 = \mu\tau` with
the μ of (54), so that (55) is the logarithmic Burgers equation (41) with a third derivative,

.. math::

    \partial_\tau y + \partial_\xi(y\ln y) + \mu^{-2}\,\partial_\xi^3 y = \partial_\xi^2 y, \qquad
    \mu^{-2} = \frac{1 - 1/\alpha}{12\,(\gamma c)^2} .

It is solved on the same rings and from the same starts as (41).  A scene is that of the logarithmic
Burgers equation; its key `equations: dispersive:` gives cells and tolerance.  Steps are longest in
ξ, where fronts rest.  Results are in the frame :math:`\tilde\xi = \xi - \tau` of (50), where Y
stands for y, so that (51) leads to the chain.

Change of sign.  The paper defines (55) for :math:`y \ge 0`.  Dispersion does not keep y above 0: of
a start that rises from (almost) nothing it makes waves below 0 on the rear side.  There the flux is
continued as the odd function :math:`y\ln|y|`, as the paper does in (57).  A chain has gaps where
y < 0, and this continuation is no model of them: there (51) reads u = 0.  `smallest_value` says how
deep y went.

Well-posedness.  About a constant y, small waves of wave number κ move with the speed
:math:`\ln|y| + 1 - \mu^{-2}\kappa^2` and decay with the rate :math:`\kappa^2`, whatever y is: no
height is unstable, but the speed has no bound where y tends to 0.  Nor is there a linear theory
about 0, since with y(ξ, τ) also

.. math:: \lambda\, y(\xi - \tau\ln\lambda,\; \tau), \qquad \lambda > 0,

is a solution: waves of any height are alike in a frame of their own.  The flux is continuous but
not Lipschitz at 0, and where y vanishes we know no proof of uniqueness: without damping Carles and
Pelinovsky, *Nonlinearity* 27 (2014) 3185-3202, construct weak solutions and leave it open.  Here
the logarithm is cut off below the tolerance, and in the refined run below a tenth of that, so that
the error estimate contains what this changes.

Balances.  The mean of y is conserved.  Multiplied by y, flux and dispersion integrate to zero over
the ring, and

.. math::

    \frac{d}{d\tau}\int \tfrac12 y^2\,d\xi = -\int (\partial_\xi y)^2\,d\xi .

Accuracy.  Every scene is solved a second time with twice the points, a tenth of the tolerance, and
steps at most half as long, from the first one on: where neither run is limited by its tolerance,
both would take the same steps.  The largest difference between both is the error estimate.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.accuracy import error_attributes, refined_by
from granular_fronts.continuum.log_kdv_burgers.solution import SOLVER, solve
from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.output.datasets import name_variables
from granular_fronts.scenes.validation import check_scene

DISPERSIVE = "dispersive"
POINT_REFINEMENT, TOLERANCE_REFINEMENT = 2, 0.1
ERROR_METHOD = (
    f"largest difference to a second run with {POINT_REFINEMENT} times the points, "
    f"{TOLERANCE_REFINEMENT:g} times the tolerance, and steps at most half as long"
)


def evolve_log_kdv_burgers(scene: Mapping[str, Any], name: str = "given") -> xr.Dataset:
    """Solve the logarithmic KdV–Burgers equation, James (2021), eq. (55), for a periodic scene.

    Parameters
    ----------
    scene : mapping
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
        If the scene is impossible; the sentence names key, value, limit and the way out.
    SolveError
        If the step size collapses.
    """
    scene = check_scene("periodic", scene, name)
    times = np.asarray(scene["record"]["snapshots"], dtype=float)
    solutions = solve_refined(scene, times)
    solution, cells = solutions.usual, scene["equations"][DISPERSIVE]["cells"]
    xi = solution.half_length * (2.0 * np.arange(cells) + 1.0 - cells) / cells
    rows = range(times.size)
    forces = solutions.map(
        lambda solved: np.array([solved.rescaled_force(row, xi) for row in rows])
    )
    attributes = error_attributes(forces.usual, forces.finer, ERROR_METHOD)
    scaling = scaling_of(scene)
    return name_variables(
        xr.Dataset(
            {"rescaled_force": (("t", "xi"), forces.usual, attributes)},
            {"t": times, "xi": xi, "slow_time": ("t", scaling.slow_rate * times)},
            attrs={"mu": scaling.dispersion**-0.5, **describe(solution)},
        )
    )


def solve_refined(scene, times):
    """Solve the equation of a checked scene, and once more with more points and a finer tolerance.

    Parameters
    ----------
    scene : mapping
    times : sequence of float
        Times t of the chain, at least 0.

    Returns
    -------
    accuracy.Refined of solution.Evolution
        Its `rescaled_force(row, xi)` gives Y at the points ξ̃ at the time of a row.
    """
    resolution = scene["equations"][DISPERSIVE]
    finer = {
        "cells": POINT_REFINEMENT * resolution["cells"],
        "tolerance": TOLERANCE_REFINEMENT * resolution["tolerance"],
    }
    return refined_by(
        lambda found: solve(scene, times, **finer, coarser=found),
        solve(scene, times, **resolution),
    )


def describe(solution):
    """Attributes that say how the equation was solved."""
    return {
        "solver": SOLVER,
        **solution.counts,
        "mean_drift": solution.mean_drift,
        "smallest_value": solution.smallest_value,
    }
