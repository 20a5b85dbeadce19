"""The law of a scene, and sizes of its motion.

The law is made once, where a scene is read.  A scene is driven by relative displacements of about
δ, with energies of about δ^(α + 1).  Sizes are decimal logarithms, −∞ for none.
"""

import math
import sys
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import AfterValidator, ConfigDict, Discriminator, Field, PlainSerializer, Tag
from pydantic.json_schema import SkipJsonSchema
from pydantic_core import PydanticCustomError

from granular_fronts.errors import InputError
from granular_fronts.model.laws import Law, make_law
from granular_fronts.model.potentials import Potential
from granular_fronts.scenes.parts import NotNegative, Part, Positive, say

MOST_DECADES = 140
"""Decades on either side of 1 within which the square of a number is a double too."""

ABSOLUTE_TOLERANCE_FLOOR = 1.0e-20
"""Smallest absolute tolerance over the largest relative displacement: far below its round-off.

From rest the integrator's first steps shrink with it: at 1e-25 some laws take minutes, and none is
more exact.
"""

ABSOLUTE_TOLERANCE_CEILING = 0.1
"""Largest absolute tolerance over the largest relative displacement."""

SIZES = np.linspace(-MOST_DECADES, MOST_DECADES, 16 * MOST_DECADES + 1)
"""Sizes of the compressions among which the one of an energy is looked up, 8 for a decade."""


class LawOfPowers(Part):
    """Law (28): elastic force u^α and viscous force γ d(u^β)/dt."""

    alpha: Positive = Field(description="Exponent α of the elastic force, 3/2 for spheres (Hertz).")
    beta: Annotated[float, Field(ge=1)] | None = Field(
        None,
        description="Exponent β of the viscous force; α by default, the generalised Kuwabara–Kono "
        "law.",
    )
    gamma: NotNegative = Field(description="Strength γ of the viscous force, equation (29).")


class NamedPotential(Part):
    """A kind and its parameters, which `make_law` knows."""

    model_config = ConfigDict(extra="allow")
    __pydantic_extra__: dict[
        str, Annotated[float, Field(allow_inf_nan=False, description="A parameter of the kind.")]
    ]

    kind: str = Field(
        description="Name of a kind; granular_fronts.model.kinds lists them, with formulas and "
        "parameters."
    )


AnyPotential = Annotated[
    Annotated[SkipJsonSchema[Potential], Tag("<made>")] | Annotated[NamedPotential, Tag("<named>")],
    Discriminator(lambda value: "<made>" if isinstance(value, Potential) else "<named>"),
]


class LawOfPotentials(Part):
    """Two potentials V and W of the strain r = x_(n+1) − x_n, negative in compression, eq. (5)."""

    elastic: AnyPotential = Field(
        description="Potential V of the elastic force, a kind of granular_fronts.model.kinds and "
        "its parameters."
    )
    viscous: AnyPotential | None = Field(
        None,
        description="Potential W of the viscous force, a kind and its parameters; kind none by "
        "default.",
    )


def law_of_parts(**parts: Any) -> Law:
    """Make the law of what a part holds; an InputError says why there is none."""
    return make_law(
        {name: part.plain() if isinstance(part, Part) else part for name, part in parts.items()}
    )


def _form(value: Any) -> str:
    """Return which form of a law is given."""
    if isinstance(value, Law):
        return "<made>"
    if isinstance(value, Part):
        return "<long>" if isinstance(value, LawOfPotentials) else "<short>"
    is_long = isinstance(value, Mapping) and {"elastic", "viscous"} & value.keys()
    return "<long>" if is_long else "<short>"


def _make(value: Any) -> Law:
    """Make the law of a part."""
    if isinstance(value, Law):
        return value
    if isinstance(value, LawOfPowers) and value.beta is None and value.alpha < 1.0:
        sentence = (
            f"{{key}}.beta is alpha by default, {say(value.alpha)}, below its limit 1: give 1 or "
            "more."
        )
        raise PydanticCustomError("sentence", sentence)
    try:
        return law_of_parts(**{name: part for name, part in value if part is not None})
    except InputError as error:
        raise PydanticCustomError("sentence", f"{{key}}: {error}") from None


if TYPE_CHECKING:
    AnyLaw = Law
else:
    AnyLaw = Annotated[
        Annotated[LawOfPowers, Tag("<short>")]
        | Annotated[LawOfPotentials, Tag("<long>")]
        | Annotated[SkipJsonSchema[Law], Tag("<made>")],
        Discriminator(_form),
        AfterValidator(_make),
        PlainSerializer(Law.describe),
    ]
"""Law of the contacts, by its exponents or by two potentials; an attribute of it is a `Law`."""


class LawOfOneExponent(Part):
    """Contact law with β = α, the generalised Kuwabara–Kono law."""

    alpha: Annotated[float, Field(gt=1)] = Field(
        description="Exponent α of the elastic and the viscous force."
    )
    beta: float | None = Field(
        None, description="Exponent β of the viscous force; it is α here, and so by default."
    )
    gamma: Positive = Field(description="Strength γ of the viscous force, equation (29).")

    def problems(self) -> Iterator[str]:
        """Rings and fronts are compared with equations of section 4, which hold for β = α."""
        if self.beta not in (None, self.alpha):
            yield (
                f"beta is {say(self.beta)}, but the equations that a ring or a front is compared "
                f"with hold for beta = alpha = {say(self.alpha)} alone: leave it out, or take a "
                "scene of a chain."
            )


