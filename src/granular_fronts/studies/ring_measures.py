r"""Numbers measured on a ring and its logarithmic Burgers equation, James (2021), section 4.3.

A measure takes the dataset of a periodic scene (see `studies.ring_against_equations`) and returns
an `Estimate`.

Shock.  The ring is cut open half a turn behind and ahead of :math:`p + \tilde c t`, where the
centre of the start would be.  The shock is where u last falls through δ/2, by linear interpolation
between beads (or sites of the equation).

Errors of the recorded variables are carried through to first order.  For a position between beads,
the change without every other bead is added.
"""

import json

import numpy as np
from scipy.stats import linregress

from granular_fronts.accuracy import Estimate, estimate, recorded, rounded
from granular_fronts.chain.measures import last_fall
from granular_fronts.scenes.ring import Ring

# What counts as a bump, relative to δ.
NOTICEABLE = 0.01


CHAIN, EQUATION = "relative_displacement", "relative_displacement_logarithmic"


def scene_of(dataset):
    """Return the scene of a ring that a dataset was computed from."""
    return Ring.read(json.loads(dataset.attrs["config"]))


def scales(dataset):
    """Return the scales of the scene."""
    return scene_of(dataset).scaling


def epsilon(dataset):
    """Return the small parameter ε of section 4."""
    return rounded(scales(dataset).epsilon)


def half_length(dataset):
    """Return half of the ring in ξ, ℓ = (p − 1/2) ε."""
    return rounded(scene_of(dataset).half_length)


def ring_length(dataset):
    """Return L of eq. (26), minus the sum of all relative displacements of the start."""
    return rounded(-float(dataset["relative_displacement"].sel(t=0.0).sum()))


def upwind_spacing(dataset):
    """Return the space step of the explicit scheme."""
    points = scene_of(dataset).equations.upwind.points
    return rounded(2.0 * half_length(dataset).value / points)


def upwind_step(dataset):
    """Return the time step of the explicit scheme, 4/5 of the limit of stability at Y = η."""
    spacing = upwind_spacing(dataset).value
    fastest = abs(np.log(scene_of(dataset).start.floor))
    return rounded(0.8 * spacing**2 / (2.0 + fastest * spacing))


def displacement_excess(dataset):
    """Return percent by which the equation's peak of u exceeds the chain's at the last snapshot."""
    return _excess(dataset, "relative_displacement", "logarithmic")


def velocity_excess(dataset):
    """Return the same for velocities."""
    return _excess(dataset, "velocity", "logarithmic")


def displacement_excess_upwind(dataset):
    """Return the percent for u, with the equation solved by the paper's scheme."""
    return _excess(dataset, "relative_displacement", "upwind")


def velocity_excess_upwind(dataset):
    """Return the same for velocities."""
    return _excess(dataset, "velocity", "upwind")


def _excess(dataset, field, solver):
    chain, equation = dataset[field].isel(t=-1), dataset[f"{field}_{solver}"].isel(t=-1)
    peak, ratio = float(chain.max()), float(equation.max() / chain.max())
    # Against the accurate solution the upwind run is wrong by design; its number has no error.
    wrong = 0.0 if solver == "upwind" else equation.attrs["error_estimate"]
    return Estimate(100.0 * (ratio - 1.0), 100.0 * (wrong + chain.attrs["error_estimate"]) / peak)


def shock_speed(dataset):
    """Return the speed of the chain's shock between the last two snapshots."""
    return _speed(dataset, CHAIN)


def shock_speed_equation(dataset):
    """Return the speed of the equation's shock between the last two snapshots."""
    return _speed(dataset, EQUATION)


def shock_speed_ratio(dataset):
    """Return the speed of the chain's shock over the equation's, between the last two snapshots."""
    return shock_speed(dataset) / shock_speed_equation(dataset)


def shock_lead(dataset):
    """Return beads by which the chain's shock is ahead of the equation's at the last snapshot."""
    chain, equation = (
        _shock_place(dataset, dataset[name].isel(t=-1)) for name in (CHAIN, EQUATION)
    )
    return chain - equation


def shock_travel(dataset):
    """Return the beads over which the chain's shock has run at the last snapshot."""
    first, last = (_shock_place(dataset, dataset[CHAIN].isel(t=row)) for row in (0, -1))
    return last - first


def aftershock_distance(dataset):
    """Return the largest |Δu|/δ 3 to 20 beads behind the shocks of both, last snapshot."""
    chain, equation = (dataset[name].isel(t=-1) for name in (CHAIN, EQUATION))
    behind = np.linspace(3.0, 20.0, 69)

    def distance(stride):
        profiles = []
        for profile in (chain, equation):
            sites, u = _cut_open(dataset, profile, stride)
            profiles.append(np.interp(last_fall(u, sites, 0.5) - behind, sites, u))
        return float(np.abs(profiles[0] - profiles[1]).max())

    return estimate(distance(1), distance(2))


