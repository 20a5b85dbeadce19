r"""Numbers measured on a simulated chain, each with an error, for comparison with the paper.

A measure takes the dataset of a scene (see `recording`) and returns a `Measured`.  Errors are those
of the recorded variables, carried through to first order; a quadrature or an interpolation on the
space-time grid adds the change that halving the grid makes.
"""

import json
import math

import numpy as np
from scipy.signal import find_peaks

from granular_fronts.measured import Measured

# A maximum of the mean compression counts if it stands out by this fraction of δ.
PROMINENCE = 0.1


def recorded(dataset, name):
    """A recorded scalar and its error estimate."""
    return Measured(float(dataset[name]), float(dataset[name].attrs["error_estimate"]))


def scene_of(dataset):
    """The scene that a dataset was computed from."""
    return json.loads(dataset.attrs["config"])


def applied_displacement(dataset):
    """δ of eq. (25)."""
    return scene_of(dataset)["boundary"]["left"]


def predicted_speed(dataset):
    """Speed of a front into an uncompressed chain, James (2021), eq. (21), with k = m = 1."""
    speed = applied_displacement(dataset) ** ((scene_of(dataset)["law"]["alpha"] - 1.0) / 2.0)
    return Measured(speed, np.spacing(speed))


def front_speed(dataset):
    """Speed measured from the arrival times in the middle of the chain."""
    return recorded(dataset, "front_speed")


def force_overshoot(dataset):
    """Largest elastic force of the passing front, in the middle of the chain, over the pressure."""
    alpha = scene_of(dataset)["law"]["alpha"]
    peaks = dataset["first_peak"]
    peak = float(peaks.sel(bead=dataset.sizes["bead"] // 2)) / applied_displacement(dataset)
    error = alpha * peak ** (alpha - 1.0) * peaks.attrs["error_estimate"]
    return Measured(peak**alpha, error / applied_displacement(dataset))


def displacement_overshoot(dataset):
    """Largest relative displacement of the whole motion over δ, minus 1."""
    largest = recorded(dataset, "largest_relative_displacement")
    delta = applied_displacement(dataset)
    return Measured(largest.value / delta - 1.0, largest.error / delta)


def first_gap_time(dataset):
    """Time at which the first contact opens."""
    return recorded(dataset, "first_gap_time")


def smallest_relative_displacement(dataset):
    """Smallest relative displacement of the whole motion: minus the widest gap."""
    return recorded(dataset, "smallest_relative_displacement")


def smallest_relative_displacement_time(dataset):
    """When the widest gap is reached."""
    return recorded(dataset, "smallest_relative_displacement_time")


def mean_compression(dataset):
    """Average of (x_1 − x_N)/N over the first full period, between its maxima, over δ."""
    mean = dataset["mean_relative_displacement"] / applied_displacement(dataset)
    peaks, _ = find_peaks(mean, prominence=PROMINENCE)
    if peaks.size < 2:
        return Measured(math.nan, math.nan)
    period = mean.isel(t_grid=slice(peaks[0], peaks[1] + 1))
    duration = float(period["t_grid"][-1] - period["t_grid"][0])
    value = float(period.integrate("t_grid")) / duration
    coarse = float(period.isel(t_grid=slice(None, None, 2)).integrate("t_grid")) / duration
    return Measured(value, abs(value - coarse))


def middle_compression(dataset):
    """Midway between the extremes of (x_1 − x_N)/N after its first maximum, over δ."""
    mean = dataset["mean_relative_displacement"] / applied_displacement(dataset)
    peaks, _ = find_peaks(mean, prominence=PROMINENCE)
    if peaks.size == 0:
        return Measured(math.nan, math.nan)

    oscillation = mean.values[peaks[0] :]
    # An extreme may lie between two times of the grid.
    error = 0.5 * np.abs(np.diff(oscillation)).max()
    return Measured(0.5 * (oscillation.max() + oscillation.min()), error)


def smallest_velocity(dataset):
    """Smallest velocity of any bead on the space-time grid."""
    velocity = dataset["velocity_grid"]
    return Measured(float(velocity.min()), float(velocity.attrs["error_estimate"]))


def momentum_growth(dataset):
    """Σẋ_n at the end of the run over δ^α t, the law quoted in section 3.3."""
    total = dataset["total_velocity"].isel(t_grid=-1)
    alpha = scene_of(dataset)["law"]["alpha"]
    exact = applied_displacement(dataset) ** alpha * float(total["t_grid"])
    return Measured(float(total) / exact, dataset["total_velocity"].attrs["error_estimate"] / exact)


def thickening(dataset):
    """Width of the first reflected front late in its way back, over its width early.

    The reflected front runs from the free end, reached at the last arrival time T, towards bead 1;
    its width is the distance over which u falls from 0.9 δ to 0.1 δ, taken at 1.2 T and 1.7 T.
    """
    end_reached = float(dataset["arrival_time"].max())

    def ratio(grid):
        return reflected_width(grid, dataset, 1.7 * end_reached) / reflected_width(
            grid, dataset, 1.2 * end_reached
        )

    grid = dataset["relative_displacement_grid"].isel(bead=slice(None, -1))
    value = ratio(grid)
    return Measured(value, abs(value - ratio(grid.isel(bead=slice(None, None, 2)))))


def reflected_width(grid, dataset, t):
    """Distance in beads over which u falls from 0.9 δ to 0.1 δ at the grid time nearest to t."""
    profile = grid.sel(t_grid=t, method="nearest").values / applied_displacement(dataset)
    beads = grid["bead"].values
    # The profile falls with n; np.interp wants it rising.
    falling = np.minimum.accumulate(profile)[::-1]
    return np.interp(0.1, falling, beads[::-1]) - np.interp(0.9, falling, beads[::-1])
