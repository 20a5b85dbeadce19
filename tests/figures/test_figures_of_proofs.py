"""Figures 23 and 24: what no curve shows, bars, marks and bands."""

import re

import numpy as np
from figure_samples import SAMPLES
from matplotlib.colors import to_rgba
from pictures import annotations, curves, draw, legend, panels, picture
from plot_fig23 import _shapes

from granular_fronts.output.style import ALARM_COLOUR, BLUE, LIGHT_BLUE

SHAPES = ("overshoot", "monotone", "critical", "neither")
COLOURS = dict(zip(SHAPES, (BLUE, LIGHT_BLUE, ALARM_COLOUR, "0.75"), strict=True))
WORDS = ["overshoots", "monotone", "one turns into the other", "shape not proved"]


def row_of(axes, alpha):
    """The height of the row with an exponent."""
    return [text.get_text() for text in axes.get_yticklabels()].index(rf"$\alpha = {alpha:g}$")


def test_figure_23_bars_span_the_proved_intervals_in_the_colours_of_their_shapes():
    _, intervals, panels = picture("fig23")
    axes = panels["shapes"]
    ends = zip(SHAPES, intervals["gamma_low"].values, intervals["gamma_high"].values, strict=True)
    for bar, (shape, low, high) in zip(axes.patches, ends, strict=True):
        np.testing.assert_allclose([bar.get_x(), bar.get_x() + bar.get_width()], [low, high])
        assert bar.get_y() < row_of(axes, 1.5) < bar.get_y() + bar.get_height()
        assert bar.get_facecolor() == to_rgba(COLOURS[shape])


def test_figure_23_marks_fronts_by_what_is_proved_of_their_shape_in_the_row_of_their_exponent():
    fronts, _, panels = picture("fig23")
    axes = panels["shapes"]
    marks = [line for line in curves(axes) if np.size(line.get_xdata())]
    found = {(*map(float, line.get_xydata()[0]), line.get_color()) for line in marks}
    assert found == {
        (float(gamma), float(row_of(axes, float(alpha))), COLOURS[shape])
        for gamma, alpha, shape in zip(fronts["gamma_low"], fronts["alpha"], SHAPES, strict=True)
    }
    assert legend(axes) == WORDS


def test_figure_23_names_of_shapes_are_what_certificates_say():
    """A certificate that overshoots, or oscillates, is never shown as monotone, nor the reverse."""
    data = SAMPLES["fig23"]()["fronts"]
    data["overshoot_bound"][:], data["oscillates"][:] = np.nan, [np.nan, 1.0, np.nan, np.nan]
    data["monotone"][:], data["critical"][:] = [1.0, np.nan, np.nan, np.nan], np.nan
    assert list(_shapes(data)) == ["monotone", "overshoot", "neither", "neither"]


def test_figure_23_leaves_out_fronts_with_dashpots():
    samples = SAMPLES["fig23"]()
    samples["fronts"]["beta"] = "certificate", [1.0, *samples["fronts"]["alpha"].values[1:]]
    axes = panels(draw("fig23", samples))["shapes"]
    assert sum(line.get_xdata().size for line in curves(axes)) == 3


def test_figure_24_widens_the_enclosure_by_the_factor_that_it_states():
    data, panels = picture("fig24")
    axes = panels["front"]
    [band] = axes.collections
    edges = band.get_paths()[0].vertices
    [words] = annotations(axes)
    stated, factor = re.fullmatch(r"within (\S+) of .*10\^\{(\d+)\}.*", words, re.DOTALL).groups()
    assert data["error"].max() <= float(stated) <= 1.1 * data["error"].max()
    error = 10 ** float(factor) * data["error"].values
    assert 0.03 <= np.median(error) < 0.3
    for sign in (-1, 1):
        for point in zip(
            data["xi"].values, data["approximation"].values + sign * error, strict=True
        ):
            assert np.isclose(edges, point, rtol=1e-12, atol=0).all(axis=1).any()
