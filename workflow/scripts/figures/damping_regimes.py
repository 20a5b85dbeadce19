"""Where damping is weak, for four laws of damping; James (2021), section 3.1."""

from itertools import cycle
from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

SHOWN_GAMMA = (0.03, 30.0)
SHORT_DASHES = (0, (2, 1))
MARKERS = "os^v"


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
    looks = cycle(zip(PROBE_COLOURS, MARKERS, strict=False))
    for beta, (colour, marker) in zip(data["beta"].values, looks, strict=False):
        law = data.sel(beta=beta)
        _draw_gamma(panels["gamma"], law, colour, marker)
        panels["restitution"].semilogx(
            law["velocity_ratio"],
            law["restitution"],
            linestyle="-",
            color=colour,
            marker=marker,
            fillstyle="none",
            markevery=12,
            clip_on=False,
            label=", ".join(filter(None, [rf"$\beta = {beta:g}$", names.get(beta)])),
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


def _draw_gamma(axes: Axes, law: xr.Dataset, colour: str, marker: str) -> None:
    """γ against velocity, solid where fronts are overdamped, over dashes everywhere."""
    # The dashes go on below the solid line, since the damping where both meet lies between two
    # points.
    overdamped = law["gamma"].where(law["gamma"] >= law["critical_gamma"])
    # Marks are between the powers of ten, because all lines cross at one of them.
    marks: dict[str, Any] = {"marker": marker, "fillstyle": "none", "markevery": (6, 12)}
    axes.loglog(law["velocity_ratio"], law["gamma"], linestyle=SHORT_DASHES, color=colour, **marks)
    axes.loglog(law["velocity_ratio"], overdamped, "-", color=colour)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            damping_regimes,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
