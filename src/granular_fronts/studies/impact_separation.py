"""The damping up to which an impact on a chain makes two pulses.

One bead strikes a chain at rest (m = v₀ = 1), whose law is a power α and a dashpot, β = 1.  There
are *two pulses* if the velocity has two maxima along the beads.  The smaller must be at least half
as high as the larger.  The pulses *separate* if this happens at some time of a grid.

The largest damping at which they do is found by bisection.  Its error is half of the last interval,
and the change that half the step of the grid makes.
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import Estimate, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.studies.strikers import struck_chain

SMALLER = 0.5
"""Least height of the smaller pulse over that of the larger one."""


def find_separation(alpha, between, width, beads, end_time, step, tolerance):
    """Return the largest damping with two pulses, by bisection of an interval to a width.

    `separating_damping` and its error, a dataset without dimensions.
    """
    usual, finer = (
        _bisect(alpha, between, width, beads, end_time, every, tolerance)
        for every in (step, 0.5 * step)
    )
    found = Estimate(finer, 0.5 * width + abs(finer - usual))
    method = "width of the last interval, and change by half the step of the grid"
    meaning = "largest damping at which the pulses separate"
    return xr.Dataset(variable_and_errors("separating_damping", (), found, method, meaning))


def _bisect(alpha, between, width, *settings):
    """Return the middle of the last interval."""
    low, high = between
    if not (separates(alpha, low, *settings) and not separates(alpha, high, *settings)):
        raise ValueError(
            f"The pulses do not separate at {low} alone of {low} and {high}: give other dampings."
        )
    while high - low > width:
        middle = 0.5 * (low + high)
        if separates(alpha, middle, *settings):
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def separates(alpha, gamma, beads, end_time, step, tolerance):
    """Whether there are two pulses at some time of the grid."""
    record = {"snapshots": np.arange(step, end_time + 0.5 * step, step).tolist()}
    scene = struck_chain((alpha, 1.0, gamma), beads, end_time, tolerance, record)
    motion = simulate_chain(scene, "impact")
    return any(count_pulses(velocity) >= 2 for velocity in motion["velocity"].values)


def count_pulses(velocity):
    """Return how many maxima along the beads are at least half as high as the highest.

    Examples
    --------
    >>> count_pulses(np.array([0.0, 0.6, 0.5, 1.0, 0.2, 0.3, 0.0]))
    2
    """
    inner = velocity[1:-1]
    peaks = inner[(inner > velocity[:-2]) & (inner >= velocity[2:])]
    return int(np.count_nonzero(peaks >= SMALLER * velocity.max()))
