r"""The exact profile of a front, by its advance–delay equation in convolution form.

A travelling front :math:`u_n(t) = u(\xi)`, ξ = n − ct, of the chain with damping exponent β
satisfies (from James 2021, eqs. (5) and (36); his section 6 shoots for it instead)

.. math::

    c^2 u'' = \Bigl(1 - \gamma c\,\frac{d}{d\xi}\Bigr)_{\!\beta}
              \bigl[P(\xi + 1) - 2P(\xi) + P(\xi - 1)\bigr],

where the derivative acts on :math:`Q = u_+^\beta` and the rest on :math:`P = u_+^\alpha`.
Integrated twice, with u → r ahead, it is an equation of the second kind,

.. math::

    c^2 (u - r) = \int_{-1}^{1} (1 - |s|)\,[P(\xi - s) - r^\alpha]\,ds
                + \gamma c \int_{-1}^{1} \operatorname{sgn}(s)\, Q(\xi - s)\,ds .

u → 1 behind; the limit ξ → −∞ gives :math:`c^2 = (1 - r^\alpha)/(1 - r)`, eq. (14), whatever β and
γ.  The kernel contains no difference of neighbouring values, so that round-off stays what it is.

Discretisation.  u is sought at the points of a uniform grid, 1 and r beyond the window, and the
integrals are replaced by the rules of `quadrature` with local polynomials through 20 points.  The
unknowns are these values and c, the conditions all equations and u(0) = (1 + r)/2 (`newton`).  The
weights sum to one exactly as the kernel does, so that the discrete equations have the same c: that
c − c₀ is at round-off says that the window is long enough, not that the grid is fine enough.

Two grids.  The equation is solved on a coarse grid, from the front of the long-wave equation, and
then on a fine one, whose spacing follows from the difference of two quadrature rules on the coarse
solution.  A third grid, finer, with another order and a longer window, gives the error estimate.
"""

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.long_wave_front import continuum_front
from granular_fronts.fronts.profile.newton import Law
from granular_fronts.fronts.profile.window import choose_window, coarse_spacing, rational
from granular_fronts.numerics.interpolation import interpolate_all
from granular_fronts.numerics.quadrature import kernel_weights

COARSE_ORDER, ORDER, OTHER_ORDER = 8, 20, 16
REFINED_ORDER = 22
STEPS = 60

# Where the direct start fails: by how much stronger damping is tried, and steps back from there.
STRONGER = (2.0, 4.0, 8.0, 16.0, 32.0)
LONGEST_RATIO, SHORTEST_RATIO = 2.0, 1.005
TOLERANCE, COARSE_TOLERANCE = 1e-15, 1e-9

# Largest difference of the two rules on the final grid, and the power of h it is taken to follow.
DEFECT = 2e-13
ASSUMED_POWER = 12
AT_REST = 5e-14

# A front on the coarse grid serves as a start only, and need not show the end of its tail.
COARSE_SHARE = 0.6
ADJUSTMENTS = 8
MOST_POINTS = 800_000

# Longest window, in sites, in which fronts have been found.
MOST_SITES = 1e6

SPEED_TOLERANCE = 1e-12
BELOW = 1e-12
RESIDUAL_TOLERANCE = 1e-13


class Profile(NamedTuple):
    """A front on its grid.

    Attributes
    ----------
    law : newton.Law
    spacing : Fraction
        Distance of the points, in sites.
    middle : int
        Index of ξ = 0.
    u : ndarray, shape (points,)
    speed : float
    residuals : ndarray
        Largest residual before each Newton step and after the last, grid after grid.
    reason : str
        Why this is not a front; empty if it is one.
    """

    law: Law
    spacing: Fraction
    middle: int
    u: np.ndarray
    speed: float
    residuals: np.ndarray
    reason: str = ""

    @property
    def xi(self):
        """Coordinates of the points, shape (points,)."""
        return float(self.spacing) * np.arange(-self.middle, self.u.size - self.middle)

    @property
    def half(self):
        """Value at ξ = 0."""
        return 0.5 * (1.0 + self.law.ahead)

    @property
    def speed_defect(self):
        """Relative deviation of c from its exact value."""
        return self.speed / self.law.speed - 1.0

    def evaluate(self, xi):
        """Values of u at any positions, 1-D."""
        return interpolate_all(self.u, self.positions(xi), 1.0, self.law.ahead)

    def positions(self, xi):
        """Positions in units of the spacing, 0 at the first point."""
        return xi / float(self.spacing) + self.middle


