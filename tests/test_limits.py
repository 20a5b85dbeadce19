"""What docs/limits.md says that is not found is not, and what it says is found is."""

import pytest
from projects import ROOT

import granular_fronts as gf

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
