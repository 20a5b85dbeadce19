r"""Chains by the step of discrete-element codes and by the accurate solver, and what is read off.

A chain at rest is pressed by δ = 1 at its left end, so that c = 1.  Times are compared with that of
a collision, `problems.collision_time`.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.referee.measurements import cubic_between
from granular_fronts.reference_methods.half_step import Chain, Motion, integrate
from granular_fronts.studies.chain_scenes import pressed_chain

LEVEL = 0.5
"""u at which a front arrives."""

TOLERANCE = 1.0e-11, 1.0e-13

CHAIN_METHOD = "error estimate of the accurate chain"


class Case(NamedTuple):
    """A chain pressed by δ = 1: α, β, γ, the number N of beads, and the end of its motion."""

    alpha: float
    beta: float
    gamma: float
    beads: int
    end_time: float


class Measurement(NamedTuple):
    """First peak of u in the middle, arrival times at a quarter and there, and u at the end."""

    peak: float
    arrivals: np.ndarray
    u: np.ndarray


def half_step_chain(case: Case, step: float) -> Motion:
    """Return the motion of the chain by the scheme."""
    rest = np.zeros(case.beads)
    chain = Chain(case.alpha, case.beta, case.gamma, left=1.0)
    return integrate(chain, rest, rest, step, round(case.end_time / step))


def accurate_chain(case: Case) -> tuple[Measurement, float]:
    """Return the same of the accurate chain, and the largest error estimate of what is read."""
    middle = case.beads // 2
    record = {"snapshots": [case.end_time], "arrival_level": LEVEL, "extremes": True}
    motion = _solve_accurately(case, record)
    peaks, arrivals = motion["first_peak"], motion["arrival_time"]
    u = motion["relative_displacement"]
    measurement = Measurement(
        float(peaks.sel(bead=middle)),
        arrivals.sel(bead=[middle // 2, middle]).values,
        u.values[0, :-1],
    )
    return measurement, max(float(read.attrs["error_estimate"]) for read in (peaks, arrivals, u))


def _solve_accurately(case: Case, record: Mapping[str, Any]) -> xr.Dataset:
    """Return the chain by the package's own solver."""
    law = {"alpha": case.alpha, "beta": case.beta, "gamma": case.gamma}
    scene = pressed_chain(law, case.beads, case.end_time, TOLERANCE, record)
    return simulate_chain(scene, f"chain with beta {case.beta:g} and gamma {case.gamma:g}")


def read_motion(case: Case, motion: Motion) -> Measurement:
    """Return what is compared with the accurate chain."""
    middle = case.beads // 2
    arrivals = [passing(motion, contact, "arrival")[0] for contact in (middle // 2, middle)]
    return Measurement(
        passing(motion, middle, "peak")[1], np.array(arrivals), -np.diff(motion.x[-1])
    )


def passing(motion: Motion, contact: int, event: str) -> tuple[float, float]:
    """Return time and u where u of a contact first passes `LEVEL`, or its first maximum above 1.

    Between two steps u is taken from `cubic_between`.
    """
    u = motion.x[:, contact - 1] - motion.x[:, contact]
    rate = motion.v[:, contact - 1] - motion.v[:, contact]
    reached = u > LEVEL if event == "arrival" else (u > 1.0) & (rate < 0.0)
    after = int(np.argmax(reached))
    if after == 0:
        raise SolveError(
            f"Contact {contact} does not pass its {event} before t = {motion.t[-1]:g}: lower gamma "
            "so that there is a peak, or end later."
        )
    curve = cubic_between(motion.t, u, rate, after - 1)
    sought = curve.solve(LEVEL) if event == "arrival" else curve.derivative().roots()
    time = sought[(sought >= motion.t[after - 1]) & (sought <= motion.t[after])][0]
    return time, float(curve(time))


def compare_motion(case: Case, step: float) -> xr.Dataset:
    """Compare u of the contact in the middle by the scheme and accurately, a step apart."""
    middle = case.beads // 2
    motion = half_step_chain(case, step)
    probe = {"beads": [middle], "start": 0.0, "stop": case.end_time, "step": step}
    record = {"snapshots": [], "probes": {"middle": probe}}
    accurate = _solve_accurately(case, record)["relative_displacement_middle"].isel(bead_middle=0)
    estimate = {name: accurate.attrs[name] for name in ("error_estimate", "error_method")}
    u = motion.x[:, middle - 1] - motion.x[:, middle]
    return xr.Dataset(
        {
            "relative_displacement_method": ("t", u, estimate),
            "relative_displacement_accurate": ("t", accurate.values[: u.size], estimate),
        },
        {"t": motion.t},
    )
