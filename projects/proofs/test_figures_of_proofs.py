"""Which fronts are proved, and one within its enclosure: curves, bars, marks and bands."""

import re

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import to_rgba
from pictures import curves

from enclosed_front import enclosed_front
from granular_fronts.output.style import ALARM_COLOUR, BLUE, LIGHT_BLUE
from proved_fronts import _shapes, proved_fronts

SHAPES = ("overshoot", "monotone", "critical", "neither")
COLOURS = dict(zip(SHAPES, (BLUE, LIGHT_BLUE, ALARM_COLOUR, "0.75"), strict=True))
WORDS = ["overshoots", "monotone", "one turns into the other", "shape not proved"]


def proofs(alphas, low, high):
    """Certificates of fronts that overshoot, are monotone, are either, and exist."""
    columns = {
        "alpha": alphas,
        "beta": alphas,
        "gamma_low": low,
        "gamma_high": high,
        "error_bound": [1e-8, 1e-7, 1e-6, 1e-5],
        "overshoot_bound": [0.1, np.nan, np.nan, np.nan],
        "oscillates": [1.0, np.nan, np.nan, np.nan],
        "monotone": [np.nan, 1.0, np.nan, np.nan],
        "critical": [np.nan, np.nan, 1.0, np.nan],
    }
    return xr.Dataset({name: ("certificate", values) for name, values in columns.items()})


@pytest.fixture
def fronts():
    gammas = [0.2, 0.3, 0.25, 0.4]
    return proofs([1.5, 2.0, 1.5, 3.0], gammas, gammas)


@pytest.fixture
def intervals():
    return proofs([1.5] * 4, [0.1, 0.2, 0.4, 0.8], [0.2, 0.4, 0.8, 1.0])


@pytest.fixture
def enclosure():
    """A front with errors, a residual, and bounds of its tails, the first lower bound unknown."""
    xi, ahead = np.linspace(-6.0, 4.0, 21), np.array([1.0, 1.5, 2.0, 2.5])
    return xr.Dataset(
        {
            "approximation": ("xi", 0.5 - 0.5 * np.tanh(xi)),
            "error": ("xi", 1e-9 * (2.0 + np.sin(xi))),
            "residual": ("xi", 1e-12 * (2.0 + np.cos(xi))),
            "decay_low": ("xi_ahead", np.exp(ahead)),
            "decay_high": ("xi_ahead", [np.inf, *(1.2 * np.exp(ahead[1:]))]),
        },
        {"xi": xi, "xi_ahead": ahead},
        {"alpha": 1.5, "gamma": 0.3, "rate_low": 0.4, "rate_high": 0.5}
        | {"amplitude_low": 0.6, "amplitude_high": 0.7},
    )


def shown(figure):
    """The panels of a figure, which matplotlib does not keep open."""
    plt.close(figure)
    return {axes.get_label(): axes for axes in figure.axes}


def assert_curve(line, x, y):
    np.testing.assert_array_equal(line.get_xdata(), x)
    np.testing.assert_array_equal(line.get_ydata(), y)


def row_of(axes, alpha):
    """The height of the row with an exponent."""
    return [text.get_text() for text in axes.get_yticklabels()].index(rf"$\alpha = {alpha:g}$")


def test_bars_span_the_proved_intervals_in_the_colours_of_their_shapes(fronts, intervals):
    axes = shown(proved_fronts(fronts, intervals))["shapes"]
    ends = zip(SHAPES, intervals["gamma_low"].values, intervals["gamma_high"].values, strict=True)
    for bar, (shape, low, high) in zip(axes.patches, ends, strict=True):
        np.testing.assert_allclose([bar.get_x(), bar.get_x() + bar.get_width()], [low, high])
        assert bar.get_y() < row_of(axes, 1.5) < bar.get_y() + bar.get_height()
        assert bar.get_facecolor() == to_rgba(COLOURS[shape])


