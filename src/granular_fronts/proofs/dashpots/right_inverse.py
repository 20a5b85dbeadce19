"""A right inverse with dashpots: the operator A, and bounds of 1 − L A and of A.

Notation of `existence`.  Far behind, ā is near α and L near the convolution δ − f, f = γ k + α Λ;
that is α times the kernel K of `granular_fronts.proofs.existence` with γ/α for γ.  Far ahead, ā is
near 0 and L near δ − γ k.  As with β = α, A is made of approximate inverses of both and of a
matrix between them, glued by splitting the *source*.

Integers c, p, q behind and p₊, q₊ ahead; b = c + q + 1; the window is [−b, M], cut into W cells of
width h = 1/n with middles x_i; p₊ ≤ M + b.  Write y = y₋ + y_w + y₊ for ξ < −b, −b < ξ < M, ξ > M,
T y = γ k*y + Λ*(ā y), so that L = 1 − T.  Given g ∈ L¹, zero outside [−p, q], g₊ ∈ L¹, zero
outside [−p₊, q₊], numbers ā_i, and any real W×W matrix H, let

    (R y_w)_i = γ (k*y_w)(x_i) + Σ_j ā_j ∫ Λ(x_i − η) y_w(η) dη over cell j,
    v = H R y_w, constant on cells,
    s₋ = T(y_w + v) on ξ < −b,  s₊ = T(y_w + v) on ξ > M,  else 0,
    d = ((1 − L_h H) R y_w)_i on the cells i of the first bead, else 0,
    A y = (δ + g)*(y₋ + s₋ + d) + y_w + v + (δ + g₊)*(y₊ + s₊),

L_h = 1 − (γ κ_{i−j} + λ_{i−j} ā_j), κ_m and λ_m the integrals of k and Λ over |s − mh| < h/2.
What the window sends behind or ahead becomes a source there.

**Defect behind.** Let e = g − f − f*g and ε = sup |ā/α − 1| over ξ < −c.  For a source σ on ξ < −b
+ 1, (δ + g)*σ lives on ξ < −b + 1 + q = −c, so that

    L (δ + g)*σ = σ + e*σ − Λ*((ā − α) (δ + g)*σ),

a defect of at most (‖e‖₁ + α ε (1 + ‖g‖₁)) ‖σ‖.

**Defect ahead.** Let e₊ = g₊ − γ k − γ k*g₊.  For a source σ on ξ > M, (δ + g₊)*σ lives on ξ > M −
p₊, and L leaves σ + e₊*σ − Λ*(ā (δ + g₊)*σ), a defect of at most (‖e₊‖₁ + (1 + ‖g₊‖₁) sup ā) ‖σ‖,
the supremum over ξ > M − p₊.

**Window.** With f_w = y_w + v, supported in the window:
 * on ξ < −b, L f_w = −s₋, and on ξ > M, L f_w = −s₊, for which both convolutions make up;
 * on cell i, y_w − L f_w = [T f_w − (T_h f_w)(x_i)] + ((1 − L_h H) R y_w)_i, where T_h has ā_j in
   place of ā on cell j, as R has, and d removes the second term on the first bead.

The three sources have disjoint supports, and with w = 1 + v bounding f_w, where v is its norm,

    Z₁ = max_i (inner_i + rest_i 1_{i ≥ n}) + gain (‖e‖₁ + α ε (1 + ‖g‖₁))
         + gain₊ (‖e₊‖₁ + (1 + ‖g₊‖₁) sup ā),

 * rest_i = Σ_j |1 − L_h H|_ij (2γ + Σ_m λ_{j−m} ā_m), as the bracket bounds |R y_w|_j;
 * the norm of v on cell i is ∫|Φ_i|, Φ_i(η) = Σ_j H_ij (γ k(x_j − η) + ā_m Λ(x_j − η)) for η in
   cell m.  The kernels k and Λ' jump at middles of cells, so Φ_i is linear on each half of a cell.
   Its slope is at most ā_m Σ |H_ij| over the j with x_j within 1 of that half.  Over the length
   h/2, ∫|Φ_i| is at most h/2 |Φ_i| at the edge of the cell + h²/8 of that;
 * for |ξ − x_i| < h/2, as k jumps by 2 at 0 (met in cell i) and by 1 at ±1 (in the cells i ± n), Λ
   has slopes ±1, and with osc_j = sup |ā − ā_j| over cell j,

       inner_i = γ h/2 (2 w_i + w_{i−n} + w_{i+n}) + h²/2 Σ_{|j−i| ≤ n} w_j sup ā
                 + Σ_j λ_{i−j} osc_j w_j;

 * gain = max(1 + σ₋, rest_i over the first bead), gain₊ = 1 + σ₊, where |s₋| ≤ σ₋ = (γ + sup ā/2)
   sup w over the first bead.  For |−γ + (1 − |s|) ā| has at most this integral over one bead. On
   the last bead σ₊ is the same.

**Norms.** On cell i, |(A y)(ξ)| is at most ρ_i = w_i + rest_i 1_{i < n} + gain ∫|g| over s > ξ + b
− 1 + gain₊ ∫|g₊| over s < ξ − M; behind the window it is at most gain (1 + ‖g‖₁), ahead of it
gain₊ (1 + ‖g₊‖₁).

**Lemma 22 (the linearisation).** L* = DF(u*) is onto and its kernel is spanned by u*'.

*Proof.* As in Lemma 5 of `consequences`, L*A = 1 − DN(y*) is invertible by Theorem 20, L* is onto,
A is injective with closed range, and L^∞ = ker L* ⊕ Ran A. A differs from y ↦ y + g*(1_{ξ<−b} y) +
g₊*(1_{ξ>M} y) by a compact operator: y_w ↦ v and d have finite rank, and s₋, s₊ live on (−b − 1,
−b) and (M, M + 1) with a common Lipschitz constant. In the splitting of L^∞ at −b and M this
operator is triangular, since q ≤ b and p₊ ≤ M + b. Its diagonal holds the identity and the
Wiener–Hopf operators of 1 + g and 1 + g₊. Their indices in L^∞ of a half line are ± the winding
numbers of 1 + ĝ and 1 + ĝ₊ (Lemma 6 of `consequences`; as there, both have inverses of the kind 1 +
l̂). (1 + ĝ)(1 − f̂) = 1 + ê with |ê| < 1, and 1 − f̂(iω) = 1 − α (1 − i (γ/α) ω) sinc²(ω/2) winds
once (Lemma 5); (1 + ĝ₊)(1 − γ k̂) = 1 + ê₊ with |ê₊| < 1, and 1 − γ k̂(iω) = 1 + iγω sinc²(ω/2)
does not wind. So |ind A| = 1; A being injective, dim ker L* = codim Ran A = 1. As u and u₊^α are
Lipschitz, u' = γ k*u' + Λ*(a(u) u') is a bounded element of the kernel. It is not 0, as u is not
constant. ∎

So the front is isolated up to shifts and continues to a C¹ branch in γ, as after Lemma 5.
"""

import numpy as np

from granular_fronts.proofs import right_inverse


def ahead_inverse(gamma, n, lost):
    """Return the kernel g₊ on beads [−p₊, q₊]; p₊; q₊."""
    signs = np.sign(np.arange(-2 * n, 2 * n) + 0.5)
    halves = np.concatenate([[0], signs / (2 * n), [0]])
    kernel = gamma * signs[n:-n], gamma * (halves[::2] + halves[1::2])
    return right_inverse.trimmed([right_inverse.periodic_inverse(*kernel, n)], n, lost)


def window_correction(stiffness, gamma, n, zero, longer):
    """Return H − 1 on the last cells, as with β = α, from ā in the middles of a longer window."""
    (_, sign), (_, tent) = (right_inverse.kernel(g, 0.0, n) for g in (1.0, 0.0))
    jump, tent = (right_inverse.toeplitz(f, len(stiffness)) for f in (sign - tent, tent))
    return right_inverse.solve_window(gamma * jump + tent * stiffness, n, zero, longer)
