"""Numbers measured on fronts of the amplitude equations, for comparison with the paper.

A measure takes the dataset of a scene (see `survey` and `log_burgers`) and returns an `Estimate`.
"""

import math

import numpy as np

from granular_fronts.accuracy import Estimate, sampled_maximum, tabulated
from granular_fronts.continuum.log_kdv_burgers.equation import CRITICAL_DAMPING, linear_rates
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import gaussian_centre

# For larger μ below 2 the squared slope is so small that one may take it for zero.
CLEARLY_UNDERDAMPED = 1.5

# Where both y and 1 − y are larger than this, the slope of a front is far above its error.
INSIDE = 1.0e-6

# Weights of a derivative of order 6, from seven equidistant values.
SLOPE = np.array([-1, 9, -45, 0, 45, -9, 1]) / 60.0


def squared_slope_overdamped(dataset):
    """Return the largest q(1) for μ of 2 and above."""
    return _squared_slope(dataset.sel(mu=dataset["mu"] >= CRITICAL_DAMPING), max)


def squared_slope_underdamped(dataset):
    """Return the smallest q(1) for μ well below 2."""
    return _squared_slope(dataset.sel(mu=dataset["mu"] <= CLEARLY_UNDERDAMPED), min)


def _squared_slope(dataset, pick):
    squares = dataset["squared_slope_at_one"]
    return Estimate(float(pick(squares.values)), float(squares.attrs["error_estimate"]))


def smallest_steepness(dataset):
    """Return smallest −y'/(y(1 − y)) before any front first reaches y = 1: above 0 where q is."""
    return Estimate(min(map(_steepness, _each_mu(dataset))), _steepness_error(dataset))


def largest_overdamped_slope(dataset):
    """Return the largest y'/(y(1 − y)) of all fronts with μ of 2 and above; none rises."""
    overdamped = dataset.sel(mu=dataset["mu"] >= CRITICAL_DAMPING)
    return Estimate(-min(map(_steepness, _each_mu(overdamped))), _steepness_error(dataset))


def _each_mu(dataset):
    return [dataset.sel(mu=mu) for mu in dataset["mu"].values]


def _steepness(front):
    """Return the smallest −y'/(y(1 − y)) of a front, after it first reaches 1, far from ends."""
    y, slope = front["rescaled_force"].values, front["slope"].values
    reached = np.flatnonzero(y >= 1.0)
    ahead = np.arange(y.size) > (reached[-1] if reached.size else -1)
    inside = ahead & (y > INSIDE) & (y < 1.0 - INSIDE)
    return float((-slope[inside] / (y[inside] * (1.0 - y[inside]))).min())


def _steepness_error(dataset):
    errors = (dataset[name].attrs["error_estimate"] for name in ("slope", "rescaled_force"))
    return float(sum(errors)) / INSIDE


def residual_of_orbits(dataset, smallest_mu):
    """Return the largest defect of z' = μz − y ln y (57), so of (59), on orbits from some μ on.

    z' comes from differences of order 6, and their error is all that is left for an exact orbit.
    Over twice the spacing the defect is 2⁶ times as large, which the error estimate assumes.
    """
    sweep = _each_mu(dataset.sel(mu=dataset["mu"] >= smallest_mu))
    fine, coarse = np.max([_orbit_defects(orbit) for orbit in sweep], axis=0)
    return Estimate(float(fine), float(coarse) / 2.0**6)


def _orbit_defects(orbit):
    """Return the largest defects with differences over one and over two grid points."""
    s, y, slope = (orbit[name].values for name in ("s", "rescaled_force", "slope"))
    logarithm = orbit["log_rescaled_force"].values
    right = float(orbit["mu"]) * slope - y * logarithm
    defects = []
    for stride in (1, 2):
        h, margin = stride * (s[1] - s[0]), 3 * stride
        values = [slope[k * stride : slope.size - (6 - k) * stride] for k in range(7)]
        derivative = np.tensordot(SLOPE, values, 1) / h
        defects.append(np.abs(derivative - right[margin : slope.size - margin]).max())
    return defects


def gaussian_defect(dataset):
    """Return the largest difference between the front for μ = 0 and the Gaussian of Remark 8."""
    y = dataset["rescaled_force"].sel(mu=0.0)
    exact = np.exp(0.5 - 0.25 * (y["s"] - gaussian_centre()) ** 2)
    return Estimate(float(abs(y - exact).max()), float(y.attrs["error_estimate"]))


def growth_rate(dataset, mu):
    """Return the measured rate at which a front leaves (1, 0) over the smallest Re λ there."""
    return _ratio(
        dataset, "growth_rate", mu, linear_rates(mu)[0 if mu > CRITICAL_DAMPING else 1].real
    )


def angular_frequency(dataset, mu):
    """Return the measured angular frequency of a front about (1, 0), above 0 if it oscillates."""
    return _ratio(dataset, "angular_frequency", mu, 1.0)


def frequency(dataset, mu):
    """Return the measured angular frequency of an oscillating front over Im λ."""
    return _ratio(dataset, "angular_frequency", mu, linear_rates(mu)[1].imag)


def _ratio(dataset, name, mu, exact):
    return tabulated(dataset.sel(mu=mu), name) / exact


def transition(dataset):
    """Return μ at which the squared frequency of the oscillations, a line in μ², comes to zero."""
    oscillating = dataset.sel(mu=dataset["angular_frequency"] > 0.0)
    squares = oscillating["angular_frequency"] ** 2
    slope, value = np.polyfit(oscillating["mu"] ** 2, squares, 1)
    errors = 2.0 * oscillating["angular_frequency"] * oscillating["angular_frequency_error"]
    mu = math.sqrt(-value / slope)
    return Estimate(mu, float(errors.max()) / (2.0 * mu * abs(slope)))


def flux_distance(dataset, alpha, smallest=0.0):
    """Return the largest |f_α(y) − y ln y|, y from `smallest` to 1, over 1/e."""
    flux, limit = dataset["flux"].sel(alpha=alpha), dataset["flux_limit"]
    difference = abs(flux - limit).where(dataset["force"] >= smallest)
    return sampled_maximum(difference * math.e)


def profile_distance(dataset, alpha):
    """Return the largest distance of u/δ between the fronts (46) and (45)."""
    return sampled_maximum(abs(dataset["front"].sel(alpha=alpha) - dataset["front_limit"]))
