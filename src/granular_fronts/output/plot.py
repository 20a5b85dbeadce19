r"""Pictures of datasets in one line, with labels, for notebooks: `granular_fronts.plot`.

The panels are the same as in the figures (`granular_fronts.output.panels`); nothing is computed.
All numbers are dimensionless, in units of the law: of the paper's, James (2021), eq. (27).  Looks
are set for each picture separately, so that a notebook's other figures stay as they are.

=================  ============================================================================
`front`            u(ξ) of an exact front
`sweep`            overshoot of many fronts over the damping
`chain`            :math:`u_n` and :math:`\dot x_n` along a chain at its snapshots
`space_time`       the same in the (n, t) plane
`animate`          the same as a moving picture
=================  ============================================================================
"""

from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from granular_fronts.arguments import count, instance
from granular_fronts.errors import InputError
from granular_fronts.output.movies import Movie, moving_chain
from granular_fronts.output.panels import (
    FIELD_LABELS,
    MARK_HEIGHT,
    contacts_open,
    draw_open_contacts,
    draw_profile,
    draw_snapshot,
    draw_spacetime,
    fix_ordinate,
    moving_parts,
)
from granular_fronts.output.style import (
    PROBE_COLOURS,
    looks_of_figures,
    new_panels,
)

__all__ = ["animate", "chain", "front", "space_time", "sweep"]

VISIBLE = 1e-3
"""Share of the jump by which a front must differ from its states to be seen."""

COLUMNS = 6
"""Columns of a legend across a figure."""

LEAST_OVERSHOOT = 1e-12
"""Error up to which a front is called converged."""

DAMPINGS = {"gamma": r"$\gamma$", "factor": "factor of $W$"}
"""Label of what a sweep goes through, by the name of its coordinate."""

BETWEEN_MARKS = 0.03
"""Distance of the marks of two snapshots, as a share of the height of a panel."""


def front(front: xr.Dataset, axes: Axes | None = None) -> Axes:
    r"""Draw the relative displacement u of an exact front over ξ = n − ct.

    Parameters
    ----------
    front : xarray.Dataset
        From `granular_fronts.solve_front`, of any law.
    axes : matplotlib.axes.Axes, optional
        Where to add the curve; a new figure by default.  A new figure shows the ξ at which u
        differs from the states on either side by 0.1 per cent of the jump or more.

    Returns
    -------
    matplotlib.axes.Axes
        With u in units of the compression δ behind the front for the paper's law, and in units of
        the law otherwise.

    Raises
    ------
    InputError
        If this is no front, or one that has not converged.

    Examples
    --------
    >>> axes = gf.plot.front(gf.solve_front(alpha=1.5, gamma=0.1))
    >>> axes.get_xlabel()
    '$\\xi = n - ct$'
    """
    front = _holding("front", front, ("relative_displacement",), ("xi",), "solve_front")
    if not front.attrs.get("converged", 1):
        raise InputError(
            f"front has not converged ({front.attrs['reason']}): there is nothing to draw."
        )
    with looks_of_figures():
        new = axes is None
        axes = _new_axes() if axes is None else instance("axes", axes, Axes, "leave it out")
        draw_profile(axes, front)
        if "alpha" not in front.attrs:
            axes.set_ylabel("compression $u$")
        if new:
            axes.set_xlim(*_visible_range(front))
    return axes


