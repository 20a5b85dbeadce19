r"""Solving the logarithmic KdV–Burgers equation of a periodic scene, kinks and all.

The equation of `evolution` is solved by the Fourier method of `fourier_waves` with the steps of
`exponential_steps`.

Kinks of the start.  Its amplitudes are exact, but those of waves that N points do not resolve are
missing, and at first a kink makes them matter.  Diffusion extinguishes them soon.  A run therefore
begins on :math:`2^L N` points, `START_LEVELS` being L, and drops half of the waves whenever
diffusion alone has taken a factor :math:`e^{-E}`, `EXTINCTION` being E, off each of them.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_burgers.starts import Given, Plateau, make_start
from granular_fronts.continuum.log_kdv_burgers.exponential_steps import Motion
from granular_fronts.continuum.log_kdv_burgers.fourier_waves import (
    Equation,
    start_amplitudes,
    values_at,
    values_on_points,
    wave_numbers,
)
from granular_fronts.model.amplitude_scaling import scaling_of

START_LEVELS, EXTINCTION = 2, 30.0
SOLVER = (
    "Fourier method, exponential Runge-Kutta steps of order 4, "
    f"{2**START_LEVELS} times as many points at the start"
)


class Evolution(NamedTuple):
    """Amplitudes of y at some times.

    Attributes
    ----------
    start : starts.Plateau or starts.Given
    times : ndarray, shape (times,)
        Times t of the chain.
    slow_times : ndarray, shape (times,)
        Slow times τ.
    amplitudes : list of ndarray
        One for each time, of as many waves as the run had then.
    half_length : float
        ℓ.
    counts : dict
        Steps.
    step_ends : list of float
        Slow times at which they ended.
    mean_drift : float
        Largest change of the mean.
    smallest_value : float
        Smallest value of y after the start at the times, on the points; the equation is the model
        of a chain where y ≥ 0, see `evolution`.
    """

    start: Plateau | Given
    times: np.ndarray
    slow_times: np.ndarray
    amplitudes: list
    half_length: float
    counts: dict
    step_ends: list
    mean_drift: float
    smallest_value: float

    def rescaled_force(self, row, moving_xi):
        """Rescaled force at the points ξ̃ = ξ − τ (any shape, modulo 2ℓ) at the time of a row.

        It keeps its sign: where it is below 0, the wave of the equation pulls.  The start itself is
        not the sum of its waves, since it has kinks.
        """
        points = np.asarray(moving_xi, dtype=float)
        if self.times[row] == 0.0:
            return self.start.values(points, self.half_length)
        xi = points.ravel() + self.slow_times[row]
        values = values_at(self.amplitudes[row], self.half_length, xi)
        return values.reshape(points.shape)


def solve(scene, times, cells, tolerance, levels=START_LEVELS, coarser=None):
    """Solve the logarithmic KdV–Burgers equation of a periodic scene once.

    Parameters
    ----------
    scene : mapping
        A checked periodic scene.
    times : sequence of float
        Times t of the chain, in any order, at least 0.
    cells : int
        N, the points on which the run goes on once the kinks of the start are smooth.
    tolerance : float
        Error per step, in y; the logarithm is cut off below it.
    levels : int, optional
        L: the run begins on 2^L times as many points.
    coarser : Evolution, optional
        A run whose steps are all halved here.

    Returns
    -------
    Evolution

    Raises
    ------
    SolveError
        If the step size collapses.
    """
    times = np.asarray(times, dtype=float)
    scaling, start = scaling_of(scene), make_start(scene["start"])
    half_length, slow_times = scaling.half_length(scene["half_beads"]), scaling.slow_rate * times
    equation = Equation(half_length, 1.0, scaling.dispersion, tolerance)
    kept, motion = follow(
        equation, start, slow_times, cells, tolerance, levels, coarser and coarser.step_ends
    )
    later = [values_on_points(kept[row], 2 * kept[row].size - 1) for row in np.flatnonzero(times)]
    smallest = min((float(values.min()) for values in later), default=start.floor)
    mean_drift = max(abs(row[0] - motion.amplitudes[0]) for row in kept)
    counts = {"steps_accepted": motion.accepted, "steps_rejected": motion.rejected}
    return Evolution(
        start,
        times,
        slow_times,
        kept,
        half_length,
        counts,
        motion.ends,
        float(mean_drift),
        smallest,
    )


def follow(equation, start, slow_times, cells, tolerance, levels=START_LEVELS, coarser=None):
    """Amplitudes of a start at some slow times.

    Parameters
    ----------
    equation : fourier_waves.Equation
    start : starts.Plateau or starts.Given
    slow_times : ndarray, shape (times,)
        In any order, at least 0.
    cells, tolerance, levels, coarser
        As in `solve`.

    Returns
    -------
    kept : list of ndarray
        Amplitudes at each time.
    motion : exponential_steps.Motion
        At the last time.
    """
    points = cells * 2**levels
    amplitudes = start_amplitudes(start, equation.half_length, points)
    motion = Motion(equation, amplitudes, points, tolerance, coarser)
    ahead, kept = list(np.argsort(slow_times, kind="stable")), [None] * len(slow_times)
    # A finer run has twice the points of the coarser one until the end, if it drops waves with it.
    share = 4 if coarser else 2
    while ahead:
        is_smooth = motion.points == cells
        drops = np.inf if is_smooth else extinction_time(equation, motion.points // share)
        while ahead and slow_times[ahead[0]] <= drops:
            row = ahead.pop(0)
            motion.advance(slow_times[row])
            kept[row] = motion.amplitudes
        if ahead:
            motion.advance(drops)
            motion.keep_waves(motion.points // 2)
    return kept, motion


def extinction_time(equation, points):
    """Slow time at which diffusion has extinguished the waves that these points do not resolve."""
    return EXTINCTION / (equation.diffusion * wave_numbers(equation, points)[-1] ** 2)
