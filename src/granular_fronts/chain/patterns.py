r"""Values along a chain from a pattern: masses of beads, or factors of the forces of contacts.

For n = 1 … N, what the keys of a pattern give is multiplied:

- `cell` c of length p: :math:`c_{(n-1) \bmod p + 1}`;
- `taper`: :math:`q^{n-1}` of a ratio q, or :math:`1 + s\,(n-1)` of a difference s;
- `random`: :math:`1 + s\,(2U_n - 1)`, spread s, with independent uniform :math:`U_n` from NumPy's
  PCG64 generator of the given seed;
- `list`: a value for each n.

An `impurity` then replaces the value at a single place.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from granular_fronts.scenes.beads import impurities


def values_along(pattern: float | Mapping[str, Any], count: int) -> np.ndarray:
    """Return the values of a pattern, shape (count,)."""
    if not isinstance(pattern, Mapping):
        return np.full(count, float(pattern))
    place = np.arange(count)
    values = np.resize(np.asarray(pattern.get("cell", [1.0]), dtype=float), count)
    taper = pattern.get("taper", {})
    values = (
        values * taper.get("ratio", 1.0) ** place * (1.0 + taper.get("difference", 0.0) * place)
    )
    if "random" in pattern:
        draw = np.random.default_rng(pattern["random"]["seed"]).random(count)
        values *= 1.0 + pattern["random"]["spread"] * (2.0 * draw - 1.0)
    values *= np.asarray(pattern.get("list", 1.0), dtype=float)
    for place, value in impurities(pattern):
        values[place - 1] = value
    return values
