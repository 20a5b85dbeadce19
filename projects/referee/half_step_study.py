r"""What the step of discrete-element codes does to a front, read as damping.

A chain with δ = c = 1 is moved by the scheme of `reference_methods.half_step`, whose contacts carry
up to h² the force :math:`-\tfrac h2 g\ddot u` besides, :math:`g = \gamma\beta u^{\beta-1}`.  What
this does can be read as another γ, by two observables.

- *Overshoot*: the γ for which the accurate chain has the first peak of u that the scheme has, at
  the contact in the middle.  Near a peak ü < 0, so that the additional force is repulsive and the
  peak lower, as damping makes it.
- *Tail*: the γ for which the oscillations behind an exact front decay as in the scheme. A wave
  :math:`u = 1 + Ae^{\lambda(n-t)}` of the scheme has

  .. math::

      \frac{2\cosh\lambda h - 2}{h^2}
      = (2\cosh\lambda - 2)\Bigl(\alpha - \beta\gamma\,\frac{e^{\lambda h}-1}{h}\Bigr),

  the dispersion relation of `fronts.linear.tails` for h → 0.

The two differ, so that the error is no damping: no other γ makes up for it.  The error changes the
peak by an amount of order hγ, and the damping by one of order γ.  The first is therefore of the
size of h/t_c, and near it for β = 3/2 in a long chain (README.md).  The tail says less:
for a wave :math:`e^{i\omega t}` ü is in phase with u, so the error shifts the frequency; decay
changes only at order hγ².

The checks that discrete-element codes are given are added, as relative errors:

- *restitution*: 1 − e of a collision of two beads that meet at the velocity 1, mean over the phase
  of the first contact within a step;
- *momentum*: Σv over the impulse δ^α t of the pressure;
- *energy*: with what the forces of the scheme dissipate, less the work of the pressure;
- *speed* of the front, from the times at which u passes ½ at a quarter and in the middle.
"""

import cmath
from typing import Any

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from granular_fronts.accuracy import Estimate, recorded, tabulated
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.model.collision import restitution
from granular_fronts.referee.measurements import excess_by_table
from granular_fronts.referee.problems import collision_time
from granular_fronts.reference_methods.half_step import Chain, Motion, integrate
from granular_fronts.studies.orders import ORDER_METHOD, observed_orders
from half_step_motions import (
    CHAIN_METHOD,
    Case,
    accurate_chain,
    compare_motion,
    half_step_chain,
    read_motion,
)

FACTORS = (0.97, 1.0, 1.07, 1.17, 1.3)
"""Dampings over γ at which the peak of the accurate chain is known; between, a polynomial."""

PHASES = 16
"""Phases of the first contact of a collision within a step."""

CONTINUATION = 20
"""Parts of a step along which a root is followed."""

TAIL_ERROR = 1.0e-12
TAIL_METHOD = "rounding of the roots"

TABLE_METHOD = "change when one tabulated damping is left out"


ERRORS = {
    "error": ("chain_error", CHAIN_METHOD),
    "peak": ("chain_error", CHAIN_METHOD),
    "peak_exact": ("chain_error", CHAIN_METHOD),
    "excess_overshoot": ("table_error", TABLE_METHOD),
    "order": ("order_error", ORDER_METHOD),
    "order_error": ("order_error", ORDER_METHOD),
}
"""For each variable, the one that holds the error of each chain, and the method."""


def compare_half_steps(**scene: Any) -> xr.Dataset:
    """Compare the scheme with accurate chains, over law, damping and step.

    On (beta, gamma, step), the step over t_c: `error`, `peak`, `excess_overshoot`,
    `excess_tail`.  On (beta, gamma): `peak_exact`, `order`, `order_error`.  For the chain that is
    shown: the checks of `_measure_checks` and the motion of `compare_motion`.
    """
    unit, shown = collision_time(scene["alpha"]), scene["shown"]
    steps = unit / np.sort(scene["steps_per_collision"])

    def case(beta: float, gamma: float) -> Case:
        end_time = scene["collision_times"] * unit
        return Case(scene["alpha"], beta, gamma, scene["beads"], end_time)

    rows = [
        xr.concat([measure_excess(case(beta, gamma), steps) for gamma in scene["gammas"]], "gamma")
        for beta in scene["betas"]
    ]
    found = xr.concat(rows, "beta").assign_coords(
        beta=scene["betas"], gamma=scene["gammas"], step=steps / unit
    )
    found["excess_tail"].attrs = {"error_estimate": TAIL_ERROR, "error_method": TAIL_METHOD}
    for name, (errors, method) in ERRORS.items():
        largest = float(np.nanmax(found[errors]))
        found[name].attrs = {"error_estimate": largest, "error_method": method}
    chain = case(shown["beta"], shown["gamma"])
    motion = compare_motion(chain, unit / shown["steps_per_collision"])
    found = found.drop_vars(["chain_error", "table_error"])
    return found.merge(_measure_checks(chain, steps)).merge(motion)


