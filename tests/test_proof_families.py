"""Proofs for all γ of an interval, and the junctions that make one family of them."""

from fractions import Fraction

import numpy as np
import pytest

flint = pytest.importorskip("flint")

from granular_fronts.errors import InputError  # noqa: E402
from granular_fronts.proofs import balls  # noqa: E402
from granular_fronts.proofs.certificate import prove_front, rational  # noqa: E402
from granular_fronts.proofs.checker import Front, read  # noqa: E402
from granular_fronts.proofs.families import join, prove_family  # noqa: E402
from granular_fronts.proofs.intervals import prove_interval  # noqa: E402


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two intervals of γ that meet at 0.3004."""
    folder = tmp_path_factory.mktemp("family")
    paths = list(prove_interval("3/2", "0.3", "0.3008", folder, width="0.0004"))
    assert [path.name for path in paths] == ["0.300000.npz", "0.300400.npz"]
    return folder


def fronts(folder):
    """Both fronts."""
    flint.ctx.prec = 80
    found = [Front(read(path)) for path in sorted(folder.glob("*.npz"))]
    for front in found:
        list(front.exists())
    return found


def test_two_intervals_are_one_family(folder):
    records = list(prove_family(sorted(folder.glob("*.npz"))))
    ends = [[Fraction(*end) for end in record["gamma"]] for record in records]
    assert ends[0][0] == Fraction("0.3")
    assert ends[0][1] == ends[1][0]
    assert ends[1][1] == Fraction("0.3008")
    last = records[1]["inequalities"][-1]
    assert last["name"] == "the front before is a translate"
    assert last["left"] < 0.95


def test_what_is_there_is_kept(folder):
    before = {path: path.read_bytes() for path in folder.glob("*.npz")}
    assert list(prove_interval("3/2", "0.3", "0.3008", folder)) == []
    assert before == {path: path.read_bytes() for path in folder.glob("*.npz")}


def test_intervals_that_do_not_meet_are_not_joined(folder):
    first, second = fronts(folder)
    join(first, second)
    for pair in ((second, first), (first, first)):
        with pytest.raises(balls.NotProvedError, match="do not meet"):
            join(*pair)


def test_another_front_is_not_joined(folder):
    """Errors of a hundredth leave room for two fronts."""
    first, second = fronts(folder)
    second.u[:] = [u + flint.arb("0.02") for u in second.u]
    with pytest.raises(balls.NotProvedError):
        join(first, second)


def test_a_front_shifted_by_a_cell_is_not_joined(folder):
    """It is the same front, but the lemma allows shifts below a cell only."""
    first, second = fronts(folder)
    for name in ("P", "u"):
        pieces = getattr(second, name)
        setattr(second, name, [*pieces[1:], pieces[-1]])
    with pytest.raises(balls.NotProvedError, match=r"shift below a cell|translate"):
        join(first, second)


def test_interval_that_is_too_wide_is_not_proved(tmp_path):
    record = prove_front("3/2", ("0.3", "0.31"), tmp_path / "wide.npz")
    assert not record["proved"]
    assert "Y0" in record["reason"] or "Z1" in record["reason"]


def test_impossible_numbers(tmp_path):
    with pytest.raises(InputError, match="six decimals"):
        next(prove_interval("3/2", "0.30000001", "0.31", tmp_path))
    with pytest.raises(InputError, match="exchange its ends"):
        prove_front("3/2", ("0.31", "0.3"), tmp_path / "file.npz")
    with pytest.raises(InputError, match=r"^alpha is .* must be a number above 1"):
        prove_front("three halves", "0.3", tmp_path / "file.npz")
    assert rational(0.1) == Fraction(1, 10)


def test_bounds_that_are_not_finite_bound_nothing():
    for value in (flint.arb("nan"), flint.arb("inf"), -flint.arb("inf")):
        for values in ([value], [value, flint.arb(1)], [flint.arb(1), value]):
            with pytest.raises(balls.NotProvedError, match="not finite"):
                balls.largest(values)
    assert balls.largest([flint.arb(2), flint.arb(3), flint.arb(1)]) == 3
    assert balls.above(flint.arb(1)) > 1


def test_powers_and_bounds_of_polynomials_contain_all_values():
    half = flint.arb("1.5")
    assert balls.power(flint.arb(-1), half) == 0
    straddling = balls.power(flint.arb(0, 0.25), half)
    assert straddling.contains(flint.arb(0))
    assert straddling.contains(flint.arb("0.125"))
    low, high = balls.bounds(flint.arb_poly([1, 2, -3]))
    values = [1 + 2 * t - 3 * t * t for t in np.linspace(-1, 1, 101)]
    assert low <= min(values)
    assert max(values) <= high
