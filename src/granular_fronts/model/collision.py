r"""Collision of two beads and its coefficient of restitution; James (2021), Remark 6.

Two equal beads meet with the relative velocity :math:`v_0`, which is the reference velocity of
(27)-(29).  Their compression :math:`u = x_1 - x_2` obeys, from (28),

.. math::

    \ddot u = -2\,\bigl(u_+^\alpha + \gamma\tfrac{d}{dt}u_+^\beta\bigr), \qquad u(0) = 0,\quad
    \dot u(0) = 1,

until u returns to zero, with the velocity :math:`-e`.  The law is taken as it is written.  Shortly
before they part the beads attract each other, since the viscous force is then the larger one.  (A
contact that ends where its force vanishes loses less, but belongs to another law.)

One exponent.  With :math:`p = \dot u + 2\gamma u_+^\beta`, twice the w of (31), :math:`\dot p =
-2u_+^\alpha`, so that p falls from 1 to :math:`-e`; with :math:`Y = 4u_+^{\alpha+1}/(\alpha+1)`

.. math::

    \frac{dY}{dp} = -2p + G\,Y^\nu, \qquad \nu = \frac{\beta}{\alpha+1}, \quad
    G = 4\gamma\Bigl(\frac{\alpha+1}{4}\Bigr)^{\nu},

from :math:`Y(1) = 0` to :math:`Y(-e) = 0`: e depends only on ν and G.  In polar coordinates
:math:`p = \rho\cos\theta`, :math:`\sqrt Y = \rho\sin\theta` both ends are known, θ = 0 and π, and

.. math::

    \theta' = 2 - g\sin^{2\nu}\theta\,\cos\theta, \qquad
    (\ln\rho)' = -g\sin^{2\nu+1}\theta, \qquad g = G\rho^{2\nu-1}, \qquad e = \rho(\theta = \pi).

- ν = 1/2, that is β = (α + 1)/2, is a damped linear oscillator of damping ratio ζ = G/4:
  :math:`e = \exp(-\pi\zeta/\sqrt{1-\zeta^2})`, and the contact never ends (e = 0) for ζ ≥ 1.
- ν < 1/2, such as the linear dashpot with α > 1: g grows as the motion dies, and once θ' ≤ 0 the
  beads creep apart for ever; e = 0 above a finite γ.
- ν > 1/2: e > 0 for every γ.  For large G, Y follows the slow curve :math:`(2p/G)^{1/\nu}` and
  forgets its start; since :math:`p \to \lambda p,\, Y \to \lambda^2 Y,\, G \to \lambda^{1-2\nu} G`
  is a symmetry, :math:`e = C(\nu)\,G^{-1/(2\nu-1)}` there, up to exponentially small terms.
- Weak damping: :math:`\ln e \approx -\tfrac12 G\,\mathrm B(\nu+1, \tfrac12)`, hence

.. math::

    \gamma \approx \frac{1-e}{2\,((\alpha+1)/4)^{\nu}\,\mathrm B(\nu+1, \tfrac12)},

0.4380245 (1 − e) for α = β = 3/2, which the paper prints as 0.438.

The equations are integrated by DOP853 to a relative error of a few 1e-14.  The reduction to one
exponent and its limits are ours.
"""

import functools
import math

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq
from scipy.special import beta as euler_beta

from granular_fronts.arguments import double_precision, scalar

TOLERANCE = 3.0e-14  # Relative, just above what DOP853 can keep.
ABSOLUTE_TOLERANCE = 1.0e-20  # Times G where it is small, so that the relative one rules.
WEAK = 1.0e-17  # G below which the expansion for weak damping is exact.
MOST_NU = 20.0  # Beyond it the damping sets in too late for the integration to see.
LARGEST_STEP = 0.1  # In θ.
FORGETTING = 45.0  # Λ at which the start is forgotten on the slow curve: exp(−45) is rounding.
LEAST_LOGARITHM = -745.0  # Of the smallest positive number in double precision.


def restitution(gamma: float, alpha: float = 1.5, beta: float | None = None) -> float:
    """Return the coefficient of restitution e of two equal beads, to an error below 1e-12.

    Parameters
    ----------
    gamma : float
        Dimensionless damping (29) for v₀ = relative velocity of the impact; 0 or more.
    alpha : float, optional
        Exponent of the elastic force, above 0.
    beta : float, optional
        Exponent of the viscous force, 1 to 20 (α + 1); α by default.

    Returns
    -------
    float
        e, from 1 (elastic) to 0 (the beads do not part).

    Raises
    ------
    InputError
        If a parameter is impossible.

    Examples
    --------
    >>> round(gf.restitution(gamma=0.1), 6)
    0.799393
    """
    nu = _reduced_exponent(alpha, beta)
    gamma = scalar("gamma", gamma, least=0.0, advice="give a damping")
    with double_precision("The damping of this collision", "bring beta closer to alpha"):
        strength = _strength(gamma, alpha, nu)
        if strength == math.inf:
            raise OverflowError
        return math.exp(log_restitution(nu, strength))


