"""Motion of a chain in extended precision, by a method that shares nothing with `chain`.

The unknowns are the positions x_n and the generalised velocities w_n, James (2021), eqs. (31) and
(32), in 80-bit arithmetic.  Within a step the slopes are a Chebyshev polynomial, found by Picard
iteration.  Its last coefficients measure the error, and it gives the state at every time.  Where a
contact opens or closes, a force is not smooth.  Steps shrink towards that instant, and the one that
straddles it is so short that the force does nothing in it.

From outside the package the stated errors of random chains are judged by it, and the stored states
of `tests/references` made.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from granular_fronts.chain.run import make_beads
from granular_fronts.errors import SolveError
from granular_fronts.scenes.chain import Chain, Equilibrium, Given, Piston, Striker

REAL = np.longdouble
PI = 4 * np.arctan(REAL(1))
DEGREE = 20
# Parts of the size of the motion: error of a step, and what a force does in a step that straddles.
TOLERANCE, OTHER_TOLERANCE = REAL("1e-17"), REAL("1e-16")
# Compressions below this part of the largest one are noise ahead of a wave.
NOISE = REAL("1e-17")
MOST_ITERATIONS = 60
BISECTIONS, NEWTON_STEPS = 10, 4


def _chebyshev(theta: Any, count: int = DEGREE + 1) -> np.ndarray:
    """Return T_0 … at places in [−1, 1] and a little outside, on a further axis."""
    values = [np.ones_like(theta), theta]
    while len(values) < count:
        values.append(2 * theta * values[-1] - values[-2])
    return np.stack(values, axis=-1)


def _integrals(theta: Any) -> np.ndarray:
    """Return the integrals of T_0 … T_DEGREE from −1, on a further axis."""
    order = np.arange(2, DEGREE + 1).astype(REAL)
    above = _chebyshev(theta, DEGREE + 2)
    rest = above[..., 3:] / (2 * (order + 1)) - above[..., 1:-2] / (2 * (order - 1))
    rest = rest - (-1) ** order / (order**2 - 1)
    return np.concatenate([theta[..., None] + 1, (theta[..., None] ** 2 - 1) / 2, rest], axis=-1)


NODES = -np.cos(PI * np.arange(DEGREE + 1).astype(REAL) / DEGREE)
WEIGHTS = np.where(np.arange(DEGREE + 1) % DEGREE == 0, REAL(0.5), REAL(1))
TO_COEFFICIENTS = 2 * WEIGHTS[:, None] * _chebyshev(NODES).T * WEIGHTS / DEGREE
INTEGRATE = _integrals(NODES) @ TO_COEFFICIENTS / 2
# Where passages are looked for.
FINE = -np.cos(PI * np.arange(3 * DEGREE + 1).astype(REAL) / (3 * DEGREE))
FINE_VALUES, FINE_INTEGRALS = _chebyshev(FINE), _integrals(FINE)
DERIVATIVE = np.polynomial.chebyshev.chebder(np.eye(DEGREE + 1)).astype(REAL)


def power(u: np.ndarray, exponent: np.longdouble) -> np.ndarray:
    """Return u₊ to an exponent of 1 or more, by products and a root where that is possible."""
    u = np.maximum(u, 0)
    if 2 * exponent % 1 != 0 or exponent > 4:
        return u**exponent
    result = np.sqrt(u) if exponent % 1 else np.ones_like(u)
    for _ in range(int(exponent)):
        result = result * u
    return result


def force(kind: str, **parameters: float) -> Callable[[np.ndarray], np.ndarray]:
    """Return −V'(−u) of a potential of a named kind, as a function of the compression u."""
    p = {name: REAL(value) for name, value in parameters.items()}
    if kind in ("hertz", "power"):
        exponent, factor = p.get("alpha", p.get("beta")), p.get("stiffness", p.get("gamma"))
        return lambda u: factor * power(u, exponent)
    if kind == "linear":
        return lambda u: p["gamma"] * u
    if kind == "toda":
        return lambda u: p["strength"] * np.expm1(p["rate"] * u)
    if kind == "fpu":
        return lambda u: u * (p["quadratic"] + u * (u * p["quartic"] - p["cubic"]))
    if kind == "morse":
        return lambda u: (
            2 * p["depth"] * p["rate"] * np.exp(p["rate"] * u) * np.expm1(p["rate"] * u)
        )

    def lennard_jones(u):
        s = 1 / (1 - u / p["distance"])
        six = s**2 * s**2 * s**2
        return 12 * p["depth"] / p["distance"] * s * six * (six - 1)

    return lennard_jones


