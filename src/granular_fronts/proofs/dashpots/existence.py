"""Existence with linear dashpots: near an approximate front there is one.

**Setting.** Λ(s) = 1 − |s| and k(s) = sgn s on |s| < 1, zero elsewhere; ‖Λ‖₁ = 1, ‖k‖₁ = 2; 1 < α,
0 < γ.  A travelling front of James (2021) with β = 1, of speed 1 from u = 1 behind to 0 ahead,
solves u'' = Δ(u₊^α − γ u₊'), that is u = Λ*u₊^α + γ k*u₊ (the equation integrated twice).  Its
positive solutions are those of

    F(u) = u − γ k*u − Λ*u₊^α = 0,      F: L^∞(ℝ) → L^∞(ℝ).

F is C¹, DF(u) h = h − γ k*h − Λ*(a(u) h), a(u) = α u₊^(α−1).  That u > 0 is shown in `ahead`; F is
the equation of dashpots that act in open contacts too.

**Lemma 19.** If u ∈ L^∞ and F(u) = 0, then u is C¹, u' = Λ'*u₊^α + γ k'*u with Λ' = −1_{|s|<1} sgn
s and k' = 2δ₀ − δ₁ − δ₋₁, u'' = Δ(u₊^α − γ u') in the sense of distributions, and u_n(t) = u(n − t)
solves the chain whose contacts exert (u_n)₊^α + γ du_n/dt.  If u > 0 everywhere, u is smooth.
*Proof.* k has bounded variation and Λ is Lipschitz, both with compact support: u is Lipschitz, and
so is u₊^α; then Λ'*u₊^α + γ k'*u is continuous.  Λ'' = δ₁ − 2δ₀ + δ₋₁ = −k'.  Where u > 0 the map
u ↦ u^α is smooth, so u ∈ C^m gives u' ∈ C^m. ∎

**Approximation.** ū = 1 for ξ < −ℓ, 0 for ξ > m, a polynomial on each of the cells of width h =
1/n between (continuity is not needed); ā = a(ū), L = DF(ū).  P̄ is a polynomial on the same cells,
1 behind and 0 ahead of them, and ω ≥ |ū₊^α − P̄|.  They are the Taylor polynomial about the middle
of a cell and its remainder over the cell. Where ū may be below 1e-11 they are 0 and sup ū₊^α.  Then
û = γ k*ū + Λ*P̄ = ΔP₂ − γ ΔU₁, with antiderivatives U₁ of ū and P₂, the second one, of P̄, is a
polynomial on each cell as well, 1 for ξ < −ℓ − 1 and 0 for ξ > m + 1; as ‖Λ‖₁ = 1,

    Y₀ = sup |ū − û| + sup ω ≥ ‖F(ū)‖.

**Theorem 20.** Let A: L^∞ → L^∞ be bounded and linear, Y₀ ≥ ‖F(ū)‖, Z₁ ≥ ‖1 − L A‖, ρ(ξ) ≥ |(A
y)(ξ)| for all ‖y‖ ≤ 1, and Z₂(r) ≥ ρ(ξ) |a(ū(ξ) + w) − a(ū(ξ))| for all ξ and |w| ≤ ρ(ξ) r.  If Y₀
< (1 − Z₁ − Z₂(r)) r for some r > 0, there is exactly one ‖y*‖ ≤ r such that u* = ū + A y* is a
zero of F.  Then |u* − ū| ≤ ρ r, and

    |u*' − û'| ≤ 4γ r sup ρ + 2 sup (ω + a(ū₊ + ρ r) ρ r).

*Proof.* N(y) = y − F(ū + A y) has the derivative 1 − L A + Λ*((a(ū + A y) − a(ū)) A ·), of norm at
most q = Z₁ + Z₂(r) < 1 on the ball of radius r, as ‖Λ‖₁ = 1, and ‖N(0)‖ ≤ Y₀.  So N maps the ball
into itself and contracts it.  u*' − û' = γ k'*(u* − ū) + Λ'*((u*)₊^α − P̄), where k' has mass 4
and Λ' mass 2, and |(u*)₊^α − ū₊^α| ≤ a(ū₊ + ρ r) ρ r as a(u) increases. ∎

**Lemma 21 (limits).** If A maps the y that vanish at both ends (ess sup of |y| over |ξ| > X tends
to 0) to such functions, then u* → 1 at −∞ and → 0 at +∞.
*Proof.* Those y form a closed subspace, and N maps it to itself: F(ū + z) vanishes at both ends if
z does, since ∫Λ = 1 and ∫k = 0. ∎  The A of `right_inverse` does, as all its kernels have compact
support.

Z₂ is bounded as in `granular_fronts.proofs.existence`.  α and γ may be in intervals, on which ū and
the kernels g, g₊ and the matrix H of A do not depend. All bounds hold for each of them.
"""

from granular_fronts.fronts.solve import evaluate_front
from granular_fronts.proofs.existence import DEGREE, cell_nodes, to_powers


def approximate_strain(front, behind, ahead, n):
    """Return ū of a computed front as coefficients in t ∈ (−1, 1) on cells of [−behind, ahead]."""
    return evaluate_front(front, cell_nodes(behind, ahead, n)) @ to_powers(DEGREE + 1).T
