"""Figures 20 and 21, and the numbers measured on campaigns of rings."""

import importlib

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr
from campaigns import all_chunks, campaign, solve
from rings import SCENES

from granular_fronts.accuracy import Estimate
from granular_fronts.campaign import measures, merging
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.output.style import MODEL_LOOKS

ALPHAS, PULSE = [1.05, 1.1, 1.3], {"half_length": 8.1, "half_width": 2, "base": 0.2}
CAMPAIGNS = {
    "damping": ({"damping": [0.5, 1.0], "alpha": ALPHAS}, {}, {}),
    "gamma": ({"alpha": ALPHAS}, {"gamma": 0.24, "delta": 5}, {}),
    "mu": ({"mu": [2.0], "alpha": ALPHAS}, {}, {}),
    "leading": ({"mu": [2.0], "alpha": ALPHAS}, {}, {"velocity": "leading"}),
    "plateau": ({"alpha": [1.2, 1.5]}, {"gamma": 0.5}, {"profile": "plateau"}),
    "time": ({"mu": [2.0, 8.0]}, {"alpha": 1.1}, {}),
    "front": ({}, {"alpha": 1.1, "mu": 8.0}, {"profile": "front"}),
    "rings": ({"gamma": [0.3, 1.0], "alpha": ALPHAS}, {}, {}),
}


@pytest.fixture(scope="module")
def rings(tmp_path_factory):
    """A small campaign for each dataset of the two figures, as the workflow writes it."""
    folder, merged = tmp_path_factory.mktemp("rings"), {}
    for name, (axes, fixed, start) in CAMPAIGNS.items():
        given = {
            "kind": "ring",
            "start": {"profile": "pulse", **start},
            "axes": {**axes, "slow_time": [0.5, 1]},
            "fixed": PULSE | fixed,
            "tolerance": 1e-5,
        }
        asked = campaign(given)
        files = [solve(chunk, folder) for chunk in all_chunks(asked, 100)]
        path = folder / f"{name}.nc"
        data = merging.merge_chunks(asked, files)
        write_dataset(data, path, scene_id=f"rings_{name}", config=given)
        merged[name] = read_dataset(path)
    return merged


@pytest.fixture
def paper_runs(tmp_path):
    runs = []
    for name in ("weak", "hertz"):
        write_dataset(xr.Dataset(), tmp_path / f"{name}.nc", scene_id=name, config=SCENES[name])
        runs.append(read_dataset(tmp_path / f"{name}.nc"))
    return runs


def drawn(name, *data):
    return getattr(importlib.import_module(name), name)(*data)


@pytest.mark.slow
def test_fig20_draws_every_equation_in_every_limit(rings):
    order = ("damping", "gamma", "mu", "leading", "plateau", "time", "front")
    figure = drawn("plot_fig20", *(rings[name] for name in order))
    damping, gamma, mu, time, start, velocity = figure.axes
    assert [len(axes.get_lines()) for axes in figure.axes] == [6, 3, 3, 9, 6, 3]
    for axes, campaign_of_axes, place in (
        (damping, rings["damping"], {"damping": 0.5}),
        (gamma, rings["gamma"], {}),
        (mu, rings["mu"], {"mu": 2.0}),
    ):
        at_one = campaign_of_axes.sel(slow_time=1.0, **place)
        for line, model in zip(axes.get_lines()[:3], MODEL_LOOKS, strict=True):
            np.testing.assert_array_equal(line.get_xdata(), at_one["epsilon_of_ring"])
            np.testing.assert_array_equal(line.get_ydata(), at_one[f"displacement_sup_{model}"])
    line = time.get_lines()[2]
    np.testing.assert_array_equal(
        line.get_ydata(), rings["time"]["displacement_sup_dispersive"].sel(mu=2.0)
    )
    worse, better = (start.get_lines()[row].get_ydata() for row in (3, 1))
    assert (worse > better)[:2].all(), "close to α = 1 the start of the paper adds an error"
    at_one = rings["damping"].sel(damping=1.0, slow_time=1.0)
    for line, formula in zip(
        velocity.get_lines(), ("leading", "printed", "first_order"), strict=True
    ):
        np.testing.assert_array_equal(line.get_ydata(), at_one[f"residual_{formula}"])
    orders = measures.fitted_order(rings["gamma"], "displacement_sup_logarithmic")
    assert f"(41): {orders.value:.2f} ±" in gamma.get_title()
    plt.close("all")


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


def test_fig21_draws_the_best_equation_and_times_of_loss(rings, paper_runs):
    figure = drawn("plot_fig21", rings["rings"], *paper_runs)
    best, least, scaled, *losses = figure.axes[:12]
    at_one = rings["rings"].sel(slow_time=1.0)
    errors = np.stack([at_one[f"displacement_sup_{model}"] for model in MODEL_LOOKS])
    shown = best.collections[0].get_array().reshape(2, 3)
    np.testing.assert_array_equal(shown, errors.argmin(axis=0))
    shown = least.collections[0].get_array().reshape(2, 3)
    np.testing.assert_array_equal(shown, errors.min(axis=0))
    found = np.sort([line.get_ydata() for line in scaled.get_lines()], axis=0)
    close = at_one.sel(alpha=[1.05])
    expected = [close[f"displacement_sup_{model}"].values[:, 0] * 21.0 for model in MODEL_LOOKS]
    np.testing.assert_allclose(found, np.sort(expected, axis=0))
    shown = losses[0].collections[0].get_array().reshape(2, 3)
    times = rings["rings"]["lost_1_logarithmic"].sel(slow_time=1.0)
    np.testing.assert_array_equal(shown, times.fillna(2.0))
    stars = [line.get_xydata()[0] for line in best.get_lines() if line.get_marker() == "*"]
    np.testing.assert_allclose(stars, [[0.1, 0.2601], [0.5, 0.3589]], atol=1e-4)
    plt.close("all")


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
