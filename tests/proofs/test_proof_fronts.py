"""Fronts of both laws proved from nothing: those of the paper's figures, and others."""

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


@pytest.mark.slow  # Makes and proves a certificate.
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


# A number above a bound: strong damping, α near 1, and weak or steep dashpots.
CASES = {
    ("3/2", "6/5", None): ({"cells": 40, "fine": 100, "drift": 1e-4}, "rate_low", 0),
    ("6/5", "1/5", None): ({}, "radius", 0),
    ("3/2", "1/10", 1): ({"cells": 40, "fine": 60, "drift": 3e-4}, "overshoot", 1.2439),
    (3, "1/2", 1): ({"cells": 30, "fine": 60, "drift": 3e-4}, "overshoot", 1.0446),
}


# Four proofs from nothing, of which each push makes those of the figures.
@pytest.mark.nightly
@pytest.mark.parametrize("case", CASES)
def test_other_fronts(case, tmp_path):
    alpha, gamma, beta = case
    options, number, least = CASES[case]
    record = gf.prove_front(alpha, gamma, tmp_path / "front.npz", beta=beta, **options)
    assert record["proved"], record["reason"]
    assert record["error"] < (1e-8 if beta else 1e-5)
    assert record["numbers"][number] > least
    assert check_certificate(tmp_path / "front.npz") == record


@pytest.mark.slow  # Makes and proves a certificate.
def test_a_front_may_be_proved_without_the_expansion_behind(monkeypatch, tmp_path):
    checks = []

    def first_fails(path):
        checks.append(check_certificate(path))
        return checks[-1] | {"proved": len(checks) > 1}

    monkeypatch.setattr(certificate, "check_certificate", first_fails)
    assert gf.prove_front("3/2", "3/10", tmp_path / "front.npz")["proved"]
    shown, remaining = (check["numbers"].keys() for check in checks)
    assert {"monotone", "rate_low", "amplitude_low"} <= shown - remaining
    assert "roots" not in load(tmp_path / "front.npz")
