"""Figure 3: a front is initiated by constant pressure, strong damping; James (2021), figure 3."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import WIDEST, draw_probes, draw_spacetime, name_waves
from granular_fronts.output.style import new_figure
from job import job

# A change of compression, over the largest, that is too small to see in the upper panel.
UNSEEN = 1e-3


def fig03(data: xr.Dataset) -> Figure:
    """Draw relative displacements of the first beads, and of all beads in the (n, t) plane.

    Parameters
    ----------
    data : xarray.Dataset
        Scene initiation_overdamped.
    """
    clip = WIDEST * configuration_of(data)["boundary"]["left"]
    figure, panels = new_figure(4.6, [["transient"], ["displacement"]])
    draw_probes(panels["transient"], data, "transient")
    probes = data["relative_displacement_transient"]
    moving = np.abs(probes - probes[-1]) > UNSEEN * probes.max()
    settled = probes["t_transient"].where(moving).max()
    # Of a number and NaN, which is where nothing moves, `fmin` is the number.
    panels["transient"].set_xlim(right=float(np.fmin(probes["t_transient"][-1], 1.15 * settled)))
    panels["transient"].legend(loc="lower right")
    panels["transient"].set_title("near the compressed end")
    draw_spacetime(
        panels["displacement"],
        data["relative_displacement_grid"].isel(bead=slice(None, -1)),
        "relative_displacement",
        (-clip, clip),
    )
    name_waves(panels["displacement"], data["arrival_time"])
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig03,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
