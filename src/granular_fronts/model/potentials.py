r"""Potentials of the elastic and of the viscous force of a contact; James (2021), section 2.

With the strain :math:`r_n = x_{n+1} - x_n`, negative in compression, the chain (5) is

.. math:: m\ddot x = \delta^-\bigl(V'(r) + \tfrac{d}{dt}W'(r)\bigr), \qquad r = \delta^+x,

with an elastic potential V and a convex potential W of the viscous force.  The contact law (2) of
granular chains is (4), the generalised Hertz potential for both:

.. math:: V(r) = \frac{k}{\alpha+1}(-r)_+^{\alpha+1}, \qquad
          W(r) = \frac{\gamma_0 k}{\beta+1}(-r)_+^{\beta+1} .

A `Potential` is V or W.  It has a named kind (see `model.kinds`), a user's own functions, or a
SymPy expression.  Its functions take and return arrays; `model.passes` compiles them for chains.
Potentials with a minimum have it at r = 0, where the chain is at rest; the units are the user's.

This module imports nothing heavier than numpy; only expressions need SymPy.
"""

from __future__ import annotations

import difflib
import functools
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from granular_fronts.arguments import instance, scalar
from granular_fronts.errors import InputError
from granular_fronts.model.given_functions import check_functions, check_interval, check_kinks
from granular_fronts.model.kinds import KINDS, Parameter

if TYPE_CHECKING:
    import numpy.typing as npt
    import sympy

GIVEN = "given"  # Kind of a potential whose functions are the user's.
# A function of the strain, from an array to an array of the same shape.
Function = Callable[[np.ndarray], np.ndarray]


class Origin:
    """What distinguishes a potential of a user's functions from all others, of the same ones even.

    Functions may depend on variables outside themselves, whose values change between the two.
    """


