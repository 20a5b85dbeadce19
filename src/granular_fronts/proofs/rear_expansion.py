"""The front behind: its slowest mode, and whether it comes from 1 monotonically or oscillating.

Far behind u' is smaller than any enclosure of u.  Its sign follows from finitely many numbers near
one place x₀ of the rear.

Let t = ξ − x₀, z = u − 1, Q = P − 1, v = u', ṽ = v 1_{t<0}, D(λ) = 1 − α K̂(λ) with K̂(λ) = ∫ K(s)
e^(−λs) ds as in `tail_roots`.  For w ≥ 0 write |f|_w = sup |f| e^(−wt), K_w = K e^(−ws), and let
Γ_w bound the norm of (δ − α K_w)^(−1) (see `balls`).

**Lemma 14.** Suppose that D has no zero with 0 < Re λ ≤ θ or Re λ = η, where η < 2θ. With θ < Re λ
< η let it have exactly the simple zeros λ₁, real, or a pair λ₂, λ̄₂, or these three.  Then

    v = Σ C_j e^(λ_j t) + ω(t) for t < 0,      |ω(t)| ≤ Γ_η (|F_b|_η + c) e^(ηt),
    |C_j D'(λ_j) + F̂_b(λ_j)| ≤ c/(2θ − Re λ_j),

with F_b on (−1, 1) and c below; C_j of conjugate λ_j are conjugate.

*Proof.* u' = K*P' and P' = a(u) v.  Hence ṽ − α K*ṽ = F_b + F_n, where F_n = 1_{t<0} K*((a(u) − α)
ṽ) and F_b = K*(P' 1_{t>0}) for −1 < t < 0, F_b = −α K*ṽ for 0 < t < 1, 0 elsewhere.  By parts, as
K(s) = 1 + s − γ ahead (s < 0) and 1 − s + γ behind,

    F_b = −γ Q(t + 1) − (1 + t − γ) Q(0) + ∫₀^(t+1) Q                    −1 < t < 0,
    F_b = −α [(1 − t + γ) z(0) − γ z(t − 1) − ∫_(t−1)^0 z]                 0 < t < 1.

D has finitely many zeros with 0 < Re λ < η, so that some θ' > θ has none up to it.  By Lemma 10 z =
O(e^(θ'ξ)), and so is v = K'*(P − 1).  So V = |ṽ|_θ is finite, and V ≤ Γ_θ (|F_b|_θ + ‖K_θ‖ ε V)
with ε = sup |a(u) − α| over t < 0.  Let |z| ≤ ζ < 1 for t < 0 and B = α (α − 1) (1 − ζ)^(−|α−2|), a
bound of |a'| there; ε ≤ B ζ.  Then |z| ≤ V e^(θt)/θ, |(a(u) − α) ṽ| ≤ B V² e^(2θt)/θ and |F_n| ≤ c
e^(2θt) with c = B V² ‖K_(2θ)‖/θ. The Laplace transform of ṽ is (F̂_b + F̂_n)/D for Re λ = θ, where
F̂_n is analytic for Re λ < 2θ and bounded by c/(2θ − Re λ).  F_b has bounded variation and F_n is
Lipschitz on t < 0, so the transforms are O(1/|Im λ|).  As D → 1 for |Im λ| → ∞ in the strip, the
line of the inverse transform (in L²) moves from θ to η, past residues −C_j e^(λ_j t).  What is left
is the solution of ω − α K*ω = F_b + F_n of growth e^(ηt), and |F_n|_η ≤ c. ∎

**Monotone fronts.** Let λ₂, if there is one, have Re λ₂ ≥ λ₁.  If C₁ < 0 and −C₁ > 2 |C₂| e^((Re λ₂
− λ₁)t) + Γ_η (|F_b|_η + c) e^((η − λ₁)t) at one t < 0, then u' < 0 up to there, as the right-hand
side grows with t.  If Re λ₂ > λ₁, then u = 1 − A e^(λ₁ξ) (1 + o(1)), A = −C₁ e^(−λ₁x₀)/λ₁;
of u(· + ξ₀) it is e^(λ₁ξ₀) times that, and B is e^(ξ₀ Re λ₂) times that of Lemma 15.

**Lemma 15 (oscillation).** Let λ₂ with C₂ ≠ 0 have Re λ₂ < λ₁ if λ₁ is in the strip.  Then, with B
= 2 |C₂/λ₂| e^(−Re λ₂ x₀) and some φ,

    u = 1 + B e^(Re λ₂ ξ) (cos(Im λ₂ ξ + φ) + o(1)) as ξ → −∞:

u crosses 1 infinitely often, is not monotone, and max u > 1.

*Proof.* z(t) = ∫ v over (−∞, t) = Σ (C_j/λ_j) e^(λ_j t) + O(e^(ηt)).  The two terms of λ₂ are
conjugate, and their sum is 2 |C₂/λ₂| e^(Re λ₂ t) cos(Im λ₂ t + arg(C₂/λ₂)). All others are smaller
by a factor that tends to 0. ∎

**Critical damping.** On an interval of γ that contains a γ with Re λ₂ = λ₁ both cases occur.
Suppose that on all of it d(Re λ₂ − λ₁)/dγ > 0 (see `tail_roots`), C₂ ≠ 0, C₁ < 0 and the inequality
of monotone fronts holds.  Then the front is monotone for that γ and those above, and overshoots for
those below.  That the interval contains one is shown by the order of the roots at both of its ends.
"""

