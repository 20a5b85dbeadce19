"""Orders fitted to campaigns of rings, and how their table writes them."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from tabulate_ring_orders import tabulate_ring_orders, with_error

from granular_fronts.accuracy import Estimate
from granular_fronts.campaign import measures
from granular_fronts.output.datasets import write_dataset


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
    tabulate_ring_orders(paths, tmp_path / "orders.csv", tmp_path / "orders.md")
    table = pd.read_csv(tmp_path / "orders.csv")
    assert list(table["fixed"]) == ["γc = 0.3", "γc = 3", "γ = 0.24", "μ = 2"]
    assert list(table["error of"]) == 2 * ["ẋ, (43) as printed"] + 2 * [
        "u, logarithmic KdV–Burgers"
    ]
    np.testing.assert_allclose(table["order"], [1.0, 1.0, 1.5, 2.0], rtol=1e-12)
