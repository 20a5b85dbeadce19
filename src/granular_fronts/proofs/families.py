"""One continuous family of fronts: how the fronts of neighbouring intervals of γ are joined.

On the interval of one certificate the fixed point y* depends continuously on γ (a contraction,
uniform in γ, of a map that is continuous in γ), and so do P* and u*, uniformly in ξ.  Where two
intervals meet, each certificate gives a front: P₁ and P₂.  Neither is unique near P̄, as
translates are fronts too, so that P₁ = P₂ cannot be expected; but P₂ may be a translate of P₁.

**Lemma 9.** Let φ(h) = ∫ h over (−1, 1), f = φ(P₁ − P₂), and P₂(ξ) − P₂(η) ≥ m > 0 for |ξ + 1| <
h, |η − 1| < h.  If T = |f|/m < h, some translate P₂(· + τ), |τ| ≤ T, has the same φ as P₁.  Let
W(ξ) bound |u₁ − ū| and |u₂(· + τ) − ū|, let ω(ξ) ≥ |a(ū + w) − a(ū)| for |w| ≤ W, with ū, A, Z₁, ρ
and κ of the first certificate, and r₀ = ∫ ρ over (−1, 1)/(P₁(−1) − P₁(1)).  If

    Z₁ + sup κ ω + 2 r₀ sup |u₁'| ω < 1,

then P₁ = P₂(· + τ).

*Proof.* Let h = P₁ − P₂(· + τ); φ(h) = 0.  As both are solutions, h = a_m K*h, a_m the mean of a
between u₁ and u₂(· + τ), |a_m − ā| ≤ ω.  By Lemma 4, h = A y + c P₁'.  With L_m = 1 − a_m K*, ‖1 −
L_m A‖ ≤ Z₁ + sup κ ω, and L_m P₁' = (a(u₁) − a_m) u₁' is at most 2 ω |u₁'|; so 0 = L_m h gives (1
− Z₁ − sup κ ω) ‖y‖ ≤ 2 |c| sup ω |u₁'|. From φ(h) = 0, |c| (P₁(−1) − P₁(1)) = |φ(A y)| ≤ ‖y‖ ∫ ρ.
Hence y = 0, c = 0. ∎

Shifting the second branch by τ, and each following one by the sum of the shifts before it, makes
the family continuous over all intervals; what is proved of each front (positivity, decrease ahead,
the maximum above 1) does not change by shifts.
"""

from flint import arb, ctx

from granular_fronts.proofs.balls import NotProvedError, bounds, largest, power, size
from granular_fronts.proofs.checker import PRECISION, Front, read
from granular_fronts.proofs.consequences import shape


def prove_family(paths):
    """Prove that the fronts of certificates, in the order of γ, form one continuous family.

    Parameters
    ----------
    paths : iterable of str or path

    Yields
    ------
    dict
        Of each certificate: `path`, `gamma` (pairs of numerator and denominator), `statements`
        and `inequalities`; the last are those of its own and of its junction with the one before.

    Raises
    ------
    NotProvedError
        At the first certificate that is not proved or not joined.
    """
    before, last = ctx.prec, None
    for path in paths:
        ctx.prec = PRECISION
        try:
            front = Front(read(path))
            statements = [*front.exists(), *shape(front), *front.rear()]
            if last is not None:
                join(last, front)
        finally:
            ctx.prec = before
        ends = front.data["gamma"].tolist()
        yield {
            "path": str(path),
            "gamma": [ends[:2], ends[2:]],
            "statements": statements,
            "inequalities": front.inequalities,
        }
        last = front


def join(first, second):
    """Lemma 9 at the common end of two intervals; noted among the inequalities of the second."""
    high, low = first.data["gamma"].tolist()[2:], second.data["gamma"].tolist()[:2]
    same_law = first.data["alpha"].tolist() == second.data["alpha"].tolist()
    if high != low or not same_law or first.n != second.n:
        raise NotProvedError(f"the intervals do not meet: {high} and {low}")
    n, alpha, h = first.n, first.alpha, first.h
    cells = range(-max(first.left, second.left) * n, max(first.M, second.M) * n)
    middle = range(-n, n)
    behind, ahead = (
        [power(bound, alpha) for j in (at - 1, at) for bound in _strain(second, j)]
        for at in (-n, n)
    )
    fall = -largest([-value for value in behind]) - largest(ahead)
    second.require("P falls over (−1, 1)", arb(0), fall)
    gap = sum((_force_gap(first, second, j) * h for j in middle), arb(0))
    shift = gap / fall
    second.require("shift below a cell", shift, h)
    drop = power(_strain(first, -n)[0], alpha) - power(_strain(first, n)[1], alpha)
    second.require("the first P falls over (−1, 1)", arb(0), drop)
    weight = sum((_norm(first, j)[0] * h for j in middle), arb(0)) / drop

    inner, outer = [], []
    for j in (cells[0] - 1, *cells, cells[-1] + 1):
        (low, high), kappa = bounds(_piece(first, j)), _norm(first, j)[1]
        steep = largest(_slope(second, k) for k in (j - 1, j, j + 1))
        apart = size(_piece(first, j) - _piece(second, j)) + _norm(second, j)[1] * second.r
        omega = first.rise(low, high, largest([apart + shift * steep, kappa * first.r]))
        inner.append(kappa * omega)
        outer.append(_slope(first, j) * omega)
    total = first.Z1 + largest(inner) + 2 * weight * largest(outer)
    second.require("the front before is a translate", total, arb(1))


def _index(front, j):
    """The place of the cell (j, j + 1)/n among those of a front, or None outside."""
    k = j + front.left * front.n
    return k if 0 <= k < len(front.u) else None


def _piece(front, j):
    """ū on a cell; 1 behind all cells, 0 ahead."""
    k = _index(front, j)
    return front.u[k] if k is not None else front.u[0] * 0 + (1 if j < 0 else 0)


def _norm(front, j):
    """ρ and κ on a cell."""
    k = _index(front, j)
    if k is not None:
        return front.rho[k], front.kappa[k]
    return (front.rho_behind, front.outer_kappa[0]) if j < 0 else (arb(1), front.outer_kappa[1])


def _strain(front, j):
    """Bounds of u* on a cell."""
    low, high = bounds(_piece(front, j))
    error = _norm(front, j)[1] * front.r
    return low - error, high + error


def _slope(front, j):
    """Bound of |u*'| on a cell."""
    return size(_piece(front, j).derivative()) * 2 * front.n + front.slope_error


def _force_gap(first, second, j):
    """Bound of |P₁ − P₂| on a cell within both windows."""
    k, m = _index(first, j), _index(second, j)
    return size(first.P[k] - second.P[m]) + first.rho[k] * first.r + second.rho[m] * second.r
