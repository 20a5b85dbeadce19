"""Order and tolerance of the integrated chain, and the same motion in other variables."""

import numpy as np
import pytest
from chains import after_steps, driven_scene, last_state, ring_scene, smooth_ring
from rings import slope_and_residual

import granular_fronts as gf
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.run import make_chain
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.state import ROWS_OF_PAIR, ROWS_OF_SINGLE
from granular_fronts.reference_methods import position_forms

RING = Boundary(ring=True)


def power_law(alpha, beta, gamma):
    return gf.make_law(alpha=alpha, beta=beta, gamma=gamma)


def fixed_steps(form, law, end_time, steps):
    """u and velocity of a ring after fixed steps, in any of the three sets of variables."""
    u, velocity = smooth_ring()
    if form == "strain":
        alpha, beta, gamma = law
        scene = ring_scene(u, velocity, gamma, alpha, beta, end_time)
        return after_steps(scene, end_time * np.arange(2, steps + 1, 2) / steps)
    system, y = position_forms.pack(form, power_law(*law), RING, u, velocity)
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
    exact = fixed_steps("strain", law, 8.0, 400)
    counts = [20, 22, 24, 26, 30, 200]
    *errors, last = (np.abs(fixed_steps(form, law, 8.0, count) - exact).max() for count in counts)
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


def test_contacts_of_a_ring_that_stay_closed_may_have_an_alpha_below_1():
    found = last_state(ring_scene(*smooth_ring(), alpha=0.7, beta=1.0))
    fixed = fixed_steps(position_forms.XW, (0.7, 1.0, 0.1), 10.0, 600)
    np.testing.assert_allclose(found, fixed, rtol=0, atol=2e-13)


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
