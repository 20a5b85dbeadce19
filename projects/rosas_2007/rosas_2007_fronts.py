"""Fronts behind impacts and exact fronts: shape, overshoot and height."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

MARKERS = "os^D"
HEIGHTS = (0.01, 0.02, 0.04)


def rosas_2007_fronts(fronts: xr.Dataset) -> Figure:
    """Draw the fronts of chains and exact fronts.

    Parameters
    ----------
    fronts : xarray.Dataset
        Fronts at several contacts, for several dampings.
    """
    figure, panels = new_figure(2.5, [["shape", "overshoot", "height"]])
    shape, overshoot, height = panels.values()
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
    figure.legend(loc="outside lower center", ncols=6)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            rosas_2007_fronts,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            fronts=snakemake.input.fronts,
        )
