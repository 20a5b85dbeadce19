"""The piston as a boundary: against a collision, other solvers and its balance laws."""

import numpy as np
import pytest
from chains import driven_scene, take_fixed_steps
from scipy.integrate import solve_ivp

import granular_fronts as gf
from granular_fronts.chain import equations, run
from granular_fronts.chain.equations import Boundary, Piston
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.chain.state import D, U

LAWS = [(1.5, 1.5, 0.3), (1.5, 1.5, 0.0), (1.2, 1.2, 0.3), (1.5, 1.0, 0.3), (1.5, 2.5, 5.0)]


def piston_scene(law, ramp=0.0, beads=30, end_time=30.0, right=0.0, velocity=0.05, **changes):
    boundary = {"kind": "piston", "velocity": velocity, "ramp": ramp, "right": right}
    scene = driven_scene(law[2], beads, end_time, law[0], law[1])
    return scene | {"boundary": boundary} | changes


def final(scene):
    state = solve(scene, scene["tolerance"]).dataset.isel(t=-1)
    return state["relative_displacement"].values, state["velocity"].values


@pytest.mark.parametrize("law", LAWS)
def test_piston_is_the_middle_bead_of_a_symmetric_collision(law):
    """N beads at rest ahead of a bead of velocity V, N beads of velocity 2V behind it."""
    beads, velocity = 30, 0.05
    start = {
        "kind": "given",
        "relative_displacement": [0.0] * (2 * beads),
        "velocity": [2.0 * velocity] * beads + [velocity] + [0.0] * beads,
    }
    collision = driven_scene(law[2], 2 * beads + 1, 60.0, law[0], law[1], delta=0.0, start=start)
    pushed = piston_scene(law, beads=beads + 1, end_time=60.0)
    for both_halves, half in zip(final(collision), final(pushed), strict=True):
        np.testing.assert_allclose(both_halves[beads:], half, rtol=0, atol=4.0e-15)


def test_right_end_ahead_of_a_piston_is_free_by_default():
    given, free = piston_scene(LAWS[0]), piston_scene(LAWS[0])
    del free["boundary"]["right"]
    held = piston_scene(LAWS[0], right=0.1)
    for field, same, other in zip(final(given), final(free), final(held), strict=True):
        np.testing.assert_array_equal(field, same)
        assert np.abs(field - other).max() > 0.01


@pytest.mark.parametrize("right", [0.0, 0.1])
@pytest.mark.parametrize("ramp", [0.0, 7.0, 50.0])
@pytest.mark.parametrize("law", LAWS)
def test_balances_close(law, ramp, right):
    """The piston keeps its velocity, and does the work that the chain stores and dissipates."""
    record = {"snapshots": [], "balances": True}
    scene = piston_scene(law, ramp, end_time=60.0, right=right, record=record)
    drifts = solve(scene, scene["tolerance"]).drifts
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


def by_scipy(scene, rtol, atol):
    """Beads 2 … N in (x, w) with the path of the piston written out."""
    law, boundary = scene["law"], scene["boundary"]
    beads, speed, ramp = scene["beads"], boundary["velocity"], boundary["ramp"]
    right = max(boundary["right"], 0.0)

    def path(t):
        return 0.5 * speed * t * t / ramp if t < ramp else speed * (t - 0.5 * ramp)

    def compressions(t, x):
        return np.append(np.append(path(t), x[:-1]) - x, right)

    def slopes(t, y):
        x, w = np.split(y, 2)
        u = np.maximum(compressions(t, x), 0.0)
        elastic, viscous = u ** law["alpha"], law["gamma"] * u ** law["beta"]
        return np.concatenate([w - np.diff(viscous), -np.diff(elastic)])

    # At rest means ẋ = 0, so that w takes the held contact at the right end.
    state = np.zeros(2 * (beads - 1))
    state[-1] = -law["gamma"] * (0.0 - right ** law["beta"])
    for span in ((0.0, ramp), (ramp, scene["end_time"])):
        state = solve_ivp(slopes, span, state, "DOP853", rtol=rtol, atol=atol).y[:, -1]
    return compressions(scene["end_time"], state[: beads - 1])


