r"""Waves to start a ring with: rescaled forces :math:`y^0(\xi)` of period 2ℓ.

- ``plateau``, James (2021), eq. (49): 1 on a half-width w, then a parabola down to a floor, with
  kinks (`continuum.log_burgers.starts`).
- ``pulse``: a periodic Gaussian of width w on a base b,

  .. math:: y^0 = b + (1 - b)\exp\Bigl(-\bigl(\tfrac{2\ell}{\pi w}\bigr)^2
      \sin^2\tfrac{\pi\xi}{2\ell}\Bigr).

- ``front``: the stationary front (45) at ξ = w, from 1 down to b, and its mirror image at −w, which
  closes the ring,

  .. math:: y^0 = b + (1 - b)\,2^{-e^{\xi - w}}\,2^{-e^{-\xi - w}} .

- ``given``: values at equally spaced points from −ℓ to ℓ.

Pulse and front are analytic and, for b > 0, bounded away from zero, where the equations are
singular.  They are handed on as values at equally spaced points, between which the trigonometric
polynomial through them differs by less than rounding.

The velocities of a start are y itself, (51), or lie on the slow manifold to first order
(`model.amplitude_scaling`).  Then waves to the left are of the order ε².
"""

import math

import numpy as np
from scipy.special import xlogy

from granular_fronts.continuum.log_burgers.equation import log_burgers_front
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.scenes.ring import GivenForce, PlateauStart

POINTS_PER_UNIT = 8
"""Points of an analytic start to a length 1 in ξ, or in its width where that is smaller."""

SHIFT = 1.0e-2
"""Distance in ξ of the values that a slope is taken from."""


def pulse(xi, half_width, base, half_length):
    """Return the start ``pulse`` at the points `xi`."""
    phase = np.sin(0.5 * np.pi * np.asarray(xi) / half_length)
    return base + (1.0 - base) * np.exp(-((2.0 * half_length / np.pi / half_width * phase) ** 2))


def front(xi, half_width, base, half_length):
    """Return the start ``front`` at the points `xi`, from −ℓ to ℓ."""
    xi = np.asarray(xi)
    steps = log_burgers_front(xi - half_width) * log_burgers_front(-xi - half_width)
    return base + (1.0 - base) * steps


PROFILES = {"pulse": pulse, "front": front}


def scene_start(profile, half_width, base, half_length):
    """Return a start as a periodic scene gives it.

    `profile` is ``plateau``, ``pulse`` or ``front``, `half_width` w in ξ, `base` the smallest
    rescaled force, b or the floor of (49).
    """
    if profile == "plateau":
        return PlateauStart(kind="plateau", half_width=float(half_width), floor=float(base))
    finest = min(1.0, half_width) / POINTS_PER_UNIT
    xi = np.linspace(-half_length, half_length, 2 * math.ceil(half_length / finest) + 1)
    values = PROFILES[profile](xi, half_width, base, half_length)
    return GivenForce(kind="given", rescaled_force=[*values[:-1], values[0]])


def start_fields(start, scaling, half_length, xi, velocity):
    """Return the relative displacements and velocities of a start at the points `xi`.

    `velocity` is ``leading`` for (51) or ``slow`` for the slow manifold.
    """
    force = make_start(start)
    y = force.values(xi, half_length)
    if velocity == "leading":
        return scaling.displacement(y), scaling.velocity(y)
    slope = slope_of(lambda points: force.values(points, half_length), xi)
    return scaling.displacement(y), scaling.corrected_velocity(y, slope, xlogy(y, y))


def slope_of(function, xi):
    """Return the derivative of a smooth function at the points `xi`, of fourth order in `SHIFT`."""
    near, far = (function(xi + k * SHIFT) - function(xi - k * SHIFT) for k in (1, 2))
    return (8.0 * near - far) / (12.0 * SHIFT)
