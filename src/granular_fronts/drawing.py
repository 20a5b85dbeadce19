"""Panels that several figures share: each draws what a dataset holds and computes nothing."""


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
