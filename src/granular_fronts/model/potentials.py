r"""Contact laws: potentials of the elastic and of the dissipative force; James (2021), section 2.

With :math:`r_n = x_{n+1} - x_n`, negative in compression, the lattice (5) is

.. math:: m\ddot x = \delta^-\bigl(V'(r) + \tfrac{d}{dt}W'(r)\bigr), \qquad r = \delta^+x,

with an elastic potential V and a convex potential W of the dissipative force.  The contact law (2)
of granular chains is (4), the generalised Hertz potential for both:

.. math:: V(r) = \frac{k}{\alpha+1}(-r)_+^{\alpha+1}, \qquad
          W(r) = \frac{\gamma_0 k}{\beta+1}(-r)_+^{\beta+1} .

A `Potential` is either kind.  Its four functions take and return arrays.  Potentials with a minimum
have it at r = 0, where the chain is at rest; the units are the user's.

This module imports nothing heavier than numpy; SymPy is needed by those alone who bring an
expression.
"""

import itertools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from granular_fronts.arguments import scalar, sequence
from granular_fronts.errors import InputError

CHECKED_POINTS = 12
DIFFERENCE_STEP = 1.0e-4
"""Step of the finite differences that check a user's derivatives, relative to the interval."""

DIFFERENCE_TOLERANCE = 1.0e-6
"""Disagreement that a check lets pass, relative to the largest derivative on the interval."""

NO_LIMITS = (-math.inf, math.inf)


class Potential(NamedTuple):
    """A potential of r and its derivatives, as functions from arrays to arrays.

    Attributes
    ----------
    name : str
        For messages.
    value, first, second : callable
        V, V' and V''.
    third : callable or None
        V'''; without it the states of a front must not be too close (see `model.jump_conditions`).
    domain : tuple of float
        Open interval of r in which the functions hold.
    """

    name: str
    value: Callable
    first: Callable
    second: Callable
    third: Callable | None = None
    domain: tuple[float, float] = NO_LIMITS


def generalised_hertz(alpha, stiffness=1.0):
    """V(r) = k/(α + 1) (−r)₊^(α+1), eq. (4); with γ₀k for k and β for α it is W.

    Parameters
    ----------
    alpha : float
        Exponent, above 0. Below 1 the contact softens, and V'' is infinite at r = 0.
    stiffness : float, optional
        k, above 0.
    """
    alpha, stiffness = _positive(alpha=alpha, stiffness=stiffness)

    def power(r, exponent, factor):
        compression = np.maximum(-np.asarray(r, dtype=float), 0.0)
        if factor == 0.0:
            return np.zeros_like(compression)
        # At r = 0 a negative exponent belongs to the compressed side; a gap carries no force.
        with np.errstate(divide="ignore"):
            return np.where(np.asarray(r) <= 0.0, factor * compression**exponent, 0.0)

    return Potential(
        f"Hertz potential with alpha = {alpha:g}",
        lambda r: power(r, alpha + 1.0, stiffness / (alpha + 1.0)),
        lambda r: power(r, alpha, -stiffness),
        lambda r: power(r, alpha - 1.0, alpha * stiffness),
        lambda r: power(r, alpha - 2.0, -alpha * (alpha - 1.0) * stiffness),
    )


def fpu(quadratic=1.0, cubic=0.0, quartic=0.0):
    """Fermi–Pasta–Ulam: V(r) = κr²/2 + ar³/3 + br⁴/4; α has b = 0, β has a = 0, harmonic both.

    Parameters
    ----------
    quadratic, cubic, quartic : float
        κ, a and b.
    """
    given = {"quadratic": quadratic, "cubic": cubic, "quartic": quartic}
    quadratic, cubic, quartic = (scalar(name, value) for name, value in given.items())
    polynomial = np.polynomial.Polynomial(
        [0.0, 0.0, quadratic / 2.0, cubic / 3.0, quartic / 4.0], symbol="r"
    )
    return Potential(
        "FPU potential",
        polynomial,
        polynomial.deriv(1),
        polynomial.deriv(2),
        polynomial.deriv(3),
    )


def toda(strength=1.0, rate=1.0):
    """V(r) = (a/b)(e^(−br) + br − 1), stiffer in compression.

    Parameters
    ----------
    strength, rate : float
        a and b, above 0.
    """
    strength, rate = _positive(strength=strength, rate=rate)
    return Potential(
        "Toda potential",
        lambda r: strength / rate * (np.expm1(-rate * r) + rate * r),
        lambda r: -strength * np.expm1(-rate * r),
        lambda r: strength * rate * np.exp(-rate * r),
        lambda r: -strength * rate**2 * np.exp(-rate * r),
    )


def morse(depth=1.0, rate=1.0):
    """V(r) = D (1 − e^(−br))², with a well of depth D.

    Parameters
    ----------
    depth, rate : float
        D and b, above 0.
    """
    depth, rate = _positive(depth=depth, rate=rate)

    def decay(r):
        return np.exp(-rate * r)

    return Potential(
        "Morse potential",
        lambda r: depth * np.expm1(-rate * r) ** 2,
        lambda r: -2.0 * depth * rate * decay(r) * np.expm1(-rate * r),
        lambda r: 2.0 * depth * rate**2 * decay(r) * (2.0 * decay(r) - 1.0),
        lambda r: 2.0 * depth * rate**3 * decay(r) * (1.0 - 4.0 * decay(r)),
    )


