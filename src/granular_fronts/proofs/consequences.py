"""What follows from an enclosure: the kernel of the linearisation, and the shape of the front.

Notation of `existence`; P = P*, u = u*, S(x) = sup |u| over ξ ≥ x, I(x) = ∫ P over (x − 1, x), and
k = ‖K‖₁ = 1 + γ² for γ ≤ 1, 2γ for γ ≥ 1.

**Lemma 5 (the linearisation).** L* = DQ(P*) is onto and its kernel is spanned by P*'.

*Proof.* L*A = 1 − DN(y*) is invertible, as ‖DN(y*)‖ < 1 by Theorem 2; so L* is onto, A is injective
with closed range, and L^∞ = ker L* ⊕ Ran A.  A differs from y ↦ y + g*(1_{ξ<−b} y) by a compact
operator: y_w ↦ H R y_w and y_w ↦ d have finite rank, and y_w ↦ s maps bounded functions to
functions on (−b − 1, −b) with a common bound and Lipschitz constant.  In the splitting of L^∞ at −b
this operator is triangular, with the identity and the Wiener–Hopf operator 1 + g on the diagonal.
Its index in L^∞ of a half line is ± the winding number of 1 + ĝ (Lemma 6).  As (1 + ĝ)(1 − α K̂) =
1 + ê with |ê| ≤ ‖e‖₁ < 1, 1/(1 + ĝ) = (1 − α K̂)/(1 + ê) is of the kind 1 + l̂, l ∈ L¹ (Neumann's
series), and the number is, up to sign, that of D(iω) = 1 − α K̂(iω) = 1 − α (1 − iγω) sinc²(ω/2).
D(0) < 0; Im D ≥ 0 for ω > 0 with equality only where D = 1; D(−iω) is the conjugate: D winds once.
So |ind A| = 1; A being injective, ind A = −1 and dim ker L* = codim Ran A = 1.  Since P is
Lipschitz (u is C¹ by Lemma 1), u' = K*P' and P' = a(u) u' is a bounded element of the kernel.  It
is not 0, as P is not constant. ∎

**Lemma 6 (index on a half line).** Let f = 1 + k̂ and 1/f = 1 + l̂ with k, l ∈ L¹.  Then y ↦ y +
k*y, cut to (0, ∞), is a Fredholm operator in L^∞(0, ∞), and its index is ± the winding number of f.

*Proof.* Write W(f) for it, and f₊, f₋ for functions c + k̂ with k = 0 on (−∞, 0) or on (0, ∞).
Then W(f₋ f f₊) = W(f₋) W(f) W(f₊).  So W(f±) is invertible if 1/f± is such a function too.
Rational functions r without poles on ℝ are dense, as polynomials times e^(−s) are in L¹(0, ∞).  As
1/f is such a function, 1/r → 1/f as r → f, and f = r (1 + n) with n of norm below 1.  The logarithm
of 1 + n is a power series; cut at 0 it gives 1 + n = f₋ f₊ with inverses.  A factor (ω − z)/(ω − p)
of r is an f₊ or f₋ if z and p are in the same half plane.  Else it is a product of an f₊, an f₋ and
of q = (ω − i)/(ω + i) or 1/q.  So f = f₋ q^κ f₊ with the winding number κ; f₋ and f₊ have none.
One of W(q), W(1/q) is S y = y − 2v, v(x) = ∫ e^(t−x) y(t) dt over (0, x).  As v' = y − v, S y = z
means v' − v = z, v(0) = 0.  This v is bounded if and only if ∫ e^(−t) z(t) dt = 0, so S has index
−1.  The other one, y − 2 ∫ e^(x−t) y(t) dt over (x, ∞), is its left inverse, of index 1. ∎

**Isolation.** The front is isolated up to shifts.  Let φ vanish on Ran A with φ(P') = 1.  For a
solution P₁ near P, τ ↦ φ(P₁(· + τ) − P) has a slope near 1, as P₁' = a(u₁) K'*P₁ is near P' and P'
is uniformly continuous.  So it is 0 for some small τ.  Then P₁(· + τ) = P + A y with a small y.  As
‖y*‖ < r, it is P by the uniqueness of Theorem 2.  The front continues to a C¹ branch in γ, by the
implicit function theorem for P̄ + A y in the space of y that vanish at both ends.

**Lemma 7 (ahead).** Let u > 0 on (x₁ − 1, x₁], s = S(x₁)^(α−1), k s < 1 and

    (1 + 2γ)(1 + γ) s < 1 − k s,      γ (1 + γ) s/2 < 1 − k s.

Then u > 0 and u' < 0 on [x₁, ∞).

*Proof.* Let x ≥ x₁ and I = I(x).  For ξ ≥ x the part of u(ξ) = ∫ K(ξ − η) P(η) dη with η < x is
between 0 and (1 + γ) I, the rest at most k S^α in modulus: S(x) ≤ (1 + γ) I/(1 − k S(x)^(α−1)).
The negative part of K has mass at most γ²/2 (for γ > 1 it has γ − 1/2 ≤ γ²/2), hence u(x) ≥ γ I −
γ²/2 S^α.  Derivatives: u'(x) = −I + ∫₀¹ P(x + s) ds + γ (2 P(x) − P(x − 1) − P(x + 1)) ≤ −I + (1 +
2γ) S^α.  With S^α ≤ s (1 + γ) I/(1 − k s) both conditions give u(x) > 0 and u'(x) < 0 if I(x) > 0.
At a first zero x > x₁ of u we would have I(x) > 0, so there is none. ∎

**Normalisation.** A translate of a front is a front.  Let u' ≤ −m < 0 for |ξ| ≤ h, let d = |u(0) −
1/2| < m h, and u' < 0 on an interval [x₀, ∞) with x₀ ≤ −2h.  Then u = 1/2 at one ξ₀ ≥ x₀ only, and
|ξ₀| ≤ d/m.  Amplitudes and families are those of u(· + ξ₀), the translate that is 1/2 at 0.

**Lemma 8 (double exponential tail).** Under the conditions of Lemma 7, ln(−ln u(x))/x → ln α as x →
∞.

*Proof.* Where x > x₁ + 1, u decreases on [x − 1, ∞), so u(x) ≤ k u(x − 1)^α.  Below, u(x) ≥ c I(x)
with c > 0 by the second condition, and I(x) ≥ κ u(x − 1 + κ)^α for 0 < κ < 1.  For v = −ln u → ∞
this reads v(x) ≥ α v(x − 1) − C, so lim inf ln v/x ≥ ln α, and v(x) ≤ α v(x − 1 + κ) + C_κ, so lim
sup ln v/x ≤ ln α/(1 − κ) for every κ. ∎

**Lemma 9 (inverses with weights).** Let k have bounded variation and compact support, and let f(λ)
= 1 − k̂(λ), k̂(λ) = ∫ k(s) e^(−λs) ds, have no zero with v ≤ Re λ ≤ w.  Then δ − k has an inverse δ
+ G with ∫ |G| (e^(−vs) + e^(−ws)) ds < ∞.

*Proof.* By parts, k̂ = O(1/|Im λ|) in each strip.  So f → 1 far up and down, and for some ε > 0
there is no zero with v − ε ≤ Re λ ≤ w + ε.  There 1/f − 1 − k̂ = k̂²/f = O(1/|Im λ|²).  Its inverse
transform H is the same on all lines of the strip, by Cauchy's theorem.  On the line Re λ = x it is
O(e^(xs)).  The outer lines bound H by e^((v − ε)s) for s > 0 and by e^((w + ε)s) for s < 0.  Let G
= k + H. ∎

**Lemma 10 (behind).** If D has no zero with 0 < Re λ ≤ θ, then u − 1 = O(e^(θξ)) as ξ → −∞.

*Proof.* z = u − 1 → 0 solves z − α K*z = K*N(z), |N(z)| ≤ C z² where z is small.  D ≠ 0 for 0 ≤ Re
λ ≤ θ, so δ − α K has an inverse δ + G with ∫ |G| (1 + e^(−θs)) ds < ∞ (Lemma 9).  With s(x) = sup
|z| over ξ < x, cutting at x leaves z 1_{<x} − α K*(z 1_{<x}) = K*(N 1_{<x}) + E, where |E| ≤ C s(x
+ 1) on [x − 1, x + 1] and E = 0 elsewhere: s(x − d) ≤ C s(x + 1)² + C s(x + 1) ∫|G| over (−∞, 1 −
d) ≤ s(x + 1)/2 for large d and −x.  So z = O(e^(rξ)) for some r > 0.  Then N = O(e^(2rξ)), and as δ
− α K is invertible with the weight e^(−wξ) for 0 ≤ w ≤ θ, z = O(e^(min(2r, θ) ξ)); finitely many
steps give θ. ∎
"""

