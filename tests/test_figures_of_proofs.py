"""Figures 23 and 24: what is proved of fronts, and nothing that is not."""

import numpy as np
from matplotlib.collections import LineCollection
from pictures import assert_curve, assert_labels, curves, legend, picture


def bars(axes):
    """Collections of bars: of fronts that overshoot, of monotone ones, and of others."""
    return [each for each in axes.collections if isinstance(each, LineCollection)]


def test_figure_23_bars_span_the_proved_intervals():
    _, intervals, _, panels = picture("fig23")
    axes = panels["plane"]
    for row, drawn in enumerate(bars(axes)):
        one = intervals.isel(certificate=row)
        [segment] = drawn.get_segments()
        low, high = float(one["gamma_low"]), float(one["gamma_high"])
        np.testing.assert_array_equal(segment, [[1.5, low], [1.5, high]])
        np.testing.assert_array_equal(drawn.get_array(), [float(one["error_bound"])])
    widths = [each.get_linewidths()[0] for each in bars(axes)]
    assert widths[0] == widths[1] > widths[2]
    assert_labels(axes, r"$\alpha$", r"$\gamma$", "linear log")


def test_figure_23_marks_fronts_by_what_is_proved_of_their_shape():
    fronts, _, curves_of_damping, panels = picture("fig23")
    axes = panels["plane"]
    words = ["overshoots", "monotone", "exists"]
    marks = {each.get_label(): each for each in axes.collections if each.get_label() in words}
    for row, word in enumerate(words):
        np.testing.assert_array_equal(
            marks[word].get_offsets(),
            [[float(fronts["alpha"][row]), float(fronts["gamma_low"][row])]],
        )
    assert legend(axes)[:3] == words
    for line, name in zip(curves(axes), ("overshoot", "tail", "long_wave"), strict=True):
        values = curves_of_damping[f"critical_damping_{name}"]
        assert_curve(line, curves_of_damping["alpha"], values)


def test_figure_23_shows_bounds_of_errors_and_maxima_over_the_damping():
    fronts, intervals, _, panels = picture("fig23")
    [steps] = panels["errors"].patches
    values, edges, _ = steps.get_data()
    np.testing.assert_array_equal(values, intervals["error_bound"])
    np.testing.assert_array_equal(edges, [0.1, 0.2, 0.4, 0.8])
    assert legend(panels["errors"]) == [r"$\alpha = 1.5$"]
    families, single = curves(panels["maxima"])
    assert_curve(single, fronts["gamma_low"], fronts["overshoot_bound"])
    np.testing.assert_array_equal(families.get_ydata(), intervals["overshoot_bound"])


def test_figure_24_widens_the_enclosure_by_the_factor_that_it_states():
    data, panels = picture("fig24")
    axes = panels["front"]
    [band] = axes.collections
    edges = band.get_paths()[0].vertices
    factor = float(axes.get_title().split("10^{")[1].split("}")[0])
    error = 10**factor * data["error"].values
    assert 0.03 <= error.max() < 0.3
    for sign in (-1, 1):
        for point in zip(
            data["xi"].values, data["approximation"].values + sign * error, strict=True
        ):
            assert np.isclose(edges, point, rtol=1e-12, atol=0).all(axis=1).any()
    [line] = curves(axes)
    assert_curve(line, data["xi"], data["approximation"])


def test_figure_24_shows_bounds_of_errors_and_of_both_tails():
    data, panels = picture("fig24")
    error, residual = curves(panels["errors"])
    assert_curve(error, data["xi"], data["error"])
    assert_curve(residual, data["xi"], data["residual"])
    low, high, gap = curves(panels["behind"])
    behind = data["xi"].values[data["xi"].values < 0]
    np.testing.assert_allclose(low.get_ydata(), 0.6 * np.exp(0.5 * behind), rtol=1e-14)
    np.testing.assert_allclose(high.get_ydata(), 0.7 * np.exp(0.5 * behind), rtol=1e-14)
    assert_curve(gap, data["xi"], 1 - data["approximation"])
    [slope] = curves(panels["ahead"])
    # The first place, where nothing is known from below, is not drawn.
    np.testing.assert_array_equal(slope.get_xdata(), [1.5, 2.0, 2.5])
    start = float(data["decay_low"][1])
    np.testing.assert_allclose(slope.get_ydata(), start * 1.5 ** np.array([0, 0.5, 1]), rtol=1e-14)
    assert_labels(panels["ahead"], r"$\xi$", r"$-\ln u$", "linear log")
