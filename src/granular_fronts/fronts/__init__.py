"""Exact travelling fronts of the lattice (James 2021, section 6)."""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
