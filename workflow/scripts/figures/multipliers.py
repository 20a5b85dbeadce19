"""Multipliers of exact fronts, flow over a bead-time and shift back."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from drawing import write_figure
from granular_fronts.output.style import ALARM_COLOUR, PROBE_COLOURS, new_figure
from job import job

MARKERS = ("o", "s", "^", "d")
CIRCLE = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 400))
# Multipliers that rounding moves farther are not shown.
LARGEST_ROUNDING = 1e-2


def multipliers(data: xr.Dataset) -> Figure:
    """Draw the spectra in the complex plane, and how the gap closes with the window.

    Parameters
    ----------
    data : xarray.Dataset
        The multipliers.
    """
    fronts = list(data["scene"].values)
    figure, panels = new_figure(5.8, [fronts, fronts, ["gap"] * len(fronts)])
    for front in fronts:
        _draw_spectrum(panels[front], data.sel(scene=front))
    handles, words = panels[fronts[0]].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside upper center", ncols=3)
    _draw_gap(panels["gap"], data)
    return figure


def _draw_spectrum(axes: Axes, data: xr.Dataset) -> None:
    """The unit circle, waves in the compressed chain behind the front, and every window."""
    axes.plot(CIRCLE.real, CIRCLE.imag, "-", color="black", linewidth=0.7)
    for branch in data["branch"].values:
        real, imaginary = (
            data[f"essential_multiplier_{part}"].sel(branch=branch)
            for part in ("real", "imaginary")
        )
        label = "waves of the compressed chain" if branch == data["branch"].values[0] else None
        axes.plot(real, imaginary, ".", color="0.8", markersize=2, label=label)
    for number, behind in enumerate(data["beads_behind"].values):
        spectrum = data.sel(beads_behind=behind)
        spectrum = spectrum.where(spectrum["multiplier_rounding"] < LARGEST_ROUNDING)
        axes.plot(
            spectrum["multiplier_real"],
            spectrum["multiplier_imaginary"],
            MARKERS[number % len(MARKERS)],
            color=PROBE_COLOURS[number % len(PROBE_COLOURS)],
            fillstyle="none",
            markersize=3.5,
            markeredgewidth=0.7,
            label=f"front, {behind} beads behind",
        )
    axes.plot(1.0, 0.0, "+", color=ALARM_COLOUR, markersize=11, label="translation")
    axes.set(title=_law(data), xlabel=r"Re $z$", ylabel=r"Im $z$", aspect="equal")


def _draw_gap(axes: Axes, data: xr.Dataset) -> None:
    """How far inside the unit circle the slowest multiplier lies, against the window."""
    for number, front in enumerate(data["scene"].values):
        one = data.sel(scene=front)
        look: dict[str, Any] = {
            "color": PROBE_COLOURS[number],
            "marker": MARKERS[number],
            "label": _law(one),
        }
        slowest = 1.0 - one["spectral_radius_without_translation"]
        axes.loglog(one["beads_behind"], slowest, linestyle="", **look)
    reflected = 1.0 - one["reflection_radius"]
    axes.loglog(one["beads_behind"], reflected, "-", color="0.6", label="reflected long waves")
    axes.set(xlabel="beads behind the front in the window", ylabel=r"$1 - |z|$ of the slowest")
    axes.set_xticks(data["beads_behind"], [f"{behind}" for behind in data["beads_behind"].values])
    axes.set_xticks([], minor=True)
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 4)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_locator(NullLocator())
    axes.legend()


def _law(data: xr.Dataset) -> str:
    """Exponent and damping of a front."""
    return rf"$\alpha = {float(data['alpha']):g}$, $\gamma c = {float(data['gamma']):g}$"


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            multipliers,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