def lennard_jones(depth=1.0, distance=1.0):
    """V(r) = D (s⁻⁶ − 1)², s = 1 + r/d: s⁻¹² − 2s⁻⁶ raised to have its minimum 0 at r = 0.

    Parameters
    ----------
    depth, distance : float
        D and the distance d of the particles at rest, above 0. It holds for r > −d.
    """
    depth, distance = _positive(depth=depth, distance=distance)

    def derivative(order):
        # The n-th derivative of s^(-p) is (-1)^n p (p + 1) … (p + n − 1) s^(-p - n).
        twelve, six = (float(math.prod(range(p, p + order)) * (-1) ** order) for p in (12, 6))
        scale = depth / distance**order

        def evaluate(r):
            s = 1.0 + r / distance
            return scale * s ** (-6 - order) * (twelve * s**-6 - 2.0 * six)

        return evaluate

    return Potential(
        "Lennard-Jones potential",
        lambda r: depth * ((1.0 + r / distance) ** -6 - 1.0) ** 2,
        derivative(1),
        derivative(2),
        derivative(3),
        (-distance, math.inf),
    )


NO_DISSIPATION = Potential("no dissipation", *[np.zeros_like] * 4)
"""W = 0, the conservative chain."""


def potential_from_functions(value, first, second, third=None, *, interval, name="the potential"):
    """A potential from a user's functions, which are checked first.

    Parameters
    ----------
    value, first, second, third : callable
        V, V', V'' and V''' (optional), from an array of r to an array of the same shape.
    interval : tuple of float
        Interval of r that the states will lie in; the check samples it, and r outside is refused.
    name : str, optional
        What messages call it.

    Returns
    -------
    Potential

    Raises
    ------
    InputError
        If a function is not vectorised or returns no finite numbers inside the interval, or if a
        derivative disagrees with a finite difference of the function before it.
    """
    low, high = _check_interval(interval)
    functions = {"V": value, "V'": first, "V''": second}
    if third is not None:
        functions["V'''"] = third
    nodes = 0.5 * (low + high) + 0.5 * (high - low) * _gauss_nodes(CHECKED_POINTS)
    for symbol, function in functions.items():
        _check_values(function, nodes, symbol, name)
    symbols = list(functions)
    for symbol, derivative in itertools.pairwise(symbols):
        step = DIFFERENCE_STEP * (high - low)
        _check_derivative(functions[symbol], functions[derivative], nodes, step, derivative, name)
    return Potential(name, value, first, second, third, (low, high))


def potential_from_expression(expression, symbol, *, interval, name=None):
    """A potential from a SymPy expression, which is differentiated for the user.

    Parameters
    ----------
    expression : sympy.Expr
        V, an expression of one symbol.
    symbol : sympy.Symbol
        The one that stands for r.
    interval : tuple of float
        As in `potential_from_functions`.
    name : str, optional
        What messages call it; the expression itself by default.

    Returns
    -------
    Potential

    Raises
    ------
    InputError
        If the expression has other symbols, or fails the check of `potential_from_functions`.
    """
    import sympy

    others = sorted(map(str, sympy.sympify(expression).free_symbols - {symbol}))
    if others:
        raise InputError(
            f"The expression {expression} depends on {', '.join(others)} besides {symbol}: "
            "substitute numbers for everything else."
        )
    functions = [
        _on_arrays(sympy.lambdify(symbol, sympy.diff(expression, symbol, order), "numpy"))
        for order in range(4)
    ]
    return potential_from_functions(*functions, interval=interval, name=name or str(expression))


def _check_interval(interval):
    """Both ends of an interval, in their order."""
    ends = sequence("interval", interval)
    if ends.size != 2 or not ends[0] < ends[1]:
        raise InputError(f"interval is {interval}, but must grow: give its two ends in order.")
    return map(float, ends)


def _on_arrays(function):
    """A function that gives an array even where SymPy found a constant."""
    return lambda r: np.zeros_like(r) + function(r)


def _check_values(function, nodes, symbol, name):
    """Refuse a function that is not vectorised, or has no finite value at a node."""
    try:
        with np.errstate(all="ignore"):
            values = np.asarray(function(nodes), dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{symbol} of {name} is not vectorised: given an array it fails with '{error}'. Use "
            "functions of numpy, or numpy.vectorize."
        ) from error
    if values.shape != nodes.shape:
        raise InputError(
            f"{symbol} of {name} is not vectorised: given {nodes.size} values of r it returns an "
            f"array of shape {values.shape}. Return one number for each r."
        )
    if not np.isfinite(values).all():
        bad = int(np.argmin(np.isfinite(values)))
        raise InputError(
            f"{symbol} of {name} is {values[bad]} at r = {nodes[bad]:.6g}: correct it, or choose "
            "an interval in which the potential is finite."
        )


def _check_derivative(function, derivative, nodes, step, symbol, name):
    """Refuse a derivative that a difference quotient of fourth order contradicts."""
    differences = 8.0 * (function(nodes + step) - function(nodes - step))
    differences -= function(nodes + 2.0 * step) - function(nodes - 2.0 * step)
    quotients, given = differences / (12.0 * step), derivative(nodes)
    size = np.abs(function(nodes)).max() + np.abs(nodes).max() * np.abs(quotients).max()
    rounding = 4.0 * np.finfo(float).eps * size / step
    distances = np.abs(quotients - given)
    worst = int(np.argmax(distances))
    if distances[worst] > DIFFERENCE_TOLERANCE * np.abs(quotients).max() + rounding:
        raise InputError(
            f"{symbol} of {name} is {given[worst]:.6g} at r = {nodes[worst]:.6g}, but the finite "
            f"difference there is {quotients[worst]:.6g}: correct the derivative, or choose an "
            "interval in which it exists."
        )


def _gauss_nodes(count):
    return np.polynomial.legendre.leggauss(count)[0]


def _positive(**values):
    """The values as floats above 0, in the order given."""
    return [scalar(name, value, above=0.0) for name, value in values.items()]
