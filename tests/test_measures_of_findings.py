"""Measures behind the numbers of the pages, on datasets whose answers are known."""

import numpy as np
import pytest
import xarray as xr

from granular_fronts.campaign import measures as rings
from granular_fronts.fronts import measures as fronts
from granular_fronts.studies import law_measures as laws


def test_power_of_strong_damping_is_that_of_the_last_pair():
    gamma = np.array([0.5, 1.0, 2.0, 4.0])
    distance = xr.DataArray([[9.0, 1.0, 2.0**-1.5, 2.0**-3.25]], {"alpha": [1.5], "gamma": gamma})
    survey = xr.Dataset({"distance_unlimited": distance})
    power = fronts.strong_damping_power(survey, alpha=1.5)
    assert power == pytest.approx((-1.75, 0.25), abs=1e-12)


def test_methods_are_as_far_apart_as_the_farthest():
    def front(distance, error):
        shooting = xr.DataArray(0.0, attrs={"distance": distance})
        profile = xr.DataArray(0.0, attrs={"error_estimate": error})
        return {"relative_displacement_shooting": shooting, "relative_displacement": profile}

    assert fronts.methods_apart(front(1e-14, 3e-14), front(2e-14, 1e-14)) == (2e-14, 3e-14)


def test_exchange_exponent_is_that_of_the_dataset():
    assert fronts.exchange_exponent(xr.Dataset(attrs={"exchange_exponent": 1.25})).value == 1.25


def test_largest_relative_distance_is_that_of_the_worst_law():
    values = {"power_expected": [2.0, -4.0], "power_exact": [2.0002, -4.004]}
    values["power_exact_error"] = [1e-3, 4e-5]
    dataset = xr.Dataset({name: ("law", column) for name, column in values.items()})
    found = laws.largest_relative_distance(dataset, quantity="power", way="exact")
    assert found == pytest.approx((1e-3, 5e-4), rel=1e-9)


def test_largest_defect_of_pistons_is_of_any_quantity():
    names = ("front_speed", "compression_behind", "velocity_behind")
    values = {}
    for name, found in zip(names, (1.0, 2.002, 3.0), strict=True):
        values |= {f"{name}_expected": round(found), name: found, f"{name}_error": 1e-6 * found}
    dataset = xr.Dataset({name: ("law", [value]) for name, value in values.items()})
    assert laws.largest_piston_defect(dataset) == pytest.approx((1e-3, 1.001e-6), rel=1e-9)


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
