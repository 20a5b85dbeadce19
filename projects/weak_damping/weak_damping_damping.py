"""Weakly damped fronts: shape, length of their oscillations, and how a chain comes to them."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

MARKERS = "os^Dv"


def weak_damping_damping(shocks: xr.Dataset, fronts: xr.Dataset) -> Figure:
    """Draw exact fronts and their limit, and the crests of chains over γn.

    Parameters
    ----------
    shocks : xarray.Dataset
        Crests of driven chains without and with damping.
    fronts : xarray.Dataset
        Exact fronts of weak damping, and waves.
    """
    figure, panels = new_figure(4.2, [["shape", "zone"], ["height", "length"]])
    limit = float(fronts["zone_limit"])
    shape, zone, height, length = panels.values()
    shape.plot(fronts["damped_distance"], fronts["front"].isel(gamma=1), "k-", lw=0.5)
    for name in ("crest", "trough"):
        shape.plot(fronts["damped_distance_wave"], fronts[name], "--", color=PROBE_COLOURS[1])
    shape.set(xlabel=r"$\gamma$ × beads behind the first crest", ylabel="$u$", xlim=(-0.02, 0.5))
    last = fronts.isel(gamma=slice(-2, None))
    slope = np.diff(last["zone"].values) / np.diff(last["gamma"].values)
    places = np.array([0.0, float(fronts["gamma"].max())])
    zone.plot(fronts["gamma"], fronts["zone"], "ko")
    zone.plot(places, last["zone"].values[-1] + slope * (places - last["gamma"].values[-1]), "k:")
    zone.axhline(limit, color="k", ls="--", lw=0.6)
    zone.set(xlabel=r"damping $\gamma$", ylabel=r"zone × $\gamma$")
    zone.locator_params(axis="x", nbins=5)
    free, *others = (shocks.isel(gamma=place) for place in range(shocks.sizes["gamma"]))
    looks = zip(others, PROBE_COLOURS, MARKERS, strict=False)
    for one, color, marker in looks:
        gamma = float(one["gamma"])
        scaled = gamma * one["contact"]
        look = {"color": color, "marker": marker, "ls": "none", "mfc": "none"}
        height.plot(scaled, one["height"], label=rf"$\gamma = {gamma:g}$", **look)
        length.plot(scaled, gamma * one["zone"], **look)
    for level in (float(free["height"][-1]), 1.0 + float(fronts["overshoot_limit"])):
        height.axhline(level, color="k", ls="--", lw=0.6)
    times = np.geomspace(0.05, 0.5)
    length.plot(times, times * float(free["zone"][-1] / free["contact"][-1]), "k:")
    length.axhline(limit, color="k", ls="--", lw=0.6)
    height.set(xlabel=r"$\gamma n$", ylabel="leading crest", xscale="log")
    length.set(xlabel=r"$\gamma n$", ylabel=r"zone × $\gamma$", xscale="log", ylim=(0, 0.4))
    figure.legend(*height.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            weak_damping_damping,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            shocks=snakemake.input.shocks,
            fronts=snakemake.input.fronts,
        )
