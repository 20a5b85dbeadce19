"""Amplitude equations of the chain and their fronts (James 2021, sections 4 and 5)."""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
from granular_fronts.continuum.warming import warm_up

__all__ = ["warm_up"]
