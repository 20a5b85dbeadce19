r"""The inner loops of a step: sums of neighbouring slope rows, with or without the law.

A stage needs, for every contact,

.. math:: U_n = s_n + a\,o_n + \sum_{j<m} w_j\,k_{j,n}, \qquad F_n = F(U_n),

with two rows s and o, m = 5 or 10 neighbouring rows k of slopes (`numerics.runge_kutta`), and the
law F.  `sum_rows` forms only the sum; a law then maps the row.  For a named law `stage_pass`
compiles both into one loop, in which the loads of the sum hide behind the arithmetic of the law.

Vectorisation.  Loops run over unsigned indices, since signed ones may wrap around the end of an
array.  Sums are written in the order of the rows and may fuse multiply and add.  A test compares
the time per bead with a bare loop of square roots, for nothing else guarantees it.
"""

import functools
import math

from llvmlite import ir
from numba import carray, types, uint64
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np.unsafe.ndarray import to_fixed_tuple

from granular_fronts.chain.state import FORCE, ROWS_OF_SINGLE, D, U
from granular_fronts.model import kinds
from granular_fronts.model.passes import NEGLIGIBLE, compile_inline
from granular_fronts.model.potentials import GIVEN
from granular_fronts.numerics.compiled import callback, kernel, subroutine
from granular_fronts.numerics.runge_kutta import LONG, SHORT
from granular_fronts.numerics.vector_functions import power

CONTRACT = {"contract"}
DOUBLES = types.CPointer(types.float64)
STAGE_PASS = types.void(DOUBLES, *[types.int64] * 4, types.float64, DOUBLES, DOUBLES)


@subroutine(forceinline=True)
def _first_five(w):
    """Return the first five weights as numbers, which a store into a row cannot change."""
    return w[0], w[1], w[2], w[3], w[4]


@subroutine(forceinline=True)
def _all_ten(w):
    """Return all ten weights."""
    return w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7], w[8], w[9]


@subroutine(fastmath=CONTRACT, forceinline=True)
def _weighted_sum(table, source, other, factor, first, weights, n):
    """Return the sum of one contact, in two chains that need not wait for each other."""
    value, rest = table[source, n], factor * table[other, n]
    for j in range(0, len(weights) - 1, 2):
        value += weights[j] * table[first + uint64(j), n]
        rest += weights[j + 1] * table[first + uint64(j + 1), n]
    if len(weights) % 2 == 1:
        last = len(weights) - 1
        rest += weights[last] * table[first + uint64(last), n]
    return value + rest


@kernel(fastmath=CONTRACT)
def sum_rows(table, target, source, other, factor, window, weights, last):
    """Write source + factor × other + Σ weights × rows into the row `target`.

    The window gives the first of the rows and their number, as in `call_stage_pass`.
    """
    first, terms = uint64(window[0]), window[1]
    if terms == SHORT:
        five = _first_five(weights)
        for n in range(uint64(1), uint64(last + 1)):
            table[target, n] = _weighted_sum(table, source, other, factor, first, five, n)
        return
    ten = _all_ten(weights)
    for n in range(uint64(1), uint64(last + 1)):
        table[target, n] = _weighted_sum(table, source, other, factor, first, ten, n)


def stage_pass(potential):
    """Return address of the loop that sums rows and takes the force of the sum; 0 if there is none.

    It is valid as long as the process; `call_stage_pass` calls it, with the potential's
    `row_parameters`.
    """
    if potential.kind == GIVEN:
        return 0
    shape = potential.shape
    if shape is kinds.hertz:
        shape = _root_slope if potential.parameters == (1.5,) else _power_slope
    return _pass_of_shape(shape, len(potential.parameters)).address


@functools.cache
def _pass_of_shape(shape, count):
    """Return the pass of a shape, F = −V'(−u)."""
    compile_inline(shape)
    return callback(STAGE_PASS, error_model="numpy", fastmath=CONTRACT)(_loop(shape, 1 + count))


def _root_slope(r, order, p):
    """Return (−r)₊^{3/2}, Hertz's own power, in the form of a shape."""
    compression = -r if -r > NEGLIGIBLE else 0.0
    return compression * math.sqrt(compression)


def _power_slope(r, order, p):
    """Return (−r)₊^α, p = (α,), in the form of a shape."""
    # Taken of every number, so that there is no branch and the loop is vectorised.
    whole = power(-r, p[0])
    return whole if -r > NEGLIGIBLE else 0.0


def _loop(shape, size):
    """Return the pass of a shape; by what it encloses numba's cache keeps it apart from others.

    The shape is a plain function: a compiled one would differ from process to process.
    """

    def sum_and_take_force(rows, columns, first, terms, last, factor, weights, parameters):
        table = carray(rows, (ROWS_OF_SINGLE, columns))
        numbers = to_fixed_tuple(carray(parameters, size), size)
        if terms == SHORT:
            five = _first_five(carray(weights, LONG))
            for n in range(uint64(1), uint64(last + 1)):
                value = _weighted_sum(table, U, D, factor, uint64(first), five, n)
                table[FORCE, n] = numbers[0] * shape(-value, 1, numbers[1:])
            return
        ten = _all_ten(carray(weights, LONG))
        for n in range(uint64(1), uint64(last + 1)):
            value = _weighted_sum(table, U, D, factor, uint64(first), ten, n)
            table[FORCE, n] = numbers[0] * shape(-value, 1, numbers[1:])

    return sum_and_take_force


@intrinsic
def call_stage_pass(typing_context, address, table, window, last, factor, weights, parameters):
    """Call a stage pass by its address; it starts from the state, and its rows are the window's."""
    integer, double = ir.IntType(64), ir.DoubleType()

    def generate(context, builder, signature, arguments):
        address, table, window, last, factor, weights, parameters = arguments
        types_of = dict(
            zip(
                ("table", "weights", "parameters"),
                (signature.args[1], *signature.args[-2:]),
                strict=True,
            )
        )

        def fields(name, value):
            return cgutils.create_struct_proxy(types_of[name])(context, builder, value=value)

        rows = fields("table", table)
        columns = cgutils.unpack_tuple(builder, rows.shape)[1]
        pointer = double.as_pointer()
        function = ir.FunctionType(
            ir.VoidType(), [pointer, *[integer] * 4, double, pointer, pointer]
        )
        builder.call(
            builder.inttoptr(address, function.as_pointer()),
            [
                rows.data,
                columns,
                *cgutils.unpack_tuple(builder, window),
                last,
                factor,
                fields("weights", weights).data,
                fields("parameters", parameters).data,
            ],
        )
        return context.get_dummy_value()

    pair = types.UniTuple(types.int64, 2)
    signature = types.void(
        types.int64, table, pair, types.int64, types.float64, weights, parameters
    )
    return signature, generate
