r"""Numbers measured on a ring and its logarithmic Burgers equation, James (2021), section 4.3.

A measure takes the dataset of a periodic scene (see `granular_fronts.comparison`) and returns a
`Measured`.

Shock.  The ring is cut open half a turn behind and ahead of :math:`p + \tilde c t`, where the
centre of the start would be; the shock stands where the last fall of u through δ/2 lies, by linear
interpolation between beads (or sites of the equation).

Errors are those of the recorded variables, carried through to first order; where a position is
interpolated between beads, the change that leaving out every other bead makes is added.
"""

import numpy as np
from scipy.stats import linregress

from granular_fronts.chain.measures import recorded, scene_of
from granular_fronts.measured import Measured
from granular_fronts.slow_scales import scaling_of

# What counts as a gap, a negative velocity or a bump, relative to the scale of the pulse.
NOTICEABLE = 0.01


def scales(dataset):
    """Scales of the scene."""
    return scaling_of(scene_of(dataset))


def exactly(value):
    """A number from a closed formula, wrong by rounding only."""
    return Measured(float(value), float(np.spacing(abs(value))))


def epsilon(dataset):
    """Small parameter ε of section 4."""
    return exactly(scales(dataset).epsilon)


def half_length(dataset):
    """Half of the ring in ξ, ℓ = (p − 1/2) ε."""
    return exactly(scales(dataset).half_length(scene_of(dataset)["half_beads"]))


def ring_length(dataset):
    """L of eq. (26), minus the sum of all relative displacements of the start."""
    return exactly(-float(dataset["relative_displacement"].sel(t=0.0).sum()))


def upwind_spacing(dataset):
    """Space step of the explicit scheme."""
    points = scene_of(dataset)["equations"]["upwind"]["points"]
    return exactly(2.0 * half_length(dataset).value / points)


def upwind_step(dataset):
    """Time step of the explicit scheme, 4/5 of the limit of stability at Y = η."""
    spacing = upwind_spacing(dataset).value
    fastest = abs(np.log(scene_of(dataset)["start"]["floor"]))
    return exactly(0.8 * spacing**2 / (2.0 + fastest * spacing))


def displacement_excess(dataset):
    """Percent by which the equation's peak of u exceeds the chain's at the last snapshot."""
    return _excess(dataset, "relative_displacement", "logarithmic")


def velocity_excess(dataset):
    """The same for velocities."""
    return _excess(dataset, "velocity", "logarithmic")


def displacement_excess_upwind(dataset):
    """Percent for u, with the equation solved by the paper's scheme."""
    return _excess(dataset, "relative_displacement", "upwind")


def velocity_excess_upwind(dataset):
    """The same for velocities."""
    return _excess(dataset, "velocity", "upwind")


def _excess(dataset, field, solver):
    chain, told = dataset[field].isel(t=-1), dataset[f"{field}_{solver}"].isel(t=-1)
    peak, ratio = float(chain.max()), float(told.max() / chain.max())
    # Against the accurate solution the upwind run is wrong by design; its number has no error.
    wrong = 0.0 if solver == "upwind" else told.attrs["error_estimate"]
    return Measured(100.0 * (ratio - 1.0), 100.0 * (wrong + chain.attrs["error_estimate"]) / peak)


def shock_speed(dataset):
    """Speed of the chain's shock between the last two snapshots."""
    return _speed(dataset, "relative_displacement", "bead")


def shock_speed_equation(dataset):
    """Speed of the equation's shock between the last two snapshots."""
    return _speed(dataset, "relative_displacement_logarithmic", "site")


def shock_lead(dataset):
    """Beads by which the chain's shock is ahead of the equation's at the last snapshot."""
    chain = _shock(dataset, "relative_displacement", "bead", -1)
    told = _shock(dataset, "relative_displacement_logarithmic", "site", -1)
    return Measured(chain.value - told.value, chain.error + told.error)


def _speed(dataset, name, axis):
    first, last = (_shock(dataset, name, axis, row) for row in (-2, -1))
    duration = float(dataset["t"][-1] - dataset["t"][-2])
    return Measured((last.value - first.value) / duration, (last.error + first.error) / duration)


def _shock(dataset, name, axis, row):
    """Position of the shock in a snapshot, in beads, on the ring cut open."""
    position = _last_fall(dataset, name, axis, row, 1)
    return Measured(position, abs(position - _last_fall(dataset, name, axis, row, 2)))


def _last_fall(dataset, name, axis, row, stride):
    profile = dataset[name].isel({"t": row, axis: slice(None, None, stride)})
    scene, scaling = scene_of(dataset), scales(dataset)
    beads = dataset.sizes["bead"]
    centre = scene["half_beads"] + scaling.frame_speed * float(profile["t"])
    sites = profile[axis].values
    sites = sites + beads * np.round((centre - sites) / beads)
    order = np.argsort(sites)
    sites, u = sites[order], profile.values[order] / scaling.delta
    i = np.flatnonzero((u[:-1] >= 0.5) & (u[1:] < 0.5))[-1]
    return sites[i] + (u[i] - 0.5) / (u[i] - u[i + 1]) * (sites[i + 1] - sites[i])


def gap_time(dataset):
    """First time on the grid at which a gap is wider than 1 % of δ."""
    level = -NOTICEABLE * scales(dataset).delta
    return _first_time(dataset["relative_displacement_grid"].min("bead") < level)


def deepest_gap(dataset):
    """Smallest relative displacement of the whole motion."""
    return recorded(dataset, "smallest_relative_displacement")


def negative_velocity_time(dataset):
    """First time on the grid at which a velocity is below −1 % of its scale."""
    level = -NOTICEABLE * scales(dataset).velocity_scale
    return _first_time(dataset["velocity_grid"].min("bead") < level)


def bump_height(dataset):
    """Largest u/δ − 1 of the whole motion: the bump on top of the plateau when it forms."""
    largest = recorded(dataset, "largest_relative_displacement")
    delta = scales(dataset).delta
    return Measured(largest.value / delta - 1.0, largest.error / delta)


def bump_velocity(dataset):
    """Velocity, in beads per time, of the largest u while it exceeds δ by more than 1 %.

    The first such stretch of time is taken, and a line fitted to the vertex of the parabola through
    the three highest beads; the error is twice the standard error of the slope.
    """
    u = dataset["relative_displacement_grid"]
    high = u.max("bead").values > (1.0 + NOTICEABLE) * scales(dataset).delta
    start = int(np.argmax(high))
    stop = start + int(np.argmin(np.append(high[start:], False)))
    if not high[start] or stop - start < 3:
        return Measured(np.nan, np.nan)
    places = [_vertex(profile) for profile in u.values[start:stop]]
    line = linregress(u["t_grid"].values[start:stop], places)
    return Measured(float(line.slope), 2.0 * float(line.stderr))


def _vertex(profile):
    """Bead number of the highest point of the parabola through the three highest beads."""
    i = int(np.argmax(profile))
    left, top, right = (profile[(i + k) % profile.size] for k in (-1, 0, 1))
    return i + 1 + 0.5 * (left - right) / (left - 2.0 * top + right)


def _first_time(found):
    """First grid time of a condition, uncertain by one step of the grid."""
    times = found["t_grid"].values
    if not found.any():
        return Measured(np.nan, np.nan)
    return Measured(float(times[int(np.argmax(found.values))]), float(times[1] - times[0]))
