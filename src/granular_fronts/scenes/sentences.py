"""From a mapping to a part, or to a sentence for each violation: key, value, limit and way out."""

import difflib
import json
import math
import re
from collections.abc import Iterator, Mapping
from types import UnionType
from typing import Annotated, Any, Literal, Self, TypeVar, Union, get_args, get_origin

import yaml
from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from granular_fronts.errors import InputError
from granular_fronts.scenes.parts import (
    LARGEST_WHOLE,
    Part,
    all_problems,
    count,
    join,
    name_entry,
    say,
)

LONGEST_SHOWN = 60
"""Letters of a value that a sentence quotes."""

MOST_CHOICES = 12
"""Names that a sentence lists even if one of them is close to an unknown one."""

NO_COMMA = "a number has no comma: write a point before its decimals."
"""About a decimal comma; in braces it ends one key and begins another, without a value."""

WANTED = {
    "float_type": "a number",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "string_type": "text",
    "tuple_type": "a list",
    "dict_type": "a mapping of keys to values",
    "model_type": "a mapping of keys to values",
    "model_attributes_type": "a mapping of keys to values",
}

LIMITS = {
    "greater_than": "but must be above {gt}: give a number above {gt}",
    "greater_than_equal": "below its limit {ge}: give {ge} or more",
    "less_than": "but must be below {lt}: give a number below {lt}",
    "less_than_equal": "above its limit {le}: give {le} or less",
    "multiple_of": "no multiple of {multiple_of}: give a multiple of {multiple_of}",
}
"""Words for a number beyond a limit."""

AnyPart = TypeVar("AnyPart", bound=Part)


def read_part(kind: type[AnyPart], given: object, label: str = "") -> AnyPart:
    """Return the part that a mapping gives, or one that is made already.

    An InputError has a sentence for each thing that is wrong, which begins with the label, for
    example ``Scene weak: ``.
    """
    if isinstance(given, kind):
        return given
    given = _plain(given)
    if not isinstance(given, Mapping):
        name = label.removesuffix(": ") or "the file"
        raise InputError(f"{name} is {_show(given)}: give a mapping of keys to values instead.")
    try:
        part = kind.model_validate(given)
    except ValidationError as error:
        found = [*_sentences(error, kind, given)]
    else:
        found = [*all_problems(part)]
        if not found:
            return part
    raise InputError("\n".join(f"{label}{sentence}" for sentence in found)) from None


class Scene(Part):
    """A part that stands for itself, so that making one says what is wrong in our sentences."""

    def __init__(self, /, **given: Any) -> None:
        self.__setstate__(read_part(type(self), given).__getstate__())

    # Pydantic itself makes scenes without it: `read_part` has sentences of its own.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @classmethod
    def read(cls, given: object, name: str = "given") -> Self:
        """Return the scene of a mapping, or a scene itself; an InputError calls it by its name."""
        return read_part(cls, given, f"Scene {name}: ")


class _Place:
    """A place inside what was given, and what the parts say of it."""

    def __init__(self, root: type[Part], given: object) -> None:
        self.kind: Any = root
        self.given = given
        self.key = ""
        self.part: type[Part] = root
        self.field: FieldInfo | None = None
        self.beyond = False  # Whether the place is in what a number or a mapping stands for.

    def enter(self, step: str | int) -> None:
        """Go one step of a location of pydantic, which may be the tag of a union."""
        kind = _bare(self.kind)
        while get_origin(kind) in (Union, UnionType):
            choices = [one for one in map(_bare, get_args(kind)) if one is not type(None)]
            tagged = [one for one in choices if step in _tags(one)]
            if tagged or str(step).startswith("<"):
                self.kind = tagged[0] if tagged else _member(kind, str(step))
                if isinstance(self.kind, type) and issubclass(self.kind, Part):
                    self.part = self.kind
                return
            kind = choices[0]
        if isinstance(kind, type) and issubclass(kind, Part):
            self.part = kind
            self.field = kind.model_fields.get(str(step))
            self.kind = self.field.annotation if self.field else None
        elif get_origin(kind) is dict:
            self.kind = get_args(kind)[1]
        elif get_origin(kind) is tuple:
            self.kind = get_args(kind)[0]
        if not self.beyond:
            self._enter_given(step)

    def _enter_given(self, step: str | int) -> None:
        """Go the same step in what was given."""
        is_list = isinstance(self.given, list | tuple)
        if isinstance(step, int) and is_list and step < len(self.given):  # type: ignore[arg-type]
            self.key, self.given = name_entry(self.key, step), self.given[step]  # type: ignore[index]
        elif isinstance(step, int) and isinstance(self.given, Mapping) and step not in self.given:
            return  # A mapping stands for a list of one.
        elif isinstance(self.given, Mapping) and step != "[key]":
            self.key, self.given = join(self.key, step), self.given.get(step)
        else:
            self.beyond = True

    @property
    def meaning(self) -> str:
        """What a field says of itself, or the part that it holds."""
        words = self.field.description if self.field else None
        kind = _bare(self.field.annotation) if self.field else None
        words = words or (isinstance(kind, type) and kind.__doc__) or ""
        return f" ({' '.join(words.split()).rstrip('.')})" if words else ""


