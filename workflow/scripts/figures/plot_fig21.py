"""Figure 21: which amplitude equation is best over exponent and damping, and for how long."""

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import BoundaryNorm, Colormap, ListedColormap, LogNorm, Normalize
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_plane
from granular_fronts.output.style import ALARM_COLOUR, MODEL_LOOKS, new_figure

SLOW_TIME = 1.0
LOSSES = (1, 5, 10)
RATIOS = (0.1, 1.0)
CLOSE = 1.05
FIRST_SHOWN = 2.0**-4
"""The first of the times between which losses are interpolated; earlier ones are one colour."""


def plot_fig21(rings: xr.Dataset, weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw the best equation, its error, errors against γc, and the times of loss.

    Parameters
    ----------
    rings : xarray.Dataset
        Campaign rings_map.
    weak, hertz : xarray.Dataset
        The two runs of the paper, whose places are marked.
    """
    rows = [["best", "error", "scaled"]]
    rows += [[f"{model}_{loss}" for loss in LOSSES] for model in MODEL_LOOKS]
    figure, panels = new_figure(8.4, rows)
    at_one = rings.sel(slow_time=SLOW_TIME)
    _draw_best(panels["best"], at_one)
    _draw_least_error(panels["error"], at_one)
    _draw_scaled(panels["scaled"], at_one)
    _draw_losses(figure, panels, rings)
    runs = [_place_of(scene) for scene in (weak, hertz)]
    for name, axes in panels.items():
        if name != "scaled":
            _finish_plane(axes, rings, runs)
    return figure


def _draw_rings(
    axes: Axes, values: xr.DataArray, colour_map: Colormap, norm: Normalize
) -> QuadMesh:
    """Colours over α − 1 and γc; rings that are not solved in red."""
    return draw_plane(axes, values, colour_map.with_extremes(bad=ALARM_COLOUR), norm, shift=1.0)


def _draw_best(axes: Axes, rings: xr.Dataset) -> None:
    """The equation with the smallest error of u at τ = 1."""
    errors = np.stack([rings[f"displacement_sup_{model}"] for model in MODEL_LOOKS])
    least = np.where(np.isnan(errors).any(axis=0), np.nan, errors.argmin(axis=0))
    best = rings["displacement_sup_logarithmic"].copy(data=least)
    colours = ListedColormap([colour for _, colour, _ in MODEL_LOOKS.values()])
    image = _draw_rings(axes, best, colours, BoundaryNorm(np.arange(-0.5, 3.0), 3))
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=20, ticks=[0, 1, 2])
    bar.ax.set_xticklabels([label for label, *_ in MODEL_LOOKS.values()], fontsize=7)


def _draw_least_error(axes: Axes, rings: xr.Dataset) -> None:
    """The smallest error of u at τ = 1 of all equations."""
    errors = [rings[f"displacement_sup_{model}"] for model in MODEL_LOOKS]
    least = xr.concat(errors, "model").min("model")
    image = _draw_rings(
        axes, least, matplotlib.colormaps["viridis_r"], LogNorm(float(least.min()), 0.1)
    )
    label = r"least $\sup|\Delta u|/\delta$, $\tau = 1$"
    axes.figure.colorbar(image, ax=axes, location="top", aspect=20, extend="max", label=label)


def _draw_scaled(axes: Axes, rings: xr.Dataset) -> None:
    """Errors at τ = 1 over 1 − 1/α against γc, for the exponents up to `CLOSE`."""
    close = rings.sel(alpha=rings["alpha"][rings["alpha"] <= CLOSE])
    for model, (_, colour, _) in MODEL_LOOKS.items():
        scaled = close[f"displacement_sup_{model}"] / (1.0 - 1.0 / close["alpha"])
        for alpha in close["alpha"].values:
            axes.plot(
                close["gamma"], scaled.sel(alpha=alpha), ".", color=colour, ms=3, linestyle="none"
            )
    axes.set(xscale="log", yscale="log", xlabel=r"$\gamma c$, $\delta = 1$")
    axes.set_title(
        rf"$\sup|\Delta u|/\delta$ over $1 - 1/\alpha$, $\alpha \leq {CLOSE:g}$", fontsize=7
    )


def _draw_losses(figure: Figure, panels: dict[str, Axes], rings: xr.Dataset) -> None:
    """Times of loss of every equation, with one scale for all."""
    drawn = [f"{model}_{loss}" for model in MODEL_LOOKS for loss in LOSSES]
    for name in drawn:
        model, _, loss = name.rpartition("_")
        image = _draw_loss(panels[name], rings, f"lost_{loss}_{model}")
        panels[name].set_title(f"{MODEL_LOOKS[model][0]} loses {loss} %", fontsize=8)
    label = r"slow time $\tau$; black: below 1/16"
    places = [panels[name] for name in drawn]
    figure.colorbar(image, ax=places, location="bottom", aspect=50, label=label, extend="both")


def _draw_loss(axes: Axes, rings: xr.Dataset, name: str) -> QuadMesh:
    """Slow time at which an equation has lost a part; beyond the last one grey."""
    last = rings["slow_time"].values[-1]
    times = rings[name].sel(slow_time=last)
    solved = rings["status"].sel(slow_time=last) == 0
    shown = times.fillna(2.0 * last).where(solved)
    colours = matplotlib.colormaps["viridis"].with_extremes(over="0.85", under="black")
    return _draw_rings(axes, shown, colours, LogNorm(FIRST_SHOWN, last))


def _place_of(scene: xr.Dataset) -> tuple[float, float]:
    """α and γc of a run of the paper."""
    asked = configuration_of(scene)
    alpha, gamma = asked["law"]["alpha"], asked["law"]["gamma"]
    return alpha, gamma * asked["displacement"] ** ((alpha - 1.0) / 2.0)


def _finish_plane(axes: Axes, rings: xr.Dataset, runs: list[tuple[float, float]]) -> None:
    """Lines of equal ε/γc, the runs of the paper, and the axes."""
    alpha, gamma = rings["alpha"].values, rings["gamma"].values
    for ratio in RATIOS:
        axes.plot(alpha - 1.0, np.sqrt((1.0 - 1.0 / alpha) / ratio), color="0.5", lw=0.8)
    for exponent, damping in runs:
        axes.plot(
            exponent - 1.0,
            damping,
            "*",
            color=ALARM_COLOUR,
            mec="white",
            ms=7,
            mew=0.5,
            clip_on=False,
        )
    axes.set(xscale="log", yscale="log", xlabel=r"$\alpha - 1$", ylabel=r"$\gamma c$, $\delta = 1$")
    axes.set(xlim=(alpha[0] - 1.0, alpha[-1] - 1.0), ylim=(gamma[0], gamma[-1]))


if __name__ == "__main__":
    run_figure(plot_fig21, globals().get("snakemake"))
