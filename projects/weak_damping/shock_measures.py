"""Numbers measured on the dataset of `dispersive_shocks`, each an `Estimate`."""

from granular_fronts.accuracy import Estimate, tabulated
from granular_fronts.fronts.solitary_waves import solitary_wave


def far_away(shocks, name):
    """Return the limit without damping, linear in 1/n, from the last contacts n/4, n/2 and n.

    Its change falls more slowly than 1/n, so that twice the last change is added to the error.
    """
    first, middle, last = (
        tabulated(shocks, name, gamma=0.0, contact=contact)
        for contact in shocks["contact"].values[-3:]
    )
    limit, before = 2.0 * last - middle, 2.0 * middle - first
    return limit + Estimate(0.0, 2.0 * abs(limit.value - before.value))


def speed_over_solitary(shocks):
    """Return the speed of the leading crest over that of a solitary wave of its height."""
    alpha = shocks.attrs["alpha"]
    height = far_away(shocks, "height") * (1.0 / float(solitary_wave(alpha).u.max()))
    return far_away(shocks, "speed") / height ** (0.5 * (alpha - 1.0))


def collapse(shocks, name, gamma, contact):
    """Return how a number at the same γn changes from 2γ to γ, over its change from 4γ to 2γ."""
    last, middle, first = (
        tabulated(shocks, name, gamma=gamma * times, contact=contact / times) for times in (1, 2, 4)
    )
    return (last - middle) / (middle - first)
