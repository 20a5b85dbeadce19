"""Spectral stability: by hand where the front is monotone, else by one scalar inequality.

Notation of `existence`; u = u* > 0, k = ‖K‖₁, Δ is the second difference over one bead, and in
formulas $a$ is a(u).

**Setting.** A small change w of the strains of a front in the chain obeys

    ẇ_n = d_n + γ Δh_n,      ḋ_n = Δh_n,      h_n = a_n w_n,      a_n(t) = a(u(n − t)).

T lets y = (w, d) move for one bead-time and follows by one bead: (T y)_n is y_{n+1} at t = 1.  X_κ,
κ > 0, has the squared norm Σ (1 + e^(2κn)) (|w_n|² + |d_n|²).  Its weight is needed ahead.  In the
untouched chain z^n, |z| < 1, is an eigenvector, and without the weight all |z| = 1 are in the
spectrum.  Shifts and a(u) are bounded, so T is bounded in X_κ.  Translation is y₀ = (u', −u'' − γ
Δ(a u')) at t = 0, with T y₀ = y₀.

**Condition (q).** q ≥ 0 increases on ℝ (jumps upwards are allowed), q = 1/(2a) ahead of a place
from which on u' < 0, and almost everywhere

    q' ≥ (a/γ) (q − 1/(2a))².

If u' < 0 on ℝ, then q = 1/(2a) is such a function: the right-hand side is 0.

**Lemma 27.** The z ≠ 1, |z| ≥ 1, in the spectrum of T are eigenvalues.  Their eigenvectors decay
exponentially behind.

*Proof.* Let T₋ and T₊ have α and 0 for a_n everywhere.  On waves e^(iθn) the operator T₋ is the
matrix e^(iθ) exp(M) with M (w, d) = (d − αγω² w, −αω² w).  Its eigenvalues are e^(iθ + σ), σ² + αγ
ω² σ + α ω² = 0, ω² = 2 − 2 cos θ.  They are inside the unit circle but for ω = 0, where they are 1.
So T₋ − z has a bounded inverse on ℓ², and the same one on ℓ² with the weight e^(νn), |ν| small. (T₊
y)_n = (w + d, d)_{n+1} has the spectral radius e^(−κ) with the weight e^(κn).  Let χ₋ be 1 for n ≤
0, else 0, and χ₊ = 1 − χ₋.  χ± (T − T±), (T − T±) χ± and the commutators of T and T± with χ± are
compact.  For those of the shift have finite rank.  By Duhamel's formula the rest are integrals of
flows around Δ(a_n − α)χ₋, Δa_n χ₊ or [Δ, χ₋] a_n.  In the last a_n may be α or 0.  As a_n → α, 0,
those are limits of operators of finite rank.  So χ₋ (T₋ − z)^(−1) χ₋ + χ₊ (T₊ − z)^(−1) χ₊ inverts
T − z on both sides, up to compact operators.  These z are a connected set, and T − z is invertible
for large |z|.  Hence T − z has the index 0, and is invertible if it has no kernel.  If T y = z y,
then (T₋ − z) χ₋ y = (T₋ − T) χ₋ y + [T, χ₋] y.  By Lemma 10 with a small θ > 0 the right-hand side
decays exponentially behind.  So does y, by the inverse with a weight. ∎

**Lemma 28 (balance).** Let T y = z y, |z| ≥ 1, z = e^λ, where y decays exponentially behind, and Σ
w_n = 0 if z = 1.  Then y = 0 if (q) holds.

*Proof.* w_n(t) = e^(λt) W(n − t) and d_n(t) = e^(λt) D(n − t) for all t, with (λ − ∂)W = D + γ Δh,
(λ − ∂)D = Δh, h = a(u) W.  W and D decay exponentially at both ends.  The sums s = Σ D(ξ + n), r =
Σ n D(ξ + n), m = Σ W(ξ + n), p = Σ n W(ξ + n) fulfil (λ − ∂)s = (λ − ∂)r = 0, (λ − ∂)m = s, (λ −
∂)p = r.  Further s(ξ + 1) = s(ξ), r(ξ + 1) = r(ξ) − s, m(ξ + 1) = m(ξ) and p(ξ + 1) = p(ξ) − m.  A
multiple of e^(λξ) with period 1 is 0 if z ≠ 1; then s = r = m = 0.  For z = 1, let λ = 0.  Then s
and r are constant, so s = 0, and m is constant, m = 0.  So p has period 1 and the slope −r, r = 0.
Hence

    x(ξ) = Σ W(ξ + n) over n ≥ 0,      j(ξ) = Σ n D(ξ + n) over n ≥ 1

decay exponentially at both ends too.  W = x − x(· + 1), D = Δj, and with J = j + γh

    (λ − ∂)j = h,      (λ − ∂)x = J(· − 1) − J.

Ahead a(u) falls, so |j| ≤ a(ξ) ∫ |W| over (ξ, ∞).  Hence q |j|² → 0 there and it can be integrated,
like a(u) |W|².  With Λ = Re λ ≥ 0, by parts and as h̄/a = W̄,

    Λ ∫|x|² = Re ∫ x̄ (λ − ∂)x = −Re ∫ J W̄ = −∫ (Re j h̄ + γ |h|²)/a,
    2Λ ∫ q |j|² = 2 Re ∫ q j h̄ − ∫ |j|² dq.

The sum of both is, with b = (1 − 2qa)/(2γ) and (q),

    Λ ∫ (|x|² + 2q |j|²) = −∫ (γ/a) |h + b j|² + ∫ (a/γ) (q − 1/(2a))² |j|² − ∫ |j|² dq
                         ≤ −∫ (γ/a) |h + b j|².

Both sides are 0.  Hence h = −b j almost everywhere, j' = (λ + b) j, and ahead, where b = 0, |j| is
a multiple of e^(Λξ) that decays.  So j = 0 there, thus everywhere, h = 0, W = 0 and D = Δj = 0. ∎

**Lemma 29 (spectral stability).** Let (q) hold.  Then no z ≠ 1 with |z| ≥ 1 is in the spectrum of T
in X_κ.  The eigenvalue 1 is simple: T y = y only for y = c y₀, and T y = y + y₀ for no y in X_κ.

*Proof.* Lemmas 27 and 28 leave z = 1.  Let T y = y, with W, D as above, λ = 0.  They vanish at both
ends, and −W' = D + γ Δh, −D' = Δh.  So W'' = (1 − γ∂) Δh = (K*h)'', and as W and K*h are bounded
and vanish ahead, W = K*h.  W − α K*W = K*((a − α)W), so that W and h decay exponentially behind as
in Lemma 10.  So does D.  The sum m of y is constant, as above; that of y₀ is ∫u' = −1.  So some y −
c y₀ has the sum 0, and is 0 by Lemma 28.  Let T y = y + y₀.  Then w_n(t) = W(n − t) + t u'(n − t),
u' − W' = D + γ Δh and −u'' − γ Δ(a u') − D' = Δh.  Thus W'' = (K*h + f)'' with f = 2u − γ Δ∫ P over
(ξ, ∞).  All vanish ahead: W = K*h + f.  But W and h vanish behind, where f → 2. ∎

**Linear stability.** For all x_n and j_n with ẋ_n = J_{n−1} − J_n, j̇_n = h_n = a_n (x_n − x_{n+1})
and J = j + γh the same sum at one time says that Σ (|x_n|² + 2q(n − t) |j_n|²), if it is finite,
does not grow.

**Remark on sound.** If W is only bounded, W → c behind and 0 ahead, then c = αc + 2.  Such a W is
minus the change of the front with its speed.  Let V → 0 ahead be the velocity in W: u' − W' = V(ξ)
− V(ξ + 1) gives V → c − 1 = −(α + 1)/(α − 1).  A sound wave away from the front has V = −α^(1/2) c
> 0.  So T y = y + y₀ has no solution that is such a wave behind, either.

**Lemma 30 (one front that falls).** For α > 1, γ > 0 any two fronts with u' ≤ 0 on ℝ are translates
of each other.

*Proof.* Both are positive: if u(ξ) = 0 first at ξ, then u = 0 ahead as it falls, but u(ξ) > 0 as K
> 0 on (0, 1).  Let u₁, u₂ be shifted so that W = u₁ − u₂ has ∫W = 0; by Lemmas 8 and 10 both tails
can be integrated. h = u₁^α − u₂^α = A W with the mean A of a(u) between u₁ and u₂.  Like both, A
falls.  W = K*h gives ∫h = 0.  So j = ∫ h over (ξ, ∞), J = j + γh and x = ∫ J over (ξ − 1, ξ) decay
at both ends.  By parts W = x − x(· + 1), as K' = −sgn s on |s| < 1 and γ (2δ₀ − δ₁ − δ₋₁).  With U
= max(u₁, u₂), U^(α−1) ≤ A and |j| ≤ U^(α−1) ∫ U over (ξ, ∞), so that j²/A → 0.  So the balance of
Lemma 28 holds with A for a(u), λ = 0 and q = 1/(2A), and h = 0. ∎

**Dashpots.** With β = 1, ẇ_n = d_n + γ Δw_n and y₀ = (u', −u'' − γ Δu'), and (q) has a²/γ in place
of a/γ.  Let κ < μ of Lemma 25.  Then Lemmas 27 to 31 hold with these changes.  In Lemma 27, σ² + γ
ω² σ + α ω² = 0.  T₊ has e^ζ and e^(ζ + γ (2 cosh ζ − 2)), ζ = −κ + iθ, in its spectrum, at most
e^(−κ + 2γ (cosh κ − 1)) < 1 in modulus.  J = j + γW, so that γ |W|² is lost in place of γ |h|²/a,
and γ/a takes the place of γ.  W = Λ*h + γ k*W, with f = 2u − γ Δ∫ u; tails ahead can be integrated
by Lemma 23.  In Lemma 31, K and k belong to γ/α, N is convolved with Λ, ‖Λ‖₁ ≤ k, and 3γ is 3γ/ā.

**The check.** It makes q from behind.  Let s(x) = sup |u − 1| over ξ < x, s₀ = s(x₀) at the first
cell, B = α (α − 1) (1 − s₀)^(−|α−2|), g, p and e as in `right_inverse`, ε = ‖e‖₁.

**Lemma 31.** If (1 + ‖g‖₁) (k B s₀/2 + ε^m (1 + αk)) ≤ (1 − ε)/2 and R = m (p + 1), then s(x − R) ≤
s(x)/2 for x ≤ x₀.  Let c = (α − 1) (1 − s₀)^(−α)/(2α) and ā = α (1 + s₀)^(α−1).  If 16 c ā R s₀ <
3γ, some q with (q) on ξ < x₀ ends with q ≤ 1/(2α) + c s₀.

*Proof.* z = u − 1 solves z = K*(αz + N), |N| ≤ B z²/2.  With z_x = z 1_{ξ<x}, s = s(x), F = z_x − α
K*z_x is K*N for ξ < x − 1, 0 for ξ > x + 1, and at most (1 + αk) s between.  (δ + e)*z_x = (δ +
g)*F.  Of the part between, (δ + g) and the first m terms of Σ (−e)^i reach back by m (p + 1) − 1 at
most.  So z_x is at most (1 + ‖g‖₁) (k B s²/2 + ε^m (1 + αk) s)/(1 − ε) for ξ < x − R.  Let I_i be
from x₀ − (i + 1)R to x₀ − i R.  On it |z| ≤ s_i = s₀/2^i, and |1/(2a) − 1/(2α)| ≤ c s_i.  Let q →
1/(2α) behind and q' = 4 c² s_i² ā/γ on I_i.  Up to the end of I_i it rises by at most Σ 4 c² s_l² ā
R/γ over l ≥ i.  That is 16 c² s_i² ā R/(3γ) ≤ c s_i.  So |q − 1/(2a)| ≤ 2 c s_i there. ∎

On a part of a cell q gets a constant slope.  It is at least (1 − 2qa)²/(4γa), the right-hand side,
for all a(u) of the part and all q on it; with dashpots (1 − 2qa)²/(4γ).  Where u' < 0 from a part
on, and q < 1/(2a) on it, q jumps to 1/(2a) and stays there.  For an interval of γ this holds for
each γ.
"""

