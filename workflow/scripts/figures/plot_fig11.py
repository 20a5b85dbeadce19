"""Figure 11: how far each continuum front is from the exact one, over the damping."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import CONTINUUM_LOOKS, fill_rows, new_figure

COLUMNS = 3


def plot_fig11(data: xr.Dataset) -> Figure:
    """Draw the sup-norm errors of u, a panel for each exponent.

    Parameters
    ----------
    data : xarray.Dataset
        The survey of exact fronts.
    """
    exponents = data["alpha"].values
    names = [f"{alpha:g}" for alpha in exponents]
    rows = fill_rows(names, COLUMNS)
    figure, panels = new_figure(2.3 * len(rows), rows)
    for alpha in exponents:
        _draw_errors(panels[f"{alpha:g}"], data.sel(alpha=alpha))
    for row in rows:
        panels[row[0]].set_ylabel("largest error of $u/\\delta$")
    for name in rows[-1]:
        if name != ".":
            panels[name].set_xlabel(r"$\gamma c$")
    panels[names[0]].legend(loc="lower left")
    return figure


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Errors of the three fronts for one exponent, and the damping where the tail turns real."""
    for front, (label, colour, line) in CONTINUUM_LOOKS.items():
        axes.loglog(
            data["gamma"], data[f"distance_{front}"], color=colour, linestyle=line, label=label
        )
    axes.axvline(float(data["critical_damping"]), color="0.6", linewidth=0.7, linestyle="-")
    axes.set(title=rf"$\alpha = {float(data['alpha']):g}$", ylim=(3e-5, 1.0))


if __name__ == "__main__":
    run_figure(plot_fig11, globals().get("snakemake"))
