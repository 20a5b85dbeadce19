"""Speed, compression and loss of pulses in tapered chains, by the chain and by collisions."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from granular_fronts.output.style import PROBE_COLOURS, new_figure

CONTACTS = slice(1, 61)  # those that the end does not reach
SPEEDS = (0.2, 0.5, 1, 2, 4)


def plot_harbola_2009_pulses(pulses: xr.Dataset, losses: xr.Dataset) -> Figure:
    """Draw pulses along tapered chains and their loss against the taper.

    Parameters
    ----------
    pulses : xarray.Dataset
        Compressions and times along several chains.
    losses : xarray.Dataset
        Loss of energy over that of binary collisions for several tapers.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.4, [["speed", "compression", "loss"]])
    near = pulses.sel(contact=CONTACTS)
    for name, color in zip(near["chain"].values, PROBE_COLOURS, strict=False):
        one = near.sel(chain=name)
        between = one["contact"].values[:-1] + 0.5
        panels["speed"].plot(between, 1.0 / np.diff(one["time"]), color=color, label=name)
        speed = 1.0 / np.diff(one["time_of_collisions"])
        panels["speed"].plot(between[::4], speed[::4], "o", color=color, ms=2.5)
        ratio = one["compression_of_collisions"] / one["compression"]
        panels["compression"].plot(one["contact"], ratio, color=color)
    for sign, marker, line, name in ((1, "o", ":", "heavier"), (-1, "s", "--", "lighter")):
        one = losses.isel(taper=np.flatnonzero(sign * losses["taper"].values > 0))
        size = np.abs(one["taper"])
        panels["loss"].plot(size, one["loss_ratio"], f"k{marker}", ms=3.5, label=f"to {name}")
        panels["loss"].plot(size, one["loss_ratio_theory"], f"k{line}", lw=0.8)
    panels["speed"].set(xlabel="contact $n$", ylabel="speed of the pulse", yscale="log")
    panels["speed"].set_yticks(SPEEDS, map(str, SPEEDS))
    panels["speed"].minorticks_off()
    panels["compression"].set(xlabel="contact $n$", ylabel="compression over exact one")
    panels["loss"].set(
        xlabel=r"taper $|\varepsilon|$", ylabel="loss over that of collisions", xscale="log"
    )
    handles, labels = panels["speed"].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    panels["loss"].legend()
    return figure