@dataclass(frozen=True, init=False)
class Potential:
    """A potential of the strain r with its derivatives, from a user's functions.

    The functions are checked first.  A potential of a named kind comes from `make_potential`.

    Parameters
    ----------
    value, first, second, third : callable
        V, V', V'' and V''' (optional), from an array of r to an array of the same shape.  Chains
        compile V' and V'' for single numbers: write them of arithmetic, of conditions by
        ``np.where``, and of functions of numpy that numba compiles.  Variables outside them must
        not change once the potential is in use; after a change build another one.
    interval : tuple of float
        Interval of r in which all strains will lie; the check samples it, and r outside is refused.
    kinks : tuple of float, optional
        Strains at which the potential is not smooth, such as 0 for a contact that opens there.
    name : str, optional
        What messages call it.

    Attributes
    ----------
    name : str
        For messages.
    kind : str
        Name in the configuration; "given" for a user's own.
    factor : float
        What the shape, or the user's functions, are multiplied by.
    parameters : tuple of float
        Those of the shape; () for a user's own.
    domain : tuple of float
        Open interval of r in which the functions hold.
    kinks : tuple of float
        Strains at which they are not smooth.
    functions : tuple of callable or None
        A user's V, V', V'' and V''', of arrays.
    scalar_functions : tuple of callable or None
        The same in the form that is compiled for single numbers.
    origin : Origin or None
        Of a user's own potential, shared only by its multiples.

    Raises
    ------
    InputError
        If a function is not vectorised, returns no finite numbers inside the interval, or disagrees
        with a finite difference of the function before it.

    Examples
    --------
    >>> import numpy as np
    >>> stiffening = gf.Potential(
    ...     lambda r: np.cosh(r) - 1.0, np.sinh, np.cosh, np.sinh, interval=(-3.0, 3.0)
    ... )
    >>> float(stiffening.second(0.0))
    1.0
    """

    name: str
    kind: str
    factor: float
    parameters: tuple[float, ...]
    domain: tuple[float, float]
    kinks: tuple[float, ...]
    functions: tuple[Callable, ...] | None = field(compare=False)
    scalar_functions: tuple[Callable, ...] | None = field(compare=False)
    origin: Origin | None

    def __init__(
        self,
        value: Function,
        first: Function,
        second: Function,
        third: Function | None = None,
        *,
        interval: Sequence[float],
        kinks: Sequence[float] = (),
        name: str = "the potential",
    ) -> None:
        low, high = check_interval(interval)
        functions = (value, first, second, third)
        check_functions(functions, low, high, name)
        functions = tuple(map(_hashable, functions))
        self.__dict__.update(
            name=name,
            kind=GIVEN,
            factor=1.0,
            parameters=(),
            domain=(low, high),
            kinks=check_kinks(kinks),
            functions=functions,
            scalar_functions=functions,
            origin=Origin(),
        )

    @classmethod
    def _of(cls, **attributes):
        """Return a potential with these attributes, unchecked."""
        potential = object.__new__(cls)
        potential.__dict__.update(attributes)
        return potential

    @classmethod
    def from_expression(
        cls,
        expression: sympy.Expr,
        symbol: sympy.Symbol,
        *,
        interval: Sequence[float],
        kinks: Sequence[float] = (),
        name: str | None = None,
    ) -> Potential:
        """Return a potential from a SymPy expression, which is differentiated for the user.

        Parameters
        ----------
        expression : sympy.Expr
            V, an expression of one symbol.
        symbol : sympy.Symbol
            The symbol of r.
        interval, kinks : tuple of float
            As for `Potential`.
        name : str, optional
            What messages call it; the expression itself by default.

        Returns
        -------
        Potential

        Raises
        ------
        InputError
            If it is no expression of SymPy (a text would run as Python), or has other symbols or no
            numbers. If it fails the check of `Potential`.
        ModuleNotFoundError
            Without SymPy.

        Examples
        --------
        >>> import sympy
        >>> r = sympy.Symbol("r")
        >>> quartic = gf.Potential.from_expression(r**4 / 4, r, interval=(-2.0, 2.0))
        >>> float(quartic.first(-2.0))
        -8.0
        """
        try:
            import sympy
        except ImportError as error:
            raise ModuleNotFoundError(
                "Potentials from expressions need SymPy: pip install 'granular-fronts[symbolic]'.",
                name="sympy",
            ) from error
        instance("expression", expression, sympy.Expr, "make one of sympy.Symbol('r')")
        instance("symbol", symbol, sympy.Symbol, "give the symbol of r")
        others = sorted(map(str, expression.free_symbols - {symbol}))
        if others:
            raise InputError(
                f"The expression {expression} depends on {', '.join(others)} besides {symbol}: "
                "substitute numbers for everything else."
            )
        # Of a real number |r| and max(r, 0) have derivatives, which their pieces give.
        r = sympy.Symbol("r", real=True)
        pieces = expression.subs(symbol, r).rewrite(sympy.Piecewise)
        derivatives = [sympy.diff(pieces, r, order) for order in range(4)]
        try:
            of_arrays, of_numbers = (
                [sympy.lambdify(r, derivative, language) for derivative in derivatives]
                for language in ("numpy", "math")
            )
            potential = cls(
                *map(_on_arrays, of_arrays),
                interval=interval,
                kinks=kinks,
                name=name or str(expression),
            )
        except (NameError, NotImplementedError) as error:
            raise InputError(
                f"The expression {expression} or a derivative is unknown to numpy: write it with "
                f"Piecewise. SymPy says: {str(error).splitlines()[0]}"
            ) from error
        return cls._of(**vars(potential) | {"scalar_functions": tuple(of_numbers)})

    @property
    def shape(self) -> Callable[..., Any] | None:
        """``shape(r, order, p)`` of a named kind, None for a user's own."""
        return None if self.kind == GIVEN else KINDS[self.kind].shape

    def value(self, r: npt.ArrayLike) -> np.ndarray:
        """Return V(r), from an array of r to an array of the same shape."""
        return self.derivative(r, 0)

    def first(self, r: npt.ArrayLike) -> np.ndarray:
        """Return V'(r)."""
        return self.derivative(r, 1)

    def second(self, r: npt.ArrayLike) -> np.ndarray:
        """Return V''(r)."""
        return self.derivative(r, 2)

    @property
    def third(self) -> Function | None:
        """V''' as a function of r; None if a user has not given it."""
        known = self.functions is None or self.functions[3] is not None
        return functools.partial(self.derivative, order=3) if known else None

    def derivative(self, r: npt.ArrayLike, order: int) -> np.ndarray:
        """Return the derivative of an order from 0 to 3; 3 only where `third` is known."""
        r = np.asarray(r, dtype=float)
        with np.errstate(all="ignore"):
            if self.functions is not None:
                return self.factor * np.asarray(self.functions[order](r), dtype=float)
            return self.factor * KINDS[self.kind].shape(r, order, self.parameters)

    def scaled(self, factor: float) -> Potential:
        """Return the potential times a number of 0 or more."""
        return self.with_factor(self.factor * factor)

    def with_factor(self, factor: float) -> Potential:
        """Return the same functions with another factor."""
        return self._of(**vars(self) | {"factor": factor})

    def ratio_to(self, other: Potential) -> float | None:
        """Return the number a for which this potential is a times the other one, or None."""
        mine, others = (
            (potential.shape, potential.parameters, potential.functions)
            for potential in (self, other)
        )
        if self.factor == 0.0:
            return 0.0
        return self.factor / other.factor if mine == others and other.factor > 0.0 else None

    def describe(self) -> dict[str, Any]:
        """Return mapping of which `make_potential` makes it; a note for a user's own functions."""
        if self.kind == GIVEN:
            return {
                "kind": GIVEN,
                "name": self.name,
                "note": "functions of a user's own, which this mapping cannot make again",
            }
        described, shape_parameters = KINDS[self.kind], iter(self.parameters)
        return {"kind": self.kind} | {
            name: self.factor if name == described.factor else next(shape_parameters)
            for name in described.parameters
        }


