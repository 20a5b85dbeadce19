"""The logarithmic Burgers equation: flux, fronts, scales, both solvers, and what is refused."""

import copy
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from scipy.integrate import quad

import granular_fronts as gf
from granular_fronts.configuration import ConfigurationError, load_configuration
from granular_fronts.continuum import finite_volumes, stabilised, upwind
from granular_fronts.continuum.evolution import (
    EvolutionError,
    evolve_unlimited,
    scaling_of,
    solve,
)
from granular_fronts.continuum.log_burgers import flux, front_end, limit_flux, log_burgers_front
from granular_fronts.continuum.starts import Given, Plateau, make_start
from granular_fronts.continuum.vector_log import logarithms
from granular_fronts.slow_scales import make_slow_scales

CONFIGURATION = load_configuration(Path(__file__).parents[1] / "config" / "default.yaml")
SCENES = CONFIGURATION["scenes"]["periodic"]


def scene_with(name="weak", **changes):
    """A paper scene on coarse grids; `law__gamma=…` reaches into it."""
    scene = copy.deepcopy(SCENES[name])
    for equation, tolerance in (("logarithmic", 1.0e-6), ("unlimited", 1.0e-5)):
        scene["equations"][equation] = {"cells": 512, "tolerance": tolerance}
    for path, value in changes.items():
        *parents, last = path.split("__")
        node = scene
        for parent in parents:
            node = node[parent]
        node[last] = value
    return scene


def slope_and_residual(sizes, errors):
    """Observed order and the scatter about it, in powers of ten."""
    x, y = np.log10(sizes), np.log10(errors)
    line = Polynomial.fit(x, y, 1).convert()
    return -line.coef[1], np.abs(line(x) - y).max()


def at_end(scene, alpha, cells, tolerance):
    """Cell averages at the end of a scene."""
    return solve(scene, alpha, [scene["end_time"]], cells, tolerance).averages[0]


def coarsen(averages, cells):
    return averages.reshape(cells, -1).mean(axis=1)


# Flux, fronts, scales.


def test_flux_tends_to_its_limit_without_cancellation():
    y = np.array([0.0, 1.0e-300, 1.0e-7, 0.3, 1.0, 2.0])
    near = flux(y, 1.0 + 1.0e-12)
    # The next term of the expansion is −(1 − 1/α) y ln²y / 2.
    np.testing.assert_allclose(near, limit_flux(y), rtol=1.0e-9, atol=1.0e-12)
    np.testing.assert_allclose(flux(y, 1.5), 3.0 * (y - y ** (2 / 3)), rtol=1.0e-14, atol=1e-15)


@pytest.mark.parametrize("alpha", [1.0 + 1.0e-9, 1.1, 1.5, 3.0])
def test_front_solves_its_equation(alpha):
    """Six-point differences of y equal f_α(y), inside the support."""
    xi = np.linspace(-6.0, min(front_end(alpha), 2.5) - 0.05, 200)
    h = 1.0e-2 if alpha < 2 else 2.0e-3
    weights = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    slope = sum(
        w * (log_burgers_front(xi + k * h, alpha) - log_burgers_front(xi - k * h, alpha)) / h
        for k, w in weights.items()
    )
    np.testing.assert_allclose(slope, flux(log_burgers_front(xi, alpha), alpha), atol=2.0e-8)


def test_limit_front_solves_its_equation_and_is_the_limit():
    xi = np.linspace(-8.0, 3.0, 50)
    y = log_burgers_front(xi)
    slope = -np.log(2.0) * np.exp(xi) * y
    np.testing.assert_allclose(slope, limit_flux(y), rtol=1.0e-12, atol=1e-300)
    np.testing.assert_allclose(log_burgers_front(xi, 1.0 + 1.0e-10), y, atol=1.0e-9)


@pytest.mark.parametrize("alpha", [1.1, 1.5])
def test_front_has_the_phase_of_the_paper_and_ends_where_it_should(alpha):
    assert log_burgers_front(0.0, alpha) ** (1 / alpha) == pytest.approx(0.5, abs=1e-15)
    assert log_burgers_front(front_end(alpha) + 1.0e-9, alpha) == 0.0
    assert log_burgers_front(front_end(alpha) - 1.0e-3, alpha) > 0.0