import math
from copy import copy

from flint import acb, acb_poly, arb, arb_poly, fmpq

from granular_fronts.proofs.balls import (
    UNIT,
    NotProvedError,
    above,
    antiderivatives,
    array,
    disc,
    inverse_defect,
    kernel,
    largest,
    size,
)
from granular_fronts.proofs.tail_roots import Law, find_root, require_zeros, slope, speed

TERMS = 16  # of the exponential on a cell
MOST_PARTS = 1000  # of an interval of γ, so that every check ends
KINDS = ("pair", "either", "real")  # which root leads, in the order of γ at critical damping


def expand(front, theta, eta):
    """Lemma 14 with the roots, the inverses and the x₀ of the certificate, on parts of its γ."""
    x0, *starts, count = map(int, front.data["starts"])
    at = (front.left + x0) * front.n
    if len(starts) != 2 or not front.n <= at <= len(front.u) - front.n:
        raise NotProvedError(f"x0 = {x0} is not inside the cells")
    if not 1 <= count <= MOST_PARTS:
        raise NotProvedError(f"{count} is no number of parts")
    kinds = _require_modes(front, theta, eta)
    gains, gammas, ng = [], [front.middle, front.half], front.n * front.fine
    for w, name, begin in zip((theta, eta), ("slow_inverse", "fast_inverse"), starts, strict=True):
        norms, defect = inverse_defect(front.alpha, gammas, w, ng, front.data[name], begin)
        front.require(f"‖e‖ of the {name}", defect, arb(1))
        gains.append((1 + norms[0]) / (1 - defect))
    to_V, to_c = _nonlinearity(front, at, theta, gains[0])

    parts = [_part(front, k, count) for k in range(count)]
    found = []
    for part in parts:
        source, errors = boundary_source(part, at)
        c = to_c * (to_V * _weighted(front.n, source, errors, theta)) ** 2
        rest = gains[1] * (_weighted(front.n, source, errors, eta) + c)
        modes = {}
        for kind, row in zip(kinds, front.data["roots"].tolist(), strict=True):
            root = find_root(part, *row)
            part.require(f"theta < Re λ of the {kind}", theta, root.real)
            part.require(f"Re λ of the {kind} < eta", root.real, eta)
            C = _amplitude(part, root, source, errors, c / (2 * theta - root.real))
            modes[kind] = root, C
        found.append(lead(part, modes, (rest, eta), x0))
    _note(front, parts)
    yield from _statements(front, found)


def _require_modes(front, theta, eta):
    """Return the kinds of the roots: all up to η < 2θ, one real or one of a pair or both."""
    kinds = ["real" if row[1] == 0 else "pair" for row in front.data["roots"].tolist()]
    if len(set(kinds)) < len(kinds):
        raise NotProvedError("more than one real root, or more than one pair")
    count = kinds.count("real") + 2 * kinds.count("pair")
    require_zeros(front, "all roots up to eta", eta, count)
    front.require("eta < 2 theta", eta, 2 * theta)
    return kinds


