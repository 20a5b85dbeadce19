"""The logarithmic KdV–Burgers equation in time: solutions, balances, orders, methods."""

import numpy as np
import pytest
from rings import assert_order, scene_with
from scipy import fft
from waves_on_rings import moved, points_of, smooth_wave

import granular_fronts as gf
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_burgers.starts import Plateau
from granular_fronts.continuum.log_kdv_burgers.equation import amplitude_of_chain
from granular_fronts.continuum.log_kdv_burgers.exponential_steps import (
    Motion,
    doubled,
    phi_functions,
)
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import (
    Equation,
    values_at,
    values_on_points,
)
from granular_fronts.continuum.log_kdv_burgers.solution import follow, solve
from granular_fronts.scenes.ring import Ring

CIRCLE = np.exp(2j * np.pi * (np.arange(64) + 0.5) / 64)


def test_phi_functions_are_the_means_over_circles():
    z = -np.concatenate([[0.0], np.geomspace(1e-6, 30.0, 60)]) * np.exp(0.4j)
    w = z[:, None] + CIRCLE
    exponential = np.exp(w)
    first = (exponential - 1.0) / w
    second = (first - 1.0) / w
    third = (second - 0.5) / w
    for functions in (phi_functions(z), doubled(*phi_functions(0.5 * z))):
        for found, values in zip(functions, (exponential, first, second, third), strict=True):
            np.testing.assert_allclose(found, values.mean(axis=1), rtol=2e-13, atol=1e-15)


@pytest.mark.parametrize("dispersion", [0.1, 1.0])
def test_decay_of_the_square_is_the_dissipation(dispersion):
    half_length, end, tolerance = 10.0, 3.0, 1e-9
    equation = Equation(half_length, 1.0, dispersion, tolerance)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    times = np.concatenate([[0.0, end], 0.5 * end * (nodes + 1.0)])
    kept, _ = follow(equation, smooth_wave(half_length), times, 128, tolerance)
    kappa = np.pi * np.arange(65) / half_length
    squares = [2.0 * half_length * (abs(a[0]) ** 2 + 2.0 * np.sum(abs(a[1:]) ** 2)) for a in kept]
    losses = [4.0 * half_length * np.sum((kappa[: a.size] * abs(a[:65])) ** 2) for a in kept[2:]]
    decay = 0.5 * (squares[0] - squares[1])
    assert decay == pytest.approx(0.5 * end * weights @ losses, abs=1e-7)
    assert decay > 0.5


def test_steps_are_of_fourth_order():
    start = fft.rfft(smooth_wave(10.0).values(points_of(10.0, 64), 10.0), norm="forward")
    counts, ends = np.array([10, 20, 40, 80, 640]), []
    for steps in counts:
        motion = Motion(Equation(10.0, 1.0, 1.0, 1e-13), start, 64, 1.0)
        for _ in range(steps):
            motion.set_amplitudes(motion.stages(2.0 / steps)[0], 64)
        ends.append(motion.amplitudes)
    assert_order(counts[:-1], errors_of(ends), 4.0, 0.1)


def test_error_is_in_proportion_to_the_tolerance():
    start = smooth_wave(10.0).values(points_of(10.0, 64), 10.0)
    tolerances = np.array([1e-7, 1e-8, 1e-9, 1e-10, 1e-12])
    errors = errors_of([moved(start, 10.0, allowed, 5.0).amplitudes for allowed in tolerances])
    assert_order(1.0 / tolerances[:-1], errors, 1.0, 0.15, scatter=np.inf)
    assert (errors < tolerances[:-1]).all()


def errors_of(ends):
    """Largest distances, on 64 points, of all but the last amplitudes to the last."""
    return np.array([np.abs(values_on_points(end - ends[-1], 64)).max() for end in ends[:-1]])