from flint import arb, fmpq

from granular_fronts.proofs.balls import UNIT

PARTS = 8  # of a cell
MOST_POWERS = 100  # m of Lemma 31
ROOM = 2  # how much steeper q is expected to be at the end of a part than at its beginning


def stable(front):
    """Theorem D, where its condition is shown; nothing else."""
    q = _behind(front)
    first = (front.fall + front.left) * front.n
    for j in range(len(front.u)):
        for part in range(PARTS):
            a = _stiffness(front, j, part)
            if q is None or not a > 0:
                return
            if j >= first and q < 1 / (2 * a):
                front.require("stable: q < 1/(2a) where u' < 0", q, 1 / (2 * a))
                front.numbers["stable"] = 1.0
                yield (
                    "The front is spectrally stable: on the unit circle and outside it the spectrum"
                    " in X_κ is the simple Floquet multiplier 1 of translation (Theorem D)."
                )
                return
            q = _rise(front, q, a)


def _behind(front):
    """Return the bound of q at the first cell, by Lemma 31; None where it does not apply."""
    alpha, (k, norm, defect) = front.alpha, front.rear_norms
    s = front.outer_kappa[0] * front.r
    if not s < 1:
        return None
    curved = k * alpha * (alpha - 1) * (1 - s) ** -abs(alpha - 2) * s / 2
    kept = {m: (1 + norm) * (curved + defect**m * (1 + alpha * k)) for m in range(1, MOST_POWERS)}
    m = next((m for m in kept if kept[m] < (1 - defect) / 2), None)
    if m is None:
        return None
    c = (alpha - 1) * (1 - s) ** -alpha / (2 * alpha)
    steepest = alpha * (1 + s) ** (alpha - 1)
    rise, room = 16 * c * steepest * m * (front.p + 1) * s, 3 * front.damping(steepest)
    if not rise < room:
        return None
    front.require("|u − 1| is halved behind", kept[m], (1 - defect) / 2)
    front.require("q rises little behind", rise, room)
    return 1 / (2 * alpha) + c * s


def _stiffness(front, j, part):
    """Return a on a part of a cell."""
    t = arb(fmpq(2 * part + 1 - PARTS, PARTS)) + UNIT / PARTS
    return front.a(front.u[j](t) + front.u_error[j] * UNIT)


def _rise(front, q, a):
    """Return q after a part of a cell; None where it is not bounded."""

    def slope(q):
        return ((1 - 2 * q * a) ** 2 / (4 * front.damping(a) * a)).upper()

    step = front.h / PARTS
    most = step * (ROOM * slope(q) + step)
    rise = step * slope(q.union(q + most))
    return q + rise if rise < most else None
