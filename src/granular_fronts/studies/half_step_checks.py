r"""The checks that discrete-element codes are given, on the half-step scheme, as relative errors.

- *Restitution*: 1 − e of a collision of two beads that meet at the velocity 1, mean over the phase
  of the first contact within a step.
- *Momentum*: Σv over the impulse δ^α t of the pressure.
- *Energy*: with what the forces of the scheme dissipate, less the work of the pressure.
- *Speed* of the front, from the times at which u passes ½ at a quarter and in the middle.
"""

import numpy as np
import xarray as xr

from granular_fronts.model.collision import restitution
from granular_fronts.reference_methods.half_step import Chain, integrate
from granular_fronts.studies.half_step_motions import (
    CHAIN_METHOD,
    accurate_chain,
    collision_time,
    half_step_chain,
    read_motion,
)

PHASES = 16
"""Of the first contact of a collision, within a step."""


def measure_checks(case, steps):
    """The four checks, each as a relative error.

    Returns
    -------
    xarray.Dataset
        On (step,): `restitution_defect`, `momentum_defect`, `energy_defect`, `speed_defect`.
    """
    exact, estimate = accurate_chain(case)
    loss = 1.0 - restitution(case.gamma, case.alpha, case.beta)
    found = {name: [] for name in ("restitution", "momentum", "energy", "speed")}
    for step in steps:
        motion = half_step_chain(case, step)
        found["restitution"].append(abs(collision_loss(case, step) / loss - 1.0))
        found["momentum"].append(abs(motion.v[-1].sum() / case.end_time - 1.0))
        found["energy"].append(energy_defect(case, motion))
        passed = np.diff(read_motion(case, motion).arrivals)
        found["speed"].append(abs(float(np.diff(exact.arrivals)[0] / passed[0]) - 1.0))
    attributes = {"error_estimate": estimate, "error_method": CHAIN_METHOD}
    return xr.Dataset(
        {f"{name}_defect": ("step", values, attributes) for name, values in found.items()}
    )


def collision_loss(case, step):
    """1 − e of two beads that meet at the velocity 1, by the scheme; mean over the phases."""
    chain = Chain(case.alpha, case.beta, case.gamma)
    steps = round(4.0 * collision_time(case.alpha) / step)
    apart = []
    for phase in (np.arange(PHASES) + 0.5) / PHASES:
        motion = integrate(chain, [-phase * step, 0.0], [1.0, 0.0], step, steps)
        apart.append(motion.v[-1, 1] - motion.v[-1, 0])
    return 1.0 - float(np.mean(apart))


def energy_defect(case, motion):
    """Energy, and what the forces of the scheme dissipate, less the work; over the work."""
    step = motion.t[1]
    u = np.maximum(-np.diff(motion.x, axis=1), 0.0)
    rate = -np.diff(motion.v, axis=1)
    half_rate = np.diff(-np.diff(motion.x, axis=1), axis=0) / step
    half_rate = np.vstack([np.zeros_like(u[:1]), half_rate])
    damping = np.where(u > 0.0, case.gamma * case.beta * u ** (case.beta - 1.0), 0.0)
    power = (damping * half_rate * rate).sum(axis=1)
    dissipated = step * (power.sum() - 0.5 * (power[0] + power[-1]))
    elastic = (u[-1] ** (case.alpha + 1.0)).sum() / (case.alpha + 1.0)
    energy = 0.5 * (motion.v[-1] ** 2).sum() + elastic
    work = motion.x[-1, 0]
    return abs(energy + dissipated - work) / work
