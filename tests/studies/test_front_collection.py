"""Fronts as curves: each is what the public solvers say of it, in a window that shows it."""

import itertools

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.studies import front_collection
from granular_fronts.studies.front_collection import MARGIN, OSCILLATIONS, SHOWN, collect_fronts

ALPHAS, GAMMAS = (1.2, 1.5), (0.05, 0.3, 0.9)
at_points = pytest.mark.parametrize(("alpha", "gamma"), list(itertools.product(ALPHAS, GAMMAS)))


@pytest.fixture(scope="module")
def collection():
    return collect_fronts(ALPHAS, GAMMAS)


@at_points
def test_curves_are_those_of_the_front(collection, alpha, gamma):
    point, front = collection.sel(alpha=alpha, gamma=gamma), gf.solve_front(alpha, gamma)
    u, xi = point["relative_displacement"].values, point["xi"].values
    np.testing.assert_array_equal(u, gf.evaluate_front(front, xi))
    roots = point["tail_root_real"].values + 1j * point["tail_root_imaginary"].values
    np.testing.assert_array_equal(roots, gf.tail_roots(alpha, gamma))
    multipliers = point["multiplier_real"].values + 1j * point["multiplier_imaginary"].values
    expected = gf.front_multipliers(front)
    found = multipliers[np.isfinite(multipliers)]
    np.testing.assert_array_equal(found, expected.values[: found.size])
    assert found.size == min(expected.size, front_collection.MULTIPLIERS)
    assert abs(found[0] - 1.0) == point["translation_defect"]
    assert point["verdict"] == expected.attrs["verdict"]


@at_points
def test_window_shows_the_front_from_tail_to_foot(collection, alpha, gamma):
    point = collection.sel(alpha=alpha, gamma=gamma)
    u, xi = point["relative_displacement"].values, point["xi"].values
    np.testing.assert_allclose(np.diff(xi), xi[1] - xi[0], rtol=1e-9)
    assert 0.0 < u[-1] <= SHOWN
    oscillations = -xi[0] * float(point["tail_frequency"]) / (2.0 * np.pi)
    assert abs(u[0] - 1.0) <= SHOWN or oscillations >= OSCILLATIONS
    assert oscillations <= (1.0 + MARGIN) * OSCILLATIONS + MARGIN * xi[-1]


def test_curves_are_as_far_apart_as_the_distances_say(collection):
    for name in ("logarithmic", "unlimited", "heteroclinic"):
        curve = collection[f"relative_displacement_{name}"]
        difference = curve - collection["relative_displacement"]
        shown = np.abs(difference).max("place")
        # The largest distance may lie between two places.
        between = np.abs(difference.diff("place")).max("place")
        assert (np.abs(shown - collection[f"distance_{name}"]) <= between).all()
        assert (between < 0.5 * shown).all()
        assert curve.attrs["error_estimate"] == 2.0**-52
    for name in ("relative_displacement", "multiplier_real", "tail_root_imaginary"):
        assert 0.0 < collection[name].attrs["error_estimate"] < 1e-8


def test_front_that_no_window_holds_has_no_multipliers(monkeypatch):
    monkeypatch.setattr(front_collection, "LARGEST_DEFECT", 0.0)
    multipliers, said = front_collection.largest_multipliers(gf.solve_front(1.5, 0.3))
    assert np.isnan(multipliers).all()
    assert np.isnan(said["translation_defect"])
    assert said["verdict"] == "undecided: 40 beads behind do not hold so wide a front"
