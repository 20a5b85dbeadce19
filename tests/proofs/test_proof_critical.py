"""Critical damping proved: fronts that oscillate behind, monotone intervals, and the crossing."""

from fractions import Fraction

import numpy as np
import pytest
from certificates import DATA
from flint import acb, arb

import granular_fronts as gf
from granular_fronts.proofs import rear_expansion, tail_roots
from granular_fronts.proofs.__main__ import main
from granular_fronts.proofs.arrays import load
from granular_fronts.proofs.balls import NotProvedError, in_balls
from granular_fronts.proofs.checker import check_certificate
from granular_fronts.proofs.tail_roots import Law

BELOW, AROUND, ABOVE = ("0.2525", "0.253"), ("0.2632", "0.2633"), ("0.2640", "0.2645")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("critical")


@pytest.fixture(scope="module")
def records(folder):
    """Certificates below, around and above critical damping of the Hertz front."""
    return {
        interval: gf.prove_front("3/2", interval, folder / f"{interval[0]}.npz")
        for interval in (BELOW, AROUND, ABOVE)
    }


@pytest.mark.slow
def test_fronts_below_oscillate_and_those_above_are_monotone(records):
    """γ_x is in the interval around it, so that fronts are monotone from it on."""
    below, around, above = (" ".join(record["statements"]) for record in records.values())
    assert all(record["proved"] for record in records.values())
    assert "changes its sign infinitely often, and the front overshoots" in below
    assert "For each γ at which Re λ₂ ≥ λ₁, u*' < 0 on the whole line" in around
    assert "u*' < 0 on the whole line: the front is monotone" in above
    kinds = [
        set(record["numbers"]) & {"monotone", "critical", "oscillates"}
        for record in records.values()
    ]
    assert kinds == [{"oscillates"}, {"critical"}, {"monotone"}]
    gamma = gf.critical_damping(1.5)
    real, pair = sorted(gf.tail_roots(1.5, gamma, count=2), key=lambda root: root.imag)
    with in_balls():
        law, *_ = tail_roots.crossing(arb(1.5), gamma, (complex(real), complex(pair)), 1e-9)
        low, high = records[AROUND]["gamma"]
        assert arb(float(low)) < law.gamma < arb(float(high))
    assert records[BELOW]["gamma"][1] < low < high < records[ABOVE]["gamma"][0]


@pytest.mark.parametrize(
    ("low", "high", "inside"),
    [pytest.param(37, 38, True, marks=pytest.mark.slow), (38, 39, False)],
)
def test_an_interval_beside_the_crossing_is_not_critical(low, high, inside, tmp_path):
    """γ_x = 0.26324587378607…: what is stated holds on both, but only one contains it."""
    gamma = np.array([2632458700 + low, 10**10, 2632458700 + high, 10**10])
    np.savez(tmp_path / "front.npz", **(load(DATA / "critical.npz") | {"gamma": gamma}))
    record = check_certificate(tmp_path / "front.npz")
    assert record["proved"]
    assert ("critical" in record["numbers"]) == inside


@pytest.mark.slow
def test_fronts_on_both_sides_of_critical_damping_are_told_apart(folder, capsys):
    """γ_x lies between two γ that are the same double; each file speaks of its own alone."""
    below, above = "0.263245873786073432", "0.26324587378607344"
    files = [str(folder / f"{name}.npz") for name in ("below", "above")]
    records = [
        gf.prove_front("3/2", gamma, file)
        for gamma, file in zip((below, above), files, strict=True)
    ]
    assert float(below) == float(above)
    assert [record["gamma"] for record in records] == [(Fraction(g),) * 2 for g in (below, above)]
    assert main(files) == 0
    first, second = capsys.readouterr().out.split(files[1])
    assert f"For α = 1.5 and γ = {below} there is" in first
    assert "changes its sign infinitely often" in first
    assert f"For α = 1.5 and γ = {above} there is" in second
    assert "the front is monotone" in second


@pytest.mark.slow
def test_quadratic_law_has_a_critical_damping_too(tmp_path):
    record = gf.prove_front(2, ("0.3978", "0.398"), tmp_path / "front.npz")
    assert record["numbers"]["critical"]
    assert record["gamma"][0] < gf.critical_damping(2) < record["gamma"][1]


