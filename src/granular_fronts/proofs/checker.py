"""The checker: a certificate is checked in ball arithmetic, with only python-flint and NumPy.

The theorem and its proof are in `existence`; the operator A and the bounds of `bound_inverse` are
in `right_inverse`.  The conclusions are in `consequences` and `rear_expansion`.  A certificate
holds exact doubles and integers, and nothing is assumed about them.  A comparison of balls holds if
it holds for all of their points.  If one fails, or anything else goes wrong, nothing is proved.

**Trust.** How a certificate was made is of no importance.  To trust what it proves one must trust
the mathematics, the processor, Python, and python-flint with FLINT.  Versions 0.4.4 to 0.9 of
python-flint accept the same certificates.  Of NumPy one must trust
 * that it reads npz files, which are zip archives;
 * sums of integers of 64 bits, and integers below 2⁵³ as doubles, by which the matrix H is exact;
   `balls.unit_plus` refuses larger ones;
 * its loops over arrays of balls, in `convolve`, `cumsum`, `sum`, `abs` and `minimum`.

Of the code here these modules are trusted: ``checker``, ``arrays``, ``balls``, ``contraction``,
``uniqueness``, ``stability``, ``tail_roots``, ``consequences`` and ``rear_expansion``.  Families
need ``families`` too, and dashpots ``dashpots.checker``, ``dashpots.row_norms`` and
``dashpots.ahead``.  Tests compute each bound again by other means.
"""

from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, arb_poly, arb_series, fmpq

from granular_fronts import arguments
from granular_fronts.proofs.arrays import ends, load, require_arrays, require_lengths, require_short
from granular_fronts.proofs.balls import (
    UNIT,
    NotProvedError,
    above,
    antiderivatives,
    array,
    bounds,
    convolve,
    horner,
    in_a_sentence,
    in_balls,
    inverse_defect,
    kernel,
    largest,
    power,
    powers,
    size,
    slope_kernel,
    slopes,
    tops,
    unit_plus,
)
from granular_fronts.proofs.consequences import shape
from granular_fronts.proofs.contraction import Contraction
from granular_fronts.proofs.dashpots.checker import DashpotFront
from granular_fronts.proofs.rear_expansion import expand
from granular_fronts.proofs.stability import stable
from granular_fronts.proofs.tail_roots import require_zeros
from granular_fronts.proofs.uniqueness import unique

TAYLOR_ORDER = 8  # of the residual about the middle of a cell
PARTS_AT_ONCE = 50  # parts of γ behind take as long as the cells once
MOST_POWERS = 8  # of s in P̄ and in an inverse
SMALL_STRAIN = 1e-7  # where ū may be below, no Taylor polynomial of ū^α is made
EXPANSION = {  # kind of number and axes
    "roots": ("f8", 2),
    "starts": ("i8", 1),
    "slow_inverse": ("i4", 2),
    "fast_inverse": ("i4", 2),
}
FIELDS = {
    "alpha": ("i8", 1),
    "gamma": ("i8", 1),
    "sizes": ("i8", 1),
    "profile": ("f8", 3),
    "inverse": ("i4", 2),
    "correction": ("i2", 2),
    "weights": ("f8", 1),
}


