"""Figure 8: the heteroclinic orbit, weakly and critically damped; James (2021), figure 8."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, fill_rows, new_figure
from job import job

BLACK, BLUE = PROBE_COLOURS[:2]
GREY = "0.55"

# Distance in points of a trajectory between the arrow's foot and its head.
ARROW_POINTS = 2


def fig08(data: xr.Dataset) -> Figure:
    """Draw the double well, the phase portrait, and the fronts.

    Parameters
    ----------
    data : xarray.Dataset
        Scene front_profiles.
    """
    fronts = [f"front {mu:g}" for mu in data["mu"].values]
    rows = [["well", "portrait"], *fill_rows(fronts, 2)]
    figure, panels = new_figure(1.9 * len(rows), rows)
    _draw_well(panels["well"], data)
    _draw_portrait(panels["portrait"], data)
    for panel, mu in zip(fronts, data["mu"].values, strict=True):
        _draw_front(panels[panel], data.sel(mu=mu))
    return figure


def _draw_well(axes: Axes, data: xr.Dataset) -> None:
    """W(y), and an arrow from the bottom of the well at y = 1 to the saddle at 0."""
    axes.plot(data["y"], data["potential"], color=BLACK, linestyle="-")
    well = float(data["potential"].sel(y=1.0, method="nearest"))
    axes.plot([0.0, 1.0], [0.0, well], "o", color=BLUE)
    axes.annotate(
        "",
        xy=(0.03, 0.01),
        xytext=(1.0, well + 0.015),
        arrowprops={
            "arrowstyle": "-|>",
            "color": BLUE,
            "linewidth": 1.0,
            "connectionstyle": "arc3,rad=0.35",
            "shrinkA": 3,
            "shrinkB": 3,
        },
    )
    axes.text(1.0, well - 0.012, "behind", ha="center", va="top", color=BLUE)
    axes.text(0.0, 0.012, "ahead", ha="right", color=BLUE)
    axes.set(xlabel="force $y$", ylabel="potential $W(y)$", title="double well")
    axes.margins(y=0.15)
    axes.set(xlim=(data["y"][0], data["y"][-1]))


def _draw_portrait(axes: Axes, data: xr.Dataset) -> None:
    """Trajectories in the plane of y and z = y', arrows towards larger s; the orbit in blue."""
    for number in data["trajectory"].values:
        trajectory = data.sel(trajectory=number)
        y, z = trajectory["rescaled_force_portrait"], trajectory["slope_portrait"]
        axes.plot(y, z, color=GREY, linestyle="-", linewidth=0.5)
        _draw_arrow(axes, y.values, z.values, data["s_portrait"].values, GREY)
    front = data.sel(mu=data.attrs["portrait_mu"])
    y, z = front["rescaled_force"], front["slope"]
    axes.plot(y, z, color=BLUE, linestyle="-", linewidth=1.2)
    _draw_arrow(axes, y.values, z.values, data["s"].values, BLUE)
    axes.plot([-1.0, 0.0, 1.0], [0.0, 0.0, 0.0], "o", color=BLACK)
    title = f"phase portrait, {_title_of(data.attrs['portrait_mu'])}"
    axes.set(xlabel="force $y$", ylabel="slope $z = y'$", title=title)
    axes.set(xlim=(-1.75, 1.75), ylim=(-1.25, 1.25))


def _draw_arrow(axes: Axes, y: np.ndarray, z: np.ndarray, s: np.ndarray, colour: str) -> None:
    """An arrow head on a trajectory at s = 0."""
    foot = np.argmin(np.abs(s))
    head = foot + ARROW_POINTS
    axes.annotate(
        "",
        xy=(y[head], z[head]),
        xytext=(y[foot], z[foot]),
        arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 0.6, "shrinkB": 0},
    )


def _draw_front(axes: Axes, front: xr.Dataset) -> None:
    """y_h(s) of one damping."""
    axes.axhline(1.0, color=GREY, linewidth=0.6, linestyle=":")
    axes.plot(front["s"], front["rescaled_force"], color=BLUE, linestyle="-")
    title = f"front, {_title_of(float(front['mu']))}"
    axes.set(xlabel="place $s$", ylabel=r"force $y_\mathrm{h}(s)$", title=title)
    highest = float(front["rescaled_force"].max())
    axes.set(xlim=(front["s"][0], front["s"][-1]), ylim=(0.0, max(1.5, 1.05 * highest)))


def _title_of(mu: float) -> str:
    """The damping of a panel."""
    return rf"$\mu = {mu:g}$"


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig08,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
