"""Scenes with any law: by configuration and from Python, and laws that no scene can have."""

import json

import numpy as np
import pytest
from potentials import cosh

import granular_fronts as gf
from granular_fronts.errors import InputError, SolveError
from granular_fronts.output.datasets import configuration_of, read_dataset, write_dataset
from granular_fronts.scenes.laws import decades_of_impact, front_speed
from granular_fronts.scenes.validation import check_scene

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
SHORT = {"alpha": 1.5, "beta": 2.5, "gamma": 0.2}
REST = {"kind": "rest"}
LONG = {
    "elastic": {"kind": "hertz", "alpha": 1.5},
    "viscous": {"kind": "simon_hunt_crossley", "gamma": 0.2},
}


def scene(law, **changes):
    return {
        "law": law,
        "beads": 20,
        "boundary": {"kind": "pressure", "left": 0.3, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": 12.0,
        "tolerance": {"relative": 1e-9, "absolute": 1e-11},
        "record": {"snapshots": [6.0, 12.0], "arrival_level": 0.15, "balances": True},
    } | changes


def test_both_forms_of_one_law_make_one_motion():
    by_exponents, by_kinds, by_object = (
        gf.simulate_chain(scene(law)) for law in (SHORT, LONG, gf.make_law(LONG))
    )
    for motion in (by_kinds, by_object):
        assert motion.drop_attrs().equals(by_exponents.drop_attrs())


@pytest.mark.parametrize(
    "boundary",
    [
        {"kind": "pressure", "left": 0.3, "right": 0.1},
        {"kind": "pressure", "left": -0.3, "right": 0.0},
        {"kind": "piston", "velocity": 0.3, "ramp": 2.0},
        {"kind": "piston", "velocity": -0.3},
        {"kind": "ring"},
    ],
    ids=lambda boundary: boundary["kind"],
)
@pytest.mark.parametrize("law", [TODA, {"elastic": {"kind": "fpu", "cubic": -0.5}}], ids=str)
def test_any_law_moves_with_any_boundary_and_keeps_its_balances(law, boundary):
    start = {"kind": "rest"}
    if boundary["kind"] == "ring":
        u = 0.2 * np.sin(2.0 * np.pi * np.arange(20) / 20.0)
        start = {"kind": "given", "relative_displacement": u, "velocity": np.zeros(20)}
    record = {"snapshots": [6.0, 12.0], "balances": True, "extremes": True}
    motion = gf.simulate_chain(scene(law, boundary=boundary, start=start, record=record))
    assert np.abs(motion["relative_displacement"]).max() > 0.01
    assert motion.attrs["momentum_drift"] < 1e-11
    assert motion.attrs["energy_drift"] < 1e-7


def test_a_users_law_is_a_law_like_any_other():
    """cosh r − 1 is the mean of two Toda potentials of opposite rates; near rest both are r²/2."""
    law = gf.make_law(elastic=cosh(), viscous={"kind": "proportional", "gamma": 0.2})
    motion = gf.simulate_chain(scene(law))
    assert motion.attrs["energy_drift"] < 1e-7
    small = {"kind": "pressure", "left": 1e-4, "right": 0.0}
    tolerance = {"relative": 1e-10, "absolute": 1e-14}
    record = {"snapshots": [12.0]}
    changes = {"boundary": small, "tolerance": tolerance, "record": record}
    harmonic = gf.make_law(elastic={"kind": "fpu"}, viscous={"kind": "linear", "gamma": 0.2})
    found, linear = (
        gf.simulate_chain(scene(law, **changes))["relative_displacement"].values
        for law in (law, harmonic)
    )
    np.testing.assert_allclose(found, linear, atol=1e-4**3)
    assert np.abs(found - linear).max() > 1e-16


def test_a_mapping_may_hold_a_users_potential():
    mapping = {"elastic": cosh(), "viscous": {"kind": "proportional", "gamma": 0.2}}
    checked = check_scene("chain", scene(mapping), "mine")
    assert checked["law"] == gf.make_law(mapping)
    with pytest.raises(InputError, match=r"^Scene mine: law: 'lineal' is no kind of viscous"):
        check_scene("chain", scene(mapping | {"viscous": {"kind": "lineal"}}), "mine")


def test_no_motion_leaves_the_interval_of_a_users_law_unnoticed():
    """The front overshoots the compression that presses it."""
    functions = (lambda r: np.cosh(r) - 1.0, np.sinh, np.cosh)
    wide, narrow = (
        gf.make_law(elastic=gf.Potential(*functions, interval=(-most, 1.0))) for most in (1.0, 0.31)
    )
    assert gf.simulate_chain(scene(wide))["relative_displacement"].max() > 0.31
    with pytest.raises(SolveError, match=r"leaves the interval from -0\.31 to 1 in which"):
        gf.simulate_chain(scene(narrow))


def barrier():
    """Infinite at rest: −ln(−r), of compressed chains alone."""
    return gf.Potential(
        lambda r: -np.log(-r), lambda r: -1.0 / r, lambda r: r**-2.0, interval=(-2.0, -0.01)
    )


def compressed(boundary, end_time=3.0):
    """Four beads of the barrier, pressed everywhere, held by a boundary."""
    ring, velocity = boundary["kind"] == "ring", boundary.get("velocity", 0.0)
    u = [0.5, 0.6, 0.5, 0.4] if ring else [0.5, 0.6, 0.5]
    start = {"kind": "given", "relative_displacement": u, "velocity": [velocity, 0.0, 0.0, 0.0]}
    changes = {"boundary": boundary, "start": start, "end_time": end_time, "beads": 4}
    record = {"snapshots": [end_time], "balances": True}
    return scene(gf.make_law(elastic=barrier()), record=record, **changes)


@pytest.mark.parametrize(
    "boundary",
    [
        {"kind": "ring"},
        {"kind": "piston", "velocity": 0.05, "right": 0.4},
        {"kind": "pressure", "left": 0.5, "right": 0.4},
    ],
    ids=lambda boundary: boundary["kind"],
)
def test_a_law_need_not_hold_at_rest(boundary):
    motion = gf.simulate_chain(compressed(boundary))
    assert motion.attrs["momentum_drift"] < 1e-13
    assert motion.attrs["energy_drift"] < 1e-8


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"boundary": {"kind": "piston", "velocity": 0.0}}, "boundary.right is 0, but the law"),
        (
            {"boundary": {"kind": "pressure", "left": 0.5, "right": 0.4}, "start": REST},
            "start.relative_displacement of a chain at rest is 0, but the law",
        ),
    ],
)
def test_a_held_end_and_a_chain_at_rest_lie_where_the_law_holds(changes, words):
    with pytest.raises(InputError, match=words):
        check_scene("chain", compressed({"kind": "ring"}) | {"beads": 4} | changes, "mine")


