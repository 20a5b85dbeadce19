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


def gamma_of_glass(dataset):
    """γ of the exact collision, glass."""
    return _gamma(dataset, "glass")


def gamma_of_steel(dataset):
    """γ of the exact collision, steel."""
    return _gamma(dataset, "steel")


def gamma_of_cork(dataset):
    """γ of the exact collision, cork with a lead core."""
    return _gamma(dataset, "cork")


def _gamma(dataset, material):
    gamma = dataset["gamma"]
    return Measured(float(gamma.sel(material=material)), float(gamma.attrs["error_estimate"]))


def power_kuwabara_kono(dataset):
    """Power of the velocity in γ for β = α."""
    return _power(dataset, 1.5)


def power_simon_hunt_crossley(dataset):
    """Power of the velocity in γ for β = α + 1."""
    return _power(dataset, 2.5)


def power_dashpot(dataset):
    """Power of the velocity in γ for β = 1."""
    return _power(dataset, 1.0)


def power_degenerate(dataset):
    """Power of the velocity in γ for β = (α + 1)/2."""
    return _power(dataset, 1.25)


def _power(dataset, beta):
    law = dataset["gamma"].sel(beta=beta)
    ends = law.isel(velocity_ratio=[0, -1])
    span = math.log(float(ends["velocity_ratio"][1] / ends["velocity_ratio"][0]))
    power = math.log(float(ends[1] / ends[0])) / span
    return Measured(power, 8.0 * float(np.finfo(float).eps))


def order_of_agreement(dataset):
    """Smallest observed order of the distance between the θ-method and the damped chain."""
    order = dataset["order"]
    return Measured(float(order.min()), float(order.attrs["error_estimate"]))


def piston_speed_kuwabara_kono(dataset):
    """Front speed ahead of a piston of constant velocity over that of (23), β = α."""
    return _over_expected(_at_once(dataset), "front_speed", "kuwabara_kono")


def piston_speed_dashpot(dataset):
    """Front speed ahead of a piston of constant velocity over that of (23), β = 1."""
    return _over_expected(_at_once(dataset), "front_speed", "dashpot")


def piston_speed_simon_hunt_crossley(dataset):
    """Front speed ahead of a piston of constant velocity over that of (23), β = α + 1."""
    return _over_expected(_at_once(dataset), "front_speed", "simon_hunt_crossley")


def ramp_speed_kuwabara_kono(dataset):
    """Front speed ahead of a piston with a ramp over that of (23), β = α."""
    return _over_expected(_by_ramp(dataset), "front_speed", "kuwabara_kono")


def ramp_speed_dashpot(dataset):
    """Front speed ahead of a piston with a ramp over that of (23), β = 1."""
    return _over_expected(_by_ramp(dataset), "front_speed", "dashpot")


def ramp_speed_simon_hunt_crossley(dataset):
    """Front speed ahead of a piston with a ramp over that of (23), β = α + 1."""
    return _over_expected(_by_ramp(dataset), "front_speed", "simon_hunt_crossley")


def piston_compression_kuwabara_kono(dataset):
    """Compression behind the front of a piston of constant velocity over that of (22), β = α."""
    return _over_expected(_at_once(dataset), "compression_behind", "kuwabara_kono")


def ramp_compression_kuwabara_kono(dataset):
    """Compression behind the front of a piston with a ramp over that of (22), β = α."""
    return _over_expected(_by_ramp(dataset), "compression_behind", "kuwabara_kono")


def piston_velocity_kuwabara_kono(dataset):
    """v_p far from a piston of constant velocity over that velocity, β = α."""
    return _over_expected(_at_once(dataset), "velocity_behind", "kuwabara_kono")


def ramp_velocity_kuwabara_kono(dataset):
    """v_p far from a piston with a ramp over its last velocity, β = α."""
    return _over_expected(_by_ramp(dataset), "velocity_behind", "kuwabara_kono")


def _at_once(dataset):
    """Fronts of pistons of constant velocity."""
    return dataset.sel(ramp=0.0)


def _by_ramp(dataset):
    """Fronts of the pistons with the longest ramp."""
    return dataset.sel(ramp=dataset["ramp"].max())


def _over_expected(dataset, name, law):
    case = dataset.sel(law=law)
    expected = float(case[f"{name}_expected"])
    return Measured(float(case[name]) / expected, float(case[f"{name}_error"]) / expected)