def make_law(alpha, gamma, beta, ahead=0.0):
    """A law with its exact speed, eq. (14)."""
    squared = -math.expm1(alpha * math.log(ahead)) / (1.0 - ahead) if ahead > 0.0 else 1.0
    return Law(float(alpha), float(beta), float(gamma), float(ahead), math.sqrt(squared))


def solve_profile(law):
    """The front of a law from nothing: a coarse grid, then a fine one.

    Parameters
    ----------
    law : newton.Law

    Returns
    -------
    Profile
        With a `reason` if it is not the front.
    """
    with np.errstate(all="ignore"):
        # A law beyond double precision has no length.
        window = choose_window(law)
    if not window.length <= MOST_SITES:
        taken = f"{window.length:.2g}" if np.isfinite(window.length) else "countless"
        return no_profile(
            law,
            f"the front and its tails take {taken} sites, but rounding hides fronts of more than "
            f"{MOST_SITES:.0e}: bring gamma closer to 1, alpha and right_state away from 1",
        )
    profile = solve_coarse(law, window.longer(COARSE_SHARE))
    if profile.reason:
        return profile
    spacing = expected_spacing(profile)
    for _ in range(ADJUSTMENTS):
        before = profile.residuals
        profile = solve_on_grid(law, window, spacing, ORDER, profile.evaluate)
        profile = profile._replace(residuals=np.concatenate([before, profile.residuals]))
        if profile.reason:
            return profile
        defect, stretch = quadrature_defect(profile), needed_stretch(profile)
        sharp = defect > DEFECT
        if not sharp and stretch == (1.0, 1.0):
            break
        window = window.longer(*stretch)
        if sharp:
            spacing = min(expected_spacing(profile), rational(0.8 * float(spacing)))
    if sharp:
        return profile._replace(
            reason=f"the quadrature still errs by {defect:.1e} at {1 / float(spacing):.4g} points "
            "per site: the front is too sharp for it"
        )
    return profile._replace(reason=reason_against(profile))


def no_profile(law, reason):
    """A record without a front, which was not looked for."""
    return Profile(law, Fraction(1), 0, np.empty(0), math.nan, np.empty(0), reason)


def refine(profile):
    """The same front on a finer grid, by another order, on a longer window."""
    window = choose_window(profile.law)
    behind = max(window.behind, float(profile.spacing) * profile.middle)
    ahead = max(window.ahead, float(profile.spacing) * (profile.u.size - profile.middle))
    spacing = rational(float(profile.spacing) / 1.4)
    return solve_on_grid(
        profile.law,
        window._replace(behind=1.1 * behind, ahead=1.1 * ahead),
        spacing,
        REFINED_ORDER,
        profile.evaluate,
    )


def solve_coarse(law, window):
    """The front on the coarse grid, from the long-wave front or else from stronger damping."""
    direct = _from_long_wave(law, window)
    if not direct.reason:
        return direct
    for factor in STRONGER:
        strong = law._replace(gamma=factor * law.gamma)
        known = _from_long_wave(strong, choose_window(strong))
        if not known.reason:
            return _walk(known, law, window)
    return direct


def _walk(known, law, window):
    """Follow the front to weaker damping, by steps as long as Newton's iteration allows."""
    ratio = LONGEST_RATIO
    while True:
        gamma = max(law.gamma, known.law.gamma / ratio)
        arrives = gamma == law.gamma
        next_law = law._replace(gamma=gamma)
        next_window = window if arrives else choose_window(next_law)
        attempt = solve_on_grid(
            next_law,
            next_window,
            coarse_spacing(next_law, next_window),
            COARSE_ORDER,
            known.evaluate,
            COARSE_TOLERANCE,
        )
        if not attempt.reason:
            known = attempt
        if (arrives and not attempt.reason) or ratio < SHORTEST_RATIO:
            return attempt
        ratio = math.sqrt(ratio) if attempt.reason else ratio


