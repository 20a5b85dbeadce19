"""Panels that several figures share: each draws what a dataset holds and computes nothing."""

from granular_fronts.style import CHAIN_COLOUR, EQUATION_COLOUR

FIELD_LABELS = {"relative_displacement": "$u_n$", "velocity": r"$\dot x_n$"}


def draw_probes(axes, data, name):
    """u_n(t) of every bead of a probe set."""
    probes = data[f"relative_displacement_{name}"]
    for bead in probes[f"bead_{name}"].values:
        curve = probes.sel({f"bead_{name}": bead})
        axes.plot(curve[f"t_{name}"], curve, label=f"$n = {bead}$")
    axes.set(xlabel="$t$", ylabel="$u_n(t)$", xlim=(curve[f"t_{name}"][0], curve[f"t_{name}"][-1]))


def label_peaks(axes):
    """Write each curve's label above its highest point, in its colour."""
    for line in axes.get_lines():
        t, u = line.get_data()
        axes.annotate(
            line.get_label(),
            (t[u.argmax()], u.max()),
            xytext=(0, 3),
            textcoords="offset points",
            ha="center",
            fontsize=7,
            color=line.get_color(),
        )


def draw_spacetime(axes, values, *, colour_map, limits, extend, label):
    """Colour the (n, t) plane, bead number across and time upwards.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
    values : xarray.DataArray
        On (t_grid, bead).
    colour_map : matplotlib.colors.Colormap
    limits : tuple of float
        Ends of the colour scale; None for the extreme of the data.
    extend : str
        Ends of the colour bar that go on beyond the scale, as in matplotlib.
    label : str
        Of the colour bar.
    """
    image = axes.pcolormesh(
        values["bead"],
        values["t_grid"],
        values,
        cmap=colour_map,
        vmin=limits[0],
        vmax=limits[1],
        shading="nearest",
        rasterized=True,
    )
    axes.set(xlabel="$n$", ylabel="$t$")
    axes.figure.colorbar(image, ax=axes, location="top", extend=extend, label=label, aspect=30)


def draw_chain_dots(axes, snapshot, field):
    """A field of all beads, one dot each.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
    snapshot : xarray.Dataset
        One time of a comparison.
    field : str
        A key of `FIELD_LABELS`.
    """
    beads = snapshot[field]
    axes.plot(beads["bead"], beads, ".", color=CHAIN_COLOUR, markersize=2.5, label="chain")
    axes.set(ylabel=FIELD_LABELS[field], xlim=(0, int(beads["bead"][-1]) + 1))


def draw_comparison(panels, data):
    """Chain and logarithmic Burgers equation at every snapshot after the start.

    Parameters
    ----------
    panels : dict of matplotlib.axes.Axes
        Under `snapshot_rows`'s names.
    data : xarray.Dataset
        A comparison.
    """
    for row, names in enumerate(snapshot_rows(data), start=1):
        snapshot = data.isel(t=row)
        for name, field in zip(names, FIELD_LABELS, strict=True):
            axes, line = panels[name], snapshot[f"{field}_logarithmic"]
            axes.plot(line["site"], line, "-", color=EQUATION_COLOUR, label="equation (41)")
            draw_chain_dots(axes, snapshot, field)
            axes.set_title(f"$t = {float(snapshot['t']):g}$")
    panels[names[0]].set_xlabel("$n$")
    panels[names[1]].set_xlabel("$n$")
    panels[snapshot_rows(data)[0][0]].legend(loc="center right")


def snapshot_rows(data):
    """Mosaic of a comparison: a row for each snapshot after the start, a column for each field."""
    return [[f"{field} {row}" for field in FIELD_LABELS] for row in range(1, data.sizes["t"])]
