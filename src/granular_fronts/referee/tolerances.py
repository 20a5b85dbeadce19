r"""Tolerances by step: what a scheme of discrete-element codes misses an answer by, measured.

A scheme of `reference_methods.half_step` moves the beads with the steps h, h/2 and h/4, and is
compared with the answer as a result of somebody's code is.  From h to h/4 its errors e fall with
the power p, and the tolerance at the step h is the largest :math:`e(h_i)\,(\tfrac54h/h_i)^p` of
the three.  That is the error of a step a quarter larger if errors are powers, and more where the
phase of an impact within a step makes one of them small by chance.
"""

from typing import NamedTuple

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.referee.answers import rows_of_states
from granular_fronts.referee.assessment import Order, find, largest_error, observed_order
from granular_fronts.referee.problems import ALPHA
from granular_fronts.referee.results_files import Result
from granular_fronts.reference_methods.half_step import SCHEMES, Chain, integrate

PARTS = 1, 2, 4  # of a step
MARGIN = 1.25  # of the step whose error is the tolerance, over the step itself
MOST_STATES = 1e8  # of single beads in a motion, 1.6 GB


class Tolerance(NamedTuple):
    """Largest errors that pass at a step, and the order of the scheme.

    `motion` is that of all states, `states` that of the states which are listed, and `reading` that
    of the number of `measurements`, relative and NaN where it has none.
    """

    step: float
    order: Order
    motion: float
    states: float
    reading: float


def move(problem, step, scheme="lagged_verlet", factor=1.0):
    """Return the motion that a scheme computes, with the damping of the problem times a factor."""
    scene, every = problem.scene, max(1, round(problem.interval / step))
    step = problem.interval / every
    left = problem.force ** (1.0 / ALPHA)
    chain = Chain(ALPHA, scene.law.beta, factor * scene.law.gamma, left, wall=problem.wall)
    steps = round(scene.end_time / step)
    if steps * scene.beads.count > MOST_STATES:
        raise InputError(
            f"{problem.name} would take {steps:.0e} steps of {step:.2g} for a tolerance, too many: "
            "take a larger step, or name the file after its step."
        )
    motion = integrate(chain, *problem.start, step, steps, scheme=SCHEMES[scheme])
    return Result(problem.name, step, motion.t[::every], motion.x[::every], motion.v[::every])


def with_states_of(problem, result, answer):
    """Return an answer with the states of a result, to tell how far another one is from it."""
    fields = {
        "relative_displacement": problem.relative_displacements(result.x),
        "velocity": result.v,
    }
    return answer.assign({name: (answer[name].dims, field) for name, field in fields.items()})


def measure_tolerance(problem, answer, scheme, step):
    """Return the tolerance of a scheme at a step."""
    results = [move(problem, step / part, scheme) for part in PARTS]
    findings = [find(problem, answer, result) for result in results]
    rows = rows_of_states(answer)
    listed = [
        largest_error(problem, answer.isel(t=rows), u[rows], one.v[rows])
        for one in results
        for u in [problem.relative_displacements(one.x)]
    ]
    motion, readings = zip(*((one.error, deviation(one)) for one in findings), strict=True)
    power = np.log2(motion[0] / motion[2]) / 2.0
    enlarged = (MARGIN * np.array(PARTS)) ** power
    errors = np.array([motion, listed, readings])
    limits = np.max(errors * enlarged, axis=1).tolist()
    return Tolerance(step, observed_order(findings), *limits)


def deviation(finding):
    """Return the relative error of the reading of a result."""
    return abs(finding.measurement / finding.exact - 1.0)