def _member(union: Any, tag: str) -> Any:
    """Return the member of a union with a tag of `pydantic.Tag`."""
    for one in get_args(union):
        notes = one.__metadata__ if get_origin(one) is Annotated else ()
        if any(getattr(note, "tag", None) == tag for note in notes):
            return _bare(one)
    return None


def _bare(kind: Any) -> Any:
    """Return a type without notes and without None."""
    while get_origin(kind) is Annotated:
        kind = get_args(kind)[0]
    choices = [one for one in get_args(kind) if one is not type(None)]
    if get_origin(kind) in (Union, UnionType) and len(choices) == 1:
        return _bare(choices[0])
    return kind


def _tags(kind: Any) -> tuple:
    """Return the values of `kind` by which a union recognises a part."""
    is_part = isinstance(kind, type) and issubclass(kind, Part)
    field = kind.model_fields.get("kind") if is_part else None
    return get_args(field.annotation) if field and get_origin(field.annotation) is Literal else ()


def _sentences(error: ValidationError, root: type[Part], given: object) -> Iterator[str]:
    errors = error.errors(include_url=False)
    nested = set()
    for details in errors:
        if isinstance(details["input"], list) and isinstance(details["loc"][-1], int):
            # Entries that are lists, as a column has them, are one mistake.
            if details["loc"][:-1] in nested:
                continue
            nested.add(details["loc"][:-1])
        inside = [one for one in errors if one["loc"][: len(details["loc"])] == details["loc"]]
        if details["type"] == "too_short" and len(inside) > 1:
            continue  # Entries that are wrong themselves do not count for pydantic.
        place = _Place(root, given)
        for step in details["loc"]:
            place.enter(step)
        yield _sentence(details, place)


def _sentence(details: ErrorDetails, place: _Place) -> str:
    kind, value, limits = details["type"], details["input"], details.get("ctx", {})
    key = place.key
    if kind == "missing":
        return f"{key} is missing: add it{place.meaning}."
    if kind in ("extra_forbidden", "invalid_key"):
        return _unknown_key(key, details, place)
    if kind in ("union_tag_not_found", "union_tag_invalid"):
        return _unknown_kind(place, limits)
    if kind == "literal_error":
        choices = re.findall("'([^']*)'", limits["expected"])
        return f"{key} is {_show(value)}, which is unknown: {_choice(value, choices)}"
    if kind == "string_pattern_mismatch" or details["loc"][-1:] == ("[key]",):
        return (
            f"{_show(value)} in {key.removesuffix(f'.{value}')} is no usable name: use lower-case "
            "letters, digits and underscores, 100 at most, a letter first."
        )
    wants_number = "number" in WANTED.get(kind, "a number")
    if wants_number and isinstance(value, float) and not math.isfinite(value):
        return f"{key} is {value}, but must be finite: give {WANTED.get(kind, 'a number')}."
    if kind == "repeated":
        entry, index = name_entry(key, limits["index"]), limits["index"]
        return f"{entry} is {_show(place.given[index])}, which is listed twice: list it once."  # type: ignore[index]
    if kind == "sentence":
        return details["msg"].replace("{key}", key)
    if kind in ("too_short", "string_too_short") and not value:
        least = limits["min_length"]
        wanted = "a name" if kind[0] == "s" else "at least "
        return f"{key} is empty: give {wanted}{_least(least) if kind[0] == 't' else ''}."
    if kind == "too_short":
        least = limits["min_length"]
        return f"{key} has {count(value)}, below its limit {least}: list {least} or more."
    if kind == "too_long":
        most = limits["max_length"]
        return f"{key} has {count(value)}, above its limit {most}: list {most} or less."
    is_within = kind not in LIMITS or LARGEST_WHOLE in map(abs, limits.values())
    if wants_number and is_within and _is_huge(value):
        return f"{key} is {_show(value)}, beyond what an array can hold: give less."
    if kind in LIMITS:
        limits = {name: f"{limit:.15g}" for name, limit in limits.items()}
        return f"{key} is {_show(value)}, {LIMITS[kind].format(**limits)}."
    if kind in WANTED:
        return _wrong_type(key, value, WANTED[kind], place)
    return f"{key}: {details['msg']}."


