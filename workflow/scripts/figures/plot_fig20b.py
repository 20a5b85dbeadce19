"""Figure 20b: the rings of figure 20 for all dampings, over time, from other starts."""

from collections.abc import Iterator
from typing import Any

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from plot_fig20 import ERROR_LABEL, MARKERS, SUP, draw_limit, middle_damping, smallest_mu

from figure_step import run_figure
from granular_fronts.campaign.measures import selected
from granular_fronts.output.style import CHAIN_COLOUR, MODEL_LOOKS, new_figure

RMS = "displacement_rms"
SIGNS = "○□△"  # how a title names the markers
FORMULAS = {
    "leading": ("leading order (51)", "x"),
    "printed": ("(43) as printed", "^"),
    "first_order": ("whole first order", "o"),
}


def plot_fig20b(
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
    _draw_limits(panels["damping"], damping, "damping", r"\gamma c")
    _draw_limits(panels["mu"], mu, "mu", r"\mu")
    draw_limit(panels["gamma"], gamma)
    panels["gamma"].set_title(rf"$\gamma = {gamma.attrs['gamma']:g}$", fontsize=8)
    _draw_over_time(panels["time"], time, front)
    _draw_starts(panels["start"], mu, leading, plateau)
    _draw_velocities(panels["velocity"], damping)
    panels["damping"].set_ylabel(ERROR_LABEL)
    for name, axes in panels.items():
        axes.set(xscale="log", yscale="log")
        axes.set_xlabel(r"$\tau$" if name == "time" else r"$\varepsilon$")
    figure.legend(handles=list(_equations()), loc="outside lower center", ncols=3)
    return figure


def _equations() -> Iterator[Line2D]:
    """The meaning of colours and dashes."""
    for look in MODEL_LOOKS.values():
        yield Line2D([], [], **look._asdict())


def _draw_limits(axes: Axes, campaign: xr.Dataset, parameter: str, symbol: str) -> None:
    """Largest error of u against ε, a marker for each value of what is fixed."""
    values = campaign[parameter].values
    for marker, value in zip(MARKERS, values, strict=False):
        draw_limit(axes, campaign, 3 * marker, **{parameter: value})
    listed = ", ".join(f"{value:g} {sign}" for value, sign in zip(values, SIGNS, strict=False))
    axes.set_title(f"${symbol} =$ {listed}", fontsize=8, loc="right")


def _draw_over_time(axes: Axes, pulses: xr.Dataset, front: xr.Dataset) -> None:
    """Largest error of u against the slow time, of a pulse for each μ and of a front."""
    runs = [*(pulses.sel(mu=mu) for mu in pulses["mu"].values), front]
    for marker, run in zip(MARKERS, runs, strict=True):
        for model, look in MODEL_LOOKS.items():
            error = run[f"{SUP}_{model}"]
            axes.plot(run["slow_time"], error, marker=marker, markersize=3, **look._asdict())
    first, second = pulses["mu"].values
    words = rf"pulse, $\mu = {first:g}$ ○, ${second:g}$ □;" + "\n"
    axes.set_title(words + rf"front, $\mu = {front.attrs['mu']:g}$ △", fontsize=8)
    axes.set_ylabel(r"largest error of $u/\delta$")


def _draw_starts(axes: Axes, mu: xr.Dataset, leading: xr.Dataset, plateau: xr.Dataset) -> None:
    """Root mean square error of u from the slow manifold, (51), and the plateau of the paper."""
    least = smallest_mu(mu)
    mu, leading = mu.sel(mu=least), leading.sel(mu=least)
    for rings, marker in ((mu, "o"), (leading, "x"), (plateau, "^")):
        for model in ("logarithmic", "dispersive"):
            epsilon, error, _ = selected(rings, f"{RMS}_{model}")
            look = MODEL_LOOKS[model]._asdict()
            axes.plot(epsilon, error, marker=marker, markersize=3, **look)
    axes.set_title("slow manifold ○, plateau △,\nleading order ×", fontsize=8)
    axes.set_ylabel(r"rms error of $u/\delta$ at $\tau = 1$")


def _draw_velocities(axes: Axes, damping: xr.Dataset) -> None:
    """Largest distance of ẋ to (51), to (43) and to the whole first order, at the middle γc."""
    middle = middle_damping(damping)
    for formula, (label, marker) in FORMULAS.items():
        epsilon, error, _ = selected(damping, f"residual_{formula}", damping=middle)
        look: dict[str, Any] = {
            "color": CHAIN_COLOUR,
            "linestyle": "-",
            "marker": marker,
            "markersize": 3.5,
        }
        axes.plot(epsilon, error, label=label, **look)
    axes.set_title(r"velocity less a formula," + "\n" + rf"$\gamma c = {middle:g}$", fontsize=8)
    axes.set_ylabel(r"$\sup|\Delta\dot x|/\delta c$ at $\tau = 1$")
    axes.legend(fontsize=7, handlelength=1.5, loc="lower right")


if __name__ == "__main__":
    run_figure(plot_fig20b, globals().get("snakemake"))
