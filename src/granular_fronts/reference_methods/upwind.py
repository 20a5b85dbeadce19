r"""The explicit upwind scheme of James (2021), section 4.3, for comparison.

Equation (50), :math:`\partial_\tau Y + \ln Y\,\partial Y = \partial^2 Y`, on M equally spaced
points of the ring, :math:`\tilde\xi_j = -\ell + j\,\Delta`, :math:`\Delta = 2\ell/M`: one-sided
differences against the wind :math:`\ln Y`, central diffusion and Euler steps,

.. math::

    Y_j^{+} = Y_j + \Delta\tau \Bigl[ -\ln Y_j\,\frac{Y_{j+1} - Y_j}{\Delta}
        + \frac{Y_{j+1} - 2Y_j + Y_{j-1}}{\Delta^2} \Bigr] \quad (\ln Y_j \le 0),

and the backward difference where :math:`\ln Y_j > 0`.  It is of first order in :math:`\Delta` and
in :math:`\Delta\tau`, does not conserve the mean, and obeys a maximum principle if
:math:`\Delta\tau \le \Delta^2/(2 + c_{max}\Delta)` with :math:`c_{max} = \max|\ln Y|`.  The paper
takes M = 10⁴ points and 4/5 of that step.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.vector_functions import logarithms

PAPER_FRACTION = 0.8


class UpwindRun(NamedTuple):
    """Points ξ̃_j, values Y there at the end, and how many steps of which size led to them."""

    xi: np.ndarray
    values: np.ndarray
    steps: int
    step: float


def grid(half_length, points):
    """The points ξ̃_j = −ℓ + 2ℓ j/M, shape (points,)."""
    return half_length * (2.0 * np.arange(points) / points - 1.0)


def largest_step(spacing, fastest):
    """Δ²/(2 + c_max Δ), the limit of stability."""
    return spacing**2 / (2.0 + fastest * spacing)


def evolve_upwind(values, half_length, end, step=None):
    """Solve (50) with the paper's scheme.

    Parameters
    ----------
    values : ndarray, shape (M,)
        Y at ξ̃_j = −ℓ + 2ℓ j/M at τ = 0, positive.
    half_length : float
        ℓ.
    end : float
        τ at the end.
    step : float, optional
        Δτ; the paper's 4/5 of the limit of stability if none is given. It is shortened so that the
        steps end at `end`.

    Returns
    -------
    UpwindRun

    Raises
    ------
    InputError
        If a value is not positive, or the step exceeds the limit of stability.
    """
    values = np.array(values, dtype=float)
    if not values.min() > 0.0:
        raise InputError(
            f"The smallest value of the start is {values.min():.6g}, where the wind ln Y of the "
            "explicit upwind scheme is infinite: give positive values."
        )
    spacing = 2.0 * half_length / values.size
    limit = largest_step(spacing, np.abs(np.log(values)).max())
    step = PAPER_FRACTION * limit if step is None else step
    if step > limit:
        raise InputError(
            f"The step {step:.6g} exceeds {limit:.6g}, the limit of stability of the explicit "
            f"scheme for {values.size} points, and would blow up: take a step below the limit."
        )
    steps = max(1, math.ceil(end / step - 1.0e-9))
    march(values, spacing, end / steps, steps)
    return UpwindRun(grid(half_length, values.size), values, steps, end / steps)


@kernel
def march(values, spacing, step, steps):
    """Advance `values`, in place, by a number of equal steps."""
    n = values.size
    padded, wind = np.empty(n + 2), np.empty(n)
    mantissa, exponent = np.empty(n), np.empty(n, dtype=np.int64)
    left, right = padded[:-2], padded[2:]
    advection, diffusion = step / spacing, step / spacing**2
    for _ in range(steps):
        if interrupted():
            break
        for i in range(n):
            padded[i + 1] = values[i]
        padded[0], padded[n + 1] = values[n - 1], values[0]
        logarithms(values, exponent, mantissa, wind)
        for i in range(n):
            forward, backward = right[i] - values[i], values[i] - left[i]
            downwind = min(wind[i], 0.0) * forward + max(wind[i], 0.0) * backward
            values[i] += diffusion * (forward - backward) - advection * downwind
