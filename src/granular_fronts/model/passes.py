r"""Potentials compiled for the rows of a chain, a loop for each derivative of each kind.

Chains and exact fronts work with the compression :math:`u = -r`.  The map of order j of a potential
V writes, for each contact of a row,

.. math:: \frac{d^j}{du^j}\,V(-u) = (-1)^j\,V^{(j)}(-u), \qquad j = 0, \dots, 3,

that is the energy, the force :math:`F(u) = -V'(-u)`, its slope :math:`F'(u) = V''(-u)`, and
:math:`F''(u)`.  In these terms a chain with any law is

.. math:: \dot u = d + \Delta_d G(u), \qquad \dot d = \Delta_d F(u), \qquad G(u) = -W'(-u).

A map is a C function, reached by its address from kernels that need not be compiled again for it:

    void map(double *u, double *result, int64 first, int64 last, double *parameters)

for the contacts first … last, both included; `result` is another row than `u`.  Maps of named kinds
are compiled once for all parameters and cached on disk.  Maps of a user's functions are compiled in
a fraction of a second for each potential.  Outside the domain of a law they give no finite number,
so that no run leaves it unnoticed.

Compilation freezes the values of the variables outside a user's function, while Python sees them
change.  At each request for a map its numbers are compared with the function itself, so that no run
mixes two laws.

Vector code.  Powers of a contact are products with a square root for the exponents 1/2, 1, 3/2, 2
and 5/2.  Other powers and exponentials use the vector code of `numerics.vector_functions`.
Compressions up to `NEGLIGIBLE` exert no force.  They could not influence another bead in double
precision, and arithmetic on the subnormal numbers of their powers is a hundred times slower.
"""

import ctypes
import functools
import inspect
import math
from itertools import pairwise

import numba
import numpy as np
from llvmlite import ir
from numba import carray, types, uint64
from numba.core.errors import NumbaError
from numba.extending import intrinsic, overload
from numba.np.unsafe.ndarray import to_fixed_tuple

from granular_fronts.errors import InputError
from granular_fronts.model import kinds
from granular_fronts.model.given_functions import nodes_inside
from granular_fronts.model.potentials import GIVEN
from granular_fronts.numerics.bits import multiply_add
from granular_fronts.numerics.compiled import callback, subroutine
from granular_fronts.numerics.vector_functions import exponential, exponential_less_one, power

NEGLIGIBLE = 1.0e-60

# Disagreement of compiled code with Python that rounding may explain, relative to the number and to
# the largest one. Functions with a difference of near numbers lose digits.
OF_NUMBER, OF_LARGEST = 1.0e-7, 1.0e-10

ROW = types.CPointer(types.float64)
ROW_MAP = types.void(ROW, ROW, types.int64, types.int64, ROW)
"""Type of a row map: u, result, first, last (included), parameters."""

_NAMED = {"fastmath": {"contract"}, "error_model": "numpy"}
_USER = {"fastmath": {"contract", "afn"}, "error_model": "numpy"}
"""Arithmetic of a user's functions: a multiply and an add may fuse.  A power with a multiple of 1/2
as constant exponent becomes products and a square root, ten times faster.  It errs by about as many
units of the last place as its exponent."""


def row_map(potential, order):
    """Return address of the row map of a derivative of a potential, valid as long as the process.

    The order is 0 to 3: energy, force, its slope and the slope of that; `call_row_map` calls it,
    with `row_parameters`. An InputError says that numba cannot compile a user's function, or that
    the compiled one gives other numbers.
    """
    if potential.kind != GIVEN:
        return _map_of_shape(potential.shape, order, len(potential.parameters)).address
    given = potential.with_factor(1.0)
    address = _map_of_given(given, order).address
    _compare(address, given, order)
    return address


def row_parameters(potential, order):
    """Return the parameters of the row map of a derivative, an array for `call_row_map`."""
    factor = (-1.0) ** order * potential.factor
    if potential.shape is kinds.hertz:
        coefficient, exponent = kinds.hertz_power(order, *potential.parameters)
        return np.array([factor * coefficient, exponent])
    return np.array([factor, *potential.parameters])


@intrinsic
def call_row_map(typing_context, address, u, result, first, last, parameters):
    """Call a row map from a kernel, for the contacts first … last, both included.

    `u` and `result` are two contiguous rows that do not overlap, or pointers; `address` comes from
    `row_map`, `parameters` from `row_parameters`.
    """

    def generate(context, builder, signature, arguments):
        address, *given = arguments
        rows = {1: u, 2: result, 5: parameters}
        given = [
            _pointer(context, builder, rows[place], argument) if place in rows else argument
            for place, argument in enumerate(given, start=1)
        ]
        for place, type_ in ((2, first), (3, last)):
            given[place] = context.cast(builder, given[place], type_, types.int64)
        pointer, count = ir.DoubleType().as_pointer(), ir.IntType(64)
        function = ir.FunctionType(ir.VoidType(), [pointer, pointer, count, count, pointer])
        builder.call(builder.inttoptr(address, function.as_pointer()), given)
        return context.get_dummy_value()

    signature = types.void(types.int64, u, result, first, last, parameters)
    return signature, generate


def _pointer(context, builder, type_, value):
    """Return the address of the first number of an array; a pointer is one."""
    if isinstance(type_, types.Array):
        value = context.make_array(type_)(context, builder, value).data
    return builder.bitcast(value, ir.DoubleType().as_pointer())


# Named kinds.


@functools.cache
def _map_of_shape(shape, order, count):
    if shape is kinds.hertz:
        return callback(ROW_MAP, **_NAMED)(_raise_row)
    compile_inline(shape)
    return callback(ROW_MAP, **_NAMED)(_loop(shape, order, 1 + count))


