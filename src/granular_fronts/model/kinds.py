r"""Named potentials of a contact: one function and one entry for each kind.

A potential of a named kind is :math:`a\,\varphi(r; p)`: a factor, which the configuration calls
stiffness, strength, depth or γ, and a shape φ with parameters p.  One function ``shape(r, order,
p)`` gives φ, φ', φ'' and φ''' for the orders 0 to 3.  It uses arithmetic, the functions below, and
functions of numpy that take numbers as well as arrays, such as `cosh` and `maximum`.  Theory
applies it to arrays; `model.passes` compiles it for single numbers, so that chains and exact fronts
have the same law.

A further kind needs its function and its entry in `ELASTIC` here, and nothing elsewhere.  Then
configuration, scenes, exact fronts, jump conditions, collisions and campaigns know it.  All shapes
with a minimum have it at r = 0, where the chain is at rest.
"""

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np


def exponential(x):
    """Return e^x, for which `model.passes` compiles vector code."""
    return np.exp(x)


def exponential_less_one(x):
    """Return e^x − 1 without cancellation, for which `model.passes` compiles vector code."""
    return np.expm1(x)


def hertz(r, order, p):
    """Return (−r)₊^(α+1)/(α + 1), p = (α,); at r = 0 the limit of the compressed side."""
    coefficient, exponent = hertz_power(order, p[0])
    if coefficient == 0.0:
        return np.zeros_like(r)
    return np.where(r <= 0.0, coefficient * np.maximum(-r, 0.0) ** exponent, 0.0)


def hertz_power(order, alpha):
    """Return the coefficient and exponent of (−r)₊ in the derivatives of `hertz`."""
    if order == 0:
        return 1.0 / (alpha + 1.0), alpha + 1.0
    if order == 1:
        return -1.0, alpha
    if order == 2:
        return alpha, alpha - 1.0
    return -alpha * (alpha - 1.0), alpha - 2.0


def quadratic(r, order, p):
    """Return r²/2, p = ()."""
    if order == 0:
        return 0.5 * r * r
    if order == 1:
        return 1.0 * r
    return 0.0 * r + (1.0 if order == 2 else 0.0)


def fpu(r, order, p):
    """Return κr²/2 + ar³/3 + br⁴/4, p = (κ, a, b): Fermi, Pasta, Ulam; α has b = 0, β has a = 0."""
    kappa, a, b = p
    if order == 0:
        return r * r * (kappa / 2.0 + r * (a / 3.0 + r * (b / 4.0)))
    if order == 1:
        return r * (kappa + r * (a + r * b))
    if order == 2:
        return kappa + r * (2.0 * a + r * (3.0 * b))
    return 2.0 * a + r * (6.0 * b)


def toda(r, order, p):
    """Return (e^(−br) + br − 1)/b, p = (b,), stiffer in compression."""
    rate = p[0]
    if order == 0:
        return (exponential_less_one(-rate * r) + rate * r) / rate
    if order == 1:
        return -exponential_less_one(-rate * r)
    if order == 2:
        return rate * exponential(-rate * r)
    return -(rate**2) * exponential(-rate * r)


def morse(r, order, p):
    """Return (1 − e^(−br))², p = (b,), a well of depth 1."""
    rate = p[0]
    decay, less_one = exponential(-rate * r), exponential_less_one(-rate * r)
    if order == 0:
        return less_one * less_one
    if order == 1:
        return -2.0 * rate * decay * less_one
    if order == 2:
        return 2.0 * rate**2 * decay * (2.0 * decay - 1.0)
    return 2.0 * rate**3 * decay * (1.0 - 4.0 * decay)


def lennard_jones(r, order, p):
    """Return (s⁻⁶ − 1)², s = 1 + r/d, p = (d,): s⁻¹² − 2s⁻⁶ raised to 0 at its minimum r = 0.

    It holds for r > −d and is infinite elsewhere.
    """
    distance = p[0]
    x = r / distance
    s = np.maximum(1.0 + x, 0.0)
    six = (s * s * s) * (s * s * s)
    # s⁻⁶ − 1, by the factor s − 1 = x of 1 − s⁶: nothing cancels.
    less_one = -x * (1.0 + s * (1.0 + s * (1.0 + s * (1.0 + s * (1.0 + s))))) / six
    if order == 0:
        return less_one * less_one
    if order == 1:
        return -12.0 / distance * less_one / (six * s)
    if order == 2:
        return 12.0 / distance**2 * (13.0 / six - 7.0) / (six * s * s)
    return -12.0 / distance**3 * (182.0 / six - 56.0) / (six * s * s * s)


class Parameter(NamedTuple):
    """A number that a kind has: its meaning for messages, and its limits, if any.

    Without a default it must be given.
    """

    meaning: str
    default: float | None = 1.0
    above: float | None = 0.0
    least: float | None = None


class Kind(NamedTuple):
    """A potential by name, factor × shape.

    `title` is for messages.  `shape` is a function ``shape(r, order, p)``, `parameters` are its own
    in the order of p.  `factor` multiplies it (None for 1).  `kinks` are the strains at which it is
    not smooth; chains locate their passages.  `domain` makes of p the open interval of r where it
    holds.
    """

    title: str
    shape: Callable
    parameters: Mapping[str, Parameter]
    factor: str | None = None
    kinks: tuple[float, ...] = ()
    domain: Callable = lambda p: (-math.inf, math.inf)


DAMPING = Parameter("strength γ of the viscous force", None, None, 0.0)

ELASTIC = {
    "hertz": Kind(
        "Hertz",
        hertz,
        {"alpha": Parameter("exponent α of the force", None), "stiffness": Parameter("k")},
        factor="stiffness",
        kinks=(0.0,),
    ),
    "toda": Kind(
        "Toda",
        toda,
        {"strength": Parameter("a"), "rate": Parameter("b")},
        factor="strength",
    ),
    "fpu": Kind(
        "FPU",
        fpu,
        {
            "quadratic": Parameter("κ", 1.0, None),
            "cubic": Parameter("a", 0.0, None),
            "quartic": Parameter("b", 0.0, None),
        },
    ),
    "morse": Kind(
        "Morse",
        morse,
        {"depth": Parameter("depth D of the well"), "rate": Parameter("b")},
        factor="depth",
    ),
    "lennard_jones": Kind(
        "Lennard-Jones",
        lennard_jones,
        {
            "depth": Parameter("depth D of the well"),
            "distance": Parameter("distance d of the particles at rest"),
        },
        factor="depth",
        domain=lambda p: (-p[0], math.inf),
    ),
}
"""Elastic potentials V by name; a viscous potential W may be any of them too."""

VISCOUS = {
    "power": Kind(
        "viscous power",
        hertz,
        {"beta": Parameter("exponent β of the viscous force", None), "gamma": DAMPING},
        factor="gamma",
        kinks=(0.0,),
    ),
    "linear": Kind("linear dashpot", quadratic, {"gamma": DAMPING}, factor="gamma"),
}
"""Viscous potentials W by name that do not depend on V."""

KINDS = ELASTIC | VISCOUS
