r"""Fourth-order explicit steps for diffusion with advection.

A system :math:`\dot Y = F(Y)` is stepped by the strong-stability-preserving Runge-Kutta method of
ten stages of Ketcheson (2008), *SIAM J. Sci. Comput.* 30, 2113-2136: with
:math:`\Phi(Y) = Y + \tfrac h6 F(Y)`, two chains of five Euler steps joined by two averages,

.. math::

    Q_4 = \Phi^4(Y_0), \quad Q_5 = \Phi(Q_4), \quad
    Q_9 = \Phi^4\bigl(\tfrac25 Q_5 + \tfrac35 Y_0\bigr), \quad
    Y_1 = \tfrac1{25} Y_0 + \tfrac9{25} Q_5 + \tfrac35 \Phi(Q_9) .

Three arrays suffice.  The embedded third-order weights :math:`(2,0,0,3,0,0,2,0,3,0)/10` of
Fekete, Conde and Shadid (2022), *J. Comput. Appl. Math.* 412, 114325, give the error estimate,
which is kept below the tolerance in the maximum norm.

Stability.  A wave of angle :math:`\theta` per cell is an eigenvector of the differences of
:math:`D\,Y'' - c\,Y'`, with the eigenvalue :math:`-D\,G(\theta)/\Delta^2 - ic\,S(\theta)/\Delta`
(`finite_volumes.symbols`).  With :math:`b = hD\,G(\pi)/\Delta^2` and :math:`p = hc^2/D` a step is
stable if its polynomial is at most 1 on

.. math:: z(\theta) = -b\,\frac{G(\theta)}{G(\pi)} - i\sqrt{\frac{p\,b}{G(\pi)}}\,S(\theta),

that is, if :math:`p \le p(b)`.  The method's region is wide.  Along the real axis it reaches
further per stage than the classical one of fourth order.  So its steps are long for the diffusion
of a fine grid and for the advection of a coarse one.  `PARABOLA` holds :math:`p(b)` for the
:math:`b` of `DIFFUSION_NUMBERS`, measured when the module is imported.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.continuum.log_burgers import finite_volumes
from granular_fronts.numerics.compiled import kernel, subroutine
from granular_fronts.numerics.interrupts import interrupted
from granular_fronts.numerics.records import make_record, record_type

STAGES = 10
# Ten times the weights of order 3 less the weights of order 4, which are all 1/10.
EMBEDDED_DIFFERENCE = (1.0, -1.0, -1.0, 2.0, -1.0, -1.0, 1.0, -1.0, 2.0, -1.0)
DIFFUSION_NUMBERS = np.arange(12.0, 1.5, -0.5)
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.8, 0.1, 5.0
RESOLUTION = 1.0e-14
FINISHED, COLLAPSED = 0, 1


def stability_polynomial(z):
    """Return the growth of the solution of Y' = λY over one step, z = hλ."""
    euler = 1.0 + np.asarray(z) / 6.0
    half_way = euler**5
    return 1.0 / 25.0 + 9.0 / 25.0 * half_way + 3.0 / 5.0 * euler**5 * (0.4 * half_way + 0.6)


def spectrum(b, p, angle):
    """Return the eigenvalues z(θ) for given b and p, times the step."""
    diffusion, advection = finite_volumes.symbols(angle)
    scale = b / finite_volumes.DIFFUSION_RADIUS
    return -scale * diffusion - 1j * np.sqrt(p * scale) * advection


def _largest_parabola(b):
    """Return the largest p at which a step with the given b is stable, with a margin of 2 %."""
    angle = np.linspace(0.0, np.pi, 513)[1:]
    lower, upper = 0.0, 64.0
    for _ in range(24):
        middle = 0.5 * (lower + upper)
        growth = np.abs(stability_polynomial(spectrum(b, middle, angle))).max()
        lower, upper = (middle, upper) if growth <= 1.0 else (lower, middle)
    return 0.98 * lower


PARABOLA = np.array([_largest_parabola(b) for b in DIFFUSION_NUMBERS])


class State(NamedTuple):
    """State and stages of one integration, each of shape (N,), and the work space."""

    averages: np.ndarray  # cell averages at the present time
    trial: np.ndarray  # a stage; in the end the averages after the step
    slope: np.ndarray  # the rates of a stage
    half_way: np.ndarray  # what the last average needs of the first five stages
    estimate: np.ndarray  # difference of both formulas, over the step
    work: finite_volumes.Work


