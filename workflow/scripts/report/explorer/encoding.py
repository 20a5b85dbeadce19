r"""Arrays as whole numbers of 16 bits, with the error of rounding them.

A row :math:`a_{i1}, a_{i2}, \dots` of an array becomes whole numbers :math:`k_{ij}` of a step
:math:`s_i` of its own,

.. math::

    a_{ij} \approx s_i k_{ij}, \qquad s_i = \max_j |a_{ij}| / 32767, \qquad
    |a_{ij} - s_i k_{ij}| \le s_i / 2.

Zero stays zero, and no sign changes: a contact that is closed in the data is not open on the page.
The code -32768 stands for a missing value.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

LARGEST_CODE = 2**15 - 1
MISSING = -LARGEST_CODE - 1


def encode(values: npt.ArrayLike) -> dict[str, Any]:
    """Round each row of an array: its codes, its steps, and the largest error of rounding."""
    given = np.asarray(values, dtype=float)
    present = np.nan_to_num(given)
    steps = np.abs(present).max(axis=-1) / LARGEST_CODE
    # A row of zeros has no step.
    multiples = present / np.where(steps > 0.0, steps, 1.0)[..., None]
    codes = np.where(np.isnan(given), MISSING, np.rint(multiples)).astype(np.int16)
    encoded = {"codes": codes, "steps": steps}
    return encoded | {"rounding": float(np.nan_to_num(np.abs(decode(encoded) - given)).max())}


def decode(encoded: dict[str, Any]) -> np.ndarray:
    """Return the values that the page shows, as its scripts compute them."""
    values = encoded["codes"] * encoded["steps"][..., None]
    return np.where(encoded["codes"] == MISSING, np.nan, values)
