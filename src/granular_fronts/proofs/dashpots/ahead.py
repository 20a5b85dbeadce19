"""What follows from an enclosure with dashpots: sign and decay ahead, overshoot, and the rear.

Notation of `existence`; u = u*, P = u₊^α, σ(ν) = ν − 2γ (cosh ν − 1), which is concave, positive
from 0 to its zero μ and negative beyond.  By Lemma 19,

    −u' = γ Δu + W,      W(ξ) = ∫_{ξ−1}^ξ P − ∫_ξ^{ξ+1} P,                                      (a)

a heat equation on the lattice, in the frame of the front, and e^(−νξ) leaves −u' − γ Δu = σ(ν)
e^(−νξ).  That a force which vanishes faster than the strain disturbs it little, Lemma 24 shows by
comparison with such exponentials.  Unlike with β = α the tail is exponential.

**Lemma 23.** u = O(e^(−νξ)) as ξ → ∞ for every ν < μ.

*Proof.* With k̂(λ) = ∫ k(s) e^(−λs) ds, Re (1 − γ k̂(−ν + iω)) = 1 − 2γ ∫₀¹ sinh(ντ) cos(ωτ) dτ ≥ 1
− 2γ (cosh ν − 1)/ν = σ(ν)/ν > 0 for 0 < ν < μ, and 1 for ν = 0.  So δ − γ k has an inverse δ + G
with ∫ |G| (1 + e^(νs)) ds < ∞ for each ν < μ (Lemma 9 of `consequences`).  Let s(x) = sup |u| over
ξ > x.  Cutting at x leaves

    u 1_{>x} − γ k*(u 1_{>x}) = 1_{>x} Λ*P + E,                                                 (b)

E = γ k*(u 1_{<x}) on (x, x + 1), −γ k*(u 1_{>x}) on (x − 1, x), 0 elsewhere; |E| ≤ γ s(x − 1),
|Λ*P| ≤ s(x − 1)^α on ξ > x.  Hence s(x + d) ≤ (1 + ‖G‖₁) s(x − 1)^α + γ s(x − 1) ∫ |G| over (d −
1, ∞), which is below s(x − 1)/2 for large d and x, as s → 0: u = O(e^(−κξ)) for some κ > 0.  Then
P = O(e^(−ακξ)), and by (b) u = O(e^(−min(ακ, ν) ξ)); finitely many steps give ν. ∎

**Lemma 24 (comparison).** Let t = ξ − x₁, σ(ν₁) > 0 > σ(ν₂), α ν₁ ≥ ν₂ > 0, and U, V > 0 with

    u e^(ν₁t) ≤ U and −u' e^(ν₂t) ≥ V for −1 ≤ t ≤ 0,
    S (e^ν₁ − 1)/ν₁ < σ(ν₁),  S = sup u₊^(α−1) over t > −1,      2 U^α < −V σ(ν₂).

Then u ≤ U e^(−ν₁t) and −u' ≥ V e^(−ν₂t) for all t ≥ 0; so u > 0 and u' < 0 there, u ≥ (V/ν₂)
e^(−ν₂t), and ν₁ < μ < ν₂.

*Proof.* y = u e^(ν₁t) → 0 as t → ∞ (Lemma 23).  If y exceeds U, it has its largest value Y over t
≥ −1 at some t > 0, where y' = 0.  Equation (a) there reads ν₁ Y = γ (e^(−ν₁) y(t + 1) − 2Y + e^ν₁
y(t − 1)) + e^(ν₁t) W ≤ γ (2 cosh ν₁ − 2) Y + e^(ν₁t) W, so σ(ν₁) Y ≤ e^(ν₁t) W ≤ e^(ν₁t) S
∫_{ξ−1}^ξ u₊ ≤ S Y (e^ν₁ − 1)/ν₁, a contradiction.

By (a) u is C², and v = −u' solves −v' = γ Δv + ΔP, where ΔP ≥ −2P ≥ −2 U^α e^(−αν₁t) ≥ −2 U^α
e^(−ν₂t) for t ≥ 0; by Lemma 19 v → 0.  If z = v − V e^(−ν₂t), which is not negative for −1 ≤ t ≤ 0
and tends to 0, is negative somewhere, it has its least value at some t > 0; there z' = 0, Δz ≥ 0
and 0 = γ Δz + ΔP − V σ(ν₂) e^(−ν₂t) ≥ (−2 U^α − V σ(ν₂)) e^(−ν₂t) > 0, a contradiction. ∎

**Lemma 25 (the tail).** If u > 0 on [x₁ − 1, ∞), there is C > 0 with u = C e^(−μξ) (1 + o(1)) as ξ
→ ∞.

*Proof.* Take x = x₁ in (b), in t.  Its right-hand side f is not negative: for 0 < t < 1, E = γ ∫ u
over (t − 1, 0), and for −1 < t < 0, E = γ ∫ u over (0, t + 1).  f = O(e^(−ηt)) for every η < αμ by
Lemma 23.  The zeros of 1 − γ k̂ in a strip are finitely many, as k̂ → 0 far up.  By the proof of
Lemma 23 there are none with −μ < Re λ ≤ 0.  On Re λ = −μ there is only λ = −μ, a simple one, as 1 −
γ k̂(−ν) = σ(ν)/ν and σ'(μ) < 0.  So for some η in (μ, αμ) it is the only one with −η ≤ Re λ ≤ 0.
The transform of u 1_{t>0} is f̂/(1 − γ k̂), where f has bounded variation, so it is O(1/|Im λ|).
The line of the inverse transform (in L²) moves from Re λ > −μ to −η: u = C e^(−μt) + ω with C = −μ
f̂(−μ)/σ'(μ) > 0, as f̂(−μ) = ∫ f e^(μt) dt > 0. Here ω = O(e^(−ηt)), as it is the solution of ω − γ
k*ω = f with this decay. ∎

**Lemma 26 (behind).** If 1 − f̂, f = γ k + α Λ, has no zero with 0 < Re λ ≤ θ, then u − 1 =
O(e^(θξ)) as ξ → −∞.
*Proof.* As that of Lemma 10 of `consequences`: z = u − 1 solves z − f*z = Λ*N(z), |N(z)| ≤ C z². ∎
1 − f̂ is the function D of `granular_fronts.proofs.tail_roots` with γ/α for γ.
"""

