"""Figures 23 and 24: what is proved of fronts, and nothing that is not."""

import numpy as np
from figure_samples import SAMPLES
from matplotlib.collections import LineCollection, PathCollection
from pictures import assert_curve, assert_labels, curves, draw, legend, panels, picture


def test_figure_23_bars_span_the_proved_intervals():
    _, intervals, _, panels = picture("fig23")
    axes = panels["plane"]
    bars, *strips = (each for each in axes.collections if isinstance(each, LineCollection))
    ends = np.stack([intervals["gamma_low"], intervals["gamma_high"]], axis=1)
    segments = np.array(bars.get_segments())
    np.testing.assert_array_equal(segments[:, :, 1], ends)
    np.testing.assert_array_equal(segments[:, :, 0], 1.5)
    np.testing.assert_array_equal(bars.get_array(), intervals["error_bound"])
    assert_labels(axes, r"$\alpha$", r"$\gamma$", "linear log")
    # Each strip has a colour of its own, and stands beside the interval of its shape.
    assert len({tuple(strip.get_color()[0]) for strip in strips}) == len(strips) == 4
    for strip, row in zip(strips, ends, strict=True):
        [segment] = strip.get_segments()
        np.testing.assert_array_equal(segment[:, 1], row)
        assert segment[0, 0] == segment[1, 0] > 1.5


def test_figure_23_marks_fronts_by_what_is_proved_of_their_shape():
    fronts, _, curves_of_damping, panels = picture("fig23")
    axes = panels["plane"]
    marks = [each for each in axes.collections if isinstance(each, PathCollection)]
    for row, mark in enumerate(marks):
        place = [[float(fronts["alpha"][row]), float(fronts["gamma_low"][row])]]
        np.testing.assert_array_equal(mark.get_offsets(), place)
        np.testing.assert_array_equal(mark.get_array(), [float(fronts["error_bound"][row])])
    words = ["overshoots", "monotone", "one turns into the other", "exists"]
    assert legend(axes)[:4] == words
    lines = [line for line in curves(axes) if np.size(line.get_xdata())]
    for line, name in zip(lines, ("overshoot", "tail", "long_wave"), strict=True):
        values = curves_of_damping[f"critical_damping_{name}"]
        assert_curve(line, curves_of_damping["alpha"], values)


def test_figure_23_leaves_out_fronts_with_dashpots():
    samples = SAMPLES["fig23"]()
    samples["fronts"]["beta"] = "certificate", [1.0, *samples["fronts"]["alpha"].values[1:]]
    axes = panels(draw("fig23", samples))["plane"]
    marks = [each for each in axes.collections if isinstance(each, PathCollection)]
    assert [len(mark.get_offsets()) for mark in marks] == [0, 1, 1, 1]


def test_figure_23_shows_bounds_of_errors_and_maxima_over_the_damping():
    fronts, intervals, _, panels = picture("fig23")
    [steps] = curves(panels["errors"])
    assert_curve(steps, [0.1, 0.2, 0.4, 0.8, 1.0], [1e-8, 1e-7, 1e-6, 1e-5, 1e-5])
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
    assert 0.03 <= np.median(error) < 0.3
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
    np.testing.assert_allclose(high.get_ydata(), 0.7 * np.exp(0.4 * behind), rtol=1e-14)
    assert_curve(gap, data["xi"], 1 - data["approximation"])
    [slope] = curves(panels["ahead"])
    # The first place, where nothing is known from below, is not drawn.
    np.testing.assert_array_equal(slope.get_xdata(), [1.5, 2.0, 2.5])
    start = float(data["decay_low"][1])
    np.testing.assert_allclose(slope.get_ydata(), start * 1.5 ** np.array([0, 0.5, 1]), rtol=1e-14)
    assert_labels(panels["ahead"], r"$\xi$", r"$-\ln u$", "linear log")
