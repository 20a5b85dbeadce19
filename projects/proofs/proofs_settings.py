"""Which fronts are proved, and which of them is drawn within its enclosure."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Any

from pydantic import Discriminator, Field, Tag, create_model

from granular_fronts.scenes.parts import Named, Pair, Part, Positive, Several, say

Exponent = Annotated[float, Field(gt=1)]
ALPHA = "Exponent α of the elastic and of the viscous force, as a decimal."


class Meshes(Part):
    """What the proof of a front needs."""

    cells: Annotated[int, Field(ge=8, le=200)] = Field(
        20, description="Cells of the window per bead."
    )
    fine: Annotated[int, Field(ge=1, le=1000)] = Field(
        40, description="Cells of the inverse behind per cell of the window."
    )
    drift: Annotated[float, Field(gt=0, lt=1)] = Field(
        6e-4, description="Largest absolute value of a(u)/α − 1 behind the window."
    )


class ProvedFront(Meshes):
    """One front."""

    alpha: Exponent = Field(description=ALPHA)
    gamma: Annotated[
        Annotated[Positive, Tag("<one>")] | Annotated[Pair[Positive], Tag("<two>")],
        Discriminator(lambda value: "<two>" if isinstance(value, list | tuple) else "<one>"),
    ] = Field(description="Damping γ as a decimal, or two decimals between which it lies.")
    beta: Annotated[float, Field(ge=1, le=1)] = Field(  # type: ignore[assignment]
        None,  # A file may leave it out, but not give null, which no script takes.
        description="Exponent β of the damping force: 1, linear dashpots, or α if it is left out.",
    )

    def problems(self) -> Iterator[str]:
        """An interval of γ is none the other way round."""
        if isinstance(self.gamma, tuple):
            yield from _problems_of_ends("gamma", self.gamma)


class IntervalPart(Meshes):
    """One part of an interval of γ."""

    to: Positive = Field(description="Upper end of the part, above the one before.")
    chunks: Annotated[int, Field(ge=1, le=10000)] = Field(
        description="Chunks of equal length, each a job."
    )


# The word `from` names no attribute of a class.
FROM: dict[str, Any] = {"from": (Positive, Field(description="Lower end of the interval of γ."))}
_Start = create_model("_Start", __base__=Part, __doc__="Where an interval begins.", **FROM)


class Family(_Start):
    """One family."""

    alpha: Exponent = Field(description=ALPHA)
    parts: Annotated[Several[IntervalPart], Field(min_length=1)] = Field(
        description="Parts of the interval from below, each with what its proofs need."
    )

    def problems(self) -> Iterator[str]:
        """Parts go up."""
        yield from _problems_of_ends("", (getattr(self, "from"), *(one.to for one in self.parts)))


class Proofs(Part):
    """Fronts that are proved by ball arithmetic (δ = c = 1)."""

    fronts: Named[ProvedFront] = Field(description="Single fronts; the key names the certificate.")
    shown: str = Field(
        min_length=1, description="Name of the front that is drawn within its enclosure."
    )
    intervals: Named[Family] = Field(
        description="Families of fronts for all γ of an interval; the key names the family."
    )

    def problems(self) -> Iterator[str]:
        """The front that is drawn is one of those that are proved."""
        if self.shown not in self.fronts:
            yield (
                f"shown is {self.shown}, which is not proved: choose one of "
                f"{', '.join(self.fronts)}."
            )
        elif self.fronts[self.shown].beta:
            yield f"shown is {self.shown}, with β = 1, but its figure needs β = α: choose another."


def _problems_of_ends(key: str, ends: tuple[float, ...]) -> Iterator[str]:
    for low, high in pairwise(ends):
        if low >= high:
            yield (
                f"{key} goes from {say(low)} to {say(high)}, but γ must grow: lower the first or "
                "raise the second."
            )
