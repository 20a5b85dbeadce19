r"""Laws of a chain: an elastic and a viscous potential; James (2021), eqs. (2) to (5).

Contact n exerts the force :math:`-V'(r_n) - \tfrac{d}{dt}W'(r_n)`.  A `Law` is the pair (V, W), and
the same one serves chains, exact fronts, jump conditions, collisions and campaigns.  The
configuration gives it in a short form, the law (28) of the paper,

    law: {alpha: 1.5, beta: 1.5, gamma: 0.06}

or by the kinds of its potentials (see `model.kinds`), and Python by the same mapping or by
`Potential` objects:

    law: {elastic: {kind: toda, rate: 2}, viscous: {kind: linear, gamma: 0.3}}

Four viscous kinds depend on the elastic potential.  They are none; proportional, :math:`W' = \gamma
V'`; kuwabara_kono, the same for a Hertz potential, :math:`\beta = \alpha`; and simon_hunt_crossley,
:math:`\beta = \alpha + 1`.  One evaluation of the force serves both where they are proportional.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from granular_fronts.arguments import instance
from granular_fronts.errors import InputError
from granular_fronts.model import kinds
from granular_fronts.model.potentials import Potential, checked_parameters, look_up, make_potential

SHORT_FORM = ("alpha", "beta", "gamma")
TWO_POTENTIALS = ("elastic", "viscous")

WAY_TO_A_POTENTIAL = (
    "give a mapping with its kind, or make one with granular_fronts.Potential or "
    "granular_fronts.Potential.from_expression"
)


@dataclass(frozen=True)
class Law:
    """An elastic and a viscous potential.

    Attributes
    ----------
    elastic, viscous : granular_fronts.model.potentials.Potential
        V and W; the factor of W is 0 where nothing dissipates.
    """

    elastic: Potential
    viscous: Potential

    @property
    def proportional(self) -> float | None:
        """γ where W' = γV', 0 for a conservative chain; None for any other law."""
        return self.viscous.ratio_to(self.elastic)

    @property
    def is_power(self) -> bool:
        """Whether this is the law (28) of the paper, with exponents α and β and stiffness 1."""
        hertzian = self.elastic.shape is kinds.hertz and self.elastic.factor == 1.0
        return hertzian and (self.viscous.shape is kinds.hertz or self.viscous.factor == 0.0)

    @property
    def alpha(self) -> float:
        """Exponent of the elastic force; an InputError unless the law is the paper's."""
        return self._power_law().elastic.parameters[0]

    @property
    def beta(self) -> float:
        """Exponent of the viscous force, α without one."""
        law = self._power_law()
        is_power = law.viscous.shape is kinds.hertz
        return law.viscous.parameters[0] if is_power else law.alpha

    @property
    def gamma(self) -> float:
        """Strength of the viscous force."""
        return self._power_law().viscous.factor

    @property
    def kinks(self) -> tuple[float, ...]:
        """Strains at which V or W is not smooth, in order."""
        return tuple(sorted({*self.elastic.kinks, *self.viscous.kinks}))

    @property
    def domain(self) -> tuple[float, float]:
        """Open interval of the strain in which V and W hold."""
        (low, high), (viscous_low, viscous_high) = self.elastic.domain, self.viscous.domain
        return max(low, viscous_low), min(high, viscous_high)

    def with_damping(self, factor: float) -> Law:
        """Return the law with W multiplied by a number of 0 or more."""
        return replace(self, viscous=self.viscous.scaled(factor))

    def describe(self) -> dict[str, Any]:
        """Return the mapping from which `make_law` makes the law, as in configurations and files.

        A note replaces a user's own functions, which a file cannot hold.
        """
        if self.is_power:
            return {"alpha": self.alpha, "beta": self.beta, "gamma": self.gamma}
        return {"elastic": self.elastic.describe(), "viscous": self._describe_viscous()}

    def __repr__(self) -> str:
        """Write the call that makes the law."""
        return f"make_law({self.describe()})"

    def _describe_viscous(self):
        if self.viscous.factor == 0.0:
            return {"kind": "none"}
        if self.viscous.kind == self.elastic.kind and self.proportional is not None:
            return {"kind": "proportional", "gamma": self.proportional}
        return self.viscous.describe()

    def _power_law(self):
        if not self.is_power:
            raise InputError(
                f"The law of {self.elastic.name} and {self.viscous.name} has no alpha, beta and "
                "gamma, which belong to the law (28): ask for its potentials."
            )
        return self


