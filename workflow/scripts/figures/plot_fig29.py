"""Figure 29: a striker on a chain of random masses, and the mean of many such chains."""

import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.campaign.averages import mean_over
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_struck_chains
from granular_fronts.output.style import LOOKS, new_figure

PASSED = "transmitted_energy", "largest_force"
SPREAD, SEED = "beads_mass_random_spread", "beads_mass_random_seed"


def plot_fig29(motion: xr.Dataset, draws: xr.Dataset) -> Figure:
    """Draw a disordered chain in space and time, and what passes over the strength of disorder.

    Parameters
    ----------
    motion : xarray.Dataset
        Scene disordered of the section real_chains.
    draws : xarray.Dataset
        Campaign disorder, with several seeds for each spread.
    """
    figure, panels = new_figure(3.6, [["motion", "passed"]])
    draw_struck_chains([panels["motion"]], motion)
    spread = configuration_of(motion)["beads"]["mass"]["random"]["spread"]
    panels["motion"].set_title(f"masses with a spread of {spread:g}")
    axes = panels["passed"]
    means, across = mean_over(draws, SEED), draws[SPREAD]
    for name in PASSED:
        look = LOOKS[name]
        axes.plot(across, draws[name].transpose(SPREAD, SEED), ".", color=look.color, alpha=0.25)
        axes.errorbar(across, means[name], means[f"{name}_error"], capsize=3, **look._asdict())
    axes.set(xlabel="spread of the masses", ylabel="what passes", ylim=(0.0, None))
    axes.legend(loc="lower left")
    return figure


if __name__ == "__main__":
    run_figure(plot_fig29, globals().get("snakemake"))
