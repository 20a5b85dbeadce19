"""Ball arithmetic for the checker: bounds, polynomials on cells, the kernel and its inverses.

A ball of python-flint contains the number that it represents; an operation on balls contains all
results.  `largest` and `above` are the only ways from balls to single numbers, both upwards.

The kernel K(s) = 1 − |s| + γ sgn s on |s| < 1 is linear between its kinks −1, 0 and 1, which are
ends of cells.  With K_w(s) = K(s) e^(−ws), cells of width h = 1/n and a piecewise constant g,

    e = g − α K_w − α K_w*g

is smooth on each cell, so that ∫|e| over a cell is at most h |e| in its middle plus h/2 ∫|e'|.  In
the middles K_w*g is a sum of g times integrals of K_w over cells about s = m h, and with the jumps
2γ, −γ e^(−w) and −γ e^w of K_w at 0, 1 and −1,

    Σ ∫|e'| ≤ α k' + α (k' + γ (2 + e^w + e^(−w))) ‖g‖₁,     k' = (e^w − e^(−w))/w + w ‖K_w‖₁.

On an interval of γ, γ₀ + s δ with |s| ≤ 1, g is a polynomial in s, and so is e in the middles. The
sum of the moduli of its coefficients is a bound there.  If the bound of ‖e‖₁ is below 1, δ − α K_w
has the inverse (δ + g)*(δ + e)^(−1) in L¹ ⊕ ℂδ, of norm at most (1 + ‖g‖₁)/(1 − ‖e‖₁).
"""

import math
import textwrap
from contextlib import contextmanager

import numpy as np
from flint import acb, arb, arb_poly, ctx, fmpq

PRECISION, SERIES = 80, 12  # bits, and terms of the longest series
LONGEST_LINE = 400  # letters of a reason
EXACT = 2**53  # up to it all integers are doubles
UNIT = arb(0, 1)  # the interval from −1 to 1
MATRIX_UNIT, INVERSE_UNIT = 2.0**-16, 2.0**-20  # of H − 1 and of g as a certificate stores them


class NotProvedError(Exception):
    """Names what is not certain, or which field is not what it must be."""


@contextmanager
def in_a_sentence(subject=""):
    """Whatever goes wrong is not proved, and is said in one short line."""
    try:
        yield
    except NotProvedError as failure:
        raise NotProvedError(_line(f"{subject}{failure}")) from failure
    except Exception as failure:
        words = f"{subject}its numbers lead to no bound: {type(failure).__name__}, {failure}"
        raise NotProvedError(_line(words)) from failure


def _line(words):
    return textwrap.shorten(words, LONGEST_LINE, placeholder=" …")


class Inequalities:
    """What is shown of something, in the order in which it is, with margins."""

    def __init__(self):
        self.inequalities = []

    def require(self, name, left, right):
        """Note left < right, or stop."""
        if not left < right:
            raise NotProvedError(f"{name}: {left} is not certainly below {right}")
        left, right = above(left), -above(-right)
        self.inequalities.append(
            {"name": name, "left": left, "right": right, "margin": right - left}
        )


