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


@pytest.fixture(params=["config", "campaign", "referee"])
def schema(request):
    file = SCHEMA.with_name(f"{request.param}.schema.yaml")
    return yaml.safe_load(file.read_text(encoding="utf-8"))


@pytest.fixture
def of_configuration():
    return yaml.safe_load(SCHEMA.read_text(encoding="utf-8"))


def description(node, schema):
    """What is said of a node, or of the definition that it refers to."""
    steps = node.get("$ref", "#").split("/")[1:]
    referred = functools.reduce(operator.getitem, steps, schema) if steps else {}
    return node.get("description") or referred.get("description", "")


def test_schema_describes_every_key(schema):
    undescribed = [
        f"{path}.{name}"
        for path, node in schema_nodes(schema)
        for name, child in node.get("properties", {}).items()
        if not description(child, schema)
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
        if "properties" in node and "allOf" not in node and "potential" not in path:
            assert node.get("additionalProperties") is False, path


@pytest.mark.parametrize("place", POTENTIALS)
def test_schema_describes_every_kind_of_potential(of_configuration, place):
    name = place.removeprefix("schema.")
    description = of_configuration["$defs"][name]["properties"]["kind"]["description"]
    known = ELASTIC if name == "elastic_potential" else VISCOUS
    for kind, described in known.items():
        assert kind in description
        assert all(parameter in description for parameter in described.parameters), kind
    assert name == "elastic_potential" or all(kind in description for kind in DEPENDENT)


def test_keys_that_may_be_left_out_and_no_others_are_called_optional(schema):
    for path, node in schema_nodes(schema):
        if "allOf" in node:
            continue
        for name, child in node.get("properties", {}).items():
            optional = "Optional" in description(child, schema)
            assert optional == (name not in node.get("required", [])), f"{path}.{name}"


def test_default_shows_every_optional_key_of_a_heteroclinic_scene(of_configuration, default):
    scene = default["scenes"]["heteroclinic"]["front_profiles"]
    assert scene.keys() == of_configuration["$defs"]["heteroclinic_scene"]["properties"].keys()


def test_default_shows_every_optional_key(of_configuration, default):
    record = default["scenes"]["chain"][SCENE]["record"]
    chain = of_configuration["$defs"]["chain_scene"]
    assert record.keys() == chain["properties"]["record"]["properties"].keys()
