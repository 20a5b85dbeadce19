"""Amplitude equations for strength ratios near one and their fronts (James 2021, sections 4, 5)."""

from granular_fronts import compiled  # noqa: F401  (decides the cache folder before any kernel)
