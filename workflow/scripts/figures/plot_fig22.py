"""Figure 22: what the step of discrete-element codes does to a front, and what does not see it."""

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure

CHECKS = {
    "excess_overshoot": ("damping by overshoot", PROBE_COLOURS[0], "-", "o"),
    "excess_tail": ("damping by tail", PROBE_COLOURS[0], "--", "o"),
    "restitution_defect": ("restitution, $1 - e$", PROBE_COLOURS[1], "-", "s"),
    "energy_defect": ("energy", PROBE_COLOURS[2], "-", "^"),
    "speed_defect": ("speed of the front", PROBE_COLOURS[3], "-", "v"),
}
BETA_STYLES = ("-", "--", ":")
MARKERS = "os^v"
FRACTION = r"$h/t_c$"
BEFORE, AFTER = 4.0, 12.0


def plot_fig22(data: xr.Dataset) -> Figure:
    """Draw a motion, excess damping, errors, and the checks.

    Parameters
    ----------
    data : xarray.Dataset
        Damping by the half-step scheme.
    """
    figure, panels = new_figure(5.6, [["motion", "excess"], ["error", "checks"]])
    _draw_motion(panels["motion"], data)
    _draw_excess(panels["excess"], data)
    _draw_errors(panels["error"], data)
    _draw_checks(panels["checks"], data)
    return figure


def _draw_motion(axes: Axes, data: xr.Dataset) -> None:
    """Draw u of the contact in the middle, by the scheme and accurately."""
    shown = configuration_of(data)["shown"]
    accurate, method = (data[f"relative_displacement_{name}"] for name in ("accurate", "method"))
    label = rf"scheme, $h = t_c/{shown['steps_per_collision']}$"
    axes.plot(accurate["t"], accurate, "-", color=EQUATION_COLOUR, label="accurate")
    axes.plot(method["t"], method, ".", color=CHAIN_COLOUR, markersize=3.5, label=label)
    arrival = float(accurate["t"][int(np.argmax(accurate.values > 0.5))])
    axes.set(
        xlim=(arrival - BEFORE, arrival + AFTER),
        xlabel="$t$",
        ylabel="$u_n$",
        title=rf"$\beta = {shown['beta']:g}$, $\gamma = {shown['gamma']:g}$",
    )
    axes.legend(loc="lower right")


def _draw_excess(axes: Axes, data: xr.Dataset) -> None:
    """Excess damping by the overshoot, and by the tail in grey, for each law and damping."""
    for colour, gamma in zip(PROBE_COLOURS, data["gamma"].values, strict=False):
        for style, beta in zip(BETA_STYLES, data["beta"].values, strict=False):
            row = data.sel(gamma=gamma, beta=beta)
            label = rf"$\gamma = {gamma:g}$" if beta == data["beta"].values[0] else None
            axes.loglog(row["step"], row["excess_tail"], style, color="#b0b0b0", linewidth=0.8)
            axes.loglog(row["step"], row["excess_overshoot"], style, color=colour, label=label)
    axes.set(xlabel=FRACTION, ylabel="excess damping", title="overshoot; grey: tail")
    # Room for the legend.
    axes.set_ylim(bottom=0.1 * float(data["excess_tail"].min()))
    betas = ", ".join(f"{beta:g}" for beta in data["beta"].values)
    axes.legend(title=rf"full, dashed, dotted: $\beta =$ {betas}", title_fontsize=7, fontsize=7)


def _draw_errors(axes: Axes, data: xr.Dataset) -> None:
    """Largest error of u at the end, with the observed order of each."""
    for colour, gamma in zip(PROBE_COLOURS, data["gamma"].values, strict=False):
        for style, beta in zip(BETA_STYLES, data["beta"].values, strict=False):
            row = data.sel(gamma=gamma, beta=beta)
            axes.loglog(row["step"], row["error"], style, color=colour)
    orders = data["order"]
    axes.set(
        xlabel=FRACTION,
        ylabel=r"$\max_n |\Delta u_n|$",
        title=f"orders {float(orders.min()):.2f} to {float(orders.max()):.2f}",
    )


def _draw_checks(axes: Axes, data: xr.Dataset) -> None:
    """Both readings of the damping of the chain that is shown, beside the checks."""
    shown = configuration_of(data)["shown"]
    chain = data.sel(beta=shown["beta"], gamma=shown["gamma"])
    for name, (label, colour, style, marker) in CHECKS.items():
        axes.loglog(
            chain["step"],
            chain[name],
            linestyle=style,
            color=colour,
            marker=marker,
            markersize=3,
            label=label,
        )
    axes.set(xlabel=FRACTION, ylabel="relative error", title="what a check sees")
    axes.set_ylim(bottom=1.0e-9)
    momentum = float(chain["momentum_defect"].max())
    axes.legend(
        fontsize=6.5,
        title_fontsize=6.5,
        loc="lower right",
        title=f"momentum: at most {momentum:.1e}",
    )


if __name__ == "__main__":
    run_figure(plot_fig22, globals().get("snakemake"))
