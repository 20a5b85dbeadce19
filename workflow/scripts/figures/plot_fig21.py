"""Figure 21: which amplitude equation is best over exponent and damping, and how good it is."""

from typing import Any

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
RATIOS = {0.1: "-", 1.0: "--"}
LARGEST_ERROR = 0.1


def plot_fig21(rings: xr.Dataset, weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw the best equation and its error.

    Parameters
    ----------
    rings : xarray.Dataset
        Campaign rings_map.
    weak, hertz : xarray.Dataset
        The two runs of the paper, whose places are marked.
    """
    figure, panels = new_figure(3.9, [["best", "error"]])
    at_one = rings.sel(slow_time=SLOW_TIME)
    _draw_best(panels["best"], at_one)
    _draw_least_error(panels["error"], at_one)
    for axes in panels.values():
        finish_plane(axes, rings, [place_of(scene) for scene in (weak, hertz)])
    return figure


def draw_rings(axes: Axes, values: xr.DataArray, colour_map: Colormap, norm: Normalize) -> QuadMesh:
    """Colours over α − 1 and γc; rings that are not solved in red."""
    return draw_plane(axes, values, colour_map.with_extremes(bad=ALARM_COLOUR), norm, shift=1.0)


def _draw_best(axes: Axes, rings: xr.Dataset) -> None:
    """The equation with the smallest error of u at τ = 1."""
    errors = np.stack([rings[f"displacement_sup_{model}"] for model in MODEL_LOOKS])
    least = np.where(np.isnan(errors).any(axis=0), np.nan, errors.argmin(axis=0))
    best = rings["displacement_sup_logarithmic"].copy(data=least)
    colours = ListedColormap([look.color for look in MODEL_LOOKS.values()])
    image = draw_rings(axes, best, colours, BoundaryNorm(np.arange(-0.5, 3.0), 3))
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=20, ticks=[0, 1, 2])
    words = [look.label.replace(" ", "\n") for look in MODEL_LOOKS.values()]
    bar.ax.set_xticklabels(words, fontsize=8)
    bar.set_label("the best equation")


def _draw_least_error(axes: Axes, rings: xr.Dataset) -> None:
    """The smallest error of u at τ = 1 of all equations."""
    errors = [rings[f"displacement_sup_{model}"] for model in MODEL_LOOKS]
    least = xr.concat(errors, "model").min("model")
    norm = LogNorm(float(least.min()), LARGEST_ERROR)
    image = draw_rings(axes, least, matplotlib.colormaps["cividis_r"], norm)
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=20, extend="max")
    bar.set_label(r"its largest error of $u/\delta$ at $\tau = 1$")
    bar.ax.xaxis.set_major_formatter(lambda value, _: f"{100.0 * value:g} %")


def place_of(scene: xr.Dataset) -> tuple[float, float]:
    """α and γc of a run of the paper."""
    asked = configuration_of(scene)
    alpha, gamma = asked["law"]["alpha"], asked["law"]["gamma"]
    return alpha, gamma * asked["displacement"] ** ((alpha - 1.0) / 2.0)


def finish_plane(axes: Axes, rings: xr.Dataset, runs: list[tuple[float, float]]) -> None:
    """Lines of equal ε/γc, the runs of the paper, and the axes."""
    alpha, gamma = rings["alpha"].values, rings["gamma"].values
    for ratio, line in RATIOS.items():
        of_ratio = np.sqrt((1.0 - 1.0 / alpha) / ratio)
        axes.plot(alpha - 1.0, of_ratio, color="white", linestyle=line, linewidth=0.8)
    for exponent, damping in runs:
        look: dict[str, Any] = {"color": "white", "markeredgecolor": "black", "markersize": 11}
        axes.plot(exponent - 1.0, damping, "*", zorder=5, clip_on=False, **look)
    axes.set(xscale="log", yscale="log", xlabel=r"$\alpha - 1$", ylabel=r"damping $\gamma c$")
    axes.set(xlim=(alpha[0] - 1.0, alpha[-1] - 1.0), ylim=(gamma[0], gamma[-1]))


if __name__ == "__main__":
    run_figure(plot_fig21, globals().get("snakemake"))
