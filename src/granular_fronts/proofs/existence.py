"""Existence: near an approximate front there is one, and only one of a certain kind.

**Setting.** K(s) = 1 − |s| + γ sgn s on |s| < 1, zero elsewhere; ‖K‖₁ = 1 + γ² for γ ≤ 1 and 2γ
for γ ≥ 1; 1 < α, 0 < γ.  A travelling front of James (2021) with β = α, of speed 1 from u = 1
behind to 0 ahead, solves u'' = (1 − γ d/dξ) Δ u₊^α, that is u = K*u₊^α (the equation integrated
twice).  With P = u₊^α this is a zero of

    Q(P) = P − (K*P)₊^α,      Q: L^∞(ℝ) → L^∞(ℝ).

Q is C¹, DQ(P) h = h − a(K*P) K*h, a(u) = α u₊^(α−1).

**Lemma 1.** If P ∈ L^∞ and Q(P) = 0, then u = K*P is C¹, u' = K'*P with K' = −1_{|s|<1} sgn s + γ
(2δ₀ − δ₁ − δ₋₁) of total mass 2 + 4γ, P = u₊^α, u'' = (1 − γ d/dξ) Δ u₊^α in the sense of
distributions, and u_n(t) = u(n − t) solves the chain.  If u > 0 everywhere, u is smooth.
*Proof.* K*P is Lipschitz, hence so is P = u₊^α, and K'*P is continuous.  K'' = (1 − γ d/ds)(δ₁ −
2δ₀ + δ₋₁).  Where u > 0 the map u ↦ u^α is smooth, so u ∈ C^k gives P ∈ C^k and u' = K'*P ∈ C^k. ∎

**Approximation.** P̄ = 1 for ξ < −ℓ, 0 for ξ > m, a polynomial on each of the cells of width h =
1/n between (continuity is not needed); ū = K*P̄, also polynomial on cells, 1 for ξ ≤ −ℓ − 1 and 0
for ξ ≥ M = m + 1; ā = a(ū), L = DQ(P̄) = 1 − ā K*.  With the second differences Δ over one bead and
the first and second antiderivatives P₁, P₂ of P̄, ū = ΔP₂ − γ ΔP₁.  For an interval of γ, γ₀ − δ to
γ₀ + δ, let γ = γ₀ + s δ and P̄ = P̄₀ + s P̄₁ + … + s^d P̄_d, P̄_k = 0 outside (−ℓ, m) for k ≥ 1;
then ū is a polynomial in s of degree d + 1.  α may be in an interval too, on which P̄ does not
depend.  What follows is claimed for each α and γ by itself, with bounds that hold for all.

**Theorem 2.** Let A: L^∞ → L^∞ be bounded and linear, Y₀ ≥ ‖Q(P̄)‖, Z₁ ≥ ‖1 − L A‖, κ(ξ) ≥ |(K*A
y)(ξ)| for all ‖y‖ ≤ 1, and Z₂(r) ≥ κ(ξ) |a(ū(ξ) + w) − a(ū(ξ))| for all ξ and |w| ≤ κ(ξ) r.  If Y₀
< (1 − Z₁ − Z₂(r)) r for some r > 0, there is exactly one ‖y*‖ ≤ r such that P* = P̄ + A y* is a
zero of Q.  Then |P* − P̄| ≤ ρ r and |u* − ū| ≤ κ r, where ρ(ξ) is the norm of y ↦ (A y)(ξ), and
|u*' − ū'| ≤ (2 + 4γ) r sup ρ.
*Proof.* N(y) = y − Q(P̄ + A y) has the derivative 1 − L A + (a(ū + K*A y) − a(ū)) K*A, of norm at
most q = Z₁ + Z₂(r) < 1 on the ball of radius r, and ‖N(0)‖ ≤ Y₀. By the mean value theorem N maps
the ball into itself and contracts it. ∎ Neither injectivity of A nor its index is used, and no
phase condition.  The theorem does not say that P* is the only solution near P̄: its translates are
others.

**Lemma 3 (limits).** If A maps the y that vanish at both ends (ess sup of |y| over |ξ| > X tends
to 0) to such functions, then P*, u* → 1 at −∞ and → 0 at +∞.
*Proof.* Those y form a closed subspace, and N maps it to itself: P → 1 implies K*P → 1 since ∫K =
1. ∎

**Z₂.** For 1 < α ≤ 2, a(u) is zero for u ≤ 0, increasing and concave for u ≥ 0.  Over u ≥ u₋ and
|w| ≤ W the largest |a(u + w) − a(u)| is at most a(p) − a(p − W), p = max(u₋, W).  For α ≥ 2, a(u)
is convex on ℝ, and over u ≤ u₊ it is a(u₊ + W) − a(u₊).

**Y₀.** On a cell, F = P̄ − ū^α is expanded in s about 0 up to s^d.  The remainder is s^(d+1) times
a Taylor coefficient of order d + 1 at another s, bounded over the whole cell and −1 ≤ s ≤ 1.  Each
of the other coefficients is expanded about the middle of the cell.  In t ∈ (−1, 1) the remainder
after order m is t^m times a Taylor coefficient of order m at a point of the cell.  If P̄
interpolates fronts at γ in the interval, Y₀ is of order δ^(d+1).  Where ū may be below 1e-7 the
bound is sup |P̄| + sup ū₊^α.
"""

import numpy as np

from granular_fronts.fronts.solve import evaluate_front

DEGREE = 9  # of the approximate front on a cell, in t


def chebyshev_nodes(count):
    """Return where polynomials on (−1, 1) interpolate well."""
    return np.cos(np.pi * (np.arange(count) + 0.5) / count)


def to_powers(count):
    """Return the matrix that takes values at the Chebyshev nodes to coefficients of powers."""
    return np.linalg.inv(np.vander(chebyshev_nodes(count), increasing=True))


def cell_nodes(behind, ahead, n):
    """Return ξ at the Chebyshev nodes of each of the cells of [−behind, ahead]."""
    middles = (np.arange((behind + ahead) * n) + 0.5) / n - behind
    return middles[:, None] + chebyshev_nodes(DEGREE + 1) / (2 * n)


def approximate(fronts, behind, ahead, n):
    """Return P̄ from computed fronts: coefficients in s, on the cells of [−behind, ahead], in t.

    The fronts belong to the Chebyshev nodes in s; s and t are in (−1, 1).
    """
    xi = cell_nodes(behind, ahead, n)
    values = [np.maximum(evaluate_front(f, xi), 0.0) ** f.attrs["alpha"] for f in fronts]
    return np.einsum("ks,sct,mt->kcm", to_powers(len(fronts)), values, to_powers(DEGREE + 1))
