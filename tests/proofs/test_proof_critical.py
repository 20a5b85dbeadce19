"""Critical damping proved: fronts that oscillate behind, monotone ones, and the crossing."""

from copy import copy
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from certificates import enclosed, load
from flint import acb, arb

import granular_fronts as gf
from granular_fronts.proofs import rear_expansion
from granular_fronts.proofs.arrays import written
from granular_fronts.proofs.balls import NotProvedError, in_balls
from granular_fronts.proofs.checker import Front
from granular_fronts.proofs.tail_roots import Law

BELOW, ABOVE = "0.263245873786073432", "0.26324587378607344"  # γ_x is between


def between(low, high):
    """The front around critical damping as it is enclosed, on another interval of γ."""
    ends = [part for end in map(Fraction, (low, high)) for part in end.as_integer_ratio()]
    with in_balls():
        front = Front(load("critical") | {"gamma": np.array(ends)})
        front = enclosed("critical", **vars(front))
        list(front.rear())
    return front


@pytest.mark.parametrize(
    ("low", "high", "shape"),
    [
        (ABOVE, ABOVE, "monotone"),
        (BELOW, ABOVE, "critical"),
        ("0.2632458738", "0.2632458739", None),
    ],
)
def test_fronts_above_critical_damping_around_it_and_beside_it_are_told_apart(low, high, shape):
    """Also where both γ are one double; beside γ_x the order of the roots is not certain."""
    front = between(low, high)
    assert float(BELOW) == float(ABOVE)
    assert {"oscillates", "monotone", "critical"} & front.numbers.keys() == {shape} - {None}
    for end in {low, high}:
        assert written(Fraction(end)) in front.parameters()


@pytest.fixture(scope="module")
def below():
    """The front that oscillates."""
    front = between(BELOW, BELOW)
    assert "oscillates" in front.numbers
    return front


@pytest.mark.parametrize("kept", [[1, 0], [0], [1], [1, 1]])
def test_root_that_leads_is_not_left_out(below, kept):
    """Below critical damping no list of roots makes the front monotone; their order is free."""
    front = copy(below)
    front.data = below.data | {"roots": below.data["roots"][kept]}
    front.numbers = {}
    with in_balls():
        if kept == [1, 0]:
            list(front.rear())
            assert front.numbers == below.numbers
        else:
            with pytest.raises(NotProvedError):
                list(front.rear())


def test_computed_tail_has_the_amplitude_that_is_proved(below):
    """|c| in u − 1 = Re c e^(λ₂ξ) + a e^(λ₁ξ) + …, from three points of the computed front."""
    gamma = float(BELOW)
    front, (pair, real) = gf.solve_front(1.5, gamma), gf.tail_roots(1.5, gamma, count=2)
    if not pair.imag:
        pair, real = real, pair
    xi = np.array([-11.0, -10.5, -10.0])
    waves = np.exp(pair * xi)
    modes = np.column_stack([waves.real, -waves.imag, np.exp(real.real * xi)])
    *c, a = np.linalg.solve(modes, gf.evaluate_front(front, xi) - 1)
    numbers = below.numbers
    assert 0 < numbers["amplitude_low"] < np.hypot(*c) < numbers["amplitude_high"] < 0.2
    assert a < 0


class Part(Law):
    """What leads in a part of the interval of γ, and what is said of parts, need no more of one."""

    def __init__(self):
        super().__init__(arb(1.5), arb(0.263))
        self.fall, self.shift, self.numbers = -5, arb(0), {}


REAL, TINY, NAN = (acb(1.9), acb(-1e-5)), arb(0, 1e-9), arb("nan")
EITHER = acb(arb(1.9, 1e-3), arb(3))  # may decay more or less fast than the real root


def lead(real, pair):
    modes = {name: mode for name, mode in (("real", real), ("pair", pair)) if mode}
    return rear_expansion.lead(Part(), modes, (arb(1e-6), arb(3.1)), -4)


@pytest.mark.parametrize(
    ("pair", "expected"),
    [
        (None, "real"),
        ((acb(2.0, 3.0), acb(1e-7)), "real"),
        ((acb(1.8, 3.0), acb(1e-7)), "pair"),
        ((EITHER, acb(1e-7)), "either"),
    ],
)
def test_leading_root(pair, expected):
    kind, *_, monotone = lead(REAL, pair)
    assert kind == expected
    assert monotone == (kind != "pair")


@pytest.mark.parametrize(
    ("real", "pair"),
    [
        *(((acb(1.9), acb(C1)), None) for C1 in (arb(1e-5), arb(0, 1e-5), NAN)),
        *((None, (acb(1.8, 3.0), acb(C2, C2))) for C2 in (TINY, NAN)),
        *((REAL, (EITHER, C2)) for C2 in (acb(1e-4), acb(TINY, TINY))),
        (REAL, (acb(NAN, NAN), acb(1e-7))),
    ],
)
def test_nothing_leads_from_amplitudes_that_are_not_certain(real, pair):
    with pytest.raises((NotProvedError, ValueError)):
        lead(real, pair)


def said(*found):
    """The numbers of parts, and the number of statements."""
    part = Part()
    return part.numbers, len(list(rear_expansion._statements(part, found)))


@pytest.mark.parametrize("exchanged", [True, False])
def test_parts_in_another_order_say_nothing(monkeypatch, exchanged):
    """Monotone fronts below those that oscillate are no critical damping."""
    monkeypatch.setattr(rear_expansion, "_exchanged", lambda front: exchanged)
    pair, real = ("pair", acb(1.9), arb(1), False), ("real", acb(1.9), arb(1), True)
    assert said(real, pair) == said(pair, (*real[:3], False)) == ({}, 0)
    assert said(pair, real) == ({"critical": 1.0} if exchanged else {}, 1)


def test_bounds_and_statements_hold_on_all_parts():
    low, high = ("real", acb(1.9), arb(1), True), ("real", acb(2.0), arb(3), True)
    bounds = {"rate_low": 1.9, "rate_high": 2.0, "amplitude_low": 1.0, "amplitude_high": 3.0}
    for parts in ((low, high), (high, low)):
        assert said(*parts) == (pytest.approx(bounds | {"monotone": 1.0}, rel=1e-9), 2)
        assert said(*parts, (*low[:3], False)) == (pytest.approx(bounds, rel=1e-9), 1)


def test_parts_cover_the_interval_of_damping():
    front = SimpleNamespace(middle=arb(0.3), half=arb(0.1), at=lambda s: (s, s), inequalities=[1])
    for k, ends in enumerate(pairwise(np.linspace(0.2, 0.4, 4))):
        part = rear_expansion._part(front, k, 3)
        for gamma in (part.gamma, front.middle + part.P * front.half):
            assert [float(gamma.lower()), float(gamma.upper())] == pytest.approx(ends, rel=1e-8)
        assert float(part.middle) == pytest.approx(sum(ends) / 2, rel=1e-8)
        assert part.inequalities == []


def test_what_is_far_from_1_behind_is_not_expanded():
    """In one cell, below or above 1, or behind all cells."""
    front = enclosed("monotone")
    with in_balls():
        low, high = front.u_low.copy(), front.u_high.copy()
        low[20] -= 1
        high[20] += 1
        for change in ({"u_low": low}, {"u_high": high}, {"outer_kappa": [1 / front.r, arb(0)]}):
            with pytest.raises(NotProvedError, match=r"u − 1. behind x0"):
                list(enclosed("monotone", **change).rear())
