r"""Numbers measured on a simulated chain, each with an error, for comparison with the paper.

A measure takes the dataset of a scene (see `recording`) and returns an `Estimate`.  Errors of the
recorded variables are carried through to first order.  A quadrature or an interpolation on the
space-time grid adds the change when the grid is halved.
"""

import json
import math

import numpy as np

from granular_fronts.accuracy import Estimate, certain_sign, estimate, recorded, rounded
from granular_fronts.scenes.chain import Chain

# A maximum of the mean compression counts if its prominence is this fraction of δ.
PROMINENCE = 0.1


def scene_of(dataset):
    """Return the scene of a chain that a dataset was computed from."""
    return Chain.read(json.loads(dataset.attrs["config"]))


def _applied_displacement(dataset):
    """Return δ of eq. (25), 0 where nothing is held."""
    return scene_of(dataset).boundary.left_end


def predicted_speed(dataset):
    """Return the speed (21) of a front into an uncompressed chain, James (2021), k = m = 1."""
    speed = _applied_displacement(dataset) ** ((scene_of(dataset).law.alpha - 1.0) / 2.0)
    return rounded(speed)


def front_speed(dataset):
    """Return the speed measured from the arrival times in the middle of the chain."""
    return recorded(dataset["front_speed"])


def force_overshoot(dataset):
    """Return the largest elastic force of the passing front at mid-chain, over the pressure."""
    alpha = scene_of(dataset).law.alpha
    peaks = dataset["first_peak"]
    peak = float(peaks.sel(bead=dataset.sizes["bead"] // 2)) / _applied_displacement(dataset)
    error = alpha * peak ** (alpha - 1.0) * peaks.attrs["error_estimate"]
    return Estimate(peak**alpha, error / _applied_displacement(dataset))


def displacement_overshoot(dataset):
    """Return the largest relative displacement of the whole motion over δ, minus 1."""
    largest = recorded(dataset["largest_relative_displacement"])
    return largest / _applied_displacement(dataset) - 1.0


def first_gap_time(dataset):
    """Return the time at which the first contact opens."""
    return recorded(dataset["first_gap_time"])


def smallest_relative_displacement(dataset):
    """Return the smallest relative displacement of the whole motion: minus the widest gap."""
    return recorded(dataset["smallest_relative_displacement"])


def smallest_relative_displacement_time(dataset):
    """When the widest gap is reached."""
    return recorded(dataset["smallest_relative_displacement_time"])


def mean_compression(dataset):
    """Return average of (x_1 − x_N)/N over the first full period, between its maxima, over δ."""
    mean = dataset["mean_relative_displacement"] / _applied_displacement(dataset)
    peaks = _maxima(mean)
    if peaks.size < 2:
        return Estimate(math.nan, math.nan)
    period = mean.isel(t_grid=slice(peaks[0], peaks[1] + 1))
    duration = float(period["t_grid"][-1] - period["t_grid"][0])
    coarse = period.isel(t_grid=slice(None, None, 2))
    return estimate(period.integrate("t_grid"), coarse.integrate("t_grid")) / duration


def _maxima(mean):
    """Return the rows of the noticeable maxima of (x_1 − x_N)/N over δ."""
    # Imported here since it takes longer than all other measures.
    from scipy.signal import find_peaks

    return find_peaks(mean, prominence=PROMINENCE)[0]


def middle_compression(dataset):
    """Return the middle between the extremes of (x_1 − x_N)/N after its first maximum, over δ."""
    mean = dataset["mean_relative_displacement"] / _applied_displacement(dataset)
    peaks = _maxima(mean)
    if peaks.size == 0:
        return Estimate(math.nan, math.nan)

    oscillation = mean.values[peaks[0] :]
    # An extreme may lie between two times of the grid.
    error = 0.5 * np.abs(np.diff(oscillation)).max()
    return Estimate(0.5 * (oscillation.max() + oscillation.min()), error)


def smallest_velocity(dataset):
    """Return the smallest velocity of any bead on the space-time grid."""
    return recorded(dataset["velocity_grid"].min(keep_attrs=True))


def smallest_velocity_behind(dataset):
    """Return the smallest velocity over v_p, on the grid, of beads that the front has passed.

    The error is the change that leaving out every other time makes.
    """
    velocity = dataset["velocity_grid"]
    passed = velocity.where(velocity["t_grid"] >= dataset["arrival_time"])
    scale = _applied_displacement(dataset) * predicted_speed(dataset).value
    smallest = estimate(passed.min(), passed.isel(t_grid=slice(None, None, 2)).min())
    return (smallest + Estimate(0.0, velocity.attrs["error_estimate"])) / scale


def momentum_growth(dataset):
    """Return Σẋ_n at the end of the run over δ^α t, the law quoted in section 3.3."""
    total = dataset["total_velocity"].isel(t_grid=-1)
    alpha = scene_of(dataset).law.alpha
    exact = _applied_displacement(dataset) ** alpha * float(total["t_grid"])
    return recorded(total) / exact


def velocity_front(dataset):
    """Return the bead at which the velocity falls through v_p/2 in the first snapshot.

    The error is the change that leaving out every other bead makes.
    """
    velocity = dataset["velocity"].isel(t=0)
    scale = _applied_displacement(dataset) * predicted_speed(dataset).value
    profile, beads = velocity.values / scale, velocity["bead"].values
    return estimate(last_fall(profile, beads, 0.5), last_fall(profile[::2], beads[::2], 0.5))


def peak_spread(dataset, beads):
    """Return the largest less smallest first peak of u/δ at some beads."""
    peaks = dataset["first_peak"].sel(bead=beads)
    largest, smallest = peaks.max(keep_attrs=True), peaks.min(keep_attrs=True)
    return (recorded(largest) - recorded(smallest)) / _applied_displacement(dataset)


def peak_decay(dataset, first, last):
    """Return the rate per bead at which the first peak of u falls from one contact to another."""
    peaks = dataset["first_peak"]
    ratio = recorded(peaks.sel(bead=first)) / recorded(peaks.sel(bead=last))
    return Estimate(math.log(ratio.value), ratio.error / ratio.value) / (last - first)


def spacing_defect(dataset, beads):
    """Return the largest relative deviation of times of travel between some beads from (21)."""
    arrival = dataset["arrival_time"].sel(bead=beads).values
    ratios = predicted_speed(dataset).value * np.diff(arrival) / np.diff(beads)
    error = 2.0 * dataset["arrival_time"].attrs["error_estimate"] / np.diff(arrival).min()
    return Estimate(float(np.abs(ratios - 1.0).max()), error)


def crossings(dataset, bead):
    """Return the number of times that u of a bead of the steady regime passes through δ."""
    u = dataset["relative_displacement_steady"].sel(bead_steady=bead)
    sides = np.sign(u.values - _applied_displacement(dataset))
    return Estimate(float(np.count_nonzero(np.diff(sides))), 0.0)


def second_arrival_time(dataset):
    """When the second shock reaches the end: the last bead but one gains velocity fastest then.

    The first shock is at the end at the last arrival time T and returns there after reflection at
    both ends.  So the search starts at 2 T; the result is uncertain by one step of the grid.
    """
    velocity = dataset["velocity_grid"].isel(bead=-2)
    late = velocity.sel(t_grid=slice(2.0 * float(dataset["arrival_time"].max()), None))
    times, gains = late["t_grid"].values, np.diff(late.values)
    i = int(np.argmax(gains))
    return Estimate(0.5 * (times[i] + times[i + 1]), float(times[i + 1] - times[i]))


def openings_after_the_widest_gap(dataset):
    """Return how many contacts are seen to open after the smallest relative displacement."""
    start = float(dataset["smallest_relative_displacement_time"])
    u = dataset["relative_displacement_grid"].isel(bead=slice(None, -1))
    signs = certain_sign(u).sel(t_grid=slice(start, None)).values
    opened = (signs[:-1] == 1) & (signs[1:] == -1)
    return Estimate(float(opened.any(axis=0).sum()), 0.0)


def openings(dataset):
    """Return the number of contacts that are seen open on the space-time grid."""
    u = dataset["relative_displacement_grid"].isel(bead=slice(None, -1))
    return Estimate(float((certain_sign(u) < 0).any("t_grid").sum()), 0.0)


def thickening(dataset):
    """Return the width of the first reflected front late in its way back, over its width early.

    The reflected front runs from the free end, reached at the last arrival time T, towards bead 1.
    Its width is the distance over which u falls from 0.9 δ to 0.1 δ, at 1.2 T and 1.7 T.
    """
    return _width_ratio(dataset, (1.7,), (1.2,))


def forward_thickening(dataset):
    """Return the same ratio for the front on its way to the free end.

    The front is not much wider than the distance of two beads.  Therefore its width is averaged,
    from 0.7 T to 0.9 T and from 0.2 T to 0.4 T.
    """
    return _width_ratio(dataset, np.linspace(0.7, 0.9, 21), np.linspace(0.2, 0.4, 21))


def backward_over_forward_width(dataset):
    """Return the width of the first reflected front at 1.7 T over its width before reflection."""
    return _width_ratio(dataset, (1.7,), np.linspace(0.7, 0.9, 21))


def _width_ratio(dataset, late, early):
    """Return mean width at some times over that at others, both in units of the last arrival time.

    The error is the change that leaving out every other bead makes.
    """
    end_reached = float(dataset["arrival_time"].max())

    def ratio(grid):
        widths = [
            np.mean([_width(grid, dataset, part * end_reached) for part in parts])
            for parts in (late, early)
        ]
        return float(widths[0] / widths[1])

    grid = dataset["relative_displacement_grid"].isel(bead=slice(None, -1))
    return estimate(ratio(grid), ratio(grid.isel(bead=slice(None, None, 2))))


def _width(grid, dataset, t):
    """Return the beads over which u falls from 0.9 δ to 0.1 δ at the grid time next to t."""
    profile = grid.sel(t_grid=t, method="nearest").values / _applied_displacement(dataset)
    ends = (last_fall(profile, grid["bead"].values, level) for level in (0.1, 0.9))
    return next(ends) - next(ends)


def last_fall(profile: np.ndarray, places: np.ndarray, level: float) -> float:
    """Return the last place, interpolated, at which a profile falls through a level.

    An IndexError says that it does not.
    """
    i = np.flatnonzero((profile[:-1] >= level) & (profile[1:] < level))[-1]
    share = (profile[i] - level) / (profile[i] - profile[i + 1])
    return float(places[i] + share * (places[i + 1] - places[i]))
