"""The reference that gives true errors of chains, and errors that chains must state."""

import numpy as np
import pytest
from chains import driven_scene, given

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.reference_methods.extended import PI, REAL, Motion

LINEAR = {"alpha": 1.0, "beta": 1.0, "gamma": 0.3}
TODA = {"elastic": {"kind": "toda", "strength": 1.0, "rate": 1.0}, "viscous": {"kind": "none"}}
BY_RELATIVE_TOLERANCE = pytest.mark.parametrize("relative", np.logspace(-8, -3, 6))


def free(law, u, velocity, end, relative=1e-9):
    """A chain with free ends and a given start."""
    tolerance = {"relative": relative, "absolute": 1e-3 * relative}
    start = given(u, velocity)
    scene = driven_scene(0.0, len(velocity), end, delta=0.0, start=start, tolerance=tolerance)
    return scene | {"law": law}


def test_reference_exchanges_the_velocities_of_elastic_beads():
    law = {"alpha": 1.5, "beta": 1.5, "gamma": 0.0}
    _, velocity = Motion(free(law, [-1.0], [1.0, 0.0], 20.0)).states([20.0])
    assert np.abs(velocity - [0.0, 1.0]).max() < 1e-17


def test_reference_of_a_damped_linear_contact_is_the_closed_form():
    """Where it is closed, ü = −2 (u + γ u̇): it touches at t = 1 and opens half a period later."""
    gamma = REAL(LINEAR["gamma"])
    motion = Motion(free(LINEAR, [-1.0], [1.0, 0.0], 8.0))
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

    def soliton(t):
        phase = 2 * (kappa * (np.append(0, n) - 13) - np.sinh(kappa) * t)
        share = 1 / (1 + np.exp(-phase))
        heights = np.log1p((np.sinh(kappa) / np.cosh(phase[1:] / 2)) ** 2)
        return heights[:-1], 2 * np.sinh(kappa) * np.diff(share)

    start = soliton(REAL(0))
    motion = Motion(free(TODA, *start, end), start=start)
    for found, exact in zip(motion.states([end]), soliton(REAL(end)), strict=True):
        assert np.abs(found[0] - exact).max() < 1e-16


@BY_RELATIVE_TOLERANCE
def test_a_gap_that_only_touches_is_never_certain(relative):
    """Two elastic beads, pressed from rest, come back to u = 0 and turn there."""
    tolerance = {"relative": relative, "absolute": 1e-3 * relative}
    rest = driven_scene(0.0, 2, 6.8, 1.925, delta=0.47, tolerance=tolerance)
    gap = simulate_chain(rest | {"record": {"snapshots": [], "extremes": True}})["first_gap_time"]
    assert np.isnan(gap) or gap.attrs["error_estimate"] == np.inf


@BY_RELATIVE_TOLERANCE
def test_error_of_an_opening_is_stated(relative):
    """Two beads that met at t = 0 with a linear force exchange velocities and part at π/√2."""
    motion = simulate_chain(free(LINEAR | {"gamma": 0.0}, [0.0], [1.0, 0.0], 3.0, relative))
    apart = {"relative_displacement": [np.pi / np.sqrt(2.0) - 3.0, 0.0], "velocity": [0.0, 1.0]}
    for name, exact in apart.items():
        error = np.abs(motion[name].isel(t=0) - exact).max()
        assert error <= 2.0 * motion[name].attrs["error_estimate"]


def test_error_of_an_event_is_stated_where_two_runs_agree_on_it_by_chance():
    """Both runs miss the time of the maximum of u = sin(√2 t)/√2 by as much at this tolerance."""
    scene = free(LINEAR | {"gamma": 0.0}, [0.0], [1.0, 0.0], 20.0, 7.33e-5)
    motion = simulate_chain(scene | {"record": {"snapshots": [], "extremes": True}})
    time = motion["largest_relative_displacement_time"]
    assert abs(time - np.pi / np.sqrt(8.0)) <= 2.0 * time.attrs["error_estimate"] < 1e-5
