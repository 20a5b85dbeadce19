"""The logarithmic Burgers equation in time: orders, balances and both solvers."""

import itertools

import numpy as np
import pytest
from rings import assert_order, at_end, coarsen, scene_with
from scipy.integrate import quad

import granular_fronts as gf
from granular_fronts.continuum.evolution import evolve_unlimited
from granular_fronts.continuum.log_burgers.equation import log_burgers_front
from granular_fronts.continuum.log_burgers.finite_volumes import Equation
from granular_fronts.continuum.log_burgers.solution import START_LEVELS, _smoothing_time, solve
from granular_fronts.continuum.log_burgers.starts import Given, make_start
from granular_fronts.errors import InputError, SolveError
from granular_fronts.reference_methods import upwind
from granular_fronts.scenes.ring import Ring


@pytest.mark.parametrize(("name", "floor"), [("weak", 1.0e-7), ("hertz", 0.0)])
def test_mean_is_kept_to_rounding_and_the_floor_holds(name, floor):
    scene = Ring.read(scene_with(name, start__floor=floor))
    solution = solve(scene, 1.0, [45.0, 90.0], 512, 1.0e-5)
    finest = solution.start.averages(512 * 2**START_LEVELS, scene.half_length, 1.0)
    drift = max(abs(row.mean() - finest.mean()) for row in solution.averages)
    assert drift == solution.mean_drift < 2.0e-15
    assert min(row.min() for row in solution.averages) >= floor
    assert max(row.max() for row in solution.averages) <= 1.0 + 1.0e-6


def test_floor_of_zero_is_the_limit_of_small_floors():
    scenes = [scene_with("hertz", start__floor=floor) for floor in (0.0, 1e-300)]
    ends = [at_end(scene, 1.0, 512, 1e-6) for scene in scenes]
    np.testing.assert_allclose(*ends, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "cells", "tolerance", "finer"), [("weak", 256, 2e-6, 8), ("hertz", 640, 1e-5, 4)]
)
def test_accuracy_asked_for_is_reached(name, cells, tolerance, finer):
    """The finer cells at the start leave nothing of the kinks of (49)."""
    reference = at_end(scene_with(name), 1.0, finer * cells, 1e-10)
    found = at_end(scene_with(name), 1.0, cells, tolerance)
    assert np.abs(found - coarsen(reference, cells)).max() < 1.0e-5


