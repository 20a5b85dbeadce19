r"""The exact profile of a front, from nothing: windows, grids and starts.

Discretisation.  s of `equation` is sought at the points of a uniform grid; beyond the window it is
1 and 0.  The integrals are replaced by the rules of `numerics.quadrature` with local polynomials
through 20 points.  The unknowns are these values and the speed, the conditions all equations and
s(0) = 1/2 (`newton`).  The weights sum to one exactly as the kernel does, so that the discrete
equations have the speed of the jump conditions.  If the solution has this speed to round-off, its
window is long enough; the grid may still be too coarse.

Two grids.  The equation is solved on a coarse grid, from the front of long waves, and then on a
fine one.  The fine spacing follows from the difference of two quadrature rules on the coarse
solution. A third grid, finer, with another order and a longer window, gives the error estimate.

If the front of long waves does not lead to the front, one of stronger damping is solved first.  It
is followed back by steps as long as Newton's iteration allows.

Tails.  Near either state :math:`s \sim e^{\lambda\xi}` with

.. math:: \lambda^2 = (p' - \lambda q')\,(2\cosh\lambda - 2),

the dispersion relation of `fronts.linear.tails` with α = p' and αg = q'.  Behind, a window of
`DECAY`/Re λ with the slowest root reaches down to round-off.  Ahead the tail is the exponential
:math:`e^{-\kappa\xi}`; where p' and q' vanish s falls doubly exponentially after a stretch that the
long-wave front describes.  These lengths are estimates: the solution itself shows whether its ends
are at rest (`_needed_stretch`).

Spacing.  A front falls ahead the more sharply the larger p'(1), for Hertz contacts α.  For these it
falls by a factor that grows like a tower, and its sharpest part needs some (6 + 4.3α) points per
site.  A wide front with small α − 1 needs fewer.  The spacing is found on a coarse grid. There
convolutions by rules of two orders differ by a known power of the spacing.
"""

import functools
import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.linear.tails import lowest_roots_of_all, rate_of_tail_ahead
from granular_fronts.fronts.profile import newton
from granular_fronts.fronts.profile.equation import FrontProblem
from granular_fronts.fronts.profile.long_wave_front import (
    at_least_critically_damped,
    long_wave_front,
)
from granular_fronts.fronts.profile.newton import Grid, Unknowns
from granular_fronts.numerics.interpolation import interpolate_all
from granular_fronts.numerics.quadrature import Weights, kernel_weights

COARSE_ORDER, ORDER, REFINED_ORDER = 8, 20, 22  # points of the local polynomials
OTHER_ORDER = 16  # compared with `ORDER`
STEPS = 60  # of Newton's iteration
TOLERANCE, COARSE_TOLERANCE = 1e-15, 1e-9  # of s, where rounding is not magnified

# Where the direct start fails: by how much stronger damping is tried, and steps back from there.
STRONGER = (2.0, 4.0, 8.0, 16.0, 32.0)
LONGEST_RATIO, SHORTEST_RATIO = 2.0, 1.005

DECAY = 37.0  # natural logarithm of what is left of a tail at the end of the window
COARSE_SHARE = 0.6  # of the window behind: a start need not show the end of its tail
MOST_SITES = 1e6  # longest window in which fronts have been found
ADJUSTMENTS = 8  # of window and spacing

POINTS_COARSE = 6000  # of the first grid, about, and of the longest grid
MOST_POINTS = 800_000
FINEST = Fraction(1, 128)  # what is not resolved with this spacing is not smooth
DEFECT = 2e-13  # largest difference of the two rules on the final grid
ASSUMED_POWER = 12  # of the spacing, which that difference is taken to follow

FINER, LONGER = 1.4, 1.1  # by how much the refined grid is finer, and its window longer

ERROR_METHOD = (
    f"largest difference to a solution with {REFINED_ORDER} instead of {ORDER} points per "
    f"polynomial, on a grid finer by {FINER} or more and a window longer by {LONGER}"
)

# What a front keeps to, where rounding is not magnified.
AT_REST = 5e-14
BELOW = 1e-12
SPEED_TOLERANCE = 1e-12
RESIDUAL_TOLERANCE = 1e-13


class Window(NamedTuple):
    """Lengths behind and ahead of ξ = 0, in sites."""

    behind: float
    ahead: float

    @property
    def length(self):
        """Both lengths together."""
        return self.behind + self.ahead

    def longer(self, behind=1.0, ahead=1.0):
        """Return the window stretched by two factors."""
        return Window(self.behind * behind, self.ahead * ahead)