def test_scales_are_those_the_paper_prints():
    weak, hertz = make_slow_scales(1.1, 0.24, 5.0), make_slow_scales(1.5, 0.24, 5.0)
    assert weak.epsilon == pytest.approx(0.35, abs=0.005)
    assert hertz.epsilon == pytest.approx(0.93, abs=0.005)
    assert weak.half_length(80) == pytest.approx(27.78, abs=0.006)
    assert hertz.half_length(80) == pytest.approx(73.84, abs=0.005)
    for scaling in (weak, hertz):
        relation = scaling.speed + scaling.slow_rate / scaling.epsilon
        assert scaling.frame_speed == pytest.approx(relation, rel=1e-14)


def test_velocity_of_a_front_agrees_with_the_first_order_velocity():
    """(44) is (43) with y' = f_α(y) up to the next order: for weak nonlinearity they meet."""
    differences = []
    for excess in (0.02, 0.01):
        scaling = make_slow_scales(1.0 + excess, 1.0, 5.0)
        y = log_burgers_front(np.linspace(-3.0, 1.0, 9), scaling.alpha)
        first_order = scaling.corrected_velocity(y, flux(y, scaling.alpha))
        of_front = scaling.front_velocity(y ** (1.0 / scaling.alpha))
        differences.append(np.abs(first_order - of_front).max() / scaling.velocity_scale)
    assert differences[0] < 1.0e-3
    assert differences[1] == pytest.approx(differences[0] / 4.0, rel=0.2)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((1.0, 0.24, 5.0), "alpha is 1.0"),
        ((0.9, 0.24, 5.0), "above 1"),
        ((1.1, 0.0, 5.0), "gamma is 0.0"),
        ((1.1, 0.24, 0.0), "delta is 0.0"),
    ],
)
def test_impossible_scales_are_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        make_slow_scales(*arguments)


def test_impossible_fluxes_and_fronts_are_refused():
    for function in (flux, log_burgers_front):
        with pytest.raises(ValueError, match=r"alpha is 1\.0.*above 1"):
            function(0.5, 1.0)
    for function in (limit_flux, lambda y: flux(y, 1.5)):
        with pytest.raises(ValueError, match=r"y is -0\.1.*cannot pull"):
            function([-0.1, 0.5])


# Parts of the scheme.


def test_logarithm_is_that_of_the_library():
    x = np.concatenate([np.geomspace(3e-308, 1e300, 4001), np.linspace(0.7, 1.42, 4001)])
    result = np.empty_like(x)
    logarithms(x, np.empty(x.size, np.int64), np.empty_like(x), result)
    exact = np.log(x)
    assert np.all(np.abs(result - exact) <= np.spacing(np.abs(exact)) + 1e-320)


@pytest.mark.parametrize("alpha", [1.0, 1.1, 1.5])
@pytest.mark.parametrize("floor", [1.0e-7, 1.0e-300, 0.0])
def test_start_averages_are_exact(alpha, floor):
    half_length, cells, start = 27.78, 37, Plateau(10.0, floor)
    averages = start.averages(cells, half_length, alpha)
    width = 2.0 * half_length / cells
    kinks = [sign * k for k in (10.0, 10.0 + np.sqrt(1.0 - floor)) for sign in (-1, 1)]
    for i in range(cells):
        a, b = -half_length + i * width, -half_length + (i + 1) * width
        inside = [k for k in kinks if a < k < b]
        value, _ = quad(
            lambda x: start.values(x, half_length) ** (1 / alpha),
            a,
            b,
            points=inside or None,
            epsabs=1e-12,
        )
        assert averages[i] == pytest.approx(value / width, abs=2e-11)
    assert averages.min() >= floor ** (1 / alpha)


def test_given_start_is_interpolated_by_a_trigonometric_polynomial():
    half_length = 12.0
    xi = half_length * np.linspace(-1.0, 1.0, 33)
    start = Given(tuple(2.0 + np.cos(np.pi * xi / half_length)))
    points = np.linspace(-12.0, 30.0, 50)
    exact = 2.0 + np.cos(np.pi * points / half_length)
    np.testing.assert_allclose(start.values(points, half_length), exact, atol=1e-13)
    edges = np.pi * np.linspace(-1.0, 1.0, 21)
    exact = 2.0 + np.diff(np.sin(edges)) / np.diff(edges)
    np.testing.assert_allclose(start.averages(20, half_length, 1.0), exact, atol=1e-13)


