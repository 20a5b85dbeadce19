"""Figure 4: fluxes and stationary fronts of the amplitude equations; James (2021), figure 4."""

from typing import Any

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import EXPONENT_LOOKS, new_figure
from job import job


def fig04(data: xr.Dataset) -> Figure:
    """Draw f_α and y^(1/α) against y, and the fronts of (46) and (45).

    Parameters
    ----------
    data : xarray.Dataset
        Tabulated fluxes and fronts.
    """
    figure, panels = new_figure(3.7, [["flux"], ["front"]])
    for alpha, (colour, line) in zip(data["alpha"].values, EXPONENT_LOOKS, strict=False):
        case = data.sel(alpha=alpha)
        look: dict[str, Any] = {"color": colour, "linestyle": line}
        panels["flux"].plot(data["force"], case["flux"], label=rf"$\alpha = {alpha:g}$", **look)
        panels["flux"].plot(data["force"], case["compression"], **look)
        panels["front"].plot(data["xi"], case["front"], **look)
        ahead = data["xi"][case["front"].values == 0.0]
        panels["front"].plot(ahead[:1], 0.0 * ahead[:1], "o", color=look["color"], zorder=3)
    limit: dict[str, Any] = {"color": "black", "linestyle": "-"}
    panels["flux"].plot(data["force"], data["flux_limit"], label=r"$\alpha \to 1^+$", **limit)
    panels["flux"].plot(data["force"], data["force"], **limit)
    panels["front"].plot(data["xi"], data["front_limit"], **limit)
    panels["flux"].text(0.98, 0.5, r"compression $y^{1/\alpha}$", ha="right")
    panels["flux"].text(0.98, -0.43, r"flux $f_\alpha(y)$", ha="right")
    panels["flux"].axhline(0.0, color="0.6", linewidth=0.5, linestyle="-")
    panels["flux"].set(
        xlabel="force $y$, over its value behind", ylabel=r"$f_\alpha(y)$ and $y^{1/\alpha}$"
    )
    panels["flux"].set(xlim=(0, 1), title="flux of the equation, and compression")
    panels["front"].set(xlabel=r"place $\xi$", ylabel=r"compression $y_\alpha^{1/\alpha}$")
    panels["front"].set(xlim=(-6, 4), title="front")
    panels["flux"].legend(loc="upper left")
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            fig04,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
