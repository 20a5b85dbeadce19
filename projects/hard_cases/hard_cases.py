"""Errors of the hard cases and their limits."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure
from job import job

SMALLEST_ERROR, LARGEST_ERROR = 1.0e-17, 1.0e-3


def hard_cases(data: xr.Dataset) -> Figure:
    """Draw the error of each case as a dot, its limit as a bar; what failed is a red diamond.

    Parameters
    ----------
    data : xarray.Dataset
        Written by solve_hard_cases.
    """
    figure, panels = new_figure(0.8 + 0.13 * data.sizes["case"], [["cases"]])
    axes, places = panels["cases"], -np.arange(data.sizes["case"])
    passed = (data["error"] <= data["limit"]).values
    # What is no number is drawn at the right edge.
    error = np.clip(data["error"].fillna(1.0).values, SMALLEST_ERROR, LARGEST_ERROR)
    axes.plot(data["limit"], places, "|", color="0.55", markersize=6, label="limit")
    axes.plot(error[passed], places[passed], "o", color=PROBE_COLOURS[1], label="passed")
    axes.plot(error[~passed], places[~passed], "D", color=ALARM_COLOUR, label="failed")
    axes.set_yticks(places, data["case"].values)
    axes.set(xscale="log", xlabel="error", xlim=(0.5 * SMALLEST_ERROR, 2.0 * LARGEST_ERROR))
    axes.grid(axis="y", linewidth=0.3)
    axes.set_ylim(places[-1] - 0.7, 0.7)
    figure.legend(loc="outside upper center", ncols=3)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            hard_cases,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