def test_point_values_are_of_seventh_order():
    cells, errors = [24, 32, 48, 64, 96], []
    for n in cells:
        edges = np.linspace(-np.pi, np.pi, n + 1)
        averages = np.diff(-np.cos(edges)) / np.diff(edges)
        xi = np.linspace(-4.0, 4.0, 1001)
        errors.append(
            np.abs(finite_volumes.point_values(averages, np.pi, xi, -2.0) - np.sin(xi)).max()
        )
    order, scatter = slope_and_residual(cells, errors)
    assert order == pytest.approx(7.0, abs=0.15)
    assert scatter < 0.05


def test_rates_are_of_sixth_order():
    """On a smooth positive wave the rates are the differences of the exact flux."""
    cells, errors = [32, 48, 64, 96, 128], []
    for n in cells:
        edges = np.linspace(-np.pi, np.pi, n + 1)
        averages = 2.0 + np.diff(-np.cos(edges)) / np.diff(edges)
        value, slope = 2.0 + np.sin(edges), np.cos(edges)
        width = 2.0 * np.pi / n
        worst = 0.0
        for alpha in (1.0, 1.5):
            equation = finite_volumes.Equation(alpha, 1e-16, 0.0, width)
            rates = np.empty(n)
            finite_volumes.evaluate_rates(equation, averages, finite_volumes.make_work(n), rates)
            advected = limit_flux(value) - value if alpha == 1 else flux(value**1.5, 1.5) - value
            exact = -np.diff(advected - alpha * value ** (alpha - 1.0) * slope) / width
            worst = max(worst, np.abs(rates - exact).max())
        errors.append(worst)
    order, scatter = slope_and_residual(cells, errors)
    assert order == pytest.approx(6.0, abs=0.15)
    assert scatter < 0.05


def test_lifting_keeps_the_mean_and_the_bound():
    averages = np.random.default_rng(1).uniform(0.0, 1.0, 200) ** 4
    before = averages.mean()
    assert finite_volumes.lift(averages, 0.1) > 0.0
    assert averages.min() == 0.1
    assert averages.mean() == pytest.approx(before, rel=1e-15)


def test_tabulated_steps_are_stable():
    """|P| ≤ 1 on points of the promised region that the table was not made from."""
    fraction = np.linspace(0.0, 1.0, 1013)[1:]
    for row, stages in enumerate(stabilised.STAGES):
        b, p = stabilised.REAL_REACH[row], stabilised.PARABOLA[row]
        for share in (0.0, 0.3, 1.0):
            z = -b * fraction + 1j * np.sqrt(share * p * b * fraction * (1.0 - fraction))
            assert np.abs(stabilised.stability_polynomial(stages, z)).max() <= 1.0 + 1e-9


def test_stability_polynomial_is_of_second_order():
    for stages in stabilised.STAGES:
        h = 1.0e-3
        polynomial = stabilised.stability_polynomial(stages, np.array([h, -h]))
        assert np.abs(polynomial - np.exp([h, -h])).max() < h**3


# Solutions.


@pytest.mark.parametrize("name", ["weak", "hertz"])
@pytest.mark.parametrize("floor", [1.0e-7, 1.0e-300, 0.0])
def test_mean_is_kept_to_rounding_and_the_floor_holds(name, floor):
    solution = solve(scene_with(name, start__floor=floor), 1.0, [45.0, 90.0], 512, 1.0e-5)
    assert solution.mean_drift < 2.0e-15
    assert solution.averages.min() >= floor
    assert solution.averages.max() <= 1.0 + 1.0e-6


def test_floor_of_zero_is_the_limit_of_small_floors():
    ends = [
        at_end(scene_with("hertz", start__floor=floor), 1.0, 512, 1e-6) for floor in (0.0, 1e-300)
    ]
    np.testing.assert_allclose(*ends, atol=1e-12)