def forces(law: Mapping[str, Any]) -> tuple[Callable, bool]:
    """Return elastic and viscous force as functions of u, and whether 0 is a kink."""
    if "alpha" in law:
        elastic = {"kind": "hertz", "alpha": law["alpha"], "stiffness": 1.0}
        viscous = {"kind": "power", "beta": law["beta"], "gamma": law["gamma"]}
    else:
        elastic, viscous = law["elastic"], law["viscous"]
    first, kind, gamma = force(**elastic), viscous["kind"], REAL(viscous.get("gamma", 0))
    kinked = elastic["kind"] == "hertz" or kind == "power"
    if kind in ("none", "proportional", "kuwabara_kono") or law.get("alpha") == law.get("beta", 0):

        def both(u):
            f = first(u)
            return f, gamma * f

        return both, kinked
    if kind == "simon_hunt_crossley":
        viscous = {"kind": "power", "beta": REAL(elastic["alpha"]) + 1, "gamma": gamma}
    second = force(**viscous)
    return lambda u: (first(u), second(u)), kinked


class Passages(NamedTuple):
    """Times, contacts (from 0), u and u' there, and whether it rises (1) or falls (−1)."""

    time: np.ndarray
    contact: np.ndarray
    u: np.ndarray
    rate: np.ndarray
    direction: np.ndarray


class Step(NamedTuple):
    """One step: its start, length, state there, and the coefficients of its slopes."""

    start: np.longdouble
    length: np.longdouble
    state: np.ndarray
    coefficients: np.ndarray


