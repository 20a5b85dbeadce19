"""Restitution of a ball on a plate, and published points."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

MARKERS = "os^Dv"
FACES = ("full", "none")
UNIT = 1e-10


def chatterjee_2022_restitution(falls: xr.Dataset) -> Figure:
    """Draw e and the distances of published points.

    Parameters
    ----------
    falls : xarray.Dataset
        Balls on a plate of several laws, with and without load.
    """
    figure, panels = new_figure(4.0, [["loss"], ["loss"], ["distance"]], sharex=True)
    loss, distance = panels.values()
    for law, color, marker in zip(falls["law"].values, PROBE_COLOURS, MARKERS, strict=False):
        alpha, beta = (float(falls[name].sel(law=law)) for name in ("alpha", "beta"))
        words = rf"$\alpha = {alpha:g}$, $\beta = {beta:g}$"
        for load, face, line in zip(falls["load"].values, FACES, ("-", ":"), strict=False):
            one = falls.sel(law=law, load=load)
            look = {"color": color, "marker": marker, "ls": "", "fillstyle": face}
            for values, how in (("restitution", {"color": color, "ls": line}), ("published", look)):
                loss.plot(one["damping"], (1.0 - one[values]) / one["damping"], **how)
            apart = (one["published"] - one["restitution"]) / UNIT
            distance.plot(one["damping"], apart, **look, label=None if load else words)
        loss.plot(0.0, falls["first_order"].sel(law=law), "_", color=color, ms=9, clip_on=False)
    distance.axhline(0.0, color="k", lw=0.5)
    distance.set(xlabel=r"damping $\gamma$", ylabel=r"distance, $10^{-10}$")
    distance.set_xlim(left=0.0)
    loss.set(ylabel=r"$(1 - e)/\gamma$")
    figure.legend(loc="outside lower center", ncols=2)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            chatterjee_2022_restitution,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            falls=snakemake.input.falls,
        )
