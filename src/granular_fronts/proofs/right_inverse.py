"""A right inverse of the linearisation: the operator A, and bounds of 1 − L A, of A and of K*A.

Notation of `existence`.  Far behind, ā is near α and L near the convolution δ − α K; far ahead, ā
= 0 and L is the identity. A is an approximate inverse of each part, glued by splitting the
*source*, so that no commutators arise.

Integers c, p, q; b = c + q + 2; the window is [−b, M], cut into W cells of width h = 1/n with
middles x_i.  Write y = y₋ + y_w + y₊ for ξ < −b, −b < ξ < M, ξ > M.  Given g ∈ L¹, zero outside
[−p, q], and any real W×W matrix H, let

    (R y_w)_i = ā(x_i) ∫ K(x_i − η) y_w(η) dη,        v = H R y_w, constant on cells,
    s = α K*(y_w + v) on (−b − 1, −b), else 0,
    d = ((1 − L_h H) R y_w)_i on the cells i of the first bead, else 0,
    A y = (δ + g)*(y₋ + s + d) + y_w + v + y₊,

L_h = 1 − diag(ā(x_i)) (κ_{i−k}), κ_m = ∫ K over |s − mh| < h/2.  What the matrix leaves undone on
the first bead, and what the window sends behind, becomes a source of the far rear. So the window
need only reach back to where ā is near α, and not where ū is 1.  As g has compact support, A maps y
that vanish at both ends to such functions (Lemma 3).

**Defect.** Let e = g − α K − α K*g, ε = sup |ā/α − 1| over ξ < −c.  For a source σ on ξ < −b + 1,
K*(σ + g*σ) lives on ξ < −b + 1 + q + 1 = −c, where ā = α + (ā − α) and α K*(δ + g) = g − e, so
that

    L (δ + g)*σ = σ + e*σ − (ā/α − 1)(g − e)*σ,

a defect of at most (‖e‖₁ + ε (‖g‖₁ + ‖e‖₁)) ‖σ‖.

With f = y_w + v, supported in the window:
 * on ξ < −b, L f = −(ā/α) s, and the s in A y makes up for it up to (ā/α − 1) s;
 * on cell i, y_w − L f = ā K*f − v_i = [ā K*f − ā(x_i) (K*f)(x_i)] + ((1 − L_h H) R y_w)_i, and d
   removes the second term on the first bead;
 * on ξ > M, ā = 0 and nothing is left.  The source y₊ leaves ā K*y₊ on (M − 1, M).

The three sources have disjoint supports, so that the norms of their contributions at one point
add up:

    Z₁ = max(max_i (inner_i + rest_i 1_{i ≥ n}), ε σ) + gain (‖e‖₁ + ε (‖g‖₁ + ‖e‖₁))
         + ‖K‖₁ sup ā over (M − 1, M),

 * rest_i = ‖K‖₁ Σ_j |1 − L_h H|_ij ā(x_j), as |R y_w|_j ≤ ā(x_j) ‖K‖₁ ‖y‖;
 * the norm of v on cell k is ∫|Φ_k|, Φ_k(η) = Σ_i H_ki ā(x_i) K(x_i − η).  Kinks and jumps of Φ_k
   are at middles of cells, so it is linear about each edge e_j of a cell.  Its slope is at most Σ
   |H_ki| ā(x_i) over |x_i − e_j| < 1, and ∫|linear| over a length h is at most h |middle| + h²/4
   |slope|: v_k = h Σ_j |Φ_k(e_j)| + h/2 Σ_i |H_ki| ā(x_i), as 2n edges are within 1 of x_i;
 * w = v + 1 bounds f; for |ξ − x_i| < h/2, as 1 − |s| has slopes ±1 and K jumps by 2γ at 0 (met in
   cell i) and by γ at ±1 (in the cells i ± n), |K*f(ξ) − K*f(x_i)| ≤ change_i = h/2 [h Σ_{|m| ≤ n}
   w_{i+m} + γ (2 w_i + w_{i−n} + w_{i+n})];
 * inner_i = sup ā change_i + (sup ā − inf ā) Σ_m w_{i−m} ∫|K| over |s − mh| < h/2, as |K*f(x_i)|
   is at most that sum;
 * σ = α sup w over the first bead × ∫|K| over s < 0, which is at most (γ² + (1 − γ)²)/2, bounds s;
   gain = 1 + max(σ, rest_i over the first bead) bounds y₋ + s + d.

**Norms.** On cell i, (A y)(ξ) is bounded by ρ_i = w_i + rest_i + gain ∫|g| over s > ξ + b − 1;
behind the window by gain (1 + ‖g‖₁), ahead by 1.  K*A y is bounded by Σ_m ρ_{i−m} ∫|K| + change_i
with ρ instead of w; or, since ā K*A y = (A y − y) + (1 − L A) y, by (|A y − y| + defect)/inf ā; κ
is the smaller.

For an interval of γ, g = g₀ + s g₁ + … like P̄ in `existence`, H is fixed, and A, whose R, s and d
contain K and ā, depends continuously on γ.  All bounds hold for every γ of the interval.

**Lemma 4 (no bound for all damping).** Let δ − α K have the inverse δ + G with G ∈ L¹.  Then every
bounded A with L A = 1, linear or not, has ‖A y‖ ≥ 1 + ‖G‖₁ − ε for some ‖y‖ ≤ 1, for each ε > 0.

*Proof.* Let y(η) = sgn G(−η), but 1 near 0.  With a small such interval (δ + G)*y ≥ 1 + ‖G‖₁ − ε
near 0.  Let f be A of y moved behind by k, and F be f moved back.  Then |F| ≤ sup ‖A y‖ over the
unit ball.  As ā = α behind −ℓ − 1, F − α K*F = y + E, where E is bounded for all k and E = 0 for ξ
< k − ℓ − 1.  So F = (δ + G)*(y + E), and (δ + G)*E → 0 near 0 as k → ∞. ∎

If ‖1 − L A‖ ≤ Z₁ < 1, A (L A)^(−1) is such an inverse, so that ‖A‖ ≥ (1 − Z₁)(1 + ‖G‖₁).
It is computed, not proved, that ‖G‖₁ grows with ln γ.  Far behind, K*A is G/α.  So no other
unknown helps while u and its perturbations are measured by their maxima: γ = ∞ needs another norm.
It needs other cells too: change_i contains h γ w_i, so that n grows with γ and the rows of H with
γ².

g and H are free: g is the periodic inverse of the discretised δ − α K at γ₀, g₁ half its change
over the interval.  H holds the columns for sources in the window of the solution of the collocation
equations on a longer window.  L_h has a near kernel (translation) and, as D winds once, one
equation too many behind.  So v = 0 is asked for at ξ = 0, and a constant is added to the equations
of the first bead.  In the order used here (constant first, phase condition in the middle)
elimination without further pivoting keeps the exponentially small tail accurate.
"""