def test_order_away_from_kinks():
    """From a smooth positive start the spatial order is six."""
    half_beads = 10
    x = np.pi * np.linspace(-1.0, 1.0, 65)
    start = {"kind": "given", "rescaled_force": 1.0 + 0.5 * np.sin(x)}
    start["rescaled_force"][-1] = start["rescaled_force"][0]
    scene = scene_with(start=start, half_beads=half_beads, end_time=10.0)
    reference = at_end(scene, 1.0, 768, 1e-12)
    cells = [24, 32, 48, 64]
    errors = [np.abs(at_end(scene, 1.0, n, 1e-12) - coarsen(reference, n)).max() for n in cells]
    order, scatter = slope_and_residual(cells, errors)
    assert order == pytest.approx(6.0, abs=0.3)
    assert scatter < 0.05


def test_order_with_kinks_exceeds_two():
    """The kinks of (49) cost orders, but less than point values would."""
    scene = scene_with()
    reference = at_end(scene, 1.0, 4096, 1e-9)
    cells = [256, 512, 1024]
    errors = [np.abs(at_end(scene, 1.0, n, 1e-9) - coarsen(reference, n)).max() for n in cells]
    assert slope_and_residual(cells, errors)[0] > 2.5
    assert errors[1] < 5.0e-6


def test_steps_are_of_second_order():
    """Where accuracy and not stability sets the steps, the error goes like tolerance^(2/3)."""
    scene = scene_with()
    reference = at_end(scene, 1.0, 2048, 1e-10)
    tolerances = np.array([1e-6, 1e-7, 1e-8])
    errors = [np.abs(at_end(scene, 1.0, 2048, t) - reference).max() for t in tolerances]
    power, scatter = slope_and_residual(1.0 / tolerances, errors)
    assert power == pytest.approx(2 / 3, abs=0.05)
    assert scatter < 0.05


@pytest.mark.parametrize("name", ["weak", "hertz"])
def test_accuracy_of_the_issue_is_reached(name):
    cells = {"weak": 512, "hertz": 768}[name]
    scene = scene_with(name)
    reference = at_end(scene, 1.0, 4 * cells, 1e-9)
    assert np.abs(at_end(scene, 1.0, cells, 2e-6) - coarsen(reference, cells)).max() < 1.0e-5


