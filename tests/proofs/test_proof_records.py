"""What is proved as data: records of certificates, and the enclosure of a front."""

from fractions import Fraction

import numpy as np
import pytest
from certificates import KEPT, PROVED, known, proved

import granular_fronts as gf
from granular_fronts.proofs import enclosure
from granular_fronts.proofs.records import JOINED, records_dataset


@pytest.fixture(scope="module")
def kept():
    """Records of the certificates that are kept, as data."""
    rows = [proved(name) | {"name": name, "path": KEPT[name], "seconds": 1.0} for name in PROVED]
    return rows, records_dataset(rows)


def test_data_hold_what_the_checker_says(kept):
    rows, data = kept
    assert list(data["certificate"].values) == list(PROVED)
    for row in rows:
        one = data.sel(certificate=row["name"])
        assert float(one["error_bound"]) == row["error"]
        assert float(one["radius"]) == row["numbers"]["radius"]
        for parameter in ("alpha", "gamma"):
            ends = one["ends"].sel(parameter=parameter).values
            assert tuple(map(Fraction, ends)) == row[parameter]
        assert str(one["statements"].values).splitlines() == row["statements"]
        found = one[["left", "right"]].dropna("inequality")
        sides = {known["name"]: (known["left"], known["right"]) for known in row["inequalities"]}
        assert sides == {
            str(name): (float(left), float(right))
            for name, left, right in zip(
                found["inequality"].values, found["left"].values, found["right"].values, strict=True
            )
        }


def test_fronts_that_continue_the_row_before_are_said_to(kept):
    first, second = kept[0][:2]
    joined = {"name": JOINED, "left": 0.7, "right": 1.0, "margin": 0.3}
    second = second | {"inequalities": [*second["inequalities"], joined]}
    assert records_dataset([first, second])["joined"].values.tolist() == [0, 1]


def test_only_what_is_proved_is_in_the_data(kept):
    _, data = kept
    assert not data["joined"].any()
    for name in PROVED:
        one, numbers = data.sel(certificate=name), proved(name)["numbers"]
        assert bool(one["monotone"] == 1.0) == ("monotone" in numbers)
        assert bool(one["overshoot_bound"].notnull()) == ("overshoot" in numbers)
        if "overshoot" in numbers:
            assert 1 + one["overshoot_bound"] == numbers["overshoot"]
        for bound in ("rate_low", "amplitude_high", "unique_within"):
            np.testing.assert_equal(float(one[bound]), numbers.get(bound, np.nan))


def test_computed_front_lies_in_the_enclosure_and_in_the_bounds_of_its_tail(monkeypatch):
    front = known("monotone")
    monkeypatch.setattr(enclosure, "prove", lambda path: front)
    data = enclosure.enclosure_dataset(KEPT["monotone"])
    computed = gf.solve_front(1.5, 0.3)
    u = gf.evaluate_front(computed, data["xi"].values)
    assert np.all(abs(u - data["approximation"]) < data["error"])
    assert np.all(data["error"] <= data.attrs["error_bound"])
    ahead = data["xi_ahead"].values
    assert np.all(data["decay_low"] <= data["decay_high"])
    assert np.all(np.isfinite(data["decay_high"]))
    u = gf.evaluate_front(computed, ahead)
    computed = u > 1e-12  # Below, it is rounding.
    decay = -np.log(u[computed])
    assert np.all(data["decay_low"].values[computed] <= decay)
    assert np.all(decay <= data["decay_high"].values[computed])
    # Ahead of all cells the bounds follow from those one bead, and one less a cell, behind.
    low, high, n = data["decay_low"].values, data["decay_high"].values, front.n
    assert low[-1] == pytest.approx(1.5 * low[-1 - n] - np.log(1 + 0.3**2))
    assert 0.25 < n * np.exp(1.5 * high[-n] - high[-1]) < 0.3  # c, below γ
