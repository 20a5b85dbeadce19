"""Order, tolerance, exact solutions and second opinions for the integrated chain."""

import numpy as np
import pytest
from chains import driven_scene, integrate_strain_fixed, ring_scene, smooth_ring
from rings import slope_and_residual
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import granular_fronts as gf
from granular_fronts.chain import equations
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.run import make_boundary, make_chain
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.state import ROWS_OF_PAIR, ROWS_OF_SINGLE
from granular_fronts.reference_methods import position_forms

RING = Boundary(ring=True)
LAWS = [(1.5, 1.5, 0.1), (1.5, 1.5, 0.0), (1.2, 1.2, 0.3), (1.5, 1.0, 0.2), (1.5, 2.5, 0.2)]


def power_law(alpha, beta, gamma):
    return gf.make_law(alpha=alpha, beta=beta, gamma=gamma)


def fixed_steps(form, law, u, velocity, end_time, steps):
    """u and velocity at the end of fixed steps, in any of the three sets of variables."""
    if form == "strain":
        u_end, d_end = integrate_strain_fixed(law, u, velocity, end_time / steps, steps)
        momentum = velocity.sum()
        v_end = equations.velocities(d_end, u_end, RING, law, momentum)
        return np.concatenate([u_end, v_end])
    system, y = position_forms.pack(form, law, RING, u, velocity)
    y = position_forms.integrate_fixed(system, y, end_time / steps, steps)
    return np.concatenate(position_forms.unpack(system, y))


@pytest.mark.parametrize("form", ["strain", position_forms.XW, position_forms.XV])
@pytest.mark.parametrize("law", LAWS)
def test_order_is_eight_in_all_variables_while_contacts_stay_closed(form, law):
    u, velocity = smooth_ring()
    law = power_law(*law)
    exact = fixed_steps("strain", law, u, velocity, 8.0, 400)
    counts = [20, 22, 24, 27, 30]
    errors = [
        np.abs(fixed_steps(form, law, u, velocity, 8.0, count) - exact).max() for count in counts
    ]
    assert errors[-1] > 3.0e-13, "the errors must stand above round-off"
    slope, scatter = slope_and_residual(counts, errors)
    # Order 8 is approached from above: where γ > 0 terms of order 9 still count at these steps.
    assert 7.9 < slope < 8.5
    assert scatter < 0.013


@pytest.mark.parametrize("law", LAWS)
def test_three_sets_of_variables_describe_one_motion(law):
    u, velocity = smooth_ring()
    law = power_law(*law)
    results = [fixed_steps(form, law, u, velocity, 8.0, 200) for form in ("strain", 0, 1)]
    np.testing.assert_allclose(results[1], results[0], rtol=0, atol=2.0e-13)
    np.testing.assert_allclose(results[2], results[0], rtol=0, atol=2.0e-13)


def test_a_law_of_one_nonlinearity_stores_one_row_of_slopes():
    u, velocity = smooth_ring()
    for given, rows in (
        ((1.5, 1.5, 0.1), ROWS_OF_SINGLE),
        ((1.5, 1.0, 0.0), ROWS_OF_SINGLE),
        ((1.2, 1.2, 0.1), ROWS_OF_SINGLE),
        ((1.5, 1.0, 0.1), ROWS_OF_PAIR),
    ):
        chain, table = make_chain(power_law(*given), RING, u, velocity)
        assert table.shape[0] == rows
        assert chain.law.single == (rows == ROWS_OF_SINGLE)


def last_state(scene):
    dataset = solve(scene, scene["tolerance"]).dataset
    u = dataset["relative_displacement"].values[-1]
    return np.concatenate([u, dataset["velocity"].values[-1]])


def test_general_kernel_equals_special_kernels():
    """β and α a hair apart go through both nonlinearities, equal ones through one."""
    one = last_state(driven_scene(gamma=0.3))
    two = last_state(driven_scene(gamma=0.3, beta=1.5 + 1.0e-13))
    np.testing.assert_allclose(two, one, rtol=0, atol=1.0e-12)
    assert np.abs(two - one).max() > 0.0


@pytest.mark.parametrize("gamma", [0.06, 0.65])
def test_error_is_proportional_to_the_tolerance(gamma):
    exact = last_state(driven_scene(gamma))
    tolerances = 10.0 ** np.arange(-11.0, -3.0)
    ratios, work = [], []
    for tolerance in tolerances:
        scene = driven_scene(gamma) | {
            "tolerance": {"relative": tolerance, "absolute": 1.0e-2 * tolerance}
        }
        solution = solve(scene, scene["tolerance"])
        u = solution.dataset["relative_displacement"].values[-1]
        v = solution.dataset["velocity"].values[-1]
        ratios.append(np.abs(np.concatenate([u, v]) - exact).max() / tolerance)
        work.append(solution.counts["right_hand_sides"])
    assert max(ratios) < 1.0
    # Ten times the accuracy costs an order-eight method 10^(1/8) = 1.33 times the work.
    growth = np.exp(np.polyfit(np.arange(len(work)), np.log(work[::-1]), 1)[0])
    assert growth == pytest.approx(10.0**0.125, abs=0.1)


