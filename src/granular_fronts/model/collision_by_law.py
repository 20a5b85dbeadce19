r"""Collision of two equal beads by any law that repels in compression.

Two beads of mass 1 meet with the relative velocity :math:`v_0`.  With :math:`F(u) = -V'(-u)` and
:math:`G(u) = -W'(-u)` their compression obeys

.. math:: \ddot u = -2\,\bigl(F(u) + \tfrac{d}{dt}G(u)\bigr), \qquad u(0) = 0,\quad
    \dot u(0) = v_0 .

As for powers (see `model.collision`), :math:`p = \dot u + 2G` falls, :math:`\dot p = -2F`, and with
:math:`p = \rho\cos\theta`, :math:`4V(-u) = \rho^2\sin^2\theta`

.. math::

    \theta' = 2 - g\cos\theta, \qquad (\ln\rho)' = -g\sin\theta, \qquad
    g = \frac{4G(u)}{\rho},

from :math:`\rho = v_0`, θ = 0 to θ = π, where the beads part: :math:`e = \rho(\pi)/v_0`, which
depends on the velocity.  A compressed contact is assumed to repel, :math:`F > 0` for :math:`u > 0`.

The equations are integrated by LSODA, since strong damping makes them stiff.
"""

import functools
import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import LSODA
from scipy.optimize import brentq

from granular_fronts.arguments import scalar
from granular_fronts.errors import InputError
from granular_fronts.model import kinds
from granular_fronts.model.collision import ACCURACY, log_restitution_by, restitution
from granular_fronts.model.laws import Law, make_law

NOTHING_LEFT = 1.0e-6
"""Part of v₀ below which beads of any law count as stuck together."""

ROUNDING_OF_ANY_LAW = 1.0e-11
"""What the rounding of V(−u) for small u lets through."""

LEAST_SINE, LEAST_ENERGY = 1.0e-9, 1.0e-300
"""Below them nothing is dissipated, and no logarithm is taken."""

MOST_ITERATIONS = 1000

SAMPLES = 64
"""Compressions at which a law is checked to repel."""


class Collision(NamedTuple):
    """What is left of the relative velocity of two beads.

    Attributes
    ----------
    restitution : float
        e, from 1 (elastic) to 0 (the beads do not part).
    error : float
        Estimate of its absolute error.
    """

    restitution: float
    error: float


def collide(law: Law | Mapping[str, Any], velocity: float = 1.0) -> Collision:
    """Collision of two equal beads of mass 1 by any law that repels in compression.

    Parameters
    ----------
    law : Law or Mapping
        A law, or the mapping of which `granular_fronts.make_law` makes one.
    velocity : float, optional
        Relative velocity v₀ of the impact, above 0; the beads begin to touch at r = 0.

    Returns
    -------
    Collision

    Raises
    ------
    InputError
        If an argument is impossible, or if the contact does not repel or not stop the beads.

    Examples
    --------
    >>> law = {"elastic": {"kind": "fpu"}, "viscous": {"kind": "linear", "gamma": 0.1}}
    >>> round(collide(law).restitution, 6)  # exp(−πζ/(1 − ζ²)^½) with ζ = γ/2^½
    0.800354
    """
    law = make_law(law)
    velocity = scalar("velocity", velocity, above=0.0, advice="give the velocity of the impact")
    shapes = {law.elastic.shape} | ({law.viscous.shape} if law.viscous.factor else set())
    if shapes == {kinds.hertz}:
        return _collide_powers(law, velocity)
    largest = _largest_compression(law, velocity)
    damping, least = _damping_of(law, velocity, largest), math.log(NOTHING_LEFT)
    found, finer = (
        math.exp(log_restitution_by(damping, functools.partial(LSODA, **tolerances), least))
        for tolerances in ({"rtol": 1.0e-10, "atol": 1.0e-12}, {"rtol": 1.0e-11, "atol": 1.0e-13})
    )
    if finer == 0.0:
        return Collision(0.0, NOTHING_LEFT)
    return Collision(finer, abs(finer - found) + ROUNDING_OF_ANY_LAW)


def _collide_powers(law, velocity):
    """The collision by the exponents, in units in which velocity and stiffness are 1."""
    (alpha,), stiffness = law.elastic.parameters, law.elastic.factor
    if law.viscous.factor == 0.0:
        return Collision(1.0, 0.0)
    (beta,) = law.viscous.parameters
    time = (velocity ** (1.0 - alpha) / stiffness) ** (1.0 / (alpha + 1.0))
    gamma = law.viscous.factor * velocity ** (beta - 1.0) * time**beta
    return Collision(restitution(gamma, alpha, beta), ACCURACY)


def _largest_compression(law, velocity):
    """The compression u with 4V(−u) = v₀², which is not exceeded."""
    energy, low = 0.25 * velocity**2, law.domain[0]
    rest = float(law.elastic.value(0.0))

    def excess(u):
        return float(law.elastic.value(-u)) - rest - energy

    u = 1.0
    while u > 0.0 and not (-u > low and excess(u) < 0.0):
        u *= 0.5
    while -2.0 * u > low and excess(2.0 * u) < 0.0:
        u *= 2.0
    far = min(2.0 * u, -low)
    compressions = far * np.arange(1.0, SAMPLES) / SAMPLES
    if not (law.elastic.first(-compressions) < 0.0).all():
        raise InputError(
            f"The contact of {law.elastic.name} does not repel everywhere between the strains "
            f"{-far:.6g} and 0: give a law whose V' is negative in compression."
        )
    if not excess(far) >= 0.0:
        raise InputError(
            f"velocity is {velocity:g}, and {law.elastic.name} stops the beads at no strain above "
            f"{low:g}, where it ends: give a smaller velocity, or a law that holds farther."
        )
    return brentq(excess, u, far, xtol=1.0e-18 * far, rtol=1.0e-15)


def _damping_of(law, velocity, largest):
    """The function g(ln(ρ/v₀), sin θ) of a law."""
    rest, no_slope = float(law.elastic.value(0.0)), float(law.viscous.first(0.0))
    limits = math.log(largest) - 50.0, math.log(1.01 * largest)

    def excess(log_u, log_energy):
        energy = float(law.elastic.value(-math.exp(log_u))) - rest
        return math.log(max(energy, LEAST_ENERGY)) - log_energy

    def damping(log_radius, sine):
        if sine < LEAST_SINE:
            return 0.0
        radius = velocity * math.exp(log_radius)
        # A power of u is a straight line in logarithms, of which the root is found at once.
        log_energy = 2.0 * math.log(0.5 * radius * sine)
        u = math.exp(brentq(excess, *limits, (log_energy,), 1.0e-14, 1.0e-14, MOST_ITERATIONS))
        return 4.0 * (no_slope - float(law.viscous.first(-u))) / radius

    return damping
