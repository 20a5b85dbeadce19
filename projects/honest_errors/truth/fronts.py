"""Fronts in extended precision by Fourier's method, and the true errors of the package.

The profile equation is solved again on a longer window and a finer grid.  Its convolutions are
multiplications of Fourier amplitudes, its forces are written once more, and the residual is taken
in extended precision.  Rules and matrix of the package lead Newton's iteration there, and have no
part in where it ends.
"""

import math
from fractions import Fraction
from functools import partial

import numpy as np
from scipy.linalg import lapack

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.numerics.quadrature import kernel_weights

Number = np.longdouble
LARGEST_MATRIX = 12_000_000
SETTLED = 2e-18
LEFT_OUT = 1e-17

# Of the stated error; where more is left, extended precision is not enough for a judge.
ENOUGH = 0.5


def hertz(r, order, alpha, stiffness=1):
    """Return V' (order 1) or V'' of (−r)₊^(α+1)/(α + 1)."""
    u = np.maximum(-r, Number(0))
    return stiffness * (-(u**alpha) if order == 1 else alpha * u ** (alpha - 1))


def power(r, order, beta, gamma):
    """Return W' or W'' of a viscous power."""
    return hertz(r, order, beta, gamma)


def linear(r, order, gamma):
    """Return W' or W'' of a dashpot."""
    return gamma * (r if order == 1 else np.ones_like(r))


def toda(r, order, rate=1, strength=1):
    """Return V' or V'' of the Toda potential."""
    return strength * (-np.expm1(-rate * r) if order == 1 else rate * np.exp(-rate * r))


def fpu(r, order, quadratic=1, cubic=0, quartic=0):
    """Return V' or V'' of the Fermi–Pasta–Ulam potential."""
    if order == 1:
        return quadratic * r + cubic * r**2 + quartic * r**3
    return quadratic + 2 * cubic * r + 3 * quartic * r**2


def morse(r, order, rate=1, depth=1):
    """Return V' or V'' of the Morse potential."""
    decay = np.exp(-rate * r)
    if order == 1:
        return -2 * depth * rate * decay * np.expm1(-rate * r)
    return 2 * depth * rate**2 * decay * (2 * decay - 1)


def lennard_jones(r, order, distance=1, depth=1):
    """Return V' or V'' of the Lennard-Jones potential with its minimum at r = 0."""
    s = 1 + r / distance
    if order == 1:
        return -12 * depth / distance * (s**-13 - s**-7)
    return 12 * depth / distance**2 * (13 * s**-14 - 7 * s**-8)


SHAPES = {
    shape.__name__: shape for shape in (hertz, power, linear, toda, fpu, morse, lennard_jones)
}


def _force_of(mapping, elastic=None):
    """Return ``force(r, order)`` of a described potential."""
    given = {name: Number(value) for name, value in mapping.items() if name != "kind"}
    if mapping["kind"] == "proportional":
        return lambda r, order: given["gamma"] * elastic(r, order)
    return partial(SHAPES[mapping["kind"]], **given)


