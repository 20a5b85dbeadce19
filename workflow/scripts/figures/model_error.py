"""How far the ring is from its amplitude equations, over time.

The distances are defined in granular_fronts.studies.ring_against_equations.
"""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import TIME, finish_grid
from granular_fronts.output.style import LOOKS, new_figure
from job import job

FIELDS = {"relative_displacement": "compression", "velocity": "velocity"}
# Width of a line, by what it shows of the differences.
WIDTHS = {"sup": ("largest", 1.8), "rms": ("root mean square", 0.8)}
SHOWN = (1e-4, 2.0)


def model_error(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw distances and solver errors, a row for each exponent, a column for each field.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    rows = [[f"{field} {row}" for field in FIELDS] for row in range(2)]
    figure, panels = new_figure(4.6, rows)
    for names, data in zip(rows, (weak, hertz), strict=True):
        exponent = rf"$\alpha = {configuration_of(data)['law']['alpha']:g}$"
        for name, (field, words) in zip(names, FIELDS.items(), strict=True):
            _draw_distances(panels[name], data, field)
            panels[name].set_title(f"{words}, {exponent}")
        panels[names[0]].set_ylabel("relative difference")
    finish_grid(figure, [panels[name] for name in rows[-1]], TIME)
    return figure


def _draw_distances(axes: Axes, data: xr.Dataset, field: str) -> None:
    """Distances of one field to both equations, and in grey what the solvers contribute."""
    for equation, noise in (("logarithmic", None), ("unlimited", "errors of the solvers")):
        look = LOOKS[equation]
        for kind, (words, width) in WIDTHS.items():
            curve = data[f"{field}_{kind}_{equation}"].isel(t_grid=slice(1, None))
            named = look._replace(label=f"{look.label}: {words}")
            axes.semilogy(curve["t_grid"], curve, linewidth=width, **named._asdict())
        floor = data[f"{field}_floor_{equation}"].isel(t_grid=slice(1, None))
        axes.fill_between(floor["t_grid"], 0.1 * SHOWN[0], floor, color="0.88", label=noise)
    axes.set(xlim=(0, float(curve["t_grid"][-1])), ylim=SHOWN)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            model_error,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            weak=snakemake.input.weak,
            hertz=snakemake.input.hertz,
        )
