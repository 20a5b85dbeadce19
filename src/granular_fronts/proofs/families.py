"""Continuous families: the fronts of neighbouring intervals of γ are joined.

On the interval of one certificate H, g and r are fixed.  As K is continuous in L¹, P̄, ū, A and Q
depend continuously on γ in norm.  So the fixed point y* of a uniform contraction depends
continuously on γ, and with it P* and u*, uniformly in ξ.  Where two intervals meet, each
certificate gives a front, P₁ and P₂, near the P̄ of that end.  Neither is unique near P̄, as
translates are fronts too, so that P₁ = P₂ cannot be expected; but P₂ may be a translate of P₁.

**Lemma 16.** Let φ(p) = ∫ p over (−1, 1), f = φ(P₁ − P₂), and P₂(ξ) − P₂(η) ≥ m > 0 for |ξ + 1| <
h, |η − 1| < h.  If T = |f|/m < h, some translate P₂(· + τ), |τ| ≤ T, has the same φ as P₁.  Let
W(ξ) bound |u₁ − ū| and |u₂(· + τ) − ū|, let ω(ξ) ≥ |a(ū + w) − a(ū)| for |w| ≤ W, with A, Z₁, ρ
and κ of the first certificate and its ū at that end.  Let P₁(−1) > P₁(1), and r₀ be ∫ ρ over
(−1, 1) divided by P₁(−1) − P₁(1).  If

    Z₁ + sup κ ω + 2 r₀ sup |u₁'| ω < 1,

then P₁ = P₂(· + τ).

*Proof.* The derivative of φ(P₂(· + τ)) by τ is at most −m, so that such a τ exists.  Let p = P₁ −
P₂(· + τ); φ(p) = 0.  As both are solutions, p = a_m K*p.  Here a_m is the mean of a(u) between u₁
and u₂(· + τ), |a_m − ā| ≤ ω.  By Lemma 5, p = A y + c P₁'.  With L_m = 1 − a_m K*, ‖1 −
L_m A‖ ≤ Z₁ + sup κ ω, and L_m P₁' = (a(u₁) − a_m) u₁' is at most 2 ω |u₁'|; so 0 = L_m p gives (1
− Z₁ − sup κ ω) ‖y‖ ≤ 2 |c| sup ω |u₁'|. From φ(p) = 0, |c| (P₁(−1) − P₁(1)) = |φ(A y)| ≤ ‖y‖ ∫ ρ.
Hence y = 0, c = 0. ∎

**Lemma 17 (threshold).** Let one certificate of a family show that damping is critical
(`rear_expansion`).  Let all before it show max u > 1, and all after it u' < 0.  If γ_x of Lemma 13
is in the interval of that one, then u' < 0 on ℝ if and only if γ ≥ γ_x, and max u > 1 for γ < γ_x.

*Proof.* The three roots of the certificate are all up to η, and those of Lemma 13 the slowest three
at γ_x.  Where their order is not certain, Re λ₂ − λ₁ grows with γ, so γ_x is its only zero on the
interval.  Above it the front is monotone, and below it overshoots. ∎

The second branch is shifted by τ, and each following one by the sum of the shifts before it.  This
makes the family continuous over all intervals.  So is that of the translates with the value 1/2 at
0 (`consequences`).  The place ξ₀ of 1/2 depends continuously on γ.  At a junction both fronts have
it in common, since each falls from two cells before 0 on.  What is proved of each front
(positivity, decrease ahead, the maximum above 1) does not change by shifts.  If α is in an
interval, the same in all certificates, this holds for each α.  As φ(P₂(· + τ)) falls with τ for |τ|
< h, τ is the only shift below h with that φ.  So τ depends continuously on α, and the family is
continuous in α and γ.
"""

import math
from itertools import groupby, takewhile
from pathlib import Path

from flint import arb, arb_poly, fmpq

