"""The theta-method damps like the Kuwabara–Kono law; James (2021), section 1."""

from itertools import cycle

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure
from job import job

MARKERS = "os^v"


def numerical_damping(data: xr.Dataset) -> Figure:
    """Draw a front of the method, damped and conservative chains, and their distances.

    Parameters
    ----------
    data : xarray.Dataset
        Numerical damping.
    """
    figure, panels = new_figure(4.4, [["profile"], ["order"]])
    _draw_profile(panels["profile"], data)
    _draw_distances(panels["order"], data)
    return figure


def _draw_profile(axes: Axes, data: xr.Dataset) -> None:
    """u_n of the three chains."""
    profile = configuration_of(data)["profile"]
    gamma = (2.0 * profile["theta"] - 1.0) * profile["step"]
    method = rf"$\theta = {profile['theta']:g}$, $h = {profile['step']:g}$"
    lines = [
        ("conservative", "-", 0.5, "#b0b0b0", "chain without damping"),
        ("damped", "-", 0.9, EQUATION_COLOUR, rf"chain with damping, $\gamma = {gamma:g}$"),
        ("method", ".", 0.0, CHAIN_COLOUR, f"no damping, by the method, {method}"),
    ]
    for name, style, width, colour, label in lines:
        values = data[f"relative_displacement_{name}"]
        axes.plot(values["bead"], values, style, linewidth=width, color=colour, label=label)
    axes.set(
        xlabel="bead $n$",
        ylabel="compression $u_n$",
        title=f"a front at $t = {profile['end_time']:g}$",
        xlim=(0, profile["beads"]),
    )
    axes.set_ylim(top=1.05 * float(data["relative_displacement_conservative"].max()))
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.1))


def _draw_distances(axes: Axes, data: xr.Dataset) -> None:
    """Distances of the method to the damped chain and to the conservative one, against h."""
    looks = cycle(zip(PROBE_COLOURS, MARKERS, strict=False))
    for theta, (colour, marker) in zip(data["theta"].values, looks, strict=False):
        row = data.sel(theta=theta)
        label = rf"$\theta = {theta:g}$, order {float(row['order']):.2f}"
        look = {"color": colour, "marker": marker}
        axes.loglog(row["step"], row["damping_distance"], "-", label=label, **look)
        axes.loglog(row["step"], row["conservative_distance"], ":", **look)
    axes.set(
        xlabel="step $h$",
        ylabel=r"distance $\max_n |\Delta u_n|/\delta$",
        title="solid: to the damped chain, dotted: undamped",
    )
    axes.set_ylim(top=2.0)
    axes.legend(loc="lower right")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            numerical_damping,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
