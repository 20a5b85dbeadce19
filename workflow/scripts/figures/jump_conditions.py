"""Jump conditions against measured fronts of several lattices; James (2021), sect. 2."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

# What is measured, and its mark.
WAYS = {
    "exact": {
        "speed_exact": ("speed, exact front", "o"),
        "speed_travelling": ("speed, exact front put into a chain", "D"),
        "power_exact": ("power, exact front", "s"),
    },
    "driven": {
        "speed_driven": ("speed, driven chain", "^"),
        "velocity_jump_driven": ("velocity jump, driven chain", "v"),
        "power_driven": ("power, driven chain", "x"),
    },
}
TITLES = {"exact": "exact fronts", "driven": "driven chains"}
DODGE = 0.27
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
SHOWN_XI = (-9, 15)


def jump_conditions(data: xr.Dataset) -> Figure:
    """Draw distances from theory over stated errors, stated errors, and profiles.

    Parameters
    ----------
    data : xarray.Dataset
        The study of jump conditions.

    Returns
    -------
    matplotlib.figure.Figure
    """
    top, bottom = ["exact", "driven", "error"], ["profile"] * 3
    figure, panels = new_figure(6.2, [top, top, top, bottom, bottom])
    laws = list(_spell(data))
    rows = np.arange(len(laws))[::-1]
    for group, colours in zip(WAYS, (PROBE_COLOURS[:3], PROBE_COLOURS[3:]), strict=True):
        axes, shifts = panels[group], (DODGE, 0.0, -DODGE)
        for (name, (label, marker)), colour, shift in zip(
            WAYS[group].items(), colours, shifts, strict=True
        ):
            look: dict[str, Any] = {
                "linestyle": "none",
                "marker": marker,
                "color": colour,
                "markersize": 4,
            }
            expected = f"{name.rpartition('_')[0]}_expected"
            error = data[f"{name}_error"] + data[f"{expected}_error"]
            axes.plot((data[name] - data[expected]) / error, rows + shift, fillstyle="none", **look)
            relative = np.abs(data[f"{name}_error"] / data[expected])
            panels["error"].plot(relative, rows + shift, fillstyle="none", label=label, **look)
        shown = max(1.3, 1.1 * np.abs(axes.dataLim.intervalx).max())
        axes.axvspan(-1.0, 1.0, color="0.93", zorder=0)
        axes.set(xlabel="distance / stated error", xlim=(-shown, shown))
        axes.set_title(TITLES[group])
    panels["error"].set(xlabel="relative", xscale="log", title="stated errors")
    for name in ("exact", "driven", "error"):
        panels[name].set_yticks(rows, laws if name == "exact" else [], fontsize=7.5)
        panels[name].hlines(rows[1:] + 0.5, *panels[name].get_xlim(), color="0.85", linewidth=0.5)
    _draw_profiles(panels["profile"], data, laws)
    handles, labels = panels["error"].get_legend_handles_labels()
    by_columns = [0, 3, 1, 4, 2, 5]
    figure.legend(
        [handles[k] for k in by_columns],
        [labels[k] for k in by_columns],
        loc="outside upper center",
        ncols=3,
        handlelength=1,
    )
    return figure


def _spell(data: xr.Dataset) -> Iterator[str]:
    """The names of the lattices as people write them, with β where the damping is a power."""
    cases = configuration_of(data)["cases"]
    for name in map(str, data["law"].values):
        words = name
        for key, spelling in SPELLINGS.items():
            words = words.replace(key, spelling)
        damping = cases[name]["dissipation"]
        power = rf", $\beta = {damping['alpha']:g}$" if damping["kind"] == "hertz" else ""
        yield words.replace("_", " ") + power


def _draw_profiles(axes: Axes, data: xr.Dataset, laws: list[str]) -> None:
    """Exact fronts, every second lattice, their middles at ξ = 0."""
    step = max(1, data.sizes["law"] // PROFILES)
    for row in range(1, data.sizes["law"], step)[:PROFILES]:
        one = data.isel(law=row)
        states = f"{float(one['state_minus']):g} to {float(one['state_plus']):g}".replace("-", "−")
        axes.plot(data["xi"], one["profile"], label=f"{laws[row]}; {states}")
    axes.set(
        xlabel=r"place in the moving frame, $\xi = n - |c|t$",
        ylabel=r"strain, $(R - R_a)/(R_b - R_a)$",
        title="some of the exact fronts",
        xlim=SHOWN_XI,
    )
    axes.legend(loc="center right", fontsize=7.5, handlelength=2.2)


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            jump_conditions,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
