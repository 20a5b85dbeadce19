"""Assess results: errors, order, apparent damping, and advice."""

from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.referee.measurements import NAMES, excess_damping, read_motion
from granular_fronts.referee.problems import ALPHA
from granular_fronts.referee.results_files import ALL_DIGITS

CLEAR = 0.25  # largest distance of a clear order from a whole number, and its largest scatter
NO_ORDER = 0.3  # observed order below which the error does not depend on the step
SAME_TIME = 1.0e-6  # distance of two times that count as one, over the interval between states
SAME_START = 1.0e-6  # of two first states, over δ or over the velocity of a front
LEFT_OPEN = 0.05  # largest share that digits may leave open of a number from which more follows
TRIES = 8  # of the states that a file stands for


class Finding(NamedTuple):
    """What one result shows.

    `error` is the larger of the errors of u over δ and of the velocities over δ^(5/4), of all
    states; `measurement` and `excess` come from `measurements`; NaN if undefined.  `exact` is the
    measurement of the answer.  `digits` are those of the file: they leave `error_open` of the
    error and `measurement_open` of the measurement open, and may settle the error and the damping
    well enough to conclude from them.
    """

    step: float
    error: float
    measurement: float
    excess: float
    exact: float
    digits: int = ALL_DIGITS
    error_open: float = 0.0
    measurement_open: float = 0.0
    error_settled: bool = True
    damping_settled: bool = True


def find(problem, answer, result):
    """Compare a result with the answer; an InputError names beads, times or a start that differ."""
    rows = _matching_rows(problem, answer, result)
    x, v = result.x[rows], result.v[rows]
    _check_start(problem, result.step, x[0], v[0])

    def judge(x, v):
        u = problem.relative_displacements(x)
        return largest_error(problem, answer, u, v), read_motion(problem, answer["t"].values, u, v)

    # The file stands for all states that differ from its own by its rounding: some are tried.
    random, tries = np.random.default_rng(0), [judge(x, v)]
    for _ in range(TRIES if any(result.rounding) else 0):
        hidden = (by * random.uniform(-1.0, 1.0, x.shape) for by in result.rounding)
        tries.append(judge(x + next(hidden), v + next(hidden)))
    left_open, (error, measurement) = np.ptp(tries, axis=0), tries[0]
    table = answer["reading"].values, answer["factor"].values
    excess = excess_damping(measurement, table[1], table[0])
    exact = float(answer["reading"].sel(factor=1.0))
    follows_from = np.abs([error, measurement - exact])
    settled = np.isnan(follows_from) | (left_open <= LEFT_OPEN * follows_from)
    digits = result.digits, *left_open.tolist(), *settled.tolist()
    return Finding(result.step, error, measurement, excess, exact, *digits)


def largest_error(problem, answer, u, v):
    """Return the larger of the errors of u over δ and of the velocities over δ^(5/4)."""
    return float(
        max(
            np.abs(u - answer["relative_displacement"].values).max() / problem.displacement,
            np.abs(v - answer["velocity"].values).max() / problem.front_velocity,
        )
    )


def _matching_rows(problem, answer, result):
    """Return the rows of a result at the times of the answer."""
    name = f"{problem.name} with step {result.step:g}"
    beads = problem.scene.beads.count
    if result.x.shape[1] != beads:
        raise InputError(
            f"{name} has {result.x.shape[1]} beads, but the problem has {beads}: compute these."
        )
    times = answer["t"].values
    rows = np.abs(result.t[:, None] - times).argmin(axis=0)
    off = np.abs(result.t[rows] - times) > SAME_TIME * problem.interval
    if off.any():
        raise InputError(
            f"{name} has no state at t = {times[off][0]:g}, its last is at t = {result.t[-1]:g}. "
            f"Write states every {problem.interval:g} up to {times[-1]:g}, with a step that "
            "divides this and that the name of the file says."
        )
    return rows


def _check_start(problem, step, x, v):
    """Check that a motion starts where and as fast as the problem."""
    # Codes that keep velocities of half steps start with a velocity half a step before or after.
    name = f"{problem.name} with step {step:g} does not start as the problem"
    off, late = (found - expected for found, expected in zip((x, v), problem.start, strict=True))
    farthest = float(np.abs(problem.relative_displacements(off)).max())
    if farthest > SAME_START * problem.displacement:
        raise InputError(
            f"{name}: at t = 0 beads are {farthest:.3g} from where they should be; give x as "
            "displacement from where they just touch, or as position in diameters."
        )
    late = float(np.abs(late).max())
    if late > 0.5 * step * problem.displacement**ALPHA + SAME_START * problem.front_velocity:
        raise InputError(
            f"{name}: at t = 0 a velocity is {late:.3g} off; in the problem bead 1 has "
            f"{problem.start[1][0]:.6g} and the others rest."
        )