def damping_for_restitution(e: float, alpha: float = 1.5, beta: float | None = None) -> float:
    """Damping γ at which two equal beads have the coefficient of restitution e.

    Parameters
    ----------
    e : float
        Above 0 and at most 1, which is elastic.
    alpha : float, optional
        Exponent of the elastic force, above 0.
    beta : float, optional
        Exponent of the viscous force, 1 to 20 (α + 1); α by default.

    Returns
    -------
    float
        γ (29) for v₀ = relative velocity of the impact, to a relative error of about 1e-12.

    Raises
    ------
    InputError
        If a parameter is impossible.

    Examples
    --------
    >>> round(gf.damping_for_restitution(0.9), 6)
    0.046609
    """
    nu = _reduced_exponent(alpha, beta)
    e = scalar("e", e, above=0.0, most=1.0, advice="give a coefficient of restitution")
    if e == 1.0:
        return 0.0
    wanted = math.log(e)

    def excess(log_strength):
        found = max(log_restitution(nu, math.exp(log_strength)), 10.0 * LEAST_LOGARITHM)
        return math.log(found / wanted)

    low = high = math.log(-2.0 * wanted / euler_beta(nu + 1.0, 0.5))
    with double_precision("The damping of this collision", "give a larger e"):
        while excess(low) > 0.0:
            low -= 1.0
        while excess(high) < 0.0:
            high += 1.0
        strength = math.exp(brentq(excess, low, high, xtol=1.0e-14, rtol=1.0e-14))
        return strength / _strength(1.0, alpha, nu)


def weak_damping_slope(alpha=1.5, beta=None):
    """Return the limit of γ/(1 − e) as e → 1; 0.4380245 for α = β = 3/2."""
    nu = _reduced_exponent(alpha, beta)
    return 2.0 / (_strength(1.0, alpha, nu) * float(euler_beta(nu + 1.0, 0.5)))


def _reduced_exponent(alpha, beta=None):
    """Return ν = β/(α + 1), β = α by default."""
    alpha = scalar("alpha", alpha, above=0.0, advice="give an exponent")
    beta = scalar(
        "beta",
        alpha if beta is None else beta,
        least=1.0,
        most=MOST_NU * (alpha + 1.0),
        advice="give an exponent",
    )
    return beta / (alpha + 1.0)


def log_restitution(nu, strength, largest_step=LARGEST_STEP):
    """Return ln e of the reduced collision for ν above 0 and G; −∞ if the beads do not part.

    A smaller bound on the integrator's steps in θ checks the result.
    """
    if strength < WEAK:
        return -0.5 * strength * float(euler_beta(nu + 1.0, 0.5))
    if nu == 0.5:
        ratio = 0.25 * strength
        return -math.pi * ratio / math.sqrt(1.0 - ratio**2) if ratio < 1.0 else -math.inf
    if nu < 0.5 and strength * _steepest(nu) >= 2.0:
        return -math.inf
    slow = _slow_strength(nu) if nu > 0.5 else math.inf
    if strength > slow:
        power_law = math.log(slow / strength) / (2.0 * nu - 1.0)
        return _integrated(nu, slow, largest_step) + power_law
    return _integrated(nu, strength, largest_step)


# Remembers the one integration that all strong dampings lead to.
@functools.lru_cache(maxsize=32)
def _integrated(nu, strength, largest_step):
    """Return the logarithm of e of the reduced collision by integration from its start."""

    def damping(log_radius, sine):
        return strength * math.exp((2.0 * nu - 1.0) * log_radius) * sine ** (2.0 * nu)

    method = functools.partial(
        DOP853,
        max_step=0.5 * largest_step,
        rtol=TOLERANCE,
        atol=ABSOLUTE_TOLERANCE * min(1.0, strength),
    )
    # Where a motion creeps the beads never part once θ' ≤ 0.
    theta, log_radius = _approach(damping, method, creeps=nu < 0.5)
    return _part(damping, theta, log_radius, method) if theta >= 0.5 * math.pi else -math.inf


def _steepest(nu):
    """Return max sin^(2ν)θ cos θ; for ν < 1/2 θ' = 0 below it if G times it is 2 or more."""
    return (2.0 * nu / (1.0 + 2.0 * nu)) ** nu / math.sqrt(1.0 + 2.0 * nu)


def _slow_strength(nu):
    """Return G above which the start is forgotten on the slow curve, for ν above 1/2."""
    # The neighbours of the curve approach it by exp(−Λ), Λ ≈ (ν 2^(1 − 1/ν) G^(1/ν) − 1)/(2 − 1/ν).
    # Near ν = 1/2 the curve is followed only where G clearly exceeds 4: hence 8 in place of 1.
    contraction = 8.0 + FORGETTING * (2.0 - 1.0 / nu)
    return (contraction / (nu * 2.0 ** (1.0 - 1.0 / nu))) ** nu


def _approach(damping, method, creeps):
    """Return θ and ln ρ just past θ = π/2, or where they stay for ever."""

    def slopes(_, state):
        theta, log_radius = state
        # A trial step may lead beyond θ = π.
        sine = max(math.sin(theta), 0.0)
        g = damping(log_radius, sine)
        return np.array([2.0 - g * math.cos(theta), -g * sine])

    solver = method(slopes, 0.0, [0.0, 0.0], math.inf)
    while solver.y[0] < 0.5 * math.pi:
        solver.step()
        if solver.y[1] < LEAST_LOGARITHM or (creeps and slopes(0.0, solver.y)[0] <= 0.0):
            break
    return solver.y


def _part(damping, theta, log_radius, method):
    """Return ln ρ at θ = π; from π/2 on θ grows at a rate above 2 and is the variable."""

    def slope(theta, log_radius):
        sine = max(math.sin(theta), 0.0)
        g = damping(log_radius[0], sine)
        return np.array([-g * sine / (2.0 - g * math.cos(theta))])

    solver = method(slope, theta, [log_radius], math.pi)
    while solver.status == "running":
        solver.step()
    return float(solver.y[0])


def _strength(gamma, alpha, nu):
    """Return G of the reduced collision."""
    return 4.0 * gamma * ((alpha + 1.0) / 4.0) ** nu