from granular_fronts.proofs.arrays import ends, in_words, written
from granular_fronts.proofs.balls import (
    NotProvedError,
    bounds,
    in_a_sentence,
    in_balls,
    largest,
    power,
    size,
)
from granular_fronts.proofs.checker import Front, read
from granular_fronts.proofs.tail_roots import critical_damping

DIGITS = 20  # of γ_x in a statement
SHAPES = {
    "overshoots": "the front overshoots, max u* > 1",
    "monotone": "u*' < 0 on the whole line: the front is monotone",
}


def certificates_below(folder):
    """Return the certificates in a folder and in those inside it, in the order of γ."""
    paths, lows = [*Path(folder).rglob("*.npz")], {}
    if not paths:
        raise NotProvedError(f"there is no certificate in {folder}")
    for path in paths:
        with in_a_sentence(f"{path}: "):
            lows[path] = ends(read(path), "gamma")
    return sorted(paths, key=lows.get)


def prove_family(paths):
    """Prove that the fronts of certificates, in the order of γ, form one continuous family.

    Yield the `record` of each, with the inequalities of its front and of its junction with the one
    before.  A NotProvedError names the first that is not proved or not joined.
    """
    last = None
    for path in paths:
        with in_a_sentence(f"{path}: "):
            last = prove(path, last)
        yield record(path, last)


def prove(path, last=None):
    """Return the front of a certificate, proved from its file and joined to the one before."""
    with in_balls():
        front = Front(read(path))
        front.statements = list(front.prove())
        if last is not None:
            join(last, front)
    return front


def conclude(records):
    """Yield what the records of a family prove together, of all its γ."""
    exponents, gammas = in_words(records[0]["alpha"], "α"), in_words(_span(records), "γ")
    yield (
        f"For {exponents} and {gammas} the fronts u*, shifted to u*(0) = 1/2, are one continuous"
        " family."
    )
    kinds = [_kind(record["numbers"]) for record in records]
    for kind, group in groupby(zip(kinds, records, strict=True), lambda pair: pair[0]):
        if kind in SHAPES:
            yield f"For {in_words(_span([record for _, record in group]), 'γ')} {SHAPES[kind]}."
    for stable, group in groupby(records, lambda record: "stable" in record["numbers"]):
        if stable:
            yield f"For {in_words(_span(list(group)), 'γ')} the front is spectrally stable."
    for at in (k for k, kind in enumerate(kinds) if kind == "critical"):
        before = list(takewhile(lambda kind: kind == "overshoots", reversed(kinds[:at])))
        after = list(takewhile(lambda kind: kind == "monotone", kinds[at + 1 :]))
        yield _threshold(records[at], _span(records[at - len(before) : at + 1 + len(after)]))


def _span(records):
    """Return both ends of the interval of γ of neighbouring certificates."""
    return records[0]["gamma"][0], records[-1]["gamma"][1]


def _threshold(record, gammas):
    """Return that fronts are monotone from γ_x on, which one certificate contains."""
    (alpha, _), (low, high) = record["alpha"], record["gamma"]
    with in_balls():
        gamma = critical_damping(alpha).gamma
        if not arb(fmpq(low.numerator, low.denominator)) < gamma:
            raise NotProvedError(f"γ_x is not above {written(low)}")
        if not gamma < arb(fmpq(high.numerator, high.denominator)):
            raise NotProvedError(f"γ_x is not below {written(high)}")
        return (
            f"For {in_words(gammas, 'γ')}: u*' < 0 on the whole line if and only if γ ≥ γ_x, γ_x ="
            f" {gamma.str(DIGITS)}; for γ < γ_x the front overshoots, max u* > 1."
        )


def _kind(numbers):
    """Return what is proved of the shape of all fronts of a certificate."""
    overshoots = numbers.keys() & {"overshoot", "oscillates"}
    known = numbers.keys() & {"monotone", "critical"}
    return "overshoots" if overshoots else known.pop() if known else "open"