def make_law(mapping: Law | Mapping[str, Any] | None = None, /, **parts: Any) -> Law:
    """Make a law from the mapping of a configuration, or from the same as keywords.

    Parameters
    ----------
    mapping : Mapping or Law, optional
        In place of keywords; a law is returned as it is.
    alpha, beta, gamma : float
        The short form: exponents of the elastic and of the viscous force, above 0, and strength of
        the viscous force, 0 or more.  Defaults are β = α and γ = 0.
    elastic, viscous : Mapping or Potential
        The long form: mappings with a kind and its parameters, or a user's own potentials; without
        a viscous one nothing dissipates.

    Returns
    -------
    Law

    Raises
    ------
    InputError
        If a name, kind or value is impossible, if forms are mixed, or if keywords are
        given besides a whole law.

    Examples
    --------
    >>> gf.make_law(alpha=1.5, gamma=0.1).beta
    1.5
    >>> law = gf.make_law(
    ...     elastic={"kind": "toda", "rate": 2.0},
    ...     viscous={"kind": "proportional", "gamma": 0.3},
    ... )
    >>> law.proportional
    0.3
    """
    if mapping is not None and parts:
        raise InputError(
            f"The law is given as a whole and {next(iter(parts))} besides: give one of them."
        )
    if isinstance(mapping, Law):
        return mapping
    if mapping is not None:
        parts = dict(instance("law", mapping, Mapping, "give one, or make a law with make_law"))
    for name in parts:
        look_up(name, "part of a law", dict.fromkeys(SHORT_FORM + TWO_POTENTIALS))
    short = [name for name in SHORT_FORM if name in parts]
    long = [name for name in TWO_POTENTIALS if name in parts]
    if short and long:
        raise InputError(
            f"The law has {short[0]} besides {long[0]}, but is given by alpha, beta, gamma or by "
            "elastic, viscous: leave one of them out."
        )
    return _make_short(**parts) if short else _make_long(**parts)


def _make_short(alpha=None, beta=None, gamma=0.0):
    if alpha is None:
        raise InputError("The law has no alpha, the exponent of its elastic force: give one.")
    beta = alpha if beta is None else beta
    return Law(
        make_potential("hertz", alpha=alpha), make_potential("power", beta=beta, gamma=gamma)
    )


def _make_long(elastic=None, viscous=None):
    if elastic is None:
        raise InputError(
            "The law has no elastic potential: give elastic, with its kind, or alpha, beta, gamma."
        )
    elastic = _make_part("elastic", elastic, kinds.ELASTIC)
    if viscous is None:
        viscous = {"kind": "none"}
    if not (isinstance(viscous, Mapping) and viscous.get("kind") in _DEPENDENT):
        return Law(elastic, _make_part("viscous", viscous, kinds.KINDS | _DEPENDENT))
    name, dependent = viscous["kind"], _DEPENDENT[viscous["kind"]]
    given = {key: value for key, value in viscous.items() if key != "kind"}
    values = checked_parameters(name, dependent.parameters, given)
    if dependent.of_hertz and elastic.shape is not kinds.hertz:
        raise InputError(
            f"The viscous potential is of kind {name}, which belongs to the elastic kind hertz, "
            f"but the elastic one is {elastic.name}: take proportional, or hertz."
        )
    return Law(elastic, dependent.make(elastic, **values))


def _make_part(part, given, known):
    if isinstance(given, Potential):
        return given
    given = instance(part, given, Mapping, WAY_TO_A_POTENTIAL)
    look_up(given.get("kind"), f"kind of {part} potential", known)
    return make_potential(**given)


class _Dependent(NamedTuple):
    """A viscous kind that depends on the elastic potential, of which `make` makes it."""

    make: Callable[..., Potential]
    parameters: Mapping[str, kinds.Parameter]
    of_hertz: bool = False  # Whether it belongs only to Hertz potentials.


def _in_proportion(elastic, gamma):
    return elastic.scaled(gamma)


_GAMMA = {"gamma": kinds.DAMPING}
_DEPENDENT = {
    "none": _Dependent(lambda elastic: make_potential("linear", gamma=0.0), {}),
    "proportional": _Dependent(_in_proportion, _GAMMA),
    "kuwabara_kono": _Dependent(_in_proportion, _GAMMA, of_hertz=True),
    "simon_hunt_crossley": _Dependent(
        lambda elastic, gamma: make_potential(
            "power", beta=elastic.parameters[0] + 1.0, gamma=gamma
        ),
        _GAMMA,
        of_hertz=True,
    ),
}
"""A further viscous kind that depends on V needs an entry here, and nothing elsewhere."""
