"""Figure 28: a striker on a tapered chain, whose beads become lighter."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_struck_chains, draw_transmitted
from granular_fronts.output.style import new_figure

RATIO = "beads_mass_taper_ratio"
PASSED = "transmitted_energy", "transmitted_momentum", "largest_force"


def plot_fig28(motion: xr.Dataset, ratios: xr.Dataset) -> Figure:
    """Draw a tapered chain in space and time, and what passes over the ratio of masses.

    Parameters
    ----------
    motion : xarray.Dataset
        Scene tapered of the section real_chains.
    ratios : xarray.Dataset
        Campaign taper.
    """
    figure, panels = new_figure(3.6, [["motion", "passed"]])
    draw_struck_chains([panels["motion"]], motion)
    ratio = configuration_of(motion)["beads"]["mass"]["taper"]["ratio"]
    panels["motion"].set_title(f"each bead {100.0 * (1.0 - ratio):g} % lighter")
    axes = panels["passed"]
    draw_transmitted(axes, ratios, RATIO, *PASSED)
    axes.set(
        xlim=(ratios[RATIO][0], ratios[RATIO][-1]), xlabel="mass of a bead over that before it"
    )
    return figure


if __name__ == "__main__":
    run_figure(plot_fig28, globals().get("snakemake"))
