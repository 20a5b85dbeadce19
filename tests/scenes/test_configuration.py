"""Scenes of the configuration: accepted, or refused in sentences that name the way out."""

import numpy as np
import pytest
from configurations import SCENE, change, refusal

from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import RELATIVE_TOLERANCE_FLOOR
from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.validation import check_scene

PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


def at_velocity(velocity):
    """A start of 420 beads of which only the first moves."""
    velocities = [velocity, *[0.0] * 419]
    return {"kind": "given", "relative_displacement": [0.0] * 419, "velocity": velocities}


CHAIN_REFUSED = [
    ({"law__alpha": 0}, ["law.alpha is 0", "above 0"]),
    ({"law__gamma": -0.1}, ["law.gamma is -0.1", "limit 0", "give 0 or more"]),
    ({"law__gamma": ...}, ["law.gamma is missing", "add it", "viscous force"]),
    ({"law": None}, ["law is null", "a mapping of keys to values"]),
    ({"beads": 1}, ["beads is 1", "limit 2", "give 2 or more"]),
    ({"beads": 420.0}, ["beads is 420.0", "whole number"]),
    ({"end_time": 0}, ["end_time is 0", "above 0"]),
    ({"end_time": "long"}, ['end_time is "long"', "give a number"]),
    ({"tolerance__relative": "1.0e-13"}, ['is "1.0e-13"', "quotes: write 1.0e-13 without them"]),
    ({"beads": "420.5"}, ['beads is "420.5": give a whole number instead']),
    ({"tolerance__relative": 1.0e-17}, ["relative is 1e-17", f"{RELATIVE_TOLERANCE_FLOOR}"]),
    ({"boundary": {"kind": "rign"}}, ['boundary.kind is "rign"', "pressure or ring or piston"]),
    ({"boundary__left": -0.1}, ["boundary.left is -0.1", "limit 0"]),
    ({"boundary__kind": "ring"}, ["boundary.left, boundary.right are no keys"]),
    ({"boundary": PISTON | {"velocity": -1}}, ["boundary.velocity is -1", "above 0"]),
    ({"boundary": PISTON | {"ramp": -2}}, ["boundary.ramp is -2", "limit 0"]),
    ({"boundary": PISTON, "start": at_velocity(0.2)}, ["begins with 0.2", "give 0.05 first"]),
    (
        {"boundary": PISTON | {"ramp": 3}, "start": at_velocity(0.05)},
        ["start.velocity begins with 0.05", "give 0 first"],
    ),
    ({"boundary": {"kind": "ring"}}, ["start.kind is rest", "ring", "kind given"]),
    ({"start": {"kind": "given"}}, ["start.relative_displacement is missing", "start.velocity"]),
    (
        {"start": {"kind": "given", "relative_displacement": [0.1] * 420, "velocity": [0.0] * 420}},
        ["start.relative_displacement has 420 numbers", "need 419"],
    ),
    ({"law__alpha": 0.8}, ["law.alpha is 0.8", "below 1", "uncompressed", "alpha of 1 or more"]),
    ({"record__snapshots": [450, 3000]}, ["record.snapshots (entry 2) is 3000", "end_time 2600"]),
    ({"record__grid__step": 2700}, ["record.grid.step is 2700", "end_time 2600"]),
    ({"record__probes__steady__stop": 9e3}, ["probes.steady.stop is 9000.0", "end_time 2600"]),
    ({"record__probes__steady__start": 420}, ["probes.steady.start is 420", "stop 420"]),
    ({"record__probes__steady__step": 400}, ["probes.steady.step is 400", "range of 360"]),
    ({"record__arrival_level": 1.5}, ["arrival_level is 1.5", "stay below 1 where about 0.1"]),
    ({"record__probes__steady__beads": []}, ["probes.steady.beads is empty", "at least one"]),
    ({"record__probes__steady__beads": [50, 421]}, ["names bead 421", "1 to 420"]),
    ({"record__probes__Fig 1": {}}, ['"Fig 1" in record.probes is no usable name']),
    ({"tolerance__absolute": 1.0e-300}, ["tolerance.absolute is 1e-300, below 1e-20", "about 0.1"]),
    ({"tolerance__absolute": 1.0e3}, ["above 0.1 of the largest", "give 1.0e-02 or less"]),
    ({"law__alpha": 1.0e3}, ["law.alpha is 1000.0", "energies of about 1e-1001", "nearer to 1"]),
    ({"beads": 10**9}, ["beads = 1000000000", "16,004 GiB", "limit of 16 GiB", "lower beads"]),
    ({"end_time": 1.0e300}, ["end_time = 1e+300", "years on one core", "lower beads or end_time"]),
    ({"law__gamma": 1.0e12}, ["law.gamma = 1000000000000.0", "37 years on one core", "law.gamma."]),
    ({"record__probes__steady__step": 1.0e-9}, ["probes.steady.step = 1e-09", "53,644 GiB"]),
    ({"record__snapshots": [450, 450.0]}, ["record.snapshots (entry 2) is 450.0", "list it once"]),
    (
        {"record__probes__grid": {"beads": [1], "start": 0, "stop": 1, "step": 1}},
        ["record.probes.grid has the name", "another name"],
    ),
    ({"record__snapshots": []}, ["record.snapshots is empty", "figure 1 needs it"]),
    ({"record__probes__transient": ...}, ["probes.transient is missing", "figure 1 needs it"]),
    ({"record__extremes": False}, ["record.extremes is empty or off", "printed numbers"]),
    ({"law__alpha": -1, "beads": 0}, ["law.alpha is -1", "\nScene", "beads is 0"]),
]
HETEROCLINIC_REFUSED = [
    ({"mu": [0.3, 2, 0.3]}, ["mu (entry 3) is 0.3", "list it once"]),
    ({"profile__start": 10}, ["profile.start is 10", "stop 10"]),
    ({"profile__step": 60}, ["profile.step is 60", "range of 50", "give 50 or less"]),
    ({"well__step": 2}, ["well.step is 2", "range of 1.75", "(limit)"]),
    ({"profile__step": 1.0e-9}, ["profile.step = 1e-09", "2,980 GiB", "raise profile.step"]),
    ({"portrait__mu": 0.5}, ["portrait.mu is 0.5", "one of mu [0.3, 2]", "add 0.5 to mu"]),
    ({"mu": [0.3, 1e-300]}, ["mu (entry 2) is 1e-300", "give 0, or 1e-280 or more"]),
    ({"mu": [0.3, 0], "profile__stop": 53}, ["profile.stop is 53", "mu = 0", "s = 52.40"]),
    ({"mu": [0.3, 0], "profile__start": -57}, ["profile.start is -57", "s = -56.77"]),
    ({"profile__stop": 1e6}, ["profile.stop is 1000000.0", "s = 54.50"]),
    ({"well": ...}, ["well is missing", "figure 8 needs it"]),
    ({"portrait__starts": []}, ["portrait.starts is empty"]),
    ({"portrait__starts": [[0.5, 0], [-1, 0]]}, ["starts (entry 2) is [-1, 0]", "equilibrium"]),
]
REFUSED = [
    *[("chain", SCENE, *row) for row in CHAIN_REFUSED],
    *[("heteroclinic", "front_profiles", *row) for row in HETEROCLINIC_REFUSED],
]


