r"""A smooth wave on a ring of many beads, by Fourier series in the bead number.

The dissipative chain in strain form with :math:`\beta = \alpha`, James (2021), eq. (36),

.. math::

    \dot u_n = d_n + \gamma\,\Delta_d\,u_n^\alpha, \qquad \dot d_n = \Delta_d\,u_n^\alpha,

holds for every n, whole or not, if it holds for the functions :math:`u(n, t)` and :math:`d(n, t)`
of a real number n of period N: each offset :math:`n_0 \in [0, 1)` is a chain by itself.  A start
that is smooth in n stays so while all contacts are compressed, and then a few Fourier coefficients,
far fewer than there are beads, hold all chains at once.  They obey the same equations with

.. math:: \Delta_d \to -\omega_k^2, \qquad \omega_k = 2\sin(k/2), \qquad k = 2\pi j/N,

exactly, and :math:`u^\alpha` is taken at M equally spaced places; on the values there
:math:`\Delta_d` is a circulant matrix.  No long-wave expansion enters: this is the chain itself,
not another model of it, up to the coefficients that are left out, which fall exponentially for an
analytic wave.  The sum of u over the ring is kept to round-off.

Cost.  The explicit steps of order 8 (DOP853) are as long as the shortest wave kept allows, about
:math:`5/k_{max}`, against about 1 for the beads.  A wave of :math:`2\ell/\varepsilon` beads over
the time :math:`2\tau/(\gamma\varepsilon^2c^2)` so costs :math:`1/(\varepsilon\gamma c) =
\alpha/(\alpha - 1)` times a constant, and bead by bead :math:`1/\varepsilon^2` times as much.

A contact that opens ends the run: the force is no longer smooth.
"""

from typing import NamedTuple

import numpy as np
from scipy.fft import irfft, rfft, rfftfreq
from scipy.integrate import DOP853
from scipy.linalg import circulant

from granular_fronts.errors import SolveError

OPEN = (
    "At t = {time:.6g} a contact of the ring opens, where its wave is not smooth: follow the beads "
    "themselves."
)


class GapError(SolveError):
    """A contact opens, where a Fourier series no longer converges."""


class Wave(NamedTuple):
    """A wave at some times and equally spaced sites, shape (times, sites), the first at n = 0."""

    relative_displacement: np.ndarray
    velocity: np.ndarray
    smallest: float  # Relative displacement after any step.


class FourierRing(NamedTuple):
    """A ring of period N in the bead number, with δ = c = 1."""

    alpha: float
    gamma: float
    beads: int  # N.
    points: int  # M, even; waves up to M/2 turns are kept.

    @property
    def wave_numbers(self):
        """Wave numbers k of the coefficients 0 … M/2."""
        return 2.0 * np.pi * rfftfreq(self.points, self.beads / self.points)

    @property
    def second_difference(self):
        """Matrix of Δ_d on values at the M places, a circulant."""
        return circulant(irfft(-4.0 * np.sin(0.5 * self.wave_numbers) ** 2, self.points))

    def strain_rates(self, u, velocity):
        """Return the values of d = w_n − w_{n+1} from u and ẋ, eq. (31)."""
        shift, force = np.exp(1j * self.wave_numbers), rfft(u**self.alpha)
        rates = (1.0 - shift) * (rfft(velocity) - self.gamma * (1.0 / shift - 1.0) * force)
        return irfft(rates, self.points)

    def velocities(self, u, d, mean):
        """Return the values of ẋ from u, d and the mean of ẋ."""
        shift, force = np.exp(1j * self.wave_numbers), rfft(u**self.alpha)
        velocity = self.gamma * (1.0 / shift - 1.0) * force
        velocity[1:] += rfft(d)[1:] / (1.0 - shift[1:])
        velocity[0] = mean * self.points
        return irfft(velocity, self.points)


def solve_fourier_ring(
    ring: FourierRing, u: np.ndarray, velocity: np.ndarray, times: np.ndarray, tolerance: float
) -> Wave:
    """Follow a smooth compressed wave on a ring; a contact that opens is a GapError.

    u and the velocity start at equally spaced sites, the first at n = 0; more of them than
    coefficients are kept loses nothing of a smooth start.  Times increase from 0 or later, in units
    of 1/c, and the tolerance is the relative error per step.
    """
    first, speed = (_resampled(row, ring.points) for row in (u, velocity))
    if not first.min() > 0.0:
        raise GapError(OPEN.format(time=0.0))
    start = np.concatenate([first, ring.strain_rates(first, speed)])
    states, smallest = _integrate(ring, start, times, tolerance)
    pairs = [np.split(state, 2) for state in states]
    return Wave(
        np.array([_resampled(u_then, u.size) for u_then, _ in pairs]),
        np.array([_resampled(ring.velocities(*pair, speed.mean()), u.size) for pair in pairs]),
        smallest,
    )


def _integrate(ring, start, times, tolerance):
    """Return the values of u and d at the given times, and the smallest u after any step."""
    points, matrix, smallest = ring.points, ring.second_difference, start[: ring.points].min()
    weights = np.full(points, 1.0 / points)

    def rates(_t, state):
        force = matrix @ np.maximum(state[:points], 0.0) ** ring.alpha
        change = state[points:] + ring.gamma * force
        # Both means are zero, and their rounding would add up over a long time.
        change -= change @ weights
        force -= force @ weights
        return np.concatenate([change, force])

    solver = DOP853(rates, 0.0, start, times[-1], rtol=tolerance, atol=1e-2 * tolerance)
    states = []
    while len(states) < len(times):
        if message := solver.step():
            raise SolveError(f"At t = {solver.t:.6g} of a ring the step size collapsed: {message}")
        smallest = min(smallest, solver.y[:points].min())
        if not smallest > 0.0:
            raise GapError(OPEN.format(time=solver.t))
        passed = times[len(states) : np.searchsorted(times, solver.t, side="right")]
        states += map(solver.dense_output(), passed)
    return states, float(smallest)


def _resampled(values, points):
    """Return the same wave at another number of places, the waves that both resolve."""
    kept = (min(values.size, points) + 1) // 2
    coefficients = np.zeros(points // 2 + 1, dtype=complex)
    coefficients[:kept] = rfft(values)[:kept]
    return irfft(coefficients, points) * (points / values.size)
