"""How far each continuum front is from the exact one, over the damping."""

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import CONTINUUM_LOOKS, LOOKS, fill_rows, new_figure
from job import job

COLUMNS = 3


def continuum_errors(data: xr.Dataset) -> Figure:
    """Draw the sup-norm errors of u, a panel for each exponent.

    Parameters
    ----------
    data : xarray.Dataset
        The survey of exact fronts.
    """
    names = [f"{alpha:g}" for alpha in data["alpha"].values]
    rows = fill_rows(names, COLUMNS)
    figure, panels = new_figure(1.9 * len(rows) + 0.2, rows)
    for row in rows:
        drawn = [panels[name] for name in row if name != "."]
        for axes in drawn[1:]:
            axes.sharey(drawn[0])
        drawn[0].set_ylabel(r"largest error of $u/\delta$")
        for axes in drawn:
            axes.set_xlabel(r"damping $\gamma c$")
    for name, alpha in zip(names, data["alpha"].values, strict=True):
        _draw_errors(panels[name], data.sel(alpha=alpha))
    handles, words = panels[names[0]].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside upper center", ncols=len(words))
    return figure


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Errors of the three fronts for one exponent, and the damping where the tail turns real."""
    for front, look in CONTINUUM_LOOKS.items():
        axes.loglog(data["gamma"], data[f"distance_{front}"], **look._asdict())
    thin: dict[str, Any] = {"color": "0.6", "linewidth": 0.5, "linestyle": "-"}
    axes.axvline(float(data["critical_damping"]), label=LOOKS["tail"].label, **thin)
    axes.set_title(rf"$\alpha = {float(data['alpha']):g}$")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            continuum_errors,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
