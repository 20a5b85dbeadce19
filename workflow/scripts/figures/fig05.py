"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import FIELD_LABELS, draw_snapshot
from granular_fronts.output.style import CHAIN_COLOUR, new_figure
from job import job


def fig05(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at t = 0, a row for each exponent.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    rows = [[f"{field} {row}" for field in FIELD_LABELS] for row in range(2)]
    figure, panels = new_figure(2.7, rows, sharex=True)
    for field in FIELD_LABELS:
        upper, lower = (panels[f"{field} {row}"] for row in range(2))
        lower.sharey(upper)
        for axes, data in ((upper, weak), (lower, hertz)):
            draw_snapshot(axes, data[field].sel(t=0.0), field, color=CHAIN_COLOUR)
            axes.set_xlim(0, int(data["bead"][-1]) + 1)
            axes.set_title(rf"$\alpha = {configuration_of(data)['law']['alpha']:g}$")
        upper.set_xlabel("")
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