class Profile(NamedTuple):
    """A front on its grid."""

    problem: FrontProblem
    spacing: Fraction  # in sites
    middle: int  # index of ξ = 0, where s = 1/2
    s: np.ndarray  # shape (points,)
    speed_defect: float  # relative deviation from the speed of the jump conditions
    residuals: np.ndarray  # the largest before each Newton step and after the last, on all grids
    reason: str = ""  # why this is not a front

    @property
    def xi(self):
        """Coordinates of the points, shape (points,)."""
        return float(self.spacing) * np.arange(-self.middle, self.s.size - self.middle)

    def evaluate(self, xi):
        """Return the values of s at any positions, 1-D."""
        return interpolate_all(self.s, xi / float(self.spacing), 1.0, 0.0, self.middle)


def solve_profile(problem):
    """Return the front of a problem from nothing; with a `reason` if it is not the front."""
    with np.errstate(all="ignore"):
        # A problem beyond double precision has no length.
        window = choose_window(problem)
    if not window.length <= MOST_SITES:
        taken = f"{window.length:.2g}" if np.isfinite(window.length) else "countless"
        return _no_profile(
            problem,
            f"the front and its tails take {taken} sites, but rounding hides more than "
            f"{MOST_SITES:.0e}: bring gamma closer to 1, alpha and right_state away from it",
        )
    profile = solve_coarse(problem, window.longer(COARSE_SHARE))
    if profile.reason:
        return profile
    spacing = max(_expected_spacing(profile), FINEST)
    for _ in range(ADJUSTMENTS):
        before = profile.residuals
        profile = solve_on_grid(problem, window, spacing, ORDER, profile.evaluate)
        profile = profile._replace(residuals=np.concatenate([before, profile.residuals]))
        if profile.reason:
            return profile
        defect, stretch = quadrature_defect(profile), _needed_stretch(profile)
        sharp = defect > DEFECT * problem.magnification
        if (not sharp and stretch == (1.0, 1.0)) or (sharp and spacing == FINEST):
            break
        window = window.longer(*stretch)
        if sharp:
            finer = min(_expected_spacing(profile), rational(0.8 * float(spacing)))
            spacing = max(finer, FINEST)
    if sharp:
        return profile._replace(
            reason=f"the quadrature still errs by {defect:.1e} at {1 / float(spacing):.4g} points "
            "per site: the front is too sharp, or the law has a kink between the states"
        )
    return profile._replace(reason=_reason_against(profile))


def _no_profile(problem, reason):
    """Return a profile without a front, with the reason."""
    return Profile(problem, Fraction(1), 0, np.empty(0), math.nan, np.empty(0), reason)


def refine(profile):
    """Return the same front on a finer grid, by another order, on a longer window."""
    spacing = float(profile.spacing)
    window = Window(spacing * profile.middle, spacing * (profile.s.size - profile.middle))
    return solve_on_grid(
        profile.problem,
        window.longer(LONGER, LONGER),
        rational(spacing / FINER),
        REFINED_ORDER,
        profile.evaluate,
    )


def solve_coarse(problem, window):
    """Return front on the coarse grid, from the long-wave front or else from stronger damping."""
    direct = _from_long_wave(problem, window)
    if not direct.reason:
        return direct
    for factor in STRONGER:
        strong = problem._replace(damping=factor * problem.damping)
        known = _from_long_wave(strong, choose_window(strong))
        if not known.reason:
            return _walk(known, problem, window)
    return direct


def _walk(known, problem, window):
    """Follow the front to weaker damping, by steps as long as Newton's iteration allows."""
    ratio = LONGEST_RATIO
    while True:
        damping = max(problem.damping, known.problem.damping / ratio)
        arrives = damping == problem.damping
        weaker = problem._replace(damping=damping)
        attempt = _solve_coarse_from(
            known.evaluate, weaker, window if arrives else choose_window(weaker)
        )
        if not attempt.reason:
            known = attempt
        if (arrives and not attempt.reason) or ratio < SHORTEST_RATIO:
            return attempt
        ratio = math.sqrt(ratio) if attempt.reason else ratio


def _from_long_wave(problem, window):
    start = long_wave_front(at_least_critically_damped(problem))
    return _solve_coarse_from(start.evaluate, problem, window)


def _solve_coarse_from(start, problem, window):
    spacing = _coarse_spacing(problem, window)
    return solve_on_grid(problem, window, spacing, COARSE_ORDER, start, COARSE_TOLERANCE)


def solve_on_grid(problem, window, spacing, order, start, tolerance=TOLERANCE):
    """Return the front on one grid, from values of s that `start` gives for any ξ.

    The iteration ends at changes of the strain below the tolerance, relative to the larger state.
    """
    middle = math.ceil(window.behind / spacing)
    points = middle + 1 + math.ceil(window.ahead / spacing)
    if points > MOST_POINTS:
        return _no_profile(
            problem, f"the window would need {points} points, more than {MOST_POINTS}"
        )
    profile = Profile(problem, spacing, middle, np.empty(points), math.nan, np.empty(0))
    unknowns = Unknowns(np.ascontiguousarray(start(profile.xi)), np.ones(1))
    unknowns.s[middle] = 0.5
    grid = make_grid(spacing, middle, kernel_weights(spacing, order))
    history = np.empty(STEPS + 1)
    tolerance *= problem.magnification
    step, status = newton.iterate(problem, grid, tolerance, unknowns, history)
    profile = profile._replace(
        s=unknowns.s,
        speed_defect=float(unknowns.speed[0]) - 1.0,
        residuals=history[: step + 1],
    )
    if status == newton.SETTLED:
        return profile
    end = f"does not settle, with a residual of {history[step]:.1e}"
    if status == newton.NOT_FINITE:
        end = f"overflows after {step} steps"
    return profile._replace(reason=f"Newton's iteration {end}")