@pytest.mark.parametrize("law", LAWS)
def test_scipy_agrees_within_its_own_error(law):
    scene = piston_scene(law, 5.0, right=0.05)
    fine, coarse = by_scipy(scene, 1.0e-12, 1.0e-14), by_scipy(scene, 1.0e-10, 1.0e-12)
    own_error = np.abs(fine - coarse).max()
    assert own_error < 1.0e-8
    assert np.abs(final(scene)[0] - fine).max() < own_error


def fixed_steps(scene, steps):
    """u and d after `steps` equal steps over the ramp and as many over the rest."""
    part, ramp = run.prepare(scene), scene["boundary"]["ramp"]
    for duration in (ramp, scene["end_time"] - ramp):
        take_fixed_steps(part.chain, part.table, duration / steps, steps)
        run._end_ramp(part)
    return np.concatenate([part.row(U), part.row(D)])


@pytest.mark.parametrize("law", [(1.5, 1.5, 0.1), (1.2, 1.2, 0.3), (1.5, 1.0, 0.2)])
def test_order_is_eight_with_the_end_of_the_ramp_inside(law):
    beads = 16
    bent = 1.0 + 0.3 * np.cos(np.pi * np.arange(beads - 1) / (beads - 1))
    start = {"kind": "given", "relative_displacement": list(bent), "velocity": [0.0] * beads}
    scene = piston_scene(law, 4.0, beads, 8.0, right=0.7, velocity=0.6, start=start)
    exact = fixed_steps(scene, 200)
    counts = [10, 11, 12, 14]
    errors = [np.abs(fixed_steps(scene, count) - exact).max() for count in counts]
    assert errors[-1] > 1.0e-12, "the errors must stand above round-off"
    slope = np.polyfit(np.log(1.0 / np.array(counts)), np.log(errors), 1)[0]
    assert 7.5 < slope < 9.0


def test_a_compressed_chain_that_moves_with_its_piston_goes_on():
    start = {"kind": "given", "relative_displacement": [0.2] * 9, "velocity": [0.05] * 10}
    u, velocity = final(piston_scene(LAWS[0], beads=10, right=0.2, start=start))
    np.testing.assert_allclose(u, 0.2, rtol=0, atol=2.0e-16)
    np.testing.assert_allclose(velocity, 0.05, rtol=0, atol=2.0e-16)


@pytest.mark.parametrize("t", [0.0, 1.0, 4.0])
def test_conversion_to_strain_form_and_back(t):
    random = np.random.default_rng(1)
    u, velocity = random.normal(size=(2, 30))
    boundary = Boundary(False, right=0.2, piston=Piston(0.5, 3.0))
    u[-1] = boundary.right
    law = gf.make_law(alpha=1.5, gamma=0.4)
    d = equations.strain_rates(velocity, u, boundary, law)
    # What the ramp adds to ẋ_1 at t = 0, and after its end no more.
    velocity[0] += 0.4 * (boundary.piston.acceleration_at(t) - 0.5 / 3.0)
    back = equations.velocities(d, u, boundary, law, t=t)
    np.testing.assert_allclose(back, velocity, rtol=0, atol=2.0e-14)


def test_a_piston_rises_linearly_over_its_ramp():
    rising, sudden = Piston(2.0, 4.0), Piston(2.0, 0.0)
    assert [rising.velocity_at(t) for t in (0.0, 1.0, 4.0, 9.0)] == [0.0, 0.5, 2.0, 2.0]
    assert rising.acceleration_at([1.0, 4.0, 9.0]).tolist() == [0.5, 0.5, 0.0]
    assert (sudden.velocity_at(0.0), sudden.acceleration_at(0.0)) == (2.0, 0.0)