def test_upwind_is_of_first_order_and_tends_to_the_finite_volumes():
    scene = scene_with(end_time=20.0)
    scaling, half_length = Ring.read(scene).scaling, Ring.read(scene).half_length
    points, start = [500, 1000, 2000], make_start(Ring.read(scene).start)
    runs = [
        upwind.evolve_upwind(
            start.values(upwind.grid(half_length, n), half_length),
            half_length,
            scaling.slow_rate * 20.0,
        )
        for n in points
    ]
    values = np.array([run.values[:: n // 500] for run, n in zip(runs, points, strict=True)])
    exact = solve(Ring.read(scene), 1.0, [20.0], 1024, 1e-7).rescaled_force(0, runs[0].xi)
    errors = np.abs(values - exact).max(axis=1)
    assert_order(points, errors, 1.0, 0.2)
    assert np.abs(2.0 * values[2] - values[1] - exact).max() < 0.2 * errors[-1]


def test_stationary_front_of_the_limit_stays_where_it_is():
    """A wide plateau ends in the front; in the moving frame the front recedes by τ exactly."""
    scaling = Ring.read(scene_with("hertz")).scaling
    xi = scaling.half_length(80) * np.linspace(-1.0, 1.0, 1025)
    rise = 1.0 / (1.0 + np.exp(-1.5 * (xi + 40.0)))
    force = np.maximum(log_burgers_front(xi - 20.0) * rise, 1e-12)
    force[-1] = force[0]
    scene = scene_with("hertz", start={"kind": "given", "rescaled_force": force}, end_time=15.0)
    near = np.linspace(13.0, 25.0, 200)
    moved = solve(Ring.read(scene), 1.0, [15.0], 2048, 1e-9).rescaled_force(
        0, near - scaling.slow_rate * 15.0
    )
    np.testing.assert_allclose(moved, log_burgers_front(near - 20.0), rtol=0, atol=2.0e-7)


def test_unlimited_equation_tends_to_its_limit():
    scene = scene_with(law__alpha=1.0001, law__gamma=0.00024 * 1.1, end_time=5.0e4)
    ends = [at_end(scene, alpha, 512, 1e-7) for alpha in (1.0, 1.0001)]
    np.testing.assert_allclose(*ends, rtol=0, atol=3.0e-4)


@pytest.mark.slow  # A solution on three times as many cells.
def test_equation_40_is_solved_through_its_steep_start():
    """At α = 3/2 the start meets its floor with infinite slope, and diffusion hardly smooths it."""
    scene = scene_with("hertz", record__snapshots=[0.5, 3.33])
    scene["equations"]["unlimited"] = {"cells": 512, "tolerance": 1.0e-6}
    force = evolve_unlimited(scene)["rescaled_force"]
    assert force.attrs["error_estimate"] < 5.0e-5
    fine = solve(
        Ring.read(scene), 1.5, [0.5, 3.33], 1536, 1.0e-7, levels=START_LEVELS, smooth_cells=8.0
    )
    exact = np.array([fine.rescaled_force(row, force["xi"].values) for row in range(2)])
    assert np.abs(force.values - exact).max() < 2.0 * force.attrs["error_estimate"]


def test_datasets_state_an_error_that_holds():
    scene = scene_with(record__snapshots=[0, 26.78, 89.95])
    dataset = gf.evolve_log_burgers(scene)
    assert dataset["rescaled_force"].dims == ("t", "xi")
    times = np.asarray(scene["record"]["snapshots"])
    fine = solve(Ring.read(scene), 1.0, times, 4096, 1e-9)
    exact = np.array([fine.rescaled_force(row, dataset["xi"]) for row in range(3)])
    error = np.abs(dataset["rescaled_force"].values - exact).max()
    estimate = dataset["rescaled_force"].attrs["error_estimate"]
    assert error <= 2.0 * estimate
    assert estimate < 1.0e-3
    unlimited = evolve_unlimited(scene)
    assert 1e-3 < np.abs(unlimited - dataset)["rescaled_force"].max() < 0.2


def test_cells_are_joined_when_diffusion_has_smoothed_kinks():
    """The time is that of the heat equation, s²/ν for a width s."""
    one, two = (_smoothing_time(Equation(1.5, 0.04, 0.0, width), 3.0) for width in (0.01, 0.02))
    assert (one, two) == pytest.approx((0.03**2 / 0.3, 0.06**2 / 0.3), rel=1e-12)


@pytest.mark.parametrize(
    ("force", "evolve", "reason"),
    [
        # Point values of a step make a trigonometric polynomial that undershoots.
        ([0.0] * 20 + [1.0] * 25 + [0.0] * 20, gf.evolve_log_burgers, "cell average .* is -"),
        # A start of 1e100 cannot be followed with an absolute error of 1e-6.
        ([1e100, 2e100] * 32 + [1e100], gf.evolve_log_burgers, "step size collapsed"),
        ([1e100, 2e100] * 32 + [1e100], gf.evolve_log_kdv_burgers, "step size collapsed"),
    ],
)
def test_start_that_cannot_be_followed_is_reported(force, evolve, reason):
    with pytest.raises(SolveError, match=reason):
        evolve(scene_with(start={"kind": "given", "rescaled_force": force}))


def test_explicit_step_that_would_blow_up_is_refused():
    values, limit = np.full(1000, 1.0e-7), upwind.largest_step(0.02, abs(np.log(1.0e-7)))
    upwind.evolve_upwind(values, 10.0, 2 * limit, step=limit)
    with pytest.raises(InputError, match="limit of stability"):
        upwind.evolve_upwind(values, 10.0, 1.0, step=1.01 * limit)
    with pytest.raises(InputError, match="positive"):
        upwind.evolve_upwind(np.zeros(1000), 10.0, 1.0)


@pytest.mark.parametrize("alpha", [1.0, 1.5])
def test_averages_of_a_start_of_few_points_are_those_of_its_polynomial(alpha):
    start, edges = Given((0.3, 0.3, 1.0, 0.3, 0.3)), np.linspace(-3.0, 3.0, 17)
    exact = [
        quad(lambda xi: start.values(xi, 3.0) ** (1.0 / alpha), *ends, epsabs=1e-14)[0] * 16.0 / 6.0
        for ends in itertools.pairwise(edges)
    ]
    np.testing.assert_allclose(start.averages(16, 3.0, alpha), exact, rtol=0, atol=1e-14)
