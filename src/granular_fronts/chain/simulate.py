r"""From a scene to a dataset: front initiation and every other driven or periodic chain.

A scene is the mapping that the configuration holds under `scenes: chain:`; its keys are described
in `workflow/schemas/config.schema.yaml`.  The motion is integrated in strain form (`strain`) with
the adaptive pair of `integrator`.

Rest means ẋ = 0, James (2021), section 3.3: where a boundary holds a contact compressed at t = 0,
the generalised velocity starts at :math:`w_1(0) = -\gamma\delta^\beta`.

Accuracy.  Every scene is integrated a second time with the tolerance divided by `REFINEMENT`; the
largest difference between the two runs is the error estimate of each recorded variable.  It comes
from an independent refinement and not from the step controller, and bounds the error as long as the
error shrinks with the tolerance, down to the point where both runs consist of rounding.
"""

import math
from typing import NamedTuple

import numpy as np
import xarray as xr
from tqdm import tqdm

from granular_fronts.chain import equations, integrator, recording
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.strain import (
    Size,
    evaluate_slopes,
    make_law,
    make_state,
    reach_of,
)
from granular_fronts.configuration import RELATIVE_TOLERANCE_FLOOR, check_chain_scene

REFINEMENT = 10.0
SOLVER = "DOP853 in strain form, order 8(5,3), steps located at contact events"
ERROR_METHOD = f"largest difference to a second run with the tolerance divided by {REFINEMENT:g}"

FIRST_STEP = 1.0e-6
STEPS_BETWEEN_REPORTS = 2000


class SolveError(ValueError):
    """A solve that stopped: when, at which bead, and why."""


class Solution(NamedTuple):
    """One integration of a scene.

    Attributes
    ----------
    dataset : xarray.Dataset
        Everything recorded.
    counts : dict
        Work: steps accepted, rejected, cut at contacts; right-hand sides.
    drifts : dict
        Largest relative drift of the balance laws.
    """

    dataset: xr.Dataset
    counts: dict
    drifts: dict


def simulate_chain(scene, name="given"):
    """Integrate one chain scene and estimate the errors of what it records.

    Parameters
    ----------
    scene : mapping
        Law, beads, boundary, start, end_time, tolerance, record; dimensionless, James (2021),
        eq. (28).
    name : str, optional
        What error messages call the scene.

    Returns
    -------
    xarray.Dataset
        `relative_displacement` and `velocity` on (t, bead) at the snapshot times, and what else the
        scene records (see `granular_fronts.chain.recording`).  Every variable carries
        `error_estimate` and `error_method`; the dataset carries counts and drifts.

    Raises
    ------
    ConfigurationError
        If the scene is impossible; the sentence names key, value, limit and the way out.
    SolveError
        If the step size collapses, the state is no longer finite, or a contact opens for α < 1.
    """
    scene = check_chain_scene(scene, name)
    tolerance = scene["tolerance"]
    finer = {
        "relative": max(tolerance["relative"] / REFINEMENT, RELATIVE_TOLERANCE_FLOOR),
        "absolute": tolerance["absolute"] / REFINEMENT,
    }
    solution = solve(scene, tolerance, f"scene {name}, solving")
    refined = solve(scene, finer, f"scene {name}, estimating the error")
    return _with_error_estimates(solution, refined.dataset, tolerance)