def profile_correlation(dataset):
    """Return correlation of max(u, 0), chain with equation, over all beads at the last snapshot.

    Gaps count as u = 0, since the equation has no gaps, as section 1 says.
    """
    chain, equation = (dataset[name].isel(t=-1) for name in (CHAIN, EQUATION))

    def correlation(stride):
        sites, u = _cut_open(dataset, chain, stride)
        approximate = np.interp(sites, *_cut_open(dataset, equation, 1))
        return float(np.corrcoef(np.maximum(u, 0.0), approximate)[0, 1])

    return estimate(correlation(1), correlation(2))


def _speed(dataset, name):
    first, last = (_shock_place(dataset, dataset[name].isel(t=row)) for row in (-2, -1))
    return (last - first) / float(dataset["t"][-1] - dataset["t"][-2])


def _shock_place(dataset, profile):
    """Return the bead at the shock of a profile of u, on the ring cut open."""
    return estimate(
        *(last_fall(*reversed(_cut_open(dataset, profile, stride)), 0.5) for stride in (1, 2))
    )


def _cut_open(dataset, profile, stride):
    """Return the sites of every `stride`-th value, rising along the ring cut open, and u/δ."""
    (axis,) = profile.dims
    profile = profile[::stride]
    scene, scaling = scene_of(dataset), scales(dataset)
    time = float(profile["t" if "t" in profile.coords else "t_grid"])
    centre = scene.half_beads + scaling.frame_speed * time
    beads, sites = dataset.sizes["bead"], profile[axis].values
    sites = sites + beads * np.round((centre - sites) / beads)
    order = np.argsort(sites)
    return sites[order], profile.values[order] / scaling.delta


def small_parameter_ratio(dataset):
    """Return ε/min(1, γc), which section 4.1 requires to be much less than 1."""
    scaling = scales(dataset)
    return rounded(scaling.epsilon / min(1.0, scaling.gamma * scaling.speed))


def damping_parameter(dataset):
    """Return μ of (54), by 12/μ² = ε/γc."""
    return rounded((12.0 / scales(dataset).ratio) ** 0.5, units=4.0)


def plateau_ratio(first, second):
    """Return the plateau of the start, in beads, second scene over first."""
    lengths = [
        scene_of(dataset).start.half_width / scales(dataset).epsilon for dataset in (first, second)
    ]
    return rounded(lengths[1] / lengths[0])


def _final_peak(dataset):
    """Return the largest u/δ of the chain at the last snapshot."""
    return recorded(dataset[CHAIN].isel(t=-1).max(keep_attrs=True)) / scales(dataset).delta


def peak_ratio(first, second):
    """Return the largest u/δ at the last snapshot, second scene over first."""
    return _final_peak(second) / _final_peak(first)


def bump_of_equation(dataset):
    """Return the largest u/δ − 1 of the equation in all snapshots."""
    return recorded(dataset[EQUATION].max(keep_attrs=True)) / scales(dataset).delta - 1.0


def gap_of_equation(dataset):
    """Return the smallest u/δ of the equation in all snapshots."""
    return recorded(dataset[EQUATION].min(keep_attrs=True)) / scales(dataset).delta


def smallest_velocity_of_equation(dataset):
    """Return the smallest velocity of the equation in all snapshots, over its scale."""
    return (
        recorded(dataset["velocity_logarithmic"].min(keep_attrs=True))
        / scales(dataset).velocity_scale
    )


def bump_birthplace(dataset):
    """Return the beads from the first u above δ by 1 %, on the grid of times, to the shock."""
    u = dataset["relative_displacement_grid"]
    level = (1.0 + NOTICEABLE) * scales(dataset).delta
    profile = u.isel(t_grid=int(np.argmax(u.max("bead").values > level)))
    shock = _shock_place(dataset, profile)
    # The bump is seen at whole beads, the vertex lies within half a bead.
    return shock - Estimate(_vertex(profile.values), 0.5)


def deepest_gap(dataset):
    """Return the smallest relative displacement of the whole motion."""
    return recorded(dataset["smallest_relative_displacement"])


def bump_height(dataset):
    """Return largest u/δ − 1 of the whole motion: the bump on top of the plateau when it forms."""
    largest = recorded(dataset["largest_relative_displacement"])
    return largest / scales(dataset).delta - 1.0


def bump_velocity(dataset):
    """Return the velocity, in beads per time, of the largest u while it exceeds δ by more than 1 %.

    In the first such stretch of time a line is fitted to the vertex of the parabola through the
    three highest beads.  The error is twice the standard error of the slope.
    """
    u = dataset["relative_displacement_grid"]
    high = u.max("bead").values > (1.0 + NOTICEABLE) * scales(dataset).delta
    start = int(np.argmax(high))
    stop = start + int(np.argmin(np.append(high[start:], False)))
    if not high[start] or stop - start < 3:
        return Estimate(np.nan, np.nan)
    places = [_vertex(profile) for profile in u.values[start:stop]]
    line = linregress(u["t_grid"].values[start:stop], places)
    return Estimate(float(line.slope), 2.0 * float(line.stderr))


def _vertex(profile):
    """Return bead number of the highest point of the parabola through the three highest beads."""
    i = int(np.argmax(profile))
    left, top, right = (profile[(i + k) % profile.size] for k in (-1, 0, 1))
    return i + 1 + 0.5 * (left - right) / (left - 2.0 * top + right)
