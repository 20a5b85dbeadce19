"""The certificates that are kept, and doubles and fine meshes to compute their bounds anew."""

import json
from copy import copy
from functools import cache

import numpy as np

from granular_fronts.proofs import arrays
from granular_fronts.proofs.balls import in_balls
from granular_fronts.proofs.checker import Front, read
from granular_fronts.proofs.dashpots.checker import DashpotFront
from granular_fronts.proofs.families import record
from projects import ROOT

DATA = ROOT / "tests/proofs/test_proof_data"
PROVED = json.loads((DATA / "proved.json").read_text())
KEPT = {name: DATA / f"{name}.npz" for name in PROVED}
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


def load(name):
    return arrays.load(KEPT[name])


@cache
def known(name):
    """The front of a certificate that is kept, proved once, which no test changes."""
    with in_balls():
        front = DashpotFront(load(name)) if name == "dashpots" else Front(read(KEPT[name]))
        front.statements = list(front.prove())
    return front


def proved(name):
    """What such a certificate proves, as the checker says it."""
    found = record(KEPT[name], known(name)) | {"proved": True, "reason": ""}
    del found["path"]
    return found


def enclosed(name, **changes):
    """A front that is proved from such a certificate, something of it changed; nothing is said."""
    front = copy(known(name))
    front.inequalities, front.numbers = [], {}
    vars(front).update(changes)
    return front


def setting(**values):
    """A change of a certificate that sets some fields."""
    return lambda data: data.update({name: np.array(value) for name, value in values.items()})


def changed(name, change):
    """One that changes a field."""

    def apply(data):
        data[name] = change(data[name])

    return apply


def at(index, value):
    """A change of one place of an array."""

    def change(values):
        values = values.copy()
        values[index] = value
        return values

    return change


def floats(values):
    return np.array([float(value.mid()) for value in values])


def middles(front):
    return (np.arange(len(front.u)) + 0.5) / front.n - front.left


def on_cells(rows, behind, n, xi):
    """A function of polynomials on cells from −behind on, 1 behind them and 0 ahead."""
    cell = np.floor((xi + behind) * n).astype(int)
    t = 2 * ((xi + behind) * n - cell) - 1
    inside = (cell >= 0) & (cell < len(rows))
    values = sum(rows[np.where(inside, cell, 0), k] * t**k for k in range(rows.shape[1]))
    return np.where(inside, values, np.where(cell < 0, 1.0, 0.0))


def quadrature(f, x, n):
    """∫ f(η) over |η − x| < 1 by Gauss's rule between ends of cells."""
    ends = np.arange(np.ceil((x - 1) * n), np.floor((x + 1) * n) + 1) / n
    ends = np.unique(np.concatenate([[x - 1, x, x + 1], ends]))
    half = np.diff(ends) / 2
    return float((f((ends[1:] + ends[:-1])[:, None] / 2 + half[:, None] * NODES) @ WEIGHTS) @ half)


def integrals(f, n):
    """Those of a function on (−1, 1) over cells about m/n, by the midpoint rule on halves."""
    halves = np.concatenate([[0], f((np.arange(-2 * n, 2 * n) + 0.5) / (2 * n)) / (2 * n), [0]])
    return halves[::2] + halves[1::2]


class Mesh:
    """Cells narrower than those of a certificate, and convolutions as matrices there."""

    def __init__(self, n, parts, left, right):
        self.per_bead, self.h = n * parts, 1 / (n * parts)
        self.x = (np.arange((left + right) * self.per_bead) + 0.5) * self.h - left
        self.offsets = np.round(np.subtract.outer(self.x, self.x) / self.h).astype(int)

    def toeplitz(self, values, first):
        index = self.offsets - first
        inside = (index >= 0) & (index < len(values))
        return np.where(inside, values[np.clip(index, 0, len(values) - 1)], 0.0)

    def kernel(self, f):
        """Convolution with a function on (−1, 1), by the midpoint rule on halves of cells."""
        return self.toeplitz(integrals(f, self.per_bead), -self.per_bead)

    def inverse(self, g, p, ng):
        """That with δ + g, where g is constant on cells of width 1/ng from −p on."""
        primitive = np.concatenate([[0], np.cumsum(g)]) / ng
        grid = np.arange(len(primitive)) / ng - p
        first, last = -p * self.per_bead - 1, round(grid[-1] * self.per_bead) + 2
        edges = (np.arange(first, last + 1) - 0.5) * self.h
        return np.eye(len(self.x)) + self.toeplitz(
            np.diff(np.interp(edges, grid, primitive)), first
        )