def test_without_dispersion_it_is_the_logarithmic_burgers_equation():
    """The same ring by sixth-order finite volumes."""
    scene = scene_with("hertz", end_time=30.0)
    half_length = Ring.read(scene).half_length
    slow_time, start = Ring.read(scene).scaling.slow_rate * 30.0, Plateau(10.0, 1e-7)
    equation = Equation(half_length, 1.0, 0.0, 1e-16)
    kept, _ = follow(equation, start, [slow_time], 1024, 1e-10, 4)
    x = points_of(half_length, 999)
    accurate = log_burgers.solve(Ring.read(scene), 1.0, [30.0], 2048, 1e-9).rescaled_force(
        0, x - slow_time
    )
    found = values_at(kept[0], half_length, x)
    np.testing.assert_allclose(found, accurate, rtol=0, atol=2e-8)


def test_datasets_state_an_error_that_holds():
    scene = scene_with("weak", law__gamma=0.12, record__snapshots=[0, 26.78, 89.95])
    dataset = gf.evolve_log_kdv_burgers(scene)
    force = dataset["rescaled_force"]
    assert force.dims == ("t", "xi")
    np.testing.assert_allclose(force["xi"], -force["xi"][::-1], rtol=0, atol=1e-13)
    assert dataset.attrs["mu"] == pytest.approx(amplitude_of_chain(1.1, 0.12, 5.0).mu, rel=1e-13)
    assert dataset.attrs["mean_drift"] == 0.0
    fine = solve(Ring.read(scene), dataset["t"].values, 2048, 1e-8)
    exact = np.array([fine.rescaled_force(row, dataset["xi"]) for row in range(3)])
    error = np.abs(force.values - exact).max()
    assert error <= 2.0 * force.attrs["error_estimate"] < 2e-4
    assert dataset.attrs["smallest_value"] == pytest.approx(exact.min(), abs=1e-3)


def test_cut_off_of_the_logarithm_changes_less_than_the_tolerance():
    start, ends = Plateau(10.0, 0.0), []
    for floor in (1e-6, 1e-12):
        equation = Equation(27.78, 1.0, 0.5, floor)
        ends.append(values_on_points(follow(equation, start, [2.0], 256, 1e-8)[0][0], 256))
    assert np.abs(ends[0] - ends[1]).max() < 1e-6


def test_refined_run_has_twice_the_points_at_all_times():
    """In the order in which the times are asked for."""
    scene, times = scene_with("weak"), [3.0, 0.0, 30.0]
    coarse = solve(Ring.read(scene), times, 256, 1e-4)
    fine = solve(Ring.read(scene), times, 512, 1e-5, coarser=coarse)
    points = [[2 * (row.size - 1) for row in found.amplitudes] for found in (coarse, fine)]
    assert points == [[512, 1024, 256], [1024, 2048, 512]]


def test_error_of_long_steps_is_stated_too():
    """On these points, all of it; both runs would take the same steps if none were halved."""
    wave = 0.5 + 0.4 * np.cos(2.0 * np.pi * (np.arange(512) + 0.5) / 512)
    scene = scene_with("weak", end_time=2.0, record__snapshots=[2.0])
    scene["start"] = {"kind": "given", "rescaled_force": list(wave)}
    scene["equations"]["dispersive"] = {"cells": 512, "tolerance": 1e-6}
    force = gf.evolve_log_kdv_burgers(scene)["rescaled_force"]
    exact = solve(Ring.read(scene), [2.0], 1024, 1e-10).rescaled_force(0, force["xi"].values)
    error = np.abs(force.values[0] - exact).max()
    assert 0.9 * force.attrs["error_estimate"] < error < 1.2 * force.attrs["error_estimate"]


def test_refined_run_halves_every_step():
    scene = scene_with("weak", end_time=20.0)
    coarse = solve(Ring.read(scene), [20.0], 128, 1e-4)
    fine = solve(Ring.read(scene), [20.0], 256, 1e-1, coarser=coarse)
    ends, starts = np.array(coarse.step_ends), np.array(fine.step_ends[:-1])
    halves = 0.5 * np.diff(ends)[np.searchsorted(ends, starts, side="right") - 1]
    assert (np.diff(fine.step_ends) <= halves * (1.0 + 1e-9)).all()