class TrueFront:
    """A front of a law between two states, from one of the package.

    Parameters
    ----------
    front : xarray.Dataset
        From `solve_front`, a start for the iteration.
    law : dict
        With `elastic` and `viscous`.
    behind, ahead : float

    Attributes
    ----------
    residual : float
        What the last iteration changed.
    """

    def __init__(self, front, law, behind, ahead, parts=2):
        self.elastic = _force_of(law["elastic"])
        self.viscous = _force_of(law["viscous"], self.elastic)
        self.behind, self.ahead = Number(behind), Number(ahead)
        self.jump = self.behind - self.ahead
        ends = np.array([self.behind, self.ahead])
        (behind_force, self.ahead_force), self.ahead_drag = (
            self.elastic(ends, 1),
            self.viscous(ends, 1)[1],
        )
        self.speed = np.sqrt((behind_force - self.ahead_force) / self.jump)
        xi = front["xi"].values
        middle = int(np.argmin(np.abs(xi)))
        given = xi[middle + 1]
        given = Fraction(1, round(1 / given)) if given < 1.0 else Fraction(round(given))
        self.parts = parts if given <= 1 else int(given)
        self.spacing = given / self.parts
        self.middle = math.ceil(1.25 * middle) * self.parts
        points = self.middle + 1 + math.ceil(1.25 * (xi.size - middle)) * self.parts
        self.xi = Number(self.spacing.numerator) / Number(self.spacing.denominator)
        self.h, self.xi = self.xi, self.xi * np.arange(-self.middle, points - self.middle)
        start = evaluate_front(front, self.xi.astype(float), "strain").astype(Number)
        self.s = (start - self.ahead) / self.jump
        self.given = slice(self.middle % self.parts, None, self.parts)
        self.fits = points * (3 * (math.ceil(1 / self.spacing) + 9) + 2) < LARGEST_MATRIX
        if self.fits:
            self.prepare()
            self.solve()

    def p(self, s, order=1):
        """Return p(s), or p'(s) for order 2."""
        r = self.ahead + self.jump * s
        if order == 2:
            return self.elastic(r, 2) / self.speed**2
        return (self.elastic(r, 1) - self.ahead_force) / (self.speed**2 * self.jump)

    def q(self, s, order=1):
        """Return q(s), or q'(s) for order 2."""
        r = self.ahead + self.jump * s
        if order == 2:
            return self.viscous(r, 2) / self.speed
        return (self.viscous(r, 1) - self.ahead_drag) / (self.speed * self.jump)

    def prepare(self):
        """Ramp that makes the front a pulse on a ring, and multipliers of the convolutions."""
        width = 34
        bell = np.exp(-((np.arange(-width, width + 1, dtype=Number) / Number("3.3")) ** 2) / 2)
        reach = math.ceil(2 / self.spacing) + 40
        rise = np.cumsum(bell) / bell.sum()
        self.left = 2 * reach + rise.size
        size = self.left + self.s.size + reach
        size += size % 2
        self.ramp = np.ones(size, Number)
        self.ramp[:reach] = 0
        self.ramp[reach : reach + rise.size] = rise
        self.pulse_size = size
        self.k = 2 * Number("3.14159265358979323846264338328") * np.arange(size // 2 + 1)
        self.k /= size * self.h
        half = self.k / 2
        with np.errstate(invalid="ignore"):
            sinc = np.where(half == 0, Number(1), np.sin(half) / half)
        self.hat, self.drag = sinc**2, -1j * self.k * sinc**2
        self.site, self.back = np.exp(-1j * half) * sinc, np.exp(-2j * half)

    def pulse(self, function=lambda s: s):
        """Return amplitudes of a function of s; s is 1 before the first point, 0 after the last.

        A state behind that were left to the first point would not be held by any equation.
        """
        whole = np.zeros(self.pulse_size, Number)
        whole[: self.left] = 1
        whole[self.left : self.left + self.s.size] = self.s
        return np.fft.rfft(function(whole) * self.ramp)

    def on_points(self, amplitudes):
        """Return the values at the points of the front."""
        return np.fft.irfft(amplitudes, self.pulse_size)[self.left : self.left + self.s.size]

    def solve(self):
        """Newton's iteration with the matrix of the start."""
        solve, corner, border, column = self.factors()
        speed = Number(1)
        self.residual, least = math.inf, math.inf
        for _ in range(12):
            p, q = self.pulse(self.p), self.pulse(self.q)
            tail = max(np.abs(a[-a.size // 20 :]).max() / np.abs(a).max() for a in (p, q))
            residual = speed**2 * self.s - self.on_points(self.hat * p + speed * self.drag * q)
            right = np.roll(residual, -1)
            right[self.middle + 1 :] = residual[self.middle + 1 :]
            right[self.middle] = self.s[self.middle] - Number(0.5)
            x = solve(right.astype(float))
            change = (float(residual[0]) - border @ x[: border.size]) / (
                corner - border @ column[: border.size]
            )
            x -= change * column
            self.residual = float(np.abs(x).max())
            self.s, speed = self.s - x, speed - change
            if self.residual < SETTLED or self.residual > 0.5 * least:
                break
            least = self.residual
        self.defect, self.tail = float(speed - 1), float(tail)

    def factors(self):
        """Return the matrix of the package's rules for the start, factorised by LAPACK."""
        weights = kernel_weights(self.spacing, 20)
        w, n, middle = weights.hat.size // 2, self.s.size, self.middle
        s = self.s.astype(float).astype(Number)
        stiffness, drag = (f(s, 2).astype(float) for f in (self.p, self.q))
        upper = w + 1
        band = np.zeros((2 * w + upper + 1, n))
        border = np.zeros(w + 1)
        for d in range(-w, w + 1):
            column = -(weights.hat[d + w] * stiffness + weights.jump[d + w] * drag) + (d == 0)
            first, last = max(1 + d, 0), min(middle + 1 + d, n)
            band[w + upper - d - 1, first:last] = column[first:last]
            first, last = max(middle + 1 + d, 0), min(n + d, n)
            band[w + upper - d, first:last] = column[first:last]
            if d >= 0:
                border[d] = column[d]
        band[w + upper, middle] = 1.0
        amplitudes = self.pulse(self.q)
        slope = (2 * self.s - self.on_points(self.drag * amplitudes)).astype(float)
        right = np.roll(slope, -1)
        right[middle + 1 :] = slope[middle + 1 :]
        right[middle] = 0.0
        factors, pivots, _ = lapack.dgbtrf(band, w, upper)

        def solve(x):
            return lapack.dgbtrs(factors, w, upper, x, pivots)[0]

        return solve, slope[0], border, solve(right)

    def velocity(self):
        """Return ẋ at the points."""
        p, q = self.pulse(self.p), self.pulse(self.q)
        share = self.on_points(self.site * p + self.back * q) - self.q(self.s)
        return -self.speed * (self.ahead + self.jump * share)

    def at(self, xi, amplitudes):
        """Return a sum of waves at one ξ."""
        place = Number(xi) - self.xi[0] + self.left * self.h
        terms = 2 * (amplitudes * np.exp(1j * self.k * place)).real
        terms[0] /= 2
        terms[-1] /= 2
        return terms.sum() / self.pulse_size

    def root(self, xi, amplitudes, level):
        """Return where a sum of waves has a value, next to ξ."""
        slope = 1j * self.k * amplitudes
        for _ in range(6):
            xi = xi - (self.at(xi, amplitudes) - level) / self.at(xi, slope)
        return xi

    def largest(self, amplitudes):
        """Return the largest value of a sum of waves."""
        top = int(np.argmax(self.on_points(amplitudes)))
        place = self.root(self.xi[top], 1j * self.k * amplitudes, 0)
        return self.at(place, amplitudes)

    def measures(self):
        """Return the overshoot, width, slope and dissipated power."""
        waves, size = self.pulse(), np.abs(self.jump)
        slope = 1j * self.k * waves
        levels = []
        for level in (Number(9) / 10, Number(1) / 10):
            last = np.flatnonzero(self.s >= level)[-1]
            levels.append(self.root(self.xi[last] + self.h / 2, waves, level))
        steepness = self.on_points(slope)
        drag = self.q(self.s, 2) * self.speed**3 * self.jump**2
        return {
            "overshoot": size * max(self.largest(waves) - 1, Number(0))
            if self.s.max() > 1 + Number(1e-17)
            else Number(0),
            "width_10_90": levels[1] - levels[0],
            "slope": size * self.largest(-slope),
            "dissipated_power": self.h * np.sum(drag * steepness**2),
        }


def compare(front, law, behind, ahead, rng):
    """(name, stated error, true error, largest value, size) of all numbers of a front."""
    for parts in (2, 3, 4):
        true = TrueFront(front, law, behind, ahead, parts)
        if not true.fits or true.tail < LEFT_OUT:
            break
    known = ENOUGH * front.attrs["error_estimate"] / float(np.abs(true.jump))
    if not true.fits or true.residual > known or abs(true.defect) > known:
        return
    waves = true.pulse()
    fields = {"strain": true.ahead + true.jump * true.s, "velocity": true.velocity()}
    middle = int(np.argmin(np.abs(front["xi"].values)))
    first = true.middle - middle * true.parts
    for name, values in fields.items():
        found = front[name]
        kept = values[first :: true.parts][: found.size]
        stated = found.attrs["error_estimate"]
        error, largest = (float(np.abs(of).max()) for of in (kept - found.values, kept))
        yield name, stated, error, largest, found.size
    places = rng.uniform(max(front["xi"].values[0], -20.0), front["xi"].values[-1], 12)
    exact = np.array([true.ahead + true.jump * true.at(xi, waves) for xi in places])
    found = evaluate_front(front, places, "strain")
    size = float(np.abs(fields["strain"]).max())
    error = float(np.abs(found - exact).max())
    yield "evaluated", front.attrs["error_estimate"], error, size, found.size
    for name, value in true.measures().items():
        stated, found = front.attrs[f"{name}_error"], front.attrs[name]
        yield name, stated, float(abs(found - value)), float(abs(value)), 1
    defect = front.attrs["speed_defect"]
    yield "speed_defect", front.attrs["speed_defect_error"], abs(defect), 1.0, 1


def _random_front(rng):
    """Return the law and states of a front of any kind."""
    kind = rng.choice(["powers"] * 5 + ["toda", "toda", "fpu", "morse", "lennard_jones"])
    gamma = float(10 ** rng.uniform(-2.3, 1.9))
    if kind == "powers":
        alpha = 1.0 + float(10 ** rng.uniform(-2.3, 0.95))
        beta = [alpha, 1.0, float(rng.uniform(1.0, 3.0))][rng.integers(3)]
        law = {"kind": "hertz", "alpha": alpha}, {"kind": "power", "beta": beta, "gamma": gamma}
        ahead = float(-rng.uniform(0.0, 0.9)) if rng.random() < 0.25 else 0.0
        return law, (-1.0, ahead)
    rate, behind = float(10 ** rng.uniform(-0.5, 0.5)), float(10 ** rng.uniform(-1.0, 1.0))
    ahead = 0.0 if rng.random() < 0.5 else float(rng.uniform(-0.5, 0.5)) * behind
    elastic = {"kind": str(kind), "rate": rate}
    if kind == "fpu":
        elastic = {"kind": "fpu", "cubic": -rate, "quartic": float(rng.uniform(0.0, 1.0))}
        ahead = min(ahead, 0.0)
    elif kind == "morse":
        ahead = min(ahead, 0.0)
    elif kind == "lennard_jones":
        elastic, behind, ahead = {"kind": "lennard_jones"}, 0.02 * behind, min(0.02 * ahead, 0.0)
    viscous = {"kind": rng.choice(["linear", "proportional"]), "gamma": 0.3 * gamma}
    return (elastic, viscous | {"kind": str(viscous["kind"])}), (-behind, ahead)


def cases(seed, count):
    """Compare random fronts with true ones; numbers as of `truth.chains.cases`."""
    for k, rng in enumerate(np.random.default_rng(seed).spawn(count)):
        (elastic, viscous), states = _random_front(rng)
        law = {"elastic": elastic, "viscous": viscous}
        try:
            front = solve_front(law=law, states=states)
        except InputError:
            continue
        if front.attrs["converged"]:
            for name, *numbers in compare(front, law, *states, rng):
                yield f"{name} {k}: {law} {states}", *numbers
