"""What ties keys of a campaign together, which its schema cannot say."""

from collections.abc import Iterator, Mapping
from typing import Any


def ranges_increase(section: Mapping) -> Iterator[str]:
    """Every range starts before it stops."""
    for key, mapping in _mappings(section):
        start: Any = mapping.get("start")
        stop: Any = mapping.get("stop")
        if None not in (start, stop) and start >= stop:
            yield (
                f"{key}.start is {start}, but must come before its stop {stop}: lower start or "
                "raise stop."
            )


def _mappings(value: object, key: str = "") -> Iterator[tuple[str, Mapping]]:
    """Every mapping inside a value, with its dotted key."""
    if isinstance(value, Mapping):
        yield key, value
        for name, item in value.items():
            yield from _mappings(item, f"{key}.{name}" if key else name)