@pytest.mark.slow
def test_computed_tail_has_the_amplitude_that_is_proved(records):
    """|c| in u − 1 = Re c e^(λ₂ξ) + a e^(λ₁ξ) + …, from three points of the computed front."""
    gamma = 0.25275
    low, high = (records[BELOW]["numbers"][f"amplitude_{end}"] for end in ("low", "high"))
    front, (pair, real) = gf.solve_front(1.5, gamma), gf.tail_roots(1.5, gamma, count=2)
    xi = np.array([-11.0, -10.5, -10.0])
    waves = np.exp(pair * xi)
    modes = np.column_stack([waves.real, -waves.imag, np.exp(real.real * xi)])
    *c, a = np.linalg.solve(modes, gf.evaluate_front(front, xi) - 1)
    assert 0 < low < np.hypot(*c) < high < 0.2
    assert a < 0


@pytest.mark.slow
def test_root_that_leads_is_not_left_out(records, folder, tmp_path):
    """Below critical damping no list of roots makes the front monotone."""
    assert records[BELOW]["proved"]
    data = load(folder / f"{BELOW[0]}.npz")
    roots = data["roots"]
    assert roots[0, 1] == 0 < roots[1, 1]
    for kept, proved in (
        ([0, 1], True),
        ([1, 0], True),
        ([0], False),
        ([1], False),
        ([1, 1], False),
    ):
        np.savez(tmp_path / "front.npz", **(data | {"roots": roots[kept]}))
        record = check_certificate(tmp_path / "front.npz")
        assert record["proved"] == proved, record["reason"]
        text = " ".join(record["statements"])
        assert "monotone" not in text
        assert "A exp" not in text
        assert ("oscillates" in record.get("numbers", {})) == proved


class Part(Law):
    """What `lead` needs of a front."""

    fall = -5
    shift = arb(0)


RATE = acb(1.9)


@pytest.mark.parametrize(
    ("pair", "expected"),
    [
        (None, "real"),
        ((acb(2.0, 3.0), acb(1e-7)), "real"),
        ((acb(1.8, 3.0), acb(1e-7)), "pair"),
        ((acb(arb(1.9, 1e-3), arb(3.0)), acb(1e-7)), "either"),
    ],
)
def test_leading_root(pair, expected):
    modes = {"real": (RATE, acb(-1e-5))} | ({"pair": pair} if pair else {})
    kind, *_, monotone = rear_expansion.lead(
        Part(arb(1.5), arb(0.263)), modes, (arb(1e-6), arb(3.1)), -4
    )
    assert kind == expected
    assert monotone == (kind != "pair")


NAN = arb("nan")


@pytest.mark.parametrize(
    ("real", "pair"),
    [
        ((RATE, acb(1e-5)), None),
        ((RATE, acb(arb(0, 1e-5))), None),
        ((RATE, acb(NAN)), None),
        (None, (acb(1.8, 3.0), acb(arb(0, 1e-9), arb(0, 1e-9)))),
        (None, (acb(1.8, 3.0), acb(NAN))),
        ((RATE, acb(-1e-5)), (acb(NAN, NAN), acb(1e-7))),
        ((RATE, acb(-1e-5)), (acb(arb(1.9, 1e-3), arb(3)), acb(1e-4))),
        ((RATE, acb(-1e-5)), (acb(arb(1.9, 1e-3), arb(3)), acb(arb(0, 1e-9), arb(0, 1e-9)))),
    ],
)
def test_nothing_leads_from_amplitudes_that_are_not_certain(real, pair):
    modes = {name: mode for name, mode in (("real", real), ("pair", pair)) if mode}
    with pytest.raises((NotProvedError, ValueError)):
        rear_expansion.lead(Part(arb(1.5), arb(0.263)), modes, (arb(1e-6), arb(3.1)), -4)


@pytest.mark.parametrize("exchanged", [True, False])
def test_parts_in_another_order_say_nothing(monkeypatch, exchanged):
    """Monotone fronts below those that oscillate are no critical damping."""
    monkeypatch.setattr(rear_expansion, "_exchanged", lambda front: exchanged)
    pair, real = ("pair", RATE, arb(1), False), ("real", RATE, arb(1), True)
    law = Part(arb(1.5), arb(0.263))
    law.numbers = {}
    assert list(rear_expansion._statements(law, [real, pair])) == []
    assert list(rear_expansion._statements(law, [pair, (*real[:3], False)])) == []
    assert law.numbers == {}
    assert len(list(rear_expansion._statements(law, [pair, real]))) == 1
    assert law.numbers == ({"critical": 1.0} if exchanged else {})
