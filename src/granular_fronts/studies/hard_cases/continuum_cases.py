r"""Hard cases of the amplitude equations: the critical damping, and starts that touch zero.

Heteroclinic.  At :math:`\mu = 2` the focus (1, 0) becomes a node, and a double rate would divide by
zero.  The answer is known from SciPy's DOP853 in other variables: with p as independent variable,
:math:`dv/dp = (v^2 + \mu v - p)/v` from :math:`v^2 + \mu v = p + \tfrac12` far ahead down to
:math:`p = \ln 2`, then :math:`p' = v`, :math:`v' = v^2 + \mu v - p` back in s.

Logarithmic Burgers equation.  :math:`y \ln y` is not Lipschitz at 0, but its limit is regular: the
wave spreads into a true zero as into a small floor.
"""

import functools
import math

import numpy as np
from scipy.integrate import solve_ivp

from granular_fronts.continuum.evolution import evolve_log_burgers
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic
from granular_fronts.studies.hard_cases import HardCase

BEHIND = np.linspace(-30.0, 0.0, 601)
FAR_AHEAD = 200.0
SCIPY = {"method": "DOP853", "rtol": 1.0e-13, "atol": 1.0e-15}

RING = {
    "law": {"alpha": 1.1, "gamma": 0.24},
    "displacement": 5,
    "half_beads": 80,
    "end_time": 90,
    "tolerance": {"relative": 1.0e-9, "absolute": 1.0e-12},
    "equations": {"logarithmic": {"cells": 1024, "tolerance": 1.0e-9}},
    "record": {"snapshots": [10.0, 90.0], "grid": {"step": 0.5}},
}
SMALL_FLOOR = 1.0e-16


def _near_critical_damping(offset):
    """Front of the logarithmic KdV-Burgers equation near μ = 2."""
    mu = 2.0 + offset
    y = heteroclinic(mu, BEHIND)["rescaled_force"].values
    return HardCase(
        problem=f"heteroclinic orbit, μ = 2 {'+' if offset > 0 else '−'} {abs(offset):g}, "
        "−30 ≤ s ≤ 0",
        expected="a monotone front, as at μ = 2",
        criterion="distance of y from SciPy's DOP853 in other variables; y falls everywhere",
        quantity="1 − y at s = −30",
        measured=float(1.0 - y[0]),
        error=float(np.abs(y - _other_orbit(mu)).max()) if (np.diff(y) <= 0.0).all() else math.nan,
        limit=1.0e-12,
    )


def _other_orbit(mu):
    """Rescaled force on `BEHIND`, by SciPy."""
    start = math.sqrt(FAR_AHEAD + 0.5 + 0.25 * mu**2) - 0.5 * mu
    ahead = solve_ivp(
        lambda p, v: (v**2 + mu * v - p) / v, (FAR_AHEAD, math.log(2.0)), [start], **SCIPY
    )
    behind = solve_ivp(
        lambda s, y: [y[1], y[1] ** 2 + mu * y[1] - y[0]],
        (0.0, BEHIND[0]),
        [math.log(2.0), ahead.y[0, -1]],
        t_eval=BEHIND[::-1],
        **SCIPY,
    )
    return np.exp(-behind.y[0][::-1])


def _touching_zero(floor):
    """The start (49) with a floor of almost, or truly, nothing."""
    solved, compared = (evolve_log_burgers(ring(value)) for value in (floor, SMALL_FLOOR))
    y = solved["rescaled_force"]
    difference = float(np.abs(y - compared["rescaled_force"]).max())
    if float(y.min()) < 0.0:
        difference = math.nan
    return HardCase(
        problem=f"logarithmic Burgers equation, start (49) with η = {floor:g}, α = 1.1, to t = 90",
        expected=f"y ≥ 0, the mean conserved, the solution for η = {SMALL_FLOOR:g}",
        criterion=f"change by twice the cells, distance from η = {SMALL_FLOOR:g}, drift of the "
        "mean; no negative y",
        quantity="largest y at the end",
        measured=float(y.isel(t=-1).max()),
        error=max(difference, y.attrs["error_estimate"], solved.attrs["mean_drift"]),
        limit=1.0e-5,
    )


def ring(floor):
    """The periodic scene of section 4.3 for α = 1.1, with a floor η of its own."""
    return RING | {"start": {"kind": "plateau", "half_width": 10, "floor": floor}}


CASES = {
    "mu_below_2": functools.partial(_near_critical_damping, -1.0e-8),
    "mu_above_2": functools.partial(_near_critical_damping, 1.0e-8),
    "floor_1e_300": functools.partial(_touching_zero, 1.0e-300),
    "true_zeros": functools.partial(_touching_zero, 0.0),
}
