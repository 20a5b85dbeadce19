"""What the panels of the page share."""

from typing import Any

import matplotlib.colors
from bokeh.events import Tap
from bokeh.models import CustomJS, Range1d, Span
from bokeh.plotting import figure
from matplotlib.colors import Colormap

CURSOR_COLOUR = "#b35900"
TOOLS = "box_zoom,reset,save"


def new_panel(name: str, height: int, x_label: str, y_label: str, **options: Any) -> figure:
    """A panel as wide as its place on the page."""
    ranges = {axis: Range1d(0, 1) for axis in ("x_range", "y_range") if axis not in options}
    # A finger that moves over a panel scrolls the page: no tool takes part in a drag unasked.
    panel = figure(
        name=name,
        height=height,
        sizing_mode="stretch_width",
        min_width=100,
        tools=TOOLS,
        active_drag=None,
        x_axis_label=x_label,
        y_axis_label=y_label,
        **ranges,
        **options,
    )
    panel.toolbar.logo = None
    panel.grid.grid_line_color = "#e4e8ec"
    panel.axis.axis_label_text_font_style = "normal"
    return panel


def add_cursor(panel: figure, dimension: str) -> Span:
    """A line across a panel that its script moves, "height" for one that stands upright."""
    line = Span(dimension=dimension, line_color=CURSOR_COLOUR, line_width=1.5)
    panel.add_layout(line)
    return line


def announce_taps(panel: figure) -> None:
    """Let the page hear where a panel is tapped, as the event `tap-NAME`."""
    code = "document.dispatchEvent(new CustomEvent(event, {detail: {x: cb_obj.x, y: cb_obj.y}}))"
    panel.js_on_event(Tap, CustomJS(args={"event": f"tap-{panel.name}"}, code=code))


def palette(colour_map: Colormap) -> list[str]:
    """The colours of a map of the figures."""
    return [matplotlib.colors.to_hex(colour_map(k)) for k in range(colour_map.N)]
