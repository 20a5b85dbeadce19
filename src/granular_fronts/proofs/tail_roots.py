"""Tail roots and critical damping: the zeros of D, enclosed and counted.

A tail u − 1 ~ e^(λξ) behind a front has D(λ) = 1 − α (1 − γλ)(2 cosh λ − 2)/λ² = 0.  With the bell
q(λ) = λ²/(2 cosh λ − 2) and k = αγ this says that the line α − kλ meets the bell at λ.

**One zero.** Let f be analytic on a compact convex set X around m, and let a convex set Y without 0
hold all values of f' there.  If N = m − f(m)/Y lies inside X, then X holds exactly one zero of f,
and N contains it (interval Newton operator).  For f(x) = f(m) + F(x) (x − m), where F(x) ∈ Y is the
mean of f' between m and x.  So x ↦ m − f(m)/F(x) maps X into N ⊂ X and has a fixed point, a zero
(Brouwer).  Every zero in X is in N, and two zeros in X would make a mean of f' zero.  For real
functions the same holds.  If X is symmetric about the real axis and f real there, the zero is real.

**All zeros.** Along Re λ = w, upwards, D turns m − 1 times if m zeros have 0 < Re λ < w.  For it
turns −1 times along the imaginary axis (Lemma 5 of `consequences`) and D → 1 at both ends.

**Moving zeros.** As D = 0 makes α (2 cosh λ − 2)/λ² = 1/(1 − γλ), a simple zero moves by

    dλ/dγ = −λ/((1 − γλ) D'(λ)).

**Lemma 11 (one bend).** q'' < 0 on (0, b) and q'' > 0 on (b, ∞) for one b between 2 and 7/2.

*Proof.* With p = −q'/q = coth(λ/2) − 2/λ = Σ 4λ/(λ² + 4π²k²) over k ≥ 1, q''/q = p² − p'.  As p ≤ Σ
λ/(π²k²) = λ/6 and, by (1 − x)/(1 + x)² ≥ 1 − 3x with x = λ²/(4π²k²), p' = Σ 4 (4π²k² − λ²)/(λ² +
4π²k²)² ≥ Σ (1 − 3x)/(π²k²) = 1/6 − λ²/120, it is below λ²/36 + λ²/120 − 1/6 < 0 for λ ≤ 2; as coth
> 1 and p' = 2/λ² − 1/(2 sinh²(λ/2)) < 2/λ², it is above (1 − 2/λ)² − 2/λ² > 0 for λ ≥ 7/2.
Balls show (`find_bend`) that on each of finitely many intervals that cover [2, 7/2] either q'' ≠ 0
or q''' > 0: q'' changes its sign upwards only, hence once. ∎

**Lemma 12 (double roots).** T = q − λq' grows from 1 to α* = T(b) on (0, b) and falls beyond.  For
1 < α < α* there is exactly one λ < b with T(λ) = α; with k = −q'(λ) the line touches the bell
there.  As k grows through this value a pair of complex roots becomes two real ones.  For α > α* no
real root is double; for α = α* the only one, b, is triple.

*Proof.* T' = −λq''.  A line with α > 1, k > 0 touches the bell at λ > 0 if and only if α = T(λ) and
k = −q'(λ); there (λ + x, k + y) is on both if y λ = −q'' x²/2 + …, so that x² ~ 2λy/|q''| if λ < b.
∎

**Lemma 13 (crossing).** At γ₀ let exactly the real λ₁ and the pair λ₂, λ̄₂ have 0 < Re λ < w, all
simple, with Re λ₂ = λ₁ and d(Re λ₂ − λ₁)/dγ > 0.  Then near γ₀ the slowest root is complex for γ <
γ₀ and real for γ > γ₀.

*Proof.* Zeros in a strip are finitely many, so w may be taken with D ≠ 0 on Re λ = w too.  As D → 1
at the ends of both lines, D turns on them as often for γ near γ₀.  So three roots remain between
them.  They are those that move from λ₁, λ₂ and λ̄₂, and λ₁ stays real. ∎
"""

import cmath
import math
from fractions import Fraction

from flint import acb, acb_series, arb, arb_series, fmpq

from granular_fronts.proofs.balls import UNIT, Inequalities, NotProvedError, disc

