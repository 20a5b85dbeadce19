"""Continuum limits of the chain: amplitude equations and fronts (James 2021, sections 4, 5)."""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