def sweep(sweep: xr.Dataset, axes: Axes | None = None) -> Axes:
    r"""Draw the overshoot of many fronts over the damping, on a logarithmic ordinate.

    Parameters
    ----------
    sweep : xarray.Dataset
        From `granular_fronts.sweep_fronts`, of any law, or a campaign over the damping alone.
    axes : matplotlib.axes.Axes, optional
        Where to add the curve; a new figure by default.

    Returns
    -------
    matplotlib.axes.Axes
        Fronts leave a gap if they were not found or overshoot by less than 1e-12, the error that a
        front may have.

    Raises
    ------
    InputError
        If these are no fronts of a sweep.

    Examples
    --------
    >>> axes = gf.plot.sweep(gf.sweep_fronts(1.5, [0.1, 0.12]))
    >>> axes.get_ylabel()
    'overshoot $\\max u/\\delta - 1$'
    """
    sweep = instance("sweep", sweep, xr.Dataset, "give what gf.sweep_fronts returns")
    [damping] = [name for name in DAMPINGS if name in sweep.dims] or ["gamma"]
    sweep = _holding("sweep", sweep, ("overshoot",), (damping,), "sweep_fronts")
    with looks_of_figures():
        axes = _new_axes() if axes is None else instance("axes", axes, Axes, "leave it out")
        overshoot = sweep["overshoot"].where(sweep["overshoot"] > LEAST_OVERSHOOT)
        axes.semilogy(sweep[damping], overshoot, ".-")
        if overshoot.isnull().all():
            axes.text(0.5, 0.5, "no overshoot", transform=axes.transAxes, ha="center")
        named = (
            r"overshoot $\max u/\delta - 1$" if damping == "gamma" else "overshoot of the strain"
        )
        if "width_10_90" not in sweep:  # No fronts, but chains of a campaign.
            named = fill(sweep["overshoot"].attrs["long_name"], 36)
        axes.set(xlabel=DAMPINGS[damping], ylabel=named)
    return axes


def chain(motion: xr.Dataset) -> tuple[Axes, Axes]:
    """Draw relative displacements and velocities along a chain at its snapshots.

    Parameters
    ----------
    motion : xarray.Dataset
        From `granular_fronts.simulate_chain`, of any law and with any ends, with `snapshots` in its
        record.

    Returns
    -------
    tuple of matplotlib.axes.Axes
        Relative displacements, with a mark at the lower edge for each contact that is open, and
        velocities.

    Raises
    ------
    InputError
        If this is no motion, or one without snapshots.

    Examples
    --------
    >>> motion = gf.simulate_chain({
    ...     "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.1}, "beads": 30,
    ...     "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
    ...     "start": {"kind": "rest"}, "end_time": 20.0,
    ...     "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    ...     "record": {"snapshots": [10.0, 20.0], "grid": {"step": 1.0}},
    ... })
    >>> displacements, velocities = gf.plot.chain(motion)
    """
    motion = _holding(
        "motion", motion, tuple(FIELD_LABELS), ("t", "bead"), "simulate_chain", "snapshots: [10]"
    )
    fields, opens = moving_parts(motion), contacts_open(motion)
    u = fields["relative_displacement"]
    with looks_of_figures():
        figure, panels = new_panels(2.7, [list(fields)], plt.figure)
        compression, velocity = panels.values()
        marks = []
        for row, time in enumerate(motion["t"].values):
            colour = PROBE_COLOURS[row % len(PROBE_COLOURS)]
            for field, values in fields.items():
                draw_snapshot(
                    panels[field], values[row], field, color=colour, label=f"$t = {time:g}$"
                )
            if opens:
                height = MARK_HEIGHT + row * BETWEEN_MARKS
                marks.append(draw_open_contacts(compression, u[row], height, color=colour))
        fix_ordinate(compression, u, opens=opens)
        opened = any(np.size(mark.get_xdata()) for mark in marks)
        named = [*velocity.get_lines(), *marks[:opened]]
        figure.legend(handles=named, loc="outside upper center", ncols=min(len(named), COLUMNS))
    return compression, velocity


