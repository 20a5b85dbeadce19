"""Figure 26: a striker on a dimer chain, and what passes against the mass of the light beads."""

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.datasets import configuration_of
from granular_fronts.output.panels import draw_struck_chains
from granular_fronts.output.style import new_figure

MASS, CONTACT = "beads_mass_cell_2", "record_sensors_far_contacts_2"


def plot_fig26(solitary: xr.Dataset, attenuated: xr.Dataset, ratios: xr.Dataset) -> Figure:
    """Draw two dimers in space and time, and transmission over the mass of the light beads.

    Parameters
    ----------
    solitary, attenuated : xarray.Dataset
        Scenes of the section real_chains.
    ratios : xarray.Dataset
        Campaign dimer_ratio.
    """
    motions = {"solitary": solitary, "attenuated": attenuated}
    figure, panels = new_figure(6.0, [[*motions], ["energy"] * 2])
    draw_struck_chains([panels[name] for name in motions], *motions.values())
    masses = {name: light_mass(motion) for name, motion in motions.items()}
    panels["solitary"].set_title(f"one pulse stays, $m$ = {masses['solitary']:g}")
    panels["attenuated"].set_title(f"the pulse decays, $m$ = {masses['attenuated']:g}")
    _draw_energy(panels["energy"], ratios)
    for letter, mass in zip("ab", masses.values(), strict=True):
        panels["energy"].axvline(mass, color="0.6", linewidth=0.8, zorder=0)
        panels["energy"].text(mass, 0.0, f" ({letter})", va="bottom", color="0.4")
    return figure


def light_mass(motion: xr.Dataset) -> float:
    """Mass of every other bead of a dimer."""
    return configuration_of(motion)["beads"]["mass"]["cell"][1]


def _draw_energy(axes: Axes, ratios: xr.Dataset) -> None:
    """The energy that passes each contact, in per cent of the striker's."""
    striker = 0.5 * configuration_of(ratios)["scene"]["start"]["velocity"] ** 2
    for contact in ratios[CONTACT].values:
        energy = ratios["transmitted_energy"].sel({CONTACT: contact})
        axes.plot(energy[MASS], energy, label=f"beyond {contact // 2} cells")
    ticks = [0.0, 0.25, 0.5, 0.75, 1.0]
    axes.set_yticks(
        [share * striker for share in ticks], [f"{100.0 * share:g} %" for share in ticks]
    )
    axes.set(xscale="log", xlim=(ratios[MASS][0], ratios[MASS][-1]), ylim=(0.0, 1.05 * striker))
    masses = [0.05, 0.1, 0.2, 0.5, 1.0]
    axes.set_xticks(masses, [f"{mass:g}" for mass in masses])
    axes.minorticks_off()
    axes.set(xlabel="mass $m$ of every other bead", ylabel="energy that passes")
    axes.legend(loc="lower left")


if __name__ == "__main__":
    run_figure(plot_fig26, globals().get("snakemake"))
