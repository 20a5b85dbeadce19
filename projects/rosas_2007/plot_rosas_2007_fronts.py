"""Fronts behind impacts and exact fronts: shape, overshoot and height."""

import xarray as xr
from matplotlib.figure import Figure

from granular_fronts.output.style import PROBE_COLOURS, new_figure

MARKERS = "os^D"
HEIGHTS = (0.01, 0.02, 0.04)


def plot_rosas_2007_fronts(fronts: xr.Dataset) -> Figure:
    """Draw the fronts of chains and exact fronts.

    Parameters
    ----------
    fronts : xarray.Dataset
        Fronts at several contacts, for several dampings.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.4, [["shape", "overshoot", "height"]])
    last = fronts["contact"].values[-1]
    exact = fronts["exact_overshoot"].stack(point=("gamma", "contact"))
    for gamma, color, marker in zip(fronts["gamma"].values, PROBE_COLOURS, MARKERS, strict=False):
        one = fronts.sel(gamma=gamma)
        front = one.sel(contact=last)
        panels["shape"].plot(front["xi"], front["exact_front"], color=color, lw=0.8)
        panels["shape"].plot(front["xi"][::10], front["front"][::10], marker, color=color, ms=2.5)
        panels["overshoot"].plot(one["damping"], one["overshoot"], marker, color=color, ms=4)
        panels["height"].plot(
            one["contact"], one["height"], marker, color=color, ms=4, label=rf"$\gamma = {gamma:g}$"
        )
    order = fronts["damping"].values.ravel().argsort()
    panels["overshoot"].plot(
        fronts["damping"].values.ravel()[order],
        exact.values[order],
        "k-",
        lw=0.8,
        label="exact front",
    )
    panels["overshoot"].axvline(fronts.attrs["critical_damping"], color="k", ls=":", lw=0.8)
    panels["height"].plot(
        fronts["contact"],
        fronts["height_of_momentum"].isel(gamma=-1),
        "k--",
        lw=0.8,
        label="by momentum",
    )
    panels["shape"].set(xlabel=r"$\xi = n - ct$", ylabel=r"$u/\delta$", xlim=(-25, 6))
    panels["overshoot"].set(
        xlabel=r"damping $\gamma\delta^{-1/4}$", ylabel=r"overshoot, $\max u/\delta - 1$"
    )
    panels["height"].set(
        xlabel="contact $n$", ylabel=r"height $\delta$", xscale="log", yscale="log"
    )
    panels["height"].set_xticks(fronts["contact"].values, map(str, fronts["contact"].values))
    panels["height"].minorticks_off()
    panels["height"].set_yticks(HEIGHTS, map(str, HEIGHTS))
    named = [panels[panel].get_legend_handles_labels() for panel in ("height", "overshoot")]
    handles, labels = (first + second for first, second in zip(*named, strict=True))
    figure.legend(handles, labels, loc="outside lower center", ncols=6)
    return figure
