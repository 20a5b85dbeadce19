"""What the step of discrete-element codes does to a front, and what does not see it."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, PROBE_COLOURS, new_figure
from job import job

CHECKS = {
    "excess_overshoot": ("damping, by the overshoot", PROBE_COLOURS[0], "-", "o", 1.5),
    "excess_tail": ("damping, by the tail", PROBE_COLOURS[0], "--", "o", 1.2),
    "restitution_defect": ("restitution, $1 - e$", PROBE_COLOURS[1], "-", "s", 0.9),
    "energy_defect": ("energy", PROBE_COLOURS[2], "-", "^", 0.9),
    "speed_defect": ("speed of the front", PROBE_COLOURS[4], "-", "v", 0.9),
}
SMALL = 0.01
BETA_STYLES: tuple[Any, ...] = ("-", "--", ":")
STEP = "step $h$, in times of a collision $t_c$"
BEFORE, AFTER = 4.0, 12.0


def half_step_damping(data: xr.Dataset) -> Figure:
    """Draw what is read and checked, a motion, excess damping, and errors.

    Parameters
    ----------
    data : xarray.Dataset
        Damping by the half-step scheme.
    """
    rows = [["checks"] * 3, ["motion", "excess", "error"]]
    figure, panels = new_figure(4.8, [rows[0], rows[0], rows[1], rows[1]])
    _draw_checks(panels["checks"], data)
    _draw_motion(panels["motion"], data)
    _draw_laws(panels["excess"], data, "excess_overshoot")
    _draw_laws(panels["error"], data, "error")
    panels["excess"].set_title("excess damping")
    panels["error"].set_title("error of all $u_n$")
    panels["excess"].legend()
    return figure


def _draw_checks(axes: Axes, data: xr.Dataset) -> None:
    """Both measurements of the damping of the chain that is shown, above the checks."""
    shown = configuration_of(data)["shown"]
    chain = data.sel(beta=shown["beta"], gamma=shown["gamma"])
    finest = int(np.argmin(chain["step"].values))
    for name, (label, colour, style, marker, width) in CHECKS.items():
        axes.loglog(
            chain["step"],
            chain[name],
            linestyle=style,
            linewidth=width,
            color=colour,
            marker=marker,
        )
        axes.annotate(
            label,
            (float(chain["step"][finest]), float(chain[name][finest])),
            xytext=(-8, 0),
            textcoords="offset points",
            horizontalalignment="right",
            verticalalignment="center",
            color=colour,
        )
    axes.set_ylim(axes.get_ylim())
    axes.axhspan(axes.get_ylim()[0], SMALL, color="0.92", zorder=0)
    axes.axhline(SMALL, color="0.5", linewidth=0.5)
    words: dict[str, Any] = {"transform": axes.get_yaxis_transform(), "verticalalignment": "top"}
    axes.text(0.01, 0.8 * SMALL, "below 1 %", color="0.3", **words)
    steps = chain["step"].values
    axes.set_xticks(steps, [f"1/{1.0 / step:.0f}" for step in steps])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(lambda value, _: f"{100.0 * value:g} %")
    # Room for the words at the left.
    axes.set(xlim=(0.17 * steps.min(), 1.1 * steps.max()), xlabel=STEP, ylabel="relative error")
    law = rf"$\beta = {shown['beta']:g}$, $\gamma = {shown['gamma']:g}$"
    axes.set_title(f"error of the damping, and of what is usually checked, {law}")


def _draw_motion(axes: Axes, data: xr.Dataset) -> None:
    """Draw u of the contact in the middle, by the scheme and accurately."""
    shown = configuration_of(data)["shown"]
    accurate, method = (data[f"relative_displacement_{name}"] for name in ("accurate", "method"))
    label = f"$h = t_c/{shown['steps_per_collision']}$"
    axes.plot(accurate["t"], accurate, "-", color=EQUATION_COLOUR, label="accurate")
    axes.plot(method["t"], method, ".", color=CHAIN_COLOUR, label=label)
    arrival = float(accurate["t"][int(np.argmax(accurate.values > 0.5))])
    axes.set(xlim=(arrival - BEFORE, arrival + AFTER), xlabel="$t$", ylabel="$u_n$")
    axes.set_title("a contact")
    axes.legend(loc="lower right", handlelength=1.5)


def _draw_laws(axes: Axes, data: xr.Dataset, name: str) -> None:
    """A number over the step, for each law, with the damping of the chain that is shown."""
    gamma = configuration_of(data)["shown"]["gamma"]
    for style, beta in zip(BETA_STYLES, data["beta"].values, strict=False):
        row = data.sel(gamma=gamma, beta=beta)
        look = {"color": CHAIN_COLOUR, "label": rf"$\beta = {beta:g}$"}
        axes.loglog(row["step"], row[name], style, **look)
    axes.set(xlabel="$h/t_c$")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            half_step_damping,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
