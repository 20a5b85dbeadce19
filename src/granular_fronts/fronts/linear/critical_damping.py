r"""Critical damping by the tail, by a long-wave formula, and by an overshoot too small to see.

The tail behind a front is governed by the roots λ of :math:`\alpha(1 - g\lambda)S(\lambda) = 1`
(see `tails`), :math:`g = \beta\gamma/\alpha`.  Weak damping makes the slowest a complex pair, and
the front oscillates; strong damping makes it real.

Double root.  The line α(1 − gλ) touches the bell :math:`1/S` at λ if

.. math::

    \alpha = \frac{S + \lambda S'}{S^2}, \qquad g = \frac{S'}{S + \lambda S'} .

Both grow with λ up to where the bell bends, :math:`S S'' = 2 S'^2`.  There the tangent meets the
axis at the largest α, α* ≈ 1.1877, and the three lowest roots are one.  Below α* the pair becomes
two real roots, the two slowest.

Crossing of real parts.  Above α* the pair stays complex, but a real root takes the lead from it:
λ = x and λ = x ± iy solve the same relation.  With :math:`q = 1/S(x)`, dividing the differences by
y² and by y leaves two equations for αg,

.. math::

    2\alpha g \sinh x\,\frac{\sin y}{y} = 4q\cosh x\,\frac{\sin^2(y/2)}{y^2} - 1, \qquad
    2\alpha g (\cosh x\cos y - 1) = 2q\sinh x\,\frac{\sin y}{y} - 2x ,

that are regular down to y = 0, which is α*.  Eliminating αg gives x(y) and α(y) = q + αg x.  As
α → ∞, 2π − y → π/α; the unknown is therefore :math:`z = 2\pi - y`, which keeps all digits.

Long waves.  As α → 1 the double root tends to λ = 6g and :math:`g = ((1 - 1/\alpha)/3)^{1/2}`, the
value μ = 2 of the logarithmic KdV–Burgers equation (James 2021, section 5).

Overshoot.  What is seen is whether max u exceeds 1.  Near critical damping the overshoot falls like
the tail over half a period.  It is far below any visible size before the tail ceases to oscillate,
so this meaning needs a cut.
"""

import functools
import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from granular_fronts.arguments import choice, scalar
from granular_fronts.errors import InputError
from granular_fronts.fronts.profile.equation import power_problem
from granular_fronts.fronts.profile.solve import solve_profile
from granular_fronts.fronts.properties import MEASURES, measure
from granular_fronts.fronts.validation import check_alpha, check_beta

SMALLEST_CUT, LARGEST_CUT = 1e-8, 0.1
RESOLUTION = 2.0**-52
LARGEST_PEAK = MEASURES.index("largest_peak")

SERIES = np.arange(1, 26)  # orders k of S(x) − 1 = Σ 2x^(2k)/(2k+2)!, enough for x ≤ 3

COEFFICIENTS = np.array([2.0 / math.factorial(2 * k + 2) for k in SERIES])
TIGHT = {"xtol": 1e-300, "rtol": 4.0 * np.finfo(float).eps, "maxiter": 1000}

LARGEST_ALPHA = 1e50  # up to it the products of the equations of the crossing do not underflow


def critical_damping(
    alpha: float, beta: float | None = None, definition: str = "tail", cut: float = 1e-3
) -> float:
    """Return the damping above which fronts do not oscillate, in a given sense, for δ = c = 1.

    Parameters
    ----------
    alpha : float
        Exponent of the elastic force, above 1.
    beta : float, optional
        Exponent of the damping force, at least 1; alpha by default.
    definition : {"tail", "double-root", "long-wave", "overshoot"}
        The sense.  At "tail" the slowest exponent of the tail turns from complex to real.  At
        "double-root" two real exponents appear as a double one, only for α ≤ α*.  At "long-wave"
        they do so in the long-wave limit, μ = 2.  At "overshoot" the overshoot max u − 1 of the
        exact front falls below the cut.
    cut : float, optional
        Overshoot that counts as none, from 1e-8 to 0.1; for "overshoot" only.

    Returns
    -------
    float
        γ.  For "tail" and "double-root" it is exact to a few units of the last digit.  For
        "overshoot" its relative error grows like 1e-14/cut and is below 1e-10 at the default cut.

    Raises
    ------
    InputError
        If a parameter is out of range or the definition does not apply.

    Examples
    --------
    >>> round(float(gf.critical_damping(1.5)), 6)
    0.263246
    >>> round(gf.critical_damping(1.5, definition="long-wave"), 6)
    0.333333
    """
    alpha = check_alpha(alpha)
    beta = check_beta(alpha, beta)
    cut = scalar(
        "cut",
        cut,
        least=SMALLEST_CUT,
        most=LARGEST_CUT,
        advice="the overshoot is resolved there, and reached for every alpha",
    )
    if choice("definition", definition, (*_MEANINGS, "overshoot")) == "overshoot":
        return _vanishing_overshoot(alpha, beta, cut)
    return alpha / beta * _MEANINGS[definition](alpha)