def space_time(motion: xr.Dataset) -> tuple[Axes, Axes]:
    """Colour the (n, t) plane by relative displacements and by velocities, as in figure 2.

    Parameters
    ----------
    motion : xarray.Dataset
        From `granular_fronts.simulate_chain`, with a `grid` in its record.

    Returns
    -------
    tuple of matplotlib.axes.Axes
        Relative displacements and velocities.  Contacts wider open than any is compressed are red.

    Raises
    ------
    InputError
        If this is no motion, or one without a space-time grid.

    Examples
    --------
    >>> motion = gf.simulate_chain({
    ...     "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.1}, "beads": 30,
    ...     "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
    ...     "start": {"kind": "rest"}, "end_time": 20.0,
    ...     "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    ...     "record": {"snapshots": [], "grid": {"step": 1.0}},
    ... })
    >>> displacements, velocities = gf.plot.space_time(motion)
    """
    u, velocity = moving_parts(_on_grid(motion), "_grid").values()
    largest = float(u.max() if contacts_open(motion) else np.abs(u).max())
    with looks_of_figures():
        _, panels = new_panels(4.4, [["u", "velocity"]], plt.figure)
        draw_spacetime(panels["u"], u, "relative_displacement", (-largest, largest))
        limits = min(0.0, float(velocity.min())), float(velocity.max())
        draw_spacetime(panels["velocity"], velocity, "velocity", limits)
    return panels["u"], panels["velocity"]


def animate(motion: xr.Dataset, frames: int = 120) -> Movie:
    """Let the fields of a chain move, in a picture that notebooks play by themselves.

    Parameters
    ----------
    motion : xarray.Dataset
        From `granular_fronts.simulate_chain`, of any law and with any ends, with a `grid` in its
        record.
    frames : int, optional
        How many times of the grid to show, evenly spaced; all where it has no more.

    Returns
    -------
    granular_fronts.output.movies.Movie
        Beads as circles, below them relative displacements, with a mark for each contact that is
        open, and velocities.
        Its method ``write(path)`` keeps it in a file: gif, png or webp.

    Raises
    ------
    InputError
        If this is no motion, or one without a space-time grid.

    Examples
    --------
    >>> motion = gf.simulate_chain({
    ...     "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.1}, "beads": 30,
    ...     "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
    ...     "start": {"kind": "rest"}, "end_time": 20.0,
    ...     "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    ...     "record": {"snapshots": [], "grid": {"step": 1.0}},
    ... })
    >>> film = gf.plot.animate(motion, frames=10)
    """
    grid = _on_grid(motion)["t_grid"].values
    frames = min(count("frames", frames), grid.size)
    rows = np.linspace(0, grid.size - 1, frames).round().astype(int)
    with looks_of_figures():
        figure, show = moving_chain(motion)
    alternative = (
        "Beads, relative displacements and velocities along a chain, moving from "
        f"t = {grid[rows[0]]:g} to t = {grid[rows[-1]]:g}."
    )
    return Movie(figure, show, rows.tolist(), alternative)


def _new_axes() -> Axes:
    """The one panel of a new figure that a notebook shows."""
    _, panels = new_panels(2.8, [["panel"]], plt.figure)
    return panels["panel"]


def _visible_range(front: xr.Dataset) -> tuple[float, float]:
    """Return the ξ between which a front is seen to differ from the states on its sides."""
    xi, u = front["xi"].values, front["relative_displacement"].values
    seen = VISIBLE * abs(u[-1] - u[0])
    first = np.flatnonzero(np.abs(u - u[0]) > seen)[0]
    last = np.flatnonzero(np.abs(u - u[-1]) > seen)[-1]
    return float(xi[first]), float(xi[last])


def _on_grid(motion: xr.Dataset) -> xr.Dataset:
    """Return a motion that has a space-time grid."""
    return _holding(
        "motion",
        motion,
        tuple(f"{field}_grid" for field in FIELD_LABELS),
        ("t_grid", "bead"),
        "simulate_chain",
        "grid: {step: 1}",
    )


def _holding(
    name: str,
    dataset: object,
    variables: tuple[str, ...],
    dims: tuple[str, ...],
    source: str,
    record: str = "",
) -> xr.Dataset:
    """Return a dataset with some variables on some dimensions."""
    way = f"give what gf.{source} returns" + (f" with {record} in its record" if record else "")
    found = instance(name, dataset, xr.Dataset, way)
    for variable in variables:
        there = found[variable].dims if variable in found else dims
        if variable not in found or there != dims or not found[variable].size:
            other = f", but on ({', '.join(map(str, there))})" if there != dims else ""
            raise InputError(f"{name} has no {variable} on ({', '.join(dims)}){other}: {way}.")
    return found
