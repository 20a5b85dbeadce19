"""Velocities behind an impact at several times, for three dampings."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure


def plot_rosas_2007_pulses(weak: xr.Dataset, medium: xr.Dataset, strong: xr.Dataset) -> Figure:
    """Draw the velocities of the beads at several times, a panel for each damping.

    Parameters
    ----------
    weak, medium, strong : xarray.Dataset
        Motions behind an impact, from small to large damping.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(5.6, [["weak"], ["medium"], ["strong"]])
    for axes, motion in zip(panels.values(), (weak, medium, strong), strict=True):
        rows = zip(motion["t"].values, motion["velocity"].values, strict=True)
        for (time, velocity), color, style in zip(rows, PROBE_COLOURS, PROBE_STYLES, strict=False):
            axes.plot(motion["bead"], velocity, color=color, linestyle=style, label=f"t = {time:g}")
        axes.text(
            0.98,
            0.8,
            rf"$\gamma = {configuration_of(motion)['law']['gamma']:g}$",
            transform=axes.transAxes,
            ha="right",
        )
        axes.set(
            ylabel=r"velocity $\dot x_n$", xlim=(0, np.max(motion["bead"])), ylim=(-0.005, 0.1)
        )
    axes.set_xlabel("bead $n$")
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=5)
    return figure