def solve(scene, tolerance, activity="solving"):
    """Integrate a checked scene once, at the given tolerance.

    Parameters
    ----------
    scene : mapping
    tolerance : mapping
        `relative` and `absolute`, per step, in the maximum norm over beads.
    activity : str
        What the progress line and a failure are headed with.

    Returns
    -------
    Solution
    """
    law = make_law(**scene["law"])
    boundary = make_boundary(scene)
    u, velocity = initial_state(scene, boundary)
    size = Size(scene["beads"], scene["beads"] if boundary.ring else scene["beads"] - 1)
    with np.errstate(over="ignore", invalid="ignore"):
        state = load_state(law, size, boundary, u, velocity)
    if not (np.isfinite(state.d).all() and np.isfinite(state.force).all()):
        raise SolveError(
            f"{activity}: the forces at t = 0 overflow double precision; scale the boundary values "
            "and the start down, eq. (27)."
        )
    record = recording.make_recording(scene, state.u.size)
    clock = start_clock(size, state)
    evaluate_slopes(law, size, state, state.u, 0, clock.reach[0])
    balances = Balances(law, size, boundary, state, velocity.sum())
    status = integrator.RUNNING
    with tqdm(total=float(scene["end_time"]), desc=activity, unit="t", delay=2.0) as progress:
        while status == integrator.RUNNING:
            status = integrator.advance(
                law,
                size,
                state,
                clock,
                float(tolerance["relative"]),
                float(tolerance["absolute"]),
                record,
                STEPS_BETWEEN_REPORTS,
            )
            progress.update(clock.t[0] - progress.n)
            balances.check(state, clock, record.track_energy)
    if status != integrator.FINISHED:
        raise SolveError(f"{activity}: {_cause(status, state, clock, size)}")
    dataset = recording.collect(scene, record, boundary, velocity.sum())
    return Solution(dataset, _counts(clock), balances.drifts())


def make_boundary(scene):
    """Boundary conditions (25) or (26) of a scene."""
    boundary = scene["boundary"]
    if boundary["kind"] == "ring":
        return Boundary(ring=True)
    return Boundary(ring=False, left=float(boundary["left"]), right=float(boundary["right"]))


def initial_state(scene, boundary):
    """Relative displacements and velocities at t = 0, both of shape (N,)."""
    beads, start = scene["beads"], scene["start"]
    u, velocity = np.zeros(beads), np.zeros(beads)
    if start["kind"] == "given":
        given = np.asarray(start["relative_displacement"], dtype=float)
        u[: given.size] = given
        velocity[:] = start["velocity"]
    if not boundary.ring:
        u[-1] = boundary.right
    return u, velocity


def load_state(law, size, boundary, u, velocity):
    """Arrays of the integrator at t = 0, with the forces of held contacts in place."""
    state = make_state(size.beads)
    beads = slice(1, size.beads + 1)
    state.u[beads] = u
    state.d[beads] = equations.strain_rates(velocity, u, boundary, law.beta, law.gamma)
    if not boundary.ring:
        state.u[size.beads] = 0.0
        for forces, exponent in ((state.force, law.alpha), (state.damping, law.beta)):
            forces[0] = equations.force(boundary.left, exponent)
            forces[size.beads :] = equations.force(boundary.right, exponent)
    return state


def start_clock(size, state):
    """A clock at t = 0; the first step is small and grows tenfold while the error allows it."""
    return integrator.Clock(
        t=np.zeros(1),
        h=np.array([FIRST_STEP]),
        reach=np.array([_first_reach(size, state)]),
        counts=np.zeros(4, dtype=np.int64),
        dissipated=np.zeros(1),
    )


def _first_reach(size, state):
    """The whole chain unless its right part is at rest, untouched and free."""
    if size.contacts == size.beads or state.force[size.beads] > 0.0:
        return size.beads
    return reach_of(size, state.u, state.d, size.beads)


class Balances:
    """Momentum law and energy balance of a run, checked between blocks of steps."""

    def __init__(self, law, size, boundary, state, momentum):
        self._law, self._size, self._boundary = law, size, boundary
        self._momentum = momentum
        self._energy_before, self._first_bead, self._last_bead = self._measure(state)[1:]
        self._worst = {"momentum": 0.0, "energy": 0.0}
        self._scale = {"momentum": 0.0, "energy": self._energy_before}
        self._energy_is_tracked = False

    def check(self, state, clock, energy_is_tracked):
        """Compare with the exact laws at the present time."""
        law, boundary, t = self._law, self._boundary, clock.t[0]
        velocity, energy, first_bead, last_bead = self._measure(state)
        left = equations.force(boundary.left, law.alpha)
        right = equations.force(boundary.right, law.alpha)
        work = left * (first_bead - self._first_bead) - right * (last_bead - self._last_bead)
        gained = 0.0 if boundary.ring else (left - right) * t
        self._note("momentum", velocity.sum() - self._momentum - gained, np.abs(velocity).sum())
        if energy_is_tracked:
            self._energy_is_tracked = True
            balance = energy - self._energy_before - work + clock.dissipated[0]
            self._note("energy", balance, energy)

    def drifts(self):
        """Largest drifts relative to Σ|ẋ_n| and to the largest energy; NaN where not tracked."""
        momentum = self._worst["momentum"] / (self._scale["momentum"] or 1.0)
        energy = self._worst["energy"] / (self._scale["energy"] or 1.0)
        return {
            "momentum_drift": float(momentum),
            "energy_drift": float(energy) if self._energy_is_tracked else math.nan,
        }

    def _note(self, name, drift, scale):
        self._worst[name] = max(self._worst[name], abs(drift))
        self._scale[name] = max(self._scale[name], abs(scale))

    def _measure(self, state):
        """Velocities, energy, and positions of the first and last bead (0 on a ring)."""
        law, boundary = self._law, self._boundary
        beads = slice(1, self._size.beads + 1)
        u, positions = state.u[beads].copy(), (0.0, 0.0)
        if not boundary.ring:
            positions = (u.sum(), u[-1])
            u[-1] = boundary.right
        d = state.d[beads]
        velocity = equations.velocities(d, u, boundary, law.beta, law.gamma, self._momentum)
        return velocity, equations.energy(u, velocity, boundary, law.alpha), *positions


