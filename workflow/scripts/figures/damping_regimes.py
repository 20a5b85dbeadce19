"""Where damping is weak, for four laws of damping; James (2021), section 3.1."""

from itertools import cycle
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

SHOWN_GAMMA = (0.02, 50.0)
DASHES = (0, (4, 2))
MARKERS = "os^v"
# The first velocities with a mark: marks of laws are beside each other where their lines meet.
MARKED = (4, 7, 10, 13)


def damping_regimes(data: xr.Dataset) -> Figure:
    """Draw γ of a front and e of a collision against the reference velocity.

    Parameters
    ----------
    data : xarray.Dataset
        Damping regimes.
    """
    figure, panels = new_figure(4.2, [["gamma"], ["restitution"]])
    alpha = configuration_of(data)["alpha"]
    names = {1.0: "dashpot", alpha: "Kuwabara–Kono", alpha + 1.0: "Simon–Hunt–Crossley"}
    looks = cycle(zip(PROBE_COLOURS, MARKERS, MARKED, strict=False))
    for beta, (colour, marker, first) in zip(data["beta"].values, looks, strict=False):
        law = data.sel(beta=beta)
        marks = {"marker": marker, "fillstyle": "none", "markevery": (first, 12)}
        _draw_gamma(panels["gamma"], law, colour, marks)
        panels["restitution"].semilogx(
            law["velocity_ratio"],
            law["restitution"],
            linestyle="-",
            color=colour,
            label=", ".join(filter(None, [rf"$\beta = {beta:g}$", names.get(beta)])),
            **marks,
        )
    ends = float(data["velocity_ratio"][0]), float(data["velocity_ratio"][-1])
    panels["gamma"].set(
        xlabel="velocity behind the front, $v_p/v_c$",
        ylabel=r"damping $\gamma$ of the front",
        title="solid: monotone, dashed: oscillating",
        xlim=ends,
        ylim=SHOWN_GAMMA,
    )
    panels["restitution"].set(
        xlabel="velocity of the collision, $v_0/v_c$",
        ylabel="coefficient of restitution $e$",
        title="two beads collide",
        xlim=ends,
        ylim=(-0.04, 1.05),
    )
    figure.legend(loc="outside upper center", ncols=2, handlelength=2)
    return figure


def _draw_gamma(axes: Axes, law: xr.Dataset, colour: str, marks: dict[str, Any]) -> None:
    """γ against velocity, solid where fronts are overdamped, and dashed where they oscillate."""
    ratio, gamma = law["velocity_ratio"].values, law["gamma"].values
    overdamped = gamma >= float(law["critical_gamma"])
    axes.loglog(ratio, gamma, linestyle="", color=colour, **marks)
    # Both lines are drawn between the two points around the critical damping.
    near = np.convolve(overdamped, [1, 1, 1], "same") > 0
    for part, line in ((near, "-"), (~overdamped, DASHES)):
        if part.any():
            axes.loglog(ratio[part], gamma[part], linestyle=line, color=colour)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            damping_regimes,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
