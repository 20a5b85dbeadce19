"""The θ-method: its equations, its conservation law, its order, and the damping it stands for."""

import math

import numpy as np
import pytest

from granular_fronts.errors import SolveError
from granular_fronts.reference_methods import theta_method
from granular_fronts.reference_methods.theta_method import integrate_from_rest
from granular_fronts.studies.numerical_damping import (
    Case,
    compare_profiles,
    damped_chain,
    measure_order,
    theta_chain,
)

ALPHA, DELTA = 1.5, 0.1
CASE = Case(ALPHA, DELTA, 14, 12.0)


def laplacian(u):
    full = np.maximum(np.concatenate([[DELTA], u, [0.0]]), 0.0) ** ALPHA
    return full[:-2] - 2.0 * full[1:-1] + full[2:]


@pytest.mark.parametrize(("theta", "step"), [(0.5, 8.0), (0.7, 0.05), (1.0, 1.0)])
def test_each_step_solves_its_equations(theta, step):
    before = integrate_from_rest(ALPHA, 12, DELTA, 0.0, theta, step, 5)
    after = integrate_from_rest(ALPHA, 12, DELTA, 0.0, theta, step, 6)
    assert before.converged
    assert after.converged
    rates = (1.0 - theta) * before.d + theta * after.d
    forces = (1.0 - theta) * laplacian(before.u) + theta * laplacian(after.u)
    scale = max(1.0, step) ** 2
    np.testing.assert_allclose(after.u, before.u + step * rates, rtol=0, atol=3e-15 * scale)
    np.testing.assert_allclose(after.d, before.d + step * forces, rtol=0, atol=3e-16 * scale)


@pytest.mark.parametrize("theta", [0.5, 1.0])
def test_force_at_the_end_gives_all_momentum(theta):
    """While no bead at the free end moves, Σ v_n = Σ n d_n grows by δ^α h in each step."""
    steps, step = 40, 0.2
    motion = integrate_from_rest(ALPHA, 80, DELTA, 0.0, theta, step, steps)
    momentum = float(np.arange(1, 80) @ motion.d)
    assert abs(motion.d[-1]) < 1e-17
    # The first force is felt from t = 0 on, before the step as well as after it.
    assert momentum == pytest.approx(DELTA**ALPHA * step * steps, rel=1e-13)


def test_orders_are_two_towards_the_damped_chain_and_one_towards_the_conservative():
    """But for θ = 1/2, of which the conservative chain is the limit at order two."""
    exact, _ = damped_chain(CASE, 0.0)
    middle = [np.abs(theta_chain(CASE, 0.5, h)[0] - exact).max() for h in (0.006, 0.003)]
    assert math.log2(middle[0] / middle[1]) == pytest.approx(2.0, abs=0.06)
    found = measure_order(CASE, [0.6, 0.75, 1.0], [0.024, 0.012, 0.006, 0.003])
    for name in ("order", "order_two_stages"):
        np.testing.assert_allclose(found[name], 2.0, rtol=0, atol=0.05)
    far = found["conservative_distance"].values[:, -2:]
    np.testing.assert_allclose(np.log2(far[:, 0] / far[:, 1]), 1.0, rtol=0, atol=0.06)
    assert np.all(found["order"].error_estimate < 0.2)
    assert found["damping_distance"].error_estimate < 1e-9
    assert np.all(found["damping_distance"] < 0.1 * found["conservative_distance"])
    np.testing.assert_allclose(found["gamma"].sel(theta=0.75), 0.5 * found["step"], rtol=1e-15)


def test_implicit_euler_damps_figure_1():
    """θ = 1 with h = 0.06 on the conservative chain is nearly the paper's chain with γ = 0.06."""
    profiles = compare_profiles(Case(ALPHA, DELTA, 40, 60.0), 1.0, 0.06)
    method, damped, conservative = (
        profiles[f"relative_displacement_{name}"] for name in ("method", "damped", "conservative")
    )
    assert float(abs(method - damped).max()) < 0.01 * DELTA
    assert float(abs(method - conservative).max()) > 0.3 * DELTA


def test_failed_newton_is_said(monkeypatch):
    assert not integrate_from_rest(3.0, 12, 1.0e120, 0.0, 1.0, 0.1, 3).converged
    monkeypatch.setattr(theta_method, "advance", lambda *arguments: -7)
    assert integrate_from_rest(ALPHA, 12, DELTA, 0.0, 1.0, 0.1, 3).iterations == 7
    with pytest.raises(SolveError, match=r"Newton's method fails for theta 1.0 and step 0.1"):
        theta_chain(Case(ALPHA, DELTA, 12, 1.0), 1.0, 0.1)
