"""Figure 14: time against error of all methods on every problem."""

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator

from figure_step import run_figure
from granular_fronts.output.style import PACKAGE_COLOURS, fill_rows, new_figure

COLUMNS = 3
PANEL_HEIGHT = 2.3
MOST_TICKS = 6
MARKERS = "osD^vPX<>*"
# Double precision resolves nothing further left.
SMALLEST_ERROR = 1e-17


def plot_fig14(data: xr.Dataset) -> Figure:
    """Draw a panel for each problem.

    Parameters
    ----------
    data : xarray.Dataset
        Written by merge_precision.

    Returns
    -------
    matplotlib.figure.Figure
    """
    problems = [str(problem) for problem in data["problem"].values]
    rows = fill_rows(problems, COLUMNS)
    figure, panels = new_figure(PANEL_HEIGHT * len(rows) + 1.0, rows)
    looks = choose_looks(data)
    for problem in problems:
        draw_problem(panels[problem], data.sel(problem=problem), looks)
    for row in rows:
        panels[row[0]].set_ylabel("seconds")
    figure.legend(
        handles=[Line2D([], [], label=label(method), **look) for method, look in looks.items()],
        loc="outside lower center",
        ncols=4,
        fontsize=6.5,
        handlelength=2.0,
    )
    note = missing(data)
    if note:
        figure.supxlabel(note, fontsize=6.5)
    return figure


def choose_looks(data: xr.Dataset) -> dict[str, dict[str, Any]]:
    """Line and marker of every method: a colour for each package, ours in black and heavier."""
    looks: dict[str, dict[str, Any]] = {}
    used: dict[str, int] = {}
    ours = set(data["own_method"].values)
    for method in map(str, data["method"].values):
        colour = PACKAGE_COLOURS.get(method.split("_")[0], PACKAGE_COLOURS["ours"])
        index = used.setdefault(colour, 0)
        used[colour] += 1
        looks[method] = {
            "color": colour,
            "marker": MARKERS[index % len(MARKERS)],
            "linestyle": "-" if method in ours or colour != PACKAGE_COLOURS["ours"] else ":",
            "linewidth": 1.6 if method in ours else 0.8,
            "markersize": 4.0 if method in ours else 3.0,
        }
    return looks


def label(method: str) -> str:
    """Name of a method as it is read."""
    return method.replace("_", " ")


def draw_problem(axes: Axes, data: xr.Dataset, looks: dict[str, dict[str, Any]]) -> None:
    """Curves of one problem, the error of its reference, and who failed."""
    for method, look in looks.items():
        chosen = data.sel({"method": method})
        chosen = chosen.isel(tolerance=np.argsort(-chosen["tolerance"].values))
        chosen = chosen.isel(tolerance=np.flatnonzero(np.isfinite(chosen["error"])))
        disturbed = chosen["disturbed"].values == 1.0
        axes.loglog(chosen["error"], chosen["seconds"], **look)
        axes.loglog(
            chosen["error"][disturbed],
            chosen["seconds"][disturbed],
            **look | {"linestyle": "none", "markerfacecolor": "white"},
        )
    reference_error = float(data["reference_error"])
    if reference_error >= SMALLEST_ERROR:
        axes.axvline(reference_error, color="#888888", linewidth=0.8, linestyle="--")
    scale = f"largest error (reference {reference_error:.0e})"
    axes.set_title(label(str(data["problem"].item())))
    axes.set_xlabel("\n".join([scale, *failures(data)]), fontsize=6.5)
    axes.xaxis.set_major_locator(LogLocator(numticks=MOST_TICKS))
    axes.tick_params(labelsize=7)


def failures(data: xr.Dataset) -> Iterator[str]:
    """A line for each method without a result at some tolerances."""
    for method in data["method"].values:
        chosen = data.sel({"method": method})
        failed = np.isfinite(chosen["disturbed"]) & ~np.isfinite(chosen["error"])
        if failed.any():
            listed = ", ".join(f"{value:.0e}" for value in chosen["tolerance"].values[failed])
            yield f"{label(str(method))} failed at {listed}"


def missing(data: xr.Dataset) -> str:
    """What was not installed, as a note."""
    absent = sorted(label(method) for method in json.loads(data.attrs["absent"]))
    return f"not installed here: {', '.join(absent)}" if absent else ""


if __name__ == "__main__":
    run_figure(plot_fig14, globals().get("snakemake"))
