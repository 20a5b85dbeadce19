"""Figures 6 and 7: ring and logarithmic Burgers equation; James (2021), figures 6 and 7."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import BEAD, FIELD_LABELS, finish_grid
from granular_fronts.output.style import ALARM_COLOUR, CHAIN_COLOUR, EQUATION_COLOUR, new_figure
from job import job

# What is shown below zero, over what is above it; wider gaps are marked with their size.
BELOW = 0.3


def fig06(data: xr.Dataset) -> Figure:
    """Draw relative displacements and velocities at every snapshot after the start.

    Parameters
    ----------
    data : xarray.Dataset
        Periodic scene weak for figure 6, and hertz for figure 7.
    """
    data, alpha = data.isel(t=slice(1, None)), configuration_of(data)["law"]["alpha"]
    rows = [[f"{field} {row}" for field in FIELD_LABELS] for row in range(data.sizes["t"])]
    figure, panels = new_figure(1.1 * len(rows) + 0.4, rows, sharex=True)
    for row, names in enumerate(rows):
        for name, field in zip(names, FIELD_LABELS, strict=True):
            highest = float(data[field].max())
            panels[name].set_ylim(-BELOW * highest, 1.08 * highest)
            _draw_snapshot(panels[name], data.isel(t=row), field)
        panels[names[0]].set_title(rf"$\alpha = {alpha:g}$, $t = {float(data['t'][row]):g}$")
    finish_grid(figure, [panels[name] for name in rows[-1]], BEAD)
    return figure


def _draw_snapshot(axes: Axes, snapshot: xr.Dataset, field: str) -> None:
    """One field of the ring and of the equation at one time."""
    line, beads = snapshot[f"{field}_logarithmic"], snapshot[field]
    words = "logarithmic Burgers equation"
    axes.plot(line["site"], line, "-", color=EQUATION_COLOUR, label=words)
    look: dict[str, Any] = {"color": CHAIN_COLOUR, "markersize": 2, "label": "ring of beads"}
    axes.plot(beads["bead"], beads, ".", **look)
    axes.set(ylabel=FIELD_LABELS[field], xlim=(0, int(beads["bead"][-1]) + 1))
    lowest = axes.get_ylim()[0]
    gaps = beads.where(beads < lowest, drop=True)
    if gaps.size:
        edge = np.full(gaps.size, 0.85 * lowest)
        axes.plot(gaps["bead"], edge, "v", color=ALARM_COLOUR, markersize=2)
        axes.annotate(
            f"$u_{{{int(gaps.idxmin())}}} = {float(gaps.min()):.2g}$",
            (float(gaps["bead"][-1]), 0.85 * lowest),
            xytext=(5, 1),
            textcoords="offset points",
            color=ALARM_COLOUR,
        )


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig06,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
