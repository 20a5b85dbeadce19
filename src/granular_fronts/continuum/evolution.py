r"""From a scene to the solution of an amplitude equation: (41) in the form (50), or (40).

A scene is the mapping that the configuration holds under `scenes: periodic:`; its keys are
described in `workflow/schemas/config.schema.yaml`.  Times of a scene are times t of the chain;
:math:`\tau = \tfrac12\gamma\varepsilon^2 c^2 t`.  Both equations are solved in the frame
:math:`\tilde\xi = \xi - \tau` on :math:`-\ell \le \tilde\xi \le \ell`, with the sixth-order finite
volumes of `finite_volumes` and the stabilised steps of `stabilised`.

Accuracy.  Every scene is solved a second time with twice the cells and a tenth of the tolerance;
the largest difference between both is the error estimate.  The error that the kinks of the start
leave shrinks like the third or fourth power of the cell width, that of the steps like the
tolerance to the power 2/3, so that the estimate is close to the error itself.
"""

import math
from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.configuration import check_scene
from granular_fronts.continuum import finite_volumes, stabilised
from granular_fronts.continuum.starts import Given, Plateau, make_start
from granular_fronts.slow_scales import SlowScales

# Below it F(y) = y ln y − y is smaller than the rounding of a sum of order 1.
SMALLEST_ARGUMENT = 1.0e-16
# Diffusivity of (40), relative to that at v = 1, below which it is frozen.
SMALLEST_DIFFUSIVITY = 1.0e-3
FIRST_STEP = 1.0e-6
CELL_REFINEMENT, TOLERANCE_REFINEMENT = 2, 0.1
SOLVER = "sixth-order finite volumes, Runge-Kutta-Chebyshev steps of order 2"
ERROR_METHOD = (
    f"largest difference to a second run with {CELL_REFINEMENT} times the cells and "
    f"{TOLERANCE_REFINEMENT:g} times the tolerance"
)


class EvolutionError(ValueError):
    """An evolution that cannot start or go on: when, and why."""


class Evolution(NamedTuple):
    """Cell averages of v = y^(1/α) at some times; α = 1 for the logarithmic equation.

    Attributes
    ----------
    start : starts.Plateau or starts.Given
    times : ndarray, shape (times,)
        Times t of the chain.
    averages : ndarray, shape (times, cells)
    half_length : float
        ℓ.
    alpha : float
        Exponent of the equation.
    counts : dict
        Steps and right-hand sides.
    mean_drift : float
        Largest change of the mean.
    largest_shortfall : float
        How far an average had to be lifted to the smallest value of the start.
    """

    start: Plateau | Given
    times: np.ndarray
    averages: np.ndarray
    half_length: float
    alpha: float
    counts: dict
    mean_drift: float
    largest_shortfall: float

    def rescaled_force(self, row, xi):
        """Rescaled force at the points ξ̃ (any shape, taken modulo 2ℓ) at the time of a row.

        The start itself is not reconstructed from its averages, since it has kinks.
        """
        points = np.asarray(xi, dtype=float)
        if self.times[row] == 0.0:
            return self.start.values(points, self.half_length)
        floor = self.start.floor ** (1.0 / self.alpha)
        values = finite_volumes.point_values(
            self.averages[row], self.half_length, points.ravel(), floor
        )
        return values.reshape(points.shape) ** self.alpha


def scaling_of(scene):
    """Scales of a checked periodic scene."""
    return SlowScales(scene["law"]["alpha"], scene["law"]["gamma"], scene["displacement"])


