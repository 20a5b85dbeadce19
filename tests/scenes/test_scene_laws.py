"""Scenes with any law: by configuration and from Python, and laws that no scene can have."""

import json
import math

import numpy as np
import pytest
from chains import given
from potentials import cosh

import granular_fronts as gf
from granular_fronts.errors import InputError, SolveError
from granular_fronts.output.datasets import configuration_of, read_dataset, write_dataset
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES
from granular_fronts.scenes.laws import (
    decades_of_energy,
    decades_of_impact,
    decades_of_load,
    front_speed,
)

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
SHORT = {"alpha": 1.5, "beta": 2.5, "gamma": 0.2}
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


def test_no_motion_leaves_the_interval_of_a_users_law_unnoticed():
    """The front overshoots the compression that presses it."""
    functions = (lambda r: np.cosh(r) - 1.0, np.sinh, np.cosh)
    wide, narrow = (
        gf.make_law(elastic=gf.Potential(*functions, interval=(-most, 1.0))) for most in (1.0, 0.31)
    )
    assert gf.simulate_chain(scene(wide))["relative_displacement"].max() > 0.31
    with pytest.raises(SolveError, match=r"leaves the interval from -0\.31 to 1 in which"):
        gf.simulate_chain(scene(narrow))


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
    """−ln(−r), of compressed chains alone."""
    functions = (lambda r: -np.log(-r), lambda r: -1.0 / r, lambda r: r**-2.0)
    law = gf.make_law(elastic=gf.Potential(*functions, interval=(-2.0, -0.01)))
    u = [0.5, 0.6, 0.5, 0.4] if boundary["kind"] == "ring" else [0.5, 0.6, 0.5]
    start = given(u, [boundary.get("velocity", 0.0), 0.0, 0.0, 0.0])
    changes = {"boundary": boundary, "start": start, "end_time": 3.0, "beads": 4}
    record = {"snapshots": [3.0], "balances": True}
    motion = gf.simulate_chain(scene(law, record=record, **changes))
    assert motion.attrs["momentum_drift"] < 1e-13
    assert motion.attrs["energy_drift"] < 1e-8


def test_a_file_says_which_law_it_was(tmp_path):
    mine = scene({"elastic": cosh()})
    motion, file = gf.simulate_chain(mine), tmp_path / "mine.nc"
    write_dataset(motion, file, scene_id="mine", config=scene(gf.make_law(elastic=cosh())))
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
        ours = default["scenes"][family][name]
        SCENES[family].read(ours | {"law": full}, "mine")
        with pytest.raises(InputError, match=r"law\.beta is 1, but .* beta = alpha = 1\.5"):
            SCENES[family].read(ours | {"law": full | {"beta": 1}}, "mine")


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
    loads = [decades_of_load(law, 10.0**size) for law in (by_exponents, by_kinds)]
    assert loads == pytest.approx([size / 1.5] * 2, abs=0.1)


def test_beyond_the_interval_of_a_law_there_is_no_front_and_a_constant_is_no_energy():
    shifted = gf.Potential(np.cosh, np.sinh, np.cosh, interval=(-3, 3))
    one, other = (gf.make_law(elastic=elastic) for elastic in (cosh(), shifted))
    assert front_speed(other, 1.0) == 0.0 < front_speed(other, 0.0)
    assert decades_of_impact(one, 0.01) == decades_of_impact(other, 0.01) < -1.0
    assert decades_of_energy(other, -2.0) == pytest.approx(decades_of_energy(one, -2.0))


SINE = {"amplitude": -1.5, "angular_frequency": 1.0, "offset": 0.5}
STRIKER = {"kind": "striker", "beads": 1, "velocity": 9.0}


@pytest.mark.parametrize(
    ("changes", "largest"),
    [
        ({}, 0.3),
        ({"start": given([0.1, -0.7, *[0.0] * 17], np.zeros(20))}, 0.7),
        ({"start": given(np.zeros(19), [0.0, -9.0, *[0.0] * 18])}, 9.0**0.8),
        ({"start": STRIKER, "boundary": {"kind": "wall", "left": 0.3}}, 9.0**0.8),
        ({"boundary": {"kind": "piston", "velocity": 2.0}}, 2.0**0.8),
        ({"boundary": {"kind": "force", "force": 2.0}}, 2.0 ** (1 / 1.5)),
        ({"boundary": {"kind": "force", "force": {"harmonic": SINE}}}, 2.0 ** (1 / 1.5)),
        ({"gravity": -0.25}, (0.25 * 20) ** 0.4),
    ],
)
def test_size_of_a_motion_is_that_of_the_largest_that_drives_it(changes, largest):
    """A displacement, or what a velocity, a force or the weight of all beads makes of a contact."""
    assert 10.0 ** Chain.read(scene(SHORT, **changes)).size == pytest.approx(largest)