from flint import arb, fmpq

from granular_fronts.proofs.balls import NotProvedError, above, bounds, largest, power


def shape(front):
    """Positivity, decrease on a half line, the tail ahead and the overshoot."""
    low, high = front.u_low - front.u_error, front.u_high + front.u_error
    x1 = _small_from(front, low, high)
    front.require("u > 0 in the window", arb(0), -largest(-low[:x1]))
    front.require("u > 0 behind it", front.outer_kappa[0] * front.r, arb(1))
    fall, slope = x1, []
    while fall and _steepest(front, fall - 1) < 0:
        fall, slope = fall - 1, [*slope, _steepest(front, fall - 1)]
    if slope:
        front.require("u' < 0 in the window", largest(slope), arb(0))
    front.fall = fmpq(fall, front.n) - front.left
    yield (
        f"u* > 0 on the whole line, u*' < 0 for ξ ≥ {front.fall}, and ln(−ln u*)/ξ → ln α as ξ → ∞."
    )
    zero = front.left * front.n
    yield normalise(front, fall, largest(_steepest(front, j) for j in (zero - 1, zero)))
    yield from overshoot(front, [u[0] for u in front.u] - front.u_error)


def _steepest(front, j):
    """Return the upper bound of u*' on a cell."""
    return bounds(front.u[j].derivative() * 2 * front.n)[1] + front.slope_error


