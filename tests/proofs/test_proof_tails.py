"""Tail roots, α* and critical damping in balls: counts, enclosures, and what is refused."""

import math
import re
from fractions import Fraction

import pytest
from flint import acb, arb, fmpq

import granular_fronts as gf
from granular_fronts.fronts.linear.critical_damping import meaning_changes_at
from granular_fronts.proofs import tail_roots
from granular_fronts.proofs.balls import NotProvedError, in_balls
from granular_fronts.proofs.tail_roots import Law
from projects import ROOT

HERTZ = Fraction(3, 2)
CRITICAL = [Fraction(alpha) for alpha in ("17/16", "9/8", "5/4", "3/2", "2", "3", "5")]
DAMPINGS = [Fraction(gamma) for gamma in ("1/10", "1/5", "3/10", "1/3", "1")]
PRECISION = 180  # bits, fifty digits
BEND = 2.3469413041671690


@pytest.fixture(scope="module", autouse=True)
def digits():
    """Fifty digits, and those of others again afterwards."""
    with in_balls(PRECISION):
        yield


def ball(fraction):
    return arb(fmpq(fraction.numerator, fraction.denominator))


@pytest.fixture(scope="module")
def bend():
    return tail_roots.find_bend(BEND, 1e-6)


def enclosures(bend):
    """By name and law: α*, γ_c for each α and the slowest roots, in balls and as computed."""
    yield ("α*", ""), tail_roots.touching(bend), meaning_changes_at()
    for alpha in CRITICAL:
        gamma = gf.critical_damping(float(alpha))
        roots = gf.tail_roots(float(alpha), gamma, count=3)
        if alpha < meaning_changes_at():
            law, _ = tail_roots.double_root(ball(alpha), roots[0].real, 1e-4)
            yield ("γ_c, double root", str(alpha)), law.gamma, gamma
        else:
            law = tail_roots.critical_damping(alpha)
            yield ("γ_c, crossing", str(alpha)), law.gamma, gamma
    for gamma in DAMPINGS:
        law, starts = Law(ball(HERTZ), ball(gamma)), gf.tail_roots(1.5, float(gamma), count=5)
        for j, start in enumerate(starts[:4]):
            yield (f"λ{j}", str(gamma)), tail_roots.find_root(law, *parts(start), 1e-9), start
        between = arb((starts[3].real + starts[4].real) / 2)
        count = sum(2 if start.imag else 1 for start in starts[:4])
        tail_roots.require_zeros(law, "no other root", between, count)


def parts(root):
    return float(root.real), float(root.imag)


@pytest.fixture(scope="module")
def found(bend):
    """Enclosures and computed values by name and law."""
    return {name: (enclosure, value) for name, enclosure, value in enclosures(bend)}


def test_computed_values_are_good_to_a_few_units_of_the_last_digit(found):
    """γ in a root costs |dλ/dγ| of its own; the enclosures have thirty digits."""
    assert {name for name, _ in found} >= {"α*", "γ_c, double root", "γ_c, crossing", "λ0", "λ3"}
    for name, (enclosure, value) in found.items():
        assert max(float(part.rad()) for part in (acb(enclosure).real, acb(enclosure).imag)) < 1e-28
        error = abs(acb(enclosure) - acb(value.real, value.imag)).upper()
        assert error < 16 * math.ulp(abs(value)), name


def test_page_prints_the_enclosed_numbers(found):
    text = (ROOT / "docs/proofs.md").read_text(encoding="utf-8")
    printed = dict(re.findall(r"^\| (\d+(?:/\d+)?) \| (\d\.\d{25,}) \|$", text, re.MULTILINE))
    crossings = {alpha: ball for (name, alpha), (ball, _) in found.items() if "crossing" in name}
    assert printed.keys() == crossings.keys()
    for alpha, digits in printed.items():
        assert abs(crossings[alpha] - arb(digits)) < arb("1e-28")
    for name in (("α*", ""), ("γ_c, double root", "9/8")):
        assert found[name][0].str(30).strip("[").split(" ")[0][:27] in text


def hertz_crossing():
    gamma = gf.critical_damping(1.5)
    real, pair = sorted(gf.tail_roots(1.5, gamma, count=2), key=lambda root: root.imag)
    return gamma, complex(real), complex(pair)


def test_crossing_exchanges_the_slowest_root():
    gamma, real, pair = hertz_crossing()
    law, *roots = tail_roots.crossing(ball(HERTZ), gamma, (real, pair), 1e-9)
    assert float(law.gamma.rad()) < 1e-40
    for side, slowest in ((-1e-9, 1), (1e-9, 0)):
        beside = Law(law.alpha, law.gamma.mid() + side)
        found = [tail_roots.find_root(beside, x.real, x.imag, 1e-6) for x in (real, pair)]
        assert found[slowest].real < found[1 - slowest].real
    assert abs(roots[0].real - roots[1].real) < arb("1e-40")


def test_crossing_elsewhere_or_of_the_wrong_roots_is_refused():
    gamma, real, pair = hertz_crossing()
    third = complex(gf.tail_roots(1.5, gamma, count=3)[2])
    for start, roots in (
        *((gamma + shift, (real, pair)) for shift in (1e-6, -1e-6)),
        *((gamma, roots) for roots in ((real, real), (real, third), (pair, real))),
    ):
        with pytest.raises(NotProvedError):
            tail_roots.crossing(ball(HERTZ), start, roots, 1e-9)


