"""Figure 21b: for how long the amplitude equations hold, and their errors against damping."""

import matplotlib
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from plot_fig21 import SLOW_TIME, draw_rings, finish_plane, place_of

from figure_step import run_figure
from granular_fronts.output.style import MODEL_LOOKS, new_figure

LOSSES = (1, 5, 10)
CLOSE = 1.05
MARKERS = ("o", "s", "^")
FIRST_SHOWN = 2.0**-4
"""The first of the times between which losses are interpolated; earlier ones are one colour."""


def plot_fig21b(rings: xr.Dataset, weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw the times of loss, and errors against γc.

    Parameters
    ----------
    rings : xarray.Dataset
        Campaign rings_map.
    weak, hertz : xarray.Dataset
        The two runs of the paper, whose places are marked.
    """
    planes = [[f"{model}_{loss}" for loss in LOSSES] for model in MODEL_LOOKS]
    figure, panels = new_figure(9.0, [*planes, ["scaled"] * 3])
    _draw_losses(figure, panels, rings)
    _draw_scaled(panels["scaled"], rings.sel(slow_time=SLOW_TIME))
    for name in (name for row in planes for name in row):
        finish_plane(panels[name], rings, [place_of(scene) for scene in (weak, hertz)])
    return figure


def _draw_losses(figure: Figure, panels: dict[str, Axes], rings: xr.Dataset) -> None:
    """Times of loss of every equation, with one scale for all."""
    drawn = [(model, loss) for model in MODEL_LOOKS for loss in LOSSES]
    for model, loss in drawn:
        axes = panels[f"{model}_{loss}"]
        image = _draw_loss(axes, rings, f"lost_{loss}_{model}")
        axes.set_title(f"{MODEL_LOOKS[model].label},\n{loss} %", fontsize=7)
    label = r"slow time $\tau$ of the loss; black: below 1/16, grey: not seen"
    places = [panels[f"{model}_{loss}"] for model, loss in drawn]
    figure.colorbar(image, ax=places, location="bottom", aspect=50, label=label, extend="both")


def _draw_loss(axes: Axes, rings: xr.Dataset, name: str) -> QuadMesh:
    """Slow time at which an equation has lost a part; beyond the last one grey."""
    last = rings["slow_time"].values[-1]
    times = rings[name].sel(slow_time=last)
    solved = rings["status"].sel(slow_time=last) == 0
    shown = times.fillna(2.0 * last).where(solved)
    colours = matplotlib.colormaps["viridis"].with_extremes(over="0.85", under="black")
    return draw_rings(axes, shown, colours, LogNorm(FIRST_SHOWN, last))


def _draw_scaled(axes: Axes, rings: xr.Dataset) -> None:
    """Errors at τ = 1 over 1 − 1/α against γc, for the exponents up to `CLOSE`."""
    close = rings.sel(alpha=rings["alpha"][rings["alpha"] <= CLOSE])
    for (model, look), marker in zip(MODEL_LOOKS.items(), MARKERS, strict=True):
        scaled = close[f"displacement_sup_{model}"] / (1.0 - 1.0 / close["alpha"])
        for row, alpha in enumerate(close["alpha"].values):
            axes.plot(
                close["gamma"],
                scaled.sel(alpha=alpha),
                marker,
                color=look.color,
                markersize=3,
                linestyle="none",
                label=look.label if row == 0 else None,
            )
    axes.set(xscale="log", yscale="log", xlabel=r"damping $\gamma c$")
    axes.set_ylabel(r"error$/(1 - 1/\alpha)$")
    axes.set_title(rf"all exponents up to $\alpha = {CLOSE:g}$, $\tau = 1$")
    axes.legend(loc="upper right")


if __name__ == "__main__":
    run_figure(plot_fig21b, globals().get("snakemake"))