def check_certificate(path: str | Path) -> dict[str, Any]:
    """Prove what a certificate claims.

    Parameters
    ----------
    path : str or path
        A file that `prove_front` wrote, of either law.

    Returns
    -------
    dict
        `proved` (bool) and, where it is False, `reason`.  The `statements` hold for all parameters
        between the ends `alpha` and `gamma`, pairs of exact fractions; `error` bounds the distance
        of u* from ū.  `numbers` always holds `radius` (of the ball of y) and `shift`, a bound of
        the size of ξ₀, where u*(ξ₀) = 1/2.  Where proved it holds `unique_within`, W of Theorem B,
        `overshoot` (max u* is above it), bounds `rate_low`, `rate_high` of λ₁ or ρ, and bounds
        `amplitude_low`, `amplitude_high` of A or B.  The value 1 marks `monotone`, `oscillates`
        (behind, so that max u* > 1), `critical` (monotone above some γ, not below) and `stable`.
        Dashpots have `tail_start`, and `tail_low`, `tail_high`, the values there of exponentials
        that bound u* ahead.  `inequalities` are dicts of `name`, `left`, `right`
        (left < right, rounded outwards) and their `margin`.

    Raises
    ------
    InputError
        If `path` is no path.  A file that is missing or damaged is one that proves nothing.

    Examples
    --------
    >>> record = gf.check_certificate("nowhere.npz")
    >>> record["proved"], record["reason"]
    (False, 'there is no file nowhere.npz')
    """
    path = arguments.path("path", path)
    record = {"proved": False, "reason": "", "statements": [], "inequalities": []}
    try:
        with in_balls(), in_a_sentence():
            data = load(path)
            front = DashpotFront(data) if "strain" in data else Front(_checked(data))
            statements = list(front.prove())
            record |= {name: ends(data, name) for name in ("alpha", "gamma")}
        record |= {"error": front.error, "statements": statements, "proved": True}
        record |= {"numbers": front.numbers, "inequalities": front.inequalities}
    except NotProvedError as failure:
        record["reason"] = str(failure)
    return record


