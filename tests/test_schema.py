"""The schema of the configuration describes every key, and the default configuration shows them."""

import functools
import operator
import re

import pytest
import yaml
from configurations import DEFAULT, ROOT, SCENE

from granular_fronts.model.kinds import ELASTIC, VISCOUS
from granular_fronts.model.laws import DEPENDENT
from granular_fronts.scenes.yaml_files import load_configuration

SCHEMA = ROOT / "workflow" / "schemas" / "config.schema.yaml"


@pytest.fixture
def default():
    return load_configuration(DEFAULT)


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


POTENTIALS = ("schema.elastic_potential", "schema.viscous_potential")


def test_schema_is_strict_at_every_level(schema):
    """But for potentials, whose kinds and parameters `model.kinds` lists."""
    for path, node in schema_nodes(schema):
        if "properties" in node and "allOf" not in node and path not in POTENTIALS:
            assert node.get("additionalProperties") is False, path


@pytest.mark.parametrize("place", POTENTIALS)
def test_schema_describes_every_kind_of_potential(schema, place):
    name = place.removeprefix("schema.")
    description = schema["$defs"][name]["properties"]["kind"]["description"]
    known = ELASTIC if name == "elastic_potential" else VISCOUS
    for kind, described in known.items():
        assert kind in description
        assert all(parameter in description for parameter in described.parameters), kind
    assert name == "elastic_potential" or all(kind in description for kind in DEPENDENT)


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
