"""Draw figures from their samples, and read what a panel shows: curves, colours, labels."""

import importlib
from functools import cache

import matplotlib.pyplot as plt
import numpy as np
import yaml
from figure_samples import SAMPLES
from projects import ROOT

LISTED = yaml.safe_load((ROOT / "workflow" / "figures.yaml").read_text(encoding="utf-8"))


def draw(figure, datasets):
    """Call the script of a figure; matplotlib does not keep the figure open."""
    name = LISTED[figure].get("script", f"plot_{figure}")
    drawn = getattr(importlib.import_module(name), name)(**datasets)
    plt.close(drawn)
    return drawn


@cache
def sampled(figure):
    """The sample of a figure, and the figure drawn of it, once for all tests."""
    given = SAMPLES[figure]()
    return given, draw(figure, given)


def picture(figure):
    """The datasets of a figure in their order, and its panels by the names the script gives."""
    given, drawn = sampled(figure)
    return *given.values(), panels(drawn)


def panels(figure):
    """Axes by name; colour bars hang on their images."""
    return {axes.get_label(): axes for axes in figure.axes if axes.get_label() != "<colorbar>"}


def curves(axes):
    """Lines and markers that show data, in the order in which they were drawn."""
    return [line for line in axes.get_lines() if line.get_transform() is axes.transData]


def image(axes):
    """The one coloured plane of a panel."""
    [mesh] = [each for each in axes.collections if each.get_array() is not None]
    return mesh


def legend(axes):
    """Entries of the legend of a panel, or else of its figure."""
    found = axes.get_legend() or axes.figure.legends[0]
    return [text.get_text() for text in found.get_texts()]


def annotations(axes):
    """Texts in a panel, without its labels."""
    return [text.get_text() for text in axes.texts]


def assert_curve(line, x, y):
    """A curve shows these numbers, and no others."""
    np.testing.assert_array_equal(line.get_xdata(), x)
    np.testing.assert_array_equal(line.get_ydata(), y)


def assert_plane(axes, values, label):
    """A panel colours these numbers over its abscissa and ordinate, and its colour bar is named."""
    shown = image(axes)
    np.testing.assert_array_equal(np.ma.filled(shown.get_array(), np.nan), values)
    corners = shown.get_coordinates()
    for name, edges in zip(values.dims, (corners[:, 0, 1], corners[0, :, 0]), strict=True):
        assert np.all((edges[:-1] < values[name].values) & (values[name].values < edges[1:]))
    bar = shown.colorbar
    assert (bar.ax.get_xlabel() or bar.ax.get_ylabel()) == label


def assert_labels(axes, x, y):
    """Labels of both axes, which are linear."""
    assert (axes.get_xlabel(), axes.get_ylabel()) == (x, y)
    assert f"{axes.get_xscale()} {axes.get_yscale()}" == "linear linear"