def test_upwind_is_of_first_order_and_tends_to_the_finite_volumes():
    scene = scene_with(end_time=20.0)
    scaling, half_length = scaling_of(scene), scaling_of(scene).half_length(80)
    accurate = solve(scene, 1.0, [20.0], 1024, 1e-7)
    points, runs = [500, 1000, 2000], {}
    for n in points:
        values = make_start(scene["start"]).values(upwind.grid(half_length, n), half_length)
        runs[n] = upwind.evolve_upwind(values, half_length, scaling.slow_rate * 20.0)
    exact = accurate.rescaled_force(0, runs[500].xi)
    errors = [np.abs(runs[n].values[:: n // 500] - exact).max() for n in points]
    order, _ = slope_and_residual(points, errors)
    assert order == pytest.approx(1.0, abs=0.2)
    extrapolated = 2.0 * runs[2000].values[::4] - runs[1000].values[::2]
    assert np.abs(extrapolated - exact).max() < 0.2 * errors[-1]


def test_stationary_front_of_the_limit_stays_where_it_is():
    """A wide plateau ends in the front; in the moving frame the front recedes by τ exactly."""
    scene = scene_with("hertz", end_time=15.0)
    scaling, half_length = scaling_of(scene), scaling_of(scene).half_length(80)
    xi = half_length * np.linspace(-1.0, 1.0, 1025)
    rise = 1.0 / (1.0 + np.exp(-1.5 * (xi + 40.0)))
    force = np.maximum(log_burgers_front(xi - 20.0) * rise, 1e-12)
    force[-1] = force[0]
    scene = scene_with("hertz", start={"kind": "given", "rescaled_force": force}, end_time=15.0)
    solution = solve(scene, 1.0, [15.0], 2048, 1e-9)
    near = np.linspace(13.0, 25.0, 200)
    found = solution.rescaled_force(0, near - scaling.slow_rate * 15.0)
    np.testing.assert_allclose(found, log_burgers_front(near - 20.0), atol=2.0e-7)


def test_unlimited_equation_tends_to_its_limit():
    scene = scene_with(law__alpha=1.0001, law__gamma=0.00024 * 1.1, end_time=5.0e4)
    ends = [at_end(scene, alpha, 512, 1e-7) for alpha in (1.0, 1.0001)]
    np.testing.assert_allclose(*ends, atol=3.0e-4)


def test_datasets_state_an_error_that_holds():
    scene = scene_with(record__snapshots=[0, 26.78, 89.95])
    dataset = gf.evolve_log_burgers(scene)
    assert dataset["rescaled_force"].dims == ("t", "xi")
    times = np.asarray(scene["record"]["snapshots"])
    fine = solve(scene, 1.0, times, 4096, 1e-9)
    exact = np.array([fine.rescaled_force(row, dataset["xi"]) for row in range(3)])
    error = np.abs(dataset["rescaled_force"].values - exact).max()
    estimate = dataset["rescaled_force"].attrs["error_estimate"]
    assert error <= 2.0 * estimate
    assert estimate < 1.0e-3
    unlimited = evolve_unlimited(scene)
    assert 1e-3 < np.abs(unlimited - dataset)["rescaled_force"].max() < 0.2


# What is refused.


REFUSED = [
    ({"law__alpha": 1}, ["law.alpha is 1", "above 1"]),
    ({"law__gamma": 0}, ["law.gamma is 0", "above 0"]),
    ({"half_beads": 1}, ["half_beads is 1", "limit 2"]),
    ({"start__floor": 1.5}, ["start.floor is 1.5", "limit 1"]),
    ({"start__half_width": 27.5}, ["half_width is 27.5", "27.7853", "raise half_beads"]),
    (
        {"start": {"kind": "given", "rescaled_force": [0.0, -0.1, 0.0]}},
        ["-0.1", "cannot pull"],
    ),
    (
        {"start": {"kind": "given", "rescaled_force": [0.0, 1.0, 0.5]}},
        ["begins with 0.0 and ends with 0.5", "periodic"],
    ),
    ({"equations__logarithmic__cells": 64}, ["logarithmic.cells is 64", "too coarse", "give 112"]),
    ({"equations__upwind__points": 64}, ["upwind.points is 64", "too coarse", "give 112"]),
    ({"equations__unlimited__tolerance": 1e-16}, ["tolerance is 1e-16", "floor of 1e-13"]),
    ({"record__snapshots": [90.5]}, ["record.snapshots (entry 1) is 90.5", "end_time 90"]),
    ({"record__snapshots": [-1]}, ["record.snapshots (entry 1) is -1", "limit 0"]),
    ({"record__grid__step": 91}, ["record.grid.step is 91", "end_time 90"]),
]


@pytest.mark.parametrize(("changes", "words"), REFUSED, ids=[str(c)[:50] for c, _ in REFUSED])
def test_impossible_scene_is_refused_in_a_sentence(changes, words):
    with pytest.raises(ConfigurationError, match=r"^Scene mine: ") as caught:
        gf.evolve_log_burgers(scene_with(**changes), "mine")
    for word in words:
        assert word in str(caught.value)


def test_start_that_rings_below_zero_is_refused():
    """Point values of a step make a trigonometric polynomial that undershoots."""
    step = [0.0] * 20 + [1.0] * 25 + [0.0] * 20
    scene = scene_with(start={"kind": "given", "rescaled_force": step})
    with pytest.raises(EvolutionError, match=r"smallest cell average of the start is -.*smoother"):
        gf.evolve_log_burgers(scene)


def test_step_size_collapse_is_reported():
    """A start of 1e100 cannot be followed with an absolute error of 1e-6."""
    force = [1.0e100, 2.0e100] * 32 + [1.0e100]
    scene = scene_with(start={"kind": "given", "rescaled_force": force})
    with pytest.raises(EvolutionError, match="step size collapsed"):
        gf.evolve_log_burgers(scene)


def test_explicit_step_that_would_blow_up_is_refused():
    values = np.full(1000, 1.0e-7)
    limit = upwind.largest_step(0.02, abs(np.log(1.0e-7)))
    upwind.evolve_upwind(values, 10.0, 2 * limit, step=limit)
    with pytest.raises(ValueError, match="would blow up: take a step below the limit"):
        upwind.evolve_upwind(values, 10.0, 1.0, step=1.01 * limit)
    with pytest.raises(ValueError, match="give positive values"):
        upwind.evolve_upwind(np.zeros(1000), 10.0, 1.0)
