import copy
import functools
import math
import operator
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import yaml

from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.constraints import RELATIVE_TOLERANCE_FLOOR
from granular_fronts.scenes.errors import ConfigurationError
from granular_fronts.scenes.validation import check_scene
from granular_fronts.scenes.yaml_files import load_configuration, merge

ROOT = Path(__file__).parents[1]
DEFAULT = ROOT / "config" / "default.yaml"
SMOKE = ROOT / "config" / "smoke.yaml"
SCHEMA = ROOT / "workflow" / "schemas" / "config.schema.yaml"
SCENE = "initiation_underdamped"


def change(configuration, family="chain", scene=SCENE, **changes):
    """Set `record__grid__step=…` in the scene; an ellipsis takes the key away."""
    changed = copy.deepcopy(configuration)
    for path, value in changes.items():
        *parents, last = path.split("__")
        node = changed["scenes"][family][scene]
        for parent in parents:
            node = node[parent]
        if value is ...:
            del node[last]
        else:
            node[last] = value
    return changed


def refusal(configuration):
    with pytest.raises(ConfigurationError) as caught:
        check_configuration(configuration)
    return str(caught.value)


@pytest.fixture
def default():
    return load_configuration(DEFAULT)


@pytest.mark.parametrize("files", [[DEFAULT], [DEFAULT, SMOKE]], ids=["default", "smoke"])
def test_configuration_files_are_accepted(files):
    check_configuration(load_configuration(*files))


def test_smoke_changes_values_but_not_what_is_drawn(default):
    smoke = load_configuration(DEFAULT, SMOKE)
    assert smoke["results"] != default["results"]
    for name, scene in default["scenes"]["chain"].items():
        record = smoke["scenes"]["chain"][name]["record"]
        assert record.keys() == scene["record"].keys()
        assert record["probes"].keys() == scene["record"]["probes"].keys()


def test_merge_goes_deep_and_replaces_lists():
    below = {"a": {"b": 1, "c": [1, 2, 3]}, "d": 4}
    above = {"a": {"c": [5]}}
    assert merge(below, above) == {"a": {"b": 1, "c": [5]}, "d": 4}
    assert below["a"]["c"] == [1, 2, 3]


PISTON = {"kind": "piston", "velocity": 0.05, "right": 0}


def at_velocity(velocity):
    """A start of 420 beads of which only the first moves."""
    velocities = [velocity, *[0.0] * 419]
    return {"kind": "given", "relative_displacement": [0.0] * 419, "velocity": velocities}