NEWTON_STEPS = 4  # from double precision to beyond that of the balls
BEND_PARTS = 1024  # intervals of unit length are cut into in Lemma 11
STRIP = arb(fmpq(1, 32))  # to both sides of a double root or of a crossing, free of other roots
MOST_PARTS = 50_000  # of a line, which take some seconds
SHORTEST = arb(fmpq(1, 2**30))  # part of a line that is cut no further
KNOWN_CROSSING = Fraction(3, 2), 1.92, 2.92  # α, λ₁ and Im λ₂, roughly
ALONG = 32  # steps in which α is changed from there by a factor of e
NEAR = 1e-8  # radius of the squares about roots that doubles have found
FARTHEST = arb(20)  # real part of a line that is followed, in time that grows as its exponential


class Law(Inequalities):
    """α and γ, of which something is shown."""

    def __init__(self, alpha, gamma):
        super().__init__()
        self.alpha, self.gamma, self.middle = alpha, gamma, gamma.mid()


def symbol(law, x, gamma=None):
    """Return D(λ), for all γ of a law or for one."""
    gamma, waves = law.gamma if gamma is None else gamma, x.exp() + (-x).exp() - 2
    return 1 - law.alpha * (1 - gamma * x) * waves / (x * x)


def slope(law, x, gamma=None):
    """Return D'(λ)."""
    return symbol(law, acb_series([x, 1], 2), gamma)[1]


def newton(f, derivative, start, radius):
    """Return the only zero of a function in a ball, by the interval Newton operator."""
    middle, ball = start, start + (disc(radius) if isinstance(start, acb) else radius * UNIT)
    for step in range(NEWTON_STEPS):
        found = middle - f(middle) / derivative(ball)
        if step == 0 and not ball.contains_interior(found):
            raise NotProvedError(f"no single root is found within {radius} of {start}")
        middle, ball = found.mid(), found
    return ball


def find_root(law, real, imaginary, radius):
    """Return the only zero of D in a square; real if its start is, and else above the real axis.

    The square is about what Newton's method finds for the middle γ.
    """
    start = acb(real, imaginary)
    for _ in range(NEWTON_STEPS):
        step = symbol(law, start, law.middle) / slope(law, start, law.middle)
        start = (start - step).mid() if imaginary else acb((start - step).real.mid())
    found = newton(lambda x: symbol(law, x), lambda x: slope(law, x), start, arb(radius))
    if imaginary == 0:
        return acb(found.real)
    law.require("lambda2 is not real", arb(0), found.imag)
    return found


def speed(law, root):
    """Return dλ/dγ."""
    return -root / ((1 - law.gamma * root) * slope(law, root))


def require_zeros(law, name, w, count):
    """D ≠ 0 on Re λ = w, and `count` zeros with 0 < Re λ < w.

    The upper half of the line is cut into parts whose images for all γ lie in a half plane from 0;
    above them |D − 1| < 1.  So D ≠ 0 there for all γ, it turns as often for each, and is followed
    for the middle one.
    """
    if not w < FARTHEST:
        raise NotProvedError(f"{name}: {w} is above {FARTHEST}, too far behind to be followed")
    waves, height = w.exp() + (-w).exp() + 2, arb(4)
    while not law.alpha * (1 + law.gamma * (w + height)) * waves < height**2:
        height *= 2
    turn, parts, done = -symbol(law, acb(w, height), law.middle).arg(), [(arb(0), height)], 0
    while parts:
        low, high = parts.pop()
        done += 1
        if done > MOST_PARTS:
            raise NotProvedError(f"{name}: the line with real part {w} has too many parts")
        start, end = (symbol(law, acb(w, y), law.middle) for y in (low, high))
        whole = symbol(law, acb(w, low.union(high)))
        if (whole / start).real > 0:
            turn += (end / start).arg()
        elif not high - low > SHORTEST:
            raise NotProvedError(f"{name}: there may be a root with real part {w}")
        else:
            middle = (low + high) / 2
            parts += [(low, middle), (middle, high)]
    law.require(name, abs(turn / arb.pi() + 1 - count), arb(0.5))


