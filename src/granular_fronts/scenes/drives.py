"""What drives the left end of a chain as a function of time: a force on bead 1, or its velocity.

A drive is cut into pieces between its break points, where it or its slope jumps; `chain.drives` has
their formula.
"""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, NamedTuple

from pydantic import Field

from granular_fronts.scenes.parts import NotNegative, Part, Positive, Several, or_number, say


class Piece(NamedTuple):
    """Part of a drive from the time `start` on: a + b s + c sin(ω s + φ), s the time since then."""

    start: float
    constant: float
    rate: float = 0.0
    amplitude: float = 0.0
    frequency: float = 0.0
    phase: float = 0.0


class Pulse(Part):
    """A constant for some time.  Of a force only, since a velocity does not jump."""

    height: float = Field(description="Value until the end of the pulse, above the offset.")
    duration: Positive = Field(description="Time t at which it ends.")
    offset: float = Field(0.0, description="Constant that is added at all times.")

    def pieces(self) -> list[Piece]:
        """Return the pulse and what follows it."""
        return [Piece(0.0, self.offset + self.height), Piece(self.duration, self.offset)]


class HalfSine(Part):
    """One arch of a sine, a sin(π t/duration), and then nothing."""

    amplitude: float = Field(description="Height a of the arch.")
    duration: Positive = Field(description="Time t at which it ends.")
    offset: float = Field(0.0, description="Constant that is added at all times.")

    def pieces(self) -> list[Piece]:
        """Return the arch and what follows it."""
        arch = Piece(0.0, self.offset, 0.0, self.amplitude, math.pi / self.duration)
        return [arch, Piece(self.duration, self.offset)]


class Harmonic(Part):
    """A sine for ever, a sin(ω t + φ)."""

    amplitude: float = Field(description="Amplitude a.")
    angular_frequency: Positive = Field(description="Angular frequency ω = 2π/period.")
    phase: float = Field(0.0, description="Phase φ in radians.")
    offset: float = Field(0.0, description="Constant that is added at all times.")

    def pieces(self) -> list[Piece]:
        """Return the sine, a single piece."""
        amplitude, frequency = self.amplitude, self.angular_frequency
        return [Piece(0.0, self.offset, 0.0, amplitude, frequency, self.phase)]


class Table(Part):
    """Values at given times, with straight lines between them, and constant before and after."""

    times: Annotated[Several[NotNegative], Field(min_length=2)] = Field(
        description="Times t of the values, which increase."
    )
    values: Several[float] = Field(description="A value for each time.")

    def problems(self) -> Iterator[str]:
        """The table is one of a function of time."""
        if len(self.times) != len(self.values):
            yield (
                f"times has {len(self.times)} entries, but values has {len(self.values)}: give a "
                "value for each time."
            )
        for entry, (before, after) in enumerate(pairwise(self.times), start=2):
            if after <= before:
                yield (
                    f"times (entry {entry}) is {say(after)}, but the one before is {say(before)}: "
                    "give times that increase; a jump takes a short time."
                )
                return

    def pieces(self) -> list[Piece]:
        """Return a straight line between each two points, and what follows the last one."""
        points = list(zip(self.times, self.values, strict=True))
        if self.times[0] > 0.0:
            points.insert(0, (0.0, self.values[0]))
        rising = [Piece(t, v, (w - v) / (end - t)) for (t, v), (end, w) in pairwise(points)]
        return [*rising, Piece(*points[-1])]


class FunctionOfTime(Part):
    """A number, or one function of time."""

    constant: float | None = Field(
        None, description="Value at all times, written as a number in place of the mapping."
    )
    pulse: Pulse | None = None
    half_sine: HalfSine | None = None
    harmonic: Harmonic | None = None
    table: Table | None = None

    def problems(self) -> Iterator[str]:
        """One function is given."""
        given = [name for name, value in self if value is not None]
        if not given:
            yield " is empty: give a number, or pulse, half_sine, harmonic or table."
        elif len(given) > 1:
            yield f" has {' and '.join(given)}: give one of them."

    def pieces(self, ramp: float = 0.0) -> list[Piece]:
        """Return the pieces; a constant may rise from 0 within a ramp."""
        if self.constant is not None:
            end = Piece(ramp, self.constant)
            return [Piece(0.0, 0.0, self.constant / ramp), end] if ramp else [end]
        functions = (self.pulse, self.half_sine, self.harmonic, self.table)
        return next(one for one in functions if one is not None).pieces()


Drive = Annotated[FunctionOfTime, or_number("constant", float | FunctionOfTime)]
