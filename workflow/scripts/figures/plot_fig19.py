"""Figure 19: the theta-method damps like the Kuwabara–Kono law; James (2021), section 1."""

from itertools import cycle

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure

MARKERS = "os^v"


def plot_fig19(data: xr.Dataset) -> Figure:
    """Draw a front of the method beside damped and conservative chains, and their distances.

    Parameters
    ----------
    data : xarray.Dataset
        Numerical damping.
    """
    figure, panels = new_figure(3.2, [["profile", "order"]])
    _draw_profile(panels["profile"], data)
    _draw_distances(panels["order"], data)
    return figure


def _draw_profile(axes: Axes, data: xr.Dataset) -> None:
    """u_n of the three chains."""
    profile = configuration_of(data)["profile"]
    gamma = (2.0 * profile["theta"] - 1.0) * profile["step"]
    lines = [
        ("conservative", "-", "#b0b0b0", "conservative chain"),
        ("damped", "-", EQUATION_COLOUR, rf"damped chain, $\gamma = {gamma:g}$"),
        (
            "method",
            ".",
            CHAIN_COLOUR,
            rf"$\theta$-method, $\theta = {profile['theta']:g}$, $h = {profile['step']:g}$",
        ),
    ]
    for name, style, colour, label in lines:
        values = data[f"relative_displacement_{name}"]
        axes.plot(values["bead"], values, style, color=colour, markersize=4, label=label)
    axes.set(
        xlabel="$n$",
        ylabel="$u_n$",
        title=f"$t = {profile['end_time']:g}$",
        xlim=(0, profile["beads"]),
    )
    axes.set_ylim(top=1.35 * float(data["relative_displacement_conservative"].max()))
    axes.legend(loc="upper right")


def _draw_distances(axes: Axes, data: xr.Dataset) -> None:
    """Distances of the method to the damped chain and to the conservative one, against h."""
    looks = cycle(zip(PROBE_COLOURS, MARKERS, strict=False))
    for theta, (colour, marker) in zip(data["theta"].values, looks, strict=False):
        row = data.sel(theta=theta)
        label = rf"$\theta = {theta:g}$, order {float(row['order']):.2f}"
        look = {"color": colour, "marker": marker, "markersize": 3.5}
        axes.loglog(row["step"], row["damping_distance"], "-", label=label, **look)
        axes.loglog(row["step"], row["conservative_distance"], ":", **look)
    axes.set(xlabel="$h$", ylabel=r"$\max_n |\Delta u_n|/\delta$")
    axes.set_ylim(top=10.0)
    axes.text(0.05, 0.95, "dotted: to the conservative chain", transform=axes.transAxes, va="top")
    axes.legend(loc="lower right", title="full: to the damped chain", title_fontsize=9)


if __name__ == "__main__":
    run_figure(plot_fig19, globals().get("snakemake"))
