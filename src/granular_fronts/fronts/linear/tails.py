r"""How an exact front approaches its two ends: the dispersion relation of the lattice.

Behind the front (James 2021, section 6), in units where δ = c = 1, :math:`u = 1 + A e^{\lambda\xi}`
with Re λ > 0 solves the linearised chain if

.. math::

    \lambda^2 = \alpha (1 - g\lambda)(2\cosh\lambda - 2), \qquad g = \beta\gamma/\alpha,

or, divided by the double root λ = 0, which is no tail when α ≠ 1,

.. math::

    \alpha (1 - g\lambda)\, S(\lambda) = 1, \qquad
    S(\lambda) = \Bigl(\frac{\sinh(\lambda/2)}{\lambda/2}\Bigr)^2.

Where the roots lie.  Let :math:`E = \alpha(1 - g\lambda)(2\cosh\lambda - 2) - \lambda^2`.  For
ω > 0 the value E(iω) stays in the closed upper half-plane, and on the lines Im λ = 2πk, k ≥ 1,
Re λ > 0, Im E is negative.  The argument of E is followed round the half-strips between these
lines, where :math:`E \approx -\alpha g \lambda e^\lambda` at the far end.  So the numbers of roots
with Re λ > 0 are exact: **three with |Im λ| < 2π, one with 2π(k−1) < Im λ < 2πk for each k ≥ 2**,
and their conjugates.  One root is looked for in each half-strip, so that none can be missed.

Where the search ends.  In a half-strip above the height h a root λ = x + iy has

.. math::

    4\,|\sinh^2(\lambda/2)| = \frac{|\lambda|^2}{\alpha|1 - g\lambda|}
        \ge m = \frac{h^2}{\alpha(1 + gh)}, \qquad
    -\arg\sinh(\lambda/2) \le \frac\pi4 + \arctan\frac xh + \frac12\arctan\frac1{gh} = \phi

(up to π).  The modulus is at most :math:`4\cosh^2(x/2)`, and the real part of sinh(λ/2) at most
sinh(x/2).  Hence x exceeds every value for which :math:`4\cosh^2(x/2) < m` or, for φ < π/2,
:math:`4\sinh^2(x/2) < m\cos^2\phi`.

The three lowest roots.  Real roots are where the straight line α(1 − gλ) meets the bell
:math:`1/S`, which bends once, at λ ≈ 2.35.  The line meets it once, and there is a complex pair, or
three times; it touches it at a double root.

Ahead of the front, at u = r > 0, the same linearisation with λ = −κ reads
:math:`\alpha r^{\alpha-1} c^{-2} (1 + g\kappa) S(\kappa) = 1`, with :math:`g =
\beta\gamma c r^{\beta-\alpha}/\alpha`; it has one real root κ > 0.  At r = 0 and β = 1 it becomes
:math:`\kappa = 4\gamma\sinh^2(\kappa/2)`, while for β > 1 the tail is double exponential:
ln(−ln u) grows by :math:`\ln\min(\alpha, \beta)` per site.
"""

import cmath
import math

import numpy as np
from numba import int64
from scipy.optimize import brentq

from granular_fronts import arguments
from granular_fronts.errors import InputError
from granular_fronts.fronts.validation import check_law
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted

BEND = 2.3469413041671690  # where the bell 1/S(λ) changes its curvature and falls most steeply

MOST_ROOTS, MOST_STRIPS = 1000, 100_000
NEWTON_STEPS = 60

# A step this small relative to the root ends Newton's iteration; the next is below round-off.
SETTLED = 1e-9

# A sum this small relative to its terms is nothing but rounding.
NEGLIGIBLE = 1e-13

# Below it S counts, and not S − 1.
SMALL = 0.25

# Largest Re λ for which S is needed; beyond, 1/S is far below the last digit of 1.
FLAT = 100.0

# Rates of a tail ahead: slower than in any window, and faster than any grid resolves.
SMALLEST_RATE, LARGEST_RATE = 1e-12, 512.0


def tail_roots(alpha: float, gamma: float, beta: float | None = None, count: int = 6) -> np.ndarray:
    """Return exponents λ of the tail behind a front, u − 1 ~ e^(λξ), the slowest decay first.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    gamma : float
        Damping in units of the front, above 0.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.
    count : int
        How many, from 1 to 1000.

    Returns
    -------
    ndarray of complex, shape (count,)
        Roots with Re λ > 0 ordered by real part, one of each conjugate pair (Im λ ≥ 0).  Simple
        roots are good to a few units of the last digit; none with a smaller real part is missing.

    Raises
    ------
    InputError
        If a parameter is out of range.

    Examples
    --------
    >>> gf.tail_roots(alpha=1.5, gamma=0.1, count=2).round(6)
    array([0.579773+2.16553j , 4.145564+9.644951j])
    """
    alpha, gamma, beta = check_law(alpha, gamma, beta)
    count = arguments.count("count", count, most=MOST_ROOTS, advice="ask for so many roots")
    roots = lowest_roots_of_all(alpha, gamma * beta / alpha, count)
    if not np.isfinite(roots).all():
        raise InputError(
            f"A tail root for alpha = {alpha}, beta = {beta} and gamma = {gamma} is beyond double "
            f"precision, or beyond {MOST_STRIPS} half-strips: bring alpha and gamma closer to 1."
        )
    return roots


