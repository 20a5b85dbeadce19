"""Errors of the amplitude equations on rings of beads as α → 1, in two limits."""

from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import MODEL_LOOKS, new_figure
from job import job
from limit_measures import selected

SUP = "displacement_sup"
MARKERS = ("o", "s", "^")
ERROR_LABEL = r"largest error of $u/\delta$ at $\tau = 1$"


def ring_limit(damping: xr.Dataset, mu: xr.Dataset) -> Figure:
    """Draw errors against ε at fixed damping, and at fixed ratio of damping and dispersion.

    Parameters
    ----------
    damping, mu : xarray.Dataset
        Campaigns of rings at fixed γc and μ, from the slow manifold.
    """
    figure, panels = new_figure(4.6, [["damping"], ["mu"]], sharex=True, sharey=True)
    middle = damping["damping"].values[damping.sizes["damping"] // 2]
    least = mu["mu"].values.min()  # where dispersion matters most
    _draw_limit(panels["damping"], damping, damping=middle)
    _draw_limit(panels["mu"], mu, mu=least)
    panels["damping"].set_title(rf"damping fixed, $\gamma c = {middle:g}$")
    panels["mu"].set_title(rf"$\mu = {least:g}$ fixed: $\gamma c$ falls with $\varepsilon$")
    for axes in panels.values():
        epsilon = axes.get_lines()[0].get_xdata()
        axes.plot(epsilon, epsilon, ":", color="0.6", label="$\\varepsilon$ itself")
    axes.set_xlabel(r"$\varepsilon = (1 - 1/\alpha)/\gamma c$")
    handles, labels = panels["damping"].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=2)
    return figure


def _draw_limit(axes: Axes, campaign: xr.Dataset, **place: float) -> None:
    """Draw largest errors of u against ε at a place of further axes."""
    for (model, look), marker in zip(MODEL_LOOKS.items(), MARKERS, strict=True):
        epsilon, error, _ = selected(campaign, f"{SUP}_{model}", **place)
        marks: dict[str, Any] = {"marker": marker, "fillstyle": "none"}
        axes.plot(epsilon, error, **marks, **look._asdict())
    axes.set(xscale="log", yscale="log", ylabel=ERROR_LABEL)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            ring_limit,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            damping=snakemake.input.damping,
            mu=snakemake.input.mu,
        )
