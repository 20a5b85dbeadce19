"""Figure 2: space-time diagrams of a front and its reflections; James (2021), figure 2."""

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import WIDEST, draw_spacetime, name_waves
from granular_fronts.output.style import compression_map, new_figure
from job import job

# What the inset shows: so many beads, until this multiple of the time of arrival.
BEADS_AT_END, TIME_AT_END = 25, 1.25


def fig02(data: xr.Dataset) -> Figure:
    """Draw u_n(t) and the velocities in the (n, t) plane, through two reflections.

    Parameters
    ----------
    data : xarray.Dataset
        Scene initiation_underdamped.
    """
    clip = WIDEST * configuration_of(data)["boundary"]["left"]
    velocity = data["velocity_grid"]
    figure, panels = new_figure(5.2, [["displacement"], ["velocity"]])
    u = data["relative_displacement_grid"].isel(bead=slice(None, -1))
    draw_spacetime(panels["displacement"], u, "relative_displacement", (-clip, clip))
    draw_spacetime(panels["velocity"], velocity, "velocity", (0.0, float(velocity.max())))
    if data["arrival_time"][-2].notnull():
        _draw_free_end(panels["displacement"], u, data["arrival_time"], clip)
    for axes in panels.values():
        name_waves(axes, data["arrival_time"])
    return figure


def _draw_free_end(axes: Axes, u: xr.DataArray, arrivals: xr.DataArray, clip: float) -> None:
    """An inset of the last beads when the front arrives, where contacts open."""
    last, arrival = int(arrivals["bead"][-1]), float(arrivals.max())
    inset = axes.inset_axes((0.56, 0.47, 0.34, 0.18))
    look: dict[str, Any] = {
        "cmap": compression_map(),
        "vmin": -clip,
        "vmax": clip,
        "shading": "nearest",
    }
    inset.pcolormesh(u["bead"], u["t_grid"], u, rasterized=True, **look)
    inset.set(xlim=(last - BEADS_AT_END, last - 0.5), ylim=(0.96 * arrival, TIME_AT_END * arrival))
    inset.set_xticks([last - 20, last - 10])
    inset.tick_params(labelsize=6)
    opens = float(u.min()) < -0.01 * clip
    inset.set_title("last beads fly off" if opens else "last beads", fontsize=6)
    if opens:
        # In grey, red is no other than blue.
        inset.text(
            0.99, 0.6, "gap", transform=inset.transAxes, ha="right", color="white", fontsize=6
        )
        axes.text(last - 12, 2.2 * arrival, "gap", ha="right", clip_on=True)
    axes.indicate_inset(inset.viewLim.bounds, edgecolor="black", linewidth=0.5)
    line: dict[str, Any] = {"arrowprops": {"arrowstyle": "-", "linewidth": 0.5}}
    box = inset.viewLim
    axes.annotate("", (box.x0, box.y1), xytext=(1, 0), textcoords=inset.transAxes, **line)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig02,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
