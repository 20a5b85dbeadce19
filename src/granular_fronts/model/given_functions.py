"""Checks of a user's functions before they make a potential.

A function of the strain must take arrays.  Each derivative is compared with a difference quotient
of fourth order of the function before it, at nodes inside the interval.
"""

import itertools
from collections.abc import Callable

import numpy as np

from granular_fronts.arguments import instance, sequence
from granular_fronts.errors import InputError

# Gauss nodes on [−1, 1] at which functions are compared with each other.
GAUSS_NODES = np.polynomial.legendre.leggauss(12)[0]
# Step of the finite differences, relative to the interval. Disagreement that the check lets pass,
# relative to the largest derivative on the interval.
DIFFERENCE_STEP, DIFFERENCE_TOLERANCE = 1.0e-4, 1.0e-6


def check_interval(interval):
    """Return both ends of an interval in order, as floats."""
    ends = sequence("interval", interval)
    if ends.size != 2 or not ends[0] < ends[1]:
        raise InputError(f"interval is {interval}, but its ends must increase: give them in order.")
    return map(float, ends)


def check_kinks(kinks):
    """Return the strains as a tuple of floats, which may be empty."""
    empty = isinstance(kinks, (tuple, list)) and not kinks
    return () if empty else tuple(map(float, sequence("kinks", kinks)))


def check_functions(functions, low, high, name):
    """Raise if a user's functions are not vectorised, finite and each other's derivatives."""
    for argument, function in zip(("value", "first", "second"), functions, strict=False):
        instance(argument, function, Callable, "give a function of an array of strains")
    if functions[3] is not None:
        instance("third", functions[3], Callable, "give a function of an array of strains, or None")
    nodes = nodes_inside(low, high)
    symbols = ("V", "V'", "V''", "V'''")
    known = {s: f for s, f in zip(symbols, functions, strict=True) if f is not None}
    for symbol, function in known.items():
        _check_values(function, nodes, symbol, name)
    step = DIFFERENCE_STEP * (high - low)
    for symbol, derivative in itertools.pairwise(known):
        with np.errstate(all="ignore"):
            _check_derivative(known[symbol], known[derivative], nodes, step, derivative, name)


def _check_values(function, nodes, symbol, name):
    """Raise unless a function is vectorised, with finite real values at the nodes."""
    try:
        with np.errstate(all="ignore"):
            found = np.asarray(function(nodes))
            values = np.asarray(found.real, dtype=float)
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InputError(
            f"{symbol} of {name} is not vectorised: given an array it fails with '{error}'. Use "
            "functions of numpy, or numpy.vectorize."
        ) from error
    if np.iscomplexobj(found):
        raise InputError(f"{symbol} of {name} has complex values: give a real function of r.")
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
    """Raise if a difference quotient of fourth order contradicts a derivative."""
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


def nodes_inside(low, high):
    """Return the Gauss nodes of an interval, at which functions are checked."""
    return 0.5 * (low + high) + 0.5 * (high - low) * GAUSS_NODES
