r"""Pictures of datasets in one line, with labels, for notebooks: `granular_fronts.plot`.

The panels are the same as in the figures (`granular_fronts.output.panels`); nothing is computed.
All numbers are dimensionless, in units of the law: of the paper's, James (2021), eq. (27).  Looks
are set for each picture separately, so that a notebook's other figures stay as they are.

=================  ============================================================================
`front`            u(ξ) of an exact front
`chain`            :math:`u_n` and :math:`\dot x_n` along a chain at its snapshots
`space_time`       the same in the (n, t) plane
=================  ============================================================================
"""

from collections.abc import Iterable, Sequence

from granular_fronts.errors import InputError

try:
    import matplotlib.pyplot as plt
except ValueError as error:
    raise InputError(
        f"Matplotlib does not start: {error}. Unset MPLBACKEND, or set it to agg."
    ) from error
import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from granular_fronts.arguments import instance
from granular_fronts.output.panels import (
    FIELD_LABELS,
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

__all__ = ["chain", "front", "space_time"]

VISIBLE = 1e-3
"""Share of the jump by which a front must differ from its states to be seen."""

COLUMNS = 6
"""Columns of a legend across a figure."""

MARK_HEIGHT = 0.04
"""Where open contacts of the first snapshot are marked, as a share of the height of a panel."""

BETWEEN_MARKS = 0.03
"""Distance of the marks of two snapshots, as a share of the height of a panel."""


def front(front: xr.Dataset, ax: Axes | None = None) -> Axes:
    r"""Draw the relative displacement u of an exact front over ξ = n − ct.

    Parameters
    ----------
    front : xarray.Dataset
        From `granular_fronts.solve_front`, of any law.
    ax : matplotlib.axes.Axes, optional
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
        new = ax is None
        ax = _new_axes() if ax is None else instance("ax", ax, Axes, "leave it out")
        draw_profile(ax, front)
        if "alpha" not in front.attrs:
            ax.set_ylabel("compression $u$")
        if new:
            ax.set_xlim(*_visible_range(front))
    return ax


def chain(motion: xr.Dataset, ax: Sequence[Axes] | None = None) -> tuple[Axes, Axes]:
    """Draw relative displacements and velocities along a chain at its snapshots.

    Parameters
    ----------
    motion : xarray.Dataset
        From `granular_fronts.simulate_chain`, of any law and with any ends, with `snapshots` in its
        record.
    ax : sequence of two matplotlib.axes.Axes, optional
        Where to draw relative displacements and velocities; a new figure by default.

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
        panels = dict(zip(fields, _pair(ax, 2.2), strict=True))
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
                marks.append(draw_open_contacts(compression, u[row], height, colour))
        fix_ordinate(compression, u, opens=opens)
        opened = any(np.size(mark.get_xdata()) for mark in marks)
        named = [*velocity.get_lines(), *marks[:opened]]
        if ax is None:
            columns = min(len(named), COLUMNS)
            velocity.figure.legend(handles=named, loc="outside upper center", ncols=columns)
        else:
            velocity.legend(handles=named)
    return compression, velocity


def space_time(motion: xr.Dataset, ax: Sequence[Axes] | None = None) -> tuple[Axes, Axes]:
    """Colour the (n, t) plane by relative displacements and by velocities, as in figure 2.

    Parameters
    ----------
    motion : xarray.Dataset
        From `granular_fronts.simulate_chain`, with a `grid` in its record.
    ax : sequence of two matplotlib.axes.Axes, optional
        Where to draw relative displacements and velocities; a new figure by default.

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
        left, right = _pair(ax, 3.4)
        draw_spacetime(left, u, "relative_displacement", (-largest, largest))
        limits = min(0.0, float(velocity.min())), float(velocity.max())
        draw_spacetime(right, velocity, "velocity", limits)
    return left, right


def _new_axes() -> Axes:
    """The one panel of a new figure that a notebook shows."""
    _, panels = new_panels(2.2, [["panel"]], plt.figure)
    return panels["panel"]


def _pair(ax: Sequence[Axes] | None, height: float) -> tuple[Axes, Axes]:
    """The two panels that are given, or those of a new figure of some height."""
    if ax is None:
        left, right = new_panels(height, [["left", "right"]], plt.figure)[1].values()
        return left, right
    given = [*ax] if isinstance(ax, Iterable) else []
    if len(given) != 2 or not all(isinstance(one, Axes) for one in given):
        raise InputError(f"ax is {ax!r}: give two axes of Matplotlib, or leave it out.")
    return given[0], given[1]


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
