r"""The logarithmic KdV–Burgers equation, its coefficients, and the plane of its stationary waves.

James (2021), section 5.  For β = α near 1 and damping of the order of :math:`(\alpha - 1)^{1/2}`
the ansatz (52),

.. math::

    u_n(t) = \delta\, y(s, \tau)^{1/\alpha}, \qquad s = 2\sqrt 3\,\varepsilon (n - ct), \qquad
    \tau = \sqrt 3\,\varepsilon^3 c t, \qquad \varepsilon = (1 - 1/\alpha)^{1/2},

with :math:`c = \delta^{(\alpha-1)/2}`, turns the chain through the expansion (53) into (55), with
the one parameter (54):

.. math::

    \partial_\tau y + \partial_s (y \ln y) + \partial_s^3 y = \mu\, \partial_s^2 y, \qquad
    \mu = 2\sqrt 3\, \gamma c\, (1 - 1/\alpha)^{-1/2} .

Stationary waves obey :math:`y'' - \mu y' + W'(y) = 0` (56), a particle with negative damping in
:math:`W(y) = \tfrac12 y^2 (\ln|y| - \tfrac12)`, or the planar system (57): :math:`y' = z`,
:math:`z' = \mu z - y \ln|y|`.  Its energy grows: :math:`(z^2/2 + W)' = \mu z^2`.  A front is the
heteroclinic orbit from (1, 0) at :math:`s \to -\infty` to (0, 0) at :math:`s \to +\infty`.

Near (1, 0) solutions behave as :math:`e^{\lambda s}`, :math:`\lambda^2 - \mu\lambda + 1 = 0`: an
unstable focus for :math:`\mu < 2`, an unstable node for :math:`\mu \ge 2`.  The origin is a saddle
of infinite strength: its logarithm is not Lipschitz, and orbits reach it faster than any
exponential.

Variables.  In :math:`p = -\ln y`, :math:`v = p' = -z/y` and
:math:`e = 2(z^2/2 + W)/y^2 = v^2 - p - \tfrac12` the logarithm is gone:

.. math::

    p' = v, \qquad v' = v^2 + \mu v - p = \tfrac12 + e + \mu v, \qquad e' = 2v\,(e + \mu v) .

Everything is quadratic.  Without damping e = 0 on the orbit and v grows linearly, which is the
Gaussian :math:`y = \exp(\tfrac12 - s^2/4)` of Remark 8; with weak damping e is small.  It keeps its
relative accuracy, which the difference v² − p − ½ would lose.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.arguments import scalar
from granular_fronts.errors import InputError
from granular_fronts.model.amplitude_scaling import SMALLEST_DAMPING

CRITICAL_DAMPING = 2.0
"""Value of μ at which the focus (1, 0) becomes a node."""


class Amplitude(NamedTuple):
    """What ties the amplitude equation to a chain."""

    mu: float  # damping μ of (54)
    speed: float  # speed c of the front, in beads per unit of time
    s_per_bead: float  # 2√3 ε: the change of s from bead to bead
    tau_per_time: float  # √3 ε³ c: the change of τ per unit of time


def amplitude_of_chain(alpha, gamma, delta=1.0):
    """Return parameter and scales of the amplitude equation for a chain, James (2021), (52)–(54).

    An InputError unless α = β > 1, γ ≥ 0 and δ > 0.
    """
    alpha = scalar("alpha", alpha, above=1.0, advice="fronts are compressive there")
    gamma = scalar("gamma", gamma, least=0.0)
    delta = scalar("delta", delta, above=0.0)
    epsilon = math.sqrt((alpha - 1.0) / alpha)
    speed = delta ** ((alpha - 1.0) / 2.0)
    return Amplitude(
        mu=2.0 * math.sqrt(3.0) * gamma * speed / epsilon,
        speed=speed,
        s_per_bead=2.0 * math.sqrt(3.0) * epsilon,
        tau_per_time=math.sqrt(3.0) * epsilon**3 * speed,
    )


def check_mu(mu):
    """Return damping μ as a float; an InputError unless it is 0 or 1e-280 to 1e280."""
    mu = scalar("mu", mu, least=0.0, most=1.0 / SMALLEST_DAMPING, advice="contacts dissipate")
    if 0.0 < mu < SMALLEST_DAMPING:
        raise InputError(
            f"mu is {mu}, but must be 0, or at least {SMALLEST_DAMPING} for the energy of the "
            "orbit to be a normal double: give such a number."
        )
    return mu


def potential(y):
    """Return the double-well potential W(y) = (y²/2)(ln|y| − ½) of (56), zero at the origin."""
    y = np.asarray(y, dtype=float)
    safe = np.where(y == 0.0, 1.0, np.abs(y))
    return 0.5 * y**2 * (np.log(safe) - 0.5)


def planar_system(s, state, mu):
    """Return the right-hand side of (57), y' and z' of a state (y, z), for orbits of any sign."""
    y, z = state
    safe = np.where(y == 0.0, 1.0, np.abs(y))
    return np.array([z, mu * z - y * np.log(safe)])


def linear_rates(mu):
    """Return both roots λ of λ² − μλ + 1 = 0, the growth rates at (1, 0), free of cancellation.

    The slow and the fast one for μ ≥ 2; otherwise a conjugate pair, negative imaginary part
    first.
    """
    mu = check_mu(mu)
    if mu < CRITICAL_DAMPING:
        frequency = math.sqrt((1.0 - 0.5 * mu) * (1.0 + 0.5 * mu))
        return complex(0.5 * mu, -frequency), complex(0.5 * mu, frequency)
    half = 0.5 * mu
    fast = half + math.sqrt(half - 1.0) * math.sqrt(half + 1.0)
    return complex(1.0 / fast), complex(fast)
