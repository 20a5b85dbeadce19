"""Scenes with any law: by configuration and from Python, and laws that no scene can have."""

import json
import math

import numpy as np
import pytest
from potentials import cosh

import granular_fronts as gf
from granular_fronts.errors import InputError, SolveError
from granular_fronts.output.datasets import configuration_of, read_dataset, write_dataset
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES
from granular_fronts.scenes.laws import (
    decades_of_energy,
    decades_of_impact,
    front_speed,
)

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
SHORT = {"alpha": 1.5, "beta": 2.5, "gamma": 0.2}
REST = {"kind": "rest"}
LONG = {
    "elastic": {"kind": "hertz", "alpha": 1.5},
    "viscous": {"kind": "simon_hunt_crossley", "gamma": 0.2},
}
# So little stiffer than the law (28) that it is one of potentials.
STIFF = LONG | {"elastic": LONG["elastic"] | {"stiffness": 1.000001}}


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
    np.testing.assert_allclose(found, linear, rtol=0, atol=1e-4**3)
    assert np.abs(found - linear).max() > 1e-16


def test_a_mapping_may_hold_a_users_potential():
    mapping = {"elastic": cosh(), "viscous": {"kind": "proportional", "gamma": 0.2}}
    checked = Chain.read(scene(mapping), "mine")
    assert checked.law == gf.make_law(mapping)
    with pytest.raises(InputError, match=r"^Scene mine: law: 'lineal' is no kind of viscous"):
        Chain.read(scene(mapping | {"viscous": {"kind": "lineal"}}), "mine")


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


def test_beta_is_alpha_by_default_in_every_family(default):
    """Rings and fronts take no other, since their equations hold for the law of Kuwabara–Kono."""
    bare, full = {"alpha": 1.5, "gamma": 0.2}, {"alpha": 1.5, "beta": 1.5, "gamma": 0.2}
    laws = [Chain.read(scene(law), "mine").law for law in (bare, full)]
    assert laws[0] == laws[1] == gf.make_law(bare)
    with pytest.raises(InputError, match=r"law\.beta is alpha by default, 0\.9, below its limit 1"):
        Chain.read(scene(bare | {"alpha": 0.9}), "mine")
    for family, name in (("periodic", "hertz"), ("front", "underdamped")):
        given = default["scenes"][family][name]
        SCENES[family].read(given | {"law": full}, "mine")
        with pytest.raises(InputError, match=r"law\.beta is 1, but .* beta = alpha = 1\.5"):
            SCENES[family].read(given | {"law": full | {"beta": 1}}, "mine")


@pytest.mark.parametrize(("velocity", "size"), [(1e-3, -3.0), (0.1, -2.0), (10.0, 1.0)])
def test_sizes_of_a_law_are_the_same_in_both_forms(velocity, size):
    """The compression v^(2/(α + 1)) that a velocity makes; front speed and energies."""
    by_exponents, by_kinds = gf.make_law(SHORT), gf.make_law(STIFF)
    sizes = [decades_of_impact(law, velocity) for law in (by_exponents, by_kinds)]
    assert sizes == pytest.approx([0.8 * math.log10(velocity)] * 2, abs=0.3)
    assert sizes[0] == pytest.approx(0.8 * math.log10(velocity))
    u = 10.0**size
    for law in (by_exponents, by_kinds):
        assert front_speed(law, size) == pytest.approx(u**0.25, rel=1e-3)
    assert decades_of_energy(by_exponents, size) == pytest.approx(
        {"alpha": 2.5 * size, "beta": 3.5 * size}
    )
    energies = {"elastic": 2.5 * size, "viscous": math.log10(0.2) + 3.5 * size}
    assert decades_of_energy(by_kinds, size) == pytest.approx(energies, abs=1e-3)
