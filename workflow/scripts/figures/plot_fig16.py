"""Figure 16: overshoot and width of exact fronts over exponent and damping, and real beads."""

import matplotlib
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, LogNorm
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from figure_step import run_figure
from granular_fronts.output.panels import draw_critical_damping, draw_materials, draw_plane
from granular_fronts.output.style import ALARM_COLOUR, new_figure
from granular_fronts.studies.materials import ALPHA

CURVES = ("tail", "long_wave", "overshoot")
# Places in a panel, as shares of its sides, above and below all curves.
REGIONS = {"monotone": (0.05, 0.92), "oscillating": (0.58, 0.08)}
WIDTHS = (1, 2, 3, 5, 10, 20, 50, 100)
ON_COLOURS = [withStroke(linewidth=2.5, foreground="white")]


def plot_fig16(atlas: xr.Dataset, curves: xr.Dataset, materials: xr.Dataset) -> Figure:
    """Draw the atlas of fronts.

    Parameters
    ----------
    atlas : xarray.Dataset
        Fronts over exponent and damping.
    curves : xarray.Dataset
        Critical damping over α.
    materials : xarray.Dataset
        Beads of remark 6.
    """
    figure, panels = new_figure(4.4, [["overshoot", "width"]])
    _draw_overshoot(panels["overshoot"], atlas, curves.attrs["overshoot_cut"])
    _draw_width(panels["width"], atlas)
    draw_critical_damping(panels["overshoot"], curves, *CURVES)
    gamma, alpha = atlas["gamma"].values, atlas["alpha"].values
    for axes in panels.values():
        draw_materials(axes, materials, ALPHA)
        axes.set(xlabel=r"exponent $\alpha$ of the contact force", yscale="log")
        axes.set(xlim=(alpha[0], alpha[-1]), ylim=(gamma[0], gamma[-1]))
    panels["overshoot"].set_ylabel(r"damping $\gamma c$")
    handles, labels = panels["overshoot"].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def _draw_overshoot(axes: Axes, atlas: xr.Dataset, least: float) -> None:
    """Largest u minus 1, white below the least that one sees, and the two regions."""
    norm = LogNorm(least, 1.0)
    # A logarithmic scale has no colour for 0, the overshoot of a monotone front.
    overshoot = atlas["overshoot"].clip(min=0.1 * least)
    colours = matplotlib.colormaps["viridis_r"].with_extremes(bad=ALARM_COLOUR, under="white")
    image = draw_plane(axes, overshoot, colours, norm)
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=30, extend="min")
    bar.set_label(rf"overshoot; white: below {100.0 * least:g} %")
    bar.ax.xaxis.set_major_formatter(lambda value, _: f"{100.0 * value:g} %")
    for word, (x, y) in REGIONS.items():
        axes.text(x, y, word, transform=axes.transAxes, style="italic", path_effects=ON_COLOURS)


def _draw_width(axes: Axes, atlas: xr.Dataset) -> None:
    """Distance over which u falls from 0.9 to 0.1, in beads, in steps that grey print shows."""
    colours = matplotlib.colormaps["cividis_r"].with_extremes(bad=ALARM_COLOUR)
    norm = BoundaryNorm(WIDTHS, colours.N, extend="both")
    image = draw_plane(axes, atlas["width_10_90"], colours, norm)
    bar = axes.figure.colorbar(image, ax=axes, location="top", aspect=30, spacing="uniform")
    bar.set_label("width of the front, in beads")


if __name__ == "__main__":
    run_figure(plot_fig16, globals().get("snakemake"))
