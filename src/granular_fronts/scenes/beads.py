"""Beads and contacts, and patterns of what varies along a chain.

A pattern gives one factor for each bead or contact of a chain.  It is a number for all of them, or
a mapping whose keys multiply.  A `cell` repeats a list, and a `taper` grows by a ratio or a
difference from one to the next.  A draw that is `random` lies between 1 − spread and 1 + spread,
and a `list` names all.  An `impurity` then replaces a single value.  `chain.patterns` evaluates it.

Beads may be spheres of materials instead, by a `cell` or `list` of words such as ``steel 9.5 mm``.
Then :math:`m_n` is in units of the first mass.  The factor of contact n is its stiffness over that
of two spheres like the first one (`model.materials`).
"""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field
from pydantic_core import PydanticCustomError

from granular_fronts.errors import InputError
from granular_fronts.model.materials import Body, body_of, hertz_stiffness
from granular_fronts.scenes.parts import (
    Part,
    Place,
    Positive,
    Several,
    Whole,
    one_or_more,
    or_number,
    say,
)

MOST_DECADES = 6
"""Decades on either side of 1 of a mass or a factor.  Light beads are fast, and set the steps."""


class Taper(Part):
    """Growth from each value to the next."""

    ratio: Positive = Field(1.0, description="Factor from one to the next.")
    difference: float = Field(0.0, description="Number added from one to the next.")

    def problems(self) -> Iterator[str]:
        """Something grows."""
        if not self.model_fields_set:
            yield " is empty: give ratio or difference."


class Random(Part):
    """Independent factors, uniform between 1 − spread and 1 + spread."""

    spread: Annotated[float, Field(gt=0, lt=1)] = Field(description="Half of the width.")
    seed: Annotated[Whole, Field(ge=0)] = Field(description="Number that sets the draw.")


class BeadWithMass(Part):
    """One bead with another mass."""

    bead: Place = Field(description="Number n of the bead, 1 to N.")
    mass: Positive = Field(description="Its mass.")

    @property
    def place_and_value(self) -> tuple[int, float]:
        """Number of the bead and its mass."""
        return self.bead, self.mass


class ContactWithFactor(Part):
    """One contact with another factor."""

    contact: Place = Field(description="Number n of the contact.")
    factor: Positive = Field(description="Its factor.")

    @property
    def place_and_value(self) -> tuple[int, float]:
        """Number of the contact and its factor."""
        return self.contact, self.factor


class Pattern(Part):
    """A number for each bead or contact, the product of what its keys give."""

    cell: Annotated[Several[Positive], Field(min_length=1)] | None = Field(
        None, description="Values repeated along the chain, for example [1, 0.3]."
    )
    taper: Taper | None = None
    random: Random | None = None
    list: Several[Positive] | None = Field(None, description="One value for each.")

    @property
    def is_one(self) -> bool:
        """Whether all values are 1."""
        return not self.model_fields_set or (
            self.cell == (1.0,) and self.model_fields_set == {"cell"}
        )

    def placed(self) -> dict[int, float]:
        """Return the values of impurities by their places."""
        return {}

    def problems_along(self, count: int, is_ring: bool) -> Iterator[str]:
        """Say what is wrong with the pattern for `count` values."""
        cell, taper = self.cell or (1.0,), self.taper or Taper()
        if is_ring and count % len(cell):
            yield (
                f"cell has {len(cell)} values, but a ring of {count} has no whole number of such "
                f"cells: take {count - count % len(cell) or len(cell)} beads."
            )
        if is_ring and self.taper:
            yield "taper is given, but a ring has no end: give a cell or a list."
        last = 1.0 + taper.difference * (count - 1)
        if last <= 0.0:
            yield (
                f"taper.difference is {say(taper.difference)}, with which value {count} is "
                f"{last:g}: give more than {-1.0 / (count - 1):.3g}."
            )
            return
        for place in sorted(self.placed()):
            if place > count:
                yield f"impurity is at {place}, but there are {count}: give 1 to {count}."
        if self.list is not None and len(self.list) != count:
            yield f"list has {len(self.list)} values, but there are {count}: give one each."
        furthest = self._decades(taper.ratio, last, count)
        if furthest > MOST_DECADES:
            yield (
                f" comes to 1e±{furthest:.0f}, beyond the 1e±{MOST_DECADES} that a chain can "
                "follow: bring its values nearer to 1."
            )

    def _decades(self, ratio: float, last: float, count: int) -> float:
        """Return the largest |decimal logarithm| of the values; `last` is where a taper adds to."""
        spread = self.random.spread if self.random else 0.0
        ends = [0.0, math.log10(last) + (count - 1) * math.log10(ratio)]
        sizes = [ends, [math.log10(1.0 - spread), math.log10(1.0 + spread)]]
        sizes += [[*map(math.log10, values)] for values in (self.cell, self.list) if values]
        placed = [abs(math.log10(value)) for value in self.placed().values()]
        return max(abs(sum(map(min, sizes))), abs(sum(map(max, sizes))), *placed)


