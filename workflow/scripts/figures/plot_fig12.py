"""Figure 12: critical damping in its several meanings, over the overshoot of the exact front."""

import matplotlib
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import draw_critical_damping, draw_plane
from granular_fronts.output.style import new_figure

SMALLEST_SHOWN = 1e-8


def plot_fig12(data: xr.Dataset) -> Figure:
    """Draw the curves and the overshoot as colour.

    Parameters
    ----------
    data : xarray.Dataset
        The damping map.
    """
    figure, panels = new_figure(4.4, [["plane"]])
    axes = panels["plane"]
    _draw_overshoot(axes, data)
    draw_critical_damping(axes, data, "tail", "double_root", "long_wave", "overshoot")
    axes.axvline(data.attrs["exchange_exponent"], color="0.4", linewidth=0.7, linestyle=":")
    axes.set(xlabel=r"$\alpha$", ylabel=r"$\gamma c$", yscale="log")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure


def _draw_overshoot(axes: Axes, data: xr.Dataset) -> None:
    """Overshoot max u − 1 on a logarithmic scale; white where a front has none to speak of."""
    overshoot = data["overshoot"].where(data["overshoot"] > SMALLEST_SHOWN)
    norm = LogNorm(SMALLEST_SHOWN, 1.0)
    image = draw_plane(axes, overshoot, matplotlib.colormaps["viridis_r"], norm)
    axes.figure.colorbar(image, ax=axes, label=r"overshoot $\max u/\delta - 1$", extend="min")


if __name__ == "__main__":
    run_figure(plot_fig12, globals().get("snakemake"))