def test_linear_chain_equals_its_matrix_exponential():
    """α = β = 1 in compression is linear: ẍ = −K x − γ K ẋ + load."""
    beads, gamma, delta, end_time = 12, 0.2, 0.3, 7.0
    u0, v0 = 0.2 + 0.05 * np.sin(np.arange(beads - 1)), 0.02 * np.cos(np.arange(beads))
    scene = driven_scene(gamma, beads, end_time, alpha=1.0, delta=delta)
    scene["boundary"] = {"kind": "pressure", "left": delta, "right": delta}
    scene["start"] = {"kind": "given", "relative_displacement": list(u0), "velocity": list(v0)}
    difference = np.eye(beads - 1, beads) - np.eye(beads - 1, beads, k=1)
    stiffness = difference.T @ difference
    load = np.zeros(beads)
    load[0], load[-1] = delta, -delta
    system = np.zeros((2 * beads + 1, 2 * beads + 1))
    system[:beads, beads : 2 * beads] = np.eye(beads)
    system[beads : 2 * beads, :beads] = -stiffness
    system[beads : 2 * beads, beads : 2 * beads] = -gamma * stiffness
    system[beads : 2 * beads, -1] = load
    x0 = np.concatenate([np.flip(np.cumsum(np.flip(u0))), [0.0]])
    y = expm(system * end_time) @ np.concatenate([x0, v0, [1.0]])
    computed = last_state(scene)
    assert computed[: beads - 1].min() > 0.0, "the linear solution holds only in compression"
    np.testing.assert_allclose(computed[: beads - 1], difference @ y[:beads], rtol=0, atol=5.0e-13)
    np.testing.assert_allclose(computed[beads:], y[beads : 2 * beads], rtol=0, atol=5.0e-13)


def collision(gamma):
    """Two beads meet with a relative velocity of 1 and part again."""
    scene = driven_scene(gamma, beads=2, end_time=20.0, delta=0.0)
    start = {"kind": "given", "relative_displacement": [-1.0], "velocity": [1.0, 0.0]}
    return scene | {"start": start}


def test_elastic_beads_exchange_their_velocities():
    computed = last_state(collision(0.0))
    np.testing.assert_allclose(computed[2:], [0.0, 1.0], rtol=0, atol=2.0e-12)


def test_damped_collision_equals_the_equation_of_its_contact():
    """ü = −2 (u₊^{3/2} + γ d/dt u₊^{3/2}) solved by SciPy in (u, w) gives the final velocities."""
    gamma = 0.3

    def contact(_t, y):
        force = max(y[0], 0.0) ** 1.5
        return [y[1] - 2.0 * gamma * force, -2.0 * force]

    solved = solve_ivp(
        contact, (0.0, 20.0), [-1.0, 1.0], "DOP853", rtol=1e-13, atol=1e-15, max_step=1e-2
    )
    computed = last_state(collision(gamma))
    relative_velocity = solved.y[1, -1]
    assert solved.y[0, -1] < 0.0, "the beads have parted"
    assert computed[2] - computed[3] == pytest.approx(relative_velocity, abs=1.0e-11)
    assert computed[2] + computed[3] == pytest.approx(1.0, abs=1.0e-15)


def scipy_chain(scene, rtol=1.0e-12, atol=1.0e-14):
    """The scene by SciPy's DOP853 on a plain numpy right-hand side in (x, w)."""
    law, boundary = gf.make_law(scene["law"]), make_boundary(scene)
    beads = scene["beads"]
    u, velocity = np.zeros(beads), np.zeros(beads)
    system, y = position_forms.pack(position_forms.XW, law, boundary, u, velocity)

    def slopes(_t, y):
        x, w = np.split(y, 2)
        u = np.append(x[:-1] - x[1:], boundary.right)
        behind, ahead = equations.forces_on_both_sides(u, boundary, law.elastic)
        correction = equations.velocity_correction(u, boundary, law)
        return np.concatenate([w + correction, behind - ahead])

    solved = solve_ivp(slopes, (0.0, scene["end_time"]), y, "DOP853", rtol=rtol, atol=atol)
    return np.concatenate(position_forms.unpack(system, solved.y[:, -1]))


@pytest.mark.parametrize("gamma", [0.0, 0.06, 0.65])
def test_scipy_agrees_within_its_own_error(gamma):
    scene = driven_scene(gamma, end_time=50.0)
    fine, coarse = scipy_chain(scene), scipy_chain(scene, 1.0e-10, 1.0e-12)
    own_error = np.abs(fine - coarse).max()
    assert own_error < 1.0e-8
    assert np.abs(last_state(scene) - fine).max() < own_error


def test_ring_scene_follows_fixed_steps():
    u, velocity = smooth_ring()
    law = power_law(1.5, 1.5, 0.1)
    fixed = fixed_steps("strain", law, u, velocity, 10.0, 400)
    np.testing.assert_allclose(last_state(ring_scene(u, velocity)), fixed, rtol=0, atol=1.0e-13)


def test_precompressed_chain_below_linear_agrees_with_plain_form():
    """α < 1 is allowed while all contacts stay closed."""
    u, velocity = smooth_ring()
    law = power_law(0.7, 1.0, 0.1)
    fixed = fixed_steps(position_forms.XW, law, u, velocity, 10.0, 600)
    scene = ring_scene(u, velocity, alpha=0.7, beta=1.0)
    np.testing.assert_allclose(last_state(scene), fixed, rtol=0, atol=2.0e-13)


@pytest.mark.parametrize("relative", [1e-3, 1e-5, 1e-7, 1e-9])
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
