"""Figure 17: jump conditions against measured fronts of several lattices; James (2021), sect. 2."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure

WAYS = {
    "speed_exact": ("speed, exact front", "o"),
    "power_exact": ("power, exact front", "s"),
    "speed_travelling": ("speed, exact front in a chain", "D"),
    "speed_driven": ("speed, driven chain", "^"),
    "velocity_jump_driven": ("velocity jump, driven chain", "v"),
    "power_driven": ("power, driven chain", "x"),
}
SPELLINGS = {
    "kuwabara_kono": "Kuwabara–Kono",
    "simon_hunt_crossley": "Simon–Hunt–Crossley",
    "hertz": "Hertz",
    "toda": "Toda",
    "fpu": "FPU",
    "alpha": "α",
    "beta": "β",
}
PROFILES = 6
SHOWN_XI = (-12, 15)


def plot_fig17(data: xr.Dataset) -> Figure:
    """Draw distances from theory over stated errors, stated errors, and profiles.

    Parameters
    ----------
    data : xarray.Dataset
        The study of jump conditions.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(6.2, [["ratio", "error"], ["profile", "profile"]])
    laws = [_spell(name) for name in data["law"].values]
    places = np.arange(len(laws))[::-1]
    for (name, (label, marker)), colour in zip(WAYS.items(), PROBE_COLOURS, strict=True):
        style: dict[str, Any] = {
            "linestyle": "none",
            "marker": marker,
            "color": colour,
            "markersize": 4.5,
        }
        quantity = name.rpartition("_")[0]
        distance = data[name] - data[f"{quantity}_expected"]
        error = data[f"{name}_error"] + data[f"{quantity}_expected_error"]
        panels["ratio"].plot(distance / error, places, label=label, fillstyle="none", **style)
        relative = np.abs(data[f"{name}_error"] / data[f"{quantity}_expected"])
        panels["error"].plot(relative, places, fillstyle="none", **style)
    shown = max(1.3, 1.1 * np.abs(panels["ratio"].dataLim.intervalx).max())
    panels["ratio"].axvspan(-1.0, 1.0, color="0.93", zorder=0)
    panels["ratio"].set(
        xlabel="(measured − theory) / stated error", xlim=(-shown, shown), yticks=places
    )
    panels["ratio"].set_yticklabels(laws)
    panels["error"].set(xlabel="stated error, relative", xscale="log", yticks=places)
    panels["error"].set_yticklabels([])
    _draw_profiles(panels["profile"], data)
    figure.legend(*panels["ratio"].get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _spell(name: str) -> str:
    """The name of a lattice as people write it."""
    words = str(name)
    for key, spelling in SPELLINGS.items():
        words = words.replace(key, spelling)
    return words.replace("_", " ")


def _draw_profiles(axes: Axes, data: xr.Dataset) -> None:
    """Exact fronts, every second lattice, their middles at ξ = 0."""
    step = max(1, data.sizes["law"] // PROFILES)
    for law in data["law"].values[1::step][:PROFILES]:
        one = data.sel(law=law)
        states = f"{float(one['state_minus']):g} to {float(one['state_plus']):g}"
        axes.plot(data["xi"], one["profile"], label=f"{_spell(law)}, {states}")
    axes.set(
        xlabel=r"$\xi = n - |c|t$",
        ylabel=r"$(R - R_a)/(R_b - R_a)$",
        xlim=SHOWN_XI,
    )
    axes.legend(loc="center right")


if __name__ == "__main__":
    run_figure(plot_fig17, globals().get("snakemake"))
