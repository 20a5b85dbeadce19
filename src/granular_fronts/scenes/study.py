"""Studies as ``workflow/studies.yaml`` lists them: each with its section of the configuration.

What the keys of a section may be stands there too, in a short form of JSON Schema that is expanded
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
    """A file of the workflow, of which an installed package carries a copy beside this module."""
    copy = Path(__file__).with_name(name)
    return copy if copy.exists() else Path(__file__).parents[3].joinpath("workflow", *folders, name)


@functools.cache
def studies() -> dict[str, dict[str, Any]]:
    """Every study of ``workflow/studies.yaml`` by its name."""
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
    """The JSON Schema of its short form."""
    if "parameters" in short:
        parts = {name: _expand(part) for name, part in short["parameters"].items()}
        keys = {"type": "object", "additionalProperties": False, "required": [*parts]}
        return {**keys, "description": short["description"], "properties": parts}
    rules = dict(short)
    numbers = rules
    if "entries" in rules:
        rules["additionalProperties"] = _expand(rules.pop("entries"))
        return {"type": "object", "$ref": "#/$defs/named", **rules}
    if "list" in rules:
        numbers = _expand(rules.pop("list"))
        rules = {"type": "array", "uniqueItems": True, "minItems": 1, "items": numbers, **rules}
    elif rules.keys().isdisjoint(("type", "$ref", "enum")):
        rules["type"] = "number"
    if numbers.get("type") in ("number", "integer") and "description" in rules:
        rules["description"] += f" {_range(numbers)}"
        rules["description"] += "." if "(SI)" in rules["description"] else ", dimensionless."
    return rules


def _range(number: Mapping[str, Any]) -> str:
    """The range of a number in words, for example ``Range above 0 and at most 1``."""
    bounds = [f"{words} {number[key]:g}" for key, words in _BOUNDS.items() if key in number]
    kind = "Whole number" if number["type"] == "integer" else "Range" if bounds else "Any number"
    return " ".join([kind, " and ".join(bounds)]).rstrip()
