"""The piston as a boundary: against a collision, the paper's front, other solvers and balances."""

import numpy as np
import pytest
from chains import by_scipy, driven_scene, given, last_state
from rings import slope_and_residual

from granular_fronts.chain import run
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.chain.state import D, U

LAWS = [(1.5, 1.5, 0.3), (1.5, 1.5, 0.0), (1.2, 1.2, 0.3), (1.5, 1.0, 0.3), (1.5, 2.5, 5.0)]


def piston_scene(law, ramp=0.0, beads=30, end_time=30.0, right=0.0, velocity=0.05, **changes):
    boundary = {"kind": "piston", "velocity": velocity, "ramp": ramp, "right": right}
    scene = driven_scene(law[2], beads, end_time, law[0], law[1])
    return scene | {"boundary": boundary} | changes


@pytest.mark.parametrize("law", LAWS)
def test_piston_is_the_middle_bead_of_a_symmetric_collision(law):
    """N beads at rest ahead of a bead of velocity V, N beads of velocity 2V behind it."""
    beads, velocity = 30, 0.05
    speeds = [2.0 * velocity] * beads + [velocity] + [0.0] * beads
    start = given([0.0] * (2 * beads), speeds)
    collision = driven_scene(law[2], 2 * beads + 1, 60.0, law[0], law[1], delta=0.0, start=start)
    both_halves = last_state(collision).reshape(2, -1)[:, beads:]
    half = last_state(piston_scene(law, beads=beads + 1, end_time=60.0)).reshape(2, -1)
    np.testing.assert_allclose(both_halves, half, rtol=0, atol=4.0e-15)


def test_right_end_ahead_of_a_piston_is_free_by_default():
    scenes = [piston_scene(LAWS[0], right=right) for right in (0.0, 0.0, 0.1)]
    del scenes[1]["boundary"]["right"]
    zero, absent, held = map(last_state, scenes)
    np.testing.assert_array_equal(zero, absent)
    assert np.abs(zero - held).max() > 0.01


@pytest.mark.parametrize("right", [0.0, 0.1])
@pytest.mark.parametrize("ramp", [0.0, 7.0, 50.0])
@pytest.mark.parametrize("law", LAWS)
def test_balances_close(law, ramp, right):
    """The piston keeps its velocity, and does the work that the chain stores and dissipates."""
    record = {"snapshots": [], "balances": True}
    scene = piston_scene(law, ramp, end_time=60.0, right=right, record=record)
    drifts = solve(scene).drifts
    assert drifts["momentum_drift"] < 5.0e-14
    assert drifts["energy_drift"] < 2.0e-13


@pytest.mark.parametrize("law", LAWS)
def test_velocity_of_the_piston_is_prescribed(law):
    times = np.array([0.0, 1.0, 3.3, 7.0, 7.5, 20.0])
    record = {"snapshots": list(times), "grid": {"step": 3.5}}
    motion = simulate_chain(piston_scene(law, 7.0, record=record))
    for suffix in ("", "_grid"):
        velocity = motion[f"velocity{suffix}"].sel(bead=1)
        prescribed = 0.05 * np.minimum(motion[f"t{suffix}"] / 7.0, 1.0)
        np.testing.assert_allclose(velocity, prescribed, rtol=0, atol=2.0e-16)


@pytest.mark.parametrize("law", LAWS)
def test_scipy_agrees_within_its_own_error(law):
    scene = piston_scene(law, 5.0, right=0.05)
    fine, coarse = by_scipy(scene), by_scipy(scene, 1.0e-10, 1.0e-12)
    own_error = np.abs(fine - coarse).max()
    assert own_error < 1.0e-8
    assert np.abs(last_state(scene) - fine).max() < own_error


def test_piston_drives_a_front_of_equations_22_and_23():
    """A piston of velocity V is followed by beads of v_p = V; its start leaves waves of n^(−2)."""
    delta, speed = 0.05**0.8, 0.05**0.2
    record = {"snapshots": [300.0 / speed], "arrival_level": 0.5 * delta}
    scene = piston_scene(LAWS[0], beads=330, end_time=300.0 / speed, record=record)
    motion = simulate_chain(scene)
    behind = motion.isel(t=0).sel(bead=75)
    assert float(behind["velocity"]) == pytest.approx(0.05, rel=5e-6)
    assert float(behind["relative_displacement"]) == pytest.approx(delta, rel=5e-6)
    assert float(motion["front_speed"]) == pytest.approx(speed, rel=5e-6)


def fixed_steps(scene, steps):
    """u and d after `steps` equal steps over the ramp and as many over the rest of the time."""
    part = run.prepare(scene)
    ends = scene["end_time"] * np.arange(1, steps + 1) / steps
    run.integrate_in_halves(part, scene["tolerance"], ends)
    return np.concatenate([part.row(U), part.row(D)])


@pytest.mark.parametrize("law", [(1.5, 1.5, 0.1), (1.2, 1.2, 0.3), (1.5, 1.0, 0.2)])
def test_order_is_eight_with_the_end_of_the_ramp_inside(law):
    beads = 16
    bent = 1.0 + 0.3 * np.cos(np.pi * np.arange(beads - 1) / (beads - 1))
    scene = piston_scene(law, 4.0, beads, 8.0, 0.7, 0.6, start=given(bent, [0.0] * beads))
    exact = fixed_steps(scene, 200)
    counts = [10, 12, 14, 16]
    errors = [np.abs(fixed_steps(scene, count) - exact).max() for count in counts]
    assert errors[-1] > 1.0e-12, "the errors must stand above round-off"
    assert 7.5 < slope_and_residual(counts, errors)[0] < 9.0


def test_a_compressed_chain_that_moves_with_its_piston_goes_on():
    start = given([0.2] * 9, [0.05] * 10)
    found = last_state(piston_scene(LAWS[0], beads=10, right=0.2, start=start))
    np.testing.assert_allclose(found, [0.2] * 10 + [0.05] * 10, rtol=0, atol=2.0e-16)
