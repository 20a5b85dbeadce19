"""Studies as ``workflow/studies.yaml`` lists them: each with its section of the configuration.

The same file describes the keys of a section in a short form of JSON Schema, which is expanded
here.
"""

import functools
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from granular_fronts.scenes.yaml_files import read_yaml

_BOUNDS = {
    "minimum": "at least",
    "exclusiveMinimum": "above",
    "maximum": "at most",
    "exclusiveMaximum": "below",
}


def find_file(name: str, *folders: str) -> Path:
    """Return a file of the workflow; an installed package has a copy in this folder."""
    copy = Path(__file__).with_name(name)
    return copy if copy.exists() else Path(__file__).parents[3].joinpath("workflow", *folders, name)


@functools.cache
def studies() -> dict[str, dict[str, Any]]:
    """Return every study of ``workflow/studies.yaml`` by its name."""
    return read_yaml(find_file("studies.yaml"))


def add_sections(schema: dict[str, Any]) -> None:
    """Put the section of each study into the schema of the configuration."""
    for study in studies().values():
        if "parameters" not in study:
            continue
        *parents, name = study["section"].split(".")
        group = functools.reduce(lambda node, key: node["properties"][key], parents, schema)
        group.setdefault("required", []).append(name)
        short = {key: study[key] for key in ("description", "parameters")}
        group.setdefault("properties", {})[name] = _expand(short)


def _expand(short: Mapping[str, Any]) -> dict[str, Any]:
    """Return the JSON Schema of its short form."""
    rules = dict(short)
    if "parameters" in rules:
        parts = {name: _expand(part) for name, part in rules.pop("parameters").items()}
        keys = {"type": "object", "additionalProperties": False, "required": [*parts]}
        return {**keys, **rules, "properties": parts}
    if "entries" in rules:
        entry = _expand(rules.pop("entries"))
        return {"type": "object", "$ref": "#/$defs/named", **rules, "additionalProperties": entry}
    if "list" in rules:
        entry = _expand(rules.pop("list"))
        rules = {"type": "array", "uniqueItems": True, "minItems": 1, "items": entry, **rules}
        return _with_range(rules, entry)
    if rules.keys().isdisjoint(("type", "$ref", "enum")):
        rules["type"] = "number"
    return _with_range(rules, rules)


def _with_range(rules: dict[str, Any], number: Mapping[str, Any]) -> dict[str, Any]:
    """Say the range of a number, or of the entries of a list, in the description of its key."""
    if "description" not in rules or number.get("type") not in ("number", "integer"):
        return rules
    bounds = [f"{words} {number[key]:g}" for key, words in _BOUNDS.items() if key in number]
    kind = "Whole number" if number["type"] == "integer" else "Range" if bounds else "Any number"
    said = " ".join([rules["description"], kind, " and ".join(bounds)]).rstrip()
    return rules | {"description": said + ("." if "(SI)" in said else ", dimensionless.")}
