r"""The logarithmic KdV–Burgers equation in time, on a ring.

Section 5 of James (2021) takes the slow variables :math:`s = 2\sqrt3\,\varepsilon_5(n - ct)` and
:math:`\tau_5 = \sqrt3\,\varepsilon_5^3 ct` with :math:`\varepsilon_5 = (1 - 1/\alpha)^{1/2}`.
Those of section 4 are shorter by one factor, :math:`s = \mu\xi` and :math:`\tau_5 = \mu\tau` with
the μ of (54), so that (55) is the logarithmic Burgers equation (41) with a third derivative,

.. math::

    \partial_\tau y + \partial_\xi(y\ln y) + \mu^{-2}\,\partial_\xi^3 y = \partial_\xi^2 y, \qquad
    \mu^{-2} = \frac{1 - 1/\alpha}{12\,(\gamma c)^2} .

It is solved on the same rings and from the same starts as (41).  A scene is the same as for the
logarithmic Burgers equation; its key `equations: dispersive:` gives cells and tolerance.  Steps are
longest in ξ, where fronts rest.  Results are in the frame :math:`\tilde\xi = \xi - \tau` of (50)
and named Y, so that (51) leads to the chain.

Change of sign.  The paper defines (55) for :math:`y \ge 0`.  Dispersion does not keep y above 0: of
a start that rises from (almost) nothing it makes waves below 0 on the rear side.  There the flux is
continued as the odd function :math:`y\ln|y|`, as the paper does in (57).  A chain has gaps where
y < 0, and this continuation is no model of them: there (51) reads u = 0.  `smallest_value` says how
deep y went.

Well-posedness.  About a constant y, small waves of wave number κ move with the speed :math:`\ln|y|
+ 1 - \mu^{-2}\kappa^2` and decay with the rate :math:`\kappa^2`, whatever y is.  No height is
unstable, but the speed has no bound where y tends to 0.  Nor is there a linear theory about 0,
since with y(ξ, τ) also

.. math:: \lambda\, y(\xi - \tau\ln\lambda,\; \tau), \qquad \lambda > 0,

is a solution: waves of any height are alike in a frame of their own.  The flux is continuous but
not Lipschitz at 0, and where y vanishes we know no proof of uniqueness.  Without damping Carles and
Pelinovsky (2014), *Nonlinearity* 27, 3185-3202, construct weak solutions and leave it open.  Here
the logarithm is cut off below the tolerance, in the refined run below a tenth of it. So the error
estimate contains what this changes.

Balances.  The mean of y is conserved.  Multiplied by y, flux and dispersion integrate to zero over
the ring, and

.. math::

    \frac{d}{d\tau}\int \tfrac12 y^2\,d\xi = -\int (\partial_\xi y)^2\,d\xi .

Method.  The Fourier method of `fourier_waves`, with the steps of `exponential_steps`.

Kinks of the start.  Its amplitudes are exact, but waves that N points do not resolve are missing,
and at first a kink makes them matter.  Diffusion extinguishes them soon.  A run therefore begins on
:math:`2^L N` points, `START_LEVELS` being L. It drops half of the waves whenever diffusion alone
has made each smaller by :math:`e^{-E}`, `EXTINCTION` being E.
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

START_LEVELS, EXTINCTION = 2, 30.0
SOLVER = (
    "Fourier method, exponential Runge-Kutta steps of order 4, "
    f"{2**START_LEVELS} times as many points at the start"
)


class Evolution(NamedTuple):
    """Amplitudes of y at some times."""

    start: Plateau | Given
    times: np.ndarray  # times t of the chain, shape (times,)
    slow_times: np.ndarray  # slow times τ, shape (times,)
    amplitudes: list  # one for each time, of as many waves as the run had then
    half_length: float  # ℓ
    counts: dict  # steps
    step_ends: list  # slow times at which they ended
    mean_drift: float  # largest change of the mean
    # Smallest y after the start, at the times and points.  Only where y ≥ 0 the equation is a model
    # of the chain, see above.
    smallest_value: float

    def rescaled_force(self, row, moving_xi):
        """Return the rescaled force at ξ̃ = ξ − τ (any shape, modulo 2ℓ) at the time of a row.

        It keeps its sign: where it is below 0, the wave of the equation pulls.  The start itself is
        not the sum of its waves, since it has kinks.
        """
        points = np.asarray(moving_xi, dtype=float)
        if self.times[row] == 0.0:
            return self.start.values(points, self.half_length)
        xi = points.ravel() + self.slow_times[row]
        values = values_at(self.amplitudes[row], self.half_length, xi)
        return values.reshape(points.shape)

    def facts(self):
        """Return the attributes that say how the equation was solved."""
        return {
            "solver": SOLVER,
            **self.counts,
            "mean_drift": self.mean_drift,
            "smallest_value": self.smallest_value,
        }


def solve(scene, times, cells, tolerance, levels=None, coarser=None):
    """Solve the logarithmic KdV–Burgers equation of a periodic scene once.

    Scene, times and errors are as of `log_burgers.solution.solve`.  `cells` are the N points used
    once the kinks of the start are smooth; before that there are 2^`levels` times as many.  The
    `tolerance` is the error per step, in y, and the logarithm is cut off below it.  All steps of
    `coarser`, an `Evolution`, are halved.
    """
    times = np.asarray(times, dtype=float)
    levels = START_LEVELS if levels is None else levels
    scaling, start, half_length = scene.scaling, make_start(scene.start), scene.half_length
    slow_times = scaling.slow_rate * times
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
    """Return amplitudes of a start at slow times, in any order, and the motion at the last."""
    points = cells * 2**levels
    amplitudes = start_amplitudes(start, equation.half_length, points)
    motion = Motion(equation, amplitudes, points, tolerance, coarser)
    ahead, kept = list(np.argsort(slow_times, kind="stable")), [None] * len(slow_times)
    # A finer run has twice the points of the coarser one until the end, if it drops waves with it.
    share = 4 if coarser else 2
    while ahead:
        is_smooth = motion.points == cells
        drops = np.inf if is_smooth else _extinction_time(equation, motion.points // share)
        while ahead and slow_times[ahead[0]] <= drops:
            row = ahead.pop(0)
            motion.advance(slow_times[row])
            kept[row] = motion.amplitudes
        if ahead:
            motion.advance(drops)
            motion.keep_waves(motion.points // 2)
    return kept, motion


def _extinction_time(equation, points):
    """Return the slow time at which diffusion has removed the waves that are not resolved."""
    return EXTINCTION / (equation.diffusion * wave_numbers(equation, points)[-1] ** 2)
