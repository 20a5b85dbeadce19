r"""Problems at the edge of what the solvers can do, each with an answer known in another way.

Unless its name says otherwise, a chain has :math:`\alpha = \beta = 3/2`, :math:`\gamma = 0.1` and
40 beads at rest, and is pressed with :math:`\delta = 1`.
"""

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from granular_fronts.chain.simulate import solve
from granular_fronts.continuum.evolution import evolve_log_burgers
from granular_fronts.fronts.linear.critical_damping import critical_damping, meaning_changes_at
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.reference_methods.extended import OTHER_TOLERANCE, TOLERANCE, Motion
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain

RELATIVE, ABSOLUTE = 1.0e-13, 1.0e-15
BEADS, END_TIME = 40, 30.0
RING = {
    "law": {"alpha": 1.1, "gamma": 0.24},
    "displacement": 5,
    "half_beads": 80,
    "end_time": 90,
    "tolerance": {"relative": 1.0e-9, "absolute": 1.0e-12},
    "equations": {"logarithmic": {"cells": 1024, "tolerance": 1.0e-9}},
    "record": {"snapshots": [10.0, 90.0], "grid": {"step": 0.5}},
}


class Case(NamedTuple):
    """A solved problem, which has passed if its error is at most the limit; NaN is not."""

    answer: str
    error: float
    limit: float


def _chain(
    law: dict[str, float], beads: int, end_time: float, unit: float = 1.0, **ends: Any
) -> dict[str, Any]:
    """Return a pressed chain, whose displacements are as large as `unit`."""
    record = {"snapshots": [end_time], "balances": True}
    return pressed_chain(law, beads, end_time, (RELATIVE, ABSOLUTE * unit), record, **ends)


def _last(scene: dict[str, Any]) -> np.ndarray:
    """Return the relative displacements and velocities at the end."""
    last = solve(scene).dataset.isel(t=-1)
    return np.stack([last["relative_displacement"].values, last["velocity"].values])


def _largest(difference: np.ndarray) -> float:
    return float(np.abs(difference).max())


def _front_starts(alpha: float = 1.5, gamma: float = 0.1, beta: float | None = None) -> Case:
    """A front starts, as in section 3.3."""
    scene = _chain(kuwabara_kono(alpha, gamma) | {"beta": beta or alpha}, BEADS, END_TIME)
    known, other = (
        np.hstack(Motion(scene, tolerance).states([scene["end_time"]]))[0]
        for tolerance in (TOLERANCE, OTHER_TOLERANCE)
    )
    u, velocity = _last(scene)
    distance = _largest(np.append(u[:-1], velocity) - known) + _largest(known - other)
    return Case("collocation in 80-bit arithmetic", distance, 1.0e-12)


def _at_another_pressure(delta: float) -> Case:
    """With x = δ x̂ and t = δ^{(1−α)/2} t̂ no motion depends on δ, (27)-(30)."""
    time = delta**-0.25  # for α = 3/2
    law = kuwabara_kono(1.5, 0.1 * time)
    u, velocity = _last(_chain(law, BEADS, END_TIME * time, delta, left=delta)) / delta
    known = _last(_chain(kuwabara_kono(1.5, 0.1), BEADS, END_TIME))
    return Case("δ = 1, scaled", _largest(np.stack([u, velocity * time]) - known), 1.0e-12)


def _equal_waves(beads: int, period: int = 25) -> Case:
    """A ring of many copies of one wave moves like the ring of that wave."""
    phase = 2.0 * np.pi * np.arange(period) / period
    wave = np.stack([1.0 + 0.5 * np.cos(2.0 * phase), 0.15 * np.sin(phase)])
    known, found = (
        _last(
            _chain(kuwabara_kono(1.5, 0.1), copies * period, 10.0, start=np.tile(wave, copies))
            | {"boundary": {"kind": "ring"}}
        )
        for copies in (1, beads // period)
    )
    error = _largest(found - np.tile(known, beads // period))
    return Case(f"a ring of {period} beads", error, 1.0e-12)


def _long_motion(beads: int, gamma: float) -> Case:
    """Contacts open and close until t = 10⁴."""
    drifts = solve(_chain(kuwabara_kono(1.5, gamma), beads, 1.0e4, left=0.1)).drifts
    return Case("balances of momentum and energy", max(drifts.values()), 1.0e-12)


def _collision(alpha: float, gamma: float) -> Case:
    """Two free beads with velocities 1 and 0 meet; no γ, or α = β = 1, has a closed form."""
    start = [-1.0], [1.0, 0.0]
    scene = _chain(kuwabara_kono(alpha, gamma), 2, 20.0, left=0.0, right=0.0, start=start)
    restitution = math.exp(-gamma * math.pi / math.sqrt(2.0 - gamma**2))
    exact = np.array([1.0 - restitution, 1.0 + restitution]) / 2.0
    return Case("closed form", _largest(_last(scene)[1] - exact), 2.0e-12)


def _true_zeros() -> Case:
    """The start (49) without a floor: y ln y is not Lipschitz at 0, but its limit is regular."""
    start = {"kind": "plateau", "half_width": 10}
    y, known = (
        evolve_log_burgers(RING | {"start": start | {"floor": floor}})["rescaled_force"]
        for floor in (0.0, 1.0e-16)
    )
    error = max(_largest((y - known).values), y.attrs["error_estimate"])
    return Case("a floor of 10⁻¹⁶", error if float(y.min()) >= 0.0 else math.nan, 1.0e-5)


def _front(alpha: float, gamma: float, beta: float | None = None) -> Case:
    """An exact front by two methods that share no code."""
    profile, shot = (solve_front(alpha, gamma, beta, method) for method in ("profile", "shooting"))
    there = evaluate_front(profile, shot["xi"].values)
    error = _largest(shot["relative_displacement"].values - there)
    converged = profile.attrs["converged"] and shot.attrs["converged"]
    return Case("shooting", error if converged else math.nan, 1.0e-12)


CASES: dict[str, Callable[[], Case]] = {
    "a front starts, γ = 0": partial(_front_starts, gamma=0.0),
    "a front starts, γ = 0.001": partial(_front_starts, gamma=1.0e-3),
    "a front starts, γ = 20": partial(_front_starts, gamma=20.0),
    "a front starts, α = 1.001": partial(_front_starts, 1.001),
    "a front starts, α = 10": partial(_front_starts, 10.0),
    "a front starts, β = 1": partial(_front_starts, gamma=0.3, beta=1.0),
    "a front starts, δ = 10⁻⁸": partial(_at_another_pressure, 1.0e-8),
    "a front starts, δ = 10⁸": partial(_at_another_pressure, 1.0e8),
    "100 000 beads": partial(_equal_waves, 100_000),
    "hundreds of contact losses": partial(_long_motion, 420, 0.06),
    "chaotic bouncing": partial(_long_motion, 20, 1.0e-3),
    "elastic collision": partial(_collision, 1.5, 0.0),
    "collision with a dashpot": partial(_collision, 1.0, 0.5),
    "ring with true zeros": _true_zeros,
    "front, double root": lambda: _front(1.1, critical_damping(1.1)),
    "front, triple root": lambda: _front(alpha := meaning_changes_at(), critical_damping(alpha)),
    "front, γ = 0.01": partial(_front, 1.5, 0.01),
    "front, γ = 20": partial(_front, 1.5, 20.0),
    "front, α = 1.02": partial(_front, 1.02, 0.05),
    "front, α = 5": partial(_front, 5.0, 0.1),
    "front, β = 1": partial(_front, 1.5, 0.3, 1.0),
}
"""What solves each case, by its name."""
