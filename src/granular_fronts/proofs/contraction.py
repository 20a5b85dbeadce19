"""The contraction of Theorems 2 and 20: a radius r from Y₀, Z₁ and Z₂(r)."""

from functools import partial

from flint import arb, fmpq

from granular_fronts.proofs.arrays import both_ends, ends, in_words
from granular_fronts.proofs.balls import Inequalities, above, largest, power


class Contraction(Inequalities):
    """The α and γ of a certificate; a subclass has the bound `Z1` and a function `Z2` of r."""

    def __init__(self, data):
        super().__init__()
        self.data, self.numbers = data, {}
        (least, most), (self.low, self.high) = both_ends(data, "alpha"), both_ends(data, "gamma")
        self.law = self.alpha, self.gamma = least.union(most), self.low.union(self.high)
        self.require("alpha > 1", arb(1), self.alpha)
        self.require("gamma > 0", arb(0), self.gamma)

    def parameters(self):
        """Return for which α and γ the statements hold, exactly."""
        alpha, gamma = (ends(self.data, name) for name in ("alpha", "gamma"))
        return f"For {in_words(alpha, 'α')} and {in_words(gamma, 'γ')}"

    def a(self, u):
        """Return α u₊^(α − 1)."""
        return self.alpha * power(u, self.alpha - 1)

    def rise(self, low, high, w):
        """Return the bound of |a(u + v) − a(u)| for |v| ≤ w and u between two bounds."""
        tops = [low.max(w)] * (not self.alpha > 2) + [high + w] * (not self.alpha < 2)
        return largest(self.a(top) - self.a(top - w) for top in tops)

    def contract(self, Y0):
        """Return the radius r of the theorem, and a larger one with only one solution."""
        self.require("Z1 < 1", self.Z1, arb(1))
        # A little above the least radius.
        near = (factor * Y0 / (1 - self.Z1) for factor in (1.001, 1.1, 2))
        r = next(filter(partial(self.contracts, Y0), near), Y0).upper()
        self.require("Z1 + Z2(r) < 1", self.Z1 + self.Z2(r), arb(1))
        self.require("Y0 < (1 − Z1 − Z2(r)) r", Y0, (1 - self.Z1 - self.Z2(r)) * r)
        # All quarter powers of 2 down from 1; what contracts nowhere was refused above.
        far = (arb(2) ** fmpq(-k, 4) for k in range(400))
        farthest = next(filter(partial(self.contracts, Y0), far), r).max(r)
        self.numbers["radius"] = above(r)
        return r, farthest

    def contracts(self, Y0, r):
        """Return whether the theorem's inequality holds at the radius r."""
        return bool((1 - self.Z1 - self.Z2(r)) * r > Y0)