def _least(number: int) -> str:
    return "one entry" if number == 1 else str(number)


def _unknown_key(key: str, details: ErrorDetails, place: _Place) -> str:
    name, known = details["loc"][-1], [*place.part.model_fields]
    near = difflib.get_close_matches(str(name), known, n=1)
    advice = f"did you mean {near[0]}?" if near else f"the keys here are {', '.join(known)}."
    if isinstance(name, int):
        advice = NO_COMMA
    return f"{key} is no key of the schema: {advice}"


def _unknown_kind(place: _Place, limits: Mapping) -> str:
    """Say which kinds there are; a union knows its parts by the key `kind`."""
    kinds = [tag for one in get_args(_bare(place.kind)) for tag in _tags(_bare(one))]
    key = join(place.key, "kind")
    if "tag" not in limits:
        return f"{key} is missing: add it, one of {', '.join(kinds)}."
    return f"{key} is {_show(limits['tag'])}, which is unknown: {_choice(limits['tag'], kinds)}"


def _wrong_type(key: str, value: object, wanted: str, place: _Place) -> str:
    if "number" in wanted and (sentence := number_as_text(key, value, "whole" in wanted)):
        return sentence
    return f"{key} is {_show(value)}: give {wanted} instead{place.meaning}."


def number_as_text(key: str, value: object, is_whole: bool) -> str | None:
    """Say how to write a number that YAML reads as text, or a whole one that it reads as a float.

    None is returned for any other value.
    """
    meant = _number_meant(str(value), is_whole) if isinstance(value, str | float) else None
    if isinstance(value, str) and re.search(r"\d,\d", value):
        advice = f"a number has no comma but a point: write {meant}." if meant else NO_COMMA
        return f"{key} is {_show(value)}, but {advice}"
    if meant is None:
        return None
    if isinstance(value, float):
        why = "which has a point or an exponent, but must be whole"
    elif not isinstance(yaml.safe_load(value), str):
        why = "which its quotes make text"
    elif "e" in str(value).lower():
        why = "which YAML reads as text because a number with an exponent needs a point and a sign"
    else:
        why = "which YAML reads as text"
    return f"{key} is {_show(value)}, {why}: write {meant}."


def _number_meant(text: str, is_whole: bool) -> str | None:
    """Return a finite number as YAML 1.1 reads it; None for any other text."""
    text = text.replace("\N{MINUS SIGN}", "-")
    if not re.search(r",\d{3}\b", text):  # 1,000 may be one or a thousand.
        text = text.replace(",", ".")
    numerator, _, denominator = text.partition("/")
    try:
        number = float(numerator) / float(denominator or "1")
    except (ValueError, ArithmeticError):
        return None
    if is_whole:
        is_possible = number.is_integer() and abs(number) <= LARGEST_WHOLE
        return str(int(number)) if is_possible else None
    if not math.isfinite(number):
        return None
    mantissa, _, exponent = say(number).partition("e")
    if not exponent:
        return mantissa
    return f"{mantissa if '.' in mantissa else f'{mantissa}.0'}e{int(exponent):+d}"


def _choice(value: object, names: list[str]) -> str:
    """Say which names there are, or of many the one that was probably meant."""
    near = difflib.get_close_matches(str(value), names, n=1)
    if near and len(names) > MOST_CHOICES:
        return f"did you mean {near[0]}?"
    return f"choose {' or '.join(names)}."


def _is_huge(value: object) -> bool:
    return isinstance(value, int) and abs(value) > LARGEST_WHOLE


def _show(value: object) -> str:
    text = json.dumps(value, default=str, ensure_ascii=False, skipkeys=True)
    return text if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]} …"


def _plain(value: Any) -> Any:
    """Turn numpy values and mappings into what YAML would have given."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        return value.tolist()
    return [_plain(item) for item in value] if isinstance(value, list | tuple) else value
