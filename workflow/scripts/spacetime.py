"""One space-time diagram, shared by the figures that show some."""


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
