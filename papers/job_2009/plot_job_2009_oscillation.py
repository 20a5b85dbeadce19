"""Compressions on both sides of a light intruder, its frequency and the law of it."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import new_figure


def plot_job_2009_oscillation(motion: xr.Dataset, sizes: xr.Dataset) -> Figure:
    """Draw one motion, and frequencies over the size.

    Parameters
    ----------
    motion : xarray.Dataset
        Motion of a chain with an intruder.
    sizes : xarray.Dataset
        Frequencies of intruders, and the law.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.3, [["motion", "motion", "frequency", "ratio"]])
    u, times = motion["relative_displacement_intruder"], motion["t_intruder"]
    for side, style in zip(range(2), ("k-", "C0--"), strict=True):
        panels["motion"].plot(times, u.isel(bead_intruder=side), style, lw=0.9)
    panels["motion"].plot(times, u.mean("bead_intruder"), "k:", lw=0.8)
    panels["motion"].axhline(0.0, color="0.6", lw=0.7, zorder=0)
    panels["motion"].set(xlabel="time $t$", ylabel="$u$", xlim=(times[0], times[-1]))
    chosen = sizes.sel(speed=1)
    panels["frequency"].loglog(chosen["size"], chosen["frequency"], "ko", ms=5, mfc="none")
    panels["frequency"].loglog(chosen["size"], chosen["law"], "k-", lw=0.9)
    for edge, style in zip(sizes["edge"].values, ("--", ":"), strict=True):
        panels["frequency"].axhline(edge, color="k", ls=style, lw=0.9)
    ratio, error = (chosen[name] / chosen["law"] for name in ("frequency", "frequency_error"))
    panels["ratio"].errorbar(chosen["size"], ratio, error, fmt="ko", ms=4, mfc="none", lw=0.9)
    panels["ratio"].axhline(1.0, color="k", lw=0.9)
    panels["ratio"].set(xscale="log", yticks=[0.9, 1.0, 1.1])
    for name, label in (("frequency", r"frequency $\omega$"), ("ratio", "frequency over the law")):
        panels[name].set(xlabel="size of the intruder", ylabel=label)
        panels[name].set_xticks([0.2, 0.4, 0.8], ["0.2", "0.4", "0.8"])
        panels[name].minorticks_off()
    panels["frequency"].set_yticks([3.0, 10.0, 30.0], ["3", "10", "30"])
    return figure


if __name__ == "__main__":
    run_figure(plot_job_2009_oscillation, globals().get("snakemake"))