def meaning_changes_at() -> float:
    """Return exponent α* ≈ 1.1877, up to which critical damping is a double root of the tail."""
    return 1.0 + _excess_alpha(_bend())


@functools.cache
def _tail(alpha):
    return _double_root(alpha) if alpha <= meaning_changes_at() else _crossing(alpha)


def _double_root(alpha):
    last = meaning_changes_at()
    if alpha > last:
        raise InputError(
            f"alpha is {alpha}, but the tail has no double root above alpha* = {last:.6f}: use "
            'definition "tail", the crossing of real parts.'
        )
    bend = _bend()
    if alpha == last:
        return _touching_damping(bend)
    x = brentq(lambda x: _excess_alpha(x) - (alpha - 1.0), 0.0, bend, **TIGHT)
    return _touching_damping(x)


def _crossing(alpha):
    """Return the g at which a pair x ± iy and a real root x share their real part."""
    scalar("alpha", alpha, most=LARGEST_ALPHA, advice="the damping is alpha^2/(pi beta) beyond")
    z = brentq(lambda z: _alpha_of_crossing(z) - alpha, 1.0 / alpha, 2.0 * math.pi, **TIGHT)
    return _slope_of_line(_crossing_real_part(z), z) / alpha


def _alpha_of_crossing(z):
    """Return α = q + αg x, from α* at z = 2π to infinity at z = 0."""
    x = _crossing_real_part(z)
    return 1.0 / (1.0 + _bell_excess(x)) + _slope_of_line(x, z) * x


def _crossing_real_part(z):
    def disagreement(x):
        a, b, c, d = _equations(x, z)
        return a * d - b * c

    # x(z) grows from 0 to the bend, below z; at z = 2π both equations agree at x = 0 too.
    return brentq(disagreement, 1.0 if z > 3.3 else 0.0, 3.0, **TIGHT)


def _slope_of_line(x, z):
    """Return αg from both equations, since each fails where its coefficient vanishes."""
    a, b, c, d = _equations(x, z)
    return (a * c + b * d) / (c * c + d * d)


def _equations(x, z):
    """Return the right-hand sides a, b and coefficients c, d of αg."""
    q, y = 1.0 / (1.0 + _bell_excess(x)), 2.0 * math.pi - z
    sine = np.sinc(y / math.pi) if y < 3.0 else -math.sin(z) / y
    half_sine = np.sinc(0.5 * y / math.pi)
    a = q * math.cosh(x) * half_sine**2 - 1.0
    b = 2.0 * q * math.sinh(x) * sine - 2.0 * x
    # cosh x cos y − 1 without cancellation.
    d = 4.0 * math.sinh(0.5 * x) ** 2 * math.cos(z) - 4.0 * math.sin(0.5 * z) ** 2
    return a, b, 2.0 * math.sinh(x) * sine, d


def _long_wave(alpha):
    return math.sqrt((alpha - 1.0) / alpha / 3.0)


_MEANINGS: dict[str, Callable[[float], float]] = {
    "tail": _tail,
    "double-root": _double_root,
    "long-wave": _long_wave,
}


def _vanishing_overshoot(alpha, beta, cut):
    def excess(gamma):
        profile = solve_profile(power_problem(alpha, gamma, beta))
        if profile.reason:
            raise InputError(
                f"The front for alpha = {alpha}, beta = {beta}, gamma = {gamma:.6g} was not found "
                f"({profile.reason}): choose another cut."
            )
        return math.log(max(measure(profile)[0][LARGEST_PEAK], RESOLUTION) / cut)

    above = below = critical_damping(alpha, beta)
    while excess(above) > 0.0:
        above *= 1.5
    while excess(below) < 0.0:
        above, below = below, below / 1.5
    return brentq(excess, below, above, xtol=1e-15, rtol=1e-13)


def _bell_excess(x):
    """Return S − 1 from its series, all terms positive."""
    return float(COEFFICIENTS @ x ** (2 * SERIES))


def _bell_series(x):
    """Return S − 1, x S' and x² S'' from their series, all terms positive."""
    terms = COEFFICIENTS * x ** (2 * SERIES)
    return [
        float(np.sum(factor * terms)) for factor in (1, 2 * SERIES, 2 * SERIES * (2 * SERIES - 1))
    ]


def _excess_alpha(x):
    """Return α − 1 of the line that touches the bell at x."""
    excess, first, _ = _bell_series(x)
    # (S + xS' − S²)/S² with S = 1 + excess; first > 2 excess, term by term.
    return ((first - excess) - excess**2) / (1.0 + excess) ** 2


def _touching_damping(x):
    """Return the g of the line that touches the bell at x."""
    excess, first, _ = _bell_series(x)
    return first / x / (1.0 + excess + first)


def _bend():
    """Return where the bell bends: S S'' = 2 S'²."""

    def curvature(x):
        excess, first, second = _bell_series(x)
        return (1.0 + excess) * second - 2.0 * first**2

    return brentq(curvature, 1.0, 3.0, **TIGHT)
