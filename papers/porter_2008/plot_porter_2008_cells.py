"""Speeds and widths of pulses in dimers, and speeds in cells of several materials."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import new_figure


def plot_porter_2008_cells(dimers: xr.Dataset, materials: xr.Dataset, light: xr.Dataset) -> Figure:
    """Draw speeds and widths over the mass ratio, and speeds of materials.

    Parameters
    ----------
    dimers : xarray.Dataset
        Pulses in dimers of several mass ratios.
    materials : xarray.Dataset
        Pulses in cells of several materials.
    light : xarray.Dataset
        The same nearer to the striker, where a pulse is soon lost.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(5.4, [["speed", "width"], ["materials", "materials"]])
    speed, width, named = panels.values()
    for axes, name, marker in (
        (speed, "speed_over_theory", "ko"),
        (speed, "speed_over_theory_by_largest", "ks"),
        (width, "width", "ko"),
    ):
        filled = "k" if marker == "ko" else "none"
        errors = dimers[f"{name}_error"]
        axes.errorbar(dimers["ratio"], dimers[name], errors, fmt=marker, ms=3.5, mfc=filled)
        axes.set_xlabel("mass ratio")
    width.plot(dimers["ratio"], dimers["width_by_theory"], "k+", ms=6)
    speed.axhline(1.0, color="k", lw=0.8)
    speed.set(ylabel="speed over theory")
    width.set(ylabel="width over equal spheres")
    cells = xr.concat([materials, light], "cell", data_vars="minimal")
    places = np.arange(cells.sizes["cell"])[::-1]
    found, errors = cells["speed_at_10_newtons"], cells["speed_at_10_newtons_error"]
    named.errorbar(found, places, xerr=errors, fmt="ko", ms=5, mfc="none")
    named.plot(found / cells["speed_over_theory"], places, "k+", ms=8)
    named.set_yticks(places, cells["cell"].values)
    named.set(xlabel="speed at 10 N in m/s", xlim=(0, 550))
    return figure


if __name__ == "__main__":
    run_figure(plot_porter_2008_cells, globals().get("snakemake"))
