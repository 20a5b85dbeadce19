"""Order, tolerance, exact solutions and second opinions for the integrated chain."""

import numpy as np
import pytest
from chains import driven_scene, given, integrate_strain_fixed, last_state, ring_scene, smooth_ring
from rings import slope_and_residual
from scipy.linalg import expm

import granular_fronts as gf
from granular_fronts.chain import equations
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.run import make_chain
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.state import ROWS_OF_PAIR, ROWS_OF_SINGLE
from granular_fronts.reference_methods import position_forms

RING = Boundary(ring=True)


def power_law(alpha, beta, gamma):
    return gf.make_law(alpha=alpha, beta=beta, gamma=gamma)


def fixed_steps(form, law, u, velocity, end_time, steps):
    """u and velocity at the end of fixed steps, in any of the three sets of variables."""
    if form == "strain":
        u_end, d_end = integrate_strain_fixed(law, u, velocity, end_time / steps, steps)
        return np.concatenate([u_end, equations.velocities(d_end, u_end, RING, law, sum(velocity))])
    system, y = position_forms.pack(form, law, RING, u, velocity)
    y = position_forms.integrate_fixed(system, y, end_time / steps, steps)
    return np.concatenate(position_forms.unpack(system, y))


@pytest.mark.parametrize(
    ("form", "law"),
    [
        ("strain", (1.5, 1.5, 0.1)),
        ("strain", (1.5, 2.5, 0.2)),
        (position_forms.XW, (1.2, 1.2, 0.3)),
        (position_forms.XW, (1.5, 1.0, 0.2)),
        (position_forms.XV, (1.5, 2.5, 0.2)),
    ],
)
def test_all_variables_converge_to_one_motion_at_order_eight(form, law):
    u, velocity = smooth_ring()
    law = power_law(*law)
    exact = fixed_steps("strain", law, u, velocity, 8.0, 400)
    counts = [20, 22, 24, 27, 30, 200]
    *errors, last = (
        np.abs(fixed_steps(form, law, u, velocity, 8.0, count) - exact).max() for count in counts
    )
    assert last < 2.0e-13
    assert errors[-1] > 3.0e-13, "the errors must stand above round-off"
    slope, scatter = slope_and_residual(counts[:-1], errors)
    # Order 8 is approached from above: where γ > 0 terms of order 9 still count at these steps.
    assert 7.9 < slope < 8.5
    assert scatter < 0.013


def test_a_law_of_one_nonlinearity_stores_one_row_of_slopes():
    single, two = ((1.5, 1.5, 0.1), (1.5, 1.0, 0.0)), ((1.5, 1.0, 0.1),)
    for laws, rows in ((single, ROWS_OF_SINGLE), (two, ROWS_OF_PAIR)):
        for law in laws:
            _, table = make_chain(power_law(*law), RING, *smooth_ring())
            assert table.shape[0] == rows


@pytest.mark.parametrize("gamma", [0.06, 0.65])
def test_error_is_proportional_to_the_tolerance(gamma):
    exact = last_state(driven_scene(gamma))
    work = []
    for relative in 10.0 ** np.arange(-4.0, -12.0, -1.0):
        tolerance = {"relative": relative, "absolute": 1.0e-2 * relative}
        scene = driven_scene(gamma, tolerance=tolerance)
        assert np.abs(last_state(scene) - exact).max() < relative
        work.append(solve(scene, tolerance).counts["right_hand_sides"])
    # Ten times the accuracy costs an order-eight method 10^(1/8) = 1.33 times the work.
    growth = np.exp(np.polyfit(np.arange(len(work)), np.log(work), 1)[0])
    assert growth == pytest.approx(10.0**0.125, abs=0.1)


def test_linear_chain_equals_its_matrix_exponential():
    """α = β = 1 in compression is linear: ẍ = −K x − γ K ẋ + load."""
    beads, gamma, delta, end_time = 12, 0.2, 0.3, 7.0
    u0, v0 = 0.2 + 0.05 * np.sin(np.arange(beads - 1)), 0.02 * np.cos(np.arange(beads))
    scene = driven_scene(gamma, beads, end_time, 1.0, delta=delta, start=given(u0, v0))
    scene["boundary"]["right"] = delta
    difference = np.eye(beads - 1, beads) - np.eye(beads - 1, beads, k=1)
    stiffness, ends = difference.T @ difference, np.eye(beads)[:, [0]] - np.eye(beads)[:, [-1]]
    system = np.zeros((2 * beads + 1, 2 * beads + 1))
    system[:beads, beads:-1] = np.eye(beads)
    system[beads:-1] = np.hstack([-stiffness, -gamma * stiffness, delta * ends])
    x0 = np.append(np.flip(np.cumsum(np.flip(u0))), 0.0)
    y = expm(system * end_time) @ np.concatenate([x0, v0, [1.0]])
    u, velocity = np.split(last_state(scene), 2)
    assert u[:-1].min() > 0.0, "the linear solution holds only in compression"
    np.testing.assert_allclose(u[:-1], difference @ y[:beads], rtol=0, atol=5.0e-13)
    np.testing.assert_allclose(velocity, y[beads:-1], rtol=0, atol=5.0e-13)


@pytest.mark.parametrize("gamma", [0.0, 0.3])
def test_two_beads_part_with_their_coefficient_of_restitution(gamma):
    """They meet with a relative velocity of 1, as in the equation that `restitution` solves."""
    start = given([-1.0], [1.0, 0.0])
    computed = last_state(driven_scene(gamma, beads=2, end_time=20.0, delta=0.0, start=start))
    assert computed[2] - computed[3] == pytest.approx(-gf.restitution(gamma), abs=1.0e-11)
    assert computed[2] + computed[3] == pytest.approx(1.0, abs=1.0e-15)


@pytest.mark.parametrize(
    ("law", "form", "steps", "error"),
    [((1.5, 1.5, 0.1), "strain", 400, 1e-13), ((0.7, 1.0, 0.1), position_forms.XW, 600, 2e-13)],
)
def test_ring_scene_follows_fixed_steps(law, form, steps, error):
    """α < 1 is allowed while all contacts stay closed."""
    u, velocity = smooth_ring()
    fixed = fixed_steps(form, power_law(*law), u, velocity, 10.0, steps)
    found = last_state(ring_scene(u, velocity, alpha=law[0], beta=law[1]))
    np.testing.assert_allclose(found, fixed, rtol=0, atol=error)


@pytest.mark.parametrize("relative", [1e-3, 1e-7])
@pytest.mark.parametrize("end_time", [0.9, 3.0])
def test_stated_error_of_a_short_motion_is_not_that_of_two_equal_runs(end_time, relative):
    """At first the steps grow as fast as they may, at one tolerance as at another."""
    tolerance = {"relative": relative, "absolute": 1e-2 * relative}
    motion = gf.simulate_chain(driven_scene(0.3, 2, end_time, tolerance=tolerance))
    exact = gf.simulate_chain(driven_scene(0.3, 2, end_time))
    for name in ("velocity", "relative_displacement"):
        error = float(np.abs(motion[name] - exact[name]).max())
        assert error > 1e-15
        assert 0.4 * error <= motion[name].error_estimate <= 2.5 * error