def test_a_file_says_which_law_it_was(tmp_path):
    given = scene(gf.make_law(elastic=cosh()))
    motion, file = gf.simulate_chain(given), tmp_path / "mine.nc"
    write_dataset(motion, file, scene_id="mine", config=given)
    stored = configuration_of(read_dataset(file))["law"]
    assert stored["elastic"]["name"] == "cosh"
    assert "cannot make again" in stored["elastic"]["note"]
    write_dataset(motion, file, scene_id="mine", config=scene(gf.make_law(TODA)))
    again = configuration_of(read_dataset(file))["law"]
    assert gf.make_law(again) == gf.make_law(TODA)
    assert json.loads(json.dumps(again)) == again


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"law": TODA | {"alpha": 1.5}}, "law.alpha is no key"),
        ({"law": {"elastic": {"kind": "toda", "rate": 0}}}, "rate is 0, but must be"),
        ({"law": {"elastic": {"rate": 1}}}, "law.elastic.kind is missing"),
        ({"law": {"viscous": {"kind": "none"}}}, "law.elastic is missing"),
        (
            {"law": {"elastic": {"kind": "lennard_jones", "distance": 0.2}}},
            "boundary.left is 0.3, but the law holds for relative displacements between",
        ),
        ({"law": {"elastic": {"kind": "hertz", "alpha": 0.5}}}, "law.alpha is 0.5, below 1"),
        ({"law": {"elastic": {"kind": "hertz", "alpha": 500}}}, "law.elastic with relative"),
        (
            {"law": SHORT, "boundary": {"kind": "pressure", "left": -0.1, "right": 0}},
            "boundary.left is -0.1, below its limit 0",
        ),
        (
            {"law": SHORT, "boundary": {"kind": "piston", "velocity": -0.1}},
            "boundary.velocity is -0.1, but must be above 0",
        ),
        (
            {"law": SHORT, "record": {"snapshots": [], "arrival_level": -0.1}},
            "record.arrival_level is -0.1, but must be above 0",
        ),
    ],
)
def test_impossible_law_of_a_scene_is_named(changes, words):
    with pytest.raises(InputError) as caught:
        check_scene("chain", scene(TODA) | changes, "mine")
    assert str(caught.value).startswith("Scene mine: ")
    assert words in str(caught.value)


@pytest.mark.parametrize("velocity", [1e-3, 0.1, 10.0])
def test_sizes_of_a_long_form_are_those_of_the_short_one(velocity):
    """The compression that a velocity makes, to a grid of decades; the speed of a front."""
    by_exponents, by_kinds = (decades_of_impact(law, velocity, 140) for law in (SHORT, LONG))
    assert abs(by_exponents - by_kinds) < 0.3
    assert front_speed(LONG, -2.0) == pytest.approx(front_speed(SHORT, -2.0))
