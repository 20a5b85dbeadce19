"""Figures 23 and 24: what no curve shows, bars, strips, marks and bands."""

import numpy as np
from figure_samples import SAMPLES
from matplotlib.collections import LineCollection, PathCollection
from pictures import draw, legend, panels, picture


def test_figure_23_bars_span_the_proved_intervals():
    _, intervals, _, panels = picture("fig23")
    axes = panels["plane"]
    bars, *strips = (each for each in axes.collections if isinstance(each, LineCollection))
    ends = np.stack([intervals["gamma_low"], intervals["gamma_high"]], axis=1)
    segments = np.array(bars.get_segments())
    np.testing.assert_array_equal(segments[:, :, 1], ends)
    np.testing.assert_array_equal(segments[:, :, 0], 1.5)
    np.testing.assert_array_equal(bars.get_array(), intervals["error_bound"])
    # Each strip has a colour of its own, and stands beside the interval of its shape.
    assert len({tuple(strip.get_color()[0]) for strip in strips}) == len(strips) == 4
    for strip, row in zip(strips, ends, strict=True):
        [segment] = strip.get_segments()
        np.testing.assert_array_equal(segment[:, 1], row)
        assert segment[0, 0] == segment[1, 0] > 1.5


def test_figure_23_marks_fronts_by_what_is_proved_of_their_shape():
    fronts, _, _, panels = picture("fig23")
    axes = panels["plane"]
    marks = [each for each in axes.collections if isinstance(each, PathCollection)]
    for row, mark in enumerate(marks):
        place = [[float(fronts["alpha"][row]), float(fronts["gamma_low"][row])]]
        np.testing.assert_array_equal(mark.get_offsets(), place)
        np.testing.assert_array_equal(mark.get_array(), [float(fronts["error_bound"][row])])
    assert legend(axes)[:4] == ["overshoots", "monotone", "one turns into the other", "exists"]


def test_figure_23_leaves_out_fronts_with_dashpots():
    samples = SAMPLES["fig23"]()
    samples["fronts"]["beta"] = "certificate", [1.0, *samples["fronts"]["alpha"].values[1:]]
    axes = panels(draw("fig23", samples))["plane"]
    marks = [each for each in axes.collections if isinstance(each, PathCollection)]
    assert [len(mark.get_offsets()) for mark in marks] == [0, 1, 1, 1]


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
