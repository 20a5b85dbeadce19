"""Each hard case is solved within its limit, and a loose solver is not."""

import pytest

import edge_cases

# Those that take seconds; each push solves the others.
SLOW = ("γ = 20", "α = 10", "000 beads", "losses", "bouncing")


# Whole problems, up to a minute each; each push solves chains to a third of the time.
@pytest.mark.nightly
@pytest.mark.parametrize("name", edge_cases.CASES)
def test_error_is_within_its_limit(name):
    case = edge_cases.CASES[name]()
    assert case.error <= case.limit


@pytest.mark.parametrize("name", [name for name in edge_cases.CASES if not name.endswith(SLOW)])
def test_error_is_within_its_limit_at_first(name, monkeypatch):
    monkeypatch.setattr(edge_cases, "BEADS", 16)
    monkeypatch.setattr(edge_cases, "END_TIME", 10.0)
    test_error_is_within_its_limit(name)


@pytest.mark.parametrize("name", ["a front starts, δ = 10⁸", "elastic collision"])
def test_a_loose_solver_fails(name, monkeypatch):
    monkeypatch.setattr(edge_cases, "RELATIVE", 1.0e-9)
    monkeypatch.setattr(edge_cases, "ABSOLUTE", 1.0e-11)
    with pytest.raises(AssertionError):
        test_error_is_within_its_limit_at_first(name, monkeypatch)
