"""Critical damping in its several meanings, over the overshoot of the exact front."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import LogLocator

from drawing import write_figure
from granular_fronts.output.style import LOOKS, new_figure
from job import job

HIGHEST_GAMMA = 1.2
# Enlarged parts: exponents, and damping.
PARTS = {"plane near 1": ((1.02, 1.45), (0.07, 0.34)), "peaks": ((1.45, 3.0), (0.22, 0.56))}
# Places of the regions, as shares of the sides of the panel.
REGIONS = {"fronts are monotone": (0.3, 0.93), "fronts oscillate": (0.6, 0.15)}
STRIP = (0.68, 0.81)
PEAKS = ("second_peak_leads", "first_peak_stays_below")
EDGE = [withStroke(linewidth=2, foreground="white")]


def critical_damping(data: xr.Dataset, materials: xr.Dataset) -> Figure:
    """Draw the curves, and the overshoot as colour.

    Parameters
    ----------
    data : xarray.Dataset
        The damping map.
    materials : xarray.Dataset
        Beads of remark 6.
    """
    figure, panels = new_figure(4.4, [["plane", "plane near 1"], ["plane", "peaks"]])
    plane = panels["plane"]
    for axes in panels.values():
        colours = _draw_overshoot(axes, data)
        _draw_curves(axes, data)
        axes.set(xlabel=r"exponent $\alpha$ of the contact force", ylabel=r"damping $\gamma c$")
    look: dict[str, Any] = {"ax": list(panels.values()), "location": "bottom", "aspect": 60}
    bar = figure.colorbar(colours, label="overshoot of the front", **look)
    bar.ax.xaxis.set_major_formatter(lambda value, _: f"{100.0 * value:g} %")
    figure.legend(*plane.get_legend_handles_labels(), loc="outside upper center", ncols=4)
    _draw_materials(plane, materials)
    plane.set(yscale="log", ylim=(data["gamma"][0], HIGHEST_GAMMA))
    plane.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    plane.yaxis.set_major_formatter("{x:g}")
    plane.set(xlim=data["alpha"][[0, -1]])
    for name, (exponents, damping) in PARTS.items():
        part = panels[name]
        # What is outside the data is not white there.
        part.set(xlim=np.clip(exponents, *data["alpha"][[0, -1]].values))
        part.set(ylim=np.clip(damping, float(data["gamma"][0]), HIGHEST_GAMMA))
        plane.indicate_inset(part.viewLim.bounds, edgecolor="0.4", linewidth=0.5, alpha=1.0)
        plane.text(*part.viewLim.max, part.get_title("left"), ha="right", va="bottom")
    _draw_peaks(panels["peaks"], data)
    for words, place in REGIONS.items():
        plane.text(*place, words, transform=plane.transAxes, path_effects=EDGE)
    strip = f"overshoot < {100.0 * data.attrs['overshoot_cut']:g} %"
    panels["peaks"].text(*STRIP, strip, transform=panels["peaks"].transAxes)
    return figure


def _draw_curves(axes: Axes, data: xr.Dataset) -> None:
    """Critical damping in its meanings, and the exponent where two of them part."""
    for name in ("tail", "double_root", "long_wave", "overshoot"):
        axes.plot(
            data["alpha"],
            data[f"critical_damping_{name}"],
            # The overshoot's dashes are seen on the brown curves.
            zorder=2.5 if name == "overshoot" else 2.0,
            **LOOKS[name]._asdict(),
        )
    exchange = data.attrs["exchange_exponent"]
    axes.axvline(exchange, color="0.5", linewidth=0.9, linestyle=":")
    axes.text(
        exchange, 0.95, r" $\alpha^*$", transform=axes.get_xaxis_transform(), va="top", clip_on=True
    )


def _draw_peaks(axes: Axes, data: xr.Dataset) -> None:
    """Where the second maximum becomes the higher one, and the first no overshoot."""
    for name in PEAKS:
        axes.plot(data["alpha"], data[name], linewidth=0.7, **LOOKS[name]._asdict())
    axes.legend(
        handles=axes.lines[-len(PEAKS) :], loc="upper left", handlelength=1.8, borderaxespad=0
    )


def _draw_overshoot(axes: Axes, data: xr.Dataset) -> ScalarMappable:
    """Overshoot max u − 1 between its level curves; white below what is called too small to see."""
    levels = [data.attrs["overshoot_cut"], *data["level"].values]
    # A level that is passed below the panel, or nowhere, ends at its lower edge.
    curves = [data["critical_damping_overshoot"], *data["overshoot_level"].fillna(data["gamma"][0])]
    norm = BoundaryNorm(levels, 256)
    colours = ScalarMappable(norm, colormaps["viridis_r"])
    for level, upper, lower in zip(levels, curves, curves[1:], strict=False):
        colour = colours.to_rgba(level)
        axes.fill_between(data["alpha"], lower, upper, color=colour, linewidth=0.0)
    return colours


def _draw_materials(axes: Axes, materials: xr.Dataset) -> None:
    """The places of real beads in the plane of exponent and damping."""
    alpha = materials.attrs["alpha"]
    for gamma in materials["gamma_printed"]:
        axes.plot(alpha, gamma, "o", color="black", markeredgecolor="white", markersize=5)
        axes.annotate(
            str(gamma["material"].values),
            (alpha, float(gamma)),
            xytext=(7, -5),
            textcoords="offset points",
            va="center",
            fontweight="bold",
            path_effects=EDGE,
        )


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            critical_damping,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
            materials=snakemake.input.materials,
        )
