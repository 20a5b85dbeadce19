r"""What the step of discrete-element codes does to a front, read as damping.

A chain with δ = c = 1 is moved by the scheme of `reference_methods.half_step`, whose contacts carry
up to h² the force :math:`-\tfrac h2 g\ddot u` besides, :math:`g = \gamma\beta u^{\beta-1}`.  What
this does can be read as another γ, by two observables.

- *Overshoot*: the γ for which the accurate chain has the first peak of u that the scheme has, at
  the contact in the middle.  Near a peak ü < 0, so that the additional force is repulsive and the
  peak lower, as damping makes it.
- *Tail*: the γ for which the oscillations behind an exact front decay as those of the scheme do.
  A wave :math:`u = 1 + Ae^{\lambda(n-t)}` of the scheme has

  .. math::

      \frac{2\cosh\lambda h - 2}{h^2}
      = (2\cosh\lambda - 2)\Bigl(\alpha - \beta\gamma\,\frac{e^{\lambda h}-1}{h}\Bigr),

  the dispersion relation of `fronts.linear.tails` for h → 0.

The two differ, so that the error is no damping: no other γ makes up for it.  The error changes the
peak by an amount of order hγ, as the damping itself does by one of order γ; the first is therefore
of the size of h/t_c, and near it for β = 3/2 in a long chain (docs/practitioners.md).  The tail
says less: for a wave :math:`e^{i\omega t}` ü is in phase with u, so the error shifts the frequency;
decay changes only at order hγ².
"""

import cmath
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import KroghInterpolator
from scipy.optimize import brentq

from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.studies.half_step_checks import measure_checks
from granular_fronts.studies.half_step_motions import (
    CHAIN_METHOD,
    Case,
    accurate_chain,
    collision_time,
    compare_motion,
    half_step_chain,
    read_motion,
)

FACTORS = (0.97, 1.0, 1.07, 1.17, 1.3)
"""Dampings over γ at which the peak of the accurate chain is known; between, a polynomial."""

CONTINUATION = 20
"""Parts of a step along which a root is followed."""

TAIL_ERROR = 1.0e-12

ORDER_METHOD = "change from the last pair of steps but one to the last"
READING_METHOD = "change of the reading that leaving out one tabulated damping makes"


class Excess(NamedTuple):
    """What the scheme does to one chain, at some steps.

    Attributes
    ----------
    error, peak : ndarray, shape (steps,)
        Largest error of u at the end; first peak in the middle.
    overshoot, tail : ndarray, shape (steps,)
        Excess damping over γ, by either observable; NaN beyond the table.
    exact_peak, order : float
        Of the accurate chain; observed at the last two steps.
    chain_error, reading_error, order_change : float
        Error estimates of the accurate chain, of `overshoot` and of `order`.
    """

    error: np.ndarray
    peak: np.ndarray
    overshoot: np.ndarray
    tail: np.ndarray
    exact_peak: float
    order: float
    chain_error: float
    reading_error: float
    order_change: float


def measure_half_step_damping(scene):
    """Compare the scheme with accurate chains, over law, damping and step.

    Parameters
    ----------
    scene : mapping
        `laws.half_step_damping` of the configuration; steps and end in collision times.

    Returns
    -------
    xarray.Dataset
        On (beta, gamma, step), the step over t_c: `error`, `peak`, `excess_overshoot`,
        `excess_tail`; on (beta, gamma): `peak_exact`, `order`, `order_error`; for the chain that is
        shown the checks of `measure_checks` and the motion of `compare_motion`.
    """
    unit, shown = collision_time(scene["alpha"]), scene["shown"]
    steps = unit / np.sort(scene["steps_per_collision"])

    def case(beta, gamma):
        end_time = scene["collision_times"] * unit
        return Case(scene["alpha"], beta, gamma, scene["beads"], end_time)

    found = [
        [measure_excess(case(beta, gamma), steps) for gamma in scene["gammas"]]
        for beta in scene["betas"]
    ]
    dataset = collect(found).assign_coords(
        beta=scene["betas"], gamma=scene["gammas"], step=steps / unit
    )
    chain = case(shown["beta"], shown["gamma"])
    motion = compare_motion(chain, unit / shown["steps_per_collision"])
    return dataset.merge(measure_checks(chain, steps)).merge(motion)


