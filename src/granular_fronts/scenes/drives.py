"""What drives the left end of a chain as a function of time: a force on bead 1, or its velocity.

A drive is a number, or a mapping with one of the keys of `_PIECES`.  It is cut into pieces between
its break points, where it or its slope jumps; `chain.drives` has their formula.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from typing import Any, NamedTuple


class Piece(NamedTuple):
    """Part of a drive from the time `start` on: a + b s + c sin(ω s + φ), s the time since then."""

    start: float
    constant: float
    rate: float = 0.0
    amplitude: float = 0.0
    frequency: float = 0.0
    phase: float = 0.0


def key_of_drive(boundary: Mapping[str, Any]) -> str | None:
    """Return which key of a boundary drives its left end, `force` or `velocity`, or None."""
    return next((key for key in ("force", "velocity") if key in boundary), None)


def pieces_of(boundary: Mapping[str, Any]) -> list[Piece]:
    """Return the pieces of the drive of a boundary, none if its left end is held."""
    key = key_of_drive(boundary)
    if key is None:
        return []
    drive = boundary[key]
    if isinstance(drive, Mapping):
        [(kind, given)] = drive.items()
        return _PIECES[kind](**given)
    ramp = float(boundary.get("ramp", 0.0))
    return _table([0.0, ramp], [0.0, drive]) if ramp else [Piece(0.0, float(drive))]


def largest_of(boundary: Mapping[str, Any]) -> float:
    """Return a bound of the size of a drive; a piece of a slope ends where the next begins."""
    return max((abs(p.constant) + abs(p.amplitude) for p in pieces_of(boundary)), default=0.0)


def value_at_start(boundary: Mapping[str, Any]) -> float:
    """Return the value of a drive at t = 0."""
    first = pieces_of(boundary)[0]
    return first.constant + first.amplitude * math.sin(first.phase)


def drive_errors(section: Mapping[str, Any]) -> Iterator[str]:
    """Say why the drive of a section, if it has one, is impossible."""
    boundary = section.get("boundary", {})
    key = key_of_drive(boundary)
    drive = boundary.get(key)
    if key == "force" and "left" in boundary:
        yield "boundary has left and force, but one of them presses the left end: leave one out."
    if not isinstance(drive, Mapping):
        return
    place = f"boundary.{key}"
    if len(drive) > 1:
        yield f"{place} has {' and '.join(drive)}: give one of them."
    if "ramp" in boundary:
        yield f"boundary.ramp is given, but {place} is a function of time: leave ramp out."
    if key == "velocity" and "pulse" in drive:
        yield (
            f"{place}.pulse jumps, which takes an infinite force: give half_sine, or a table in "
            "which the velocity falls over some time."
        )
    if "table" in drive:
        yield from _table_errors(f"{place}.table", **drive["table"])


def _table_errors(place: str, times: list, values: list) -> Iterator[str]:
    """Say why a table is none of a function of time."""
    if len(times) != len(values):
        yield (
            f"{place}.times has {len(times)} entries, but values has {len(values)}: give a value "
            "for each time."
        )
    for entry, (before, after) in enumerate(pairwise(times), start=2):
        if after <= before:
            yield (
                f"{place}.times (entry {entry}) is {after}, but the one before is {before}: give "
                "times that increase; a jump takes a short time."
            )
            return


def _pulse(height: float, duration: float, offset: float = 0.0) -> list[Piece]:
    return [Piece(0.0, offset + height), Piece(duration, offset)]


def _half_sine(amplitude: float, duration: float, offset: float = 0.0) -> list[Piece]:
    arch = Piece(0.0, offset, 0.0, amplitude, math.pi / duration)
    return [arch, Piece(duration, offset)]


def _harmonic(
    amplitude: float, angular_frequency: float, phase: float = 0.0, offset: float = 0.0
) -> list[Piece]:
    return [Piece(0.0, offset, 0.0, amplitude, angular_frequency, phase)]


def _table(times: list, values: list) -> list[Piece]:
    """Return straight lines between the points; before and after them the drive is constant."""
    points = list(zip(times, values, strict=True))
    if times[0] > 0.0:
        points.insert(0, (0.0, values[0]))
    rising = [Piece(t, v, (w - v) / (end - t)) for (t, v), (end, w) in pairwise(points)]
    return [*rising, Piece(*points[-1])]


_PIECES: dict[str, Callable[..., list[Piece]]] = {
    "pulse": _pulse,
    "half_sine": _half_sine,
    "harmonic": _harmonic,
    "table": _table,
}
