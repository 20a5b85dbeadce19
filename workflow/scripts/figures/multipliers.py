"""Multipliers of exact fronts, flow over a bead-time and shift back."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

MARKERS = ("o", "s", "^", "v", "D")
CIRCLE = np.exp(1j * np.linspace(0.0, 2.0 * np.pi, 400))
# Multipliers that rounding moves farther are not shown.
LARGEST_ROUNDING = 1e-2
NEAR = 0.12
"""Side of the panels that show the neighbourhood of 1."""


def multipliers(data: xr.Dataset) -> Figure:
    """Draw the spectra in the complex plane, and how the gap closes with the window.

    Parameters
    ----------
    data : xarray.Dataset
        The multipliers.
    """
    fronts, windows = list(data["scene"].values), range(data.sizes["beads_behind"])
    near = [f"{front} near 1" for front in fronts]
    figure, panels = new_figure(4.1, [[*fronts, "gap"], [*near, "."]])
    for name, zoomed, front in zip(fronts, near, fronts, strict=True):
        whole, near_one, spectra = panels[name], panels[zoomed], data.sel(scene=front)
        _draw_spectrum(whole, spectra, windows[:1], 1.5)
        whole.set_title(_name(spectra), loc="right")
        whole.text(1.1, -1.06, "$|z| = 1$", ha="right")
        _draw_spectrum(near_one, spectra, windows, 2.3)
        near_one.set(xlim=(1.0 - NEAR, 1.0 + 0.1 * NEAR), ylim=(-0.55 * NEAR, 0.55 * NEAR))
        whole.indicate_inset(near_one.viewLim.bounds, edgecolor="0.4", linewidth=0.5, alpha=1.0)
        near_one.plot(1.0, 0.0, "+", color="black", markersize=7, label="translation")
        whole.text(0.78, 0.2, near_one.get_title("left"), ha="right")
    gap = panels["gap"]
    _draw_gap(gap, data)
    # Both legends are below it, in the empty place of the figure.
    look: dict[str, Any] = {"loc": "upper left", "alignment": "left"}
    gap.legend(title="(c)", bbox_to_anchor=(-0.1, -0.22), **look).set_in_layout(False)
    handles, words = panels[near[0]].get_legend_handles_labels()
    place: dict[str, Any] = {"bbox_to_anchor": (-0.1, -0.66), "bbox_transform": gap.transAxes}
    figure.legend(handles, words, title="other panels", borderaxespad=0.5, **place, **look)
    return figure


def _draw_spectrum(axes: Axes, data: xr.Dataset, windows: range, markersize: float) -> None:
    """The unit circle, waves in the compressed chain behind the front, and some windows.

    The first multiplier of each window is that of translation, the cross at 1.
    """
    axes.plot(CIRCLE.real, CIRCLE.imag, "-", color="black", linewidth=0.7, zorder=2.5)
    for branch in data["branch"].values:
        real, imaginary = (
            data[f"essential_multiplier_{part}"].sel(branch=branch)
            for part in ("real", "imaginary")
        )
        label = "waves of the compressed chain" if branch == data["branch"].values[0] else None
        axes.plot(real, imaginary, ".", color="0.8", markersize=1.4, label=label)
    for number in windows:
        spectrum = data.isel(beads_behind=number, multiplier=slice(1, None))
        spectrum = spectrum.where(spectrum["multiplier_rounding"] < LARGEST_ROUNDING)
        axes.plot(
            spectrum["multiplier_real"],
            spectrum["multiplier_imaginary"],
            MARKERS[number % len(MARKERS)],
            color=PROBE_COLOURS[number % len(PROBE_COLOURS)],
            fillstyle="none",
            markersize=markersize,
            label=f"front, {int(spectrum['beads_behind'])} beads behind",
        )
    axes.set(xlabel=r"Re $z$", ylabel=r"Im $z$", aspect="equal")


def _draw_gap(axes: Axes, data: xr.Dataset) -> None:
    """How far inside the unit circle the slowest multiplier lies, against the window."""
    for number, front in enumerate(data["scene"].values):
        one = data.sel(scene=front)
        look: dict[str, Any] = {
            "color": PROBE_COLOURS[-1 - number],
            "marker": MARKERS[-1 - number],
            # Marks of fronts that agree lie within each other.
            "markersize": 5.0 / (1 + number),
            "fillstyle": "none",
            "label": _name(one),
        }
        slowest = 1.0 - one["spectral_radius_without_translation"]
        axes.loglog(one["beads_behind"], slowest, linestyle="", **look)
    reflected = 1.0 - one["reflection_radius"]
    axes.loglog(one["beads_behind"], reflected, "-", color="0.6", label="reflected long waves")
    axes.set(xlabel="beads behind the front in the window", ylabel=r"$1 - |z|$, slowest multiplier")
    slowest = 1.0 - data["spectral_radius_without_translation"]
    axes.set_ylim(float(0.7 * slowest.min()), float(1.5 * max(slowest.max(), reflected.max())))
    axes.set_xticks(data["beads_behind"], [f"{behind}" for behind in data["beads_behind"].values])
    axes.set_xticks([], minor=True)
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 3, 5, 7)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_locator(NullLocator())


def _name(data: xr.Dataset) -> str:
    """Name and damping of a front."""
    return rf"{data['scene'].item()}, $\gamma c = {float(data['gamma']):g}$"


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            multipliers,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
