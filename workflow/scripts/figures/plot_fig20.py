"""Figure 20: errors of the amplitude equations on rings of beads as α → 1."""

import math

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.accuracy import Estimate
from granular_fronts.campaign.measures import fitted_order, selected
from granular_fronts.output.style import CHAIN_COLOUR, MODEL_LOOKS, new_figure

SUP, RMS = "displacement_sup", "displacement_rms"
MARKERS = ("o", "s", "^")
SLOW_TIME = 1.0
FORMULAS = {
    "leading": "(51) (×)",
    "printed": "(43) as printed (△)",
    "first_order": "whole first order (o)",
}


def plot_fig20(
    damping: xr.Dataset,
    gamma: xr.Dataset,
    mu: xr.Dataset,
    leading: xr.Dataset,
    plateau: xr.Dataset,
    time: xr.Dataset,
    front: xr.Dataset,
) -> Figure:
    """Draw errors against ε in three limits, against time, and for other starts.

    Parameters
    ----------
    damping, gamma, mu : xarray.Dataset
        Campaigns of rings at fixed γc, γ and μ, from the slow manifold.
    leading : xarray.Dataset
        As `mu`, with the velocities of the paper's start.
    plateau : xarray.Dataset
        The start of the paper.
    time, front : xarray.Dataset
        A pulse and a front of one α over a long slow time.
    """
    figure, panels = new_figure(5.6, [["damping", "gamma", "mu"], ["time", "start", "velocity"]])
    _draw_limit(panels["damping"], damping, "damping", r"\gamma c")
    _draw_limit(
        panels["gamma"], gamma.expand_dims(gamma=[gamma.attrs["gamma"]]), "gamma", r"\gamma"
    )
    _draw_limit(panels["mu"], mu, "mu", r"\mu")
    _draw_over_time(panels["time"], time, front)
    _draw_starts(panels["start"], mu, leading, plateau)
    _draw_velocities(panels["velocity"], damping)
    panels["damping"].set_ylabel(r"$\sup|\Delta u|/\delta$ at $\tau = 1$")
    for axes in panels.values():
        axes.set(xscale="log", yscale="log")
    handles, labels = panels["damping"].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def _draw_limit(axes: Axes, campaign: xr.Dataset, parameter: str, symbol: str) -> None:
    """Largest error of u against ε, a colour for each equation and a marker for each value."""
    values = campaign[parameter].values
    for marker, value in zip(MARKERS, values, strict=False):
        for model, (label, colour, line) in MODEL_LOOKS.items():
            place = {parameter: value, "slow_time": SLOW_TIME}
            epsilon, error, _ = selected(campaign, f"{SUP}_{model}", **place)
            named = label if value == values[0] else "_"
            axes.plot(
                epsilon, error, color=colour, linestyle=line, marker=marker, ms=3, label=named
            )
    rows = [
        f"{label}: {_order_text(campaign, f'{SUP}_{model}', parameter)}"
        for model, (label, *_) in MODEL_LOOKS.items()
    ]
    axes.set_xlabel(r"$\varepsilon$")
    listed = ", ".join(f"{value:g}" for value in values)
    axes.set_title(f"fixed ${symbol} = {listed}$\nslopes\n" + "\n".join(rows), fontsize=7)


def _order_text(campaign: xr.Dataset, error: str, parameter: str) -> str:
    """Fitted orders with their scatter, one for each value of a parameter."""
    orders = [
        fitted_order(campaign, error, slow_time=SLOW_TIME, **{parameter: value})
        for value in campaign[parameter].values
    ]
    return ", ".join(map(with_error, orders))


def with_error(order: Estimate) -> str:
    """A fitted order and its error, with the digits that the error leaves, two at least."""
    # A line through two points has the error 0, one through a ring that failed has none.
    digits = max(2, math.ceil(-math.log10(order.error))) if order.error > 0.0 else 2
    return f"{order.value:z.{digits}f} ± {order.error:.{digits}f}".replace("-", "−")


def _draw_over_time(axes: Axes, pulses: xr.Dataset, front: xr.Dataset) -> None:
    """Largest error of u against the slow time, of a pulse for each μ and of a front."""
    runs = [*(pulses.sel(mu=mu) for mu in pulses["mu"].values), front]
    for marker, run in zip(MARKERS, runs, strict=True):
        for model, (_, colour, line) in MODEL_LOOKS.items():
            error = run[f"{SUP}_{model}"]
            axes.plot(run["slow_time"], error, color=colour, linestyle=line, marker=marker, ms=3)
    first, second = pulses["mu"].values
    axes.set_title(
        rf"$\alpha = {front.attrs['alpha']:g}$: pulse, $\mu = {first:g}$ (o), ${second:g}$ (□);"
        + "\n"
        + rf"front, $\mu = {front.attrs['mu']:g}$ (△)",
        fontsize=7,
    )
    axes.set(xlabel=r"$\tau$", ylabel=r"$\sup|\Delta u|/\delta$")


def _draw_starts(axes: Axes, mu: xr.Dataset, leading: xr.Dataset, plateau: xr.Dataset) -> None:
    """Root mean square error of u from the slow manifold, (51), and the plateau of the paper."""
    mu, leading = mu.sel(mu=2.0), leading.sel(mu=2.0)
    for rings, marker in ((mu, "o"), (leading, "x"), (plateau, "^")):
        for model in ("logarithmic", "dispersive"):
            _, colour, line = MODEL_LOOKS[model]
            epsilon, error, _ = selected(rings, f"{RMS}_{model}", slow_time=SLOW_TIME)
            axes.plot(epsilon, error, color=colour, linestyle=line, marker=marker, ms=3)
    gamma, delta = plateau.attrs["gamma"], plateau.attrs["delta"]
    axes.set_title(
        "pulse, $\\mu = 2$: slow manifold (o), (51) (×);\n"
        rf"plateau (49), $\gamma = {gamma:g}$, $\delta = {delta:g}$ (△)",
        fontsize=7,
    )
    axes.set(xlabel=r"$\varepsilon$", ylabel=r"rms $\Delta u/\delta$ at $\tau = 1$")


def _draw_velocities(axes: Axes, damping: xr.Dataset) -> None:
    """Largest distance of ẋ to (51), to (43) and to the whole first order, at γc = 1."""
    place, rows = {"damping": 1.0, "slow_time": SLOW_TIME}, []
    for (formula, label), marker in zip(FORMULAS.items(), ("x", "^", "o"), strict=True):
        epsilon, error, _ = selected(damping, f"residual_{formula}", **place)
        axes.plot(epsilon, error, color=CHAIN_COLOUR, marker=marker, ms=3)
        order = fitted_order(damping, f"residual_{formula}", **place)
        rows.append(f"{label}: {with_error(order)}")
    title = r"$\gamma c = 1$: $\dot x$ less a formula in $y$"
    axes.set_title(title + "\nslopes\n" + "\n".join(rows), fontsize=7)
    axes.set(xlabel=r"$\varepsilon$", ylabel=r"$\sup|\Delta\dot x|/\delta c$ at $\tau = 1$")


if __name__ == "__main__":
    run_figure(plot_fig20, globals().get("snakemake"))
