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
import numpy.typing as npt

from granular_fronts.errors import InputError
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.vector_functions import logarithm

PAPER_FRACTION = 0.8


class UpwindRun(NamedTuple):
    """Points ξ̃_j, values Y there at the end, and how many steps of which size led to them."""

    xi: np.ndarray
    values: np.ndarray
    steps: int
    step: float


def grid(half_length, points):
    """Return the points ξ̃_j = −ℓ + 2ℓ j/M, shape (points,)."""
    return half_length * (2.0 * np.arange(points) / points - 1.0)


def largest_step(spacing, fastest):
    """Return Δ²/(2 + c_max Δ), the limit of stability."""
    return spacing**2 / (2.0 + fastest * spacing)


def evolve_upwind(
    values: npt.ArrayLike, half_length: float, end: float, step: float | None = None
) -> UpwindRun:
    """Solve (50) with the paper's scheme from values at ξ̃_j = −ℓ + 2ℓ j/M up to τ = `end`.

    The step Δτ, the paper's 4/5 of the limit of stability if none is given, is shortened so that
    the steps end at `end`.  A value that is not positive, or a step above the limit, is an
    InputError.
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
    _march(values, spacing, end / steps, steps)
    return UpwindRun(grid(half_length, values.size), values, steps, end / steps)


@kernel
def _march(values, spacing, step, steps):
    """Advance `values`, in place, by a number of equal steps."""
    n, advection, diffusion = values.size, step / spacing, step / spacing**2
    old, new = np.empty(n + 2), np.empty(n + 2)
    for i in range(n):
        old[i + 1] = values[i]
    for _ in range(steps):
        if interrupted():
            break
        old[0], old[n + 1] = old[n], old[1]
        _step_once(old, new, advection, diffusion)
        old, new = new, old
    for i in range(n):
        values[i] = old[i + 1]


@subroutine(error_model="numpy")
def _step_once(old, new, advection, diffusion):
    """One step of all points; `old` and `new` have one more on either side."""
    left, centre, right, stepped = old[:-2], old[1:-1], old[2:], new[1:-1]
    for i in range(centre.size):
        forward, backward = right[i] - centre[i], centre[i] - left[i]
        wind = logarithm(centre[i])
        downwind = wind * (forward if wind <= 0.0 else backward)
        stepped[i] = centre[i] + (diffusion * (forward - backward) - advection * downwind)
