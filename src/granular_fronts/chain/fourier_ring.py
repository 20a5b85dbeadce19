r"""A smooth wave on a ring of many beads, by Fourier series in the bead number.

The dissipative chain in strain form with :math:`\beta = \alpha`, James (2021), eq. (36),

.. math::

    \dot u_n = d_n + \gamma\,\Delta_d\,u_n^\alpha, \qquad \dot d_n = \Delta_d\,u_n^\alpha,

holds for every n, whole or not, if it holds for the functions :math:`u(n, t)` and :math:`d(n, t)`
of a real number n of period N: each offset :math:`n_0 \in [0, 1)` is a chain by itself.  A start
that is smooth in n stays so while all contacts are compressed, and then a few Fourier coefficients,
far fewer than there are beads, hold all chains at once.  They obey the same equations with

.. math:: \Delta_d \to -\omega_k^2, \qquad \omega_k = 2\sin(k/2), \qquad k = 2\pi j/N,

exactly, and :math:`u^\alpha` is taken at M equally spaced places.  No long-wave expansion enters:
this is the chain itself, not another model of it, up to the coefficients that are left out, which
fall exponentially for an analytic wave.

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

from granular_fronts.errors import SolveError


class GapError(SolveError):
    """A contact opens, where a Fourier series no longer converges."""


class Wave(NamedTuple):
    """A wave on a ring at some times.

    Attributes
    ----------
    relative_displacement, velocity : ndarray, shape (times, sites)
        At equally spaced places along the ring, the first at n = 0.
    smallest : float
        Smallest relative displacement after any step.
    """

    relative_displacement: np.ndarray
    velocity: np.ndarray
    smallest: float


class FourierRing(NamedTuple):
    """A ring of period N in the bead number, with δ = c = 1.

    Attributes
    ----------
    alpha, gamma : float
        Exponent of both forces, and strength of the viscous one.
    beads : int
        N.
    points : int
        M, even; waves up to M/2 turns are kept.
    """

    alpha: float
    gamma: float
    beads: int
    points: int

    @property
    def wave_numbers(self):
        """Wave numbers k of the coefficients 0 … M/2."""
        return 2.0 * np.pi * rfftfreq(self.points, self.beads / self.points)

    def force(self, coefficients):
        """Coefficients of u^α, and the smallest u."""
        u = irfft(coefficients, self.points)
        smallest = u.min()
        return rfft(np.maximum(u, 0.0) ** self.alpha), smallest

    def strain_rates(self, u, velocity):
        """Coefficients of d = w_n − w_{n+1} from those of u and ẋ, eq. (31)."""
        shift = np.exp(1j * self.wave_numbers)
        force, _ = self.force(u)
        return (1.0 - shift) * (velocity - self.gamma * (1.0 / shift - 1.0) * force)

    def velocities(self, u, d, mean):
        """Coefficients of ẋ from those of u and d, and the coefficient of its mean."""
        shift = np.exp(1j * self.wave_numbers)
        force, _ = self.force(u)
        velocity = self.gamma * (1.0 / shift - 1.0) * force
        velocity[1:] += d[1:] / (1.0 - shift[1:])
        velocity[0] = mean
        return velocity


def solve_fourier_ring(ring, u, velocity, times, tolerance):
    """Follow a smooth compressed wave on a ring.

    Parameters
    ----------
    ring : FourierRing
    u, velocity : ndarray, shape (sites,)
        Start at equally spaced places, the first at n = 0; more of them than coefficients are kept
        loses nothing of a smooth start.
    times : ndarray
        Increasing, in units of 1/c, the first at least 0.
    tolerance : float
        Relative error per step.

    Returns
    -------
    Wave

    Raises
    ------
    GapError
        If a contact opens.
    SolveError
        If the step size collapses.
    """
    u_hat, v_hat = (_resampled(rfft(row), row.size, ring.points) for row in (u, velocity))
    start = np.concatenate([u_hat, ring.strain_rates(u_hat, v_hat)])
    states, smallest = _integrate(ring, start, times, tolerance)
    waves = ring.wave_numbers.size
    displacements, velocities = [], []
    for state in states:
        u_hat, d_hat = state[:waves], state[waves:]
        for rows, hat in (
            (displacements, u_hat),
            (velocities, ring.velocities(u_hat, d_hat, v_hat[0])),
        ):
            rows.append(irfft(_resampled(hat, ring.points, u.size), u.size))
    return Wave(np.array(displacements), np.array(velocities), smallest)


def _integrate(ring, start, times, tolerance):
    """States at the given times, and the smallest u after any step."""
    waves, minus_square = ring.wave_numbers.size, -4.0 * np.sin(0.5 * ring.wave_numbers) ** 2

    def rates(_t, state):
        force, _ = ring.force(state[:waves])
        force *= minus_square
        change = np.empty_like(state)
        np.multiply(force, ring.gamma, out=change[:waves])
        change[:waves] += state[waves:]
        change[waves:] = force
        return change

    _, smallest = ring.force(start[:waves])
    solver = DOP853(
        rates, 0.0, start, times[-1], rtol=tolerance, atol=1e-2 * tolerance * ring.points
    )
    states, row = [], 0
    while row < len(times):
        if times[row] == solver.t:
            states.append(solver.y)
            row += 1
            continue
        if message := solver.step():
            raise SolveError(f"At t = {solver.t:.6g} of a ring the step size collapsed: {message}")
        smallest = min(smallest, ring.force(solver.y[:waves])[1])
        if not smallest > 0.0:
            raise GapError(
                f"At t = {solver.t:.6g} a contact of the ring opens, where its wave is not smooth: "
                "follow the beads themselves."
            )
        dense = solver.dense_output()
        while row < len(times) and times[row] <= solver.t:
            states.append(dense(times[row]))
            row += 1
    return states, smallest


def _resampled(coefficients, points, wanted):
    """Coefficients of the same wave for another number of places."""
    kept = min(points, wanted) // 2
    resampled = np.zeros(wanted // 2 + 1, dtype=complex)
    resampled[:kept] = coefficients[:kept] * (wanted / points)
    return resampled
