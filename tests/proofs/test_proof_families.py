"""Proofs for all γ of an interval, and the junctions that make one family of them."""

from copy import copy
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace

import flint
import numpy as np
import pytest
from certificates import middles

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.proofs import balls, certificate, intervals, stored
from granular_fronts.proofs.balls import in_balls
from granular_fronts.proofs.certificate import prove_front, rational
from granular_fronts.proofs.families import join, prove, prove_family, record
from granular_fronts.proofs.intervals import _require_conclusion, _require_place

ENDS = ("0.3", "0.302", "0.304")


@pytest.fixture(scope="module")
def family(tmp_path_factory):
    """Two intervals of γ that meet at 0.302, of fronts with α = 2, which overshoot."""
    folder, fronts = tmp_path_factory.mktemp("family"), []

    def kept(path, last):
        fronts.append(prove(path, last))
        return fronts[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(intervals, "prove", kept)
        records = list(intervals.prove_interval(2, ENDS[0], ENDS[2], folder, fine=12))
    names = [f"{folder}/{low}.npz" for low in ("0.300000", "0.302000")]
    assert [record["path"] for record in records] == names
    return folder, fronts


@pytest.fixture(scope="module")
def known(family):
    """Both fronts, as they were proved and joined."""
    return family[1]


def test_two_intervals_are_one_family(known):
    low, middle, high = map(Fraction, ENDS)
    records = [record("", front) for front in known]
    assert [one["gamma"] for one in records] == [(low, middle), (middle, high)]
    falls, shift, first_falls, last = records[1]["inequalities"][-4:]
    assert (falls["name"], shift["name"]) == ("P falls over (−1, 1)", "shift below a cell")
    assert first_falls["name"] == "the first P falls over (−1, 1)"
    assert last["name"] == "the front before is a translate"
    assert last["left"] == pytest.approx(0.8666, rel=1e-3)
    # Z₁, and little by changes of the inverse and of the shift.
    assert last["left"] - float(known[0].Z1.mid()) == pytest.approx(4.88e-8, rel=0.05)
    assert max(one["error"] for one in records) < 1e-6


def test_front_varies_with_gamma_within_the_enclosure(known):
    """Fronts computed at other γ than those that P̄ was made from, and ranges of P̄ and ū over γ."""
    front, rounding = known[0], flint.arb(0, 1e-20)
    xi = middles(front)
    for s in (-1.0, -0.37, 0.5, 1.0):
        with in_balls():
            P, u = front.at(flint.arb(s))
        computed = solve_front(2, 0.301 + 0.001 * s)
        strain = [float(one[0].mid()) for one in u]
        assert abs(evaluate_front(computed, xi) - strain).max() < front.error
        for wide, narrow in ((front.u, u), (front.P, P)):
            for all_gammas, one in zip(wide, narrow, strict=True):
                assert (all_gammas[0] + rounding).contains(one[0])


def test_residual_of_an_interval_contains_those_of_its_points(known):
    """|P̄ − ū₊^α| at points in ξ and γ stays below its bound, and reaches a good part of it."""
    front, shares = known[0], []
    with in_balls():
        fronts = [front.at(flint.arb(s)) for s in np.linspace(-1, 1, 9)]
        for j in range(40, len(front.u), 23):
            bound, found = float(front.residual(j).upper()), 0.0
            for P, u in fronts:
                for t in map(flint.arb, np.linspace(-1, 1, 7)):
                    value = P[j](t) - balls.power(u[j](t), front.alpha)
                    found = max(found, abs(float(value.mid())))
            assert found <= bound
            shares.append(found / bound)
    assert max(shares) > 0.5


def lifted(front):
    """Errors of a hundredth leave room for two fronts."""
    front.strain = [[u[0] + flint.arb("0.02"), *u[1:]] for u in front.strain]


def shifted(front):
    """It is the same front, but the lemma allows shifts below a cell only."""
    for name in ("profile", "strain"):
        pieces = getattr(front, name)
        setattr(front, name, [*pieces[1:], pieces[-1]])


def of_another_law(front):
    front.data = front.data | {"alpha": np.array([3, 1, 3, 1])}


def test_other_fronts_and_intervals_that_do_not_meet_are_not_joined(known):
    first, second = map(copy, known)
    lies = (lifted, "translate"), (shifted, "shift below a cell"), (of_another_law, "do not meet")
    with in_balls():
        join(first, second)
        for pair in ((second, first), (first, first)):
            with pytest.raises(balls.NotProvedError, match="do not meet"):
                join(*pair)
        for change, broken in lies:
            first, second = map(copy, known)
            second.inequalities = []
            change(second)
            with pytest.raises(balls.NotProvedError, match=broken):
                join(first, second)


def a_bead_shorter(front):
    """The same front in a window that ends a bead before on either side."""
    for name in ("profile", "strain", "rho", "kappa"):
        setattr(front, name, getattr(front, name)[front.n : -front.n])
    front.left, front.M = front.left - 1, front.M - 1


def test_fronts_of_other_windows_are_joined(known):
    """Outside its cells a front is 1 behind and 0 ahead, nearly as the other is there."""
    totals = []
    for shorten in (lambda front: None, a_bead_shorter):
        first, second = map(copy, known)
        second.inequalities = []
        shorten(second)
        with in_balls():
            join(first, second)
        totals.append(second.inequalities[-1]["left"])
    assert totals[1] == pytest.approx(totals[0], rel=1e-7)


@pytest.mark.parametrize("place", [0, -1])
@pytest.mark.parametrize("name", ["outer_kappa", "kappa"])
def test_junction_counts_the_whole_line(known, name, place):
    """Where the first front is hardly enclosed in its last cell, or beyond, on either side."""
    first, second = map(copy, known)
    second.inequalities = []
    bounds = list(getattr(first, name))
    bounds[place] = 1 / first.r
    setattr(first, name, bounds)
    a_bead_shorter(second)
    with in_balls(), pytest.raises(balls.NotProvedError, match="translate"):
        join(first, second)


@pytest.mark.slow  # Makes and proves certificates.
def test_what_is_not_proved_is_made_anew_and_the_rest_is_kept(family, tmp_path):
    """A certificate of another interval, and none, in the place of the second."""
    first, second = sorted(family[0].glob("*.npz"))
    for file, place in ((first, first.name), (first, second.name)):
        (tmp_path / place).write_bytes(file.read_bytes())
    records = list(intervals.prove_interval(2, ENDS[0], ENDS[2], tmp_path))
    assert records[0]["gamma"][1] == records[1]["gamma"][0] == Fraction(ENDS[1])
    assert records[-1]["gamma"][1] == Fraction(ENDS[2])
    assert (tmp_path / first.name).read_bytes() == first.read_bytes()
    assert (tmp_path / second.name).read_bytes() != first.read_bytes()


@pytest.mark.slow  # Makes and proves two certificates.
def test_boxes_of_alpha_and_gamma_are_one_family(tmp_path):
    """About the Hertz chain: α = 3/2 ± 1/5000, two intervals of γ."""
    alpha, ends = ("7499/5000", "7501/5000"), ("0.3", "0.301", "0.302")
    paths = [tmp_path / "first.npz", tmp_path / "second.npz"]
    for path, gamma in zip(paths, pairwise(ends), strict=True):
        record = prove_front(alpha, gamma, path)
        assert record["proved"], record["reason"]
        assert record["alpha"] == tuple(map(Fraction, alpha))
        front = prove(path)
        with in_balls():
            strain = [float(u[0].mid()) for u in front.at(flint.arb(0))[1]]
        for exponent in (1.4998, 1.5002):
            computed = solve_front(exponent, sum(map(float, gamma)) / 2)
            assert abs(evaluate_front(computed, middles(front)) - strain).max() < record["error"]
    _, second = prove_family(paths)
    assert second["inequalities"][-1]["name"] == "the front before is a translate"
    assert second["inequalities"][-1]["left"] == pytest.approx(0.67, abs=0.01)  # docs/proofs.md


def test_impossible_numbers_and_fronts_that_are_not_found_are_refused(tmp_path, monkeypatch):
    with pytest.raises(InputError, match="six decimals"):
        next(intervals.prove_interval("3/2", "0.30000001", "0.31", tmp_path))
    for arguments, words in (
        (("3/2", ("0.31", "0.3")), "exchange its ends"),
        *(((alpha, "0.3"), "^alpha is .* above 1") for alpha in ("three", "1", f"{10**18}/3")),
    ):
        with pytest.raises(InputError, match=words):
            prove_front(*arguments, tmp_path / "file.npz")
    with pytest.raises(InputError, match="beta is 2"):
        prove_front("3/2", "0.3", tmp_path / "file.npz", beta=2)
    assert rational(0.1) == Fraction(1, 10)
    with pytest.raises(InputError, match="more than 18 digits"):
        stored.integers(2**63)
    failed = SimpleNamespace(attrs={"converged": 0, "reason": "the residual is 1"})
    monkeypatch.setattr(certificate, "solve_front", lambda *_: failed)
    with pytest.raises(InputError, match="no front to prove: the residual is 1"):
        prove_front("3/2", "0.3", tmp_path / "file.npz")


def test_wide_interval_that_concludes_nothing_is_made_narrower():
    """With data of the tail and without a statement on overshoot; narrow ones are kept."""
    wide, narrow = np.array([3, 10, 301, 1000]), np.array([3, 10, 3004, 10000])
    silent = {"roots": (), "gamma": wide}
    with pytest.raises(balls.NotProvedError, match="too wide"):
        _require_conclusion(SimpleNamespace(data=silent, numbers={"rate_low": 1.5}))
    for data, numbers in (
        ({"gamma": wide}, {}),
        (silent | {"gamma": narrow}, {}),
        *((silent, {name: 1.0}) for name in ("overshoot", "oscillates", "critical", "monotone")),
    ):
        _require_conclusion(SimpleNamespace(data=data, numbers=numbers))


def test_certificate_in_the_folder_counts_for_its_own_interval_and_law_only():
    kept = SimpleNamespace(
        data={"alpha": np.array([3, 2] * 2), "gamma": np.array([3, 10, 31, 100])}
    )
    alpha, at, high = (Fraction(3, 2),) * 2, Fraction(3, 10), Fraction(32, 100)
    _require_place(kept, alpha, at, high)
    for place in (
        ((Fraction(2),) * 2, at, high),
        (alpha, Fraction(29, 100), high),
        (alpha, at, Fraction(305, 1000)),
    ):
        with pytest.raises(balls.NotProvedError, match="another interval"):
            _require_place(kept, *place)
