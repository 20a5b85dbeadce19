"""Potentials by name, with their parameters in order."""

import mpmath as mp
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


READY = {
    "hertz 3/2": (hertz(1.5, 2.0), lambda r: 2 * (-r) ** 2.5 / 2.5 if r < 0 else 0),
    "hertz 1/2": (hertz(0.5), lambda r: (-r) ** 1.5 / 1.5 if r < 0 else 0),
    "hertz 1": (hertz(1.0), lambda r: r**2 / 2 if r < 0 else 0),
    "fpu": (fpu(0.5, -2.0, 3.0), lambda r: r**2 / 4 - 2 * r**3 / 3 + 3 * r**4 / 4),
    "toda": (toda(2.0, 3.0), lambda r: mp.mpf(2) / 3 * (mp.exp(-3 * r) + 3 * r - 1)),
    "morse": (morse(2.0, 1.5), lambda r: 2 * (1 - mp.exp(-1.5 * r)) ** 2),
    "lennard-jones": (
        lennard_jones(0.5, 2.0),
        lambda r: mp.mpf(0.5) * ((1 + r / 2) ** -12 - 2 * (1 + r / 2) ** -6 + 1),
    ),
    "power": (
        make_potential("power", beta=2.5, gamma=0.4),
        lambda r: 0.4 * (-r) ** 3.5 / 3.5 if r < 0 else 0,
    ),
    "linear": (make_potential("linear", gamma=0.3), lambda r: 0.3 * r**2 / 2),
}
"""A potential of each kind, with its V for numbers of mpmath."""
