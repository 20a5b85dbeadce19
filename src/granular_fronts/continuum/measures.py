"""Numbers measured on fronts of the amplitude equations, for comparison with the paper.

A measure takes the dataset of a scene (see `survey`) and returns a `Measured`.
"""

import math

import numpy as np

from granular_fronts.continuum.heteroclinic import gaussian_centre
from granular_fronts.continuum.log_kdv_burgers import CRITICAL_DAMPING, linear_rates
from granular_fronts.measured import Measured

# Dampings of the sweep that the paper's statements about rates are tested at.
OSCILLATING, MONOTONE = 0.3, 3.0

# For larger μ below 2 the squared slope is so small that one may take it for zero.
CLEARLY_UNDERDAMPED = 1.5


def squared_slope_at_critical_damping(dataset):
    """q(1) of (59) for μ = 2."""
    return _squared_slope(dataset.sel(mu=[CRITICAL_DAMPING]), max)


def squared_slope_overdamped(dataset):
    """Largest q(1) for μ above 2."""
    return _squared_slope(dataset.sel(mu=dataset["mu"] > CRITICAL_DAMPING), max)


def squared_slope_underdamped(dataset):
    """Smallest q(1) for μ well below 2."""
    return _squared_slope(dataset.sel(mu=dataset["mu"] <= CLEARLY_UNDERDAMPED), min)


def _squared_slope(dataset, pick):
    squares = dataset["squared_slope_at_one"]
    return Measured(float(pick(squares.values)), float(squares.attrs["error_estimate"]))


def gaussian_defect(dataset):
    """Largest difference between the front for μ = 0 and the Gaussian of Remark 8."""
    y = dataset["rescaled_force"].sel(mu=0.0)
    exact = np.exp(0.5 - 0.25 * (y["s"] - gaussian_centre()) ** 2)
    return Measured(float(abs(y - exact).max()), float(y.attrs["error_estimate"]))


def growth_of_oscillations(dataset):
    """Measured growth rate over Re λ, oscillating front."""
    return _ratio(dataset, "growth_rate", OSCILLATING, linear_rates(OSCILLATING)[1].real)


def frequency_of_oscillations(dataset):
    """Measured angular frequency over Im λ, oscillating front."""
    return _ratio(dataset, "angular_frequency", OSCILLATING, linear_rates(OSCILLATING)[1].imag)


def slow_growth(dataset):
    """Measured growth rate over the smaller λ, monotone front."""
    return _ratio(dataset, "growth_rate", MONOTONE, linear_rates(MONOTONE)[0].real)


def _ratio(dataset, name, mu, exact):
    one = dataset.sel(mu=mu)
    return Measured(float(one[name]) / exact, float(one[f"{name}_error"]) / exact)


def transition(dataset):
    """μ at which the squared frequency of the oscillations, a line in μ², comes to zero."""
    oscillating = dataset.sel(mu=dataset["angular_frequency"] > 0.0)
    squares = oscillating["angular_frequency"] ** 2
    slope, value = np.polyfit(oscillating["mu"] ** 2, squares, 1)
    errors = 2.0 * oscillating["angular_frequency"] * oscillating["angular_frequency_error"]
    mu = math.sqrt(-value / slope)
    return Measured(mu, float(errors.max()) / (2.0 * mu * abs(slope)))