def rate_of_tail_ahead(stiffness, viscosity, speed):
    """Return κ of a tail e^(−κξ) ahead: c²κ² = (V'' + cW''κ)(2 cosh κ − 2), between 1e-12 and 512.

    `stiffness` and `viscosity` are V'' and cW'' ahead, not both 0, with V'' below c².
    """

    def excess(kappa):
        bell = (2.0 * math.sinh(0.5 * kappa) / kappa) ** 2
        return (stiffness + viscosity * kappa) * bell - speed**2

    if excess(SMALLEST_RATE) >= 0.0:
        return SMALLEST_RATE
    top = 1.0
    while top < LARGEST_RATE and excess(top) < 0.0:
        top *= 2.0
    return brentq(excess, SMALLEST_RATE, top) if excess(top) > 0.0 else LARGEST_RATE


@kernel
def lowest_roots_of_all(alpha, damping, count):
    """Return `count` roots with the smallest real parts, in that order; NaN for one not found."""
    roots = np.empty(3 + count, np.complex128)
    found = _lowest_strip(alpha, damping, roots)
    strip = int64(2)
    while found < count or not _beyond(alpha, damping, strip, roots[count - 1].real):
        if found < roots.size:
            found += 1
            roots[found - 1] = _strip_root(alpha, damping, strip)
        else:
            # The last place holds the largest real part so far, which is not among the first.
            roots[found - 1] = _strip_root(alpha, damping, strip)
        _sort_by_real_part(roots[:found])
        strip += 1
        if strip > MOST_STRIPS or interrupted():
            roots[:] = math.nan
            break
    return roots[:count]


@subroutine
def _sort_by_real_part(roots):
    """Sort in place by insertion, NaN last: all but the last few are in order already."""
    for i in range(1, roots.size):
        root, k = roots[i], i
        while k > 0 and (roots[k - 1].real > root.real or math.isnan(roots[k - 1].real)):
            roots[k] = roots[k - 1]
            k -= 1
        roots[k] = root


@subroutine
def _beyond(alpha, damping, strip, real_part):
    """Return whether all half-strips from this one on hold only roots with a larger real part."""
    height = 2.0 * math.pi * (strip - 1)
    smallest = height * height / (alpha * (1.0 + damping * height))
    phase = 0.25 * math.pi + math.atan(real_part / height) + 0.5 * math.atan(1.0 / damping / height)
    least = smallest * math.cos(phase) ** 2 if phase < 0.5 * math.pi else 0.0
    if least > 4.0 * math.sinh(0.5 * real_part) ** 2:
        return True
    # A root that is not finite is left to the caller, not looked for without end.
    return not smallest <= 4.0 * math.cosh(0.5 * real_part) ** 2


@subroutine
def _excess(x):
    """Return S(x) − 1 without cancellation, complex x."""
    if abs(x) >= 1.0:
        return 4.0 * (cmath.sinh(0.5 * x) / x) ** 2 - 1.0
    term = x * x / 12.0
    total = term
    for k in range(2, 10):
        term = term * x * x / ((2 * k + 2) * (2 * k + 1))
        total = total + term
    return total


@subroutine
def _log_slope(x):
    """Return S'(x)/S(x) = coth(x/2) − 2/x, complex x."""
    if abs(x) < 0.05:
        return x * (1.0 / 6.0 - x * x * (1.0 / 360.0 - x * x / 15120.0))
    return cmath.cosh(0.5 * x) / cmath.sinh(0.5 * x) - 2.0 / x


@subroutine
def _newton(x, alpha, damping, known):
    """Find a root of α(1 − gλ)S(λ) − 1 by Newton's iteration from x, but not the known one."""
    # Near a multiple root it never settles. Then the root is the place where the function falls to
    # rounding, and no more can be known of it.
    nearest, smallest = complex(math.nan, math.nan), NEGLIGIBLE
    for _ in range(NEWTON_STEPS):
        if not abs(x.real) < FLAT:
            break
        more, line = _excess(x), 1.0 - damping * x
        bell = 1.0 + more
        linear, curved = alpha * damping * x, alpha * line * more
        value = (alpha - 1.0) - linear + curved
        share = abs(value) / (alpha - 1.0 + abs(linear) + abs(curved))
        if abs(bell) < SMALL:
            # Strong damping draws roots towards the zeros 2πik of S, where S − 1 hides S.
            bell = 4.0 * (cmath.sinh(0.5 * x) / x) ** 2
            value = alpha * line * bell - 1.0
            share = abs(value) / (abs(alpha * line * bell) + 1.0)
        if share < smallest:
            nearest, smallest = x, share
        slope = alpha * bell * (line * _log_slope(x) - damping)
        deflated = slope * (x - known) - value
        if deflated == 0.0:
            break
        step = value * (x - known) / deflated
        length = abs(step) / abs(x)
        x = x - step * min(1.0, 0.5 / length) if length > 0.0 else x
        if length < SETTLED:
            return x
    return nearest


