"""The front behind: its slowest mode, and the sign of u' on the whole rear.

A front without overshoot comes from 1 monotonically, but far behind u' is smaller than any
enclosure of u.  Its sign follows from finitely many numbers near one place x₀ of the rear.

Let t = ξ − x₀, z = u − 1, Q = P − 1, v = u', ṽ = v 1_{t<0}, D(λ) = 1 − α K̂(λ) with K̂(λ) = ∫ K(s)
e^(−λs) ds, so that D(λ) = 1 − α (1 − γλ)(2 cosh λ − 2)/λ².  For w ≥ 0 write |f|_w = sup |f|
e^(−wt), K_w = K e^(−ws), and let Γ_w bound the norm of (δ − α K_w)^(−1) (see `balls`).

**Lemma 8.** Suppose that D has no zero with 0 < Re λ ≤ θ, and with θ < Re λ < η exactly the simple
zeros λ₁, real, and none or a pair λ₂, λ̄₂ with Re λ₂ > λ₁, where η < 2θ, and none with Re λ = η.
Then

    v = Σ C_j e^(λ_j t) + ω(t) for t < 0,      |ω(t)| ≤ Γ_η (|F_b|_η + c) e^(ηt),
    |C_j D'(λ_j) + F̂_b(λ_j)| ≤ c/(2θ − Re λ_j),

with F_b on (−1, 1) and c below.  If C₁ < 0 and −C₁ > 2 |C₂| e^((Re λ₂ − λ₁)t) + Γ_η (|F_b|_η + c)
e^((η − λ₁)t) at one t < 0, then u' < 0 up to there, and u = 1 − A e^(λ₁ξ) (1 + o(1)), A = −C₁
e^(−λ₁x₀)/λ₁.

*Proof.* u' = K*P' and P' = a(u) v.  Hence ṽ − α K*ṽ = F_b + F_n, where F_n = 1_{t<0} K*((a(u) − α)
ṽ) and F_b = K*(P' 1_{t>0}) for −1 < t < 0, F_b = −α K*ṽ for 0 < t < 1, 0 elsewhere.  By parts, as
K(s) = 1 + s − γ ahead (s < 0) and 1 − s + γ behind,

    F_b = −γ Q(t + 1) − (1 + t − γ) Q(0) + ∫₀^(t+1) Q                    −1 < t < 0,
    F_b = −α [(1 − t + γ) z(0) − γ z(t − 1) − ∫_(t−1)^0 z]                 0 < t < 1.

By Lemma 7 z = O(e^(θξ)), and so is v = K'*(P − 1).  So V = |ṽ|_θ is finite, and V ≤ Γ_θ (|F_b|_θ +
‖K_θ‖ ε V) with ε = sup |a(u) − α| over t < 0.  Let |z| ≤ ζ < 1 for t < 0 and B = α (α − 1) (1 ∓
ζ)^(α−2), − for α ≤ 2, the largest |a'| there; ε ≤ B ζ.  Then |z| ≤ V e^(θt)/θ, |(a(u) − α) ṽ| ≤ B
V² e^(2θt)/θ and |F_n| ≤ c e^(2θt) with c = B V² ‖K_2θ‖/θ. The Laplace transform of ṽ is (F̂_b +
F̂_n)/D for Re λ = θ, where F̂_n is analytic for Re λ < 2θ and bounded by c/(2θ − Re λ).  F_b has
bounded variation and F_n is Lipschitz on t < 0, so the transforms are O(1/|Im λ|), and D → 1 as
|Im λ| → ∞ in the strip: the line of the inverse transform (in L²) moves from θ to η, past −C_j
e^(λ_j t).  What is left is the solution of ω − α K*ω = F_b + F_n of growth e^(ηt), and |F_n|_η ≤
c. ∎

The zeros are counted by winding numbers: along Re λ = w, upwards, D turns m − 1 times if m zeros
have 0 < Re λ < w, as it turns −1 times along the imaginary axis (Lemma 4) and D → 1 at both ends.
"""

import math

from flint import acb, acb_poly, acb_series, arb, arb_poly, fmpq

