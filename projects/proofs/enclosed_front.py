"""A front that is proved, its enclosure, and bounds of both tails."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure
from job import job

VISIBLE = 0.03  # width of the enclosure that the eye sees
FLOOR = 1e-16  # of a logarithmic axis, where the enclosure reaches 0
BAND = "#b9cbe0"
THIN: dict[str, Any] = {"linestyle": "-", "linewidth": 0.6}


def enclosed_front(data: xr.Dataset) -> Figure:
    """Draw a front within its enclosure, the errors, and both tails.

    Parameters
    ----------
    data : xarray.Dataset
        The enclosure of a front.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(4.0, [["front", "errors"], ["behind", "ahead"]])
    _draw_front(panels["front"], data)
    _draw_errors(panels["errors"], data)
    _draw_behind(panels["behind"], data)
    _draw_ahead(panels["ahead"], data)
    return figure


def _draw_front(axes: Axes, data: xr.Dataset) -> None:
    """ū and the band in which u lies, widened by a power of ten so that it can be seen."""
    exponent = round(np.ceil(np.log10(VISIBLE / float(data["error"].median()))))
    u, error = data["approximation"], 10.0**exponent * data["error"]
    axes.fill_between(data["xi"], u - error, u + error, color=BAND, linewidth=0)
    axes.plot(data["xi"], u, color=CHAIN_COLOUR, linestyle="-")
    law = r"proved front, $\alpha = {alpha:g}$, $\gamma = {gamma:g}$".format_map(data.attrs)
    axes.set(xlabel=r"$\xi$", ylabel="$u$", xlim=(-12, 6), title=law)
    width = f"within {_rounded_up(float(data['error'].max()))} of the line,\nband"
    words = rf"{width} drawn $10^{{{exponent}}}$ times wider"
    axes.text(0.03, 0.06, words, transform=axes.transAxes)


def _rounded_up(bound: float) -> str:
    """A bound with two digits, which is a bound still."""
    unit = 10.0 ** (np.floor(np.log10(bound)) - 1)
    return f"{np.ceil(bound / unit) * unit:.1e}".replace("e-0", "e-")


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Bounds of the residual and of the error of u in each cell."""
    for name, colour, label in (
        ("error", EQUATION_COLOUR, r"of $u$: $|u - \bar u|$"),
        ("residual", PROBE_COLOURS[5], r"residual: $|\bar P - \bar u_+^\alpha|$"),
    ):
        axes.semilogy(data["xi"], data[name], color=colour, linestyle="-", label=label)
    axes.set(xlabel=r"$\xi$", title="proved bounds of errors")
    axes.legend(loc="lower left")


def _draw_behind(axes: Axes, data: xr.Dataset) -> None:
    """1 − u: the enclosure, and the leading term with the proved bounds of A."""
    xi, gap, error = data["xi"], 1 - data["approximation"], data["error"]
    low, high = np.maximum(gap - error, FLOOR), gap + error
    axes.fill_between(xi, low, high, color=BAND, linewidth=0, label="enclosure")
    behind = xi[xi.values < 0]
    for name, rate, label in (
        ("amplitude_low", "rate_high", r"$A\,e^{\lambda\xi}$"),
        ("amplitude_high", "rate_low", None),
    ):
        if name in data.attrs:
            term = data.attrs[name] * np.exp(data.attrs[rate] * behind)
            axes.plot(behind, term, color=PROBE_COLOURS[4], label=label, **THIN)
    axes.plot(xi, gap, color=CHAIN_COLOUR, label=r"$1 - \bar u$", **THIN)
    axes.set(yscale="log", xlabel=r"$\xi$", ylabel="$1 - u$", title="behind the front")
    axes.set(xlim=(float(xi[0]), 2))
    axes.legend()


def _draw_ahead(axes: Axes, data: xr.Dataset) -> None:
    """−ln u between its bounds, on a scale where a double exponential is a straight line."""
    rows = data.isel(xi_ahead=np.isfinite(data["decay_high"].values))
    xi, low, high = rows["xi_ahead"], rows["decay_low"], rows["decay_high"]
    axes.fill_between(xi, low, high, color=BAND, linewidth=0, label="proved bounds")
    line = float(low[0]) * np.exp(np.log(data.attrs["alpha"]) * (xi - xi[0].values))
    axes.plot(xi, line, "--", color=CHAIN_COLOUR, linewidth=0.6, label=r"slope $\ln\alpha$")
    axes.set(yscale="log", xlabel=r"$\xi$", ylabel=r"$-\ln u$", title="ahead of the front")
    axes.legend()


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            enclosed_front,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
