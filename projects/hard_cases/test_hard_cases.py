"""Each hard case is solved within its limit, and a loose solver is not."""

import pytest

import edge_cases

# Those that take seconds; each push solves the others.
SLOW = ("γ = 20", "α = 10", "000 beads", "losses", "bouncing")
CASES = [
    pytest.param(name, marks=[pytest.mark.nightly] if name.endswith(SLOW) else [])
    for name in edge_cases.CASES
]


@pytest.mark.parametrize("name", CASES)
def test_error_is_within_its_limit(name):
    case = edge_cases.CASES[name]()
    assert case.error <= case.limit


@pytest.mark.parametrize("name", ["a front starts, δ = 10⁸", "elastic collision"])
def test_a_loose_solver_fails(name, monkeypatch):
    monkeypatch.setattr(edge_cases, "RELATIVE", 1.0e-6)
    monkeypatch.setattr(edge_cases, "ABSOLUTE", 1.0e-8)
    case = edge_cases.CASES[name]()
    assert case.error > case.limit
