"""Rates of both tails of overdamped fronts, and what is proved."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import BLUE, MAGENTA, new_figure
from job import job
from overdamped_fronts import ALPHA, roots

DAMPING = np.geomspace(0.1, 22.0, 400)


def herrmann_2025_rates(fronts: xr.Dataset) -> Figure:
    """Draw measured rates on tail roots, and proofs, over the damping.

    Parameters
    ----------
    fronts : xarray.Dataset
        Overdamped fronts.
    """
    figure, panels = new_figure(3.4, [["rates"], ["rates"], ["rates"], ["proved"]], sharex=True)
    rates, proved = panels.values()
    for tail, colour, mark, share in (
        ("ahead", MAGENTA, "s", 1.0),
        ("behind", BLUE, "o", ALPHA - 1.0),
    ):
        rates.plot(DAMPING, [roots(gamma)[tail] for gamma in DAMPING], "-", color=colour)
        rates.plot(DAMPING, share / DAMPING, ":", color=colour, lw=0.6)
        look = {"color": colour, "mfc": "none", "ls": "none", "label": tail}
        rates.plot(fronts["gamma"], fronts[tail], mark, **look)
    rates.set(xscale="log", yscale="log", ylabel="rate of decay per bead")
    rates.legend()
    for damping, bound in zip(fronts["certificate"], fronts["overshoot_bound"], strict=True):
        proved.plot(damping, 0.0, "kD", mfc="white" if bound > 0.0 else "black")
    look = {"arrowstyle": "->", "linestyle": "--", "lw": 0.8}
    proved.annotate("", (DAMPING[-1], 1.0), (float(fronts["gamma"][-3]), 1.0), arrowprops=look)
    proved.set(title="fronts that are proved", ylim=(-0.6, 1.6), xlabel=r"damping $\gamma$")
    proved.set_yticks([0.0, 1.0], ["here", r"for large $\gamma$"])
    for axes in panels.values():
        axes.axvline(fronts.attrs["critical_damping"], color="0.6", lw=0.6)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            herrmann_2025_rates,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            fronts=snakemake.input.fronts,
        )
