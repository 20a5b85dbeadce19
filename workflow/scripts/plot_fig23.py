"""Figure 23: where fronts are proved in the plane of exponent and damping, and what."""

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure

CURVES = {
    "overshoot": ("fronts overshoot below", PROBE_COLOURS[0], "-"),
    "tail": ("tail turns real", PROBE_COLOURS[4], (0, (3, 1))),
    "long_wave": (r"long waves, $\mu = 2$", PROBE_COLOURS[1], (0, (6, 1.5))),
}
MARKERS = {"overshoot": "v", "monotone": "s", "neither": "o"}
WORDS = {"overshoot": "overshoots", "monotone": "monotone", "neither": "exists"}
COLOURS = matplotlib.colormaps["viridis_r"]


def plot_fig23(fronts: xr.Dataset, intervals: xr.Dataset, curves: xr.Dataset) -> Figure:
    """Draw what is proved.

    Parameters
    ----------
    fronts : xarray.Dataset
        Single fronts that are proved.
    intervals : xarray.Dataset
        Families of fronts that are proved.
    curves : xarray.Dataset
        Critical damping over α.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.9, [["plane", "errors"], ["plane", "maxima"]])
    errors = np.concatenate([data["error_bound"].values for data in (fronts, intervals)])
    norm = LogNorm(errors.min(), errors.max())
    draw_plane(panels["plane"], fronts, intervals, norm)
    draw_curves(panels["plane"], curves)
    draw_errors(panels["errors"], intervals, norm)
    draw_maxima(panels["maxima"], fronts, intervals)
    return figure


def kinds(data: xr.Dataset) -> np.ndarray:
    """What is proved of the shape, of each certificate."""
    overshoots, monotone = (
        np.isfinite(data["overshoot_bound"].values),
        data["monotone"].values == 1.0,
    )
    return np.select([overshoots, monotone], ["overshoot", "monotone"], "neither")


def draw_plane(axes: Axes, fronts: xr.Dataset, intervals: xr.Dataset, norm: LogNorm) -> None:
    """Bars over the proved intervals of γ, thin where the shape is not known; single fronts."""
    for kind, width in (("overshoot", 7.0), ("monotone", 7.0), ("neither", 2.5)):
        rows = intervals.isel(certificate=kinds(intervals) == kind)
        ends = zip(
            rows["alpha"].values, rows["gamma_low"].values, rows["gamma_high"].values, strict=True
        )
        bars = LineCollection(
            [[(alpha, low), (alpha, high)] for alpha, low, high in ends],
            array=rows["error_bound"].values,
            cmap=COLOURS,
            norm=norm,
            linewidths=width,
            capstyle="butt",
        )
        axes.add_collection(bars)
    for kind, marker in MARKERS.items():
        rows = fronts.isel(certificate=kinds(fronts) == kind)
        axes.scatter(
            rows["alpha"],
            rows["gamma_low"],
            c=rows["error_bound"],
            cmap=COLOURS,
            norm=norm,
            marker=marker,
            s=26,
            edgecolors="black",
            linewidths=0.7,
            zorder=3,
            label=WORDS[kind],
        )
    axes.figure.colorbar(
        bars, ax=axes, location="top", aspect=30, label=r"proved bound of $|u - \bar u|$"
    )
    axes.set(
        xlabel=r"$\alpha$", ylabel=r"$\gamma$", yscale="log", xlim=(1.05, 3.1), ylim=(0.025, 1.6)
    )


def draw_curves(axes: Axes, curves: xr.Dataset) -> None:
    """Critical damping as it is computed, which nothing here proves."""
    for name, (label, colour, style) in CURVES.items():
        values = curves[f"critical_damping_{name}"]
        axes.plot(curves["alpha"], values, color=colour, linestyle=style, linewidth=1, label=label)
    axes.legend(fontsize=6.5, loc="lower right", ncols=2)


def draw_errors(axes: Axes, intervals: xr.Dataset, norm: LogNorm) -> None:
    """The bound of the error on each interval of γ, one line for each exponent."""
    for colour, alpha in zip(PROBE_COLOURS, np.unique(intervals["alpha"]), strict=False):
        rows = intervals.isel(certificate=intervals["alpha"].values == alpha)
        edges = np.append(rows["gamma_low"].values, rows["gamma_high"].values[-1])
        axes.stairs(
            rows["error_bound"].values,
            edges,
            baseline=None,
            color=colour,
            label=rf"$\alpha = {alpha:g}$",
        )
    axes.set(
        xscale="log", yscale="log", ylabel=r"bound of $|u - \bar u|$", ylim=(norm.vmin, norm.vmax)
    )
    axes.legend(fontsize=7)


def draw_maxima(axes: Axes, fronts: xr.Dataset, intervals: xr.Dataset) -> None:
    """By how much max u is proved to exceed 1."""
    for colour, alpha in zip(PROBE_COLOURS, np.unique(intervals["alpha"]), strict=False):
        rows = intervals.isel(certificate=intervals["alpha"].values == alpha)
        middles = np.sqrt(rows["gamma_low"] * rows["gamma_high"])
        axes.plot(middles, rows["overshoot_bound"], color=colour, linestyle="-")
    axes.plot(fronts["gamma_low"], fronts["overshoot_bound"], "kv", markersize=4)
    axes.set(xscale="log", yscale="log", xlabel=r"$\gamma$", ylabel=r"$\max u$ exceeds 1 by")


if __name__ == "__main__":
    run_figure(plot_fig23, globals().get("snakemake"))