CLOCK = record_type(
    *((name, float) for name in ("t", "h", "shortfall")),
    *((name, np.int64) for name in ("accepted", "rejected", "right_hand_sides")),
)
"""Time, next step, and the largest shortfall lifted; steps accepted and rejected, right-hand sides.
"""


def make_state(averages):
    """Return the state and stages for given cell averages."""
    arrays = [np.zeros_like(averages) for _ in range(4)]
    return State(averages.copy(), *arrays, finite_volumes.make_work(averages.size))


def make_clock(first_step):
    """Return the clock at time 0."""
    return make_record(CLOCK, h=first_step)


@kernel
def advance(equation, state, clock, tolerance, stop):
    """Step to the time `stop`, which is met exactly, with an error per step in the maximum norm.

    Returns FINISHED, or COLLAPSED if the step size fell below `RESOLUTION` of the stop.
    """
    while clock.t < stop and not interrupted():
        remaining = stop - clock.t
        h = min(clock.h, _largest_stable_step(equation, state.averages))
        lands = h >= remaining
        if lands:
            h = remaining
        elif 2.0 * h > remaining:
            h = 0.5 * remaining
        if h < RESOLUTION * stop and not lands:
            return COLLAPSED
        error = try_step(equation, state, h) / tolerance
        clock.right_hand_sides += STAGES
        factor = LARGEST_FACTOR
        if error > 0.0:
            factor = min(LARGEST_FACTOR, max(SMALLEST_FACTOR, SAFETY * error ** (-0.25)))
        if error <= 1.0:
            clock.t = stop if lands else clock.t + h
            clock.accepted += 1
            shortfall = finite_volumes.lift(state.trial, equation.bound)
            clock.shortfall = max(clock.shortfall, shortfall)
            copy(state.trial, state.averages)
            # A step cut short to land says little about the next one.
            clock.h = max(clock.h, h * factor) if lands else h * factor
        else:
            clock.rejected += 1
            clock.h = h * factor
    return FINISHED


@subroutine
def copy(values, target):
    """Write the values into another array; of slices numba makes four times as much code."""
    for i in range(values.size):
        target[i] = values[i]


@subroutine
def _largest_stable_step(equation, averages):
    """Return the largest step for which diffusion and advection are both stable."""
    smallest = largest = averages[0]
    for average in averages:
        smallest, largest = min(smallest, average), max(largest, average)
    strength, diffusion = finite_volumes.advection_and_diffusion(equation, smallest, largest)
    stiffness = diffusion * finite_volumes.DIFFUSION_RADIUS / equation.width**2
    best = 0.0
    for row in range(DIFFUSION_NUMBERS.size):
        best = max(
            best, min(DIFFUSION_NUMBERS[row] / stiffness, PARABOLA[row] / max(strength, 1e-300))
        )
    return best


@subroutine
def try_step(equation, state, h):
    """Take one step into `state.trial`; return the largest estimated error."""
    start, stage, slope = state.averages, state.trial, state.slope
    half_way, estimate = state.half_way, state.estimate
    sixth, tenth = h / 6.0, h / 10.0
    copy(start, stage)
    estimate[:] = 0.0
    for j in range(STAGES):
        if j == 5:
            for i in range(start.size):
                half_way[i] = (start[i] + 9.0 * stage[i]) / 25.0
                stage[i] = 0.6 * start[i] + 0.4 * stage[i]
        finite_volumes.evaluate_rates(equation, stage, state.work, slope)
        difference = tenth * EMBEDDED_DIFFERENCE[j]
        for i in range(start.size):
            stage[i] += sixth * slope[i]
            estimate[i] += difference * slope[i]
    error = 0.0
    for i in range(start.size):
        stage[i] = half_way[i] + 0.6 * stage[i]
        if estimate[i] != estimate[i]:
            return np.inf
        error = max(error, abs(estimate[i]))
    return error


def work_done(clock):
    """Return the steps and right-hand sides so far, as a dict."""
    return {
        "steps_accepted": int(clock.accepted),
        "steps_rejected": int(clock.rejected),
        "right_hand_sides": int(clock.right_hand_sides),
    }