def record(path, front):
    """Return what is proved, as in `check_certificate`, with `path`."""
    return {
        "path": str(path),
        "alpha": ends(front.data, "alpha"),
        "gamma": ends(front.data, "gamma"),
        "error": front.error,
        "numbers": front.numbers,
        "statements": front.statements,
        "inequalities": front.inequalities,
    }


def join(first, second):
    """Lemma 16 at the common end of two intervals; noted among the inequalities of the second."""
    (_, high), (low, _) = (ends(front.data, "gamma") for front in (first, second))
    if high != low or ends(first.data, "alpha") != ends(second.data, "alpha"):
        raise NotProvedError(f"the intervals do not meet: {high} and {low}")
    n = math.lcm(first.n, second.n)
    one, two = _Side(first, 1, n), _Side(second, -1, n)
    alpha, h, middle = first.alpha, arb(1) / n, range(-n, n)
    behind, ahead = (
        [power(bound, alpha) for j in (at - 1, at) for bound in two.strain(j)] for at in (-n, n)
    )
    fall = -largest([-value for value in behind]) - largest(ahead)
    second.require("P falls over (−1, 1)", arb(0), fall)
    gap = sum((_force_gap(one, two, j) * h for j in middle), arb(0))
    shift = gap / fall
    second.require("shift below a cell", shift, h)
    drop = power(one.strain(-n)[0], alpha) - power(one.strain(n)[1], alpha)
    second.require("the first P falls over (−1, 1)", arb(0), drop)
    weight = sum((one.norm(j)[0] * h for j in middle), arb(0)) / drop

    inner, outer = [], []
    for j in range(-max(first.left, second.left) * n - 1, max(first.M, second.M) * n + 1):
        (low, high), kappa = bounds(one.u(j)), one.norm(j)[1]
        steep = largest(two.slope(k) for k in (j - 1, j, j + 1))
        apart = size(one.u(j) - two.u(j)) + two.norm(j)[1] * second.r
        omega = first.rise(low, high, largest([apart + shift * steep, kappa * first.r]))
        inner.append(kappa * omega)
        outer.append(one.slope(j) * omega)
    total = first.Z1 + largest(inner) + 2 * weight * largest(outer)
    second.require("the front before is a translate", total, arb(1))


class _Side:
    """The front of one end of an interval on the cells (j, j + 1)/n, n a multiple of its own."""

    def __init__(self, front, s, n):
        self.front, self.n, self.parts = front, n, n // front.n
        self.pieces, self.strains = front.at(arb(s))

    def place(self, j):
        """Return the place of a cell among the cells of the front, or None outside."""
        k = j // self.parts + self.front.left * self.front.n
        return k if 0 <= k < len(self.strains) else None

    def part(self, f, j):
        """Return a polynomial on its part of a cell."""
        k = self.parts
        return f(arb_poly([fmpq(2 * (j % k) + 1 - k, k), fmpq(1, k)])) if k > 1 else f

    def P(self, j):  # noqa: N802
        """Return P̄, within the cells of the front."""
        return self.part(self.pieces[self.place(j)], j)

    def u(self, j):
        """Return ū; 1 behind all cells, 0 ahead."""
        k = self.place(j)
        return self.part(self.strains[k], j) if k is not None else arb_poly([int(j < 0)])

    def norm(self, j):
        """Return ρ and κ."""
        k, front = self.place(j), self.front
        if k is not None:
            return front.rho[k], front.kappa[k]
        return (front.rho_behind, front.outer_kappa[0]) if j < 0 else (arb(1), front.outer_kappa[1])

    def strain(self, j):
        """Return the bounds of u*."""
        low, high = bounds(self.u(j))
        error = self.norm(j)[1] * self.front.r
        return low - error, high + error

    def slope(self, j):
        """Return the bound of |u*'|."""
        return size(self.u(j).derivative()) * 2 * self.n + self.front.slope_error


def _force_gap(one, two, j):
    """Return the bound of |P₁ − P₂| on a cell within both windows."""
    error = one.norm(j)[0] * one.front.r + two.norm(j)[0] * two.front.r
    return size(one.P(j) - two.P(j)) + error