def bell(x, order):
    """Return the values of q and of its derivatives at a real ball."""
    x = arb_series([x, 1], order + 1)
    series = x * x / (x.exp() + (-x).exp() - 2)
    return [series[k] * math.factorial(k) for k in range(order + 1)]


def touching(x):
    """Return T(λ), the α of the line that touches the bell."""
    q, first = bell(x, 1)
    return q - x * first


def find_bend(start, radius):
    """Return b, the only λ > 0 at which the bell bends; α* = T(b)."""
    for k in range(2 * BEND_PARTS, 7 * BEND_PARTS // 2):
        part = arb(fmpq(k, BEND_PARTS)).union(arb(fmpq(k + 1, BEND_PARTS)))
        _, _, second, third = bell(part, 3)
        if not (second > 0 or second < 0 or third > 0):
            raise NotProvedError(f"q may bend more than once near {part}")
    bend = newton(lambda x: bell(x, 2)[2], lambda x: bell(x, 3)[3], arb(start), arb(radius))
    if not 2 < bend < 3.5:
        raise NotProvedError(f"{bend} is not between 2 and 7/2")
    return bend


def double_root(alpha, start, radius):
    """Return the law of Lemma 12 and its double root, which is the slowest of all roots."""
    root = newton(
        lambda x: touching(x) - alpha, lambda x: -x * bell(x, 2)[2], arb(start), arb(radius)
    )
    _, first, second = bell(root, 2)
    law = Law(alpha, -first / alpha)
    law.require("the double root is below the bend", second, arb(0))
    require_zeros(law, "no slower root", (root - STRIP).mid(), 0)
    require_zeros(law, "two roots there", (root + STRIP).mid(), 2)
    return law, root


def crossing(alpha, gamma, starts, radius):
    """Return the law of Lemma 13 and its roots, near a real root and a complex one."""

    def roots(law):
        return [find_root(law, start.real, start.imag, radius) for start in starts]

    def lead(gamma):
        real, pair = roots(Law(alpha, gamma))
        return pair.real - real.real

    def opening(gamma):
        law = Law(alpha, gamma)
        real, pair = roots(law)
        return speed(law, pair).real - speed(law, real).real

    law = Law(alpha, newton(lead, opening, arb(gamma), arb(radius) / 4096))
    law.require("the pair grows faster", arb(0), opening(law.gamma))
    real, pair = roots(law)
    require_zeros(law, "no slower root", (real.real - STRIP).mid(), 0)
    require_zeros(law, "three roots there", (real.real + STRIP).mid(), 3)
    return law, real, pair


def critical_damping(alpha):
    """Return γ_x of a fraction α in a ball: Lemma 13 near what Newton's method finds in doubles."""
    gamma, real, pair = _nearly_critical(alpha)
    return crossing(arb(fmpq(alpha.numerator, alpha.denominator)), gamma, (real, pair), NEAR)[0]


def _nearly_critical(alpha):
    """Return γ, λ₁ and λ₂ = λ₁ + iy with D = 0 at both, along α from a known crossing."""
    start, x, y = KNOWN_CROSSING
    steps = 1 + abs(round(ALONG * math.log(alpha / start)))
    for k in range(1, steps + 1):
        at = float(start) * float(alpha / start) ** (k / steps)
        for _ in range(2 * NEWTON_STEPS):
            f, over_x, over_y = _pair_defect(at, x, y)
            turn = (over_x.conjugate() * over_y).imag
            x += (over_y.conjugate() * f).imag / turn
            y -= (over_x.conjugate() * f).imag / turn
    return _damping_of(at, x), complex(x), complex(x, y)


def _damping_of(alpha, x):
    """Return the γ with D(x) = 0."""
    return (1 - x * x / (alpha * (2 * math.cosh(x) - 2))) / x


def _pair_defect(alpha, x, y, step=1e-5):
    """Return D(x + iy), where γ makes D(x) = 0, and its derivatives by x and y."""

    def defect(x, y):
        z = complex(x, y)
        return 1 - alpha * (1 - _damping_of(alpha, x) * z) * (2 * cmath.cosh(z) - 2) / z**2

    ways = ((step, 0), (0, step))
    slopes = ((defect(x + a, y + b) - defect(x - a, y - b)) / (2 * step) for a, b in ways)
    return defect(x, y), *slopes
