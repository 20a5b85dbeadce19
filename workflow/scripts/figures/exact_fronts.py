"""Exact fronts of the lattice by two methods; after James (2021), section 6."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_profile
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, GREEN, MAGENTA, new_figure
from job import job

METHODS = {"profile": (EQUATION_COLOUR, "-", "s"), "shooting": (CHAIN_COLOUR, ":", "o")}


def exact_fronts(underdamped: xr.Dataset, overdamped: xr.Dataset) -> Figure:
    """Draw profiles, the difference of the methods, and their residuals.

    Parameters
    ----------
    underdamped, overdamped : xarray.Dataset
        Front scenes of these names.
    """
    scenes = [underdamped, overdamped]
    rows = [[f"{part} {row}" for part in ("u", "difference", "residual")] for row in range(2)]
    figure, panels = new_figure(3.6, rows)
    for names, data in zip(rows, scenes, strict=True):
        profiles, difference, residuals = (panels[name] for name in names)
        _draw_profiles(profiles, data)
        _draw_difference(difference, data)
        _draw_residuals(residuals, data)
        profiles.sharey(panels["u 0"])
        residuals.sharey(panels["residual 0"])
    panels["u 0"].legend(loc="lower left")
    panels["difference 1"].legend(loc="upper left")
    panels["residual 1"].legend(loc="upper right")
    return figure


def _draw_profiles(axes: Axes, data: xr.Dataset) -> None:
    """u(ξ) by the profile equation, and by shooting at whole and half beads."""
    draw_profile(axes, data, color=METHODS["profile"][0], label="profile equation")
    shot = data["relative_displacement_shooting"]
    on_beads = np.isclose(shot["xi_shooting"] % 1.0, 0.0)
    axes.plot(
        shot["xi_shooting"][on_beads],
        shot[on_beads],
        "o",
        color=METHODS["shooting"][0],
        fillstyle="none",
        label="shooting",
    )
    law = configuration_of(data)["law"]
    axes.set_title(rf"$\alpha = {law['alpha']:g}$, $\gamma = {law['gamma']:g}$")


def _draw_difference(axes: Axes, data: xr.Dataset) -> None:
    """Difference of the two methods at every point of shooting."""
    for field, label, colour, marker in (
        ("velocity", "velocity", MAGENTA, "x"),
        ("relative_displacement", "compression", GREEN, "."),
    ):
        difference = data[f"{field}_difference"]
        xi = difference["xi_shooting"]
        axes.semilogy(xi, np.abs(difference), marker, color=colour, markersize=2, label=label)
    axes.set(ylabel="|difference|", xlabel=r"$\xi = n - ct$", ylim=(3e-17, 5e-13))


def _draw_residuals(axes: Axes, data: xr.Dataset) -> None:
    """Largest residual before each Newton or Gauss–Newton step."""
    for method, (colour, line, marker) in METHODS.items():
        residual = data[f"residual_history_{method}"]
        axes.semilogy(
            residual,
            line,
            marker=marker,
            fillstyle="none",
            color=colour,
            label=method,
        )
    rises = 1 + np.flatnonzero(np.diff(data["residual_history_profile"]) > 0.0)
    for step in rises[:1]:
        height = float(data["residual_history_profile"][step])
        axes.annotate("finer grid", (step, height), (0, 4), textcoords="offset points", ha="center")
    axes.set(ylabel="residual", xlabel="step of the iteration")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            exact_fronts,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            underdamped=snakemake.input.underdamped,
            overdamped=snakemake.input.overdamped,
        )
