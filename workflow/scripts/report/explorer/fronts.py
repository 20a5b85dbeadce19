"""Exact fronts over exponent and damping: their data for the page, and their panels."""

from typing import Any

import numpy as np
import xarray as xr
from bokeh.models import (
    ColorBar,
    ColumnDataSource,
    DataRange1d,
    HoverTool,
    LogColorMapper,
    LogTicker,
)
from bokeh.palettes import Viridis256
from bokeh.plotting import figure

from explorer.encoding import encode
from explorer.panels import CURSOR_COLOUR, announce_taps, new_panel
from granular_fronts.output.style import (
    ALARM_COLOUR,
    CHAIN_COLOUR,
    CONTINUUM_LOOKS,
    PROBE_COLOURS,
)

DASHES = dict(zip(CONTINUUM_LOOKS, ("dashed", "dotdash", "dotted"), strict=True))
CURVES = {
    "tail": ("tail turns real", PROBE_COLOURS[0], "solid"),
    "double_root": ("double root", PROBE_COLOURS[4], "dotted"),
    "long_wave": ("long waves, μ = 2", PROBE_COLOURS[1], "dashed"),
}
READINGS = (
    "overshoot",
    "width_10_90",
    "error",
    "beads_behind",
    "translation_defect",
    *(f"distance_{name}" for name in CONTINUUM_LOOKS),
    "tail_root_real",
    "tail_root_imaginary",
)
MULTIPLIERS = ("multiplier_real", "multiplier_imaginary")
CONTINUUM = tuple(f"relative_displacement_{name}" for name in CONTINUUM_LOOKS)
DISPLACEMENTS = ("relative_displacement", *CONTINUUM)
SMALLEST_OVERSHOOT = 1e-6


def fronts_for_page(collection: xr.Dataset) -> dict[str, Any]:
    """Return what the script of the fronts is given, a row for each front, α after α."""
    rows = {
        name: variable.values.reshape(-1, *variable.shape[2:])
        for name, variable in collection.variables.items()
        if variable.dims[:2] == ("alpha", "gamma")
    }
    return {
        "alpha": collection["alpha"].values,
        "gamma": collection["gamma"].values,
        "first": np.ascontiguousarray(rows["xi"][:, 0]),
        "last": np.ascontiguousarray(rows["xi"][:, -1]),
        "verdict": rows["verdict"].tolist(),
        **{name: rows[name] for name in READINGS},
        **{name: encode(rows[name]) for name in (*DISPLACEMENTS, *MULTIPLIERS)},
    }


def draw_fronts(fronts: dict[str, Any], plane: xr.Dataset) -> tuple[list[figure], dict[str, Any]]:
    """Draw the panels of the fronts; return them and what their script is given."""
    atlas, chosen = _draw_atlas(fronts, plane)
    front, curves = _draw_profile()
    tail, roots = _draw_complex("tail", "Re λ", "Im λ")
    square = {"x_range": DataRange1d(), "y_range": DataRange1d(), "match_aspect": True}
    spectrum, multipliers = _draw_complex("spectrum", "Re z", "Im z", **square)
    circle = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 181))
    spectrum.line(circle.real, circle.imag, color="#8a949e", line_width=1)
    return [atlas, front, tail, spectrum], {
        "fronts": fronts,
        "front_panel": front,
        "tail_panel": tail,
        "chosen": chosen,
        "curves": curves,
        "roots": roots,
        "multipliers": multipliers,
    }