def collect(found):
    """Dataset of all chains, on (beta, gamma)."""

    def stacked(name):
        return np.array([[getattr(one, name) for one in row] for row in found])

    def variable(name, error, method):
        values, estimate = stacked(name), float(np.nanmax(stacked(error)))
        dimensions = ("beta", "gamma", "step")[: values.ndim]
        return dimensions, values, {"error_estimate": estimate, "error_method": method}

    tail = {"error_estimate": TAIL_ERROR, "error_method": "rounding of the roots"}
    return xr.Dataset(
        {
            "error": variable("error", "chain_error", CHAIN_METHOD),
            "peak": variable("peak", "chain_error", CHAIN_METHOD),
            "peak_exact": variable("exact_peak", "chain_error", CHAIN_METHOD),
            "excess_overshoot": variable("overshoot", "reading_error", READING_METHOD),
            "excess_tail": (("beta", "gamma", "step"), stacked("tail"), tail),
            "order": variable("order", "order_change", ORDER_METHOD),
            "order_error": variable("order_change", "order_change", ORDER_METHOD),
        }
    )


def measure_excess(case, steps):
    """Error, peak and excess damping of the scheme at some steps.

    Parameters
    ----------
    case : Case
        Its end is a multiple of every step.
    steps : ndarray
        Three or more h, falling.

    Returns
    -------
    Excess
    """
    chains = [accurate_chain(case._replace(gamma=factor * case.gamma)) for factor in FACTORS]
    table = [reading.peak for reading, _ in chains]
    exact, estimate = chains[FACTORS.index(1.0)]
    found = [read_motion(case, half_step_chain(case, step)) for step in steps]
    error = np.array([np.abs(one.u - exact.u).max() for one in found])
    orders = np.log(error[:-1] / error[1:]) / np.log(steps[:-1] / steps[1:])
    peak = np.array([one.peak for one in found])
    overshoot = excess_by_table(peak, FACTORS, table)
    coarse = excess_by_table(peak, FACTORS[:2] + FACTORS[3:], table[:2] + table[3:])
    return Excess(
        error,
        peak,
        overshoot,
        np.array([excess_of_tail(case, step) for step in steps]),
        exact.peak,
        orders[-1],
        estimate,
        np.nanmax(np.abs(overshoot - coarse)),
        abs(orders[-1] - orders[-2]),
    )


def excess_by_table(peaks, factors, table):
    """γ of the accurate chain with a peak, over γ, less 1; NaN beyond the table.

    Parameters
    ----------
    peaks : ndarray
    factors, table : sequence of float
        Dampings over γ, and the peaks of the accurate chain there.

    Returns
    -------
    ndarray, of the shape of `peaks`
    """
    inside = (peaks <= max(table)) & (peaks >= min(table))
    # Barycentric weights of SciPy are multiplied in random order, unlike these differences.
    logarithm = KroghInterpolator(table, np.log(factors))
    return np.where(inside, np.expm1(logarithm(peaks)), np.nan)


def excess_of_tail(case, step):
    """γ of the front whose tail decays like that of the scheme, over γ, less 1."""
    root = tail_root(case, step)

    def slower(factor):
        roots = tail_roots(case.alpha, factor * case.gamma, case.beta, count=2)
        return float(roots[0].real - root.real)

    return brentq(slower, 0.5, 2.0, xtol=1.0e-13) - 1.0


def tail_root(case, step):
    """The root of the scheme's dispersion relation that the slowest one for h = 0 becomes.

    Parameters
    ----------
    case : Case
    step : float
        h.
    """
    root = complex(tail_roots(case.alpha, case.gamma, case.beta, count=1)[0])
    damping = case.beta * case.gamma
    for h in np.linspace(0.0, step, CONTINUATION + 1)[1:]:
        for _ in range(6):
            lag = case.alpha - damping * (cmath.exp(root * h) - 1.0) / h
            bell = 2.0 * cmath.cosh(root) - 2.0
            excess = (2.0 * cmath.cosh(root * h) - 2.0) / h**2 - bell * lag
            slope = 2.0 * cmath.sinh(root * h) / h - 2.0 * cmath.sinh(root) * lag
            root -= excess / (slope + bell * damping * cmath.exp(root * h))
    return root
