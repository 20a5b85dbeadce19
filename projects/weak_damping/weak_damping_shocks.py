"""Compression at a contact over time, for several dampings."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import new_figure
from job import job


def weak_damping_shocks(motions: list[xr.Dataset]) -> Figure:
    """Draw the compression at a contact, a panel for each motion.

    Parameters
    ----------
    motions : list of xarray.Dataset
        Motions of a driven chain, from no damping to strong damping.
    """
    names = [f"motion_{number}" for number in range(len(motions))]
    figure, panels = new_figure(4.6, [[name] for name in names], sharex=True)
    for axes, motion in zip(panels.values(), motions, strict=True):
        series = motion["relative_displacement_far"].isel(bead_far=0)
        axes.plot(motion["t_far"], series, "k-", lw=0.3)
        axes.axhline(1.0, color="k", ls=":", lw=0.6)
        gamma = configuration_of(motion)["law"]["gamma"]
        axes.text(0.98, 0.78, rf"$\gamma = {gamma:g}$", transform=axes.transAxes, ha="right")
        axes.set(ylabel="$u_{400}$", xlim=(370, 1100), ylim=(-0.05, 1.85))
    axes.set_xlabel("time $t$")
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            weak_damping_shocks,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            motions=snakemake.input.motions,
        )
