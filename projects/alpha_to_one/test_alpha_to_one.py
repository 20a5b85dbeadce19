"""Measures on rings whose answers are known, and how the table of orders writes them."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import limit_measures as measures
from granular_fronts.accuracy import Estimate
from granular_fronts.output.datasets import write_dataset
from ring_limit import ring_limit
from tabulate_ring_orders import tabulate_ring_orders, with_error

AXES = {"slow_time": [1.0, 16.0], "mu": [1.0, 2.0, 4.0], "alpha": [1.01, 1.1, 1.5]}
SIZE = np.array([[[1.0], [2.0], [4.0]], [[3.0], [8.0], [6.0]]])


def rings_of(**variables):
    """Rings on the axes, each number with an error of 1e-6."""
    given = {
        name: ([*AXES], values * np.ones((2, 3, 3)), {"error_estimate": 1e-6})
        for name, values in variables.items()
    }
    return xr.Dataset(given, AXES)


RINGS = rings_of(
    wrong=-SIZE * np.array([1e-4, 1e-2, 9.0]),
    right=np.array([1e-5, 5e-3, 1e-9]),
    epsilon_of_ring=np.array([0.01, 0.1, 0.5]),
    ratio_of_ring=12.0 / np.array(AXES["mu"])[:, None] ** 2,
)
LEADING = rings_of(wrong=5.0 * RINGS["wrong"].values)
ONE = {"error": "wrong", "mu": 2, "alpha": 1.1}
PAIR = {"error": "wrong", "other": "right", "mu": 2}


@pytest.mark.parametrize(
    ("measure", "data", "arguments", "value", "error"),
    [
        (measures.error_of_ring, [RINGS], ONE, 0.02, 1e-6),
        (measures.error_ratio, [RINGS], ONE | {"other": "right"}, 4.0, 1e-6 / 5e-3 * 5),
        (measures.smallest_ratio, [RINGS], PAIR, 4.0, 1e-6 / 1e-5 * 5),
        (measures.start_over_model, [RINGS, LEADING], ONE, 5.0, 1e-6 / 0.02 * 6),
        (measures.growth, [RINGS], ONE | {"first": 1, "last": 16}, 4.0, 1e-6 / 0.02 * 5),
        (measures.error_over_ratio, [RINGS], ONE, 0.02 / 3, 1e-6 / 3 * (1 + 0.02 / 3)),
        # Over 1 − 1/1.1; the error over the smallest 1 − 1/α.
        (measures.largest_over_exponent, [RINGS], {"error": "wrong"}, 0.44, 1.01e-4),
        (
            measures.largest_over_exponent,
            [RINGS],
            {"error": "wrong", "most_mu": 2},
            0.11,
            1.01e-4,
        ),
        (
            measures.largest_over_exponent,
            [RINGS],
            {"error": "wrong", "least_mu": 2, "most_mu": 4},
            0.22,
            1.01e-4,
        ),
    ],
)
def test_measure_is_what_follows_by_hand(measure, data, arguments, value, error):
    assert measure(*data, **arguments) == pytest.approx((value, error), rel=1e-9)


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (0.9293, 0.042, "0.93 ± 0.05"),
        (-0.061, 0.03, "−0.06 ± 0.03"),
        (0.9991, 0.0018, "0.999 ± 0.002"),
        (np.nan, np.nan, "nan"),
        (1.0, 0.0, "1.00"),
    ],
)
def test_orders_are_written_with_the_digits_of_their_errors(value, error, words):
    assert with_error(Estimate(value, error)) == words


def made_up(power, scatter=0.0):
    """Errors 3 ε^power of rings with ε = α − 1, scattered by a factor."""
    alpha = np.array([1.001, 1.01, 1.03, 1.1, 1.5])
    epsilon = alpha - 1.0
    error = 3.0 * epsilon**power * np.exp(scatter * np.array([1.0, -1.0, 1.0, -1.0, 9.0]))
    variables = {"epsilon_of_ring": ("alpha", epsilon), "e": ("alpha", -error)}
    return xr.Dataset(variables, {"alpha": alpha}).expand_dims(slow_time=[1.0])


@pytest.mark.parametrize("power", [1.0, 2.0])
def test_fitted_order_is_the_power(power):
    found = measures.fitted_order(made_up(power), "e")
    assert found.value == pytest.approx(power, abs=1e-12)
    scattered = measures.fitted_order(made_up(power, 0.1), "e")
    assert found.error < 1e-12 < 0.02 < scattered.error
    assert abs(scattered.value - power) < scattered.error


def test_orders_and_largest_errors_of_rings():
    """An order is known to two standard errors of its slope; μ is computed, and 2 is 2."""
    epsilon, error = np.array([0.01, 0.1, 1.0]), np.array([1e-3, 2e-2, 0.1])
    alpha, ratio = np.array([1.01, 1.05, 1.1]), np.full(3, 12.0 / (2.0 - 1e-13) ** 2)
    columns = {"epsilon_of_ring": epsilon, "ratio_of_ring": ratio, "e": error}
    rings = xr.Dataset(
        {name: (("alpha", "slow_time"), column[:, None]) for name, column in columns.items()},
        {"alpha": alpha, "slow_time": [1.0]},
    )
    rings["e"].attrs["error_estimate"] = 1e-6
    line, covariance = np.polyfit(np.log(epsilon), np.log(error), 1, cov=True)
    found = measures.fitted_order(rings, "e")
    assert found == pytest.approx((line[0], 2.0 * covariance[0, 0] ** 0.5))
    largest = measures.largest_over_exponent(rings, "e", least_mu=2.0)
    assert largest.value == pytest.approx((error / (1.0 - 1.0 / alpha)).max())
    assert np.isnan(measures.largest_over_exponent(rings, "e", most_mu=2.0).value)


def test_table_has_the_order_of_each_line(tmp_path):
    """A line for each equation or formula and each value of what a campaign fixes."""
    campaigns = {
        "rings_damping": made_up(1.0).expand_dims(damping=[0.3, 3.0]),
        "rings_gamma": made_up(1.5).assign_attrs(gamma=0.24),
        "rings_mu": made_up(2.0).expand_dims(mu=[2.0]),
    }
    for name, rings in campaigns.items():
        error = "residual_printed" if name == "rings_damping" else "displacement_sup_dispersive"
        named = rings.rename(e=error)
        for each in named.variables:
            named[each].attrs["long_name"] = each
        write_dataset(named, tmp_path / f"{name}.nc", scene_id=name, config={})
    paths = [tmp_path / f"{name}.nc" for name in campaigns]
    tabulate_ring_orders(*paths, tmp_path / "orders.csv", tmp_path / "orders.md")
    table = pd.read_csv(tmp_path / "orders.csv")
    assert list(table["fixed"]) == ["γc = 0.3", "γc = 3", "γ = 0.24", "μ = 2"]
    assert list(table["error of"]) == 2 * ["ẋ, (43) as printed"] + 2 * [
        "u, logarithmic KdV–Burgers"
    ]
    np.testing.assert_allclose(table["order"], [1.0, 1.0, 1.5, 2.0], rtol=1e-12)


ALPHA = np.array([1.01, 1.05, 1.1, 1.5])


def test_extreme_orders_are_those_of_all_equations_and_dampings():
    def rings(axis, values, more):
        """Rings whose errors are powers of ε, but for α = 3/2."""
        epsilon = np.outer(np.ones(len(values)), ALPHA - 1.0)
        errors = {
            name: ((axis, "alpha"), epsilon ** (order + more) + (ALPHA > 1.4))
            for name, order in zip(measures.EQUATION_ERRORS, (1.0, 0.9, 1.1), strict=True)
        }
        errors["epsilon_of_ring"] = (axis, "alpha"), epsilon
        return xr.Dataset(errors, {axis: values, "alpha": ALPHA}).expand_dims(slow_time=[1.0])

    damping, gamma = rings("damping", [0.3, 3.0], 0.0), rings("case", [0], 0.05).isel(case=0)
    assert measures.smallest_order(damping, gamma).value == pytest.approx(0.9, abs=1e-12)
    assert measures.largest_order(damping, gamma).value == pytest.approx(1.15, abs=1e-12)


def test_best_equation_of_a_map():
    """(55) up to γ = 0.2; (40) at 0.3, but all along from 0.8 on, where a ring is not solved."""
    gamma = np.array([0.1, 0.2, 0.3, 0.4, 0.8, 1.6])
    logarithmic = np.where(gamma == 0.4, 0.1, 0.9)
    unlimited = np.where(gamma == 0.3, 0.1, 0.5 / gamma)
    errors = np.stack([logarithmic, unlimited, gamma])[..., None] * np.ones(ALPHA.size)
    errors[1, -1, 0], errors[2, :, 3] = np.nan, -9.0
    dataset = xr.Dataset(
        {
            name: (("slow_time", "gamma", "alpha"), [values])
            for name, values in zip(measures.EQUATION_ERRORS, errors, strict=True)
        },
        {"slow_time": [1.0], "gamma": gamma, "alpha": ALPHA},
    )
    assert measures.best_up_to(dataset, "displacement_sup_dispersive").value == 0.2
    assert measures.best_from(dataset, "displacement_sup_unlimited").value == 0.8


def test_figure_names_the_damping_and_the_ratio_that_it_shows():
    def rings(axis, values):
        whole = made_up(1.0).drop_vars("e").expand_dims({axis: values})
        return whole.assign(dict.fromkeys(measures.EQUATION_ERRORS, whole["epsilon_of_ring"]))

    drawn = ring_limit(rings("damping", [0.3, 0.7]), rings("mu", [3.0, 8.0]))
    damping, mu = (axes.get_title() for axes in drawn.axes)
    assert damping.endswith(r"$\gamma c = 0.7$")
    assert mu.startswith(r"$\mu = 3$")
