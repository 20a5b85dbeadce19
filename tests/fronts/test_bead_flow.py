"""The flow of a window, its derivative, and banded least squares."""

import itertools

import numpy as np
import pytest

from granular_fronts.fronts.shooting import bead_flow
from granular_fronts.fronts.shooting.bead_flow import PowerLaw
from granular_fronts.numerics.banded_qr import band_storage, solve_least_squares

LAWS = [(1.2, 1.2, 0.05), (1.5, 1.0, 0.4), (1.5, 2.5, 0.2)]
by_law = pytest.mark.parametrize("law", [PowerLaw(*law) for law in LAWS], ids=str)
CONTACTS, STEPS, SPREAD = 40, 16, 20


def compressed_window():
    """A smooth state at rest at both ends of the window, u > 0 throughout."""
    n = np.arange(CONTACTS + 2.0)
    bump = np.exp(-0.05 * (n - 18.0) ** 2)
    u, d = 0.6 + 0.4 * bump, 0.2 * bump * np.sin(n)
    u[[0, -1]] = d[[0, -1]] = 0.0
    return u, d


def driver_behind(times):
    return 0.6 + 0.1 * np.sin(3.0 * times)


def moved(law, u, d, steps=STEPS, driven=driver_behind):
    """u and d after one bead-time, and the stiffnesses."""
    stiffness = bead_flow.make_stiffness(law, steps, u.size)
    driver = driven(bead_flow.stage_times(1.0, steps))
    weights = bead_flow.make_weights(law, 1.0 / steps)
    change = bead_flow.flow(law, weights, driver, u, d, stiffness)
    return np.array([u, d]) + change, stiffness


def extrapolated_derivative(function, h=2.0e-3):
    """Central differences of f at 0 with steps h, h/2, h/4, extrapolated to order 6."""
    table = [(function(k) - function(-k)) / (2.0 * k) for k in (h, h / 2.0, h / 4.0)]
    for order in (4.0, 16.0):
        table = [
            (order * fine - coarse) / (order - 1.0) for coarse, fine in itertools.pairwise(table)
        ]
    return table[0]


@by_law
def test_derivatives_of_the_flow_by_its_start_and_by_the_driver(law):
    u, d = compressed_window()
    direction = np.zeros((2, u.size))
    direction[:, 1:-1] = np.random.default_rng(3).normal(size=(2, CONTACTS))
    expected = extrapolated_derivative(
        lambda k: moved(law, u + k * direction[0], d + k * direction[1])[0]
    )
    weights, stiffness = bead_flow.make_weights(law, 1.0 / STEPS), moved(law, u, d)[1]
    band = bead_flow.derivative(law, weights, stiffness, SPREAD)
    result = np.zeros_like(expected)
    for n in range(1, CONTACTS + 1):
        for start in range(max(1, n - SPREAD), min(CONTACTS, n + SPREAD) + 1):
            result[:, n] += band[n, start - n + SPREAD] @ direction[:, start]
    np.testing.assert_allclose(result, expected, rtol=0, atol=3.0e-11)
    expected = extrapolated_derivative(
        lambda k: moved(law, u, d, driven=lambda t: driver_behind(t) + k * np.cos(2.0 * t))[0]
    )
    change = np.cos(2.0 * bead_flow.stage_times(1.0, STEPS))[np.newaxis]
    result = bead_flow.derivative_by_driver(law, weights, change, stiffness)[0]
    np.testing.assert_allclose(result[:, 1:-1], expected[:, 1:-1], rtol=0, atol=3.0e-11)


@by_law
def test_narrow_band_agrees_with_a_wide_one(law):
    """Contacts beyond `spread_of` receive nothing that a double would notice."""
    u, d = compressed_window()
    weights, stiffness = bead_flow.make_weights(law, 1.0 / STEPS), moved(law, u, d)[1]
    spread = bead_flow.spread_of(law, STEPS, u.max())
    wide = bead_flow.derivative(law, weights, stiffness, SPREAD)
    narrow = bead_flow.derivative(law, weights, stiffness, spread)
    inside = slice(SPREAD - spread, SPREAD + spread + 1)
    np.testing.assert_allclose(narrow, wide[:, inside], rtol=0, atol=1.0e-14)
    assert np.abs(wide[:, : SPREAD - spread]).max(initial=0.0) < 1.0e-14
    assert np.abs(wide[:, SPREAD - 3 :]).max() > 1.0e-4


@pytest.mark.parametrize(("rows", "columns", "lower", "upper"), [(60, 55, 9, 6), (30, 30, 2, 3)])
def test_banded_least_squares_agrees_with_dense(rows, columns, lower, upper):
    random = np.random.default_rng(0)
    dense, band = np.zeros((rows, columns)), band_storage(rows, lower, upper)
    for i in range(rows):
        for j in range(max(0, i - lower), min(columns, i + upper + 1)):
            dense[i, j] = band[i, j - i + lower] = random.normal()
    right = random.normal(size=rows)
    expected = np.linalg.lstsq(dense, right, rcond=None)[0]
    solution = solve_least_squares(band, lower, columns, right.copy())
    np.testing.assert_allclose(solution, expected, rtol=1.0e-10)
    assert np.linalg.norm(dense.T @ (dense @ solution - right)) < 1.0e-12


def test_rank_deficiency_gives_nan():
    band = band_storage(4, 1, 1)
    band[:3, 1] = 1.0
    band[1, 1] = 0.0
    assert np.isnan(solve_least_squares(band, 1, 3, np.ones(4))).any()
