"""A ring of James (2021), section 4.3, to its end by the logarithmic Burgers equation (50).

Four schemes; a number of points or cells, or a longest step, says how fine:

upwind          the paper's explicit scheme;
finite_volumes  ours, with finer cells at the start;
uniform_cells   ours without them, which shows what the kinks of the start cost;
fourier         the method of the equation with a third derivative (55), here without it, which
                shares no scheme with ours.

The start (49) has kinks.  The reference, finite volumes on fine cells, is not stored, since it must
be evaluated at the points of each scheme.  Its error is its distance to the Fourier method, also
refined.
"""

from functools import partial

import numpy as np

from granular_fronts.continuum.log_burgers.solution import SMALLEST_ARGUMENT, START_LEVELS, solve
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import Equation, values_at
from granular_fronts.continuum.log_kdv_burgers.solution import follow
from granular_fronts.reference_methods import upwind
from granular_fronts.scenes.ring import Ring
from peers.runs import Run, Stopwatch
from problems.problem import Answer, Problem

# Of the reference.
CELLS, TOLERANCE, POINTS, LONGEST_STEP = 4096, 1.0e-10, 1024, 0.0025
# Error per step over the sixth power of the cell width: neither space nor time is wasted.
TOLERANCE_PER_WIDTH = 0.05
EVALUATED_POINTS = 8192
# Of the Fourier method: its error per step is this power of its longest step. Its start is on 2⁴
# times as many points.
FOURIER_ORDER, FOURIER_LEVELS = 4, 4


def make_ring(_settings, scene):
    """Return a periodic scene with its answer."""
    scene = Ring.read(scene)
    accurate = solve(scene, 1.0, [scene.end_time], CELLS, TOLERANCE)
    independent = _run_fourier(scene, accurate, LONGEST_STEP)
    error = float(np.abs(independent.fields["rescaled_force"]).max())
    return Problem(
        # The fields of a run are its distances to the reference.
        {"rescaled_force": Answer(np.zeros(1), np.zeros(1), error)},
        {
            "upwind": partial(_run_upwind, scene, accurate),
            "finite_volumes": partial(_run_cells, scene, accurate, START_LEVELS),
            "uniform_cells": partial(_run_cells, scene, accurate, 0),
            "fourier": partial(_run_fourier, scene, accurate),
        },
    )


def _run_upwind(scene, accurate, points):
    """The paper's scheme."""
    points, half_length = round(points), accurate.half_length
    with Stopwatch() as watch:
        values = make_start(scene.start).values(upwind.grid(half_length, points), half_length)
        found = upwind.evolve_upwind(values, half_length, _end_of(scene))
    return Run(_distances(accurate, found.xi, found.values), **watch.times)


def _run_cells(scene, accurate, levels, cells):
    """The finite volumes."""
    cells = round(cells)
    tolerance = TOLERANCE_PER_WIDTH * (2.0 * accurate.half_length / cells) ** 6
    with Stopwatch() as watch:
        evolution = solve(scene, 1.0, [scene.end_time], cells, tolerance, levels)
    xi = upwind.grid(accurate.half_length, EVALUATED_POINTS)
    return Run(_distances(accurate, xi, evolution.rescaled_force(0, xi)), **watch.times)


def _run_fourier(scene, accurate, longest_step):
    """The Fourier method on ξ = ξ̃ + τ."""
    half_length, end = accurate.half_length, _end_of(scene)
    equation = Equation(half_length, 1.0, 0.0, SMALLEST_ARGUMENT)
    # `follow` takes half of the steps that it is shown.
    doubled = np.arange(0.0, end + 4.0 * longest_step, 2.0 * longest_step).tolist()
    tolerance = longest_step**FOURIER_ORDER
    with Stopwatch() as watch:
        start = make_start(scene.start)
        kept, _ = follow(equation, start, [end], POINTS, tolerance, FOURIER_LEVELS, coarser=doubled)
    xi = upwind.grid(half_length, POINTS)
    values = values_at(kept[0], half_length, xi + end)
    return Run(_distances(accurate, xi, values), **watch.times)


def _end_of(scene):
    """Return τ at the end."""
    return scene.scaling.slow_rate * scene.end_time


def _distances(accurate, xi, values):
    """Return the distances of Y to the reference at the points of a scheme."""
    return {"rescaled_force": values - accurate.rescaled_force(0, xi)}
