"""How far each continuum front is from the exact one, over the damping."""

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import CONTINUUM_LOOKS, fill_rows, new_figure
from job import job

COLUMNS = 3
# Where the name of a curve is: its place along the curve, and how far from it in points.
NAMES = {
    "logarithmic": (0.98, (0, 16), "right"),
    "unlimited": (0.78, (-8, -8), "right"),
    "heteroclinic": (0.0, (0, -16), "left"),
}


def continuum_errors(data: xr.Dataset) -> Figure:
    """Draw the sup-norm errors of u, a panel for each exponent.

    Parameters
    ----------
    data : xarray.Dataset
        The survey of exact fronts.
    """
    names = [f"{alpha:g}" for alpha in data["alpha"].values]
    rows = fill_rows(names, COLUMNS)
    figure, panels = new_figure(1.9 * len(rows), rows)
    for row in rows:
        drawn = [panels[name] for name in row if name != "."]
        for axes in drawn[1:]:
            axes.sharey(drawn[0])
        drawn[0].set_ylabel(r"largest error of $u/\delta$")
        for axes in drawn:
            axes.set_xlabel(r"damping $\gamma c$")
    for name, alpha in zip(names, data["alpha"].values, strict=True):
        _draw_errors(panels[name], data.sel(alpha=alpha))
    _name_curves(panels[names[0]], data.isel(alpha=0))
    last = panels[names[-1]]
    look: dict[str, Any] = {"ha": "right", "color": "0.4"}
    place = float(data["critical_damping"][-1]), 0.03
    last.text(*place, "tail stops \noscillating ", transform=last.get_xaxis_transform(), **look)
    return figure


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Errors of the three fronts for one exponent, and the damping where the tail turns real."""
    for front, look in CONTINUUM_LOOKS.items():
        axes.loglog(data["gamma"], data[f"distance_{front}"], **look._asdict())
    axes.axvline(float(data["critical_damping"]), color="0.6", linewidth=0.5, linestyle="-")
    axes.set_title(rf"$\alpha = {float(data['alpha']):g}$")


def _name_curves(axes: Axes, data: xr.Dataset) -> None:
    """Write each name on its curve."""
    for front, (place, offset, side) in NAMES.items():
        label, colour, _ = CONTINUUM_LOOKS[front]
        at = data.isel(gamma=int(place * (data.sizes["gamma"] - 1)))
        axes.annotate(
            label.replace(" ", "\n"),
            (float(at["gamma"]), float(at[f"distance_{front}"])),
            xytext=offset,
            textcoords="offset points",
            ha=side,
            va="center",
            color=colour,
        )


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            continuum_errors,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