@subroutine
def _strip_root(alpha, damping, strip):
    """Return the root with 2π(k − 1) < Im λ < 2πk, k ≥ 2."""
    # There the map λ ↦ arcosh(1 + λ²/(2α(1 − gλ))) + 2πik contracts for most laws, with the branch
    # of arcosh that has −2π < Im < 0; Newton's iteration finishes.
    turn = complex(0.0, 2.0 * math.pi * strip)
    x = turn + complex(1.0, -1.0)
    for _ in range(8):
        z = 1.0 + x * x / (2.0 * alpha * (1.0 - damping * x))
        x = cmath.log(z + cmath.sqrt(z - 1.0) * cmath.sqrt(z + 1.0))
        x += turn if x.imag < 0.0 else turn - complex(0.0, 2.0 * math.pi)
    # Of a steep law with weak damping it may not: its roots are next to the imaginary axis.
    for part in range(10):
        x = _newton(x, alpha, damping, complex(-1.0e300, 0.0))
        if 2.0 * math.pi * (strip - 1) < x.imag < 2.0 * math.pi * strip and x.real > 0.0:
            return x
        x = turn + complex(0.1, -0.2 * math.pi * (part + 0.5))
    return complex(math.nan, math.nan)


@subroutine
def _lowest_strip(alpha, damping, roots):
    """Fill in the roots with 0 ≤ Im λ < 2π and count them: three are real, or one and a pair."""
    low = _where_bell_falls(alpha * damping, 0.0, BEND)
    high = _where_bell_falls(alpha * damping, FLAT, BEND)
    end = 1.0 / damping
    if _gap(low, alpha, damping) < 0.0 < _gap(high, alpha, damping):
        roots[0] = _meeting(0.0, low, alpha, damping)
        roots[1] = _meeting(high, low, alpha, damping)
        roots[2] = _meeting(high, end, alpha, damping)
        return 3
    bent = low < high
    start = high if bent and _gap(low, alpha, damping) >= 0.0 else 0.0
    stop = low if bent and _gap(low, alpha, damping) < 0.0 else end
    roots[0] = _meeting(start, stop, alpha, damping)
    roots[1] = _complex_root(alpha, damping, roots[0])
    if roots[1].real < roots[0].real:
        roots[0], roots[1] = roots[1], roots[0]
    return 2


@subroutine
def _complex_root(alpha, damping, known):
    """Return a root with 0 ≤ Im λ < 2π other than the known real one."""
    # It is first sought where it lies for long waves, then where it lies for large damping. Of some
    # 45000 laws with α − 1 from 1e-6 to 100 and γ from 1e-4 to 1e4, many of them next to a double
    # root, none needs more.
    discriminant = 36.0 * damping * damping - 12.0 * (alpha - 1.0) / alpha
    x = _newton(6.0 * damping + cmath.sqrt(complex(discriminant, 0.0)), alpha, damping, known)
    if _in_lowest_strip(x):
        return complex(x.real, abs(x.imag))
    distance = math.sqrt(math.pi / (alpha * damping))
    x = _newton(complex(distance, 2.0 * math.pi - distance), alpha, damping, known)
    if _in_lowest_strip(x):
        return complex(x.real, abs(x.imag))
    return complex(math.nan, math.nan)


@subroutine
def _in_lowest_strip(x):
    """Return whether Re x > 0 and |Im x| < 2π."""
    return x.real > 0.0 and abs(x.imag) < 2.0 * math.pi


@subroutine
def _gap(x, alpha, damping):
    """Return α(1 − gx) − 1/S(x), real x ≥ 0, without cancellation."""
    if x == 0.0:
        return alpha - 1.0
    if x > FLAT:
        return alpha * (1.0 - damping * x)
    more = _excess(complex(x, 0.0)).real
    return (alpha - 1.0) - alpha * damping * x + more / (1.0 + more)


@subroutine
def _meeting(above, below, alpha, damping):
    """Return x between two points where the line α(1 − gx) crosses the bell 1/S(x)."""
    while True:
        x = 0.5 * (above + below)
        if x in (above, below):
            return complex(x, 0.0)
        if _gap(x, alpha, damping) > 0.0:
            above = x
        else:
            below = x


@subroutine
def _where_bell_falls(slope, flat, steep):
    """Return the x between two points where 1/S(x) falls with a slope; `steep` if it never does."""
    while True:
        x = 0.5 * (flat + steep)
        if x in (flat, steep):
            return x
        z = complex(x, 0.0)
        if _log_slope(z).real / (1.0 + _excess(z).real) > slope:
            steep = x
        else:
            flat = x
