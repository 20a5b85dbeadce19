"""Numbers measured on pulses in tapered chains, the dataset of `tapered_chains`."""

from itertools import pairwise

import numpy as np

from granular_fronts.accuracy import Estimate, tabulated


def speed_over_exact(pulses, chain, first, last):
    """Return the speed by binary collisions over the exact one, where they differ most."""
    one = pulses.sel(chain=chain, contact=slice(first, last))
    exact, collisions = (np.diff(one[name]) for name in ("time", "time_of_collisions"))
    ratio = exact / collisions
    worst = np.argmax(np.abs(ratio - 1.0))
    return Estimate(ratio[worst], 2.0 * pulses["time"].attrs["error_estimate"] / collisions[worst])


def compression_over_exact(pulses, chain, contact):
    """Return the largest compression by binary collisions over the exact one."""
    one = pulses.sel(chain=chain, contact=contact)
    exact = Estimate(float(one["compression"]), pulses["compression"].attrs["error_estimate"])
    return Estimate(float(one["compression_of_collisions"]), 0.0) / exact


def loss_of_vanishing_growth(pulses):
    """Return the loss over that of binary collisions for vanishing growth."""
    return _limit([tabulated(pulses, "loss_ratio", taper=size) for size in _smallest(pulses)], 1.0)


def loss_less_mass(pulses):
    """Return this loss less m_*/m."""
    return loss_of_vanishing_growth(pulses) - tabulated(pulses, "mass_of_wave")


def correction_over_theory(pulses):
    """Return the correction of the loss towards lighter beads over its theory, as it vanishes."""
    mass = tabulated(pulses, "mass_of_wave")
    ratios = []
    for size in _smallest(pulses):
        theory = float(pulses["loss_ratio_theory"].sel(taper=-size)) - mass.value
        found = tabulated(pulses, "loss_ratio", taper=-size)
        ratios.append((found - mass) * (1.0 / theory))
    return _limit(ratios, 0.5)


def _smallest(pulses):
    """Return the three smallest sizes of ε, each half of the next."""
    return pulses["taper"].values[pulses["taper"].values > 0.0][:3]


def _limit(three, power):
    """Return the limit of numbers at h, 2h and 4h that approach it as a power of h."""
    share = 1.0 / (2.0**power - 1.0)
    fine, coarse = (near + (near - far) * share for near, far in pairwise(three))
    return fine + Estimate(0.0, abs(fine.value - coarse.value))
