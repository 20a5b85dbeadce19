"""Figure 16: overshoot, width and regime of exact fronts over the plane of exponent and damping."""

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, ListedColormap, LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from figure_step import run_figure
from granular_fronts.output.panels import draw_critical_damping, draw_plane
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure
from granular_fronts.studies.materials import ALPHA

REGIMES = ("monotone", "oscillating", "by > 1 %")
REGIME_COLOURS = ("#f2efe6", "#b9cbe0", "#5f7fae")
VISIBLE = 0.01


def plot_fig16(atlas: xr.Dataset, curves: xr.Dataset, materials: xr.Dataset) -> Figure:
    """Draw the atlas of fronts.

    Parameters
    ----------
    atlas : xarray.Dataset
        Campaign fronts_atlas.
    curves : xarray.Dataset
        Critical damping over α.
    materials : xarray.Dataset
        Beads of remark 6.
    """
    figure, panels = new_figure(3.6, [["overshoot", "width", "regime"]])
    _draw_overshoot(panels["overshoot"], atlas)
    _draw_width(panels["width"], atlas)
    _draw_regime(panels["regime"], atlas)
    for axes in panels.values():
        draw_critical_damping(axes, curves, "tail", "double_root", "long_wave")
        _draw_materials(axes, materials)
        gamma, alpha = atlas["gamma"].values, atlas["alpha"].values
        axes.set(xlabel=r"$\alpha$", yscale="log", xlim=(alpha[0], alpha[-1]))
        axes.set(ylim=(gamma[0], gamma[-1]))
    panels["overshoot"].set_ylabel(r"$\gamma c$")
    handles, labels = panels["overshoot"].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def _draw_overshoot(axes: Axes, atlas: xr.Dataset) -> None:
    """Largest u minus 1, on a logarithmic scale down to a millionth."""
    norm = LogNorm(1e-6, 1.0)
    # A logarithmic scale has no colour for 0, the overshoot of a monotone front.
    overshoot = atlas["overshoot"].clip(min=1e-7)
    _colour_plane(axes, overshoot, "viridis_r", norm, "overshoot", extend="min")


def _draw_width(axes: Axes, atlas: xr.Dataset) -> None:
    """Distance over which u falls from 0.9 to 0.1, in beads."""
    width = atlas["width_10_90"]
    norm = LogNorm(float(width.min()), float(width.max()))
    _colour_plane(axes, width, "cividis_r", norm, "width, 90 % to 10 %", extend="neither")


def _draw_regime(axes: Axes, atlas: xr.Dataset) -> None:
    """Whether the slowest tail oscillates, and whether one can see it."""
    oscillates = atlas["tail_frequency"] > 0.0
    regime = oscillates.astype(float) + (oscillates & (atlas["overshoot"] > VISIBLE))
    regime = regime.where(atlas["status"] == 0)
    norm = BoundaryNorm(np.arange(-0.5, 3.0), 3)
    colours = ListedColormap(REGIME_COLOURS).with_extremes(bad=ALARM_COLOUR)
    image = draw_plane(axes, regime, colours, norm)
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=30, ticks=[0, 1, 2])
    bar.ax.set_xticklabels(REGIMES, fontsize=7)


def _colour_plane(
    axes: Axes, values: xr.DataArray, colour_map: str, norm: Normalize, label: str, *, extend: str
) -> None:
    """A scalar over the plane with its scale above; points that are not solved in red."""
    colours = matplotlib.colormaps[colour_map]
    colours = colours.with_extremes(bad=ALARM_COLOUR, under=colours(0.0))
    image = draw_plane(axes, values, colours, norm)
    axes.figure.colorbar(image, ax=axes, location="top", aspect=30, label=label, extend=extend)


def _draw_materials(axes: Axes, materials: xr.Dataset) -> None:
    """The places of real beads."""
    for bead in materials["gamma_printed"]:
        axes.plot(ALPHA, bead, "o", color=PROBE_COLOURS[0], markersize=3)
        axes.annotate(
            str(bead["material"].values),
            (ALPHA, float(bead)),
            xytext=(4, 0),
            textcoords="offset points",
            va="center",
            fontsize=7,
            path_effects=[withStroke(linewidth=2, foreground="white")],
        )


if __name__ == "__main__":
    run_figure(plot_fig16, globals().get("snakemake"))