def _loop(shape, order, size):
    """Return the loop of a shape; by what it encloses numba's cache keeps it apart from others."""

    def evaluate_row(u, result, first, last, parameters):
        numbers = to_fixed_tuple(carray(parameters, size), size)
        u_row, result_row = carray(u, last + 1), carray(result, last + 1)
        for n in range(uint64(first), uint64(last + 1)):
            result_row[n] = numbers[0] * shape(-u_row[n], order, numbers[1:])

    return evaluate_row


@functools.cache
def compile_inline(function):
    """Let compiled code call a plain function, as a part of itself."""
    overload(function, _NAMED | {"forceinline": True}, strict=False, prefer_literal=True)(
        lambda *arguments: function
    )


@overload(kinds.exponential, {"forceinline": True})
def _exponential(x):
    return lambda x: exponential(x)


@overload(kinds.exponential_less_one, {"forceinline": True})
def _exponential_less_one(x):
    return lambda x: exponential_less_one(x)


def _raise_row(u, result, first, last, parameters):
    """A coefficient times u₊ to an exponent, its two parameters; one loop for each special form."""
    coefficient, exponent = parameters[0], parameters[1]
    u_row, result_row = carray(u, last + 1), carray(result, last + 1)
    start, stop = uint64(first), uint64(last + 1)
    if exponent == 1.5:
        for n in range(start, stop):
            x = _compression(u_row[n])
            result_row[n] = coefficient * (x * math.sqrt(x))
    elif exponent == 1.0:
        for n in range(start, stop):
            result_row[n] = coefficient * _compression(u_row[n])
    elif exponent == 0.5:
        for n in range(start, stop):
            result_row[n] = coefficient * math.sqrt(_compression(u_row[n]))
    elif exponent == 2.5:
        for n in range(start, stop):
            x = _compression(u_row[n])
            square, root = x * x, math.sqrt(x)
            # With the rounding of the square, which two products would add to theirs.
            left = multiply_add(x, x, -square)
            result_row[n] = coefficient * multiply_add(square, root, left * root)
    elif exponent == 2.0:
        for n in range(start, stop):
            x = _compression(u_row[n])
            result_row[n] = coefficient * (x * x)
    else:
        for n in range(start, stop):
            # Taken of every number, so that there is no branch and the loop is vectorised.
            whole = coefficient * power(u_row[n], exponent)
            result_row[n] = whole if u_row[n] > NEGLIGIBLE else 0.0


@subroutine(forceinline=True)
def _compression(u):
    return u if u > NEGLIGIBLE else 0.0


# A user's functions.


@functools.cache
def _map_of_given(potential, order):
    """Return loop of a user's function, compiled in memory; NaN outside the domain ends a run."""
    function, (low, high) = potential.scalar_functions[order], potential.domain
    # What is no Python function, such as np.sinh, numba either knows or not.
    compiled = numba.njit(**_USER)(function) if inspect.isfunction(function) else function

    def evaluate_row(u, result, first, last, parameters):
        factor = parameters[0]
        u_row, result_row = carray(u, last + 1), carray(result, last + 1)
        for n in range(uint64(first), uint64(last + 1)):
            r = -u_row[n]
            result_row[n] = factor * _number(compiled(r)) if low < r < high else math.nan

    try:
        return numba.cfunc(ROW_MAP, **_USER)(evaluate_row)
    except NumbaError as error:
        raise InputError(
            f"{_symbol(order)} of {potential.name} cannot be compiled for chains: write it of "
            "arithmetic, conditions and functions of numpy or math, for one number. Numba says: "
            f"{_first_line(error)}"
        ) from error


def _compare(address, potential, order):
    """Raise if a compiled function, of factor 1, and the function itself give different numbers."""
    nodes = _nodes(potential)
    expected, found = potential.derivative(nodes, order), _call(address, -nodes)
    largest = np.abs(expected).max(where=np.isfinite(expected), initial=0.0)
    agree = np.abs(found - expected) <= OF_NUMBER * np.abs(expected) + OF_LARGEST * largest
    differ = np.isfinite(expected) & ~agree
    if differ.any():
        worst = int(np.argmax(differ))
        raise InputError(
            f"{_symbol(order)} of {potential.name} is {expected[worst]:.9g} at r = "
            f"{nodes[worst]:.6g}, but {found[worst]:.9g} in compiled code: numba freezes the "
            "values of variables outside a function when it compiles it. Build the potential "
            "anew after its constants are set, and write it of functions that numba and numpy "
            "take alike."
        )


@functools.lru_cache(maxsize=256)
def _nodes(potential):
    """Return the strains inside each interval between kinks."""
    low, high = potential.domain
    inside = sorted({kink for kink in potential.kinks if low < kink < high})
    return np.concatenate([nodes_inside(*ends) for ends in pairwise([low, *inside, high])])


def _call(address, u):
    """Return what a map without parameters but the factor 1 makes of a row."""
    result, factor = np.empty_like(u), np.ones(1)
    _C_MAP(address)(u.ctypes.data, result.ctypes.data, 0, u.size - 1, factor.ctypes.data)
    return result


_C_MAP = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p
)


def _symbol(order):
    return "V" + order * "'"


def _number(x):
    """A number, or the one that an array without dimensions holds, such as np.where gives."""


@overload(_number)
def _number_of(x):
    if isinstance(x, types.Array):
        return lambda x: float(x.item())
    return lambda x: float(x)


def _first_line(error):
    """Return what numba says of an error, without its colours and its advice."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return next((line for line in lines if not line.startswith("Failed in")), "nothing")
