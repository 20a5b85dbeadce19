"""Fronts of both laws proved from nothing: those of the paper's figures, and others."""

from fractions import Fraction

import pytest

import granular_fronts as gf
from granular_fronts.proofs import certificate
from granular_fronts.proofs.checker import check_certificate

FIGURES = {
    "figure 1": (Fraction(6, 100), {"cells": 48, "fine": 100, "drift": 3e-4}, "overshoot", 1.3696),
    "figure 3": (Fraction(65, 100), {}, "monotone", 0),
}


@pytest.mark.parametrize(
    "figure",
    [
        # Twenty seconds; each push makes and proves the other figure's certificate.
        pytest.param("figure 1", marks=pytest.mark.nightly),
        pytest.param("figure 3", marks=pytest.mark.slow),
    ],
)
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


# Four proofs from nothing, of which each push makes that of a figure.
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


COARSE, LATE = (
    {"proved": False, "reason": reason, "numbers": {}} for reason in ("Z1 < 1: no", "theta: no")
)
PROVED = {"proved": True, "reason": "", "numbers": {}}
BARE = ["weights"]  # where the expansion behind is left out


@pytest.mark.parametrize(
    ("given", "answers", "tried"),
    [
        ({}, [PROVED], [certificate.USUAL]),
        ({}, [COARSE, PROVED], [certificate.USUAL, certificate.FINER[0]]),
        ({}, [COARSE] * 4, [certificate.USUAL, *certificate.FINER, BARE]),
        ({}, [LATE, PROVED], [certificate.USUAL, BARE]),
        ({"fine": 60}, [COARSE, COARSE], [(20, 60, 6e-4), BARE]),
    ],
)
def test_finer_cells_and_then_no_expansion_are_tried(monkeypatch, tmp_path, given, answers, tried):
    """The last answer counts, and only cells that are too wide are made finer."""
    written, left = [], list(answers)

    def describe(_front, _alpha, _gamma, *mesh):
        return dict.fromkeys(certificate.EXPANSION) | {"weights": [1.4, 2.7], "mesh": mesh}

    monkeypatch.setattr(certificate, "describe", describe)
    monkeypatch.setattr(certificate.stored, "write", lambda _, fields: written.append(fields))
    monkeypatch.setattr(certificate, "check_certificate", lambda _: left.pop(0))
    assert gf.prove_front("3/2", "3/10", tmp_path / "front.npz", **given) == answers[-1]
    assert not left
    for fields, way in zip(written, tried, strict=True):
        bare = way == BARE
        assert ("roots" in fields) != bare
        assert len(fields["weights"]) == 2 - bare
        assert bare or fields["mesh"] == tuple(way)