@contextmanager
def in_balls(precision=PRECISION):
    """Precision, and the longest series, that the proof needs; as they were afterwards."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = precision, SERIES
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before


def kernel(gamma, w, n):
    """Return K_w at s = (m + 1/2)/n; integrals of K_w, and of its modulus, over |s − m/n| < 1/(2n).

    On half a cell of width l the midpoint rule errs by l³/24 K_w'' somewhere on it.
    """
    half, middles, whole, absolute = arb(1) / (2 * n), [], [arb(0)], [arb(0)]
    for j in range(-2 * n, 2 * n):
        sign, s = (1 if j >= 0 else -1), arb(fmpq(2 * j + 1, 4 * n))
        around, end = s + half / 2 * UNIT, s + half / 2
        (line, decay), (lines, decays), (last, last_decay) = (
            (1 + sign * (gamma - x), (-w * x).exp()) for x in (s, around, end)
        )
        bend = decays * w * (w * lines + 2 * sign)
        whole.append(half * line * decay + half**3 / 24 * bend)
        one_sign = lines > 0 or lines < 0
        absolute.append(abs(whole[-1] if one_sign else half * lines * decays))
        if j % 2 == 0:
            middles.append(last * last_decay)
    whole, absolute = array([*whole, 0]), array([*absolute, 0])
    return array(middles), whole[::2] + whole[1::2], absolute[::2] + absolute[1::2]


def inverse_defect(alpha, gammas, w, n, rows, begin):
    """Return ∫|g| from each cell on, and a bound of ‖e‖₁, for all |s| ≤ 1.

    γ and g are polynomials in s, `gammas` and `rows` their coefficients.  The rows, from begin/n
    on, are stored by their second differences in units of INVERSE_UNIT.
    """
    kernels = [
        [alpha * f for f in kernel(gammas[0], w, n)[:2]],
        *([alpha * part * f for f in slope_kernel(w, n)] for part in gammas[1:]),
    ]
    gamma = horner(gammas, UNIT)
    smooth = (2 * w.sinh() / w if w > 0 else 2) + w * kernel(gamma, w, n)[2].sum()
    return defect(kernels, (alpha * smooth, 2 * alpha * gamma * (1 + w.cosh())), n, rows, begin)


def defect(kernels, variation, n, rows, begin):
    """Return the same for e = g − f − f*g with another f on (−1, 1), smooth between −1, 0 and 1.

    `kernels` has the coefficients of f in s: f in the middles of cells, and integrals as of
    `kernel`.  `variation` bounds ∫|f'| between the jumps of f, and their sum.
    """
    count = rows.shape[1]
    if not begin <= -n or begin + count < n:
        raise NotProvedError("an inverse does not cover (−1, 1)")
    g = [array(summed(row) * INVERSE_UNIT) for row in rows]
    e = np.array([array([0] * (count + 2 * n)) for _ in range(len(g) + len(kernels) - 1)])
    for k, row in enumerate(g):
        e[k, n:-n] += row
    for j, (middles, whole) in enumerate(kernels):
        e[j, -begin : 2 * n - begin] -= middles
        for k, row in enumerate(g):
            e[j + k] -= convolve(whole, row)
    norms = np.cumsum(np.abs([*sum(map(np.abs, g)), arb(0)])[::-1])[::-1] / n
    smooth, jumps = variation
    return norms, np.abs(e).sum() / n + (smooth + (smooth + jumps) * norms[0]) / (2 * n)


def slope_kernel(w, n):
    """Return the first two of `kernel` for sgn(s) e^(−ws), by which K_w depends on γ."""
    one, zero = (kernel(arb(gamma), w, n)[:2] for gamma in (1, 0))
    return [f - g for f, g in zip(one, zero, strict=True)]


def summed(differences):
    """Return the integers from their second differences; of a matrix, once along each axis."""
    return differences.cumsum(axis=0, dtype=np.int64).cumsum(axis=-1)


def unit_plus(differences):
    """Return the matrices H and H − 1, exactly: doubles hold whole units up to EXACT of them."""
    units = summed(differences)
    if not abs(units).max() < EXACT - 1 / MATRIX_UNIT:
        raise NotProvedError("the matrix H has entries that doubles do not hold")
    correction = units * MATRIX_UNIT
    return np.eye(len(units)) + correction, correction


def convolve(f, g):
    """Return all coefficients of a product of polynomials."""
    product = (arb_poly(list(f)) * arb_poly(list(g))).coeffs()
    return np.array(product + [arb(0)] * (len(f) + len(g) - 1 - len(product)), dtype=object)


def antiderivatives(pieces, h):
    """Return continuous antiderivative, 0 at the left end, of polynomials on cells of width h."""
    found, total = [], arb(0)
    for piece in pieces:
        integral = piece.integral() * (h / 2)
        found.append(integral + (total - integral(arb(-1))))
        total = found[-1](arb(1))
    return found


def size(f):
    """Return the bound of the modulus of a polynomial on (−1, 1)."""
    return sum(map(abs, f.coeffs()), arb(0))


def slopes(pieces, n, error):
    """Return bounds of the modulus of a slope, from polynomials on cells and an error."""
    return [size(f.derivative()) * 2 * n + error for f in pieces]


def bounds(f):
    """Return the exact bounds of a polynomial on (−1, 1)."""
    middle, rest = f[0], size(f - f[0])
    return (middle - rest).lower(), (middle + rest).upper()


def array(values):
    """Return an array of balls."""
    return np.array([arb(value) for value in values], dtype=object)


def disc(radius):
    """Return the smallest square that contains all complex numbers of modulus `radius`."""
    return acb(radius * UNIT, radius * UNIT)


def power(u, exponent):
    """Return u₊^exponent, for exponents above 0."""
    if u <= 0:
        return arb(0)
    return u**exponent if u > 0 else arb(0).union(u.upper() ** exponent)


def powers(u, exponent, count):
    """Return the first coefficients of (u₀ + u₁ s + …)^exponent, themselves series in t.

    By w = u^c, u w' = c u' w: k u₀ w_k = Σ (c i − k + i) u_i w_(k−i), 1 ≤ i ≤ k.
    """
    found = [u[0] ** exponent]
    for k in range(1, count):
        terms = ((exponent * i - (k - i)) * (u[i] * found[k - i]) for i in range(1, k + 1))
        found.append(sum(terms, 0 * u[0]) / (k * u[0]))
    return found


def horner(f, s):
    """Return Σ f_k s^k."""
    value = f[-1]
    for coefficient in f[-2::-1]:
        value = coefficient + s * value
    return value


def largest(values):
    """Return the least exact upper bound of all values."""
    tops = [value.upper() for value in values]
    if not all(top.is_finite() for top in tops):
        raise NotProvedError("a bound is not finite")
    found = tops[0]
    for top in tops:
        found = found if top <= found else top
    return found


def tops(values):
    """Return an exact upper bound of each value."""
    return array(value.upper() for value in values)


def above(x):
    """Return a double that no point of a ball exceeds."""
    found = float(x.upper())
    return found if arb(found) >= x else math.nextafter(found, math.inf)
