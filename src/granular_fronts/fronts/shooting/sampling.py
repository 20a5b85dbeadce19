r"""A front by shooting as a function of ξ: between its contacts, and in the tail behind its window.

Between.  While a window flows, contact n passes through all of the front between n and n − 1,
:math:`u_n(t) = U(n - t)`, exact to the integrator.

Behind.  The window ends where the tail is a sum of modes to round-off (`tail_closure`), with
amplitudes that the shot has found.  A mode of u that goes like :math:`e^{\lambda\xi}` has the
velocity

.. math:: \dot x - 1 = \frac{\lambda}{e^{\lambda} - 1}\, e^{\lambda\xi},

since :math:`\dot x(\xi) - \dot x(\xi + 1) = \dot u = -u'`.
"""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.fronts.shooting import equations, tail_closure
from granular_fronts.fronts.shooting.equations import join, split
from granular_fronts.fronts.shooting.solve import bead_velocities


class Sample(NamedTuple):
    """A front on uniform ξ = n − t: u and ẋ, each of shape (points,)."""

    xi: np.ndarray
    relative_displacement: np.ndarray
    velocity: np.ndarray


def sample_front(shot, points_per_site):
    """The front from where its tail is lost in rounding to its last bead.

    Parameters
    ----------
    shot : shooting.Shot
    points_per_site : int
        Points per unit of ξ, at least 1.

    Returns
    -------
    Sample
    """
    window = sample_window(shot, points_per_site)
    length = math.ceil(tail_closure.tail_length(shot.window.roots))
    count = length * points_per_site
    xi = window.xi[0] - np.arange(count, 0, -1) / points_per_site
    tail = sample_tail(shot, xi)
    return Sample(*(np.concatenate(pair) for pair in zip(tail, window, strict=True)))


def sample_window(shot, points_per_site):
    """The front in the window of the shot.

    Parameters
    ----------
    shot : shooting.Shot
    points_per_site : int
        Points per unit of ξ, at least 1.

    Returns
    -------
    Sample
        From less than one unit behind the first bead to the last bead.
    """
    duration = 1.0 / points_per_site
    window = shot.window
    part = window._replace(steps=math.ceil(window.steps * duration))
    amplitudes, state = split(window, shot.unknowns)
    values = np.empty((2, shot.bead.size, points_per_site))
    for j in range(points_per_site):
        time = j * duration
        values[:, :, -1 - j] = state[:, 0], bead_velocities(window, amplitudes, state, time)
        change, _ = equations.flow(part, join(amplitudes, state), duration, time)
        state = state + change
    fractions = (np.arange(points_per_site) + 1.0) * duration - 1.0
    xi = (shot.bead[:, np.newaxis] + fractions).ravel()
    return Sample(xi, *values.reshape(2, -1))


def sample_tail(shot, xi):
    """The front behind the window, as the sum of its modes.

    Parameters
    ----------
    shot : shooting.Shot
    xi : ndarray, shape (points,)

    Returns
    -------
    Sample
    """
    amplitudes, _ = split(shot.window, shot.unknowns)
    distance = xi - (shot.bead[0] - 1)
    u, velocity, used = np.ones(xi.size), np.ones(xi.size), 0
    for root in shot.window.roots:
        real = amplitudes[used]
        imaginary = amplitudes[used + 1] if root.imag else 0.0
        used += 2 if root.imag else 1
        mode = (real - 1j * imaginary) * np.exp(root * distance)
        u += mode.real
        velocity += (root / (np.exp(root) - 1.0) * mode).real
    return Sample(xi, u, velocity)
