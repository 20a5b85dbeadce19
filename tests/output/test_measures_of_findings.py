"""Measures behind the numbers of the pages, on datasets whose answers are known."""

import numpy as np
import pytest
import xarray as xr

from granular_fronts.campaign import measures as rings

ORDERS = {"logarithmic": 1.0, "unlimited": 0.9, "dispersive": 1.1}
ALPHA = np.array([1.01, 1.05, 1.1, 1.5])


def campaign(axis, values, power):
    """Rings whose errors are powers of ε, but for α = 3/2."""
    epsilon = np.outer(np.ones(len(values)), ALPHA - 1.0)
    errors = {
        f"displacement_sup_{name}": ((axis, "alpha"), epsilon ** power(order) + (ALPHA > 1.4))
        for name, order in ORDERS.items()
    }
    dataset = xr.Dataset(
        errors | {"epsilon_of_ring": ((axis, "alpha"), epsilon)}, {axis: values, "alpha": ALPHA}
    )
    return dataset.expand_dims(slow_time=[1.0])


def test_extreme_orders_are_those_of_all_equations_and_dampings():
    damping = campaign("damping", [0.3, 3.0], lambda order: order)
    gamma = campaign("case", [0], lambda order: order + 0.05).isel(case=0)
    assert rings.smallest_order(damping, gamma).value == pytest.approx(0.9, abs=1e-12)
    assert rings.largest_order(damping, gamma).value == pytest.approx(1.15, abs=1e-12)


def test_best_equation_of_a_map():
    """(55) is best up to γ = 0.2, (40) from 0.8 on, a ring that is not solved left out."""
    gamma = np.array([0.1, 0.2, 0.4, 0.8, 1.6])
    dims = ("slow_time", "gamma", "alpha")
    ones = np.ones((1, gamma.size, ALPHA.size))
    errors = {
        "dispersive": ones * gamma[:, None],
        "unlimited": ones * 0.5 / gamma[:, None],
        "logarithmic": ones * np.where(gamma == 0.4, 0.1, 0.9)[:, None],
    }
    errors["unlimited"][0, 4, 0] = np.nan
    errors["dispersive"][0, :, 3] = -9.0
    dataset = xr.Dataset(
        {f"displacement_sup_{name}": (dims, values) for name, values in errors.items()},
        {"slow_time": [1.0], "gamma": gamma, "alpha": ALPHA},
    )
    assert rings.best_up_to(dataset, "displacement_sup_dispersive").value == 0.2
    assert rings.best_from(dataset, "displacement_sup_unlimited").value == 0.8
