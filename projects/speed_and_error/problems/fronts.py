"""Exact fronts of the lattice, James (2021), section 6: u_n and velocities at whole ξ = n.

The profile equation chooses its grid itself; shooting has a tolerance of the residual.
"""

import math
from functools import partial

import numpy as np

from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.profile.equation import power_problem
from granular_fronts.fronts.profile.solve import ORDER, solve_profile
from granular_fronts.fronts.properties import velocity
from granular_fronts.fronts.shooting.solve import shoot_front
from granular_fronts.numerics.interpolation import interpolate_all
from peers import scipy_fronts
from peers.runs import Run, Stopwatch
from problems.problem import FIELDS, Problem, stored_answers

ALPHA = 1.5
# Exponent of the slowest tail at the end of the window that the peer is given.
DECAY = 32.0


def make_front(settings, states):
    """Return a front with its stored values."""
    gamma, bead = settings["gamma"], states["bead"].values
    behind = max(-bead[0], math.ceil(DECAY / tail_roots(ALPHA, gamma)[0].real))
    methods = {
        "profile": partial(_run_profile, gamma, bead),
        "shooting": partial(_run_shooting, gamma, bead),
        **{
            name: partial(solve, gamma, bead, behind)
            for name, solve in scipy_fronts.METHODS.items()
        },
    }
    return Problem(stored_answers(states, gamma=gamma), methods)


def _run_profile(gamma, bead, _tolerance):
    """The profile equation from nothing, window and grid included."""
    with Stopwatch() as watch:
        profile = solve_profile(power_problem(ALPHA, gamma, ALPHA))
        fields = {} if profile.reason else _values_at(profile, bead.astype(float))
    return Run(fields, **watch.times, message=profile.reason)


def _values_at(profile, xi):
    """Return the relative displacements and velocities of a profile."""
    positions = xi / float(profile.spacing)
    return {
        "relative_displacement": profile.evaluate(xi),
        "velocity": interpolate_all(velocity(profile, ORDER), positions, 1.0, 0.0, profile.middle),
    }


def _run_shooting(gamma, bead, tolerance):
    """Gauss-Newton with the exact derivative of the flow."""
    with Stopwatch() as watch:
        shot = shoot_front(ALPHA, gamma, tolerance=tolerance)
    if not shot.converged:
        return Run(message=shot.reason)
    inside = np.clip(bead, shot.bead[0], shot.bead[-1]) - shot.bead[0]
    return Run({name: getattr(shot, name)[inside] for name in FIELDS}, **watch.times)