class Front(Contraction):
    """The approximate front P̄, ū on the cells of [−left, M], and the bounds of the theorem.

    P, u and all that is made from them contain every α and γ of the certificate.  The window
    [−b, M] of A is the last W cells.
    """

    def __init__(self, data):
        super().__init__(data)
        behind, ahead, n, self.p, q, self.c, self.fine = map(int, data["sizes"])
        self.n, self.h, self.left = n, arb(1) / n, max(behind + 1, self.c + q + 2)
        self.M = ahead + 1
        self.W = (self.c + q + ahead + 3) * n
        have = *(data[name].shape[1] for name in ("profile", "inverse")), *data["correction"].shape
        want = (behind + ahead) * n, (self.p + q) * n * self.fine, self.W, self.W
        require_lengths(have, want)
        entries = sum(data[name].size for name in data if name.endswith("inverse"))
        parts = 1 + int(data["starts"][-1]) / PARTS_AT_ONCE if "starts" in data else 1
        require_short(self.W, entries, n * self.fine, len(data["profile"]) * want[0] * parts)
        self.nK = 2 * self.gamma if self.gamma >= 1 else 1 + self.gamma**2
        known = [self.integrate(k, rows) for k, rows in enumerate(data["profile"].tolist())]
        self.profile, first, second = (
            list(zip(*each, strict=True)) for each in zip(*known, strict=True)
        )
        self.middle, self.half = (self.low + self.high) / 2, (self.high - self.low) / 2
        zero = arb_poly([0])
        self.strain = [
            [
                g - self.middle * f - self.half * e
                for e, f, g in zip((zero, *F), (*F, zero), (*G, zero), strict=True)
            ]
            for F, G in zip(first, second, strict=True)
        ]
        self.P, self.u = self.at(UNIT)
        self.u_mid = array(u[0] for u in self.u)
        self.u_low, self.u_high = map(array, zip(*map(bounds, self.u), strict=True))

    def integrate(self, k, rows):
        """Return coefficient of s^k in P̄ on all cells, and differences of its antiderivatives."""
        n, behind = self.n, arb_poly([int(k == 0)])
        pieces = [behind] * ((self.left + 1) * n - self.data["sizes"][0] * n)
        pieces += [arb_poly(row) for row in rows] + [arb_poly([0])] * (2 * n)
        once = antiderivatives(pieces, self.h)
        twice = antiderivatives(once, self.h)
        inside = range(n, len(pieces) - n)
        steps = ([f[j + n] - 2 * f[j] + f[j - n] for j in inside] for f in (once, twice))
        return pieces[n:-n], *steps

    def at(self, s):
        """Return P̄ and ū on all cells at γ₀ + s δ."""
        return [[horner(f, s) for f in cells] for cells in (self.profile, self.strain)]

    def prove(self):
        """All statements."""
        yield from self.exists()
        yield from unique(self)
        yield from shape(self)
        yield from stable(self)
        yield from self.rear()

    def damping(self, a):
        """Return γ, by which Theorem D divides."""
        return self.gamma

    def unknown(self, u):
        """Return P of u."""
        return power(u, self.alpha)

    def unknown_gap(self, top, gap):
        """Return the bound of the difference of P where u is below `top` and differs by `gap`."""
        return self.a(top) * gap

    def exists(self):
        """The theorem: a solution, its enclosure and its uniqueness; Lemma 5."""
        self.bound_inverse()
        Y0 = largest(map(self.residual, range(len(self.u))))
        self.r, farthest = self.contract(Y0)
        self.P_error, self.u_error = self.rho * self.r, self.kappa * self.r
        self.slope_error = (2 + 4 * self.gamma) * largest([*self.rho, self.rho_behind]) * self.r
        self.error = above(largest([*self.u_error, *(self.outer_kappa * self.r)]))
        self.slopes = slopes(self.u, self.n, self.slope_error)
        yield (
            f"{self.parameters()} there is a front P* = P̄ + A y*, u* = K*P*, from 1 behind to 0"
            f" ahead, with |u* − ū| < {1.001 * self.error:.3e} on the whole line; it is the"
            f" only P̄ + A y with ‖y‖ < {0.999 * float(farthest):.3e}."
        )
        yield "Its linearisation maps L^∞ onto L^∞, and its kernel is spanned by the derivative."

    def Z2(self, r):  # noqa: N802
        """Return the largest κ |a(ū + w) − a(ū)| with |w| ≤ κ r."""
        ends = zip(self.outer_kappa, (arb(1), arb(0)), (arb(1), arb(0)), strict=True)
        cells = *ends, *zip(self.kappa, self.u_low, self.u_high, strict=True)
        return largest(kappa * self.rise(low, high, kappa * r) for kappa, low, high in cells)

    def residual(self, j):
        """Return bound of |P̄ − ū₊^α| on cell j by Taylor polynomials in s about γ₀ and in t."""
        if not self.u_low[j] > SMALL_STRAIN:
            return size(self.P[j]) + power(abs(self.u_high[j]), self.alpha)
        P, u, m = self.profile[j], self.strain[j], TAYLOR_ORDER
        found = [[] for _ in P]
        for point, order in ((arb_poly([0, 1]), m), (arb_poly([UNIT, 1]), m + 1)):
            p, v = ([arb_series(f(point).coeffs(), order) for f in parts] for parts in (P, u))
            for terms, f, g in zip(found, p, powers(v, self.alpha, len(P)), strict=True):
                terms += (f - g).coeffs()[len(terms) : order]
        ranges = arb_poly([low.union(high) for low, high in map(bounds, u)])
        near = [self.u_low[j].union(self.u_high[j]), *ranges(arb_poly([UNIT, 1])).coeffs()[1:]]
        last = (arb_series(near, len(P) + 1) ** self.alpha)[len(P)]
        return sum((abs(term) for terms in found for term in terms), abs(last))

    def bound_inverse(self):
        """Z1, and the row norms ρ of A and κ of K*A, on all cells and outside."""
        n, W, h, nK, alpha = self.n, self.W, self.h, self.nK, self.alpha
        a_low, a_mid, a_high = (
            array(map(self.a, u)) for u in (self.u_low, self.u_mid, self.u_high)
        )
        far = (self.left - self.c) * n
        drift = largest(abs(a / alpha - 1) for a in (*a_low[:far], *a_high[:far]))
        self.require("|a(ū)/α − 1| behind −c", drift, arb(1))
        a_low, a_mid, a_high = (a[-W:] for a in (a_low, a_mid, a_high))
        middles, _, absolute = kernel(self.gamma, arb(0), n)
        flat, sign = kernel(self.middle, arb(0), n)[1], slope_kernel(arb(0), n)[1]
        begin = -self.p * n * self.fine
        law = alpha, (self.middle, self.half), arb(0)
        tails, defect = inverse_defect(*law, n * self.fine, self.data["inverse"], begin)
        self.require("‖e‖", defect, arb(1))
        self.rear_norms = nK, tails[0], defect

        H, correction = unit_plus(self.data["correction"])
        rest, v = array([0] * W), array([0] * W)
        for j in range(W):  # columns of 1 − L_h H
            varying = self.half * UNIT * convolve(sign, H[:, j])
            smooth = (convolve(flat, H[:, j]) + varying)[n:-n]
            rest += np.abs(a_mid * smooth - correction[:, j]) * (a_mid[j] * nK)
        for k in range(W):  # rows of H diag(a)
            row = H[k] * a_mid
            edges = convolve(middles[::-1], row)[n - 1 : n + W]
            v[k] = h * np.abs(edges).sum() + h / 2 * np.abs(row).sum()

        v, rest = tops(v), tops(rest)
        w, swing = v + 1, array([h * h / 2] * (2 * n + 1))
        swing[[0, n, -1]] += h * self.gamma * array([fmpq(1, 2), 1, fmpq(1, 2)])
        change, modulus = (np.convolve(w, f)[n:-n] for f in (swing, absolute))
        inner = a_high * change + (a_high - a_low) * modulus
        entering = alpha * (self.gamma**2 + (1 - self.gamma) ** 2) / 2 * largest(w[:n])
        gain = 1 + largest([entering, *rest[:n]])
        outer = gain * (defect + drift * (tails[0] + defect)) + nK * largest(a_high[-n:])
        self.Z1 = (outer + largest([*inner[:n], *(inner + rest)[n:], entering * drift])).upper()

        reach = np.minimum((np.arange(W) - n) * self.fine - begin, len(tails) - 1)
        added = gain * tails[reach] + rest
        behind = gain * (1 + tails[0])
        rho = np.concatenate([[behind] * n, w + added, [arb(1)] * n])
        direct = np.convolve(rho, absolute + swing)[2 * n : -2 * n]
        through = v + added + inner + outer
        kappa = [
            d.upper().min((t / a).upper()) if a > 0 else d
            for d, t, a in zip(direct, through, a_low, strict=True)
        ]
        first = (gain * tails[0] + entering * (1 + drift) + outer) / (alpha * (1 - drift))
        more = len(self.u) - W
        self.rho, self.rho_behind = tops([behind] * more + [*rho[n:-n]]), behind.upper()
        self.kappa = tops([first] * more + kappa)
        self.outer_kappa = tops([first, nK * largest(rho[-2 * n :])])

    def rear(self):
        """Lemma 10 and, where the certificate has its data, the expansion behind."""
        theta, *more = map(arb, self.data["weights"].tolist())
        self.require("theta > 0", arb(0), theta)
        require_zeros(self, "no root up to theta", theta, 0)
        yield f"u* − 1 = O(exp({float(theta)!r} ξ)) as ξ → −∞."
        if more:
            yield from expand(self, theta, *more)


def read(path):
    """Return the arrays of a certificate of this kind."""
    return _checked(load(path))


def _checked(data):
    """Return the arrays of a certificate, if they have the kinds and shapes that they must have."""
    fields = FIELDS | EXPANSION if len(data.get("weights", ())) == 2 else FIELDS
    require_arrays(data, fields, sizes=7)
    if max(len(data["profile"]), len(data["inverse"])) > MOST_POWERS:
        raise NotProvedError("there are too many powers of s")
    return data
