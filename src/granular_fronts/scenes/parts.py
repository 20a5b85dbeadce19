"""What a user may ask for, in typed and frozen parts, and the types of their keys.

A part lists its keys, each with type, range, default and meaning.  What ties keys together is its
method `problems`, a generator of sentences that begin with a key.
"""

from collections.abc import Iterable, Iterator, Mapping, Sized
from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

LARGEST_WHOLE = 2**63 - 1
"""Largest whole number that an array can hold."""


def _first_paragraph(schema: dict[str, Any]) -> None:
    """Leave out of a schema's description what is about Python."""
    schema["description"] = schema["description"].partition("\n\n")[0]


class Part(BaseModel):
    """A mapping of known keys, none of which is set again."""

    model_config = ConfigDict(
        extra="forbid",
        frozen=True,
        strict=True,
        allow_inf_nan=False,
        arbitrary_types_allowed=True,
        json_schema_extra=_first_paragraph,
    )

    def problems(self) -> Iterator[str]:
        """Say what is wrong with keys that are possible one by one; those inside are right."""
        yield from ()

    def plain(self) -> dict[str, Any]:
        """Return what a file would hold: what was given, in numbers, texts, lists and mappings."""
        return self.model_dump(mode="json", exclude_unset=True)

    def __repr_args__(self) -> Iterable[tuple[str, Any]]:
        """Show what was given."""
        return self.plain().items()


def all_problems(value: object, key: str = "") -> Iterator[str]:
    """Say what is wrong with all parts inside a value; a part relies on those that it holds."""
    items: Iterable[tuple[Any, Any]] = ()
    if isinstance(value, Part):
        items = [(name, getattr(value, name)) for name in type(value).model_fields]
    elif isinstance(value, dict):
        items = value.items()
    found = [
        sentence for name, inside in items for sentence in all_problems(inside, join(key, name))
    ]
    yield from found
    if isinstance(value, Part) and not found:
        for sentence in value.problems():
            # A sentence on the whole part begins with a blank.
            yield f"{key}{sentence}".lstrip() if sentence[0] == " " else join(key, sentence)


def join(key: str, rest: object) -> str:
    """Return a dotted key."""
    return f"{key}.{rest}" if key else str(rest)


def name_entry(key: str, index: int) -> str:
    """Name an entry of a list as people count, for example ``record.snapshots (entry 1)``."""
    return f"{key} (entry {index + 1})"


def count(entries: Sized) -> str:
    """Return how many entries there are, in words."""
    return "1 entry" if len(entries) == 1 else f"{len(entries)} entries"


def say(number: float) -> str:
    """Return a number as people write it, a whole one without its point."""
    return repr(number).removesuffix(".0")


def _listed(values: Any) -> Any:
    """Take a list, as files have them, but no set and no generator."""
    return tuple(values) if isinstance(values, list) else values


def _paired(values: Any) -> Any:
    """Take a list of two."""
    values = _listed(values)
    if isinstance(values, tuple) and len(values) != 2:
        raise PydanticCustomError("sentence", f"{{key}} has {count(values)}: list 2.")
    return values


def _distinct(values: tuple) -> tuple:
    for index, value in enumerate(values):
        if value in values[:index]:
            raise PydanticCustomError("repeated", "", {"index": index, "value": value})
    return values


def or_number(key: str, written: Any) -> BeforeValidator:
    """Let a number stand for a mapping with this key; `written` is what a file may hold."""
    return BeforeValidator(
        lambda v: v if isinstance(v, Mapping | Part) else {key: v}, json_schema_input_type=written
    )


def one_or_more(one: Any) -> BeforeValidator:
    """Let a single part stand for a list of one."""
    return BeforeValidator(
        lambda v: [v] if isinstance(v, Mapping | Part) else v,
        json_schema_input_type=one | list[one],
    )


Value = TypeVar("Value")
Several = Annotated[tuple[Value, ...], BeforeValidator(_listed)]
Distinct = Annotated[
    tuple[Value, ...],
    BeforeValidator(_listed),
    AfterValidator(_distinct),
    Field(json_schema_extra={"uniqueItems": True}),
]
Listed = Annotated[Distinct[Value], Field(min_length=1)]
Pair = Annotated[tuple[Value, Value], BeforeValidator(_paired)]

Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
Whole = Annotated[int, Field(ge=-LARGEST_WHOLE, le=LARGEST_WHOLE)]
Place = Annotated[Whole, Field(ge=1)]
Name = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]{0,99}$")]
Named = Annotated[
    dict[Name, Value], Field(min_length=1, json_schema_extra={"additionalProperties": False})
]


class Interval(Part):
    """What lies between a start and a stop."""

    start: float = Field(description="First point.")
    stop: float = Field(description="Last point, after the first.")

    def problems(self) -> Iterator[str]:
        """The start comes before the stop."""
        if self.start >= self.stop:
            yield (
                f"start is {say(self.start)}, but must come before its stop {say(self.stop)}: "
                "lower start or raise stop."
            )


class Range(Interval):
    """Points from a start to a stop, in equal steps."""

    step: Positive = Field(description="Distance of two points.")

    @property
    def points(self) -> float:
        """Number of steps."""
        return (self.stop - self.start) / self.step

    def problems(self) -> Iterator[str]:
        """The range grows, and holds a step."""
        yield from [*super().problems()] or step_problems(
            self.step, self.stop - self.start, "from start to stop"
        )


class Times(Range):
    """Times at which something is sampled."""

    start: NotNegative = Field(description="Time t of the first sample.")
    stop: Positive = Field(description="Time t of the last sample, after the first.")
    step: Positive = Field(description="Time between two samples.")


def step_problems(step: float, length: float, limits: str) -> Iterator[str]:
    """No step is longer than the range that it divides."""
    if step > length:
        yield (
            f"step is {say(step)}, longer than the range of {length:g} that it divides "
            f"({limits}): give {length:g} or less."
        )
