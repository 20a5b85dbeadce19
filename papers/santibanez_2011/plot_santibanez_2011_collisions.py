"""Waves after a collision, and secondary forces and shifts over its place."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure

LABELS = {0: "1 and 1", 2: "1 and 1.5", 3: "1 and 2"}


def plot_santibanez_2011_collisions(odd: xr.Dataset, even: xr.Dataset, found: xr.Dataset) -> Figure:
    """Draw two reflections, and what collisions at many places leave.

    Parameters
    ----------
    odd, even : xarray.Dataset
        Motions of chains that end at a wall, which acts as a bead and as a contact.
    found : xarray.Dataset
        Shifts and secondary waves.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.5, [["waves", "secondary", "shift"]])
    for motion, style in ((even, "k-"), (odd, "C0--")):
        forces = np.maximum(motion["relative_displacement"], 0.0) ** 1.5
        incident, after = (forces.isel(t=time, bead=slice(None, -2)) for time in range(2))
        panels["waves"].semilogy(motion["bead"][:-2], after / incident.max(), style, lw=0.9)
    panels["waves"].set(xlabel="contact $n$", ylabel="force over incident", ylim=(1e-3, 1.5))
    power = 2.0 * found.attrs["alpha"] / (found.attrs["alpha"] - 1.0)
    # Place 1 is the next contact.
    next_contact = found.sel(place=[0.0]).assign_coords(place=[1.0])
    found = xr.concat([found, next_contact], "place", combine_attrs="override")
    right = found.sel(direction=1)
    equal = right.sel(pair=0)
    panels["secondary"].plot(found["place"], equal["secondary"] ** power, "ko-", ms=4, lw=0.8)
    panels["secondary"].set(ylabel="secondary force over incident", ylim=(0.0, None))
    for (pair, label), color, style in zip(
        LABELS.items(), PROBE_COLOURS, PROBE_STYLES, strict=False
    ):
        shifts = right["shift"].sel(pair=pair)
        panels["shift"].plot(found["place"], shifts, "o", color=color, ls=style, ms=4, label=label)
    panels["shift"].set(ylabel="shift of the slower wave", ylim=(0.0, None))
    for name in ("secondary", "shift"):
        panels[name].set_xlabel("place of the collision")
    panels["shift"].legend(title="speeds")
    return figure


if __name__ == "__main__":
    run_figure(plot_santibanez_2011_collisions, globals().get("snakemake"))
