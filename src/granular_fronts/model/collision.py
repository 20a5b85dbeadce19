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

Any law.  With :math:`F(u) = -V'(-u)` and :math:`G(u) = -W'(-u)` of two beads of mass 1,

.. math:: \ddot u = -2\,\bigl(F(u) + \tfrac{d}{dt}G(u)\bigr), \qquad u(0) = 0,\quad
    \dot u(0) = v_0 .

Again :math:`p = \dot u + 2G` falls, :math:`\dot p = -2F`, and with :math:`p = \rho\cos\theta`,
:math:`4V(-u) = \rho^2\sin^2\theta` the equations in θ hold with

.. math:: g = \frac{4G(u)}{\rho}, \qquad \theta' = 2 - g\cos\theta, \qquad
    (\ln\rho)' = -g\sin\theta,

from :math:`\rho = v_0`, θ = 0 to θ = π, where the beads part: :math:`e = \rho(\pi)/v_0`, which
depends on the velocity.  A compressed contact is assumed to repel, :math:`F > 0` for :math:`u > 0`.
LSODA integrates here, since strong damping makes the equations stiff.
"""

import functools
import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import DOP853, LSODA
from scipy.optimize import brentq
from scipy.special import beta as euler_beta

from granular_fronts.arguments import double_precision, scalar
from granular_fronts.errors import InputError
from granular_fronts.model import kinds
from granular_fronts.model.laws import Law, make_law

TOLERANCE = 3.0e-14  # Relative, just above what DOP853 can keep.
ABSOLUTE_TOLERANCE = 1.0e-20  # So small that the relative one rules.
LARGEST_STEP = 0.1  # In θ.
ACCURACY = 1.0e-12  # Error of the collisions of one exponent.
FORGETTING = 45.0  # Λ at which the start is forgotten on the slow curve: exp(−45) is rounding.
LEAST_LOGARITHM = -745.0  # Of the smallest positive number in double precision.
NOTHING_LEFT = 1.0e-6  # Part of v₀ below which beads of any law count as stuck together.
ROUNDING_OF_ANY_LAW = 1.0e-11  # What the rounding of V(−u) for small u lets through.
LEAST_SINE, LEAST_ENERGY = 1.0e-9, 1.0e-300  # Nothing is dissipated below them.
MOST_ITERATIONS = 1000
SAMPLES = 64  # Compressions at which a law is checked to repel.


def restitution(gamma: float, alpha: float = 1.5, beta: float | None = None) -> float:
    """Return the coefficient of restitution e of two equal beads, to an error below 1e-12.

    Parameters
    ----------
    gamma : float
        Dimensionless damping (29) for v₀ = relative velocity of the impact; 0 or more.
    alpha : float, optional
        Exponent of the elastic force, above 0.
    beta : float, optional
        Exponent of the viscous force, 1 or more; α by default.

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
        Exponent of the viscous force, 1 or more; α by default.

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
    beta = scalar("beta", alpha if beta is None else beta, least=1.0, advice="give an exponent")
    return beta / (alpha + 1.0)


def log_restitution(nu, strength, largest_step=LARGEST_STEP):
    """Return ln e of the reduced collision for ν above 0 and G; −∞ if the beads do not part.

    A smaller bound on the integrator's steps in θ checks the result.
    """
    if strength == 0.0:
        return 0.0
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
        DOP853, max_step=0.5 * largest_step, rtol=TOLERANCE, atol=ABSOLUTE_TOLERANCE
    )
    return _log_restitution_by(damping, method, LEAST_LOGARITHM, creeps=nu < 0.5)


def _log_restitution_by(damping, method, least, creeps=False):
    """Return ln e for a damping g(ln ρ, sin θ), by a solver of SciPy with its tolerances."""
    # Below `least` ln ρ counts as −∞; where a motion `creeps` the beads never part once θ' ≤ 0.
    theta, log_radius = _approach(damping, method, least, creeps)
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


def _approach(damping, method, least, creeps):
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
        if solver.y[1] < least or (creeps and slopes(0.0, solver.y)[0] <= 0.0):
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


# Any law.


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
    """Collide two equal beads of mass 1 by any law that repels in compression.

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
    >>> round(gf.collide(law).restitution, 6)  # exp(−πζ/(1 − ζ²)^½) with ζ = γ/2^½
    0.800354
    """
    law = make_law(law)
    velocity = scalar("velocity", velocity, above=0.0, advice="give the velocity of the impact")
    shapes = {law.elastic.shape} | ({law.viscous.shape} if law.viscous.factor else set())
    if shapes == {kinds.hertz}:
        return _collide_powers(law, velocity)
    largest = _largest_compression(law, velocity)
    damping, least = _damping_of(law, velocity, largest), math.log(NOTHING_LEFT)
    # Two tolerances of LSODA, a factor of 10 apart: their difference is the error.
    found, finer = (
        math.exp(_log_restitution_by(damping, functools.partial(LSODA, **tolerances), least))
        for tolerances in ({"rtol": 1.0e-10, "atol": 1.0e-12}, {"rtol": 1.0e-11, "atol": 1.0e-13})
    )
    if finer == 0.0:
        return Collision(0.0, NOTHING_LEFT)
    return Collision(finer, abs(finer - found) + ROUNDING_OF_ANY_LAW)


def _collide_powers(law, velocity):
    """Return the collision by the exponents, in units in which velocity and stiffness are 1."""
    (alpha,), stiffness = law.elastic.parameters, law.elastic.factor
    if law.viscous.factor == 0.0:
        return Collision(1.0, 0.0)
    (beta,) = law.viscous.parameters
    time = (velocity ** (1.0 - alpha) / stiffness) ** (1.0 / (alpha + 1.0))
    gamma = law.viscous.factor * velocity ** (beta - 1.0) * time**beta
    return Collision(restitution(gamma, alpha, beta), ACCURACY)


def _largest_compression(law, velocity):
    """Return the compression u with 4V(−u) = v₀², which is not exceeded."""
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
    """Return the function g(ln(ρ/v₀), sin θ) of a law."""
    rest, no_slope = float(law.elastic.value(0.0)), float(law.viscous.first(0.0))
    # From exp(−50) of the largest compression, where nothing is felt, to a rounding beyond it.
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
