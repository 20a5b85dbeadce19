"""What several figures share: each function draws what a dataset holds and computes nothing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from granular_fronts.accuracy import certain_sign
from granular_fronts.output.style import compression_map, velocity_map

if TYPE_CHECKING:
    import xarray as xr

FIELD_LABELS = {
    "relative_displacement": "compression $u_n$",
    "velocity": r"velocity $\dot x_n$",
}
BEAD, TIME = "bead $n$", "time $t$"
WIDEST = 1.4
"""Largest compression in colours, over δ: the paper clips its colours at 0.14 where δ = 0.1."""


def draw_probes(axes: Axes, data: xr.Dataset, name: str) -> None:
    """u_n(t) of every bead of a probe set."""
    probes = data[f"relative_displacement_{name}"]
    for bead in probes[f"bead_{name}"].values:
        curve = probes.sel({f"bead_{name}": bead})
        axes.plot(curve[f"t_{name}"], curve, label=f"$n = {bead}$")
    axes.set(xlabel=TIME, ylabel=FIELD_LABELS["relative_displacement"])
    axes.set(xlim=(curve[f"t_{name}"][0], curve[f"t_{name}"][-1]))


def label_peaks(axes: Axes) -> None:
    """Write each curve's label above its highest point, in its colour."""
    for line in axes.get_lines():
        t, u = np.asarray(line.get_data())
        axes.annotate(
            str(line.get_label()),
            (t[u.argmax()], u.max()),
            xytext=(0, 3),
            textcoords="offset points",
            ha="center",
            color=line.get_color(),
        )


def draw_spacetime(
    axes: Axes, values: xr.DataArray, field: str, limits: tuple[float, float]
) -> None:
    """Colour the (n, t) plane by a field on (t_grid, bead), bead across and time upwards.

    With limits that are centred on 0 contacts at rest are white; wider gaps have one red.  The
    scale above begins and ends where the data do.
    """
    image = axes.pcolormesh(
        values["bead"],
        values["t_grid"],
        values,
        cmap=compression_map() if field == "relative_displacement" else velocity_map(),
        vmin=limits[0],
        vmax=limits[1],
        shading="nearest",
        rasterized=True,
    )
    axes.set(xlabel=BEAD, ylabel=TIME)
    lowest, highest = float(values.min()), float(values.max())
    extend = "min" if lowest < limits[0] else "neither"
    bar = axes.figure.colorbar(
        image,
        ax=axes,
        location="top",
        extend=extend,
        label=FIELD_LABELS[field],
        aspect=30,
        ticks=MaxNLocator(5),
    )
    bar.ax.set_xlim(max(limits[0], min(0.0, lowest)), min(limits[1], highest))


def name_waves(axes: Axes, arrivals: xr.DataArray) -> None:
    """Write the names of a front and of its reflection next to their ways in the (n, t) plane."""
    last, arrival, (_, end) = int(arrivals["bead"][-1]), float(arrivals.max()), axes.get_ylim()
    edge = [withStroke(linewidth=2, foreground="white")]
    if np.isnan(arrivals[-2]):
        return  # The front has not crossed the chain.
    axes.text(0.56 * last, 0.35 * arrival, "front", path_effects=edge)
    if 1.3 * arrival < end:
        axes.text(0.1 * last, 1.45 * arrival, "reflected wave", path_effects=edge)
    axes.text(0.62 * last, 0.15 * arrival, "at rest", color="0.5")


def draw_profile(axes: Axes, front: xr.Dataset, **look: Any) -> None:
    """u(ξ) of an exact front; `look` is that of the line, as in `matplotlib.axes.Axes.plot`."""
    axes.plot(front["xi"], front["relative_displacement"], "-", **look)
    axes.set(xlabel=r"$\xi = n - ct$", ylabel=r"compression $u/\delta$")


def draw_snapshot(axes: Axes, values: xr.DataArray, field: str, **look: Any) -> None:
    """A field on (bead) at one time, a dot for each bead on a thin line of some look."""
    dots: dict[str, Any] = {"marker": ".", "linestyle": "-", "markersize": 2, "linewidth": 0.5}
    axes.plot(values["bead"], values, **dots | look)
    axes.set(xlabel=BEAD, ylabel=FIELD_LABELS[field], xlim=(0, int(values["bead"][-1])))


def contacts_open(motion: xr.Dataset) -> bool:
    """Whether the contacts of a motion may open, since no force holds extended ones."""
    return bool(motion.attrs.get("contacts_open", 0))


def moving_parts(motion: xr.Dataset, suffix: str = "") -> dict[str, xr.DataArray]:
    """The fields of a motion by their names, displacements without the held end, no contact."""
    fields = {field: motion[f"{field}{suffix}"] for field in FIELD_LABELS}
    contacts = slice(motion.attrs.get("contacts"))
    fields["relative_displacement"] = fields["relative_displacement"].isel(bead=contacts)
    return fields


def draw_open_contacts(axes: Axes, u: xr.DataArray, height: float, colour: str) -> Line2D:
    """Mark contacts that are open, of relative displacements on (bead), at a share of the height.

    The height is that of the panel.
    """
    beads = u["bead"].values[certain_sign(u).values < 0]
    [marks] = axes.plot(
        beads,
        np.full(beads.size, height),
        "|",
        markeredgewidth=2.0,
        transform=axes.get_xaxis_transform(),
        clip_on=False,
        # A line without points would count as one at the corner of the figure.
        in_layout=False,
        color=colour,
        label="open contacts",
    )
    return marks


def fix_ordinate(axes: Axes, values: xr.DataArray, *, opens: bool) -> None:
    """Let a panel show a field of all times, from as far below zero as above where contacts open.

    Gaps may be wider than compressions by any factor.
    """
    low, high = float(values.min()), float(values.max())
    low = max(low, -high) if opens else low
    margin = 0.05 * (high - low) or 1.0
    axes.set_ylim(low - margin, high + margin)


def finish_grid(figure: Figure, lowest: Sequence[Axes], label: str, columns: int = 3) -> None:
    """Label the abscissae of the lowest row, and put the legend of all panels above them."""
    for axes in lowest:
        axes.set_xlabel(label)
    handles, words = lowest[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside upper center", ncols=min(len(words), columns))
