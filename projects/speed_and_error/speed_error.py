"""Figure 14: time against error of all methods, on each problem."""

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator
from scipy.optimize import isotonic_regression

from granular_fronts.output.style import PACKAGE_COLOURS, PACKAGE_LINES, fill_rows, new_figure

# What the problems are.
TITLES = {
    "initiation_underdamped": "driven chain",
    "front_underdamped": "exact front",
    "log_burgers_weak": "logarithmic Burgers",
}
COLUMNS = 2
# Heights of a name next to a panel, of what is above and below the panel, and of the lowest
# panel, in inches.
NAME_HEIGHT, FRAME_HEIGHT, LOWEST = 0.14, 0.55, 1.2
MOST_TICKS = 5
MARKERS = "osD^vPX<>*"
# Discrete-element codes are given a step, not a tolerance.
CODES = ("lammps",)
# Double precision resolves nothing further left.
SMALLEST_ERROR = 1e-17


def speed_error(data: xr.Dataset) -> Figure:
    """Draw a panel for each problem, the names of its curves at its right.

    Parameters
    ----------
    data : xarray.Dataset
        Written by merge_precision.
    """
    problems = [str(problem) for problem in data["problem"].values]
    rows = fill_rows(problems, COLUMNS)
    heights = [_height(data, row) for row in rows]
    # A row of the mosaic for each tenth of an inch gives the rows of panels their heights.
    mosaic = [
        row for row, inches in zip(rows, heights, strict=True) for _ in range(int(10 * inches))
    ]
    figure, panels = new_figure(sum(heights), mosaic)
    looks = _choose_looks(data)
    for problem in problems:
        _draw_problem(panels[problem], data.sel(problem=problem), looks)
    for row in rows:
        panels[row[0]].set_ylabel("seconds")
    note = _missing(data)
    if note:
        figure.supxlabel(note, fontsize=7)
    return figure


def _height(data: xr.Dataset, row: list[str]) -> float:
    """Height of a row of panels, which the names at the fullest of them need, in inches."""
    chosen = data.sel({"problem": [problem for problem in row if problem != "."]})
    solved = chosen["error"].notnull().any("step_tolerance").sum("solver")
    return FRAME_HEIGHT + max(LOWEST, NAME_HEIGHT * int(solved.max()))


def _choose_looks(data: xr.Dataset) -> dict[str, dict[str, Any]]:
    """Line and marker of every method: a colour for each package, ours in black and heavier."""
    looks: dict[str, dict[str, Any]] = {}
    used: dict[str, int] = {}
    ours = set(data["own_method"].values)
    for method in map(str, data["solver"].values):
        colour = PACKAGE_COLOURS.get(method.split("_")[0], PACKAGE_COLOURS["ours"])
        index = used.setdefault(colour, 0)
        used[colour] += 1
        looks[method] = {
            "color": colour,
            "marker": MARKERS[index % len(MARKERS)],
            "linestyle": _style_of(method, method in ours),
            "linewidth": 1.4 if method in ours else 0.7,
            "markersize": 3.5 if method in ours else 2.2,
        }
    return looks


def _style_of(method: str, is_own_method: bool) -> Any:
    """Line of the package that a method belongs to; dotted for other methods of ours."""
    package = method.split("_")[0]
    return PACKAGE_LINES.get(package, "-" if is_own_method else ":")


def _label(method: str) -> str:
    """Name of a method as it is read."""
    return method.replace("_", " ")


def _draw_problem(axes: Axes, data: xr.Dataset, looks: dict[str, dict[str, Any]]) -> None:
    """Curves of one problem with their names, the error of its reference, and who failed."""
    ends = {}
    for method, look in looks.items():
        chosen = data.sel(solver=method)
        chosen = chosen.isel(step_tolerance=np.argsort(-chosen["step_tolerance"].values))
        chosen = chosen.isel(step_tolerance=np.flatnonzero(np.isfinite(chosen["error"])))
        disturbed = chosen["disturbed"].values == 1.0
        axes.loglog(chosen["error"], chosen["seconds"], **look)
        axes.loglog(
            chosen["error"][disturbed],
            chosen["seconds"][disturbed],
            **look | {"linestyle": "none", "markerfacecolor": "white"},
        )
        if chosen["error"].size:
            loosest = int(np.argmax(chosen["error"].values))
            ends[method] = float(chosen["error"][loosest]), float(chosen["seconds"][loosest])
    reference_error = float(data["reference_error"])
    if reference_error >= SMALLEST_ERROR:
        axes.axvline(reference_error, color="#888888", linewidth=0.8, linestyle="--")
    scale = f"largest error (reference {reference_error:.0e})"
    problem = str(data["problem"].item())
    axes.set_title(TITLES.get(problem, _label(problem)), fontsize=8)
    axes.set_xlabel("\n".join([scale, *_failures(data)]), fontsize=7)
    axes.xaxis.set_major_locator(LogLocator(numticks=MOST_TICKS))
    axes.tick_params(which="both", labelsize=7)
    _name_curves(axes, ends, looks)


def _name_curves(
    axes: Axes, ends: dict[str, tuple[float, float]], looks: dict[str, dict[str, Any]]
) -> None:
    """The name of each curve at the right of the panel, at its end of largest error."""
    # The names keep the order of the ends and a distance of their own height. Within that, the sum
    # of the squares of their shifts is least (isotonic regression).
    methods = sorted(ends, key=lambda method: ends[method][1])
    low, high = np.log(axes.get_ylim())
    wanted = [(np.log(ends[method][1]) - low) / (high - low) for method in methods]
    ranks = np.arange(len(methods)) / max(len(methods), LOWEST / NAME_HEIGHT)
    free = isotonic_regression(np.array(wanted) - ranks).x if methods else ranks
    places = np.clip(free, 0.0, 1.0 - ranks[-1:]) + ranks
    for method, place in zip(methods, places, strict=True):
        axes.annotate(
            _label(method),
            ends[method],
            (1.04, place),
            textcoords="axes fraction",
            color=looks[method]["color"],
            fontsize=7,
            verticalalignment="center",
            arrowprops={
                "arrowstyle": "-",
                "color": looks[method]["color"],
                "linewidth": 0.3,
                "relpos": (0.0, 0.5),
            },
        )


def _failures(data: xr.Dataset) -> Iterator[str]:
    """A line for the methods without a result at the same tolerances, or steps."""
    failed: dict[str, list[str]] = {}
    for method in map(str, data["solver"].values):
        chosen = data.sel(solver=method)
        tried = np.isfinite(chosen["disturbed"])
        missed = tried & ~np.isfinite(chosen["error"])
        if missed.any():
            listed = ", ".join(f"{value:g}" for value in chosen["step_tolerance"].values[missed])
            where = f"at step {listed}" if method.split("_")[0] in CODES else f"at {listed}"
            # The list of all would not fit below a panel.
            where = "throughout" if (missed == tried).all() else where
            failed.setdefault(where, []).append(_label(method))
    for where, methods in failed.items():
        yield f"failed {where}: {', '.join(methods)}"


def _missing(data: xr.Dataset) -> str:
    """What was not installed, as a note."""
    absent = sorted(_label(method) for method in json.loads(data.attrs["absent"]))
    return f"not installed here: {', '.join(absent)}" if absent else ""
