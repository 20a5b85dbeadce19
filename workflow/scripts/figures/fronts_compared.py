"""Exact fronts, driven chains and continuum fronts; after James (2021), section 6.3."""

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import finish_grid
from granular_fronts.output.style import BLACK, CONTINUUM_LOOKS, LOOKS, new_figure
from job import job

LINES = {name: look._asdict() | {"linewidth": 0.7} for name, look in CONTINUUM_LOOKS.items()}
# Broad and pale, so that green dashes are seen on it where both coincide.
LINES["logarithmic"] |= {"linestyle": "-", "linewidth": 2.0, "alpha": 0.4}
FARTHEST_BEHIND = -20.0


def fronts_compared(scenes: list[xr.Dataset]) -> Figure:
    """Draw the compression of every front, and by how much continuum fronts miss it below.

    Parameters
    ----------
    scenes : list of xarray.Dataset
        Front scenes, one for each column.
    """
    rows = [[f"{part} {column}" for column in range(len(scenes))] for part in ("u", "error")]
    figure, panels = new_figure(3.6, rows)
    for column, data in enumerate(scenes):
        profile, error = panels[f"u {column}"], panels[f"error {column}"]
        profile.sharey(panels["u 0"])
        _draw_profiles(profile, data)
        _draw_errors(error, data)
        for axes in (profile, error):
            # So that circles at the ends are whole.
            axes.set_xlim(left=max(float(data["xi"][0]), FARTHEST_BEHIND) - 0.3)
            axes.set_xlim(right=float(data["xi"][-1]) + 0.3)
    panels["u 0"].set_ylabel(r"compression $u/\delta$")
    panels["error 0"].set_ylabel(r"error of $u/\delta$")
    figure.align_ylabels()
    finish_grid(figure, [panels[name] for name in rows[0]], r"$\xi = n - ct$", columns=5)
    return figure


def _draw_profiles(axes: Axes, data: xr.Dataset) -> None:
    """Compression of one front: exact, driven, and the three continuum models."""
    driven = data["relative_displacement_driven"]
    circles: dict[str, Any] = {"color": BLACK, "markerfacecolor": "white", "label": "driven chain"}
    axes.plot(driven["xi_driven"], driven, "o", zorder=3, **circles)
    for front, look in LINES.items():
        values = data[f"relative_displacement_{front}"]
        axes.plot(data["xi"], values, **look)
    axes.plot(data["xi"], data["relative_displacement"], **LOOKS["exact"]._asdict())
    law = configuration_of(data)["law"]
    axes.set_title(rf"$\alpha = {law['alpha']:g}$, $\gamma = {law['gamma']:g}$")


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Difference of the compression of each continuum front from the exact one."""
    for front, look in LINES.items():
        difference = data[f"relative_displacement_{front}"] - data["relative_displacement"]
        axes.plot(data["xi"], difference, **look)
    axes.axhline(0.0, color="0.6", linewidth=0.5, linestyle="-")
    axes.set_xlabel(r"$\xi = n - ct$")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fronts_compared,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            scenes=snakemake.input.scenes,
        )