def measure_excess(case: Case, steps: np.ndarray) -> xr.Dataset:
    """Return the error, peak and excess damping of one chain at three or more falling steps."""
    chains = [accurate_chain(case._replace(gamma=factor * case.gamma)) for factor in FACTORS]
    table = [measurement.peak for measurement, _ in chains]
    exact, estimate = chains[FACTORS.index(1.0)]
    found = [read_motion(case, half_step_chain(case, step)) for step in steps]
    error = np.array([np.abs(one.u - exact.u).max() for one in found])
    orders = observed_orders(error, steps)
    peak = np.array([one.peak for one in found])
    overshoot = excess_by_table(peak, FACTORS, table)
    # Of the tabulated dampings one between γ and the largest is left out.
    coarse = excess_by_table(peak, FACTORS[:2] + FACTORS[3:], table[:2] + table[3:])
    return xr.Dataset(
        {
            "error": ("step", error),
            "peak": ("step", peak),
            "peak_exact": exact.peak,
            "excess_overshoot": ("step", overshoot),
            "excess_tail": ("step", [excess_of_tail(case, step) for step in steps]),
            "order": orders[-1],
            "order_error": abs(orders[-1] - orders[-2]),
            "chain_error": estimate,
            "table_error": np.nanmax(np.abs(overshoot - coarse)),
        }
    )


def excess_of_tail(case: Case, step: float) -> float:
    """Return γ of the front whose tail decays as in the scheme, over γ, less 1."""
    root = tail_root(case, step)

    def slower(factor: float) -> float:
        roots = tail_roots(case.alpha, factor * case.gamma, case.beta, count=2)
        return float(roots[0].real - root.real)

    return brentq(slower, 0.5, 2.0, xtol=1.0e-13) - 1.0


def tail_root(case: Case, step: float) -> complex:
    """Return root of the scheme's dispersion relation that the slowest one for h = 0 becomes."""
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


def _measure_checks(case: Case, steps: np.ndarray) -> xr.Dataset:
    """Return the four checks on (step,), each as a relative error under `<name>_defect`."""
    exact, estimate = accurate_chain(case)
    loss = 1.0 - restitution(case.gamma, case.alpha, case.beta)
    found: dict[str, list[float]] = {
        name: [] for name in ("restitution", "momentum", "energy", "speed")
    }
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


def collision_loss(case: Case, step: float) -> float:
    """Return 1 − e of two beads that meet at the velocity 1 in the scheme; mean over phases."""
    chain = Chain(case.alpha, case.beta, case.gamma)
    steps = round(4.0 * collision_time(case.alpha) / step)
    apart = []
    for phase in (np.arange(PHASES) + 0.5) / PHASES:
        motion = integrate(chain, [-phase * step, 0.0], [1.0, 0.0], step, steps)
        apart.append(motion.v[-1, 1] - motion.v[-1, 0])
    return 1.0 - float(np.mean(apart))


def energy_defect(case: Case, motion: Motion) -> float:
    """Return energy, and what the forces of the scheme dissipate, less the work; over the work."""
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


def order_of_half_steps(dataset: xr.Dataset, beta: float, gamma: float) -> Estimate:
    """Return the observed order of the half-step scheme towards the accurate chain."""
    return tabulated(dataset.sel(beta=beta, gamma=gamma), "order")


def excess_damping(
    dataset: xr.Dataset, observable: str, beta: float, gamma: float, steps_per_collision: float
) -> Estimate:
    """Return the damping that an observable of the half-step scheme looks like, over γ, less 1."""
    excess = dataset[f"excess_{observable}"].sel(beta=beta, gamma=gamma)
    return recorded(excess.sel(step=1.0 / steps_per_collision, method="nearest", tolerance=1e-9))
