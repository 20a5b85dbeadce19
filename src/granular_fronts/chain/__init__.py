"""Dissipative granular chains: equations, compiled integrator, scenes (James 2021, section 3)."""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
from granular_fronts.chain.simulate import simulate_chain, warm_up

__all__ = ["simulate_chain", "warm_up"]
