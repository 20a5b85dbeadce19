r"""Stabilised explicit steps of second order for diffusion with advection.

A system :math:`\dot Y = F(Y)` whose eigenvalues lie along the negative real axis is stepped by the
Runge-Kutta-Chebyshev method of Sommeijer, Shampine and Verwer, *J. Comput. Appl. Math.* 88 (1998)
315-326.  Its :math:`s` stages follow the three-term recurrence of the Chebyshev polynomials,

.. math::

    Y_j - Y_0 = \mu_j (Y_{j-1} - Y_0) + \nu_j (Y_{j-2} - Y_0)
        + \tilde\mu_j\, h F_{j-1} + \tilde\gamma_j\, h F_0 ,

so that three arrays suffice for any :math:`s`, and the real interval of stability grows as
:math:`s^2`: one step of ten stages goes as far as thirty of the classical fourth-order method.

Advection.  With the paper's damping (:math:`\varepsilon = 2/13`) the stability region is a chain
of thin beads, and advection at a grid Peclet number of one or two leaves it.  Much stronger damping
(`DAMPING`) fuses them into one egg: a third of the real interval is paid for a region that holds

.. math:: |\operatorname{Im} z|^2 \le p_s\, |\operatorname{Re} z| \,(1 - |\operatorname{Re} z|/b_s),
    \qquad 0 \le -\operatorname{Re} z \le b_s .

Central differences of :math:`D\,Y'' - c\,Y'` have eigenvalues on
:math:`|\operatorname{Im}\lambda|^2 \le (c^2/D)\,|\operatorname{Re}\lambda|`, whatever the grid, so
a step is stable if :math:`h\rho \le b_s` and :math:`h\,c^2/D \le p_s`, with :math:`\rho` the
largest real eigenvalue.  Even :math:`s` have the larger :math:`p_s`; only they are used.
`REAL_REACH` and `PARABOLA` hold :math:`b_s` and :math:`p_s`, measured when the module is imported.

Step size.  The embedded estimate :math:`\tfrac45(Y_0 - Y_1) + \tfrac25 h(F_0 + F_1)` is kept below
the tolerance in the maximum norm; of all :math:`s` the one with the least work per unit of time is
taken.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.compiled import kernel
from granular_fronts.continuum import finite_volumes

DAMPING = 40.0
MOST_STAGES = 48
STAGES = tuple(range(2, MOST_STAGES + 1, 2))
SAFETY, SMALLEST_FACTOR, LARGEST_FACTOR = 0.8, 0.1, 5.0
RESOLUTION = 1.0e-14
FINISHED, COLLAPSED = 0, 1
ACCEPTED, REJECTED, EVALUATIONS = 0, 1, 2


def chebyshev(stages, x):
    """T_0 … T_s and their first and second derivatives at x, each of shape (s + 1, *x.shape)."""
    x = np.asarray(x)
    zero = np.zeros_like(x)
    value, slope, curvature = [zero + 1.0, x], [zero, zero + 1.0], [zero, zero]
    for j in range(2, stages + 1):
        curvature.append(2.0 * x * curvature[-1] - curvature[-2] + 4.0 * slope[j - 1])
        slope.append(2.0 * x * slope[-1] - slope[-2] + 2.0 * value[j - 1])
        value.append(2.0 * x * value[-1] - value[-2])
    return np.array(value), np.array(slope), np.array(curvature)


def recurrence(stages):
    """Coefficients μ_j, ν_j, μ̃_j, γ̃_j of the stages, shape (stages + 1, 4); row 0 is unused."""
    w0 = 1.0 + DAMPING / stages**2
    value, slope, curvature = chebyshev(stages, w0)
    w1 = slope[stages] / curvature[stages]
    b = np.empty(stages + 1)
    b[2:] = curvature[2:] / slope[2:] ** 2
    b[:2] = b[2]
    a = 1.0 - b * value
    rows = np.zeros((stages + 1, 4))
    rows[1, 2] = b[1] * w1
    for j in range(2, stages + 1):
        rows[j, :3] = 2 * b[j] * w0 / b[j - 1], -b[j] / b[j - 2], 2 * b[j] * w1 / b[j - 1]
        rows[j, 3] = -a[j - 1] * rows[j, 2]
    return rows


def stability_polynomial(stages, z):
    """Growth of the solution of Y' = λY over one step, z = hλ."""
    w0 = 1.0 + DAMPING / stages**2
    value, slope, curvature = chebyshev(stages, w0)
    b = curvature[stages] / slope[stages] ** 2
    at_z, _, _ = chebyshev(stages, w0 + slope[stages] / curvature[stages] * z)
    return 1.0 - b * value[stages] + b * at_z[stages]


def _largest_stable(stages, points, upper):
    """Largest parameter up to `upper` for which all `points(parameter)` are stable."""
    lower = 0.0
    for _ in range(20):
        middle = 0.5 * (lower + upper)
        stable = np.abs(stability_polynomial(stages, points(middle))).max() <= 1.0 + 1.0e-12
        lower, upper = (middle, upper) if stable else (lower, middle)
    return lower


def _stability_tables():
    """b_s and p_s of every number of stages in `STAGES`, with a margin of 2 %."""
    fraction = np.linspace(0.0, 1.0, 257)[1:]
    reach, parabola = np.empty(len(STAGES)), np.empty(len(STAGES))
    for row, stages in enumerate(STAGES):
        b = _largest_stable(stages, lambda end: -end * fraction, float(stages**2))
        height = np.sqrt(b * fraction * (1.0 - fraction))
        bow = (-b * fraction, 1j * height)
        p = _largest_stable(stages, lambda p, bow=bow: bow[0] + np.sqrt(p) * bow[1], 40.0)
        reach[row], parabola[row] = 0.98 * b, 0.98 * p
    return reach, parabola


