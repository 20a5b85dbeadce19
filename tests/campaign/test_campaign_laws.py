"""Campaigns with any law: their points, their grid, and laws that cannot be made."""

import numpy as np
import pytest
from campaigns import all_chunks, campaign, refusal, solve, solved_points
from configurations import assert_refused

from granular_fronts.campaign import merging
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.model.laws import make_law

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
CHAINS = {
    "kind": "chain",
    "law": TODA,
    "axes": {"law.elastic.rate": [0.5, 1.0], "delta": [0.1, 0.5]},
    "fixed": {"beads": 30},
    "tolerance": 1e-8,
    "record": {"scalars": ["front_speed", "overshoot", "first_gap_time", "largest_overshoot"]},
}
FRONTS = {
    "kind": "front",
    "law": TODA,
    "axes": {"law.elastic.rate": [0.5, 1.0], "damping": [0.5, 1.0]},
    "fixed": {"behind": -2.0},
    "record": {"profile": {"start": -2, "stop": 2, "count": 5}},
}


def solved(given):
    found = solved_points(campaign(given))
    assert not found.reasons.any()
    return found


def test_a_law_of_powers_gives_the_points_of_its_exponents():
    """Solved in the units of the law and in those of δ: James (2021), eq. (29)."""
    ends = {"beads": 30, "delta_right": 0.01}
    record = {"scalars": [*CHAINS["record"]["scalars"], "smallest_compression"]}
    axes = {"gamma": [0.1, 0.3], "delta": [0.1, 0.5]}
    short = {"kind": "chain", "tolerance": CHAINS["tolerance"], "record": record}
    expected = solved(short | {"axes": axes, "fixed": {"alpha": 1.5, "beta": 2.5} | ends})
    law = {"elastic": {"kind": "hertz", "alpha": 1.5}, "viscous": {"kind": "simon_hunt_crossley"}}
    varied = {"law.viscous.gamma": [0.1, 0.3], "delta": [0.1, 0.5]}
    found = solved(CHAINS | {"law": law, "axes": varied, "fixed": ends, "record": record})
    assert (expected.values["smallest_compression"] < 0.0).all()
    for name, values in expected.values.items():
        np.testing.assert_allclose(found.values[name], values, rtol=1e-6, atol=1e-7)


def test_strong_pressure_makes_the_front_of_the_jump_conditions():
    """The speed over c of eq. (13) is 1 where the front has formed."""
    found = solved(CHAINS | {"axes": {"law.viscous.gamma": [1.0], "delta": [2.0]}})
    assert found.values["front_speed"][0, 0] == pytest.approx(1.0, abs=2e-3)


def test_front_points_of_a_law_are_its_exact_fronts():
    found = solved(FRONTS)
    for (line, fast), overshoot in np.ndenumerate(found.values["overshoot"]):
        rate = FRONTS["axes"]["law.elastic.rate"][line]
        law = make_law(TODA | {"elastic": {"kind": "toda", "rate": rate}})
        damped = law.with_damping(FRONTS["axes"]["damping"][fast])
        front = solve_front(law=damped, states=(-2.0, 0.0))
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-12)
        u, xi = found.values["relative_displacement"][line, fast], np.linspace(-2, 2, 5)
        np.testing.assert_allclose(u, evaluate_front(front, xi), rtol=0, atol=1e-12)


def test_a_front_beyond_double_precision_leaves_a_reason():
    steep = {"elastic": {"kind": "hertz", "alpha": 300.0}, "viscous": TODA["viscous"]}
    axes, ends = {"damping": [1e-300]}, {"behind": -10.0}
    found = solved_points(campaign(FRONTS, law=steep, axes=axes, fixed=ends))
    assert "A front of this law lies beyond double precision" in found.reasons[0, 0]


def test_varied_numbers_of_a_law_are_dimensions_of_the_grid(tmp_path):
    asked = campaign(CHAINS)
    files = [solve(chunk, tmp_path) for chunk in all_chunks(asked, 2)]
    merged = merging.merge_chunks(asked, files)
    assert merged["front_speed"].dims == ("elastic_rate", "delta")
    assert merged["elastic_rate"].attrs["long_name"] == "law.elastic.rate"
    np.testing.assert_array_equal(merged["status"], 0)


def test_points_of_another_law_are_solved_anew():
    names = {
        all_chunks(campaign(CHAINS, law=TODA | {"viscous": {"kind": "linear", "gamma": g}}), 10)[
            0
        ].name
        for g in (0.3, 0.4)
    }
    assert len(names) == 2


def rates(*values, **axes):
    return {"axes": {"law.elastic.rate": [*values], "delta": [1.0], **axes}}


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"kind": "ring"}, "law is given, but kind ring"),
        ({"law": {"elastic": {"kind": "tode"}}}, "'tode' is no kind of elastic potential"),
        ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
        ({"law": {"elastic": {"kind": "toda", "rate": "2"}}}, "law.elastic.rate is"),
        (rates(-1.0, 1.0), "rate is -1.0 | above 0"),
        (rates(1.0, **{"law.elastic.rat": [1.0]}), "'rat' is no parameter of toda"),
        (rates(1.0, alpha=[1.5]), "axes.alpha is given"),
    ],
)
def test_wrong_law_of_a_campaign_is_refused(changes, words):
    assert_refused(refusal(CHAINS, **changes), words)


def test_an_axis_of_a_law_needs_a_law():
    without = {key: value for key, value in CHAINS.items() if key != "law"}
    assert_refused(refusal(without), "axes.law.elastic.rate varies a number of the law")
