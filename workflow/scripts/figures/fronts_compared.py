"""Exact fronts, driven chains and continuum fronts; after James (2021), section 6.3."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.panels import finish_grid
from granular_fronts.output.style import CONTINUUM_LOOKS, LOOKS, new_figure
from job import job

FIELDS = {
    "relative_displacement": r"compression $u/\delta$",
    "velocity": r"velocity $\dot x/c\delta$",
}
MARGIN = 0.15


def fronts_compared(scenes: list[xr.Dataset]) -> Figure:
    """Draw both fields of every front, and by how much continuum fronts miss its compression.

    Parameters
    ----------
    scenes : list of xarray.Dataset
        Front scenes, one for each row.
    """
    rows = [[f"{part} {row}" for part in (*FIELDS, "error")] for row in range(len(scenes))]
    figure, panels = new_figure(1.6 * len(rows) + 0.4, rows)
    for names, data in zip(rows, scenes, strict=True):
        *fields, error = (panels[name] for name in names)
        for axes, field in zip(fields, FIELDS, strict=True):
            _draw_models(axes, data, field)
        _draw_errors(error, data)
        law = rf"$\alpha = {data.attrs['alpha']:g}$", rf"$\gamma c = {data.attrs['gamma']:.2g}$"
        fields[0].text(0.04, 0.1, "\n".join(law), transform=fields[0].transAxes)
    finish_grid(figure, [panels[name] for name in rows[-1]], r"$\xi = n - ct$", columns=3)
    return figure


def _draw_models(axes: Axes, data: xr.Dataset, field: str) -> None:
    """One field of one front: exact, driven, and the three continuum models."""
    driven = data[f"{field}_driven"]
    axes.plot(driven["xi_driven"], driven, ".", color="0.6", markersize=4, label="driven chain")
    for front, look in CONTINUUM_LOOKS.items():
        axes.plot(data["xi"], data[f"{field}_{front}"], **look._asdict())
    axes.plot(data["xi"], data[field], **LOOKS["exact"]._asdict())
    # The spike of a continuum front would hide all else.
    low, high = float(data[field].min()), float(data[field].max())
    margin = MARGIN * (high - low)
    axes.set(xlim=(data["xi"][0], data["xi"][-1]), ylim=(low - margin, high + margin))
    axes.set_ylabel(FIELDS[field])


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Difference of the compression of each continuum front from the exact one."""
    for front, look in CONTINUUM_LOOKS.items():
        difference = data[f"relative_displacement_{front}"] - data["relative_displacement"]
        axes.plot(data["xi"], difference, **look._asdict())
    axes.axhline(0.0, color="0.6", linewidth=0.6, linestyle="-")
    axes.set(xlim=(data["xi"][0], data["xi"][-1]), ylabel=r"error of $u/\delta$")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fronts_compared,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            scenes=snakemake.input.scenes,
        )
