"""The reference that gives true errors of chains, and errors that chains must state."""

import numpy as np
import pytest

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.reference_methods.extended import PI, REAL, Motion


def scene(law, u, velocity, end):
    """A chain with free ends and a given start."""
    u, velocity = (np.asarray(values, dtype=float) for values in (u, velocity))
    start = {"kind": "given", "relative_displacement": u, "velocity": velocity}
    boundary = {"kind": "pressure", "left": 0.0, "right": 0.0}
    return {
        "law": law,
        "beads": len(velocity),
        "boundary": boundary,
        "start": start,
        "end_time": end,
        "tolerance": {"relative": 1e-9, "absolute": 1e-11},
        "record": {"snapshots": []},
    }


def test_reference_exchanges_the_velocities_of_elastic_beads():
    law = {"alpha": 1.5, "beta": 1.5, "gamma": 0.0}
    _, velocity = Motion(scene(law, [-1.0], [1.0, 0.0], 20.0)).states([20.0])
    assert np.abs(velocity - [0.0, 1.0]).max() < 1e-17


def test_reference_of_a_damped_linear_contact_is_the_closed_form():
    """Where it is closed, ü = −2 (u + γ u̇): it touches at t = 1 and opens half a period later."""
    gamma = REAL(0.3)
    law = {"alpha": 1.0, "beta": 1.0, "gamma": float(gamma)}
    gamma = REAL(law["gamma"])
    motion = Motion(scene(law, [-1.0], [1.0, 0.0], 8.0))
    frequency = np.sqrt(2 - gamma**2)
    touches, opens = motion.passages(0.0).time
    assert abs(touches - 1) < 1e-17
    assert abs(opens - 1 - PI / frequency) < 1e-17
    _, velocity = motion.states([8.0])
    assert abs(velocity[0] @ [1, -1] + np.exp(-gamma * PI / frequency)) < 1e-17
    top = motion.passages()
    later = np.arctan(frequency / gamma) / frequency
    highest = np.exp(-gamma * later) * np.sin(frequency * later) / frequency
    assert abs(top.u[0] - highest) < 1e-17
    assert abs(top.time[0] - 1 - later) < 1e-16


def test_reference_carries_the_soliton_of_toda():
    n, kappa, end = np.arange(1, 31), REAL(2), 1.5
    law = {"elastic": {"kind": "toda", "strength": 1.0, "rate": 1.0}, "viscous": {"kind": "none"}}

    def soliton(t):
        phase = 2 * (kappa * (np.append(0, n) - 13) - np.sinh(kappa) * t)
        share = 1 / (1 + np.exp(-phase))
        heights = np.log1p((np.sinh(kappa) / np.cosh(phase[1:] / 2)) ** 2)
        return heights[:-1], 2 * np.sinh(kappa) * np.diff(share)

    start = soliton(REAL(0))
    motion = Motion(scene(law, *start, end), start=start)
    for found, exact in zip(motion.states([end]), soliton(REAL(end)), strict=True):
        assert np.abs(found[0] - exact).max() < 1e-16


@pytest.mark.parametrize("relative", np.logspace(-8, -3, 6))
def test_a_gap_that_only_touches_is_never_certain(relative):
    """Two elastic beads, pressed from rest, come back to u = 0 and turn there."""
    pressed = {"kind": "pressure", "left": 0.47, "right": 0.0}
    rest = scene({"alpha": 1.925, "beta": 1.925, "gamma": 0.0}, [0.0], [0.0, 0.0], 6.8)
    rest |= {"boundary": pressed, "start": {"kind": "rest"}, "record": {"snapshots": [6.8]}}
    rest |= {"tolerance": {"relative": relative, "absolute": 1e-3 * relative}}
    rest["record"]["extremes"] = True
    gap = simulate_chain(rest)["first_gap_time"]
    assert np.isnan(gap) or gap.attrs["error_estimate"] == np.inf


@pytest.mark.parametrize("relative", np.logspace(-8, -3, 6))
def test_error_of_an_opening_is_stated(relative):
    """Two beads that met at t = 0 with a linear force exchange velocities and part at π/√2."""
    hertz = {"kind": "hertz", "alpha": 1.0, "stiffness": 1.0}
    law = {"elastic": hertz, "viscous": {"kind": "none"}}
    meet = scene(law, [0.0], [1.0, 0.0], 3.0) | {"record": {"snapshots": [3.0]}}
    meet["tolerance"] = {"relative": relative, "absolute": 1e-3 * relative}
    motion = simulate_chain(meet).isel(t=0)
    apart = {"relative_displacement": [np.pi / np.sqrt(2.0) - 3.0, 0.0], "velocity": [0.0, 1.0]}
    for name, exact in apart.items():
        assert np.abs(motion[name] - exact).max() <= 2.0 * motion[name].attrs["error_estimate"]
