"""Figure 13: multipliers of exact fronts, flow over a bead-time and shift back."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import finish_grid
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure

MARKERS = ("o", "s", "^", "d")
CIRCLE = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 400))


def plot_fig13(data: xr.Dataset) -> Figure:
    """Draw the spectra in the complex plane, and how the gap closes with the window.

    Parameters
    ----------
    data : xarray.Dataset
        The multipliers.
    """
    fronts = list(data["scene"].values)
    figure, panels = new_figure(6.2, [fronts, [f"{front} near 1" for front in fronts]])
    for front in fronts:
        one = data.sel(scene=front)
        _draw_spectrum(panels[front], one)
        _draw_neighbourhood(panels[f"{front} near 1"], one)
    lowest = [panels[f"{front} near 1"] for front in fronts]
    finish_grid(figure, lowest, r"Re $z$", columns=3)
    return figure


def _draw_spectrum(axes: Axes, data: xr.Dataset) -> None:
    """The unit circle, waves in the compressed chain behind the front, and every window."""
    axes.plot(CIRCLE.real, CIRCLE.imag, "-", color="0.6", linewidth=0.7)
    for branch in data["branch"].values:
        real, imaginary = (
            data[f"essential_multiplier_{part}"].sel(branch=branch)
            for part in ("real", "imaginary")
        )
        label = "compressed chain" if branch == data["branch"].values[0] else None
        axes.plot(real, imaginary, ".", color="0.75", markersize=2, label=label)
    for number, behind in enumerate(data["beads_behind"].values):
        spectrum = data.sel(beads_behind=behind)
        axes.plot(
            spectrum["multiplier_real"],
            spectrum["multiplier_imaginary"],
            MARKERS[number % len(MARKERS)],
            color=PROBE_COLOURS[number % len(PROBE_COLOURS)],
            fillstyle="none",
            markersize=3.5,
            markeredgewidth=0.7,
            label=f"{behind} beads behind",
        )
    law = rf"$\alpha = {float(data['alpha']):g}$, $\gamma c = {float(data['gamma']):g}$"
    axes.set(title=law, xlabel=r"Re $z$", ylabel=r"Im $z$", aspect="equal")


def _draw_neighbourhood(axes: Axes, data: xr.Dataset) -> None:
    """The same near z = 1, where the multipliers of long waves come close with the window."""
    _draw_spectrum(axes, data)
    axes.plot(1.0, 0.0, "+", color=ALARM_COLOUR, markersize=9, label="translation")
    axes.set(xlim=(0.7, 1.03), ylim=(-0.3, 0.3), title="", aspect="auto")


if __name__ == "__main__":
    run_figure(plot_fig13, globals().get("snakemake"))
