"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import FIELD_LABELS, draw_snapshot
from granular_fronts.output.style import BLUE, GREEN, new_figure
from job import job


def fig05(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at t = 0, of both exponents.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    figure, panels = new_figure(3.2, [[field] for field in FIELD_LABELS], sharex=True)
    # Dots lie in the circles where both exponents have the same value.
    circles = {"color": GREEN, "marker": "o", "markersize": 2.2, "fillstyle": "none"}
    for field, axes in panels.items():
        for data, look in ((weak, circles), (hertz, {"color": BLUE})):
            label = rf"$\alpha = {configuration_of(data)['law']['alpha']:g}$"
            draw_snapshot(axes, data[field].sel(t=0.0), field, label=label, **look)
        axes.set_xlim(0, int(data["bead"][-1]) + 1)
    panels["relative_displacement"].set_xlabel("")
    panels["relative_displacement"].legend(loc="upper right")
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig05,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            weak=snakemake.input.weak,
            hertz=snakemake.input.hertz,
        )
