"""Figure 7b: how far the ring is from its amplitude equations, over time.

The distances are defined in granular_fronts.studies.ring_against_equations.
"""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import draw_rings, finish_grid
from granular_fronts.output.style import EQUATION_COLOUR, UNLIMITED_COLOUR

EQUATIONS = {
    "logarithmic": ("(41)", EQUATION_COLOUR),
    "unlimited": ("(40)", UNLIMITED_COLOUR),
}
KINDS = {"sup": ("-", "largest"), "rms": ("--", "rms"), "floor": (":", "solvers")}
TITLES = {
    "relative_displacement": r"compression $u_{n,+}/\delta$",
    "velocity": r"velocity $\dot x_n/\delta^{(\alpha+1)/2}$",
}


def plot_fig07b(weak: xr.Dataset, hertz: xr.Dataset) -> Figure:
    """Draw distances and solver errors, a row for each exponent, a column for each field.

    Parameters
    ----------
    weak, hertz : xarray.Dataset
        The two periodic scenes.
    """
    figure, rows = draw_rings(5.2, [weak, hertz], _draw_distances)
    for row in rows:
        row[0].set_ylabel("difference chain to equation")
    finish_grid(figure, rows[-1], "$t$")
    return figure


def _draw_distances(axes: Axes, data: xr.Dataset, field: str, exponent: str) -> None:
    """Distances of one field to both equations, and what the solvers contribute."""
    for kind, (style, words) in KINDS.items():
        for equation, (number, colour) in EQUATIONS.items():
            curve = data[f"{field}_{kind}_{equation}"].isel(t_grid=slice(1, None))
            label = f"{number} {words}"
            axes.semilogy(curve["t_grid"], curve, linestyle=style, color=colour, label=label)
    axes.set(xlim=(0, float(curve["t_grid"][-1])), ylim=(1e-10, 2))
    axes.set_title(f"{exponent}, {TITLES[field]}")


if __name__ == "__main__":
    run_figure(plot_fig07b, globals().get("snakemake"))