@pytest.mark.parametrize(
    ("family", "name", "changes", "words"), REFUSED, ids=[str(row[2])[:50] for row in REFUSED]
)
def test_impossible_scene_is_refused_in_a_sentence(default, family, name, changes, words):
    sentence = refusal(change(default, family, name, **changes))
    assert sentence.startswith(f"Scene {name}: ")
    assert sentence.endswith((".", "?"))
    for word in words:
        assert word in sentence


def test_heteroclinic_scene_may_leave_out_what_only_the_figure_needs():
    scene = {"mu": np.array([0.3]), "profile": {"start": -1, "stop": np.float64(1), "step": 0.5}}
    assert check_scene("heteroclinic", scene, "mine")["mu"] == [0.3]


def test_what_is_large_but_possible_is_accepted(default):
    """A hundred thousand beads for an hour, a thousand snapshots, ten million samples."""
    large = change(
        default, beads=100_000, record__grid__step=500, record__probes__steady__step=3.6e-5
    )
    check_configuration(large)


def test_probes_may_have_the_names_of_limits(default):
    record = default["scenes"]["chain"][SCENE]["record"]
    for name in ("start", "stop", "step", "limit", "span"):
        record["probes"][name] = record["probes"]["steady"]
    check_configuration(default)


def test_single_scene_is_checked_under_its_own_name(default):
    scene = change(default, law__gamma=-1)["scenes"]["chain"][SCENE]
    with pytest.raises(InputError, match=r"^Scene mine: law\.gamma is -1"):
        check_scene("chain", scene, "mine")


def test_single_scene_may_hold_numpy_values(default):
    scene = change(
        default,
        beads=np.int64(3),
        law__gamma=np.float64(0.1),
        record={"snapshots": np.array([1.0, 2.0])},
        boundary={"kind": "ring"},
        start={"kind": "given", "relative_displacement": np.ones(3), "velocity": np.zeros(3)},
    )["scenes"]["chain"][SCENE]
    checked = check_scene("chain", scene, "mine")
    assert checked["start"]["velocity"] == [0.0, 0.0, 0.0]
    assert type(checked["beads"]) is int