import numpy as np
from scipy import fft, linalg


def kernel(gamma, w, n):
    """Return K e^(−ws) at (m + 1/2)/n and its integrals over |s − m/n| < 1/(2n), as floats."""

    def values(s):
        return (1 - abs(s) + np.sign(s) * gamma) * np.exp(-w * s)

    j = (np.arange(-2 * n, 2 * n) + 0.5) / (2 * n)
    bend = (w * w * values(j) + 2 * w * np.sign(j) * np.exp(-w * j)) / (2 * n) ** 2 / 24
    halves = np.concatenate([[0], (values(j) + bend) / (2 * n), [0]])
    return values((np.arange(-n, n) + 0.5) / n), halves[::2] + halves[1::2]


def rear_inverse(alpha, gamma, w, n, lost, half=0.0):
    """Return the kernels g, and where half > 0 also g₁, on beads [−p, q]; p; q."""

    def inverse(at):
        return periodic_inverse(*(alpha * f for f in kernel(at, w, n)), n)

    rows = [inverse(gamma)]
    if half > 0:
        rows.append((inverse(gamma + half) - inverse(gamma - half)) / 2)
    return trimmed(rows, n, lost)


def trimmed(rows, n, lost):
    """Return kernels on beads [−p, q]; p; q.  Beyond lies at most `lost` of the first's ∫|g|."""
    g = rows[0]
    zero = len(g) // 2
    mass = np.cumsum(abs(g)) / n
    first, last = np.searchsorted(mass, (lost, mass[-1] - lost))
    p, q = max(1, -((first - zero) // n)), max(1, -(-(last + 1 - zero) // n))
    return np.array(rows)[:, zero - p * n : zero + q * n], p, q


def periodic_inverse(middles, whole, n, span=200):
    """Return G with δ + g inverse to δ − f, from f in the middles of cells and its integrals.

    Its period is 2 `span` beads, far beyond those on which it is kept.
    """
    cells = 2 * span * n
    source, operator = np.zeros(cells), np.zeros(cells)
    source[np.arange(-n, n)], operator[np.arange(-n, n + 1)] = middles, whole
    return np.fft.fftshift(fft.irfft(fft.rfft(source) / (1 - fft.rfft(operator)), cells))


def toeplitz(whole, cells):
    """Return the matrix of integrals of a kernel over cells about x_i − x_j."""
    n = len(whole) // 2
    offsets = np.subtract.outer(np.arange(cells), np.arange(cells))
    return np.where(abs(offsets) <= n, whole[np.clip(offsets + n, 0, 2 * n)], 0.0)


def window_correction(stiffness, gamma, n, zero, longer):
    """Return H − 1 on the last cells, from ā at middles of a window `longer` cells longer.

    The cell `zero` begins at ξ = 0.
    """
    matrix = toeplitz(kernel(gamma, 0.0, n)[1], len(stiffness))
    return solve_window(stiffness[:, None] * matrix, n, zero, longer)


def solve_window(matrix, n, zero, longer):
    """Return H − 1 on the last cells, from the matrix of T on a longer window."""
    cells = len(matrix)
    system, sources = np.zeros((cells + 1, cells + 1)), np.zeros((cells + 1, cells - longer))
    rows = np.delete(np.arange(cells + 1), zero + 1)
    system[rows, 1:] = np.eye(cells) - matrix
    system[:n, 0] = 1.0
    system[zero + 1, zero + 1] = 1.0
    sources[rows] = np.eye(cells)[:, longer:]
    inverse = linalg.solve(system, sources, check_finite=False)[1 + longer :]
    return inverse - np.eye(cells - longer)
