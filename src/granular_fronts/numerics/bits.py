"""The bits of a double, and a multiplication and an addition with one rounding."""

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic


@intrinsic
def bits_of(typing_context, number):
    """Return the 64 bits of a double, as an integer."""

    def generate(context, builder, signature, arguments):
        return builder.bitcast(arguments[0], ir.IntType(64))

    return types.int64(types.float64), generate


@intrinsic
def double_of(typing_context, bits):
    """Return the double of 64 bits."""

    def generate(context, builder, signature, arguments):
        return builder.bitcast(arguments[0], ir.DoubleType())

    return types.float64(types.int64), generate


@intrinsic
def multiply_add(typing_context, a, b, c):
    """Return a b + c, rounded once; with c = −fl(a b) the rounding error of the product."""

    def generate(context, builder, signature, arguments):
        return builder.fma(*arguments)

    return types.float64(types.float64, types.float64, types.float64), generate


@intrinsic
def borrowed(typing_context, values):
    """Return an array, or a tuple of numbers and arrays, whose owners need not be counted.

    The caller of the kernel keeps them alive.  Counting locks the memory bus, thousands of times
    in a run.
    """

    def release(context, builder, type_, value):
        if isinstance(type_, types.BaseTuple):
            parts = cgutils.unpack_tuple(builder, value)
            for i, (part_type, part) in enumerate(zip(type_, parts, strict=True)):
                released = release(context, builder, part_type, part)
                value = builder.insert_value(value, released, i)
            return value
        if not isinstance(type_, types.Array):
            return value
        array = cgutils.create_struct_proxy(type_)(context, builder, value=value)
        for name in ("meminfo", "parent"):
            setattr(array, name, cgutils.get_null_value(getattr(array, name).type))
        return array._getvalue()

    def generate(context, builder, signature, arguments):
        return release(context, builder, values, arguments[0])

    return values(values), generate
