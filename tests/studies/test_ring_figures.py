"""Numbers measured on campaigns of rings, and how figure 20 writes them."""

import importlib

import numpy as np
import pytest
import xarray as xr

from granular_fronts.accuracy import Estimate
from granular_fronts.campaign import measures


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (0.9293, 0.042, "0.93 ± 0.04"),
        (-0.061, 0.03, "−0.06 ± 0.03"),
        (0.9991, 0.0018, "0.999 ± 0.002"),
        (np.nan, np.nan, "nan ± nan"),
    ],
)
def test_fig20_writes_orders_with_the_digits_of_their_errors(value, error, words):
    assert importlib.import_module("plot_fig20").with_error(Estimate(value, error)) == words


def made_up(power, scatter=0.0):
    """Errors 3 ε^power of rings with ε = α − 1, scattered by a factor."""
    alpha = np.array([1.001, 1.01, 1.03, 1.1, 1.5])
    epsilon = alpha - 1.0
    error = 3.0 * epsilon**power * np.exp(scatter * np.array([1.0, -1.0, 1.0, -1.0, 9.0]))
    attributes = {"error_estimate": 1e-9}
    return xr.Dataset(
        {
            "epsilon_of_ring": ("alpha", epsilon),
            "e": ("alpha", -error, attributes),
            "one": ("alpha", np.ones(5), attributes),
        },
        {"alpha": alpha},
    ).expand_dims(slow_time=[1.0])


@pytest.mark.parametrize("power", [1.0, 2.0])
def test_fitted_order_is_the_power(power):
    found = measures.fitted_order(made_up(power), "e")
    assert found.value == pytest.approx(power, abs=1e-12)
    scattered = measures.fitted_order(made_up(power, 0.1), "e")
    assert found.error < 1e-12 < 0.02 < scattered.error
    assert abs(scattered.value - power) < scattered.error


def test_errors_of_rings_and_their_ratios():
    data = made_up(1.0)
    assert measures.error_of_ring(data, "e", alpha=1.1).value == pytest.approx(0.3)
    assert measures.error_of_ring(data, "e", alpha=1.1).error == 1e-9
    least = measures.smallest_ratio(data, "one", "e")
    assert least.value == pytest.approx(1.0 / 0.3)
    assert measures.error_ratio(data, "one", "e", alpha=1.1).value == pytest.approx(1.0 / 0.3)
    later = xr.concat([data, 2.0 * data.assign_coords(slow_time=[4.0])], "slow_time")
    later["e"].attrs = data["e"].attrs
    assert measures.growth(later, "e", first=1, last=4, alpha=1.1).value == pytest.approx(2.0)
    over = measures.error_over_ratio(data.assign(ratio_of_ring=2.0 * data["one"]), "e", alpha=1.1)
    assert over.value == pytest.approx(0.15)
    strong = data.assign(ratio_of_ring=12.0 / 4.0 * data["one"])
    largest = measures.largest_over_exponent(strong, "e", least_mu=2)
    assert largest.value == pytest.approx(3.0 * 1.1)
    assert np.isnan(measures.largest_over_exponent(strong, "e", most_mu=2).value)
    ratio = measures.start_over_model(data, made_up(2.0), "e", alpha=1.1)
    assert ratio.value == pytest.approx(0.1)
