"""Random rings: stated errors, and differences to a much finer solution."""

from collections.abc import Iterator

import numpy as np

from granular_fronts.campaign.ring_points import make_ring
from granular_fronts.errors import InputError
from granular_fronts.studies.ring_limit import Resolution, Ring, compare, resolutions
from true_chains import Number


class _Finest(Resolution):
    """A resolution that puts places between the beads where the usual one does."""

    def holds_between_beads(self, epsilon: float) -> bool:
        """Whether the usual waves are longer than two beads."""
        return resolutions(1.0)[0].holds_between_beads(epsilon)


def _finest(tolerance: float) -> tuple[Resolution, Resolution]:
    """Return the finest resolution, twice: its own error is not asked for."""
    return (_Finest(16.0, 32, 0.03125, 1e-3 * tolerance, 1e-3 * tolerance),) * 2


def _random_ring(rng: np.random.Generator) -> tuple[Ring, float]:
    """Return a ring, and a slow time."""
    alpha = float(rng.choice([1.05, 1.1, 1.2, 1.3, 1.5]))
    point = {"alpha": alpha, "delta": 1.0, "mu": float(np.exp(rng.uniform(np.log(0.5), np.log(8))))}
    point |= {"half_length": rng.uniform(7, 12), "half_width": rng.uniform(1.5, 3)}
    point |= {"base": rng.uniform(0.1, 0.5)}
    start = {"profile": str(rng.choice(["pulse", "front"]))}
    start |= {"velocity": str(rng.choice(["slow", "leading"]))}
    return make_ring(point, start), rng.uniform(0.3, 1.5)


def cases(seed: int, count: int) -> Iterator[Number]:
    """Compare random rings with finer ones."""
    for index in range(count):
        rng = np.random.default_rng([seed, index])
        try:
            ring, slow_time = _random_ring(rng)
            found = compare(ring, np.array([slow_time]), 10 ** rng.uniform(-8, -5))
            true = compare(ring, np.array([slow_time]), 1e-8, resolve=_finest)
        except InputError:  # The wave does not fit into so few beads.
            continue
        for name, ([value], [stated]) in found.items():
            [exact], _ = true[name]
            both = np.isfinite(value) and np.isfinite(exact)
            # Slow times between which losses are interpolated are part of their definition.
            if both and not name.startswith("lost_") and not name.endswith("_of_ring"):
                yield f"{name} {index}", float(stated), float(abs(value - exact)), 1.0
