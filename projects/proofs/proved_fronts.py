"""Which fronts are proved, over exponent and damping, and what of them."""

from collections.abc import Iterator
from itertools import cycle
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullLocator

from drawing import write_figure
from granular_fronts.output.style import ALARM_COLOUR, BLUE, LIGHT_BLUE, new_figure
from job import job

# What is proved of the shape: in words, its colour, and the mark of a single front.
SHAPES = {
    "overshoot": ("overshoots", BLUE, "v"),
    "monotone": ("monotone", LIGHT_BLUE, "s"),
    "critical": ("one turns into the other", ALARM_COLOUR, "D"),
    "neither": ("shape not proved", "0.75", "o"),
}
THICKNESS = 0.4
# Edges of bars in points: one that hides the seams of intervals, one that shows a narrow interval.
SEAM, CRITICAL_EDGE = 0.3, 1.5
EXPONENT_LOOKS = (("-", "o"), ("--", "s"), ("-.", "^"), (":", "D"))


def proved_fronts(fronts: xr.Dataset, intervals: xr.Dataset) -> Figure:
    """Draw what is proved.

    Parameters
    ----------
    fronts : xarray.Dataset
        Single fronts that are proved; those with β = α are drawn.
    intervals : xarray.Dataset
        Families of fronts that are proved.

    Returns
    -------
    matplotlib.figure.Figure
    """
    fronts = fronts.isel(certificate=fronts["beta"].values == fronts["alpha"].values)
    figure, panels = new_figure(5.4, [["shapes"], ["shapes"], ["errors"], ["maxima"]], sharex=True)
    exponents = np.unique(np.concatenate([fronts["alpha"], intervals["alpha"]]))
    _draw_shapes(panels["shapes"], fronts, intervals, exponents)
    _draw_bounds(panels["errors"], fronts, intervals, exponents, "error_bound")
    _draw_bounds(panels["maxima"], fronts, intervals, exponents, "overshoot_bound")
    title = "proved distance to the computed front, at most"
    panels["errors"].set(title=title, ylabel=r"$|u - \bar u|$")
    title = "proved overshoot, at least"
    panels["maxima"].set(title=title, ylabel=r"$\max u - 1$", xlabel=r"damping $\gamma$")
    lowest, highest = (
        [float(limit(data[end])) for data in (fronts, intervals)]
        for limit, end in ((np.min, "gamma_low"), (np.max, "gamma_high"))
    )
    for axes in panels.values():
        axes.set(xscale="log", xlim=(0.9 * min(lowest), 1.1 * max(highest)))
        axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_locator(NullLocator())
    figure.legend(handles=list(_shape_marks()), loc="outside upper center", ncols=2)
    figure.legend(
        *panels["maxima"].get_legend_handles_labels(), loc="outside lower center", ncols=2
    )
    return figure


def _shapes(data: xr.Dataset) -> np.ndarray:
    """What is proved of the shape, of each certificate."""
    overshoots = np.isfinite(data["overshoot_bound"].values) | (data["oscillates"].values == 1.0)
    known = [overshoots, data["monotone"].values == 1.0, data["critical"].values == 1.0]
    return np.select(known, ["overshoot", "monotone", "critical"], "neither")


def _draw_shapes(
    axes: Axes, fronts: xr.Dataset, intervals: xr.Dataset, exponents: np.ndarray
) -> None:
    """A row for each exponent: bars on intervals of γ, marks of single fronts upon them."""
    for shape, (_, colour, marker) in SHAPES.items():
        bars, marks = (
            data.isel(certificate=_shapes(data) == shape) for data in (intervals, fronts)
        )
        rows = np.searchsorted(exponents, bars["alpha"])
        widths = bars["gamma_high"] - bars["gamma_low"]
        edge = CRITICAL_EDGE if shape == "critical" else SEAM
        look: dict[str, Any] = {"edgecolor": colour, "linewidth": edge, "zorder": 2.0 + edge}
        axes.barh(rows, widths, THICKNESS, left=bars["gamma_low"], color=colour, **look)
        rows = np.searchsorted(exponents, marks["alpha"])
        look = {"markeredgecolor": "white", "markersize": 5, "zorder": 5}
        axes.plot(marks["gamma_low"], rows, marker, linestyle="none", color=colour, **look)
    axes.set_yticks(np.arange(exponents.size), [rf"$\alpha = {alpha:g}$" for alpha in exponents])
    axes.set(ylim=(-0.6, exponents.size - 0.4), title="fronts that are proved to exist")


def _shape_marks() -> Iterator[Line2D]:
    """The meaning of colours and marks."""
    for words, colour, marker in SHAPES.values():
        look: dict[str, Any] = {"color": colour, "markeredgecolor": "white", "markersize": 5}
        yield Line2D([], [], linestyle="-", linewidth=4, marker=marker, label=words, **look)


def _draw_bounds(
    axes: Axes, fronts: xr.Dataset, intervals: xr.Dataset, exponents: np.ndarray, name: str
) -> None:
    """A bound on each interval of γ as a line, and of each front as a mark, by the exponent."""
    for (line, marker), alpha in zip(cycle(EXPONENT_LOOKS), exponents, strict=False):
        family, single = (
            data.isel(certificate=data["alpha"].values == alpha) for data in (intervals, fronts)
        )
        middles = np.sqrt(family["gamma_low"] * family["gamma_high"])
        marks: dict[str, Any] = {"marker": marker, "markersize": 3, "markerfacecolor": "black"}
        label = rf"$\alpha = {alpha:g}$"
        axes.plot(middles, family[name], line, color="0.35", markevery=[], label=label, **marks)
        axes.plot(single["gamma_low"], single[name], linestyle="none", color="black", **marks)
    axes.set_yscale("log")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            proved_fronts,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            fronts=snakemake.input.fronts,
            intervals=snakemake.input.intervals,
        )
