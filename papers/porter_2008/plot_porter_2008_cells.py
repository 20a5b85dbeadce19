"""Speeds and widths of pulses in dimers, and speeds in cells of several materials."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import new_figure


def plot_porter_2008_cells(dimers: xr.Dataset, materials: xr.Dataset) -> Figure:
    """Draw speeds and widths over the mass ratio, and speeds of materials.

    Parameters
    ----------
    dimers : xarray.Dataset
        Pulses in dimers of several mass ratios.
    materials : xarray.Dataset
        Pulses in cells of several materials.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(5.4, [["speed", "width"], ["materials", "materials"]])
    speed, width, named = panels.values()
    for axes, name in ((speed, "speed"), (width, "stretch")):
        axes.errorbar(dimers["ratio"], dimers[name], dimers[f"{name}_error"], fmt="ko", ms=4)
        axes.set_xlabel("mass ratio")
    width.plot(dimers["ratio"], dimers["stretch_theory"], "k+", ms=8)
    speed.axhline(1.0, color="k", lw=0.8)
    speed.set(ylabel="speed over theory")
    width.set(ylabel="width over equal spheres")
    places = np.arange(materials.sizes["cell"])[::-1]
    found = materials["speed_at_10_newtons"]
    errors = materials["speed_at_10_newtons_error"]
    named.errorbar(found, places, xerr=errors, fmt="ko", ms=5, mfc="none")
    named.plot(found / materials["speed"], places, "k+", ms=8)
    named.set_yticks(places, materials["cell"].values)
    named.set(xlabel="speed at 10 N in m/s", xlim=(0, 550))
    return figure


if __name__ == "__main__":
    run_figure(plot_porter_2008_cells, globals().get("snakemake"))