from granular_fronts.proofs.balls import (
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

TERMS = 16


def expand(front, theta, eta):
    """Lemma 8 with the roots, the inverses and the x₀ of the certificate."""
    alpha, gamma, ng = front.alpha, front.gamma, front.n * front.fine
    x0, *starts = map(int, front.data["starts"])
    at = (front.left + x0) * front.n
    if len(starts) != 2 or not front.n <= at <= len(front.u) - front.n:
        raise NotProvedError(f"x0 = {x0} is not inside the cells")
    roots = [find_root(front, *row) for row in front.data["roots"].tolist()]
    slowest, *others = (root.real for root in roots)
    _require_order(front, theta, eta, slowest, others)
    gains = []
    for w, name, begin in zip((theta, eta), ("slow_inverse", "fast_inverse"), starts, strict=True):
        norms, defect = inverse_defect(alpha, [gamma], w, ng, front.data[name][None], begin)
        front.require(f"‖e‖ of the {name}", defect, arb(1))
        gains.append((1 + norms[0]) / (1 - defect))

    source, errors = boundary_source(front, at)
    slow, fast = (_weighted(front.n, source, errors, w) for w in (theta, eta))
    below, top = front.u_low - front.u_error, front.u_high + front.u_error
    z = largest([*abs(below[:at] - 1), *abs(top[:at] - 1), front.outer_kappa[0] * front.r])
    front.require("|u − 1| behind x0", z, arb(1))
    bend = alpha * (alpha - 1) * (1 - z if alpha <= 2 else 1 + z) ** (alpha - 2)
    once, twice = (kernel(gamma, w, ng)[2].sum() for w in (theta, 2 * theta))
    front.require("nearly linear behind x0", gains[0] * once * bend * z, arb(1))
    V = gains[0] * slow / (1 - gains[0] * once * bend * z)
    c = bend * V**2 * twice / theta

    C, *minor = (
        _amplitude(front, root, source, errors, c / (2 * theta - root.real)) for root in roots
    )
    front.require("C1 < 0", C.real, arb(0))
    A = -C.real * (-slowest * x0).exp() / slowest
    front.numbers |= {
        "rate": float(slowest),
        "amplitude_low": -above(-A),
        "amplitude_high": above(A),
    }
    yield (
        f"u* = 1 − A exp(λ ξ) (1 + o(1)) as ξ → −∞, λ = {slowest.str(15)},"
        f" {-above(-A):.6f} − 1e-6 < A < {above(A):.6f} + 1e-6."
    )
    t = arb(front.fall - x0)
    rest = gains[1] * (fast + c) * ((eta - slowest) * t).exp()
    for amplitude, rate in zip(minor, others, strict=True):
        rest += 2 * abs(amplitude) * ((rate - slowest) * t).exp()
    if t < 0 and rest < -C.real:
        front.require("other modes, where the range of u' < 0 begins", rest, -C.real)
        front.numbers["monotone"] = 1.0
        yield "u*' < 0 on the whole line: the front is monotone."


def _require_order(front, theta, eta, slowest, others):
    """θ < λ₁ < Re λ₂ < η < 2θ, and no more zeros."""
    require_zeros(front, "all roots up to eta", eta, 1 + 2 * len(others))
    front.require("theta < lambda1", theta, slowest)
    front.require("lambda1 < eta", slowest, eta)
    front.require("eta < 2 theta", eta, 2 * theta)
    if len(others) > 1:
        raise NotProvedError("more than one pair of complex roots")
    for rate in others:
        front.require("lambda1 < Re lambda2", slowest, rate)
        front.require("Re lambda2 < eta", rate, eta)


def boundary_source(front, at):
    """F_b on the cells of (−1, 1), as polynomials of P̄ and ū, and its errors there."""
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
    """|F_b|_w."""
    return largest(
        (size(f) + error) * (-w * fmpq(k - n, n)).exp()
        for k, (f, error) in enumerate(zip(source, errors, strict=True))
    )


def _amplitude(front, root, source, errors, bent):
    """C = −F̂(λ)/D'(λ); the exponential on a cell is a Taylor polynomial and a remainder."""
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
    return -transform / symbol(front, acb_series([root, 1], 2))[1]


def symbol(front, x, gamma=None):
    """D(λ), for all γ of the certificate or for one."""
    gamma, waves = front.gamma if gamma is None else gamma, x.exp() + (-x).exp() - 2
    return 1 - front.alpha * (1 - gamma * x) * waves / (x * x)


def find_root(front, real, imaginary, radius):
    """The only zero of D in a square, by the interval Newton operator; real if its middle is."""
    middle = acb(real, imaginary)
    square = middle + disc(arb(radius))
    if imaginary != 0:
        front.require("lambda2 is not real", arb(0), square.imag)
    for step in range(3):
        found = middle - symbol(front, middle) / symbol(front, acb_series([square, 1], 2))[1]
        if step == 0 and not square.contains_interior(found):
            raise NotProvedError(f"no single root is found within {radius} of {middle}")
        middle, square = found.mid(), found
    return square if imaginary != 0 else acb(square.real)


def require_zeros(front, name, w, count):
    """D ≠ 0 on Re λ = w, and `count` zeros with 0 < Re λ < w.

    The upper half of the line is cut into parts whose images for all γ lie in a half plane from 0;
    above them |D − 1| < 1.  So D ≠ 0 there for all γ, it turns as often for each, and is followed
    for the middle one.
    """
    waves, height = w.exp() + (-w).exp() + 2, arb(4)
    while not front.alpha * (1 + front.gamma * (w + height)) * waves < height**2:
        height *= 2
    turn, parts = -symbol(front, acb(w, height), front.middle).arg(), [(arb(0), height)]
    while parts:
        low, high = parts.pop()
        start, end = (symbol(front, acb(w, y), front.middle) for y in (low, high))
        whole = symbol(front, acb(w, low.union(high)))
        if (whole / start).real > 0:
            turn += (end / start).arg()
        elif len(parts) > 60:
            raise NotProvedError(f"{name}: there may be a root with real part {w}")
        else:
            middle = (low + high) / 2
            parts += [(low, middle), (middle, high)]
    front.require(name, abs(turn / arb.pi() + 1 - count), arb(0.5))
