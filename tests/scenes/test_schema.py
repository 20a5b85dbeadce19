"""The schemas describe every key, and let no other pass; a user's errors quote them."""

import re

import pytest
from configurations import DEFAULT, SCENE

from granular_fronts.scenes.schema import load_schema
from granular_fronts.scenes.yaml_files import load_configuration

SCHEMAS = {name: load_schema(name) for name in ("config", "campaign", "referee")}


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


@pytest.mark.parametrize(
    ("family", "name", "part", "definition", "elsewhere"),
    [
        ("heteroclinic", "front_profiles", None, "heteroclinic_scene", set()),
        # No figure of the paper shows forces of contacts; campaigns of the project record them.
        ("chain", SCENE, "record", "chain_scene", {"sensors"}),
    ],
)
def test_default_shows_every_optional_key(family, name, part, definition, elsewhere):
    shown = load_configuration(DEFAULT)["scenes"][family][name]
    known = SCHEMAS["config"]["$defs"][definition]["properties"]
    if part:
        shown, known = shown[part], known[part]["properties"]
    assert shown.keys() | elsewhere == known.keys()
