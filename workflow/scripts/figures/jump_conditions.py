"""Jump conditions against measured fronts of several lattices; James (2021), sect. 2."""

from collections.abc import Iterator

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import PROBE_COLOURS, new_figure
from job import job

# What is measured, in words, with its mark.
WAYS = {
    "speed_exact": ("speed, exact front", "o"),
    "speed_travelling": ("speed, exact front in a chain", "D"),
    "power_exact": ("power, exact front", "s"),
    "speed_driven": ("speed, driven chain", "^"),
    "velocity_jump_driven": ("velocity jump, driven chain", "v"),
    "power_driven": ("power, driven chain", "x"),
}
BETWEEN_MARKS = 0.155
SPELLINGS = {
    "kuwabara_kono": "Kuwabara–Kono",
    "simon_hunt_crossley": "Simon–Hunt–Crossley",
    "hertz": "Hertz",
    "toda": "Toda",
    "fpu": "FPU",
    "alpha": "α",
    "beta": "β",
}


def jump_conditions(data: xr.Dataset) -> Figure:
    """Draw distances from theory over stated errors, a row for each lattice.

    Parameters
    ----------
    data : xarray.Dataset
        The study of jump conditions.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(0.35 * data.sizes["law"] + 0.9, [["distances"]])
    axes, rows = panels["distances"], np.arange(data.sizes["law"])[::-1]
    shifts = BETWEEN_MARKS * (2.5 - np.arange(len(WAYS)))
    for (name, (label, marker)), colour, shift in zip(
        WAYS.items(), PROBE_COLOURS, shifts, strict=True
    ):
        expected = f"{name.rpartition('_')[0]}_expected"
        error = data[f"{name}_error"] + data[f"{expected}_error"]
        axes.plot(
            (data[name] - data[expected]) / error,
            rows + shift,
            marker,
            color=colour,
            fillstyle="none",
            label=label,
        )
    shown = 1.25 * max(1.0, np.abs(axes.dataLim.intervalx).max())
    axes.axvspan(-1.0, 1.0, color="0.93", zorder=0)
    axes.axvline(0.0, color="0.6", linewidth=0.4, zorder=0)
    axes.hlines(rows[1:] + 0.5, -shown, shown, color="0.8", linewidth=0.4)
    axes.set(xlabel="distance / stated error", xlim=(-shown, shown))
    axes.set_yticks(rows, list(_spell(data)))
    axes.set_ylim(rows[-1] - 0.6, rows[0] + 0.6)
    figure.legend(loc="outside upper center", ncols=2, handlelength=1)
    return figure


def _spell(data: xr.Dataset) -> Iterator[str]:
    """The names of the lattices as people write them, with β where the damping is a power."""
    cases = configuration_of(data)["cases"]
    for name in map(str, data["law"].values):
        words = name
        for key, spelling in SPELLINGS.items():
            words = words.replace(key, spelling)
        damping = cases[name]["dissipation"]
        power = "\n" rf"$\beta = {damping['alpha']:g}$" if damping["kind"] == "hertz" else ""
        yield words.replace("_", " ") + power


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            jump_conditions,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            data=snakemake.input.data,
        )
