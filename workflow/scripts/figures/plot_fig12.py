"""Figure 12: critical damping in its several meanings, over the overshoot of the exact front."""

import matplotlib
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import draw_plane
from granular_fronts.output.style import PROBE_COLOURS, new_figure

CURVES = {
    "tail": ("tail: what governs the decay", PROBE_COLOURS[0], "-"),
    "double_root": ("double root", PROBE_COLOURS[1], (0, (6, 1.5))),
    "long_wave": ("long waves, $((1-1/\\alpha)/3)^{1/2}$", PROBE_COLOURS[2], "-."),
    "overshoot": ("overshoot of CUT", PROBE_COLOURS[4], (0, (3, 1))),
}
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
    for name, (label, colour, line) in CURVES.items():
        curve = data[f"critical_damping_{name}"]
        text = label.replace("CUT", f"{data.attrs['overshoot_cut']:g}")
        axes.plot(curve["alpha"], curve, color=colour, linestyle=line, label=text)
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
