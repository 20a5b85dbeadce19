"""Figure 2: space-time diagrams of a front and its reflections; James (2021), figure 2."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_spacetime
from granular_fronts.output.style import new_figure, velocity_map

# The paper clips its colours at 0.14 where δ = 0.1: gaps wider than any compression are red.
CLIP_OVER_DELTA = 1.4


def plot_fig02(data: xr.Dataset) -> Figure:
    """Draw u_n(t) and the velocities in the (n, t) plane, through two reflections.

    Parameters
    ----------
    data : xarray.Dataset
        Scene initiation_underdamped.
    """
    clip = CLIP_OVER_DELTA * configuration_of(data)["boundary"]["left"]
    figure, panels = new_figure(4.4, [["displacement", "velocity"]])
    draw_spacetime(
        panels["displacement"],
        data["relative_displacement_grid"].isel(bead=slice(None, -1)),
        "$u_n(t)$",
        limits=(-clip, clip),
        extend="min",
    )
    draw_spacetime(
        panels["velocity"],
        data["velocity_grid"],
        r"$\dot x_n(t)$",
        velocity_map(),
        limits=(0.0, None),
    )
    panels["velocity"].set_ylabel("")
    return figure


if __name__ == "__main__":
    run_figure(plot_fig02, globals().get("snakemake"))