class Impure(Pattern):
    """A pattern in which impurities replace single values."""

    impurity: Several[Any] = ()

    def placed(self) -> dict[int, float]:
        """Return the values of impurities by their places."""
        return dict(one.place_and_value for one in self.impurity)

    def problems(self) -> Iterator[str]:
        """No two impurities are at one place."""
        places = [one.place_and_value[0] for one in self.impurity]
        for place in sorted({one for one in places if places.count(one) > 1}):
            yield f"impurity names {place} more than once: keep one of its values."


class Masses(Impure):
    """Masses along a chain: a number for all, or the product of what the keys give."""

    impurity: Annotated[Several[BeadWithMass], one_or_more(BeadWithMass)] = Field(
        (), description="One bead with another mass, or a list of such."
    )


class Factors(Impure):
    """Factors along a chain: a number for all, or the product of what the keys give."""

    impurity: Annotated[Several[ContactWithFactor], one_or_more(ContactWithFactor)] = Field(
        (), description="One contact with another factor, or a list of such."
    )


def _number_for_all(written: Any) -> BeforeValidator:
    """Let a number stand for a pattern; `written` is what a file may hold."""
    return BeforeValidator(
        lambda v: v if isinstance(v, Mapping | Part) else {"cell": [v]},
        json_schema_input_type=written,
    )


def _body(words: str) -> Body:
    try:
        return body_of(words)
    except InputError as error:
        raise PydanticCustomError("sentence", f"{{key}}: {error}") from None


def _sphere(words: str) -> str:
    if math.isinf(_body(words).radius):
        raise PydanticCustomError(
            "sentence", f"{{key}} is {words}, without a diameter: give one, as in {words} 9.5 mm."
        )
    return words


def _wall(words: str) -> str:
    _body(words)
    return words


Spheres = Annotated[Several[Annotated[str, AfterValidator(_sphere)]], Field(min_length=1)]
Wall = Annotated[str, AfterValidator(_wall)]


class Beads(Part):
    """Beads, with masses or of materials; a number is their count."""

    count: Annotated[Whole, Field(ge=1)] = Field(description="Number N of beads.")
    mass: Annotated[Masses, _number_for_all(Positive | Masses)] = Field(
        Masses(), description="Masses m_n along the chain, a number or a pattern; 1 by default."
    )
    cell: Spheres | None = Field(
        None,
        description="Spheres repeated along the chain, each by material and diameter, for example "
        "[steel 9.5 mm, ptfe 4.8 mm], in place of masses.  Diameters in m, cm, mm, um or in; the "
        "first sphere has mass 1.",
    )
    list: Spheres | None = Field(None, description="A sphere for each bead, in place of a cell.")

    @property
    def spheres(self) -> tuple[str, ...]:
        """The words for spheres, none where beads have masses."""
        return self.list or self.cell or ()

    @property
    def are_equal(self) -> bool:
        """Whether nothing but the number of beads is given."""
        return self.model_fields_set == {"count"}

    def problems(self) -> Iterator[str]:
        """Masses and materials are not both given."""
        given = [name for name in ("cell", "list", "mass") if name in self.model_fields_set]
        if len(given) > 1:
            yield (
                f"{given[0]} names materials, which set masses and stiffness, but {given[1]} is "
                "given too: leave one of them out."
            )

    def masses(self) -> Pattern:
        """Return the pattern of the masses, those of spheres over the first one."""
        if not self.spheres:
            return self.mass
        masses = [body_of(words).mass for words in self.spheres]
        relative = tuple(mass / masses[0] for mass in masses)
        return Pattern(list=relative) if self.list else Pattern(cell=relative)

    def stiffness(self, contacts: int, wall: str | None) -> Pattern:
        """Return the pattern of the elastic factors of spheres, over that of two first ones."""
        # The sphere ahead of the last one is the first of a ring; it is not touched at a held end.
        bodies = [body_of(self.spheres[n % len(self.spheres)]) for n in range(self.count + 1)]
        if wall:
            bodies[-1] = body_of(wall)
        like_first = hertz_stiffness(bodies[0], bodies[0])
        factors = tuple(hertz_stiffness(*pair) / like_first for pair in pairwise(bodies))
        return Pattern(list=factors[:contacts])


CountOrBeads = Annotated[Beads, or_number("count", Annotated[int, Field(ge=1)] | Beads)]


class Contacts(Part):
    """What the forces of the contacts are multiplied by, n between the beads n and n + 1."""

    elastic: Annotated[Factors, _number_for_all(Positive | Factors)] = Field(
        Factors(), description="Factors of the elastic force, a number or a pattern; 1 by default."
    )
    viscous: Annotated[Factors, _number_for_all(Positive | Factors)] | None = Field(
        None,
        description="Factors of the viscous force, a number or a pattern; those of the elastic "
        "force by default.",
    )
