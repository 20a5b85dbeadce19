r"""Values along a chain from a pattern: masses of beads, or factors of the forces of contacts.

For n = 1 … N, what the keys of a pattern give is multiplied:

- `cell` c of length p: :math:`c_{(n-1) \bmod p + 1}`;
- `taper`: :math:`q^{n-1}` of a ratio q, or :math:`1 + s\,(n-1)` of a difference s;
- `random`: :math:`1 + s\,(2U_n - 1)`, spread s, with independent uniform :math:`U_n` from NumPy's
  PCG64 generator of the given seed;
- `list`: a value for each n.

An `impurity` then replaces the value at a single place.
"""

import numpy as np

from granular_fronts.scenes.beads import Pattern


def values_along(pattern: Pattern, count: int) -> np.ndarray:
    """Return the values of a pattern, shape (count,)."""
    place = np.arange(count)
    values = np.resize(pattern.cell or (1.0,), count)
    if pattern.taper:
        values = values * pattern.taper.ratio**place * (1.0 + pattern.taper.difference * place)
    if pattern.random:
        draw = np.random.default_rng(pattern.random.seed).random(count)
        values = values * (1.0 + pattern.random.spread * (2.0 * draw - 1.0))
    if pattern.list is not None:
        values = values * np.asarray(pattern.list)
    for number, value in pattern.placed().items():
        values[number - 1] = value
    return values
