"""Figure 25: shares of numbers whose true error exceeds a multiple of the stated one."""

import math

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure

# Kinds of numbers by what their names hold; the first that matches counts.
KINDS = {
    "times": ("_time",),
    "numbers of beads": ("_bead",),
    "extremes and speeds": ("largest", "smallest", "peak", "front_speed"),
    "states": ("relative_displacement", "velocity", "strain", "evaluated"),
    "measures": ("",),
}
FEW, TWICE, TENFOLD = 5e-3, 2.0, 10.0
LEAST_RATIO, LARGEST_RATIO, LEAST_SHARE = 3e-4, 30.0, 3e-4


def honesty(chains: xr.Dataset, fronts: xr.Dataset, rings: xr.Dataset) -> Figure:
    """Draw a panel for each kind of problem.

    Parameters
    ----------
    chains, fronts, rings : xarray.Dataset
        Written by measure_honesty.
    """
    problems = {"chains": chains, "exact fronts": fronts, "rings": rings}
    figure, panels = new_figure(4.0, [[*problems]])
    for kind, data in problems.items():
        _draw_kind(panels[kind], data)
        panels[kind].set_title(kind)
        panels[kind].set_xlabel(f"true error / stated error\n{_in_words(data)}", fontsize=8)
    panels["chains"].set_ylabel("share of numbers above")
    place = math.sqrt(TWICE * TENFOLD), 1.5 * FEW
    panels["chains"].text(*place, "should be empty", rotation=90, ha="center", fontsize=8)
    return figure


def _draw_kind(axes: Axes, data: xr.Dataset) -> None:
    """Shares of each kind of numbers, and what they should not enter."""
    kinds = np.array([_kind_of(name) for name in data["variable"].values])
    shown = [kind for kind in KINDS if kind in kinds]
    for kind, colour, line in zip(shown, PROBE_COLOURS, PROBE_STYLES, strict=False):
        ratios = np.sort(data["ratio"].values[kinds == kind])
        shares = 1.0 - np.arange(ratios.size) / ratios.size
        ends = np.clip([LEAST_RATIO, *ratios, ratios[-1]], LEAST_RATIO, 2 * LARGEST_RATIO)
        axes.step(ends, [1.0, *shares, LEAST_SHARE / 10], color=colour, linestyle=line, label=kind)
    axes.fill_between([TWICE, TENFOLD], FEW, 1.0, color="0.88", linewidth=0.0)
    axes.fill_between([TENFOLD, LARGEST_RATIO], LEAST_SHARE, 1.0, color="0.78", linewidth=0.0)
    axes.set(
        xscale="log",
        yscale="log",
        xlim=(LEAST_RATIO, LARGEST_RATIO),
        ylim=(LEAST_SHARE, 1.2),
    )
    axes.set_xticks([0.001, 0.1, 1.0, TWICE, TENFOLD], ["0.001", "0.1", "1", "2", "10"])
    axes.minorticks_off()
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.25))


def _kind_of(name: str) -> str:
    """Kind of a number by the name of its variable."""
    return next(kind for kind, parts in KINDS.items() if any(part in name for part in parts))


def _in_words(data: xr.Dataset) -> str:
    """How many numbers there are, and how many are further off than twice their error."""
    ratios = data["ratio"].values
    return f"{ratios.size} numbers, {np.mean(ratios > TWICE):.2%} above {TWICE:g}"
