"""Figure 24: a front that is proved, its enclosure, and bounds of both tails."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure

VISIBLE, FLOOR = 0.03, 1e-16
BAND = "#b9cbe0"


def plot_fig24(data: xr.Dataset) -> Figure:
    """Draw a front within its enclosure, the errors, and both tails.

    Parameters
    ----------
    data : xarray.Dataset
        The enclosure of a front.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(5.2, [["front", "errors"], ["behind", "ahead"]])
    draw_front(panels["front"], data)
    draw_errors(panels["errors"], data)
    draw_behind(panels["behind"], data)
    draw_ahead(panels["ahead"], data)
    return figure


def widening(data: xr.Dataset) -> float:
    """The power of ten by which the enclosure is widened, so that it can be seen."""
    return 10.0 ** np.ceil(np.log10(VISIBLE / float(data["error"].median())))


def draw_front(axes: Axes, data: xr.Dataset) -> None:
    """ū and the band in which u lies, its width multiplied."""
    factor = widening(data)
    exponent = round(np.log10(factor))
    u, error = data["approximation"], factor * data["error"]
    axes.fill_between(data["xi"], u - error, u + error, color=BAND, linewidth=0)
    axes.plot(data["xi"], u, color=CHAIN_COLOUR, linestyle="-")
    alpha, gamma = data.attrs["alpha"], data.attrs["gamma"]
    axes.set(
        xlabel=r"$\xi$",
        ylabel="$u$",
        xlim=(-12, 6),
        title=rf"$\alpha = {alpha:g}$, $\gamma = {gamma:g}$; band widened by $10^{{{exponent}}}$",
    )


def draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Bounds of the residual and of the error of u in each cell."""
    axes.semilogy(
        data["xi"], data["error"], color=EQUATION_COLOUR, linestyle="-", label=r"$|u - \bar u|$"
    )
    axes.semilogy(
        data["xi"],
        data["residual"],
        color=PROBE_COLOURS[5],
        linestyle="-",
        label=r"$|\bar P - \bar u_+^\alpha|$",
    )
    axes.set(xlabel=r"$\xi$", title="bounds that are proved")
    axes.legend(fontsize=7)


def draw_behind(axes: Axes, data: xr.Dataset) -> None:
    """1 − u: the enclosure, and the leading term with the proved bounds of A."""
    gap, error = 1 - data["approximation"], data["error"]
    axes.fill_between(
        data["xi"],
        np.maximum(gap - error, FLOOR),
        gap + error,
        color=BAND,
        linewidth=0,
        label="enclosure",
    )
    rows = data["xi"].values < 0
    for name, rate, label in (
        ("amplitude_low", "rate_high", r"$A\,e^{\lambda\xi}$"),
        ("amplitude_high", "rate_low", None),
    ):
        if name in data.attrs:
            term = data.attrs[name] * np.exp(data.attrs[rate] * data["xi"][rows])
            axes.plot(
                data["xi"][rows],
                term,
                color=PROBE_COLOURS[4],
                linestyle="-",
                linewidth=0.8,
                label=label,
            )
    axes.plot(
        data["xi"],
        gap,
        color=CHAIN_COLOUR,
        linestyle="-",
        linewidth=0.8,
        label=r"$1 - \bar u$",
    )
    axes.set(
        yscale="log",
        xlabel=r"$\xi$",
        ylabel="$1 - u$",
        xlim=(float(data["xi"][0]), 2),
        title="behind",
    )
    axes.legend(fontsize=7)


def draw_ahead(axes: Axes, data: xr.Dataset) -> None:
    """−ln u between its bounds, on a scale where a double exponential is a straight line."""
    known = np.isfinite(data["decay_high"].values)
    rows = data.isel(xi_ahead=known)
    axes.fill_between(
        rows["xi_ahead"],
        rows["decay_low"],
        rows["decay_high"],
        color=BAND,
        linewidth=0,
        label="proved bounds",
    )
    start = rows.isel(xi_ahead=0)
    slope = np.exp(np.log(data.attrs["alpha"]) * (rows["xi_ahead"] - start["xi_ahead"]))
    axes.plot(
        rows["xi_ahead"],
        float(start["decay_low"]) * slope,
        color=CHAIN_COLOUR,
        linestyle="--",
        linewidth=0.8,
        label=r"slope $\ln\alpha$",
    )
    axes.set(yscale="log", xlabel=r"$\xi$", ylabel=r"$-\ln u$", title="ahead")
    axes.legend(fontsize=7)


if __name__ == "__main__":
    run_figure(plot_fig24, globals().get("snakemake"))