def _nonlinearity(front, at, theta, gain):
    """Return the factors of |F_b|_θ in V, and of V² in c."""
    below, top = front.u_low - front.u_error, front.u_high + front.u_error
    z = largest([*abs(below[:at] - 1), *abs(top[:at] - 1), front.outer_kappa[0] * front.r])
    front.require("|u − 1| behind x0", z, arb(1))
    bend = front.alpha * (front.alpha - 1) * (1 - z) ** -abs(front.alpha - 2)
    ng = front.n * front.fine
    once, twice = (kernel(front.gamma, w, ng)[2].sum() for w in (theta, 2 * theta))
    front.require("nearly linear behind x0", gain * once * bend * z, arb(1))
    return gain / (1 - gain * once * bend * z), bend * twice / theta


def _part(front, k, count):
    """Return the front on one of equal parts of its interval of γ, with inequalities of its own."""
    part = copy(front)
    low, high = (arb(fmpq(2 * j - count, count)) for j in (k, k + 1))
    part.gamma, part.middle = (
        front.middle + s * front.half for s in (low.union(high), (low + high) / 2)
    )
    part.P, part.u = front.at(low.union(high))
    part.inequalities = []
    return part


def lead(part, modes, rest, x0):
    """Return which root leads, its rates and its amplitude, and whether the front is monotone.

    `rest` is the bound of ω and its rate.
    """
    real, pair = modes.get("real"), modes.get("pair")
    from_x0 = part.shift * UNIT - x0  # of the place where u* = 1/2
    ahead = pair[0].real - real[0].real if real and pair else None
    kind = "either"
    if not pair or (real and ahead > 0):
        kind = "real"
    elif not real or ahead < 0:
        kind = "pair"
    if kind != "real":
        part.require("C2 is not 0", arb(0), abs(pair[1]))
    if kind == "pair":
        B = 2 * abs(pair[1] / pair[0]) * (pair[0].real * from_x0).exp()
        return kind, pair[0], B, False
    part.require("C1 < 0", real[1].real, arb(0))
    if kind == "either":
        part.require("Re λ2 − λ1 grows", speed(part, real[0]).real, speed(part, pair[0]).real)
    A = -real[1].real * (real[0].real * from_x0).exp() / real[0].real
    t = arb(part.fall - x0)
    others = rest[0] * ((rest[1] - real[0].real) * t).exp()
    if pair:
        others += 2 * abs(pair[1]) * (ahead * t).exp()
    monotone = bool(t < 0 and others < -real[1].real)
    if monotone or kind == "either":
        part.require("x0 is ahead of where the range of u' < 0 begins", t, arb(0))
        part.require("other modes there", others, -real[1].real)
    return kind, real[0], A, monotone


def _note(front, parts):
    """Of the inequalities of all parts those with the least margins."""
    least = {}
    for one in (one for part in parts for one in part.inequalities):
        known = least.setdefault(one["name"], one)
        if one["margin"] < known["margin"]:
            least[one["name"]] = one
    front.inequalities += least.values()


