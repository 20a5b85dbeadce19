"""Pulses behind impacts at several times; their fronts and exact ones: shape, overshoot, height."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure
from job import job

MARKERS = "os^D"
HEIGHTS = (0.01, 0.02, 0.04)
MOSAIC = [["weak", "medium", "strong"], ["shape", "overshoot", "height"]]


def rosas_2007_pulses(
    weak: xr.Dataset, medium: xr.Dataset, strong: xr.Dataset, fronts: xr.Dataset
) -> Figure:
    """Draw velocities of the beads for three dampings, and fronts of chains with exact ones.

    Parameters
    ----------
    weak, medium, strong : xarray.Dataset
        Motions behind an impact, from small to large damping.
    fronts : xarray.Dataset
        Fronts at several contacts, for several dampings.
    """
    figure, panels = new_figure(4.4, MOSAIC)
    for name, motion in (("weak", weak), ("medium", medium), ("strong", strong)):
        looks = zip(motion["velocity"], PROBE_COLOURS, PROBE_STYLES, strict=False)
        for velocity, color, style in looks:
            time = f"t = {float(velocity['t']):g}"
            panels[name].plot(motion["bead"], velocity, color=color, linestyle=style, label=time)
        words = rf"$\gamma = {configuration_of(motion)['law']['gamma']:g}$"
        panels[name].text(0.98, 0.9, words, transform=panels[name].transAxes, ha="right")
        panels[name].set(xlabel="bead $n$", xlim=(0, 500), ylim=(-0.005, 0.1))
    panels["weak"].set_ylabel(r"velocity $\dot x_n$")
    panels["strong"].legend(loc="center right")
    shape, overshoot, height = (panels[name] for name in MOSAIC[1])
    for gamma, color, marker in zip(fronts["gamma"].values, PROBE_COLOURS, MARKERS, strict=False):
        one = fronts.sel(gamma=gamma)
        front, label = one.isel(contact=-1), rf"$\gamma = {gamma:g}$"
        shape.plot(front["xi"], front["exact_front"], color=color, lw=0.6)
        shape.plot(front["xi"][::10], front["front"][::10], marker, color=color, ms=2)
        overshoot.plot(one["damping"], one["overshoot"], marker, color=color)
        height.plot(one["contact"], one["height"], marker, color=color, label=label)
    exact = fronts.stack(point=("gamma", "contact")).sortby("damping")
    overshoot.plot(exact["damping"], exact["exact_overshoot"], "k-", lw=0.6, label="exact front")
    overshoot.axvline(fronts.attrs["critical_damping"], color="k", ls=":", lw=0.6)
    theory = fronts["height_of_momentum"].isel(gamma=-1)
    height.plot(fronts["contact"], theory, "k--", lw=0.6, label="by momentum")
    shape.set(xlabel=r"$\xi = n - ct$", ylabel=r"$u/\delta$", xlim=(-25, 6))
    overshoot.set(xlabel=r"damping $\gamma\delta^{-1/4}$", ylabel=r"overshoot, $\max u/\delta - 1$")
    height.set(xlabel="contact $n$", ylabel=r"height $\delta$", xscale="log", yscale="log")
    height.set_xticks(fronts["contact"].values, map(str, fronts["contact"].values))
    height.minorticks_off()
    height.set_yticks(HEIGHTS, map(str, HEIGHTS))
    figure.legend(handles=[*height.lines, overshoot.lines[-2]], loc="outside lower center", ncols=6)
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
            fronts=snakemake.input.fronts,
        )
