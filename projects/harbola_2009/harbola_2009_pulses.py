"""Speed, compression and loss of pulses in tapered chains, by the chain and by collisions."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

CONTACTS = slice(1, 61)  # those that the end does not reach
SPEEDS = (0.2, 0.5, 1, 2, 4)


def harbola_2009_pulses(pulses: xr.Dataset) -> Figure:
    """Draw pulses along tapered chains and their loss against the taper.

    Parameters
    ----------
    pulses : xarray.Dataset
        Compressions and times along several chains, and losses for several tapers.
    """
    figure, panels = new_figure(2.5, [["speed", "compression", "loss"]])
    speed, compression, loss = panels.values()
    near = pulses.sel(contact=CONTACTS)
    between = near["contact"].values[:-1] + 0.5
    for name, color in zip(near["chain"].values, PROBE_COLOURS, strict=False):
        one = near.sel(chain=name)
        speed.plot(between, 1.0 / np.diff(one["time"]), color=color, label=name)
        collisions = 1.0 / np.diff(one["time_of_collisions"])
        speed.plot(between[::4], collisions[::4], "o", color=color, ms=2)
        ratio = one["compression_of_collisions"] / one["compression"]
        compression.plot(one["contact"], ratio, color=color)
    for sign, marker, line, name in ((1, "o", ":", "heavier"), (-1, "s", "--", "lighter")):
        side = pulses.isel(taper=np.flatnonzero(sign * pulses["taper"].values > 0))
        size = np.abs(side["taper"])
        loss.plot(size, side["loss_ratio"], f"k{marker}", label=f"to {name}")
        loss.plot(size, side["loss_ratio_theory"], f"k{line}", lw=0.6)
    speed.set(xlabel="contact $n$", ylabel="speed of the pulse", yscale="log")
    speed.set_yticks(SPEEDS, map(str, SPEEDS))
    speed.minorticks_off()
    compression.set(xlabel="contact $n$", ylabel="compression over exact one")
    loss.set(xlabel=r"taper $|\varepsilon|$", ylabel="loss over that of collisions", xscale="log")
    loss.legend()
    figure.legend(*speed.get_legend_handles_labels(), loc="outside lower center", ncols=5)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            harbola_2009_pulses,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            pulses=snakemake.input.pulses,
        )
