"""Figure 15: errors of the hard cases and their limits, and order through contact events."""

import re

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure

BLUE = PROBE_COLOURS[1]
GREY = "0.55"
SMALLEST_ERROR = 1.0e-17
METHODS = {
    "strain_form": "located",
    "positions_and_w": r"not located, in $(x, w)$",
    "positions_and_velocities": r"not located, in $(x, \dot x)$",
}
MARKERS = ("o", "s", "^")
OPENING = "(b) opening of the contact"


def hard_cases(data: xr.Dataset) -> Figure:
    """Draw all errors against their limits, and errors against steps.

    Parameters
    ----------
    data : xarray.Dataset
        Written by measure_hard_cases.
    """
    height = 2.2 + 0.12 * data.sizes["case"]
    figure, panels = new_figure(height, [["cases", "orders"]])
    _draw_cases(panels["cases"], data)
    _draw_orders(panels["orders"], data)
    methods, names = panels["orders"].get_legend_handles_labels()
    figure.legend(methods, names, loc="outside lower center", title=OPENING, ncols=3)
    return figure


def _draw_cases(axes: Axes, data: xr.Dataset) -> None:
    """Error of each case as a dot, its limit as a bar; failures are red, refusals crosses."""
    places = -np.arange(data.sizes["case"])
    error = np.maximum(data["error"].values, SMALLEST_ERROR)
    passed = data["passed"].values.astype(bool)
    refused = ~np.isfinite(error)
    axes.plot(data["limit"], places, "|", color=GREY, markersize=8, label="limit")
    axes.plot(error[passed], places[passed], "o", color=BLUE, markersize=3.5, label="passed")
    failed = ~passed & ~refused
    axes.plot(error[failed], places[failed], "D", color=ALARM_COLOUR, ms=4, label="failed")
    at_edge = np.full(refused.sum(), SMALLEST_ERROR)
    axes.plot(at_edge, places[refused], "x", color=ALARM_COLOUR, label="no result")
    axes.set_yticks(places, [_label_of(name) for name in data["case"].values], fontsize=7)
    axes.set(xscale="log", xlabel="error", xlim=(0.5 * SMALLEST_ERROR, 1.0e-3))
    axes.set_title("each case and its limit")
    axes.grid(axis="y", linewidth=0.3)
    used = [line for line in axes.get_lines() if np.size(line.get_xdata())]
    axes.legend(handles=used, loc="upper right", handlelength=1)


def _label_of(name: str) -> str:
    """Name of a case for people: gamma_1e_6 is gamma 1e-6, alpha_1_02 is alpha 1.02."""
    name = re.sub(r"(\de)_(\d)", r"\1-\2", name)
    return re.sub(r"(\d)_(\d)", r"\1.\2", name).replace("_", " ")


def _draw_orders(axes: Axes, data: xr.Dataset) -> None:
    """Median error of the parting velocity against the number of steps."""
    for method, colour, marker in zip(METHODS, PROBE_COLOURS, MARKERS, strict=False):
        curve = data.sel(solver=method)
        label = f"{METHODS[method]}: slope {float(curve['observed_order']):.1f}"
        axes.plot(
            curve["event_steps"],
            curve["event_error"],
            linestyle="-",
            color=colour,
            marker=marker,
            markersize=3.5,
            label=label,
        )
    axes.set(xscale="log", yscale="log", xlabel="steps", ylabel="error after a collision")
    axes.set_title("two beads collide")
