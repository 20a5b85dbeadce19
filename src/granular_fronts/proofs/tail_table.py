"""Tail roots and critical damping: thirty digits in balls, beside the values of doubles.

The computed values start the enclosures of `tail_roots`, and are judged by them.
"""

import math
from fractions import Fraction

from flint import acb, arb, ctx, fmpq

from granular_fronts.fronts.linear.critical_damping import critical_damping, meaning_changes_at
from granular_fronts.fronts.linear.tails import BEND
from granular_fronts.fronts.linear.tails import tail_roots as computed_roots
from granular_fronts.proofs.tail_roots import (
    Law,
    crossing,
    double_root,
    find_bend,
    slowest_roots,
    touching,
)

PRECISION, DIGITS, RADIUS = 180, 30, 1e-9
ALPHAS = tuple(map(Fraction, ("17/16", "9/8", "5/4", "3/2", "2", "3", "5")))
LAWS = tuple((Fraction("3/2"), Fraction(gamma)) for gamma in ("1/10", "1/5", "3/10", "1/3", "1"))
COUNT = 4


def tail_records(alphas=ALPHAS, laws=LAWS, count=COUNT):
    """α*, where critical damping changes its meaning; γ_c for each α; the slowest roots of laws.

    Parameters
    ----------
    alphas : iterable of Fraction
    laws : iterable of pairs of Fraction
        α and γ, β = α.
    count : int
        How many roots of each law.

    Yields
    ------
    dict
        `quantity`, `alpha`, `gamma` (what it belongs to, empty where nothing), `enclosure` (middle
        and radius in 30 digits), `computed` (a double), `error` (bound of its distance from the
        enclosed number), `ulps` (the same in units of its last digit).

    Raises
    ------
    NotProvedError
        If an enclosure or a count of roots fails.
    """
    before, ctx.prec = ctx.prec, PRECISION
    try:
        bend = find_bend(BEND, 1e-6)
        yield _record("α*", "", "", touching(bend), meaning_changes_at())
        for alpha in alphas:
            yield from _critical(alpha)
        for alpha, gamma in laws:
            yield from _slowest(alpha, gamma, count)
    finally:
        ctx.prec = before


def _critical(alpha):
    exponent, gamma = ball(alpha), critical_damping(float(alpha))
    roots = computed_roots(float(alpha), gamma, count=3)
    if alpha < meaning_changes_at():
        law, _ = double_root(exponent, roots[0].real, 1e-4)
        yield _record("γ_c, double root", alpha, "", law.gamma, gamma)
    else:
        real, pair = sorted(roots[:2], key=lambda root: root.imag)
        law, *_ = crossing(exponent, gamma, (real, pair), RADIUS)
        yield _record("γ_c, crossing", alpha, "", law.gamma, gamma)


def _slowest(alpha, gamma, count):
    law = Law(ball(alpha), ball(gamma))
    starts = computed_roots(float(alpha), float(gamma), count=count + 1)
    roots = slowest_roots(law, [complex(root) for root in starts], RADIUS)
    for j, (root, start) in enumerate(zip(roots, starts, strict=False), 1):
        yield _record(f"λ{j}", alpha, gamma, root, complex(start))


def _record(quantity, alpha, gamma, enclosure, computed):
    point = acb(computed.real, computed.imag)
    error = float(abs(acb(enclosure) - point).upper())
    value = enclosure.real if isinstance(enclosure, acb) and computed.imag == 0 else enclosure
    return {
        "quantity": quantity,
        "alpha": str(alpha),
        "gamma": str(gamma),
        "enclosure": value.str(DIGITS),
        "computed": computed.real if computed.imag == 0 else computed,
        "error": error,
        "ulps": error / math.ulp(abs(computed)),
    }


def ball(fraction):
    """A ball around a fraction."""
    return arb(fmpq(fraction.numerator, fraction.denominator))