def test_double_root_is_double():
    alpha = ball(Fraction(9, 8))
    gamma = gf.critical_damping(1.125)
    start = gf.tail_roots(1.125, gamma, count=1)[0].real
    law, root = tail_roots.double_root(alpha, start, 1e-4)
    assert tail_roots.symbol(law, acb(root)).contains(0)
    assert tail_roots.slope(law, acb(root)).contains(0)
    assert abs(law.gamma - gamma) < arb("1e-15")
    for side, imaginary in ((-1e-4, True), (1e-4, False)):
        slowest = gf.tail_roots(1.125, gamma + side, count=1)[0]
        assert bool(slowest.imag) == imaginary


@pytest.mark.parametrize(
    ("alpha", "start", "radius"), [(1.3, 2.34, 1e-2), (1.18771, 2.34, 1e-2), (1.125, 3.1, 0.2)]
)
def test_no_double_root_beyond_the_last_alpha_or_beyond_the_bend(alpha, start, radius):
    """Beyond the bend the line touches the bell too, with two slower roots before it."""
    with pytest.raises(NotProvedError):
        tail_roots.double_root(arb(alpha), start, radius)


def test_bend_and_the_last_alpha(monkeypatch, bend):
    last = tail_roots.touching(bend)
    assert abs(last - meaning_changes_at()) < arb("1e-15")
    law = Law(last, -tail_roots.bell(bend, 1)[1] / last)
    tail_roots.require_zeros(law, "three", arb("2.45"), 3)
    tail_roots.require_zeros(law, "none", arb("2.24"), 0)
    monkeypatch.setattr(tail_roots, "BEND_PARTS", 512)  # The bell is even.
    assert tail_roots.find_bend(BEND, 1e-6).overlaps(bend)  # So the start is what is refused.
    for start, radius in ((2.4, 1e-6), (2.3, 1e-3), (float("nan"), 1e-6), (-BEND, 1e-6)):
        with pytest.raises((NotProvedError, ValueError)):
            tail_roots.find_bend(start, radius)


@pytest.mark.parametrize("place", ["2.0001", "2.3", "3.49999"])
def test_bell_may_bend_nowhere_else(monkeypatch, place):
    """Where both q'' and its slope may be 0, from 2 to 7/2, nothing is concluded."""
    bell = tail_roots.bell

    def flat(x, order):
        values = bell(x, order)
        return [*values[:2], arb(0), arb(0)] if x.contains(arb(place)) else values

    monkeypatch.setattr(tail_roots, "bell", flat)
    with pytest.raises(NotProvedError, match="may bend more than once"):
        tail_roots.find_bend(BEND, 1e-6)


FAR = 12, 0.087, 0.3456, 2


@pytest.mark.parametrize(
    ("alpha", "gamma", "w", "zeros"),
    [FAR, *((1.5, 0.3, *line) for line in ((1.0, 0), (1.6, 1), (2.5, 3)))],
)
def test_zeros_are_counted(alpha, gamma, w, zeros):
    """Of FAR a pair with Im λ > 4: a line that ended there would not turn around 0."""
    slow = [root for root in gf.tail_roots(alpha, gamma, count=3) if root.real < w]
    assert sum(2 if root.imag else 1 for root in slow) == zeros
    assert [root.imag > 4 for root in slow[:1]] == [alpha == FAR[0]] * bool(zeros)
    law = Law(arb(alpha), arb(gamma))
    tail_roots.require_zeros(law, "zeros", arb(w), zeros)
    for count in {*range(5)} - {zeros}:
        with pytest.raises(NotProvedError):
            tail_roots.require_zeros(law, "zeros", arb(w), count)


@pytest.mark.parametrize("gamma", [0.05, 0.3])
def test_speed_of_roots_is_their_derivative(gamma):
    step = 1e-6
    roots = gf.tail_roots(1.5, gamma, count=2)
    behind, ahead = (gf.tail_roots(1.5, gamma + s, count=2) for s in (-step, step))
    for j, root in enumerate(roots):
        found = complex(tail_roots.speed(Law(arb(1.5), arb(gamma)), acb(root.real, root.imag)))
        assert found == pytest.approx((ahead[j] - behind[j]) / (2 * step), rel=1e-7)


ON_A_ROOT = "1.4726594827649096"


@pytest.mark.parametrize(
    ("w", "words"),
    [
        (ON_A_ROOT, "may be a root"),
        ("19.9", "too many parts"),
        *((far, "too far behind") for far in ("20.001", "1e300", "inf", "nan")),
    ],
)
def test_lines_through_a_root_and_without_end_count_nothing(monkeypatch, w, words):
    """A certificate may name any θ, and its check must end."""
    assert tail_roots.MOST_PARTS <= 50_000  # Some seconds.
    monkeypatch.setattr(tail_roots, "MOST_PARTS", 500)
    with pytest.raises(NotProvedError, match=words):
        tail_roots.require_zeros(Law(ball(HERTZ), ball(Fraction(3, 10))), "theta", arb(w), 1)


def test_an_interval_of_damping_counts_with_all_its_dampings():
    """A line or a square that a root reaches for some γ, though not for the middle one."""
    slowest = [gf.tail_roots(1.5, gamma, count=1)[0].real for gamma in (0.29991, 0.3, 0.30009)]
    wide, narrow = (Law(ball(HERTZ), arb("0.3", radius)) for radius in (1e-4, 1e-9))
    root = tail_roots.find_root(wide, slowest[1], 0.0, 0.004)
    assert all(root.real.contains(arb(one)) for one in slowest)
    between = arb((slowest[1] + slowest[2]) / 2)
    tail_roots.require_zeros(narrow, "zeros", between, 0)
    with pytest.raises(NotProvedError, match="may be a root"):
        tail_roots.require_zeros(wide, "zeros", between, 0)
