"""What docs/limits.md says that is not found is not, and what it says is found is."""

import pytest
import sympy
from chains import driven_scene
from projects import ROOT

import granular_fronts as gf
from granular_fronts.chain.simulate import solve

TEXT = " ".join((ROOT / "docs" / "limits.md").read_text(encoding="utf-8").split())
NOT_FOUND = {
    "γ = 0.005 with (α, β) = (4, 1.25), (6, 1.25), (6, 2.5);": [
        (4.0, 1.25, 0.005),
        (6.0, 1.25, 0.005),
        (6.0, 2.5, 0.005),
    ],
    "γ = 50 at α = 1.01 with β = 1.25 and 1.5;": [(1.01, 1.25, 50.0), (1.01, 1.5, 50.0)],
    "γ = 0.001 from α = 3/2 on;": [(1.5, 1.5, 0.001), (2.0, 2.0, 0.001)],
    "β = 1 with α ≥ 4 near γ = 0.01.": [(4.0, 1.0, 0.01), (6.0, 1.0, 0.01)],
}
"""α, β, γ of each part of the sentence."""


def test_sentence_is_made_of_these_parts():
    begin = "these fronts were not found: "
    assert begin + " ".join(NOT_FOUND) in TEXT


@pytest.mark.slow
@pytest.mark.parametrize("point", [point for part in NOT_FOUND.values() for point in part])
def test_front_is_not_found_and_the_reason_is_said(point):
    alpha, beta, gamma = point
    front = gf.solve_front(alpha=alpha, beta=beta, gamma=gamma)
    assert front.attrs["converged"] == 0
    assert front.attrs["reason"]


def test_strong_damping_is_found():
    assert "With α = β = 3/2 fronts are found up to γ = 100." in TEXT
    assert gf.solve_front(alpha=1.5, gamma=100.0).attrs["converged"] == 1


@pytest.mark.slow
def test_large_linear_terms_keep_newtons_iteration_from_settling():
    assert "a linear term in V that is 10⁴ times the rest keeps Newton's iteration" in TEXT
    r = sympy.Symbol("r")
    for size, found in ((1e3, 1), (1e4, 0)):
        elastic = gf.Potential.from_expression(sympy.cosh(r) - 1 + size * r, r, interval=(-4, 4))
        law = gf.make_law(elastic=elastic, viscous={"kind": "linear", "gamma": 0.5})
        front = gf.solve_front(law=law, states=(-1.0, -0.1))
        assert front.attrs["converged"] == found
        assert ("Newton's iteration does not settle" in front.attrs["reason"]) == (not found)


@pytest.mark.parametrize(("beta", "gamma"), [(1.0, 50.0), (1.5, 50.0), (1.5, 200.0)])
def test_strong_damping_costs_the_steps_that_stability_asks_for(beta, gamma):
    assert "about 4G′(δ)/6 in a unit of time" in TEXT
    scene = driven_scene(gamma, 420, 700.0, beta=beta)
    steps = solve(scene, {"relative": 1e-9, "absolute": 1e-11}).counts["steps_accepted"]
    slope = beta * gamma * 0.1 ** (beta - 1.0)
    assert steps == pytest.approx(700.0 * 4.0 * slope / 6.0, rel=0.25)
