"""Fronts proved from nothing: those of the paper's figures, and others of all shapes."""

from fractions import Fraction

import pytest

import granular_fronts as gf
from granular_fronts.proofs import certificate
from granular_fronts.proofs.arrays import load
from granular_fronts.proofs.checker import check_certificate

FIGURES = {
    "figure 1": (Fraction(6, 100), {"cells": 48, "fine": 100, "drift": 3e-4}, "overshoot", 1.3696),
    "figure 3": (Fraction(65, 100), {}, "monotone", 0),
}


@pytest.mark.slow
@pytest.mark.parametrize("figure", FIGURES)
def test_fronts_of_the_paper(figure, tmp_path):
    """γ (1/10)^(−1/4), enclosed by fractions: the fourth powers prove it; docs/proofs.md."""
    gamma, options, number, least = FIGURES[figure]
    start = int(float(gamma) * 10**-0.25 * 10**13)
    low, high = Fraction(start - 1, 10**13), Fraction(start + 2, 10**13)
    assert low**4 * 10 < gamma**4 < high**4 * 10
    record = gf.prove_front("3/2", (low, high), tmp_path / "front.npz", **options)
    assert record["proved"], record["reason"]
    assert record["numbers"][number] > least


CASES = {
    ("3/2", "3333/10000"): "monotone",
    ("3/2", "3655/10000"): "monotone",
    ("3/2", "1/5"): "overshoots",
    ("3/2", "1/10"): "overshoots",
    (2, "1/2"): "monotone",
    ("6/5", "1/5"): "ln α",
    ("3/2", "6/5"): "A exp(λ ξ)",
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_other_fronts(case, tmp_path):
    options = {"cells": 40, "fine": 100, "drift": 1e-4} if Fraction(case[1]) > 1 else {}
    record = gf.prove_front(*case, tmp_path / "front.npz", **options)
    assert record["proved"], record["reason"]
    assert CASES[case] in " ".join(record["statements"])
    assert check_certificate(tmp_path / "front.npz") == record


@pytest.mark.slow
def test_a_front_may_be_proved_without_the_expansion_behind(monkeypatch, tmp_path):
    checks = []

    def first_fails(path):
        checks.append(check_certificate(path))
        return checks[-1] | {"proved": len(checks) > 1}

    monkeypatch.setattr(certificate, "check_certificate", first_fails)
    assert gf.prove_front("3/2", "3/10", tmp_path / "front.npz")["proved"]
    first, second = (check["statements"] for check in checks)
    assert first[:3] == second[:3]
    assert "monotone" in first[-1]
    assert "O(exp(" in second[-1]
    assert "roots" not in load(tmp_path / "front.npz")
