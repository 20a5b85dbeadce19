"""Random fronts: stated errors, and true ones by Fourier's method in extended precision.

The profile equation is solved again on a longer window and a finer grid.  Its convolutions are
multiplications of Fourier amplitudes, its forces are those of `reference_methods.extended`, and the
residual is taken in extended precision.  The package's quadrature leads Newton's iteration there,
and has no part in where it ends.
"""

import json
import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import xarray as xr
from scipy import sparse
from scipy.sparse.linalg import splu

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.model.laws import make_law
from granular_fronts.numerics.quadrature import kernel_weights
from granular_fronts.reference_methods.extended import PI, REAL, forces
from true_chains import Number

LONGER = 1.25
LARGEST_MATRIX = 12_000_000
"""Numbers in the factors of a front that is judged."""
SETTLED = 2e-18

# What two ramps need, in points: half a width, and its unit.
RAMP, SOFTNESS = 34, REAL("3.3")

# Part of the amplitudes at the shortest waves above which a finer grid is tried.
LEFT_OUT = 1e-17
# Of the stated error; where more is left, extended precision is not enough for a judge.
ENOUGH = 0.5


class TrueFront:
    """A front of `solve_front`, solved again with some parts in each of its cells."""

    def __init__(self, front: xr.Dataset, parts: int = 2) -> None:
        law = json.loads(front.attrs["law"])
        self.law, (self.forces, _) = make_law(law), forces(law)
        behind, ahead = (REAL(front.attrs[f"state_{place}"]) for place in ("behind", "ahead"))
        self.ahead, self.jump = ahead, behind - ahead
        elastic, self.drag_ahead = self.forces(np.array([-behind, -ahead]))
        self.force_ahead = elastic[1]
        self.speed = np.sqrt((elastic[1] - elastic[0]) / self.jump)
        xi, cell = front["xi"].values, Fraction(front.attrs["spacing"]).limit_denominator()
        middle = int(np.argmin(np.abs(xi)))
        self.parts = parts if cell <= 1 else int(cell)
        self.spacing = cell / self.parts
        self.middle = math.ceil(LONGER * middle) * self.parts
        points = self.middle + 1 + math.ceil(LONGER * (xi.size - middle)) * self.parts
        self.h = REAL(self.spacing.numerator) / REAL(self.spacing.denominator)
        self.xi = self.h * np.arange(-self.middle, points - self.middle)
        start = evaluate_front(front, self.xi.astype(float), "strain").astype(REAL)
        self.s = (start - self.ahead) / self.jump
        self.fits = points * (3 * (math.ceil(1 / self.spacing) + 9) + 2) < LARGEST_MATRIX
        if self.fits:
            self._make_ring()
            self._solve()

    def pq(self, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return p(s) and q(s) of the profile equation."""
        elastic, viscous = self.forces(-(self.ahead + self.jump * s))
        p = (self.force_ahead - elastic) / (self.speed**2 * self.jump)
        return p, (self.drag_ahead[1] - viscous) / (self.speed * self.jump)

    def _make_ring(self) -> None:
        """Ramp that makes the front a pulse on a ring, and multipliers of the convolutions."""
        bell = np.exp(-((np.arange(-RAMP, RAMP + 1, dtype=REAL) / SOFTNESS) ** 2) / 2)
        reach = math.ceil(2 / self.spacing) + RAMP
        self.left = 2 * reach + bell.size
        size = self.left + self.s.size + reach
        size += size % 2
        self.ramp = np.ones(size, REAL)
        self.ramp[:reach] = 0
        self.ramp[reach : reach + bell.size] = np.cumsum(bell) / bell.sum()
        self.k = 2 * PI * np.arange(size // 2 + 1) / (size * self.h)
        half = self.k / 2
        sinc = np.sin(half) / np.where(half == 0, REAL(1), half)
        sinc[0] = 1
        self.hat, self.sign = sinc**2, -1j * self.k * sinc**2
        self.site, self.back = np.exp(-1j * half) * sinc, np.exp(-2j * half)

    def waves(self) -> tuple[np.ndarray, ...]:
        """Return amplitudes of s, p and q; s is 1 before the first point, 0 after the last."""
        whole = np.zeros(self.ramp.size, REAL)
        whole[: self.left] = 1
        whole[self.left : self.left + self.s.size] = self.s
        return tuple(np.fft.rfft(of * self.ramp) for of in (whole, *self.pq(whole)))

    def on_points(self, amplitudes: np.ndarray) -> np.ndarray:
        """Return the values at the points of the front."""
        return np.fft.irfft(amplitudes, self.ramp.size)[self.left : self.left + self.s.size]

    def _solve(self) -> None:
        """Newton's iteration with the matrix of the start."""
        order, factors = self._factors()
        speed = REAL(1)
        self.left_over, least = math.inf, math.inf
        for _ in range(12):
            _, p, q = self.waves()
            residual = speed**2 * self.s - self.on_points(self.hat * p + speed * self.sign * q)
            phase = self.s[self.middle] - REAL(0.5)
            wrong = np.append(residual, phase).astype(float)
            *change, faster = factors.solve(wrong[order])
            self.s, speed = self.s - change, speed - faster
            self.left_over = float(np.abs(change).max())
            if self.left_over < SETTLED or self.left_over > 0.5 * least:
                break
            least = self.left_over
        self.defect = float(speed - 1)
        self.tail = float(max(np.abs(a[-a.size // 20 :]).max() / np.abs(a).max() for a in (p, q)))

    def _factors(self) -> tuple[np.ndarray, Any]:
        """Return the factors of the matrix of the start by the package's quadrature.

        Unknowns are s and the speed over the exact one, and the last equation is s = 1/2 at ξ = 0.
        Equations are put into the order in which `fronts.profile.newton` needs no pivoting, which
        here would make rounding errors grow without bounds.
        """
        hat, sign, _ = kernel_weights(self.spacing, 20)
        size, width = self.s.size, hat.size // 2
        strain = (self.ahead + self.jump * self.s).astype(float)
        stiffness = self.law.elastic.second(strain) / float(self.speed) ** 2
        drag = self.law.viscous.second(strain) / float(self.speed)
        offsets = range(-width, width + 1)
        hat, sign = (sparse.diags(of, offsets, shape=(size, size)) for of in (hat, sign))
        slopes = sparse.eye(size) - hat @ sparse.diags(stiffness) - sign @ sparse.diags(drag)
        of_speed = (2 * self.s - self.on_points(self.sign * self.waves()[2])).astype(float)
        phase = sparse.eye(1, size, self.middle)
        matrix = sparse.bmat([[slopes, of_speed[:, None]], [phase, None]], format="csc")
        order = np.r_[1 : self.middle + 1, size, self.middle + 1 : size, 0]
        return order, splu(matrix[order], permc_spec="NATURAL", diag_pivot_thresh=0.0)

    def velocity(self) -> np.ndarray:
        """Return ẋ at the points."""
        _, p, q = self.waves()
        share = self.on_points(self.site * p + self.back * q) - self.pq(self.s)[1]
        return -self.speed * (self.ahead + self.jump * share)

    def at(self, xi: Any, amplitudes: np.ndarray) -> Any:
        """Return a sum of waves at one ξ."""
        place = REAL(xi) - self.xi[0] + self.left * self.h
        terms = 2 * (amplitudes * np.exp(1j * self.k * place)).real
        return (terms.sum() - (terms[0] + terms[-1]) / 2) / self.ramp.size

    def _root(self, xi: Any, amplitudes: np.ndarray, level: Any) -> Any:
        """Return where a sum of waves has a value, next to ξ."""
        for _ in range(6):
            slope = self.at(xi, 1j * self.k * amplitudes)
            xi = xi - (self.at(xi, amplitudes) - level) / slope
        return xi

    def _largest(self, amplitudes: np.ndarray) -> Any:
        """Return the largest value of a sum of waves."""
        top = self.xi[int(np.argmax(self.on_points(amplitudes)))]
        return self.at(self._root(top, 1j * self.k * amplitudes, 0), amplitudes)

    def measures(self) -> dict[str, Any]:
        """Return the overshoot, width, slope and dissipated power."""
        waves, _, q = self.waves()
        size, slope, drag = np.abs(self.jump), 1j * self.k * waves, 1j * self.k * q
        last = (np.flatnonzero(self.s >= REAL(level) / 10)[-1] for level in (9, 1))
        starts = (self.xi[place] + self.h / 2 for place in last)
        high, low = (self._root(next(starts), waves, REAL(level) / 10) for level in (9, 1))
        lost = np.sum(self.on_points(drag) * self.on_points(slope))
        over = self._largest(waves) - 1 if self.s.max() > 1 + REAL("1e-17") else REAL(0)
        return {
            "overshoot": size * max(over, REAL(0)),
            "width_10_90": low - high,
            "slope": size * self._largest(-slope),
            "dissipated_power": self.speed**3 * self.jump**2 * self.h * lost,
        }


def judge(front: xr.Dataset, rng: np.random.Generator) -> Iterator[Number]:
    """Compare all numbers of a front with what they should be."""
    for parts in (2, 3, 4):
        true = TrueFront(front, parts)
        if not true.fits or true.tail < LEFT_OUT:
            break
    known = ENOUGH * front.attrs["error_estimate"] / float(np.abs(true.jump))
    if not true.fits or true.left_over > known or abs(true.defect) > known:
        return
    xi = front["xi"].values
    first = true.middle - int(np.argmin(np.abs(xi))) * true.parts
    strain = true.ahead + true.jump * true.s
    for name, values in (("strain", strain), ("velocity", true.velocity())):
        found, kept = front[name], values[first :: true.parts][: xi.size]
        error, largest = (float(np.abs(of).max()) for of in (kept - found.values, kept))
        yield name, found.attrs["error_estimate"], error, largest
    places = rng.uniform(max(xi[0], -20.0), xi[-1], 12)
    waves, *_ = true.waves()
    exact = np.array([true.ahead + true.jump * true.at(place, waves) for place in places])
    error = float(np.abs(evaluate_front(front, places, "strain") - exact).max())
    largest = float(np.abs(strain).max())
    yield "evaluated", front.attrs["error_estimate"], error, largest
    for name, value in true.measures().items():
        stated, found = front.attrs[f"{name}_error"], front.attrs[name]
        yield name, stated, float(abs(found - value)), float(abs(value))
    defect = front.attrs["speed_defect"]
    yield "speed_defect", front.attrs["speed_defect_error"], abs(defect), 1.0


def _random_front(rng: np.random.Generator) -> tuple[dict[str, Any], tuple[float, float]]:
    """Return the law and states of a front of any kind."""
    kind = str(rng.choice(["powers"] * 5 + ["toda", "toda", "fpu", "morse", "lennard_jones"]))
    gamma = float(10 ** rng.uniform(-2.3, 1.9))
    if kind == "powers":
        alpha = 1.0 + float(10 ** rng.uniform(-2.3, 0.95))
        beta = [alpha, 1.0, float(rng.uniform(1.0, 3.0))][rng.integers(3)]
        ahead = float(-rng.uniform(0.0, 0.9)) if rng.random() < 0.25 else 0.0
        return {"alpha": alpha, "beta": beta, "gamma": gamma}, (-1.0, ahead)
    rate, behind = float(10 ** rng.uniform(-0.5, 0.5)), float(10 ** rng.uniform(-1.0, 1.0))
    ahead = 0.0 if rng.random() < 0.5 else float(rng.uniform(-0.5, 0.5)) * behind
    elastic: dict[str, Any] = {"kind": kind, "rate": rate}
    if kind == "fpu":
        elastic = {"kind": "fpu", "cubic": -rate, "quartic": float(rng.uniform(0.0, 1.0))}
    elif kind == "lennard_jones":
        elastic, behind, ahead = {"kind": kind}, 0.02 * behind, 0.02 * ahead
    ahead = ahead if kind == "toda" else min(ahead, 0.0)
    viscous = {"kind": str(rng.choice(["linear", "proportional"])), "gamma": 0.3 * gamma}
    return {"elastic": elastic, "viscous": viscous}, (-behind, ahead)


def cases(seed: int, count: int) -> Iterator[Number]:
    """Judge the random fronts that there are."""
    for k, rng in enumerate(np.random.default_rng(seed).spawn(count)):
        law, states = _random_front(rng)
        try:
            front = solve_front(law=law, states=states)
        except InputError:
            continue
        if front.attrs["converged"]:
            for name, stated, true, largest in judge(front, rng):
                yield f"{name} {k}: {law} {states}", stated, true, largest