from flint import arb, fmpq

from granular_fronts.proofs.balls import NotProvedError, above, array, bounds, largest, power
from granular_fronts.proofs.consequences import normalise, overshoot
from granular_fronts.proofs.tail_roots import Law, require_zeros


def shape(front):
    """Positivity, decrease ahead and the tail there; the overshoot; the tail behind."""
    theta, slow, fast = map(arb, front.data["weights"].tolist())
    low, high = front.u_low - front.rho * front.r, front.u_high + front.rho * front.r
    steepest = array(bounds(u.derivative() * 2 * front.n)[1] for u in front.smooth)
    steepest += front.slope_error
    x1, U, V = _compare(front, high, steepest, slow, fast)
    front.require("u > 0 in the window", arb(0), -largest(-low[:x1]))
    front.require("u > 0 behind it", front.rho_behind * front.r, arb(1))
    falls = x1
    while falls > 0 and steepest[falls - 1] < 0:
        falls -= 1
    front.require("u' < 0 in the window", largest(steepest[falls:x1]), arb(0))
    start, falls_from = (fmpq(k, front.n) - front.left for k in (x1, falls))
    front.fall = falls_from
    rounded = above(arb(start))  # Not below x₁, so that the upper bound holds for it too.
    least, most = -above(-V / fast * (fast * (start - arb(rounded))).exp()), above(U)
    front.numbers |= {"tail_start": rounded, "tail_low": least, "tail_high": most}
    yield (
        f"u* > 0 on the whole line, u*' < 0 for ξ ≥ {falls_from}, and with t = ξ − {start}"
        f" {0.999 * least:.3e} exp(−{float(fast)!r} t) < u* < {1.001 * most:.3e}"
        f" exp(−{float(slow)!r} t) for t ≥ 0."
    )
    zero = front.left * front.n
    yield normalise(front, falls, largest(steepest[zero - 1 : zero + 1]))
    yield "u* = C exp(−μξ) (1 + o(1)) as ξ → ∞, C > 0, where μ = 2γ (cosh μ − 1) > 0."
    yield from overshoot(front, front.u_mid - front.rho * front.r)
    front.require("theta > 0", arb(0), theta)
    behind = Law(front.alpha, front.gamma / front.alpha)
    require_zeros(behind, "no root up to theta", theta, 0)
    front.inequalities += behind.inequalities
    yield f"u* − 1 = O(exp({float(theta)!r} ξ)) as ξ → −∞."


def _compare(front, high, steepest, slow, fast):
    """Return the cells before the first x₁ of Lemma 24 on an edge of cells; U and V."""
    gamma, alpha, n = front.gamma, front.alpha, front.n

    def sigma(rate):
        return rate - 2 * gamma * (rate.cosh() - 1)

    front.require("sigma(nu1) > 0", arb(0), sigma(slow))
    front.require("sigma(nu2) < 0", sigma(fast), arb(0))
    front.require("nu2 < alpha nu1", fast, alpha * slow)
    front.require("nu2 > 0", arb(0), fast)
    mass, sup, sups = (slow.exp() - 1) / slow, front.rho_ahead * front.r, []
    for bound in high[::-1]:
        sup = largest([sup, bound])
        sups.append(sup)
    sups.reverse()
    before = arb(fmpq(1, n)) * array(range(n, -1, -1))  # −t at the edges of the bead before x₁
    grows, slows = ([(-rate * s).exp() for s in before] for rate in (slow, fast))
    for x1 in range(n, len(high) + 1):
        bead = range(x1 - n, x1)
        S = power(sups[x1 - n], alpha - 1)
        U = largest(high[i] * grows[k + 1] for k, i in enumerate(bead))
        V = -largest(steepest[i] * slows[k] for k, i in enumerate(bead))
        sides = (S * mass, sigma(slow)), (2 * power(U, alpha), -V * sigma(fast))
        if U > 0 and V > 0 and all(left < right for left, right in sides):
            break
    else:
        raise NotProvedError("the front is nowhere small and steep enough ahead")
    front.require("little force ahead", *sides[0])
    front.require("decrease ahead", *sides[1])
    return x1, U, V
