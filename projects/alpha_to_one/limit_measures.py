r"""Numbers measured on campaigns of rings: orders in ε, and comparisons of errors.

The order of an equation is the slope of :math:`\ln e` against :math:`\ln\varepsilon`, with e its
error at one slow time.  It is fitted by least squares over the rings with :math:`\alpha \le 1.1`.
Its error is twice the standard error of the slope.  Terms of the next order bend the line by far
more than the errors of the solvers.
"""

import numpy as np
from scipy.stats import linregress

from granular_fronts.accuracy import Estimate

LARGEST_EXPONENT = 1.1
"""Largest exponent of the rings that a slope is fitted to."""

ROUNDING = 1.0e-12
"""Rounding of μ, which is computed."""

NEAR = 1.2
"""Largest α of the rings on which equations are compared in the map."""

EQUATION_ERRORS = tuple(
    f"displacement_sup_{equation}" for equation in ("logarithmic", "unlimited", "dispersive")
)
"""Largest errors of u/δ of (41), (40) and (55)."""


def selected(dataset, error, *, slow_time=1.0, **place):
    """Return ε, the absolute error of a name and α of rings at one τ, by increasing α.

    `place` holds values of further axes; so it does below.
    """
    rings = dataset.sel(slow_time=slow_time, **place)
    return rings["epsilon_of_ring"].values, np.abs(rings[error].values), rings["alpha"].values


def fitted_order(dataset, error, **place):
    """Return the order in ε of an error."""
    epsilon, found, alpha = selected(dataset, error, **place)
    near = alpha <= LARGEST_EXPONENT
    line = linregress(np.log(epsilon[near]), np.log(found[near]))
    return Estimate(float(line.slope), 2.0 * float(line.stderr))


def error_of_ring(dataset, error, *, slow_time=1.0, **place):
    """Return an error of one ring, with what the solvers add to it."""
    value = dataset[error].sel(slow_time=slow_time, **place)
    return Estimate(abs(float(value)), float(dataset[error].attrs["error_estimate"]))


def smallest_ratio(dataset, error, other, *, slow_time=1.0, **place):
    """Return the smallest ratio of two errors over rings with α up to `LARGEST_EXPONENT`."""
    rings = dataset.sel(slow_time=slow_time, **place)
    rings = rings.where(rings["alpha"] <= LARGEST_EXPONENT, drop=True)
    ratios = np.abs(rings[error] / rings[other])
    least = float(ratios.min())
    floor = dataset[error].attrs["error_estimate"] + least * dataset[other].attrs["error_estimate"]
    return Estimate(least, float(floor / np.abs(rings[other]).min()))


def start_over_model(slow, leading, error, **place):
    """Return an error after the start (51) over the same after a start on the slow manifold."""
    return error_of_ring(leading, error, **place) / error_of_ring(slow, error, **place)


def error_ratio(dataset, error, other, **place):
    """Return an error of one ring over another."""
    return error_of_ring(dataset, error, **place) / error_of_ring(dataset, other, **place)


def growth(dataset, error, *, first, last, **place):
    """Return an error of one ring at the slow time `last` over that at `first`."""
    late, early = (error_of_ring(dataset, error, slow_time=time, **place) for time in (last, first))
    return late / early


def error_over_ratio(dataset, error, **place):
    """Return an error of one ring over its ε/γc."""
    return error_ratio(dataset, error, "ratio_of_ring", **place)


def largest_over_exponent(dataset, error, *, slow_time=1.0, least_mu=0.0, most_mu=np.inf):
    """Return the largest error over 1 − 1/α, for α up to `LARGEST_EXPONENT` and μ in a range."""
    rings = dataset.sel(slow_time=slow_time)
    rings = rings.where(rings["alpha"] <= LARGEST_EXPONENT, drop=True)
    mu, kappa = np.sqrt(12.0 / rings["ratio_of_ring"]), 1.0 - 1.0 / rings["alpha"]
    within = (mu > least_mu * (1.0 - ROUNDING)) & (mu < most_mu * (1.0 - ROUNDING))
    largest = float((np.abs(rings[error]) / kappa).where(within).max())
    return Estimate(largest, float(dataset[error].attrs["error_estimate"] / kappa.min()))


def smallest_order(damping, gamma):
    """Return the smallest order of the three equations, over rings at fixed γc and at fixed γ."""
    return min(_orders(damping, gamma))


def largest_order(damping, gamma):
    """Return the largest of these."""
    return max(_orders(damping, gamma))


def _orders(damping, gamma):
    for error in EQUATION_ERRORS:
        yield fitted_order(gamma, error)
        for value in damping["damping"].values:
            yield fitted_order(damping, error, damping=value)


def best_up_to(dataset, error):
    """Return the γ up to which an equation has the smallest error, for every α up to `NEAR`."""
    gamma, best = _best(dataset, error)
    return Estimate(float(gamma[np.logical_and.accumulate(best)].max()), ROUNDING)


def best_from(dataset, error):
    """Return the smallest γ above which an equation has the smallest error."""
    gamma, best = _best(dataset, error)
    return Estimate(float(gamma[::-1][np.logical_and.accumulate(best[::-1])].min()), ROUNDING)


def _best(dataset, error):
    """Return γ of a map, and whether an equation is best there for every α, at τ = 1."""
    rings = dataset.sel(slow_time=1.0)
    rings = rings.where(rings["alpha"] <= NEAR, drop=True)
    least = np.min([np.abs(rings[one]) for one in EQUATION_ERRORS], axis=0)
    best = (np.abs(rings[error]) == least) | np.isnan(rings[error])
    return rings["gamma"].values, best.all("alpha").values
