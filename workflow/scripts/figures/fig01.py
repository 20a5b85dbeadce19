"""Figure 1: a front is initiated by constant pressure, weak damping; James (2021), figure 1."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.panels import draw_probes, draw_snapshot, label_peaks
from granular_fronts.output.style import new_figure
from job import job


def fig01(data: xr.Dataset) -> Figure:
    """Draw relative displacements of single beads and a snapshot of the velocities.

    Parameters
    ----------
    data : xarray.Dataset
        Scene initiation_underdamped.
    """
    figure, panels = new_figure(3.5, [["steady", "snapshot"], ["transient", "transient"]])
    draw_probes(panels["steady"], data, "steady")
    label_peaks(panels["steady"])
    for line in panels["steady"].get_lines():
        line.set_linestyle("-")
    panels["steady"].set_title("far from the compressed end", pad=12)
    draw_probes(panels["transient"], data, "transient")
    panels["transient"].legend(loc="lower right", ncols=2)
    panels["transient"].set_title("near the compressed end: the front forms")
    _draw_velocities(panels["snapshot"], data)
    return figure


def _draw_velocities(axes: Axes, data: xr.Dataset) -> None:
    """Velocities of all beads at the snapshot."""
    snapshot = data["velocity"].isel(t=0)
    draw_snapshot(axes, snapshot, "velocity", color="black")
    axes.set_title(f"all beads at $t = {float(snapshot['t']):g}$", pad=12)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig01,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
