"""Figure 27: a pulse meets one bead of another mass."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_struck_chains, draw_transmitted
from granular_fronts.output.style import new_figure

MASS, PLACE = "beads_mass_impurity_mass", "beads_mass_impurity_bead"


def plot_fig27(light: xr.Dataset, heavy: xr.Dataset, masses: xr.Dataset) -> Figure:
    """Draw a light and a heavy impurity in space and time, and what passes over its mass.

    Parameters
    ----------
    light, heavy : xarray.Dataset
        Scenes of the section real_chains.
    masses : xarray.Dataset
        Campaign impurity, of which the first place is shown.
    """
    figure, panels = new_figure(6.0, [["light", "heavy"], ["passed"] * 2])
    draw_struck_chains([panels["light"], panels["heavy"]], light, heavy)
    for name, motion in (("light", light), ("heavy", heavy)):
        impurity = configuration_of(motion)["beads"]["mass"]["impurity"]
        panels[name].set_title(f"bead {impurity['bead']} has the mass {impurity['mass']:g}")
    axes = panels["passed"]
    draw_transmitted(axes, masses.isel({PLACE: 0}), MASS, "transmitted_energy", "largest_force")
    axes.axvline(1.0, color="0.6", linewidth=0.8, zorder=0)
    axes.set(xscale="log", xlim=(masses[MASS][0], masses[MASS][-1]))
    ticks = [0.1, 1.0, 10.0]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xlabel("mass of the impurity")
    return figure


if __name__ == "__main__":
    run_figure(plot_fig27, globals().get("snakemake"))
