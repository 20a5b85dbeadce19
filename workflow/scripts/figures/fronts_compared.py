"""Exact fronts, driven chains and continuum fronts; after James (2021), section 6.3."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import finish_grid
from granular_fronts.output.style import CONTINUUM_LOOKS, LOOKS, new_figure
from job import job


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
        _draw_profiles(profile, data)
        _draw_errors(error, data)
    panels["u 0"].set_ylabel(r"compression $u/\delta$")
    panels["error 0"].set_ylabel(r"error of $u/\delta$")
    finish_grid(figure, [panels[name] for name in rows[0]], r"$\xi = n - ct$", columns=5)
    return figure


def _draw_profiles(axes: Axes, data: xr.Dataset) -> None:
    """Compression of one front: exact, driven, and the three continuum models."""
    driven = data["relative_displacement_driven"]
    axes.plot(driven["xi_driven"], driven, ".", color="0.6", markersize=4, label="driven chain")
    for front, look in CONTINUUM_LOOKS.items():
        axes.plot(data["xi"], data[f"relative_displacement_{front}"], **look._asdict())
    axes.plot(data["xi"], data["relative_displacement"], **LOOKS["exact"]._asdict())
    law = configuration_of(data)["law"]
    axes.set_title(rf"$\alpha = {law['alpha']:g}$, $\gamma = {law['gamma']:g}$")
    axes.set(xlim=(data["xi"][0], data["xi"][-1]))


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Difference of the compression of each continuum front from the exact one."""
    for front, look in CONTINUUM_LOOKS.items():
        difference = data[f"relative_displacement_{front}"] - data["relative_displacement"]
        axes.plot(data["xi"], difference, **look._asdict())
    axes.axhline(0.0, color="0.6", linewidth=0.5, linestyle="-")
    axes.set(xlabel=r"$\xi = n - ct$", xlim=(data["xi"][0], data["xi"][-1]))


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fronts_compared,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            scenes=snakemake.input.scenes,
        )