class Motion:
    """A solved scene: `steps`, from which the methods read off what is recorded.

    Parameters
    ----------
    scene : mapping or granular_fronts.Chain
        A chain scene, as `simulate_chain` takes it, but no start in equilibrium.
    tolerance : float, optional
        Error of a step, relative to the size of the motion.
    start : tuple of arrays, optional
        Relative displacements and velocities at t = 0 in extended precision, for those of a given
        start, which a scene holds in double precision.
    """

    def __init__(
        self,
        scene: Mapping[str, Any] | Chain,
        tolerance: Any = TOLERANCE,
        start: tuple[np.ndarray, np.ndarray] | None = None,
    ) -> None:
        if np.finfo(REAL).nmant < 63:
            raise SolveError(
                f"numpy.longdouble has a significand of {np.finfo(REAL).nmant + 1} bits here and "
                "64 are needed for a reference: compute it on an x86-64 machine."
            )
        scene = Chain.read(scene)
        self.beads, boundary = scene.beads.count, scene.boundary
        self.forces, self.kinked = forces(scene.law.describe())
        self.ring, self.wall = (boundary.kind == kind for kind in ("ring", "wall"))
        varied = make_beads(scene)
        if isinstance(scene.start, Equilibrium):
            raise SolveError("The reference knows no equilibrium: list the start.")
        self.mass, *factors = (np.ones(self.beads, dtype=REAL) * part for part in varied[:3])
        contacts = slice(None if self.ring or self.wall else -1)
        self.elastic_factor, self.viscous_factor = (factor[contacts] for factor in factors)
        self.gravity = REAL(varied.gravity)
        # The most that a contact's force does to a bead, over that of the law to a bead of mass 1.
        self.strength = max(factor.max() for factor in factors) / self.mass.min()
        self.pieces = np.array(boundary.pieces(), dtype=REAL).T
        driven = "velocity" if isinstance(boundary, Piston) else "force"
        self.driven = driven if self.pieces.size else None
        self.piece = 0
        ends = np.array([boundary.left_end, boundary.right_end], dtype=REAL)
        self.right = ends[1]
        self.held = self.forces(ends)
        u, velocity = start or self._start(scene.start, boundary.at_start)
        self.turn = u.sum() if self.ring else REAL(0)
        x = np.concatenate([[REAL(0)], -np.cumsum(u)])[: self.beads]
        if self.wall:
            x += u.sum()
        still = np.concatenate([x, np.zeros(self.beads, dtype=REAL)])
        shift = self.slopes(np.zeros(1, dtype=REAL), still[None])[0, : self.beads]
        if self.driven == "velocity":
            shift[0] = velocity[0]
        state = np.concatenate([x, velocity - shift])
        weight = np.abs(self.gravity) * self.mass.sum()
        driven = np.array([*u, *velocity, *ends, boundary.largest, weight])
        self.size = np.abs(driven).max()
        self.tolerance = tolerance * self.size
        self.steps: list[Step] = []
        now, end = REAL(0), REAL(scene.end_time)
        breaks = self.pieces[0][1:] if self.driven else np.empty(0)
        for self.piece, goal in enumerate([*breaks[breaks < end], end]):
            state = self._advance(now, goal, state)
            now = goal

    def _start(self, start, at_start):
        u, velocity = np.zeros_like(self.elastic_factor), np.zeros(self.beads, dtype=REAL)
        if isinstance(start, Striker):
            velocity[: start.beads] = start.velocity
        elif isinstance(start, Given):
            u[:], velocity[:] = start.relative_displacement, start.velocity
        elif self.driven == "velocity":
            velocity[0] = at_start
        return u, velocity

    def drive(self, t):
        """Return the force on bead 1 or its velocity, of no piece later than the present one."""
        row = np.searchsorted(self.pieces[0], t, side="right") - 1
        start, *formula = self.pieces[:, np.clip(row, 0, self.piece)]
        constant, rate, amplitude, frequency, phase = formula
        s = t - start
        return constant + rate * s + amplitude * np.sin(frequency * s + phase)

    def drive_rate(self, t):
        """Return the rate of the drive."""
        row = np.searchsorted(self.pieces[0], t, side="right") - 1
        start, _, rate, amplitude, frequency, phase = self.pieces[:, row]
        return rate + amplitude * frequency * np.cos(frequency * (t - start) + phase)

    def compression(self, state):
        """Return the compressions of the moving contacts, of states whose last axis is (x, w)."""
        u = self._differences(state[..., : self.beads])
        if self.ring:
            u[..., -1] += self.turn
        return u

    def _differences(self, x):
        """Return x_n − x_(n+1) over the moving contacts, from x or its rates."""
        if self.ring:
            return x - np.roll(x, -1, axis=-1)
        u = x.copy()
        u[..., :-1] -= x[..., 1:]
        return u if self.wall else u[..., :-1]

    def slopes(self, t, states):
        """Return (ẋ, ẇ) of states, shape (times, 2 N)."""
        out, beads = np.empty_like(states), self.beads
        transmitted = np.empty((2, len(states), beads + 1), dtype=REAL)
        moving = slice(1, 1 + self.elastic_factor.size)
        elastic, viscous = self.forces(self.compression(states))
        transmitted[1, :, moving] = self.elastic_factor * elastic
        transmitted[0, :, moving] = self.viscous_factor * viscous
        if self.ring:
            transmitted[:, :, 0] = transmitted[:, :, -1]
        else:
            held = [0] if self.wall else [0, -1]
            transmitted[1, :, held] = self.held[0][: len(held), None]
            transmitted[0, :, held] = self.held[1][: len(held), None]
        if self.driven == "force":
            transmitted[0, :, 0], transmitted[1, :, 0] = 0, self.drive(t)
        viscous, elastic = (transmitted[:, :, :-1] - transmitted[:, :, 1:]) / self.mass
        out[:, :beads], out[:, beads:] = states[:, beads:] + viscous, elastic + self.gravity
        if self.driven == "velocity":
            out[:, 0], out[:, self.beads] = self.drive(t), 0
        return out

    def _advance(self, now, goal, state):
        length = min(REAL("1e-6"), goal - now)
        while now < goal:
            length = min(self._before_a_kink(now, state, length), goal - now)
            states, slopes = self._try(now, state, length)
            if states is None:
                length /= 2
                continue
            coefficients = TO_COEFFICIENTS @ slopes
            error = length * np.abs(coefficients[-2:]).max()
            crossing = self._first_harmful_kink(states, length)
            if crossing < 1:
                length *= max(0.6 * crossing, REAL("0.1"))
                continue
            factor = 0.8 * (self.tolerance / max(error, REAL("1e-30"))) ** (REAL(1) / DEGREE)
            if error > self.tolerance:
                length *= min(max(factor, REAL("0.1")), REAL("0.8"))
                continue
            self.steps.append(Step(now, length, state, coefficients))
            state = states[-1]
            now = goal if length == goal - now else now + length
            length *= min(factor, REAL(5))
        return state

    def _try(self, now, state, length):
        """Return states and slopes at the nodes, or None where the iteration does not converge."""
        times = now + length * (NODES + 1) / 2
        states, last = np.repeat(state[None], DEGREE + 1, axis=0), REAL(np.inf)
        floor = REAL("1e-20") * self.size
        for iteration in range(MOST_ITERATIONS):
            slopes = self.slopes(times, states)
            found = state + length * (INTEGRATE @ slopes)
            change = np.abs(found - states).max()
            states = found
            if not np.isfinite(change) or (iteration > 5 and change > last and last > 1e-12):
                return None, None
            if change <= floor or (change >= last and change < 100 * self.tolerance):
                return states, self.slopes(times, states)
            last = change
        return None, None

    def _effect(self, size, length):
        """Return what a kink of a contact of some size can do within a length of time."""
        elastic, viscous = self.forces(size)
        return self.strength * length * (np.abs(viscous) + length * np.abs(elastic))

    def _before_a_kink(self, now, state, length):
        """Return length, or a shorter one that keeps its distance from a contact's next zero."""
        if not self.kinked:
            return length
        u = self.compression(state)
        rate = self._differences(self.slopes(np.full(1, now), state[None])[0, : self.beads])
        nearing = (u * rate < 0) & (np.abs(u) < 2 * length * np.abs(rate))
        nearing &= self._effect(np.abs(rate) * length, length) > self.tolerance
        u, rate = np.abs(u[nearing]), np.abs(rate[nearing])
        for size, ahead in zip(u, u / rate, strict=True):
            effect = self._effect(size, ahead) / self.tolerance
            if effect < 0.1:
                length = min(length, 3 * ahead)
                continue
            # The coefficients fall like powers of ρ, the ellipse that the zero lies on.
            rho = max(effect, REAL(1)) ** (REAL(1) / DEGREE) + REAL("0.15")
            length = min(length, ahead * 4 / (2 + rho + 1 / rho))
        return length

    def _first_harmful_kink(self, states, length):
        """Part of the step after which a contact passes 0 with a force that matters, or 1."""
        if not self.kinked:
            return REAL(1)
        u = self.compression(states)
        low, high = u.min(axis=0), u.max(axis=0)
        passes = (low < 0) & (high > 0)
        passes &= self._effect(np.minimum(-low, high), length) > 0
        if not passes.any():
            return REAL(1)
        harmful = passes & (self._effect(high - low, length) > self.tolerance)
        harmful &= np.minimum(-low, high) > NOISE * self.size * REAL("1e-3")
        if not harmful.any():
            return REAL(1)
        first = np.argmax(u[:, harmful] * u[0, harmful] < 0, axis=0).min()
        return (NODES[max(first, 1)] + 1) / 2 if first < DEGREE else REAL("0.99")

    def states(self, times):
        """Return the compressions of the moving contacts and velocities at some times."""
        starts = np.array([step.start for step in self.steps])
        times = np.asarray(times).astype(REAL)
        rows = np.clip(np.searchsorted(starts, times, side="right") - 1, 0, None)
        states = np.empty((times.size, 2 * self.beads), dtype=REAL)
        for row in np.unique(rows):
            here = rows == row
            step = self.steps[row]
            theta = 2 * (times[here] - step.start) / step.length - 1
            states[here] = step.state + step.length / 2 * _integrals(theta) @ step.coefficients
        return self.compression(states), self.slopes(times, states)[:, : self.beads]

    def passages(self, level: float | None = None) -> Passages:
        """Return all passages of any contact through a level, or else through u' = 0."""
        found = [self._passages_of(step, level) for step in self.steps]
        return Passages(*map(np.concatenate, zip(*found, strict=True)))

    def _passages_of(self, step, level):
        rates = self._differences(step.coefficients[:, : self.beads])
        offset = self.compression(step.state)
        half = step.length / 2

        def u_at(theta, contacts):
            return offset[contacts] + half * (_integrals(theta) * rates[:, contacts].T).sum(axis=-1)

        def rate_at(theta, contacts, of=rates):
            return (_chebyshev(theta, len(of)) * of[:, contacts].T).sum(axis=-1)

        if level is None:
            values, value_at = FINE_VALUES @ rates, rate_at
            slope_at = partial(rate_at, of=DERIVATIVE @ rates)
        else:
            values = offset + half * (FINE_INTEGRALS @ rates) - REAL(level)
            value_at = lambda *place: u_at(*place) - REAL(level)  # noqa: E731
            slope_at = lambda *place: half * rate_at(*place)  # noqa: E731
        rises = (values[:-1] <= 0) & (values[1:] > 0)
        falls = (values[:-1] > 0) & (values[1:] <= 0)
        rows, contacts = np.nonzero(rises | falls)
        direction = np.where(rises[rows, contacts], 1, -1)
        low, high = FINE[rows], FINE[rows + 1]
        if not rows.size:
            return Passages(low, contacts, low, low, direction)
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            beyond = direction * value_at(middle, contacts) > 0
            low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
        theta = (low + high) / 2
        for _ in range(NEWTON_STEPS):
            moved = theta - value_at(theta, contacts) / slope_at(theta, contacts)
            theta = np.clip(moved, low, high)
        time = step.start + half * (theta + 1)
        return Passages(time, contacts, u_at(theta, contacts), rate_at(theta, contacts), direction)
