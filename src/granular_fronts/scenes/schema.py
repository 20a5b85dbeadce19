"""The strict schema of a campaign, and a sentence for each of its violations.

A sentence names the scene, the key, its value, the limit and the way out. What a schema cannot
express, because it ties two keys together, is a check of `sections`.
"""

import difflib
import functools
import json
import math
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import UnionType
from typing import Any

from jsonschema import Draft202012Validator, validators
from jsonschema.exceptions import ValidationError

from granular_fronts.scenes.parts import LARGEST_WHOLE, name_entry
from granular_fronts.scenes.sentences import (
    LONGEST_SHOWN,
    MOST_CHOICES,
    NO_COMMA,
    number_as_text,
)
from granular_fronts.scenes.yaml_files import read_yaml

_KIND = {
    "array": "a list",
    "boolean": "true or false",
    "integer": "a whole number",
    "number": "a number",
    "object": "a mapping of keys to values",
    "string": "text",
}

_LIMITS = {
    "minimum": "below its limit {limit}: give {limit} or more",
    "maximum": "above its limit {limit}: give {limit} or less",
    "exclusiveMinimum": "but must be above {limit}: give a number above {limit}",
    "exclusiveMaximum": "but must be below {limit}: give a number below {limit}",
}
"""Words for a number beyond a limit."""

ABOUT_KEYS = "required", "additionalProperties"
"""Kinds of violations that concern a key inside the value, and not the value as a whole."""


def _is_whole(_checker: object, value: Any) -> bool:
    # JSON Schema also calls 420.0 an integer, but a count of beads is used as an index.
    return _is_plain(value, int) and abs(value) <= LARGEST_WHOLE


def _is_finite(_checker: object, value: Any) -> bool:
    # YAML reads .nan and .inf, and every comparison with a limit lets them pass.
    return _is_plain(value, int | float) and abs(value) <= sys.float_info.max


def _is_plain(value: object, kind: type | UnionType) -> bool:
    return isinstance(value, kind) and not isinstance(value, bool)


_Validator = validators.extend(
    Draft202012Validator,
    type_checker=Draft202012Validator.TYPE_CHECKER.redefine_many(
        {"integer": _is_whole, "number": _is_finite}
    ),
)


def violations(instance: object, schema: str) -> Iterator[str]:
    """Say how a campaign violates the schema ``campaign``."""
    validator = _validator_of(schema)
    definitions = validator.schema["$defs"]
    errors = sorted(validator.iter_errors(instance), key=lambda error: str(error.path))
    for error in errors:
        scene, key = _locate([*error.absolute_path])
        if not key and error.validator not in ABOUT_KEYS:
            scene, key = "", scene.removesuffix(": ") or "the file"
        yield scene + _sentence(error, key, definitions)


@functools.cache
def _validator_of(schema: str) -> Any:
    """Return the validator of a schema."""
    return _Validator(load_schema(schema))


@functools.cache
def load_schema(name: str) -> dict[str, Any]:
    """Return the schema ``campaign``, of which an installed package has a copy in this folder."""
    copy = Path(__file__).with_name(f"{name}.schema.yaml")
    folder = Path(__file__).parents[3].joinpath("workflow", "schemas")
    return read_yaml(copy if copy.exists() else folder / copy.name)


def _locate(path: Sequence[str | int]) -> tuple[str, str]:
    """Split a path into the words that name its scene and its dotted key inside that scene."""
    scene = ""
    if path[:1] == ["scenes"] and len(path) > 2:
        scene, path = f"Scene {path[2]}: ", path[3:]
    key = ""
    for part in path:
        key = name_entry(key, part) if isinstance(part, int) else f"{key}.{part}".lstrip(".")
    return scene, key


