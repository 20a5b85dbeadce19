"""Figure 14b: time against error of all methods, on the other problems."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from plot_fig14 import ON_THE_PAGE, draw_problems

from figure_step import run_figure


def plot_fig14b(data: xr.Dataset) -> Figure:
    """Draw a panel for each problem that is not in figure 14.

    Parameters
    ----------
    data : xarray.Dataset
        Written by merge_precision.
    """
    return draw_problems(data.sel(problem=~np.isin(data["problem"], list(ON_THE_PAGE))))


if __name__ == "__main__":
    run_figure(plot_fig14b, globals().get("snakemake"))
