"""Check the certificate of a front with linear dashpots in ball arithmetic.

The theorem and its proof are in `existence`, the operator A in `right_inverse`, bounds of it in
`row_norms`, what follows in `ahead`.  A certificate holds exact doubles and integers, and nothing
is assumed about them.
"""

from flint import arb, arb_poly, arb_series

from granular_fronts.proofs.arrays import require_arrays, require_lengths, require_short
from granular_fronts.proofs.balls import (
    UNIT,
    above,
    antiderivatives,
    array,
    bounds,
    largest,
    power,
    size,
    slopes,
)
from granular_fronts.proofs.contraction import Contraction
from granular_fronts.proofs.dashpots.ahead import shape
from granular_fronts.proofs.dashpots.row_norms import bound_inverse
from granular_fronts.proofs.stability import stable
from granular_fronts.proofs.uniqueness import unique

TAYLOR_ORDER = 8  # of P̄ about the middle of a cell
SMALL_STRAIN = 1e-11  # where ū may be below, P̄ is 0
FIELDS = {  # kind of number and axes
    "alpha": ("i8", 1),
    "gamma": ("i8", 1),
    "sizes": ("i8", 1),
    "strain": ("f8", 2),
    "inverse_behind": ("i4", 2),
    "inverse_ahead": ("i4", 2),
    "correction": ("i2", 2),
    "weights": ("f8", 1),
}
SIZES = ("behind", "ahead", "n", "fine", "p", "q", "c", "M", "p_ahead", "q_ahead")


class DashpotFront(Contraction):
    """The approximate front ū on the cells of [−left, right], and the bounds of the theorem."""

    def __init__(self, data):
        require_arrays(data, FIELDS, len(SIZES))
        super().__init__(data)
        self.sizes = sizes = dict(zip(SIZES, map(int, data["sizes"]), strict=True))
        self.n, self.p, self.h = sizes["n"], sizes["p"], arb(1) / sizes["n"]
        self.b = sizes["c"] + sizes["q"] + 1
        self.left = max(sizes["behind"] + 1, self.b)
        self.right = max(sizes["ahead"] + 1, sizes["M"])
        self.require_lengths()
        self.u = self.cells(
            arb_poly([1]), [arb_poly(row) for row in data["strain"].tolist()], arb_poly([0])
        )
        self.u_mid = array(u[0] for u in self.u)
        self.u_low, self.u_high = map(array, zip(*map(bounds, self.u), strict=True))
        self.P, self.remainders = zip(*map(self.force, range(len(self.u))), strict=True)
        self.smooth = self.integrated()

    def require_lengths(self):
        """Stop unless the arrays have the lengths that follow from the sizes."""
        sizes, data, n = self.sizes, self.data, self.n
        ng, W = n * sizes["fine"], (self.b + sizes["M"]) * n
        kernels = "inverse_behind", "inverse_ahead", "correction", "weights"
        require_lengths(
            (len(data["strain"]), *(data[name].shape for name in kernels)),
            (
                (sizes["behind"] + sizes["ahead"]) * n,
                (1, (sizes["p"] + sizes["q"]) * ng),
                (1, (sizes["p_ahead"] + sizes["q_ahead"]) * ng),
                (W, W),
                (3,),
            ),
        )
        entries = data["inverse_behind"].size + data["inverse_ahead"].size
        require_short(W, entries, ng, 2 * len(data["strain"]))
        reach, window = arb(sizes["p_ahead"]), arb(self.b + sizes["M"])
        self.require("p₊ < M + b + 1", reach, window + 1)

    def cells(self, behind, inside, ahead):
        """Return one value on each cell of [−left, right], from the cells of [−behind, ahead]."""
        before, after = self.left - self.sizes["behind"], self.right - self.sizes["ahead"]
        return [behind] * (before * self.n) + inside + [ahead] * (after * self.n)

    def force(self, j):
        """Return P̄ on cell j, and a bound of |ū₊^α − P̄|."""
        if not self.u_low[j] > SMALL_STRAIN:
            return arb_poly([0]), power(abs(self.u_high[j]), self.alpha)
        u, m = self.u[j], TAYLOR_ORDER
        whole = [self.u_low[j].union(self.u_high[j]), *u(arb_poly([UNIT, 1])).coeffs()[1:]]
        P, rest = (
            arb_series(terms, order) ** self.alpha
            for terms, order in ((u.coeffs(), m), (whole, m + 1))
        )
        return arb_poly(P.coeffs()), abs(rest[m])

    def integrated(self):
        """Return û on all cells, from differences of antiderivatives of ū and P̄."""
        n, h = self.n, arb(1) / self.n
        behind, ahead = [arb_poly([1])] * n, [arb_poly([0])] * n
        strain, force = (
            antiderivatives([*behind, *pieces, *ahead], h) for pieces in (self.u, self.P)
        )
        force = antiderivatives(force, h)
        return [
            f[2] - 2 * f[1] + f[0] - self.gamma * (u[2] - 2 * u[1] + u[0])
            for f, u in (
                (force[j : j + 2 * n + 1 : n], strain[j : j + 2 * n + 1 : n])
                for j in range(len(self.u))
            )
        ]

    def prove(self):
        """All statements."""
        yield from self.exists()
        yield from unique(self)
        yield from shape(self)
        yield from stable(self)

    def damping(self, a):
        """Return γ/a, by which Theorem D divides."""
        return self.gamma / a

    def unknown(self, u):
        """Return u, the unknown itself."""
        return u

    def unknown_gap(self, top, gap):
        """Return the bound of the difference of u."""
        return gap

    def exists(self):
        """The theorem: a solution, its enclosure and its uniqueness; Lemma 22."""
        self.Z1, self.rho, self.rho_behind, self.rho_ahead = bound_inverse(self)
        differences = (size(u - smooth) for u, smooth in zip(self.u, self.smooth, strict=True))
        self.r, farthest = self.contract(largest(differences) + largest(self.remainders))
        worst = largest([*self.rho, self.rho_behind, self.rho_ahead]) * self.r
        tallest = largest([*self.u_high, arb(1)]) + worst
        force_error = largest(self.remainders) + self.a(tallest) * worst
        self.slope_error = 4 * self.gamma * worst + 2 * force_error
        self.error = above(worst)
        self.kappa, self.outer_kappa = self.rho, (self.rho_behind, self.rho_ahead)
        self.u_error = self.rho * self.r
        self.slopes = slopes(self.smooth, self.n, self.slope_error)
        yield (
            f"{self.parameters()}, with linear dashpots (β = 1), there is a front u* = ū + A"
            " y*, u* = Λ*u*₊^α + γ k*u*, from 1 behind to 0 ahead, with |u* − ū| <"
            f" {1.001 * self.error:.3e} on the whole line; it is the only ū + A y with"
            f" ‖y‖ < {0.999 * float(farthest):.3e}."
        )
        yield "Its linearisation maps L^∞ onto L^∞, and its kernel is spanned by the derivative."

    def Z2(self, r):  # noqa: N802
        """Return the largest ρ |a(ū + w) − a(ū)| with |w| ≤ ρ r."""
        cells = [*zip(self.rho, self.u_low, self.u_high, strict=True)]
        cells += [(self.rho_behind, arb(1), arb(1)), (self.rho_ahead, arb(0), arb(0))]
        return largest(rho * self.rise(low, high, rho * r) for rho, low, high in cells)
