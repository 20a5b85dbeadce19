"""Figures 20 and 21, and the numbers measured on campaigns of rings."""

import importlib

import numpy as np
import pytest
import xarray as xr
from pictures import curves, image, picture

from granular_fronts.accuracy import Estimate
from granular_fronts.campaign import measures
from granular_fronts.output.style import MODEL_LOOKS


def test_fig20_draws_every_equation_in_every_limit():
    damping, gamma, mu, _, _, time, _, panels = picture("fig20")
    for name, campaign, place in (
        ("damping", damping, {"damping": 0.3}),
        ("gamma", gamma, {}),
        ("mu", mu, {"mu": 2.0}),
    ):
        at_one = campaign.sel(slow_time=1.0, **place)
        for line, model in zip(curves(panels[name])[:3], MODEL_LOOKS, strict=True):
            np.testing.assert_array_equal(line.get_xdata(), at_one["epsilon_of_ring"])
            error = np.abs(at_one[f"displacement_sup_{model}"])
            np.testing.assert_array_equal(line.get_ydata(), error)
    line = curves(panels["time"])[2]
    np.testing.assert_array_equal(line.get_ydata(), time["displacement_sup_dispersive"].sel(mu=2.0))
    orders = measures.fitted_order(gamma, "displacement_sup_logarithmic")
    title = panels["gamma"].get_title().replace("−", "-")
    assert f"(41): {orders.value:.2f} ±" in title


@pytest.mark.parametrize(
    ("value", "error", "words"),
    [
        (0.9293, 0.042, "0.93 ± 0.04"),
        (-0.061, 0.03, "−0.06 ± 0.03"),
        (-0.002, 0.013, "0.00 ± 0.01"),
        (0.9991, 0.0018, "0.999 ± 0.002"),
        (1.0, 0.0, "1.00 ± 0.00"),
        (np.nan, np.nan, "nan ± nan"),
    ],
)
def test_fig20_writes_orders_with_the_digits_of_their_errors(value, error, words):
    plot_fig20 = importlib.import_module("plot_fig20")
    assert plot_fig20.with_error(Estimate(value, error)) == words


def test_fig21_draws_the_best_equation_and_times_of_loss():
    rings, _, _, panels = picture("fig21")
    at_one = rings.sel(slow_time=1.0)
    errors = np.stack([at_one[f"displacement_sup_{model}"] for model in MODEL_LOOKS])
    for name, expected in (("best", errors.argmin(axis=0)), ("error", errors.min(axis=0))):
        shown = image(panels[name]).get_array().reshape(expected.shape)
        np.testing.assert_array_equal(shown, expected)
    scaled = np.sort([line.get_ydata() for line in curves(panels["scaled"])], axis=None)
    close = at_one.where(at_one["alpha"] <= 1.05, drop=True)
    errors = [close[f"displacement_sup_{model}"].values for model in MODEL_LOOKS]
    expected = np.array(errors) / (1.0 - 1.0 / close["alpha"].values)
    np.testing.assert_allclose(scaled, np.sort(expected, axis=None))
    last = rings["slow_time"].values[-1]
    for name, loss in (
        ("logarithmic_1", "lost_1_logarithmic"),
        ("unlimited_5", "lost_5_unlimited"),
    ):
        times = rings[loss].sel(slow_time=last)
        shown = image(panels[name]).get_array().reshape(times.shape)
        np.testing.assert_array_equal(shown, times.fillna(2.0 * last))
    found = [
        line.get_xydata()[0] for line in panels["best"].get_lines() if line.get_marker() == "*"
    ]
    # γc of the two runs of the paper, δ = 5.
    stars = [[0.1, 0.24 * 5.0**0.05], [0.5, 0.24 * 5.0**0.25]]
    np.testing.assert_allclose(found, stars, rtol=1e-12)


# Measures.


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
