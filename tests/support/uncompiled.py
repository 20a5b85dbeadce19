"""Run kernels as Python, so that their results and their coverage can be looked at.

Importing this module before any kernel leaves the functions of `numba.njit` as they are.  What only
compiled code can do is given here in Python: the bits of a double, a product and a sum rounded
once, and calls by address.  Everything is slower by a factor of some hundred, and errors of
arithmetic are exceptions where compiled code has infinities.
"""

from fractions import Fraction
from importlib import import_module
from types import SimpleNamespace

import numba
import numpy as np
from numba.np.unsafe import ndarray

from granular_fronts.numerics import compiled

# The variable NUMBA_DISABLE_JIT, which does the same, is refused.
numba.config.DISABLE_JIT = 1
bits, interrupts = (import_module(f"granular_fronts.numerics.{n}") for n in ("bits", "interrupts"))

called = []
"""Functions that kernels call by their address, which is the number of places up to theirs."""


def callback(signature, **options):
    """Give a function an address, without compiling it."""

    def keep(function):
        called.append(function)
        return SimpleNamespace(address=len(called))

    return keep


def carray(array, shape):
    """The part of an array that a pointer to its first number and a shape would give."""
    return array.reshape(-1)[: np.prod(shape)].reshape(shape)


def multiply_add(a, b, c):
    if not np.isfinite(a * b + c):
        return a * b + c
    return float(Fraction(a) * Fraction(b) + Fraction(c))


def call_row_map(address, u, result, first, last, parameters):
    called[address - 1](u[: last + 1], result[: last + 1], first, last, parameters)


def call_with_factor(address, u):
    result = np.empty_like(u)
    call_row_map(address, u, result, 0, u.size - 1, np.ones(1))
    return result


def call_stage_pass(address, table, window, last, factor, weights, parameters):
    called[address - 1](table, table.shape[1], *window, last, factor, weights, parameters)


bits.bits_of = lambda number: np.float64(number).view(np.int64)
bits.double_of = lambda number: np.int64(number).view(np.float64)
bits.multiply_add = multiply_add
bits.borrowed = lambda values: values
compiled.callback = numba.cfunc = callback
numba.carray = carray
ndarray.to_fixed_tuple = lambda array, size: tuple(array[:size])
# Compiled code mixes whole numbers of both kinds, of which numpy would make a double.
numba.int64 = numba.uint64 = int
interrupts._interrupt_has_come = lambda: 0
# These take the names above when they are imported.
passes = import_module("granular_fronts.model.passes")
passes.call_row_map, passes._call, passes._number = call_row_map, call_with_factor, float
import_module("granular_fronts.chain.stage_passes").call_stage_pass = call_stage_pass
