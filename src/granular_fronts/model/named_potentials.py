"""First derivatives of potentials by name, for one strain, that `chain.any_law` compiles."""

import math


def hertz_slope(alpha, stiffness=1.0):
    """V'(r) = −k(−r)₊^α, for one r."""

    def slope(r):
        return -stiffness * (-r) ** alpha if r < 0.0 else 0.0

    return slope


def fpu_slope(quadratic=1.0, cubic=0.0, quartic=0.0):
    """V'(r) = κr + ar² + br³, for one r."""

    def slope(r):
        return r * (quadratic + r * (cubic + r * quartic))

    return slope


def toda_slope(strength=1.0, rate=1.0):
    """V'(r) = a(1 − e^(−br)), for one r."""

    def slope(r):
        return -strength * math.expm1(-rate * r)

    return slope


SLOPES = {"hertz": hertz_slope, "fpu": fpu_slope, "toda": toda_slope}


def make_slope(description):
    """Its first derivative, for one strain, ready to be compiled."""
    return SLOPES[description["kind"]](**_parameters(description))


def _parameters(description):
    return {name: float(value) for name, value in description.items() if name != "kind"}
