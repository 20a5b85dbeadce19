"""What docs/limits.md says that is not found is not, and what it says is found is."""

import pytest
import sympy
from chains import driven_scene

import granular_fronts as gf
from granular_fronts.chain.simulate import solve

NOT_FOUND = [(6.0, 1.25, 0.005), (1.01, 1.5, 50.0)]


@pytest.mark.slow
@pytest.mark.parametrize(("alpha", "beta", "gamma"), NOT_FOUND)
def test_front_is_not_found_and_the_reason_is_said(alpha, beta, gamma):
    front = gf.solve_front(alpha=alpha, beta=beta, gamma=gamma)
    assert front.attrs["converged"] == 0
    assert front.attrs["reason"]


def test_strong_damping_is_found():
    assert gf.solve_front(alpha=1.5, gamma=100.0).attrs["converged"] == 1


@pytest.mark.slow
@pytest.mark.parametrize(("size", "found"), [(1e3, 1), (1e4, 0)])
def test_large_linear_terms_keep_newtons_iteration_from_settling(size, found):
    r = sympy.Symbol("r")
    elastic = gf.Potential.from_expression(sympy.cosh(r) - 1 + size * r, r, interval=(-4, 4))
    law = gf.make_law(elastic=elastic, viscous={"kind": "linear", "gamma": 0.5})
    front = gf.solve_front(law=law, states=(-1.0, -0.1))
    assert front.attrs["converged"] == found
    assert ("Newton's iteration does not settle" in front.attrs["reason"]) == (not found)


@pytest.mark.parametrize(("beta", "gamma"), [(1.0, 50.0), (1.5, 200.0)])
def test_strong_damping_costs_the_steps_that_stability_asks_for(beta, gamma):
    """About 4G′(δ)/6 in a unit of time."""
    scene = driven_scene(gamma, 420, 700.0, beta=beta)
    steps = solve(scene, {"relative": 1e-9, "absolute": 1e-11}).counts["steps_accepted"]
    slope = beta * gamma * 0.1 ** (beta - 1.0)
    assert steps == pytest.approx(700.0 * 4.0 * slope / 6.0, rel=0.25)
