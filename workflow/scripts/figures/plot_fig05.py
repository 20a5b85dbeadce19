"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import draw_chain_dots, draw_rings


def plot_fig05(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at t = 0, a row for each exponent.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    figure, rows = draw_rings(3.6, [weak, hertz], _draw_start)
    for axes in rows[-1]:
        axes.set_xlabel("$n$")
    return figure


def _draw_start(axes: Axes, data: xr.Dataset, field: str, exponent: str) -> None:
    """One field of all beads at t = 0."""
    draw_chain_dots(axes, data.sel(t=0.0), field)
    axes.annotate(exponent, (0.02, 0.86), xycoords="axes fraction")


if __name__ == "__main__":
    run_figure(plot_fig05, globals().get("snakemake"))