def _recurrence_table():
    table = np.zeros((len(STAGES), MOST_STAGES + 1, 4))
    for row, stages in enumerate(STAGES):
        table[row, : stages + 1] = recurrence(stages)
    return table


REAL_REACH, PARABOLA = _stability_tables()
RECURRENCE = _recurrence_table()


class Stages(NamedTuple):
    """State and stages of one integration, each of shape (N,), and the work space.

    Attributes
    ----------
    averages, rates : ndarray
        Cell averages at the present time, and their rates of change.
    last, before, next_rates : ndarray
        Increments over the step of the last two stages, and the rates of the last one.
    work : finite_volumes.Work
    """

    averages: np.ndarray
    rates: np.ndarray
    last: np.ndarray
    before: np.ndarray
    next_rates: np.ndarray
    trial: np.ndarray
    work: finite_volumes.Work


class Clock(NamedTuple):
    """Time and step size (arrays of one entry), counts of work, largest shortfall lifted."""

    t: np.ndarray
    h: np.ndarray
    counts: np.ndarray
    shortfall: np.ndarray


def start(averages, first_step):
    """Stages and clock at time 0 for given cell averages."""
    arrays = [np.zeros_like(averages) for _ in range(5)]
    stages = Stages(averages.copy(), *arrays, finite_volumes.make_work(averages.size))
    clock = Clock(np.zeros(1), np.array([first_step]), np.zeros(3, np.int64), np.zeros(1))
    return stages, clock


@kernel
def advance(equation, state, clock, tolerance, stop):
    """Step to the time `stop`, which is met exactly.

    Parameters
    ----------
    equation : finite_volumes.Equation
    state : Stages
    clock : Clock
    tolerance : float
        Error per step in the maximum norm over cells.
    stop : float

    Returns
    -------
    int
        FINISHED, or COLLAPSED if the step size fell below `RESOLUTION` of it.
    """
    finite_volumes.evaluate_rates(equation, state.averages, state.work, state.rates)
    while clock.t[0] < stop:
        row, h = choose_stages(equation, state.averages, clock.h[0])
        remaining = stop - clock.t[0]
        lands = h >= remaining
        if lands:
            h = remaining
        elif 2.0 * h > remaining:
            h = 0.5 * remaining
        if h < RESOLUTION * stop and not lands:
            return COLLAPSED
        error = try_step(equation, state, row, h) / tolerance
        clock.counts[EVALUATIONS] += STAGES[row]
        factor = LARGEST_FACTOR
        if error > 0.0:
            factor = min(LARGEST_FACTOR, max(SMALLEST_FACTOR, SAFETY * error ** (-1.0 / 3.0)))
        if error <= 1.0:
            clock.t[0] = stop if lands else clock.t[0] + h
            clock.counts[ACCEPTED] += 1
            shortfall = finite_volumes.lift(state.trial, equation.bound)
            clock.shortfall[0] = max(clock.shortfall[0], shortfall)
            state.averages[:] = state.trial
            state.rates[:] = state.next_rates
            if shortfall > 0.0:
                finite_volumes.evaluate_rates(equation, state.averages, state.work, state.rates)
            # A step cut short to land says little about the next one.
            clock.h[0] = max(clock.h[0], h * factor) if lands else h * factor
        else:
            clock.counts[REJECTED] += 1
            clock.h[0] = h * (factor if error == error else SMALLEST_FACTOR)
    return FINISHED


@kernel
def choose_stages(equation, averages, wanted):
    """Row of `STAGES` and step size with the least work per unit of time."""
    smallest, largest = averages.min(), averages.max()
    strength, diffusion = finite_volumes.advection_and_diffusion(equation, smallest, largest)
    stiffness = diffusion * finite_volumes.DIFFUSION_REACH / equation.width**2
    best_row, best_h = 0, 0.0
    for row in range(len(STAGES)):
        h = min(wanted, REAL_REACH[row] / stiffness)
        if strength > 0.0:
            h = min(h, PARABOLA[row] / strength)
        if h * STAGES[best_row] > best_h * STAGES[row]:
            best_row, best_h = row, h
    return best_row, best_h


@kernel
def try_step(equation, state, row, h):
    """One step into `state.trial` and `state.next_rates`; returns the largest estimated error."""
    start, rates, trial, slope = state.averages, state.rates, state.trial, state.next_rates
    last, before = state.last, state.before
    coefficients = RECURRENCE[row]
    first = coefficients[1, 2] * h
    for i in range(start.size):
        before[i] = 0.0
        last[i] = first * rates[i]
        trial[i] = start[i] + last[i]
    for j in range(2, STAGES[row] + 1):
        finite_volumes.evaluate_rates(equation, trial, state.work, slope)
        mu, nu = coefficients[j, 0], coefficients[j, 1]
        on_slope, on_rates = coefficients[j, 2] * h, coefficients[j, 3] * h
        for i in range(start.size):
            new = mu * last[i] + nu * before[i] + on_slope * slope[i] + on_rates * rates[i]
            before[i] = last[i]
            last[i] = new
            trial[i] = start[i] + new
    finite_volumes.evaluate_rates(equation, trial, state.work, slope)
    error = 0.0
    for i in range(start.size):
        estimate = 0.4 * h * (rates[i] + slope[i]) - 0.8 * last[i]
        error = max(error, abs(estimate))
        if estimate != estimate:
            return np.inf
    return error


def work_done(clock):
    """Steps and right-hand sides so far, as a dict."""
    return {
        "steps_accepted": int(clock.counts[ACCEPTED]),
        "steps_rejected": int(clock.counts[REJECTED]),
        "right_hand_sides": int(clock.counts[EVALUATIONS]),
    }
