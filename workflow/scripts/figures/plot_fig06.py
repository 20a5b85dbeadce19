"""Figures 6 and 7: ring and logarithmic Burgers equation; James (2021), figures 6 and 7."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import draw_comparison


def plot_fig06(data: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at every snapshot.

    Parameters
    ----------
    data : xarray.Dataset
        Periodic scene weak for figure 6, and hertz for figure 7.
    """
    return draw_comparison(data)


if __name__ == "__main__":
    run_figure(plot_fig06, globals().get("snakemake"))