def exponent_of(law: Law) -> float | None:
    """Return the exponent α of a Hertz potential, None for other elastic potentials."""
    return law.elastic.parameters[0] if law.elastic.kind == "hertz" else None


def decades_of_impact(law: Law, velocity: float) -> float:
    """Return the size of the strain that a velocity makes of contacts at rest.

    A velocity v compresses them to about :math:`V(-u) = v^2`, that is :math:`v^{2/(α + 1)}` for
    the law (28), or stretches them as far where that takes less.
    """
    if velocity == 0.0:
        return -math.inf
    if law.is_power:
        return 2.0 / (law.alpha + 1.0) * math.log10(abs(velocity))
    energies = np.fmax(*(law.elastic.value(sign * 10.0**SIZES) for sign in (-1.0, 1.0)))
    energies -= law.elastic.value(0.0)
    return _first_size(law.elastic, energies >= float(velocity) ** 2)


def decades_of_load(law: Law, load: float) -> float:
    """Return the size of the strain at which a contact bears a force."""
    if load == 0.0:
        return -math.inf
    if law.is_power:
        return math.log10(load) / law.alpha
    forces = np.fmax(*(abs(law.elastic.first(sign * 10.0**SIZES)) for sign in (-1.0, 1.0)))
    return _first_size(law.elastic, forces >= load)


def _first_size(potential: Potential, enough: Any) -> float:
    """Return the first size at which something is enough, or beyond which no contact is pressed."""
    enough = enough | (potential.domain[0] >= -(10.0**SIZES))
    return float(SIZES[enough.argmax()] if enough.any() else SIZES[-1])


def front_speed(law: Law, size: float) -> float:
    """Return the front speed into contacts at rest, (V'(−u)/−u)^½ for u = 10^size."""
    elastic, u = law.elastic, 10.0**size
    if -u <= elastic.domain[0]:
        return 0.0
    return math.sqrt(abs(float(elastic.first(-u))) / u)


def decades_of_energy(law: Law, size: float) -> dict[str, float]:
    """Return the sizes of V and W at a compression of 10^size, by key of the law."""
    if law.is_power:
        exponents = {"alpha": law.alpha} | ({"beta": law.beta} if law.beta != law.alpha else {})
        return {key: (exponent + 1.0) * size for key, exponent in exponents.items()}
    energies = {key: _decades_of_energy(getattr(law, key), size) for key in ("elastic", "viscous")}
    return {key: found for key, found in energies.items() if math.isfinite(found)}


def _decades_of_energy(potential: Potential, size: float) -> float:
    """Return the same of one potential, −∞ where it is 0."""
    if potential.factor == 0.0 or -(10.0**size) <= potential.domain[0]:
        return -math.inf
    if potential.kind in ("hertz", "power"):
        return math.log10(potential.factor) + (potential.parameters[0] + 1.0) * size
    low, high = potential.domain
    at_rest = potential.value(0.0) if low < 0.0 < high else 0.0
    energy = abs(float(potential.value(-(10.0**size)) - at_rest))
    if energy == 0.0 and potential.shape:  # Functions that are given may be flat.
        energy = math.ulp(0.0)
    return math.log10(min(energy, sys.float_info.max)) if energy else -math.inf


def decades(value: float) -> float:
    """Return the decimal logarithm of a size."""
    return math.log10(abs(value)) if value else -math.inf


def energy_problems(law: Law, size: float) -> Iterator[str]:
    """Energies of a motion of the size, and the damping, neither overflow nor vanish."""
    if math.isfinite(size):
        for name, found in decades_of_energy(law, size).items():
            if abs(found) > MOST_DECADES:
                # An exponent may be given by either form of a law.
                key = f"law.{name}"
                if law.is_power:
                    key = f"law has {name} {say(getattr(law, name))}, which"
                yield (
                    f"{key} with relative displacements of about 1e{size:+.0f} makes energies of "
                    f"about 1e{found:+.0f}, beyond the 1e±{MOST_DECADES} that double precision can "
                    "square: bring both nearer to 1."
                )
    if law.is_power and law.gamma and abs(decades(law.gamma)) > MOST_DECADES:
        yield (
            f"law has gamma {say(law.gamma)}, beyond the 1e±{MOST_DECADES} that double precision "
            "can square: bring it nearer to 1, or give 0 for no damping."
        )


def tolerance_problems(absolute: float, size: float) -> Iterator[str]:
    """Say that an absolute tolerance drowns in the rounding of a motion, or lets all pass."""
    above = math.log10(absolute) - size
    if above < math.log10(ABSOLUTE_TOLERANCE_FLOOR):
        limit, side, advice = ABSOLUTE_TOLERANCE_FLOOR, "below", "more"
    elif math.isfinite(above) and above > math.log10(ABSOLUTE_TOLERANCE_CEILING):
        limit, side, advice = ABSOLUTE_TOLERANCE_CEILING, "above", "less"
    else:
        return
    largest = 10.0**size
    yield (
        f"tolerance.absolute is {say(absolute)}, {side} {limit:g} of the largest relative "
        f"displacement, which is about {largest:.3g}: give {limit * largest:.1e} or {advice}."
    )