def _draw_atlas(fronts: dict[str, Any], plane: xr.Dataset) -> tuple[figure, ColumnDataSource]:
    """Overshoot over the plane, curves of critical damping, and the fronts to choose from."""
    alpha, gamma = plane["alpha"].values, plane["gamma"].values
    step, ratio = alpha[1] - alpha[0], np.sqrt(gamma[1] / gamma[0])
    bottom, top = gamma[0] / ratio, gamma[-1] * ratio
    left, right = alpha[0] - 0.5 * step, alpha[-1] + 0.5 * step
    panel = new_panel(
        "atlas",
        420,
        "exponent α",
        "damping γ",
        x_range=(min(left, fronts["alpha"].min()), max(right, fronts["alpha"].max())),
        y_range=(min(bottom, fronts["gamma"].min()), max(top, fronts["gamma"].max())),
        y_axis_type="log",
    )
    colours = LogColorMapper(
        palette=Viridis256[::-1], low=SMALLEST_OVERSHOOT, high=1.0, nan_color=ALARM_COLOUR
    )
    # A logarithmic scale has no colour for 0, the overshoot of a monotone front.
    overshoot = plane["overshoot"].transpose("gamma", "alpha").clip(min=0.5 * SMALLEST_OVERSHOOT)
    panel.image(
        [overshoot.values.astype(np.float32)],
        x=left,
        y=bottom,
        dw=right - left,
        dh=top - bottom,
        color_mapper=colours,
    )
    for name, (label, colour, dash) in CURVES.items():
        critical = plane[f"critical_damping_{name}"].values
        panel.line(alpha, critical, legend_label=label, color=colour, line_dash=dash, line_width=2)
    places = np.meshgrid(fronts["alpha"], fronts["gamma"])
    panel.scatter(places[0].ravel(), places[1].ravel(), size=2, color="white", line_color="#444")
    chosen = ColumnDataSource({"alpha": [], "gamma": []})
    panel.scatter(
        "alpha",
        "gamma",
        source=chosen,
        size=14,
        fill_color=None,
        line_color=CURSOR_COLOUR,
        line_width=3,
    )
    bar = ColorBar(color_mapper=colours, ticker=LogTicker(), height=10, title="overshoot of u")
    panel.add_layout(bar, "above")
    panel.legend.location = "top_right"
    panel.legend.background_fill_alpha = 0.85
    panel.yaxis.ticker = _ticks_between(panel.y_range.start, panel.y_range.end)
    announce_taps(panel)
    return panel, chosen


def _ticks_between(low: float, high: float) -> list[float]:
    """1, 2 and 5 times the powers of ten between two numbers."""
    powers = 10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    ticks = np.outer(powers, (1.0, 2.0, 5.0)).ravel()
    return [float(f"{tick:.0e}") for tick in ticks if low <= tick <= high]


def _draw_profile() -> tuple[figure, ColumnDataSource]:
    """The exact front and the continuum fronts."""
    source = ColumnDataSource({name: [] for name in ("xi", "exact", *CONTINUUM_LOOKS)})
    panel = new_panel("front", 420, "ξ = n − ct", "relative displacement u", y_range=(-0.1, 1.9))
    lines = [
        panel.line(
            "xi", "exact", source=source, color=CHAIN_COLOUR, line_width=2.5, legend_label="exact"
        )
    ]
    for name, (label, colour, _) in CONTINUUM_LOOKS.items():
        look = {"color": colour, "line_dash": DASHES[name], "line_width": 2, "legend_label": label}
        lines.append(panel.line("xi", name, source=source, **look))
    panel.legend.click_policy = "hide"
    panel.legend.location = "top_right"
    tooltips = [("ξ", "@xi"), ("exact", "@exact")]
    tooltips += [(look[0], f"@{name}") for name, look in CONTINUUM_LOOKS.items()]
    panel.add_tools(HoverTool(renderers=lines[:1], tooltips=tooltips, mode="vline"))
    return panel, source


def _draw_complex(
    name: str, x_label: str, y_label: str, **options: Any
) -> tuple[figure, ColumnDataSource]:
    """Numbers in the complex plane."""
    source = ColumnDataSource({"real": [], "imaginary": []})
    panel = new_panel(name, 380, x_label, y_label, **options)
    dots = panel.scatter(
        "real", "imaginary", source=source, size=7, fill_color=None, line_color=CHAIN_COLOUR
    )
    tooltips = [(x_label, "@real{0.0000}"), (y_label, "@imaginary{0.0000}")]
    panel.add_tools(HoverTool(renderers=[dots], tooltips=tooltips))
    return panel, source
