"""A striker on dimers, tapered and disordered chains, and a chain that is driven."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.campaign.averages import mean_over
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.style import BLACK, new_figure
from job import job

LIGHT, CONTACT = "beads_mass_cell_2", "record_sensors_far_contacts_2"
RATIO, OTHER = "beads_mass_taper_ratio", "beads_mass_impurity_mass"
SPREAD, SEED = "beads_mass_random_spread", "beads_mass_random_seed"
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)


def real_chains(
    dimers: xr.Dataset, tapers: xr.Dataset, draws: xr.Dataset, driven: xr.Dataset
) -> Figure:
    """Draw the energy that passes three kinds of chain, and overshoots of a driven one.

    Parameters
    ----------
    dimers, tapers, draws, driven : xarray.Dataset
        Campaigns dimer_ratio, taper, disorder and driven_chain.
    """
    figure, panels = new_figure(4.2, [["dimers", "tapers"], ["draws", "driven"]])
    energy = dimers["transmitted_energy"]
    for contact in energy[CONTACT].values:
        label = f"beyond {contact // 2} cells"
        panels["dimers"].plot(energy[LIGHT], energy.sel({CONTACT: contact}), label=label)
    energy = tapers["transmitted_energy"]
    for ratio in energy[RATIO].values:
        label = f"each {100.0 * (1.0 - ratio):.0f} % lighter" if ratio < 1.0 else "equal beads"
        panels["tapers"].plot(energy[OTHER], energy.sel({RATIO: ratio}), label=label)
    _draw_disorder(panels["draws"], draws)
    for delta in driven["delta"].values:
        overshoot = driven["overshoot"].sel(delta=delta)
        panels["driven"].plot(driven["gamma"], overshoot, label=rf"$\delta = {delta:g}$")
    panels["driven"].set(xlabel=r"damping $\gamma$", ylabel=r"overshoot of $u/\delta$")
    panels["dimers"].set_xlabel("mass of every other bead")
    panels["tapers"].set_xlabel("mass of one other bead")
    for name in ("dimers", "tapers", "driven"):
        panels[name].set_xscale("log")
        panels[name].xaxis.set_major_formatter("{x:g}")
        panels[name].legend()
    for name, campaign in (("dimers", dimers), ("tapers", tapers), ("draws", draws)):
        _share_energy(panels[name], campaign)
    return figure


def _draw_disorder(axes: Axes, draws: xr.Dataset) -> None:
    """The energy that passes each chain as a dot, and the means with their errors."""
    means, energy = mean_over(draws, SEED), draws["transmitted_energy"].transpose(SPREAD, SEED)
    axes.plot(draws[SPREAD], energy, ".", color=BLACK, alpha=0.25)
    mean, error = means["transmitted_energy"], means["transmitted_energy_error"]
    axes.errorbar(draws[SPREAD], mean, error, color=BLACK, linestyle="-", capsize=2)
    axes.set_xlabel("spread of the masses")


def _share_energy(axes: Axes, campaign: xr.Dataset) -> None:
    """Let the ordinate show energies in per cent of that of the striker, whose mass is 1."""
    striker = 0.5 * configuration_of(campaign)["scene"]["start"]["velocity"] ** 2
    ticks = [share * striker for share in SHARES]
    axes.set_yticks(ticks, [f"{100.0 * share:g} %" for share in SHARES])
    axes.set(ylim=(0.0, 1.05 * striker), ylabel="energy that passes")


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            real_chains,
            snakemake.input.texts,
            snakemake.output,
            {},
            dimers=snakemake.input.dimers,
            tapers=snakemake.input.tapers,
            draws=snakemake.input.draws,
            driven=snakemake.input.driven,
        )
