"""Figure 23: where fronts are proved in the plane of exponent and damping, and what."""

from typing import Any

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator

from figure_step import run_figure
from granular_fronts.output.panels import draw_critical_damping
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure

SHAPES = {
    "overshoot": ("overshoots", "v", PROBE_COLOURS[3]),
    "monotone": ("monotone", "s", PROBE_COLOURS[5]),
    "critical": ("one turns into the other", "D", ALARM_COLOUR),
    "neither": ("exists", "o", "0.6"),
}
"""What is proved of the shape: in words, the mark of a single front, the colour of a strip."""
COLOURS = matplotlib.colormaps["viridis_r"]
BESIDE = 0.035  # in α, between a bar and the strip of its shapes
DAMPINGS = (0.05, 0.1, 0.2, 0.3, 0.5, 1.0)


def plot_fig23(fronts: xr.Dataset, intervals: xr.Dataset, curves: xr.Dataset) -> Figure:
    """Draw what is proved.

    Parameters
    ----------
    fronts : xarray.Dataset
        Single fronts that are proved; those with β = α are drawn.
    intervals : xarray.Dataset
        Families of fronts that are proved.
    curves : xarray.Dataset
        Critical damping over α.

    Returns
    -------
    matplotlib.figure.Figure
    """
    fronts = fronts.isel(certificate=fronts["beta"].values == fronts["alpha"].values)
    figure, panels = new_figure(4.4, [["plane", "errors"], ["plane", "maxima"]])
    errors = np.concatenate([data["error_bound"].values for data in (fronts, intervals)])
    norm = LogNorm(errors.min(), errors.max())
    _draw_intervals(panels["plane"], intervals, norm)
    _draw_fronts(panels["plane"], fronts, norm)
    draw_critical_damping(panels["plane"], curves, "overshoot", "tail", "long_wave")
    _draw_errors(panels["errors"], intervals, norm)
    _draw_maxima(panels["maxima"], fronts, intervals)
    for name in ("errors", "maxima"):
        panels[name].xaxis.set_major_locator(FixedLocator(DAMPINGS))
        panels[name].xaxis.set_major_formatter("{x:g}")
        panels[name].xaxis.set_minor_locator(NullLocator())
    handles, words = panels["plane"].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=4, fontsize=7)
    return figure


def _shapes(data: xr.Dataset) -> np.ndarray:
    """What is proved of the shape, of each certificate."""
    overshoots = np.isfinite(data["overshoot_bound"].values) | (data["oscillates"].values == 1.0)
    known = [overshoots, data["monotone"].values == 1.0, data["critical"].values == 1.0]
    return np.select(known, ["overshoot", "monotone", "critical"], "neither")


def _draw_intervals(axes: Axes, intervals: xr.Dataset, norm: LogNorm) -> None:
    """A bar for each proved interval of γ, coloured by the error, and a strip for the shape."""
    bars = LineCollection(_uprights(intervals, 0.0), linewidths=7, capstyle="butt", cmap=COLOURS)
    bars.set(array=intervals["error_bound"].values, norm=norm)
    axes.add_collection(bars)
    for shape, (_, _, colour) in SHAPES.items():
        rows = intervals.isel(certificate=_shapes(intervals) == shape)
        looks: dict[str, Any] = {"colors": colour, "linewidths": 2.5, "capstyle": "butt"}
        axes.add_collection(LineCollection(_uprights(rows, BESIDE), **looks))
    label = r"proved bound of $|u - \bar u|$"
    axes.figure.colorbar(bars, ax=axes, location="top", aspect=30, label=label)


def _uprights(rows: xr.Dataset, beside: float) -> list[list[tuple[float, float]]]:
    """The ends of each interval of γ, at its exponent or a little beside."""
    alpha = rows["alpha"].values + beside
    ends = rows["gamma_low"].values, rows["gamma_high"].values
    return [[(x, low), (x, high)] for x, low, high in zip(alpha, *ends, strict=True)]


def _draw_fronts(axes: Axes, fronts: xr.Dataset, norm: LogNorm) -> None:
    """Single fronts, with the words for all shapes."""
    for shape, (words, marker, colour) in SHAPES.items():
        rows = fronts.isel(certificate=_shapes(fronts) == shape)
        errors: dict[str, Any] = {"c": rows["error_bound"], "cmap": COLOURS, "norm": norm}
        edge: dict[str, Any] = {"s": 26, "edgecolors": colour, "linewidths": 1.2, "zorder": 3}
        axes.scatter(rows["alpha"], rows["gamma_low"], marker=marker, **errors, **edge)
        looks: dict[str, Any] = {"linewidth": 2.5, "markersize": 5, "markerfacecolor": "none"}
        axes.plot([], [], "-", color=colour, marker=marker, label=words, **looks)
    axes.set(xlabel=r"$\alpha$", ylabel=r"$\gamma$", yscale="log")
    axes.set(xlim=(1.05, 3.1), ylim=(0.03, 1.6))


def _draw_errors(axes: Axes, intervals: xr.Dataset, norm: LogNorm) -> None:
    """The bound of the error on each interval of γ, one line for each exponent."""
    for colour, alpha in zip(PROBE_COLOURS, np.unique(intervals["alpha"]), strict=False):
        rows = intervals.isel(certificate=intervals["alpha"].values == alpha)
        edges = np.append(rows["gamma_low"].values, rows["gamma_high"].values[-1])
        bounds = np.append(rows["error_bound"].values, rows["error_bound"].values[-1])
        label = rf"$\alpha = {alpha:g}$"
        axes.step(edges, bounds, "-", where="post", color=colour, label=label)
    axes.set(xscale="log", yscale="log", ylabel=r"bound of $|u - \bar u|$")
    axes.set(ylim=(norm.vmin, norm.vmax))
    axes.legend(fontsize=7)


def _draw_maxima(axes: Axes, fronts: xr.Dataset, intervals: xr.Dataset) -> None:
    """By how much max u is proved to exceed 1."""
    for colour, alpha in zip(PROBE_COLOURS, np.unique(intervals["alpha"]), strict=False):
        rows = intervals.isel(certificate=intervals["alpha"].values == alpha)
        middles = np.sqrt(rows["gamma_low"] * rows["gamma_high"])
        axes.plot(middles, rows["overshoot_bound"], color=colour, linestyle="-")
    axes.plot(fronts["gamma_low"], fronts["overshoot_bound"], "kv", markersize=4)
    axes.set(xscale="log", yscale="log", xlabel=r"$\gamma$", ylabel=r"$\max u$ exceeds 1 by")


if __name__ == "__main__":
    run_figure(plot_fig23, globals().get("snakemake"))