def test_marks_say_what_is_proved_of_shapes_in_rows_of_exponents(fronts, intervals):
    axes = shown(proved_fronts(fronts, intervals))["shapes"]
    marks = [line for line in curves(axes) if np.size(line.get_xdata())]
    found = {(*map(float, line.get_xydata()[0]), line.get_color()) for line in marks}
    assert found == {
        (float(gamma), float(row_of(axes, float(alpha))), COLOURS[shape])
        for gamma, alpha, shape in zip(fronts["gamma_low"], fronts["alpha"], SHAPES, strict=True)
    }
    assert [text.get_text() for text in axes.figure.legends[0].get_texts()] == WORDS


def test_names_of_shapes_are_what_certificates_say(fronts):
    """A certificate that overshoots, or oscillates, is never shown as monotone, nor the reverse."""
    fronts["overshoot_bound"][:], fronts["oscillates"][:] = np.nan, [np.nan, 1.0, np.nan, np.nan]
    fronts["monotone"][:], fronts["critical"][:] = [1.0, np.nan, np.nan, np.nan], np.nan
    assert list(_shapes(fronts)) == ["monotone", "overshoot", "neither", "neither"]


def test_fronts_with_dashpots_are_left_out(fronts, intervals):
    fronts["beta"] = "certificate", [1.0, *fronts["alpha"].values[1:]]
    axes = shown(proved_fronts(fronts, intervals))["shapes"]
    assert sum(line.get_xdata().size for line in curves(axes)) == 3


@pytest.mark.parametrize(
    ("panel", "name"), [("errors", "error_bound"), ("maxima", "overshoot_bound")]
)
def test_bounds_are_lines_of_intervals_and_marks_of_fronts(fronts, intervals, panel, name):
    line, *marks = curves(shown(proved_fronts(fronts, intervals))[panel])
    middles = np.sqrt(intervals["gamma_low"] * intervals["gamma_high"])
    assert_curve(line, middles, intervals[name])
    marks = [mark for mark in marks if mark.get_linestyle() == "None"]
    for mark, alpha in zip(marks, (1.5, 2.0, 3.0), strict=True):
        rows = fronts.isel(certificate=fronts["alpha"].values == alpha)
        assert_curve(mark, rows["gamma_low"], rows[name])


def test_errors_and_both_tails_are_those_of_the_enclosure(enclosure):
    found = shown(enclosed_front(enclosure))
    for line, name in zip(curves(found["errors"]), ("error", "residual"), strict=True):
        assert_curve(line, enclosure["xi"], enclosure[name])
    [*terms, computed] = curves(found["behind"])
    assert_curve(computed, enclosure["xi"], 1 - enclosure["approximation"])
    xi = enclosure["xi"].values[enclosure["xi"].values < 0]
    # Behind the front the slower decay is the larger term.
    assert_curve(terms[0], xi, 0.6 * np.exp(0.5 * xi))
    assert_curve(terms[1], xi, 0.7 * np.exp(0.4 * xi))
    [ahead] = curves(found["ahead"])
    assert np.diff(np.log(ahead.get_ydata())) == pytest.approx([0.5 * np.log(1.5)] * 2)


def test_the_enclosure_is_widened_by_the_factor_that_is_stated(enclosure):
    data, axes = enclosure, shown(enclosed_front(enclosure))["front"]
    [band] = axes.collections
    edges = band.get_paths()[0].vertices
    [words] = (text.get_text() for text in axes.texts)
    stated, factor = re.fullmatch(r"within (\S+) of .*10\^\{(\d+)\}.*", words, re.DOTALL).groups()
    assert data["error"].max() <= float(stated) <= 1.1 * data["error"].max()
    error = 10 ** float(factor) * data["error"].values
    assert 0.03 <= np.median(error) < 0.3
    for sign in (-1, 1):
        for point in zip(
            data["xi"].values, data["approximation"].values + sign * error, strict=True
        ):
            assert np.isclose(edges, point, rtol=1e-12, atol=0).all(axis=1).any()
