r"""Hard cases of a driven chain: extremes of the law, the pressure, the length and the time.

Unless a case says otherwise, :math:`\delta = 1`, so that a front runs with :math:`c = 1`, on a
chain at rest.  The run ends before the front reaches the free end.  Answers come from

- `extended`: another method in other variables and 80-bit arithmetic,
- the scaling (27)-(30): with :math:`x = \delta\hat x`,
  :math:`t = \delta^{(1-\alpha)/2}\,\hat t` and
  :math:`\gamma = \delta^{(1-\alpha)/2}\hat\gamma` (for :math:`\beta = \alpha`) the motion does
  not depend on δ,
- symmetries, balance laws and closed solutions.
"""

import functools

import numpy as np

from granular_fronts.chain.simulate import solve
from granular_fronts.reference_methods.extended import reference_state
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from granular_fronts.studies.hard_cases import HardCase

TOLERANCE = 1.0e-13, 1.0e-15
BEADS, END_TIME = 40, 30.0
AGAINST_EXTENDED = "distance of u and ẋ at the end from another method in 80-bit arithmetic"


def make_scene(law, beads, end_time, left=1.0, right=0.0, start=None, tolerance=None):
    """A chain between two held displacements, as of `pressed_chain`, recorded at its end."""
    record = {"snapshots": [end_time], "balances": True}
    return pressed_chain(law, beads, end_time, tolerance or TOLERANCE, record, left, right, start)


def final_state(scene):
    """Fields u and ẋ at the last snapshot, and the drifts of the balance laws."""
    solution = solve(scene)
    final = solution.dataset.isel(t=-1)
    return final["relative_displacement"].values, final["velocity"].values, solution.drifts


def initiation(law, expected="a front", beads=BEADS, end_time=END_TIME, right=0.0, start=None):
    """A chain driven from the left, against the extended precision."""
    scene = make_scene(law, beads, end_time, right=right, start=start)
    u, velocity, _ = final_state(scene)
    reference = reference_state(scene)
    distances = np.abs(u - reference.relative_displacement), np.abs(velocity - reference.velocity)
    return HardCase(
        problem="initiation, α = {alpha:g}, β = {beta:g}, γ = {gamma:g}".format(**law)
        + f", δ = 1, N = {beads}, to t = {end_time:g}",
        expected=expected,
        criterion=AGAINST_EXTENDED,
        quantity="largest u at the end",
        measured=float(u.max()),
        error=reference.error + max(float(one.max()) for one in distances),
        limit=1.0e-12,
    )


def _precompression():
    """Contacts that touch by 10⁻¹²: force and stiffness are tiny, but nowhere zero."""
    touch = 1.0e-12
    start, law = (np.full(BEADS - 1, touch), np.zeros(BEADS)), kuwabara_kono(1.5, 0.1)
    case = initiation(law, "the front of the uncompressed chain", right=touch, start=start)
    return case._replace(problem=f"precompression u = {touch:g}, {case.problem}")


def _scaling(delta):
    """A run at another pressure, scaled by (27)-(30), is the run at δ = 1."""
    time_scale = delta ** ((1.0 - 1.5) / 2.0)
    law, scaled_law = (kuwabara_kono(1.5, 0.1 * scale) for scale in (1.0, time_scale))
    end_time, tolerance = END_TIME * time_scale, (TOLERANCE[0], TOLERANCE[1] * delta)
    u, velocity, _ = final_state(make_scene(law, BEADS, END_TIME))
    u_scaled, velocity_scaled, _ = final_state(
        make_scene(scaled_law, BEADS, end_time, left=delta, tolerance=tolerance)
    )
    errors = u_scaled / delta - u, velocity_scaled * time_scale / delta - velocity
    return HardCase(
        problem=f"δ = {delta:g}, α = β = 3/2, γ = {scaled_law['gamma']:g}, N = {BEADS}, "
        f"to t = {end_time:g}",
        expected="the run at δ = 1, scaled",
        criterion="relative distance from the scaled run at δ = 1",
        quantity="largest u/δ at the end",
        measured=float(u_scaled.max() / delta),
        error=max(float(np.abs(error).max()) for error in errors),
        limit=1.0e-12,
    )


def _colliding_fronts():
    """Equal pressure at both ends: two fronts meet in the middle, each the mirror of the other."""
    law = kuwabara_kono(1.5, 0.3)
    case = initiation(law, "mirror symmetry, and no contact opens", end_time=25.0, right=1.0)
    u, velocity, _ = final_state(make_scene(law, BEADS, 25.0, right=1.0))
    mirrored = np.abs(u[:-1] - u[-2::-1]).max(), np.abs(velocity + velocity[::-1]).max()
    return case._replace(
        problem=f"two fronts meet, {case.problem}",
        criterion=f"{AGAINST_EXTENDED}, and from its own mirror image",
        error=max(case.error, *map(float, mirrored)),
    )


def _many_beads(beads=100_000, period=25):
    """N = 10⁵: a ring of many copies of one period moves like the ring of that period."""
    phase = 2.0 * np.pi * np.arange(period) / period
    start = 1.0 + 0.5 * np.cos(2.0 * phase), 0.15 * np.sin(phase)
    copies = beads // period
    states = []
    for repeats in (1, copies):
        tiled = [np.tile(part, repeats) for part in start]
        scene = make_scene(kuwabara_kono(1.5, 0.1), repeats * period, 10.0, start=tiled)
        states.append(final_state(scene | {"boundary": {"kind": "ring"}}))
    (u, velocity, _), (u_many, velocity_many, drifts) = states
    errors = u_many - np.tile(u, copies), velocity_many - np.tile(velocity, copies)
    return HardCase(
        problem=f"N = {beads}, a ring of {copies} equal waves, α = β = 3/2, γ = 0.1, to t = 10",
        expected="every wave is as on a ring of its own",
        criterion=f"distance from the ring of {period} beads, and relative drift of momentum",
        quantity="largest u at the end",
        measured=float(u_many.max()),
        error=max(*(float(np.abs(error).max()) for error in errors), drifts["momentum_drift"]),
        limit=1.0e-12,
    )


def _initiation(alpha=1.5, gamma=0.1, beta=None, **changes):
    """An initiation with β = α unless it is given."""
    law = kuwabara_kono(alpha, gamma) | ({} if beta is None else {"beta": beta})
    return functools.partial(initiation, law, **changes)


CASES = {
    "gamma_zero": _initiation(gamma=0.0, expected="a train of solitary waves, energy conserved"),
    "gamma_1e_6": _initiation(gamma=1.0e-6),
    "gamma_1e_3": _initiation(gamma=1.0e-3),
    "gamma_5": _initiation(gamma=5.0),
    "gamma_50": _initiation(gamma=50.0, beads=20, end_time=10.0),
    "alpha_1_001": _initiation(1.001),
    "alpha_1_02": _initiation(1.02),
    "alpha_3": _initiation(3.0),
    "alpha_5": _initiation(5.0),
    "alpha_10": _initiation(10.0),
    "beta_1": _initiation(gamma=0.3, beta=1.0),
    "beta_alpha_plus_1": _initiation(gamma=0.3, beta=2.5),
    "delta_1e_8": functools.partial(_scaling, 1.0e-8),
    "delta_1e8": functools.partial(_scaling, 1.0e8),
    "precompression_1e_12": _precompression,
    "colliding_fronts": _colliding_fronts,
    "many_beads": _many_beads,
}