def _statements(front, found):
    kinds, roots, amplitudes, monotone = zip(*found, strict=True)
    places = [KINDS.index(kind) for kind in kinds]
    rate = _hull(root.real for root in roots)
    low, high = max(0.0, -above(-_least(amplitudes))), above(largest(amplitudes))
    bounds = {"rate_low": -above(-rate), "rate_high": above(rate)}
    bounds |= {"amplitude_low": low, "amplitude_high": high}
    if set(kinds) == {"real"}:
        front.numbers |= bounds
        yield (
            f"u*(ξ + ξ₀) = 1 − A exp(λ ξ) (1 + o(1)) as ξ → −∞, λ = {rate.str(15)},"
            f" {low:.6f} − 1e-6 < A < {high:.6f} + 1e-6."
        )
        if all(monotone):
            front.numbers["monotone"] = 1.0
            yield "u*' < 0 on the whole line: the front is monotone."
    elif set(kinds) == {"pair"}:
        waves = _hull(root.imag for root in roots)
        front.numbers |= bounds | {"oscillates": 1.0}
        yield (
            f"u*(ξ + ξ₀) = 1 + B exp(ρ ξ) (cos(ω ξ + φ) + o(1)) as ξ → −∞, ρ = {rate.str(15)}, ω ="
            f" {waves.str(15)}, 0 < B < {high:.6f} + 1e-6: u* − 1 changes its sign infinitely"
            " often, and the front overshoots."
        )
    elif places == sorted(places) and all(monotone[places.count(0) :]):
        if _exchanged(front):
            front.numbers["critical"] = 1.0
        yield (
            "For each γ at which Re λ₂ ≥ λ₁, u*' < 0 on the whole line: the front is monotone.  For"
            " each γ at which Re λ₂ < λ₁, u* − 1 changes its sign infinitely often as ξ → −∞: the"
            " front overshoots.  The latter γ are below the former."
        )


def _exchanged(front):
    """Return whether λ₂ decays more slowly than λ₁ at the lower end of γ, faster at the upper."""
    ahead = []
    for gamma in (front.middle - front.half, front.middle + front.half):
        law, rows = Law(front.alpha, gamma), front.data["roots"].tolist()
        real, pair = sorted((find_root(law, *row) for row in rows), key=lambda x: x.imag != 0)
        ahead.append(pair.real - real.real)
    return bool(ahead[0] < 0 and ahead[1] > 0)


def _least(values):
    """Return an exact lower bound of all values."""
    return -largest([-value for value in values])


def _hull(values):
    """Return a ball around all values."""
    values = list(values)
    return _least(values).union(largest(values))


def boundary_source(front, at):
    """Return F_b on the cells of (−1, 1), as polynomials of P̄ and ū, and its errors there."""
    n, gamma, half = front.n, front.gamma, front.h / 2
    Q, z = ([f - 1 for f in pieces] for pieces in (front.P[at : at + n], front.u[at - n : at]))
    Q_sums, z_sums = antiderivatives(Q, front.h), antiderivatives(z, front.h)
    Q0, z0, z_sum = Q[0](arb(-1)), z[-1](arb(1)), z_sums[-1](arb(1))
    lines = [arb_poly([arb(fmpq(2 * k + 1, 2 * n)), half]) for k in range(n)]  # t + 1, or t
    before = [
        total - gamma * f - (line - gamma) * Q0
        for line, f, total in zip(lines, Q, Q_sums, strict=True)
    ]
    after = [
        front.alpha * (gamma * f + z_sum - total - (1 + gamma - line) * z0)
        for line, f, total in zip(lines, z, z_sums, strict=True)
    ]
    P_error, u_error = (largest(e[at - n : at + n]) for e in (front.P_error, front.u_error))
    early = (1 + gamma + gamma.max(abs(1 - gamma))) * P_error
    late = 2 * front.alpha * (1 + gamma) * u_error
    return before + after, array([early] * n + [late] * n)


def _weighted(n, source, errors, w):
    return largest(
        (size(f) + error) * (-w * fmpq(k - n, n)).exp()
        for k, (f, error) in enumerate(zip(source, errors, strict=True))
    )


def _amplitude(front, root, source, errors, bent):
    """Return C = −F̂(λ)/D'(λ); the exponential on a cell is a Taylor polynomial and a remainder."""
    n, half, x = front.n, front.h / 2, root * front.h / 2
    exponential = acb_poly([(-x) ** k / math.factorial(k) for k in range(TERMS)])
    growth = abs(x).exp()
    remainder = abs(x) ** TERMS / math.factorial(TERMS) * growth
    transform = disc(bent)
    for k, (f, error) in enumerate(zip(source, errors, strict=True)):
        integral = (acb_poly(f) * exponential).integral()
        value = integral(acb(1)) - integral(acb(-1))
        value += disc(2 * size(f) * remainder + 2 * error * growth)
        transform += value * half * (-root * fmpq(2 * (k - n) + 1, 2 * n)).exp()
    return -transform / slope(front, root)