def _reason_against(profile):
    """Return in words why a solution is not the front sought; empty if it may be."""
    problem, s, residual = profile.problem, profile.s, profile.residuals[-1]
    rounding = problem.magnification
    if residual > RESIDUAL_TOLERANCE * rounding * (1.0 + problem.damping_number):
        return f"the residual is {residual:.1e}, above round-off"
    if abs(profile.speed_defect) > SPEED_TOLERANCE * rounding:
        return f"the speed is wrong by {profile.speed_defect:.1e}: this is not a front"
    if s[profile.middle + 1 :].max() >= 0.5:
        return "the front passes its value at xi = 0 again ahead: another part of it is at xi = 0"
    if s.min() < -BELOW * rounding:
        return (
            f"the strain passes the state ahead by {-s.min():.3g} of the jump: this is another "
            "branch"
        )
    if not problem.least < s.min() <= s.max() < problem.most:
        return (
            f"the front overshoots by {s.max() - 1.0:.3g} of the jump, out of the domain of the law"
        )
    if _needed_stretch(profile) != (1.0, 1.0):
        return "the ends of the window are not at rest: the tail decays more slowly than expected"
    return ""


def _needed_stretch(profile):
    """Return the factors by which the window is too short behind and ahead, 1.0 where it is not."""
    at_rest = AT_REST * profile.problem.magnification
    behind = np.abs(profile.s[: 4 + profile.s.size // 200] - 1.0).max()
    ahead = np.abs(profile.s[-4:]).max()
    return (1.2 if behind > at_rest else 1.0), (1.3 if ahead > at_rest else 1.0)


def quadrature_defect(profile):
    """Return the largest difference of the right-hand sides by rules of orders 20 and 16."""
    grid = make_grid(profile.spacing, profile.middle, differences_of_rules(profile.spacing, ORDER))
    return newton.largest_convolution(profile.problem, grid, profile.s)


@functools.cache
def differences_of_rules(spacing, order):
    """Return the weights of an order less the weights of order 16."""
    rule, other = (kernel_weights(spacing, of) for of in (order, OTHER_ORDER))
    more = (rule.hat.size - other.hat.size) // 2
    return Weights(*(a - np.pad(b, more) for a, b in zip(rule, other, strict=True)))


def make_grid(spacing, middle, weights):
    """Return the grid as compiled code takes it."""
    return Grid(float(spacing), middle, weights.hat, weights.jump)


def _expected_spacing(coarse):
    """Return the spacing at which the defect is expected to be at round-off."""
    allowed = DEFECT * coarse.problem.magnification
    ratio = allowed / max(quadrature_defect(coarse), 1e-30)
    return rational(float(coarse.spacing) * min(max(ratio ** (1.0 / ASSUMED_POWER), 0.2), 2.0))


def choose_window(problem):
    """Return the window of a problem, from the tails of its front."""
    root = lowest_roots_of_all(problem.behind.p_slope, problem.tail_damping, 1)[0]
    return Window(DECAY / root.real, _length_ahead(problem))


def _length_ahead(problem):
    long_wave = long_wave_front(problem).xi[-1]
    dispersive = 12.5 / math.sqrt(12.0 * (1.0 - 1.0 / problem.behind.p_slope))
    return max(long_wave + dispersive, DECAY / rate_ahead(problem))


def rate_ahead(problem):
    """Return κ of the tail ahead, s ~ e^(−κξ); infinite where s falls faster, p'(0) = q'(0) = 0."""
    stiffness, viscosity = problem.ahead.p_slope, problem.damping * problem.ahead.q_slope
    if stiffness == viscosity == 0.0:
        return math.inf
    return rate_of_tail_ahead(stiffness, viscosity, 1.0)


def _coarse_spacing(problem, window):
    """Return the spacing of the first grid: a third of a sharp front's points, not too many."""
    per_site = 2.0 + 1.6 * problem.behind.p_slope
    return rational(max(1.0 / per_site, window.length / POINTS_COARSE))


def rational(spacing):
    """Return the spacing at or below this one that is a whole number of sites or divides a site."""
    if spacing >= 1.0:
        return Fraction(math.floor(spacing))
    return Fraction(1, math.ceil(1.0 / spacing))
