"""Numbers measured on contact laws, for comparison with the paper.

A measure takes the dataset that a module of this folder makes and returns a `Measured`.
"""

import math

import numpy as np

from granular_fronts.collision import weak_damping_slope
from granular_fronts.laws.materials import ALPHA
from granular_fronts.measured import Measured


def weak_damping_constant(_dataset):
    """γ/(1 − e) in the limit e → 1, a closed formula."""
    value = weak_damping_slope(ALPHA)
    return Measured(value, 4.0 * float(np.spacing(value)))


def gamma(dataset, material):
    """γ of the exact collision with the coefficient of restitution of a material."""
    found = dataset["gamma"]
    return Measured(float(found.sel(material=material)), float(found.attrs["error_estimate"]))


def velocity_power(dataset, beta):
    """Power of the velocity in γ by (29), from the smallest to the largest velocity."""
    law = dataset["gamma"].sel(beta=beta)
    ends = law.isel(velocity_ratio=[0, -1])
    span = math.log(float(ends["velocity_ratio"][1] / ends["velocity_ratio"][0]))
    power = math.log(float(ends[1] / ends[0])) / span
    return Measured(power, 8.0 * float(np.finfo(float).eps))


def restitution_gain(dataset, beta):
    """Restitution e at the smallest velocity less that at the largest.

    Above 0 if damping is weak at small velocities, below 0 if it is weak at large ones.
    """
    slowest, fastest = dataset["restitution"].sel(beta=beta).isel(velocity_ratio=[0, -1]).values
    error = 2.0 * dataset["restitution"].attrs["error_estimate"]
    return Measured(float(slowest - fastest), error)


def order_of_agreement(dataset):
    """Smallest observed order of the distance between the θ-method and the damped chain."""
    order = dataset["order"]
    return Measured(float(order.min()), float(order.attrs["error_estimate"]))


def front_speed(dataset, law, ramp):
    """Front speed ahead of a piston over that of (23)."""
    return _over_expected(dataset, "front_speed", law, ramp)


def compression_behind(dataset, law, ramp):
    """Compression behind the front of a piston over that of (22)."""
    return _over_expected(dataset, "compression_behind", law, ramp)


def velocity_behind(dataset, law, ramp):
    """v_p far from a piston over the velocity of the piston."""
    return _over_expected(dataset, "velocity_behind", law, ramp)


def _over_expected(dataset, name, law, ramp):
    case = dataset.sel(law=law, ramp=ramp)
    expected = float(case[f"{name}_expected"])
    return Measured(float(case[name]) / expected, float(case[f"{name}_error"]) / expected)


def signed_speed(dataset, law):
    """Speed of the exact front of a law over |c| of (14), negative if it runs to smaller n."""
    case = dataset.sel(law=law)
    expected = abs(float(case["speed_expected"]))
    errors = (case[name].attrs["error_estimate"] for name in ("speed_exact", "speed_expected"))
    return Measured(float(case["speed_exact"]) / expected, sum(errors) / expected)
