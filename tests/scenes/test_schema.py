"""The schemas describe every key, and let no other pass; a user's errors quote them."""

import json
import pickle
import re
from typing import get_args

import numpy as np
import pytest
from chains import driven_scene
from configurations import DEFAULT, SCENE
from jsonschema import Draft202012Validator
from pydantic import ValidationError

from granular_fronts.scenes.chain import Chain, Record
from granular_fronts.scenes.configuration import Configuration
from granular_fronts.scenes.orbit import Orbits
from granular_fronts.scenes.parts import Part
from granular_fronts.scenes.schema import load_schema
from granular_fronts.scenes.validation import SCENES, check_scene
from granular_fronts.scenes.yaml_files import load_configuration

SCHEMAS = {"campaign": load_schema("campaign")}


def schema_nodes(node, path="schema"):
    """Walk through the schema's own schemas: properties, definitions and their parts."""
    yield path, node
    for group in ("properties", "$defs"):
        for name, child in node.get(group, {}).items():
            yield from schema_nodes(child, f"{path}.{name}")


def description(node, schema):
    """What is said of a node, or of the definition that it refers to."""
    referred = schema["$defs"].get(node.get("$ref", "").rpartition("/")[2], {})
    return node.get("description") or referred.get("description", "")


@pytest.mark.parametrize("schema", SCHEMAS.values(), ids=SCHEMAS)
def test_every_key_is_known_described_and_optional_where_it_says_so(schema):
    """But for potentials, whose kinds and parameters `model.kinds` lists."""
    for path, node in schema_nodes(schema):
        if node.get("type") in ("number", "integer"):
            assert re.search(r"dimensionless|in (m/s|[a-z]+s) \(SI\)", node["description"]), path
        if "properties" not in node or "allOf" in node:
            continue
        assert "potential" in path or node.get("additionalProperties") is False, path
        for name, child in node["properties"].items():
            said = description(child, schema)
            assert said, f"{path}.{name}"
            assert ("Optional" in said) == (name not in node.get("required", [])), f"{path}.{name}"


def parts_below(part):
    """A part and all parts that its keys hold."""
    yield part
    for below in part.__subclasses__():
        yield from parts_below(below)


def test_every_key_of_a_scene_says_what_it_is():
    for part in parts_below(Part):
        for name, field in part.model_fields.items():
            inside = [one for one in get_args(field.annotation) or [field.annotation] if one]
            is_part = any(isinstance(one, type) and issubclass(one, Part) for one in inside)
            assert name in ("kind", "impurity") or field.description or is_part, (
                f"{part.__name__}.{name}"
            )
            assert part.__doc__


def test_the_schema_for_editors_takes_the_default_and_no_unknown_key():
    validator = Draft202012Validator(Configuration.model_json_schema())
    default = load_configuration(DEFAULT)
    assert [*validator.iter_errors(default)] == []
    scene = default["scenes"]["chain"][SCENE]
    scene["bedas"] = 3
    scene["record"]["probes"]["Near"] = {}
    assert len([*validator.iter_errors(default)]) == 2


def test_default_shows_every_optional_key():
    scenes = load_configuration(DEFAULT)["scenes"]
    assert scenes["heteroclinic"]["front_profiles"].keys() == Orbits.model_fields.keys()
    # No figure of the paper shows forces of contacts; campaigns of the project record them.
    shown = scenes["chain"][SCENE]["record"].keys() | {"sensors"}
    assert shown == Record.model_fields.keys()


@pytest.mark.parametrize("family", SCENES)
def test_a_scene_is_what_it_says_of_itself(family):
    """Its plain form, as a file holds it, makes it again; so do its keys as arguments."""
    for name, given in load_configuration(DEFAULT)["scenes"][family].items():
        scene = check_scene(family, given, name)
        assert check_scene(family, json.loads(json.dumps(scene.plain())), name) == scene
        assert SCENES[family](**given) == scene
        assert pickle.loads(pickle.dumps(scene)) == scene
        changed = next(iter(scene.model_fields_set))
        with pytest.raises(ValidationError):
            setattr(scene, changed, None)


def test_arguments_of_a_scene_may_be_those_of_numpy():
    given = driven_scene(beads=20, record={"snapshots": [1.0, 2.0]})
    arguments = given | {"beads": np.int64(20), "record": {"snapshots": np.array([1.0, 2.0])}}
    assert Chain(**arguments) == Chain(**given)
