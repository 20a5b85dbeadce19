"""Potentials by name, with their parameters in order."""

import numpy as np

from granular_fronts.model.potentials import Potential, make_potential


def hertz(alpha, stiffness=1.0):
    return make_potential("hertz", alpha=alpha, stiffness=stiffness)


def toda(strength=1.0, rate=1.0):
    return make_potential("toda", strength=strength, rate=rate)


def fpu(quadratic=1.0, cubic=0.0, quartic=0.0):
    return make_potential("fpu", quadratic=quadratic, cubic=cubic, quartic=quartic)


def morse(depth=1.0, rate=1.0):
    return make_potential("morse", depth=depth, rate=rate)


def lennard_jones(depth=1.0, distance=1.0):
    return make_potential("lennard_jones", depth=depth, distance=distance)


NO_DISSIPATION = make_potential("linear", gamma=0.0)


def cosh():
    """A user's own potential, another one at each call."""
    functions = (lambda r: np.cosh(r) - 1.0, np.sinh, np.cosh, np.sinh)
    return Potential(*functions, interval=(-3.0, 3.0), name="cosh")
