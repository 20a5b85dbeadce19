"""Shares of numbers whose true error exceeds a multiple of the stated one."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure
from job import job

FEW, TWICE, TENFOLD = 5e-3, 2.0, 10.0
LEAST_RATIO, LARGEST_RATIO, LEAST_SHARE = 3e-4, 30.0, 3e-5


def honest_errors(chains: xr.Dataset, fronts: xr.Dataset, rings: xr.Dataset) -> Figure:
    """Draw a curve for each kind of problem, and what they should not enter.

    Parameters
    ----------
    chains, fronts, rings : xarray.Dataset
        Written by measure_honest_errors.
    """
    figure, panels = new_figure(2.8, [["shares"]])
    axes, problems = panels["shares"], {"chains": chains, "exact fronts": fronts, "rings": rings}
    for (kind, data), colour, line in zip(
        problems.items(), PROBE_COLOURS, PROBE_STYLES, strict=False
    ):
        ratios = np.sort(data["ratio"].values)
        shares = [1.0, *(1.0 - np.arange(ratios.size) / ratios.size), 0.1 * LEAST_SHARE]
        ends = np.clip([LEAST_RATIO, *ratios, ratios[-1]], LEAST_RATIO, 2 * LARGEST_RATIO)
        label = f"{kind}: {ratios.size} numbers, {np.mean(ratios > TWICE):.2%} above {TWICE:g}"
        axes.step(ends, shares, color=colour, linestyle=line, label=label)
    axes.fill_between([TWICE, TENFOLD], FEW, 1.0, color="0.88", linewidth=0.0)
    axes.fill_between([TENFOLD, LARGEST_RATIO], LEAST_SHARE, 1.0, color="0.78", linewidth=0.0)
    place = np.sqrt(TWICE * TENFOLD), 1.5 * FEW
    axes.text(*place, "should be empty", rotation=90, ha="center")
    axes.set(xlabel="true error / stated error", ylabel="share of numbers above")
    axes.set(xscale="log", yscale="log")
    axes.set(xlim=(LEAST_RATIO, LARGEST_RATIO), ylim=(LEAST_SHARE, 1.2))
    axes.set_xticks([0.001, 0.1, 1.0, TWICE, TENFOLD], ["0.001", "0.1", "1", "2", "10"])
    axes.minorticks_off()
    figure.legend(loc="outside upper center")
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            honest_errors,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            chains=snakemake.input.chains,
            fronts=snakemake.input.fronts,
            rings=snakemake.input.rings,
        )