REFUSED = [
    ({"law__alpha": 0}, ["law.alpha is 0", "above 0"]),
    ({"law__beta": 0.5}, ["law.beta is 0.5", "limit 1", "give 1 or more"]),
    ({"law__gamma": -0.1}, ["law.gamma is -0.1", "limit 0", "give 0 or more"]),
    ({"law__gamma": ...}, ["law.gamma is missing", "add it", "viscous force"]),
    ({"law__gama": 0.1}, ["law.gama is no key", "did you mean gamma?"]),
    ({"law__colour": 1}, ["law.colour is no key", "alpha, beta, gamma"]),
    ({"law": None}, ["law is null", "a mapping of keys to values"]),
    ({"beads": 1}, ["beads is 1", "limit 2", "give 2 or more"]),
    ({"beads": 420.0}, ["beads is 420.0", "whole number"]),
    ({"beads": True}, ["beads is true", "whole number"]),
    ({"end_time": 0}, ["end_time is 0", "above 0"]),
    ({"end_time": "long"}, ['end_time is "long"', "give a number"]),
    ({"end_time": math.inf}, ["end_time is inf", "must be finite"]),
    ({"law__gamma": math.nan}, ["law.gamma is nan", "must be finite"]),
    ({"record__snapshots": [1.0, math.nan]}, ["record.snapshots (entry 2) is nan"]),
    ({"tolerance__relative": "1e-13"}, ['tolerance.relative is "1e-13"', "write 1.0e-13"]),
    ({"tolerance__absolute": "2.5E6"}, ["write 2.5e+6"]),
    (
        {"tolerance__relative": 1.0e-17},
        ["tolerance.relative is 1e-17", f"floor of {RELATIVE_TOLERANCE_FLOOR}", "or more"],
    ),
    ({"tolerance__absolute": 0.0}, ["tolerance.absolute is 0.0", "above 0"]),
    ({"boundary": {"kind": "rign"}}, ['boundary.kind is "rign"', "pressure or ring or piston"]),
    ({"boundary__left": -0.1}, ["boundary.left is -0.1", "limit 0"]),
    ({"boundary__kind": "ring"}, ["boundary.left, boundary.right are no keys"]),
    ({"boundary": PISTON | {"velocity": -1}}, ["boundary.velocity is -1", "above 0"]),
    ({"boundary": PISTON | {"ramp": -2}}, ["boundary.ramp is -2", "limit 0"]),
    ({"boundary": PISTON | {"left": 0.1}}, ["boundary.left is no key"]),
    ({"boundary": {"kind": "piston", "right": 0}}, ["boundary.velocity is missing"]),
    (
        {"boundary": PISTON, "start": at_velocity(0.2)},
        ["start.velocity begins with 0.2", "bead 1 is a piston", "give 0.05 first"],
    ),
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
    ({"record__probes__steady__beads": []}, ["probes.steady.beads is empty", "at least one"]),
    (
        {"record__probes__steady__beads": [50, 421]},
        ["probes.steady.beads names bead 421", "420 beads", "1 to 420"],
    ),
    ({"record__probes__steady__beads": [0]}, ["probes.steady.beads (entry 1) is 0", "limit 1"]),
    ({"record__probes__Fig 1": {}}, ['"Fig 1" in record.probes is no usable name']),
    ({"record__extremes": "yes"}, ['record.extremes is "yes"', "true or false"]),
]


@pytest.mark.parametrize(("changes", "words"), REFUSED, ids=[str(c)[:50] for c, _ in REFUSED])
def test_impossible_scene_is_refused_in_a_sentence(default, changes, words):
    sentence = refusal(change(default, **changes))
    assert sentence.startswith(f"Scene {SCENE}: ")
    assert sentence.endswith((".", "?"))
    for word in words:
        assert word in sentence


HETEROCLINIC_REFUSED = [
    ({"mu": []}, ["mu is empty", "at least one"]),
    ({"mu": [0.3, -1]}, ["mu (entry 2) is -1", "limit 0"]),
    ({"mu": [0.3, math.inf]}, ["mu (entry 2) is inf", "must be finite"]),
    ({"mu": [0.3, 2, 0.3]}, ["mu (entry 3) is 0.3", "list it once"]),
    ({"profile__start": 10}, ["profile.start is 10", "stop 10"]),
    ({"profile__step": 0}, ["profile.step is 0", "above 0"]),
    ({"portrait__starts": []}, ["portrait.starts is empty"]),
    ({"portrait__starts": [[0.5, 0], [-1, 0]]}, ["starts (entry 2) is [-1, 0]", "equilibrium"]),
    ({"well__limit": -1}, ["well.limit is -1", "above 0"]),
]


@pytest.mark.parametrize(
    ("changes", "words"), HETEROCLINIC_REFUSED, ids=[str(c)[:50] for c, _ in HETEROCLINIC_REFUSED]
)
def test_impossible_heteroclinic_scene_is_refused_in_a_sentence(default, changes, words):
    sentence = refusal(change(default, "heteroclinic", "front_profiles", **changes))
    assert sentence.startswith("Scene front_profiles: ")
    for word in words:
        assert word in sentence