def _from_long_wave(law, window):
    """The front on the coarse grid, from the long-wave front of not too weak damping."""
    weakest = law.alpha / law.beta * math.sqrt((1.0 - 1.0 / law.alpha) / 3.0)
    known, values = continuum_front(law, max(law.gamma, weakest))
    return solve_on_grid(
        law,
        window,
        coarse_spacing(law, window),
        COARSE_ORDER,
        lambda xi: np.interp(xi, known, values),
        COARSE_TOLERANCE,
    )


def solve_on_grid(law, window, spacing, order, start, tolerance=TOLERANCE):
    """The front on one grid.

    Parameters
    ----------
    law : newton.Law
    window : window.Window
    spacing : Fraction
    order : int
        Points of the local polynomials.
    start : callable
        u at the given ξ, for Newton's iteration.
    tolerance : float, optional
        Change of u at which the iteration ends.

    Returns
    -------
    Profile
    """
    middle = math.ceil(window.behind / spacing)
    points = middle + 1 + math.ceil(window.ahead / spacing)
    if points > MOST_POINTS:
        return no_profile(law, f"the window would need {points} points, more than {MOST_POINTS}")
    weights = kernel_weights(spacing, order)
    profile = Profile(law, spacing, middle, np.empty(points), law.speed, np.empty(0))
    u = np.ascontiguousarray(start(profile.xi))
    u[middle] = profile.half
    speed, history = np.array([law.speed]), np.empty(STEPS + 1)
    step, status = newton.iterate(
        law,
        weights.hat,
        weights.jump,
        float(spacing),
        middle,
        profile.half,
        tolerance,
        u,
        speed,
        history,
    )
    profile = profile._replace(u=u, speed=float(speed[0]), residuals=history[: step + 1])
    if status == newton.SETTLED:
        return profile
    return profile._replace(
        reason=f"Newton's iteration does not settle, with a residual of {history[step]:.1e}"
    )


def reason_against(profile):
    """Why a solution of the equations is not the front sought, in words; empty if it may be."""
    residual = profile.residuals[-1]
    if residual > RESIDUAL_TOLERANCE * (1.0 + profile.law.gamma):
        return f"the residual is {residual:.1e}, above round-off"
    if abs(profile.speed_defect) > SPEED_TOLERANCE:
        return f"the speed is wrong by {profile.speed_defect:.1e}: this is not a front"
    if profile.u[profile.middle + 1 :].max() >= profile.half:
        return "u exceeds its value at xi = 0 ahead of it: another part of the wave is at xi = 0"
    if profile.u.min() < profile.law.ahead - BELOW:
        return f"u falls to {profile.u.min():.3g}, below the state ahead: this is another branch"
    if needed_stretch(profile) != (1.0, 1.0):
        return "the ends of the window are not at rest: the tail decays more slowly than expected"
    return ""


def needed_stretch(profile):
    """Factors by which the window is too short behind and ahead, 1.0 where it is not."""
    behind = np.abs(profile.u[: 4 + profile.u.size // 200] - 1.0).max()
    ahead = np.abs(profile.u[-4:] - profile.law.ahead).max()
    return (1.2 if behind > AT_REST else 1.0), (1.3 if ahead > AT_REST else 1.0)


def quadrature_defect(profile):
    """Largest difference of the right-hand sides by rules of orders 20 and 16."""
    fine, other = (kernel_weights(profile.spacing, order) for order in (ORDER, OTHER_ORDER))
    more = (fine.hat.size - other.hat.size) // 2
    hat, jump = fine.hat - np.pad(other.hat, more), fine.jump - np.pad(other.jump, more)
    return newton.largest_convolution(profile.law, hat, jump, profile.u)


def expected_spacing(coarse):
    """Spacing at which the defect is expected to be at round-off."""
    ratio = DEFECT / max(quadrature_defect(coarse), 1e-30)
    return rational(float(coarse.spacing) * min(max(ratio ** (1.0 / ASSUMED_POWER), 0.2), 2.0))
