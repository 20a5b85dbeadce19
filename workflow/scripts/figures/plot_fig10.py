"""Figure 10: exact fronts, driven chains and continuum fronts; after James (2021), section 6.3."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.panels import finish_grid
from granular_fronts.output.style import CHAIN_COLOUR, CONTINUUM_LOOKS, new_figure

FIELDS = {"relative_displacement": r"$u/\delta$", "velocity": r"$\dot x/\delta^{(\alpha+1)/2}$"}


def plot_fig10(scenes: list[xr.Dataset]) -> Figure:
    """Draw relative displacements and velocities of every scene.

    Parameters
    ----------
    scenes : list of xarray.Dataset
        Front scenes, one for each row.
    """
    rows = [[f"{field} {row}" for field in FIELDS] for row in range(len(scenes))]
    figure, panels = new_figure(1.75 * len(rows), rows)
    for names, data in zip(rows, scenes, strict=True):
        for name, field in zip(names, FIELDS, strict=True):
            _draw_models(panels[name], data, field)
    finish_grid(figure, [panels[name] for name in rows[-1]], r"$\xi = n - ct$", columns=5)
    return figure


def _draw_models(axes: Axes, data: xr.Dataset, field: str) -> None:
    """One field of one front: exact, driven, and the three continuum models."""
    driven = data[f"{field}_driven"]
    axes.plot(
        driven["xi_driven"],
        driven,
        ".",
        color="0.6",
        markersize=4,
        label="driven chain",
    )
    for front, (label, colour, line) in CONTINUUM_LOOKS.items():
        axes.plot(data["xi"], data[f"{field}_{front}"], color=colour, linestyle=line, label=label)
    axes.plot(data["xi"], data[field], "-", color=CHAIN_COLOUR, label="exact")
    law = rf"$\alpha = {data.attrs['alpha']:g}$, $\gamma c = {data.attrs['gamma']:.3g}$"
    axes.set(title=law, ylabel=FIELDS[field], xlim=(data["xi"][0], data["xi"][-1]))


if __name__ == "__main__":
    run_figure(plot_fig10, globals().get("snakemake"))