def make_potential(kind: str, **parameters: float) -> Potential:
    """Make a potential of a named kind; parameters with a default may be left out.

    An InputError says that there is no such kind or parameter, or that a value is out of range.

    >>> float(make_potential("hertz", alpha=1.5).first(-4.0))
    -8.0
    """
    described = look_up(kind, "kind", KINDS)
    values = checked_parameters(kind, described.parameters, parameters)
    factor = values.pop(described.factor, 1.0)
    shape_parameters = tuple(values.values())
    return Potential._of(
        name=f"{described.title} potential",
        kind=kind,
        factor=factor,
        parameters=shape_parameters,
        domain=described.domain(shape_parameters),
        kinks=described.kinks,
        functions=None,
        scalar_functions=None,
        origin=None,
    )


def look_up(name: object, meaning: str, known: Mapping[str, Any]) -> Any:
    """Return the entry of a name, or a sentence that says what it is not, with the nearest name."""
    if isinstance(name, str) and name in known:
        return known[name]
    near = difflib.get_close_matches(str(name), known, n=1)
    advice = f"did you mean {near[0]}?" if near else f"choose one of {', '.join(known)}."
    raise InputError(f"{name!r} is no {meaning}: {advice}")


def checked_parameters(
    kind: str, known: Mapping[str, Parameter], given: Mapping[str, Any]
) -> dict[str, float]:
    """Return the parameters of a kind by name, checked; those left out have their defaults."""
    for name in given:
        look_up(name, f"parameter of {kind}", known)
    missing = [name for name in known if name not in given and known[name].default is None]
    if missing:
        raise InputError(f"{kind} has no {missing[0]}, {known[missing[0]].meaning}: give one.")
    return {
        name: scalar(
            name,
            given.get(name, parameter.default),
            above=parameter.above,
            least=parameter.least,
            advice=f"give {kind} such a number",
        )
        for name, parameter in known.items()
    }


def _hashable(function):
    """Return a callable, in a function if it has no hash, as polynomials of numpy have none."""
    if function is None or isinstance(function, Hashable):
        return function
    return lambda r: function(r)


def _on_arrays(function):
    """Return a function that gives an array even where SymPy found a constant."""
    return lambda r: np.zeros_like(r) + function(r)
