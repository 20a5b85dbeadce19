"""Time against error of all methods, on each problem."""

import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, fill_rows, new_figure
from job import job

PANEL_HEIGHT = 1.9  # in inches
OURS = "black"
PACKAGES = {
    "upwind": (ALARM_COLOUR, "-"),
    "scilab": (ALARM_COLOUR, "--"),
    "scipy": (PROBE_COLOURS[1], "-"),
    "numbalsoda": (PROBE_COLOURS[2], "--"),
    "diffrax": (PROBE_COLOURS[3], (0, (6, 1, 1, 1))),
    "lammps": ("0.55", "-."),
}
"""Colour and line of methods that are not ours, by the first word of their names."""
MARKERS = "osD^vPX"


def speed_error(data: xr.Dataset) -> Figure:
    """Draw a panel for each problem.

    Parameters
    ----------
    data : xarray.Dataset
        Written by measure_speed.
    """
    runs = dict(list(data.to_dataframe().groupby("problem", sort=False)))
    rows = fill_rows(runs, 2)
    figure, panels = new_figure(PANEL_HEIGHT * len(rows), rows)
    for problem, of_problem in runs.items():
        _draw_problem(panels[problem], of_problem)
        panels[problem].set_title(problem.replace("_", " "))
    for row in rows:
        panels[row[0]].set_ylabel("seconds")
    return figure


def _draw_problem(axes: Axes, runs: pd.DataFrame) -> None:
    """Curves of one problem, and the error of its reference."""
    for (method, curve), marker in zip(runs.groupby("method", sort=False), MARKERS, strict=False):
        colour, line = PACKAGES.get(method.partition("_")[0], (OURS, "-"))
        label = method.replace("_", " ")
        look = {"color": colour, "marker": marker, "linewidth": 0.7}
        axes.loglog(curve["error"], curve["seconds"], linestyle=line, label=label, **look)
        busy = curve[curve["disturbed"] == 1]
        axes.loglog(busy["error"], busy["seconds"], **look | {"linestyle": "", "mfc": "white"})
    axes.axvline(runs["reference_error"].iloc[0], color="0.55", linewidth=0.8, linestyle="--")
    axes.set_xlabel("largest error")
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=6, handlelength=2.0)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            speed_error,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