def _counts(clock):
    return {
        "steps_accepted": int(clock.counts[integrator.ACCEPTED]),
        "steps_rejected": int(clock.counts[integrator.REJECTED]),
        "steps_cut_at_contacts": int(clock.counts[integrator.REJECTED_AT_CONTACT]),
        "right_hand_sides": int(clock.counts[integrator.STAGE_COUNT]),
    }


def _cause(status, state, clock, size):
    """The sentence for a solve that stopped."""
    t = clock.t[0]
    contacts = slice(1, size.contacts + 1)
    if status == integrator.OPENED:
        bead = 1 + int(np.argmin(state.new_u[contacts]))
        return (
            f"At t = {t:.6g} the contact of beads {bead} and {bead + 1} opens. For alpha < 1 the "
            "force is not differentiable there and the motion is not known to be unique: "
            "precompress the chain, lower the load, or end the run earlier."
        )
    if status == integrator.NOT_FINITE:
        bead = 1 + int(np.argmax(~np.isfinite(state.new_u[contacts])))
        return (
            f"At t = {t:.6g} the state of bead {bead} is not a finite number however short the "
            "step: the start or the boundary values are too large for double precision."
        )
    bead = 1 + int(np.argmax(np.abs(state.new_u[contacts] - state.u[contacts])))
    return (
        f"At t = {t:.6g} the step size collapsed to {clock.h[0]:.3g}, with the fastest change at "
        f"bead {bead}: the tolerance cannot be met in double precision; raise tolerance.relative "
        "or tolerance.absolute."
    )


def _with_error_estimates(solution, refined, tolerance):
    """The dataset of `solution`, each variable with its largest difference to `refined`."""
    dataset = solution.dataset
    for name, variable in dataset.data_vars.items():
        estimate = _largest(np.abs(variable - refined[name]))
        # Two runs may agree to the last bit by chance; the last bit itself is still uncertain.
        estimate = max(estimate, float(np.spacing(_largest(np.abs(variable)))))
        variable.attrs |= {"error_estimate": estimate, "error_method": ERROR_METHOD}
    dataset.attrs |= {
        "solver": SOLVER,
        "relative_tolerance": float(tolerance["relative"]),
        "absolute_tolerance": float(tolerance["absolute"]),
        **solution.counts,
        **solution.drifts,
    }
    return dataset


def _largest(values):
    """Largest finite entry, or NaN if there is none."""
    return float(values.max()) if np.isfinite(values).any() else math.nan


def warm_up():
    """Compile every kernel once, so that jobs which run side by side find them in the cache."""
    for alpha, beta in ((1.5, 1.5), (1.2, 1.2), (1.5, 1.0)):
        scene = {
            "law": {"alpha": alpha, "beta": beta, "gamma": 0.1},
            "beads": 4,
            "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
            "start": {"kind": "rest"},
            "end_time": 1.0,
            "tolerance": {"relative": 1.0e-6, "absolute": 1.0e-8},
            "record": {"snapshots": [1.0], "balances": True},
        }
        solve(scene, scene["tolerance"])
