"""Uniqueness up to shifts: a solution within a stated distance of ū is a translate of the front.

Notation of `existence` and `families`; P = P*, u = u*, φ(p) = ∫ p over (−1, 1).  Lemma 16 compares
two enclosed fronts.  Here the second is any solution near ū.

**Lemma 18 (uniqueness).** Let W > 0 and P(−1 − τ) − P(1 − τ) ≥ m > 0 for |τ| ≤ H.  Let f ≥ ∫ |P −
v₊^α| over (−1, 1) for all |v − ū| ≤ W, and T = f/m < H.  Let V(ξ) ≥ W and s(ξ) bound |u(ξ − τ) −
ū(ξ)| ≤ V and |u'(ξ − τ)| ≤ s for |τ| ≤ T, let ω(ξ) ≥ |a(ū + w) − a(ū)| for |w| ≤ V, and r₀ = ∫ ρ/m
over (−1, 1). If

    Z₁ + sup κ ω + 2 r₀ sup s ω < 1,

then each bounded solution v of v = K*v₊^α with |v − ū| ≤ W on ℝ is u(· − τ) for some |τ| ≤ T.

*Proof.* τ ↦ φ(P(· − τ)) has the derivative P(−1 − τ) − P(1 − τ) ≥ m.  So for some |τ| ≤ T it is
φ(v₊^α).  Write P_τ, u_τ for the translates of P, u by that τ, and p = P_τ − v₊^α, φ(p) = 0.  As
‖1 − DQ(P_τ) A‖ ≤ Z₁ + sup κ ω < 1, the proof of Lemma 5 gives L^∞ = span P_τ' ⊕ Ran A.  Thus
p = A y + c P_τ'.  The mean a_m of a(u) between v and u_τ has |a_m − ā| ≤ ω, and L_m p = 0 with
L_m = 1 − a_m K*.  From there on the proof is that of Lemma 16: L_m P_τ' = (a(u_τ) − a_m) u_τ', so
that (1 − Z₁ − sup κ ω) ‖y‖ ≤ 2 |c| sup s ω, and |c| m ≤ |φ(A y)| ≤ ‖y‖ ∫ ρ.  Hence p = 0. ∎

With dashpots the unknown is u itself: u stands for P, ρ for κ, and L_m = 1 − γ k* − Λ*a_m; as ‖Λ‖₁
= 1, both suprema are the same.
"""

from flint import arb, fmpq

from granular_fronts.proofs.balls import above, array, largest

REACH = 16  # shifts are below 1/16 bead, rounded up to cells
FINENESS = 8  # W is a power of 2^(−1/8),
WIDEST, NARROWEST = 4 * FINENESS, 40 * FINENESS  # from 2^(−4) down to 2^(−40)


def unique(front):
    """Theorem B with the largest W that it holds for."""
    near = _Neighbourhood(front)
    front.require("the unknown falls over (−1, 1)", arb(0), near.fall)
    holds, fails = NARROWEST + 1, WIDEST - 1
    while holds - fails > 1:
        middle = (holds + fails) // 2
        holds, fails = (middle, fails) if near.bound(width(middle)) < 1 else (holds, middle)
    if holds > NARROWEST:
        return
    W = width(holds)
    front.require("no other front within W", near.bound(W), arb(1))
    front.numbers["unique_within"] = -above(-W)
    yield (
        "Every bounded solution v with |v − ū| <"
        f" {0.999 * front.numbers['unique_within']:.3e} on the whole line is a translate of u*."
    )


def width(k):
    """Return the k-th distance that is tried."""
    return arb(2) ** fmpq(-k, FINENESS)


class _Neighbourhood:
    """What Theorem B needs of a front, on its cells and, first and last, behind and ahead."""

    def __init__(self, front):
        n, self.front = front.n, front
        reach = -(-n // REACH)
        self.H, slopes = arb(fmpq(reach, n)), array([front.slope_error] * reach)
        slopes = [*slopes, *front.slopes, *slopes]
        steep = [largest(slopes[j : j + 2 * reach + 1]) for j in range(len(front.slopes))]
        behind, ahead = front.outer_kappa
        self.steep = [steep[0], *steep, steep[-1]]
        self.kappa = [behind, *front.kappa, ahead]
        self.errors = [kappa * front.r for kappa in self.kappa]
        self.low, self.high = [arb(1), *front.u_low, arb(0)], [arb(1), *front.u_high, arb(0)]
        start, end = ((front.left + side) * n for side in (-1, 1))
        self.inside = range(start, end)
        before = front.u_low - front.kappa * front.r
        after = front.u_high + front.kappa * front.r
        lowest = [-front.unknown(u) for u in before[start - reach : start + reach]]
        highest = [front.unknown(u) for u in after[end - reach : end + reach]]
        self.fall = -largest(lowest) - largest(highest)
        self.weight = sum((front.rho[j] for j in self.inside), arb(0)) / n / self.fall

    def shift(self, W):
        """Return T."""
        front = self.front
        gaps = (
            front.unknown_gap(front.u_high[j] + self.errors[j + 1].max(W), self.errors[j + 1] + W)
            for j in self.inside
        )
        return sum(gaps, arb(0)) / front.n / self.fall

    def bound(self, W):
        """Return the left side of the inequality of Theorem B."""
        front, T = self.front, self.shift(W)
        if not T < self.H:
            return arb("inf")
        rises = [
            front.rise(low, high, W.max(error + T * steep))
            for low, high, error, steep in zip(
                self.low, self.high, self.errors, self.steep, strict=True
            )
        ]
        inner = largest(kappa * rise for kappa, rise in zip(self.kappa, rises, strict=True))
        outer = largest(steep * rise for steep, rise in zip(self.steep, rises, strict=True))
        return front.Z1 + inner + 2 * self.weight * outer