def test_heteroclinic_scene_may_leave_out_what_only_the_figure_needs():
    scene = {"mu": np.array([0.3]), "profile": {"start": -1, "stop": np.float64(1), "step": 0.5}}
    assert check_scene("heteroclinic", scene, "mine")["mu"] == [0.3]


def test_checking_waits_for_no_heavy_import():
    module = "granular_fronts.scenes.configuration"
    code = f"import {module}, sys; print({{'numpy', 'numba'}} & set(sys.modules))"
    environment = {"PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


def test_every_mistake_is_told_at_once(default):
    sentences = refusal(change(default, law__alpha=-1, beads=0)).splitlines()
    assert len(sentences) == 2


@pytest.mark.parametrize(
    ("configuration", "words"),
    [
        ({}, "scenes is missing"),
        ({"results": "", "scenes": {"chain": {}}}, "results is empty"),
        ({"results": "results", "scenes": {"chain": {}}}, "scenes.heteroclinic is missing"),
        ({"results": "results", "scenes": {"chian": {}}}, "did you mean chain?"),
        ({"results": "results", "scenes": {"chain": {1: {}}}}, "1 in scenes.chain is no usable"),
    ],
)
def test_impossible_configuration_outside_scenes_is_refused(configuration, words):
    assert words in refusal(configuration)


def test_missing_key_is_told_where_a_definition_describes_it(default):
    del default["exact_fronts"]["survey"]["gamma"]
    told = "exact_fronts.survey.gamma is missing: add it (Dampings at equal ratios)."
    assert refusal(default) == told


def test_single_scene_is_checked_under_its_own_name(default):
    scene = change(default, law__gamma=-1)["scenes"]["chain"][SCENE]
    with pytest.raises(ConfigurationError, match=r"^Scene mine: law\.gamma is -1"):
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


def schema_nodes(node, path="schema"):
    """Walk through the schema's own schemas: properties, definitions and their parts."""
    yield path, node
    for group in ("properties", "$defs"):
        for name, child in node.get(group, {}).items():
            yield from schema_nodes(child, f"{path}.{name}")


@pytest.fixture
def schema():
    return yaml.safe_load(SCHEMA.read_text(encoding="utf-8"))


def described(node, schema):
    """A node, or the definition that it refers to, which carries the description."""
    if "$ref" not in node:
        return node
    steps = node["$ref"].removeprefix("#/").split("/")
    return functools.reduce(operator.getitem, steps, schema)


def test_schema_describes_every_key(schema):
    undescribed = [
        f"{path}.{name}"
        for path, node in schema_nodes(schema)
        for name, child in node.get("properties", {}).items()
        if not described(child, schema).get("description")
    ]
    assert not undescribed


def test_schema_says_of_every_number_that_it_is_dimensionless_or_in_which_unit(schema):
    for path, node in schema_nodes(schema):
        if node.get("type") in ("number", "integer"):
            assert re.search(r"dimensionless|in (m/s|[a-z]+s) \(SI\)", node["description"]), path


def test_schema_is_strict_at_every_level(schema):
    for path, node in schema_nodes(schema):
        if "properties" in node and "allOf" not in node:
            assert node.get("additionalProperties") is False, path


def test_keys_that_may_be_left_out_are_called_optional(schema):
    for path, node in schema_nodes(schema):
        if "allOf" in node:
            continue
        for name in set(node.get("properties", {})) - set(node.get("required", [])):
            assert "Optional." in node["properties"][name]["description"], f"{path}.{name}"


def test_default_shows_every_optional_key_of_a_heteroclinic_scene(schema, default):
    scene = default["scenes"]["heteroclinic"]["front_profiles"]
    assert scene.keys() == schema["$defs"]["heteroclinic_scene"]["properties"].keys()


def test_default_shows_every_optional_key(schema, default):
    record = default["scenes"]["chain"][SCENE]["record"]
    assert (
        record.keys() == schema["$defs"]["chain_scene"]["properties"]["record"]["properties"].keys()
    )
