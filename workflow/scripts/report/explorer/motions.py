"""Motions of chains and rings over space and time: their data for the page, and their panels."""

from typing import Any

import numpy as np
import xarray as xr
from bokeh.models import ColorBar, ColumnDataSource, HoverTool, LinearColorMapper
from bokeh.plotting import figure

from explorer.encoding import encode
from explorer.panels import add_cursor, announce_taps, new_panel, palette
from granular_fronts.output.panels import contacts_open
from granular_fronts.output.style import ALARM_COLOUR, CHAIN_COLOUR, compression_map, velocity_map

FIELDS = ("relative_displacement", "velocity")


def motion_for_page(data: xr.Dataset) -> dict[str, Any]:
    """Return what the script of the motions is given of one."""
    velocity = data["velocity_grid"]
    return {
        "times": data["t_grid"].values.astype(float),
        "beads": int(data.sizes["bead"]),
        "opens": contacts_open(data),
        # Colours and axes go this far; gaps may be much wider.
        "largest": float(data["relative_displacement_grid"].max()),
        "slowest": float(velocity.min()),
        "fastest": float(velocity.max()),
    } | {
        field: encode(values) | {"error": float(values.attrs["error_estimate"])}
        for field in FIELDS
        for values in [data[f"{field}_grid"]]
    }


def draw_motions(motions: dict[str, Any]) -> tuple[list[figure], dict[str, Any]]:
    """Draw the panels of the motions; return them and what their script is given."""
    profile = ColumnDataSource({"n": [], "u": [], "v": []})
    gaps = ColumnDataSource({"n": [], "u": []})
    compression = _draw_profile("relative_displacement", "relative displacement uₙ", "u", profile)
    compression.scatter(
        "n", "u", source=gaps, marker="inverted_triangle", size=6, color=ALARM_COLOUR
    )
    speed = _draw_profile("velocity", "velocity ẋₙ", "v", profile)
    speed.x_range = compression.x_range
    beads, bead_arguments = _draw_beads()
    spacetime, spacetime_arguments = _draw_spacetime()
    panels = [beads, compression, speed, spacetime]
    cursors = [add_cursor(panel, "height") for panel in panels[1:]]
    return panels, {
        "motions": motions,
        "panels": {panel.name: panel for panel in panels},
        "profile": profile,
        "gaps": gaps,
        "bead_cursors": cursors,
        "time_cursor": add_cursor(spacetime, "width"),
        **bead_arguments,
        **spacetime_arguments,
    }


def _draw_profile(name: str, label: str, field: str, source: ColumnDataSource) -> figure:
    """One field along the chain at one time."""
    panel = new_panel(name, 220, "bead n", label)
    panel.line("n", field, source=source, color=CHAIN_COLOUR, line_width=1)
    dots = panel.scatter("n", field, source=source, size=3, color=CHAIN_COLOUR)
    panel.add_tools(
        HoverTool(renderers=[dots], tooltips=[("n", "@n"), (label, f"@{field}{{0.0000}}")])
    )
    return panel


def _draw_beads() -> tuple[figure, dict[str, Any]]:
    """Beads near the cursor as discs coloured by velocity, and lines across gaps."""
    colours = LinearColorMapper(palette=palette(velocity_map()), low=0, high=1)
    beads = ColumnDataSource({"x": [], "n": [], "v": [], "edge": []})
    openings = ColumnDataSource({"start": [], "stop": []})
    panel = new_panel("beads", 150, "place, in bead diameters", "", y_range=(-0.8, 0.8))
    panel.yaxis.visible = False
    panel.ygrid.visible = False
    discs = panel.circle(
        "x",
        0,
        radius=0.5,
        source=beads,
        fill_color={"field": "v", "transform": colours},
        fill_alpha=0.75,
        line_color="edge",
        line_width=1.5,
    )
    panel.segment(
        "start", 0, "stop", 0, source=openings, color=ALARM_COLOUR, line_width=3, line_dash="dotted"
    )
    panel.add_tools(HoverTool(renderers=[discs], tooltips=[("bead", "@n"), ("velocity", "@v")]))
    return panel, {"beads": beads, "openings": openings, "bead_colours": colours}


def _draw_spacetime() -> tuple[figure, dict[str, Any]]:
    """A field over bead number and time, gaps in a colour of their own."""
    colours = LinearColorMapper(palette=palette(compression_map()), low=0, high=1)
    # One value, so that the script knows the type of a picture.
    blank = np.zeros((1, 1), dtype=np.float32)
    picture = ColumnDataSource({"image": [blank], "x": [0], "y": [0], "dw": [1], "dh": [1]})
    panel = new_panel("spacetime", 420, "bead n", "time t")
    panel.image("image", x="x", y="y", dw="dw", dh="dh", source=picture, color_mapper=colours)
    panel.add_layout(ColorBar(color_mapper=colours, height=10, title_standoff=4), "above")
    announce_taps(panel)
    looks = {
        "relative_displacement": {
            "palette": palette(compression_map()),
            "low_color": ALARM_COLOUR,
        },
        "velocity": {"palette": palette(velocity_map()), "low_color": None},
    }
    return panel, {"picture": picture, "colours": colours, "looks": looks}
