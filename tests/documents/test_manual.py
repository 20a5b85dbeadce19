"""What the manual makes of the code: every public name and every key of the configuration."""

import inspect
import re

import pytest
import yaml
from pages import load_script
from projects import ROOT

import granular_fronts as gf
from granular_fronts.scenes.schema import load_schema

SCHEMA = load_schema("config")


PAGES = load_script("generate")


def test_every_public_name_has_an_entry():
    page = PAGES.public_names()
    for name in gf.__all__:
        found = getattr(gf, name)
        home = found.__name__ if inspect.ismodule(found) else f"{found.__module__}.{name}"
        assert f"\n## {name}\n" in page
        assert f":: {home}\n" in page


def paths_of(value, path=""):
    """Keys of a configuration joined by dots, … for the entries of a list."""
    if isinstance(value, dict):
        for key, below in value.items():
            longer = f"{path}.{key}".removeprefix(".")
            yield longer
            yield from paths_of(below, longer)
    elif isinstance(value, list):
        for below in value:
            yield from paths_of(below, f"{path}.…")


def pattern(described):
    return re.escape(described).replace(re.escape("⟨name⟩"), r"\w+")


def test_every_key_of_the_default_configuration_is_described():
    described = {path for path, text in PAGES.keys(SCHEMA, SCHEMA) if text}
    configuration = yaml.safe_load((ROOT / "config" / "default.yaml").read_text(encoding="utf-8"))
    known = re.compile("|".join(pattern(path) for path in described))
    given = set(paths_of(configuration))
    assert {path for path in given if not known.fullmatch(path)} == set()
    assert not known.fullmatch("scenes.unheard_of")


def test_a_definition_that_contains_itself_is_listed_once():
    schema = {
        "$defs": {
            "node": {
                "description": "A node.",
                "properties": {"next": {"description": "The next.", "$ref": "#/$defs/node"}},
            }
        },
        "properties": {"first": {"$ref": "#/$defs/node"}},
    }
    assert list(PAGES.keys(schema, schema)) == [("first", "A node."), ("first.next", "The next.")]


def test_the_manual_needs_results(tmp_path):
    with pytest.raises(SystemExit, match="run make first"):
        PAGES.write_pages(tmp_path / "generated", tmp_path)
    assert not (tmp_path / "generated").exists()