def normalise(front, fall, steepest):
    """Return where u* = 1/2, from the first cell on which it falls and u*' next to ξ = 0."""
    zero = front.left * front.n
    front.require("u* falls about 0", arb(fall), arb(zero - 1))
    front.require("u*' < 0 about 0", steepest, arb(0))
    gap = abs(front.u[zero](arb(-1)) - fmpq(1, 2)) + front.kappa[zero] * front.r
    front.shift = (gap / -steepest).upper()
    front.require("u* = 1/2 within a cell of 0", front.shift, arb(1) / front.n)
    front.numbers["shift"] = above(front.shift)
    return (
        f"u* = 1/2 at one ξ₀ ≥ {fmpq(fall, front.n) - front.left} only, and |ξ₀| <"
        f" {1.001 * front.numbers['shift']:.3e}."
    )


def overshoot(front, tops):
    """That max u* > 1, from lower bounds of u* anywhere."""
    top = max(tops, key=lambda u: float(u.lower()))
    if top > 1:
        front.require("overshoot", arb(1), top)
        front.numbers["overshoot"] = -above(-top)
        yield f"max u* > {-above(-top)!r}: the front overshoots."


def _small_from(front, low, high):
    """Return the first cell of the longest half line on which both conditions of Lemma 7 hold."""
    gamma, sup, sides = front.gamma, front.outer_kappa[1] * front.r, None
    for i in range(len(low) - 1, front.n, -1):
        sup = largest([sup, abs(low[i]), abs(high[i])])
        s = power(sup, front.alpha - 1)
        falls, stays = ((1 + 2 * gamma) * (1 + gamma) * s, gamma * (1 + gamma) * s / 2)
        if not (falls < 1 - front.nK * s and stays < 1 - front.nK * s):
            break
        first, sides = i, (falls, stays, 1 - front.nK * s)
    if sides is None:
        raise NotProvedError("the front is not yet small at the end of the window")
    front.require("decrease ahead", sides[0], sides[2])
    front.require("u > 0 ahead", sides[1], sides[2])
    return first