class Order(NamedTuple):
    """Slope of log error over log step at the two smallest steps.

    `scatter` is its distance from the slope of the pair before; NaN for two steps.
    """

    value: float
    scatter: float

    def __str__(self):
        return f"{self.value:.2f}" + ("" if np.isnan(self.scatter) else f" ± {self.scatter:.2f}")


def observed_order(findings):
    """Return the order that the errors of two or more steps show."""
    steps, errors = (np.log([getattr(one, name) for one in findings]) for name in ("step", "error"))
    slopes = np.diff(errors) / np.diff(steps)
    scatter = abs(slopes[-1] - slopes[-2]) if slopes.size > 1 else np.nan
    return Order(float(slopes[-1]), float(scatter))


def damping_without_step(findings):
    """Return excess damping extrapolated to step 0, and its change by the smallest step.

    It is linear in the step at the two smallest ones, and at the pair before; NaN unless three or
    more steps have an excess.  An error of second order is less than the change.
    """
    steps, excess = np.array([(one.step, one.excess) for one in findings]).T
    at_zero = excess[1:] - steps[1:] * np.diff(excess) / np.diff(steps)
    return (at_zero[-1], abs(at_zero[-1] - at_zero[-2])) if at_zero.size > 1 else (np.nan, np.nan)


def report(problem, findings, wanted):
    """Sentences on all results of one problem, and what would help.

    `findings` are of different steps, the largest first; `wanted` is an error that would do.
    """
    yield from measured(problem, findings)
    if len(findings) < 2:
        yield "  Give a second step, and the order is found."
        return
    settled = all(one.error_settled for one in findings)
    order = observed_order(findings) if settled else None
    yield from (f"  {line}" for line in _advice(problem, findings[-1], order, wanted))


def measured(problem, findings):
    """Sentences on what was measured of one problem, at different steps, the largest first."""
    yield problem.title
    for one in findings:
        digits = "" if one.error_settled else f" ± {one.error_open:.0e} by its {one.digits} digits"
        damping = _damping_in_words(problem, one) if one.damping_settled else ""
        yield f"  step {one.step:g}: largest error {one.error:.1e}{digits}{damping}."
    if not all(one.error_settled and one.damping_settled for one in findings):
        yield (
            f"  {min(one.digits for one in findings)} digits are too few for the order or the "
            "damping where none is given: write all, in LAMMPS by dump_modify … format float %.17g."
        )
    if len(findings) > 1 and all(one.error_settled for one in findings):
        yield f"  The observed order is {observed_order(findings)}."
    excess, change = damping_without_step(findings)
    if all(one.damping_settled for one in findings) and not np.isnan(excess):
        yield (
            f"  Extrapolated to step 0, gamma is off by {100.0 * excess:+.2g} % ± "
            f"{100.0 * change:.1g} %."
        )


def _damping_in_words(problem, finding):
    if problem.scene.law.gamma == 0.0:
        return f"; {NAMES[problem.motion]} {finding.measurement:.5g}, exact {finding.exact:.5g}"
    if np.isnan(finding.excess):
        return ""
    side = "large" if finding.excess > 0.0 else "small"
    return (
        f"; {NAMES[problem.motion]} {finding.measurement:.5g}, as if gamma were "
        f"{100.0 * abs(finding.excess):.2g} % too {side}"
    )


def _advice(problem, finest, order, wanted):
    """What to change: nothing, problem, number of steps; at a clear order, step and integrator."""
    if finest.error + finest.error_open <= wanted:
        yield f"At step {finest.step:g} the error is below {wanted:g}, as wanted."
    elif order is None:
        return
    elif order.value < NO_ORDER:
        yield (
            "The error does not fall with the step: perhaps this is another problem. Compare law, "
            "mass, radius, force and start with the file of the problem in words."
        )
    elif abs(order.value - round(order.value)) >= CLEAR or order.scatter > CLEAR:
        yield "The order is not clear yet: add a smaller step."
    else:
        step = finest.step * (wanted / finest.error) ** (1.0 / order.value)
        yield f"For an error of {wanted:g} take the step {step:.2g}."
        if round(order.value) == 1:
            yield (
                "Order one has several causes: granular-fronts-referee judge compares this case, "
                "and solitary_wave_undamped_hertz, with three schemes. If viscous forces see the "
                "velocity of half a step before, a predicted one makes it two, as fix mvv/dpd of "
                "LAMMPS does in the deck lammps.in with -var integrator mvv."
            )
