"""How far the ring is from its amplitude equations, over time.

The distances are defined in granular_fronts.studies.ring_against_equations.
"""

from typing import Any

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import TIME
from granular_fronts.output.style import LOOKS, new_figure
from job import job

MARKS: dict[str, dict[str, Any]] = {
    "logarithmic": {"linestyle": "-", "marker": "o", "markevery": 20},
    "unlimited": {"linestyle": "-", "marker": "^", "markevery": (10, 20)},
}


def model_error(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw the largest distances of compression, a panel for each exponent.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    figure, panels = new_figure(3.4, [["weak"], ["hertz"]], sharex=True)
    for axes, data in zip(panels.values(), (weak, hertz), strict=True):
        for equation in ("logarithmic", "unlimited"):
            distance = data[f"relative_displacement_sup_{equation}"].isel(t_grid=slice(1, None))
            # Dashes would beat with the oscillation.
            look = LOOKS[equation]._asdict() | MARKS[equation]
            axes.plot(distance["t_grid"], distance, **look)
        exponent = configuration_of(data)["law"]["alpha"]
        axes.set(title=rf"$\alpha = {exponent:g}$", ylabel=r"largest error of $u/\delta$")
        axes.set_ylim(bottom=0)
    axes.set(xlabel=TIME, xlim=(0, float(distance["t_grid"][-1])))
    panels["hertz"].legend(loc="upper left")
    return figure


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
