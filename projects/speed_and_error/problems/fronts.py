"""Exact fronts of the lattice, James (2021), section 6: u_n and velocities at whole ξ = n.

Ours are the profile equation on the grid that it chooses itself, the same on a given grid, and
shooting.  The spacing of the given grid takes the place of a tolerance; shooting has a tolerance of
the residual.
"""

import math
from fractions import Fraction
from functools import partial

import numpy as np

from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.profile.equation import power_problem
from granular_fronts.fronts.profile.solve import (
    ORDER,
    choose_window,
    solve_coarse,
    solve_on_grid,
    solve_profile,
)
from granular_fronts.fronts.properties import velocity
from granular_fronts.fronts.shooting.solve import shoot_front
from granular_fronts.numerics.interpolation import interpolate_all
from peers import scipy_fronts
from peers.runs import Run, Stopwatch
from problems.problem import Problem, read_reference, stored_state

ALPHA = 1.5
FIELDS = ("relative_displacement", "velocity")
# Exponent of the slowest tail at the end of the window that the peers are given.
DECAY = 32.0


def make_problem(problem, states):
    """Return the front of one entry of ``precision.fronts``, with its stored reference."""
    gamma, bead = problem["gamma"], states["bead"].values
    state = stored_state(states, "front", gamma=gamma)
    behind = max(-bead[0], math.ceil(DECAY / tail_roots(ALPHA, gamma)[0].real))
    peers = scipy_fronts.METHODS.items()
    return Problem(
        ours="profile",
        reference=read_reference(state, FIELDS),
        methods={
            "profile": partial(_run_profile, gamma, bead),
            "profile_on_grid": partial(_run_profile_on_grid, gamma, bead),
            "shooting": partial(_run_shooting, gamma, bead),
            **{name: partial(solve, gamma, bead, behind) for name, solve in peers},
        },
    )


def _run_profile(gamma, bead, _tolerance):
    """Solve the profile equation from nothing, window and grid included."""
    with Stopwatch() as watch:
        profile = solve_profile(power_problem(ALPHA, gamma, ALPHA))
        fields = {} if profile.reason else values_at(profile, bead)
    return Run(fields, **watch.times, message=profile.reason)


def _run_profile_on_grid(gamma, bead, spacing):
    """Solve the profile equation on a grid of a given spacing."""
    problem = power_problem(ALPHA, gamma, ALPHA)
    with Stopwatch() as watch:
        window = choose_window(problem)
        coarse = solve_coarse(problem, window)
        spacing = Fraction(spacing).limit_denominator(1000)
        profile = solve_on_grid(problem, window, spacing, ORDER, coarse.evaluate)
        fields = {} if profile.reason else values_at(profile, bead)
    return Run(fields, **watch.times, message=profile.reason)


def values_at(profile, bead):
    """Return the relative displacements and velocities of a profile at whole ξ."""
    xi, middle = bead.astype(float), profile.middle
    positions = xi / float(profile.spacing)
    return {
        "relative_displacement": profile.evaluate(xi),
        "velocity": interpolate_all(velocity(profile, ORDER), positions, 1.0, 0.0, middle),
    }


def _run_shooting(gamma, bead, tolerance):
    """Shoot by Gauss-Newton with the exact derivative of the flow."""
    with Stopwatch() as watch:
        shot = shoot_front(ALPHA, gamma, tolerance=tolerance)
    if not shot.converged:
        return Run(message=shot.reason)
    inside = np.clip(bead, shot.bead[0], shot.bead[-1]) - shot.bead[0]
    fields = {name: getattr(shot, name)[inside] for name in FIELDS}
    return Run(fields, **watch.times, right_hand_sides=shot.counts["right_hand_sides"])
