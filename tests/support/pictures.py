"""What a panel shows: curves, colours, labels."""

import numpy as np


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
