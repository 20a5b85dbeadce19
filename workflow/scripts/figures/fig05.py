"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import FIELD_LABELS, draw_snapshot
from granular_fronts.output.style import EXPONENT_LOOKS, new_figure
from job import job


def fig05(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at t = 0, of both exponents.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    figure, panels = new_figure(2.6, [list(FIELD_LABELS)])
    for data, (colour, line) in zip((hertz, weak), EXPONENT_LOOKS, strict=True):
        label = rf"$\alpha = {configuration_of(data)['law']['alpha']:g}$"
        for field, axes in panels.items():
            draw_snapshot(
                axes, data[field].sel(t=0.0), field, color=colour, linestyle=line, label=label
            )
    panels["relative_displacement"].legend(loc="upper left")
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