def evolve_log_burgers(scene, name="given"):
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
    ConfigurationError
        If the scene is impossible; the sentence names key, value, limit and the way out.
    EvolutionError
        If the start has negative averages, or the step size collapses.
    """
    scene = check_scene("periodic", scene, name)
    return _dataset(scene, *solve_twice(scene, LOGARITHMIC, scene["record"]["snapshots"]))


def evolve_unlimited(scene, name="given"):
    """Solve James (2021), eq. (40), before the limit α → 1, for a periodic scene.

    Parameters, result and errors are those of `evolve_log_burgers`.
    """
    scene = check_scene("periodic", scene, name)
    return _dataset(scene, *solve_twice(scene, UNLIMITED, scene["record"]["snapshots"]))


LOGARITHMIC, UNLIMITED = "logarithmic", "unlimited"


def solve_twice(scene, equation, times):
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
    solution, refined : Evolution
    """
    resolution = scene["equations"][equation]
    alpha = 1.0 if equation == LOGARITHMIC else scene["law"]["alpha"]
    cells, tolerance = resolution["cells"], resolution["tolerance"]
    return (
        solve(scene, alpha, times, cells, tolerance),
        solve(scene, alpha, times, CELL_REFINEMENT * cells, TOLERANCE_REFINEMENT * tolerance),
    )


def solve(scene, alpha, times, cells, tolerance):
    """Solve (40) for an exponent α, or its limit (50) for α = 1, once.

    Parameters
    ----------
    scene : mapping
        A checked periodic scene.
    alpha : float
        Exponent of the equation, 1 or more.
    times : sequence of float
        Times t of the chain, in any order, at least 0.
    cells : int
    tolerance : float
        Error per step, in v.

    Returns
    -------
    Evolution
    """
    scaling = scaling_of(scene)
    half_length = scaling.half_length(scene["half_beads"])
    start = make_start(scene["start"])
    averages = start.averages(cells, half_length, alpha)
    equation = _equation(alpha, averages, start.floor, 2.0 * half_length / cells)
    state, clock = stabilised.start(averages, FIRST_STEP)
    times = np.asarray(times, dtype=float)
    kept = np.empty((times.size, cells))
    for row in np.argsort(times, kind="stable"):
        status = stabilised.advance(
            equation, state, clock, tolerance, scaling.slow_rate * times[row]
        )
        if status == stabilised.COLLAPSED:
            raise EvolutionError(
                f"At slow time {clock.t[0]:.6g} the step size collapsed to {clock.h[0]:.3g}: the "
                f"tolerance {tolerance:g} cannot be met in double precision; raise it."
            )
        kept[row] = state.averages
    mean_drift = np.abs(kept.mean(axis=1) - averages.mean()).max()
    return Evolution(
        start,
        times,
        kept,
        half_length,
        alpha,
        stabilised.work_done(clock),
        float(mean_drift),
        float(clock.shortfall[0]),
    )


def _equation(alpha, averages, lowest, width):
    """The equation of the kernels; y ≥ `lowest` bounds averages from below, wherever cells lie."""
    smallest = float(averages.min())
    if smallest < 0.0:
        raise EvolutionError(
            f"The smallest cell average of the start is {smallest:.3g}, but a rescaled force is 0 "
            "or more: give more points of the start, or a smoother one."
        )
    degenerate = 0.0 if alpha == 1.0 else SMALLEST_DIFFUSIVITY ** (1.0 / (alpha - 1.0))
    bound = lowest ** (1.0 / alpha)
    floor = max(bound, SMALLEST_ARGUMENT, degenerate)
    return finite_volumes.Equation(alpha, floor, bound, width)


def _dataset(scene, solution, refined):
    times = np.asarray(scene["record"]["snapshots"], dtype=float)
    cells, half_length = solution.averages.shape[1], solution.half_length
    xi = half_length * (2.0 * np.arange(cells) + 1.0 - cells) / cells
    rows = range(times.size)
    force = np.array([solution.rescaled_force(row, xi) for row in rows])
    finer = np.array([refined.rescaled_force(row, xi) for row in rows])
    estimate = max(float(np.abs(force - finer).max()), math.ulp(1.0))
    attributes = {"error_estimate": estimate, "error_method": ERROR_METHOD}
    return xr.Dataset(
        {"rescaled_force": (("t", "xi"), force, attributes)},
        {"t": times, "xi": xi, "slow_time": ("t", scaling_of(scene).slow_rate * times)},
        attrs=describe(solution),
    )


def describe(solution):
    """Attributes that say how an equation was solved."""
    return {
        "solver": SOLVER,
        **solution.counts,
        "mean_drift": solution.mean_drift,
        "largest_shortfall": solution.largest_shortfall,
    }