def _sentence(error: ValidationError, key: str, definitions: dict) -> str:
    """Say in one sentence what a violation is and how to end it."""
    if "propertyNames" in error.absolute_schema_path:
        return (
            f"{_show(error.instance)} in {key} is no usable name: use lower-case letters, digits "
            "and underscores, 100 at most, a letter first."
        )
    if error.validator == "required":
        return _missing_key(error, key, definitions)
    if error.validator == "additionalProperties":
        return _unknown_key(error, key)
    if error.validator == "type":
        return _wrong_type(error, key)
    value, limit = _show(error.instance), error.validator_value
    if error.validator in _LIMITS:
        return f"{key} is {value}, {_LIMITS[error.validator].format(limit=limit)}."
    if error.validator == "enum":
        return f"{key} is {value}, which is unknown: {_choice(error)}"
    if error.validator == "uniqueItems":
        return _repeated_entry(error, key)
    if error.validator == "minLength":
        return f"{key} is empty: give a name."
    if error.validator in ("minItems", "minProperties") and not error.instance:
        return f"{key} is empty: give at least {'one entry' if limit == 1 else limit}."
    lengths = [error.schema.get(bound) for bound in ("minItems", "maxItems")]
    if lengths == [limit, limit]:
        meaning = error.schema["description"].rstrip(".")
        return f"{key} has {_count(error.instance)}: list {limit} ({meaning})."
    if error.validator == "minItems":
        return f"{key} has {_count(error.instance)}, below its limit {limit}: list {limit} or more."
    if error.validator == "maxItems":
        return f"{key} has {_count(error.instance)}, above its limit {limit}: list {limit} or less."
    return f"{key}: {error.message}."


def _choice(error: ValidationError) -> str:
    """Say which names there are, or of many the one that was probably meant."""
    names = error.validator_value
    near = difflib.get_close_matches(str(error.instance), names, n=1)
    if near and len(names) > MOST_CHOICES:
        return f"did you mean {near[0]}?"
    return f"choose {' or '.join(names)}."


def _count(entries: Sequence) -> str:
    return "1 entry" if len(entries) == 1 else f"{len(entries)} entries"


def _repeated_entry(error: ValidationError, key: str) -> str:
    entries = error.instance
    index = next(i for i, entry in enumerate(entries) if entry in entries[:i])
    return (
        f"{name_entry(key, index)} is {_show(entries[index])}, which is listed twice: list it once."
    )


def _missing_key(error: ValidationError, key: str, definitions: dict) -> str:
    # jsonschema reports each missing key by itself, but names it in its message only.
    missing = next(name for name in error.validator_value if error.message.startswith(f"'{name}'"))
    described = error.schema["properties"][missing]
    if "description" not in described:
        described = definitions[described["$ref"].removeprefix("#/$defs/")]
    meaning = described["description"].rstrip(".")
    return f"{_join(key, missing)} is missing: add it ({meaning})."


def _unknown_key(error: ValidationError, key: str) -> str:
    known = list(error.schema["properties"])
    unknown = [name for name in error.instance if name not in known]
    near = difflib.get_close_matches(str(unknown[0]), known, n=1)
    advice = f"did you mean {near[0]}?" if near else f"the keys here are {', '.join(known)}."
    if _is_plain(unknown[0], int) and error.instance[unknown[0]] is None:
        advice = NO_COMMA
    names = ", ".join(_join(key, name) for name in unknown)
    return f"{names} {'is no key' if len(unknown) == 1 else 'are no keys'} of the schema: {advice}"


def _wrong_type(error: ValidationError, key: str) -> str:
    allowed = error.validator_value
    kinds = [allowed] if isinstance(allowed, str) else allowed
    expected = " or ".join(_KIND[kind] for kind in kinds)
    if not {"number", "integer"}.isdisjoint(kinds) and _is_plain(error.instance, int | float):
        if isinstance(error.instance, int):
            return f"{key} is {_show(error.instance)}, beyond what an array can hold: give less."
        if not math.isfinite(error.instance):
            return f"{key} is {error.instance}, but must be finite: give {expected}."
    if kinds[0] in ("number", "integer"):
        sentence = number_as_text(key, error.instance, kinds == ["integer"])
        if sentence:
            return sentence
    meaning = error.schema.get("description", "").rstrip(".")
    return f"{key} is {_show(error.instance)}: give {expected} instead" + (
        f" ({meaning})." if meaning else "."
    )


def _join(key: str, name: object) -> str:
    return f"{key}.{name}" if key else str(name)


def _show(value: object) -> str:
    text = json.dumps(value, default=str, ensure_ascii=False, skipkeys=True)
    return text if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]} …"
