"""Velocities behind an impact at several times, for three dampings."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure
from job import job


def rosas_2007_pulses(weak: xr.Dataset, medium: xr.Dataset, strong: xr.Dataset) -> Figure:
    """Draw the velocities of the beads at several times, a panel for each damping.

    Parameters
    ----------
    weak, medium, strong : xarray.Dataset
        Motions behind an impact, from small to large damping.
    """
    figure, panels = new_figure(4.4, [["weak"], ["medium"], ["strong"]], sharex=True)
    for axes, motion in zip(panels.values(), (weak, medium, strong), strict=True):
        looks = zip(motion["velocity"], PROBE_COLOURS, PROBE_STYLES, strict=False)
        for velocity, color, style in looks:
            time = f"t = {float(velocity['t']):g}"
            axes.plot(motion["bead"], velocity, color=color, linestyle=style, label=time)
        words = rf"$\gamma = {configuration_of(motion)['law']['gamma']:g}$"
        axes.text(0.98, 0.8, words, transform=axes.transAxes, ha="right")
        axes.set(ylabel=r"velocity $\dot x_n$", xlim=(0, motion.sizes["bead"]), ylim=(-0.005, 0.1))
    axes.set_xlabel("bead $n$")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            rosas_2007_pulses,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            weak=snakemake.input.weak,
            medium=snakemake.input.medium,
            strong=snakemake.input.strong,
        )
