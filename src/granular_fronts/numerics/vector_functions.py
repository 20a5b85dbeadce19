r"""Logarithm, exponential and power, written so that a compiler turns them into vector code.

The library's functions are called for one number at a time and would take most of the time of a
right-hand side.

Logarithm.  :math:`x = 2^k m` with :math:`m \in [\sqrt{1/2}, \sqrt2)` is split by integer arithmetic
on the bits, and with :math:`s = f/(2+f)`, :math:`f = m - 1`,

.. math:: \ln m = f - \tfrac12 f^2 + s\,(\tfrac12 f^2 + R(s^2)), \qquad
    R(z) = z P(z) \approx \frac{\ln(1+s) - \ln(1-s)}{s} - 2,

where the minimax polynomial `P` of degree 6 comes from the C library fdlibm (Sun Microsystems,
1993).  The error is below one unit of the last place.

Exponential less one.  :math:`x = k\ln 2 + r` with :math:`|r| \le \tfrac12\ln 2`, and

.. math:: e^x - 1 = 2^k (e^r - 1) + (2^k - 1)

with the Taylor polynomial of :math:`e^r - 1`, whose remainder is below :math:`10^{-17}`.  Nothing
cancels where x is small.  Adding :math:`1.5\cdot2^{52}` rounds :math:`x/\ln2` to k and leaves k in
the last bits of the sum.

Power.  :math:`x^a = e^{a \ln x}` multiplies the relative error of the logarithm by
:math:`a \ln x`, so the logarithm carries a second double for its own rounding.  Its leading part is
:math:`k \ln 2 + 2s`.  The remainder of the division s and the rounding of the sum are exact.  What
follows, :math:`s R(s^2)`, is a hundred times smaller than s.  The product with a is split in the
same way.  What is left is the rounding of r and of the last sum, about one unit of the last place
together.
"""

import math

import numpy as np

from granular_fronts.numerics.bits import bits_of, double_of, multiply_add
from granular_fronts.numerics.compiled import kernel, subroutine

LN2 = math.log(2.0)
LN2_HIGH, LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10
P0, P1, P2, P3, P4, P5, P6 = (
    6.666666666666735130e-01,
    3.999999999940941908e-01,
    2.857142874366239149e-01,
    2.222219843214978396e-01,
    1.818357216161805012e-01,
    1.531383769920937332e-01,
    1.479819860511658591e-01,
)
# Bits of 1.0 and of the square root of one half, and the 52 bits of a fraction.
ONE, ROOT_HALF = np.int64(0x3FF0000000000000), np.int64(0x3FE6A09E667F3BCD)
FRACTION, FRACTION_BITS, BIAS = np.int64(0x000FFFFFFFFFFFFF), np.int64(52), np.int64(1023)

# Reciprocal factorials: of degree j + 1 in the exponential.
TAYLOR = tuple(1.0 / math.factorial(j + 1) for j in range(13))
ROUNDER = 1.5 * 2.0**52
ROUNDER_BITS = np.int64(0x4338000000000000)
# Powers of two that a double can hold; the next one above is infinite.
LOWEST_EXPONENT, INFINITE_EXPONENT = -1022.0, 1024.0

_CONTRACT = {"contract"}


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _remainder_of_logarithm(s):
    """Return R(s²)."""
    z = s * s
    w = z * z
    return z * (P0 + w * (P2 + w * (P4 + w * P6))) + w * (P1 + w * (P3 + w * P5))


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _small_exponential_less_one(r):
    """Return e^r − 1 for |r| ≤ ½ ln 2."""
    tail = TAYLOR[12]
    for j in range(11, 0, -1):
        tail = TAYLOR[j] + r * tail
    return r + r * r * tail


@kernel(fastmath=_CONTRACT, error_model="numpy", forceinline=True)
def logarithm(x):
    """Return the natural logarithm for a loop that is to be vectorised: no branch, no call.

    x is normal, at least 2.3e-308, which is not checked.  The error is below one unit of the last
    place.
    """
    shifted = bits_of(x) + (ONE - ROOT_HALF)
    k = double_of((shifted >> FRACTION_BITS) - BIAS + ROUNDER_BITS) - ROUNDER
    f = double_of((shifted & FRACTION) + ROOT_HALF) - 1.0
    s = f / (2.0 + f)
    half_square = 0.5 * f * f
    small = s * (half_square + _remainder_of_logarithm(s)) + k * LN2_LOW
    return k * LN2_HIGH - ((half_square - small) - f)


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _reduced_argument(x):
    """Return both r and 2^k of x = k ln 2 + r; k stays within the range of a double."""
    rounded = min(max(x * (1.0 / LN2), LOWEST_EXPONENT), INFINITE_EXPONENT) + ROUNDER
    k = rounded - ROUNDER
    return (x - k * LN2_HIGH) - k * LN2_LOW, double_of((bits_of(rounded) << FRACTION_BITS) + ONE)


@kernel(fastmath=_CONTRACT, forceinline=True)
def exponential(x):
    """Return e^x for a loop that is to be vectorised: no branch, no call.

    The error is below two units of the last place.  That x is above −1e20 is not checked. The
    result is infinite above 1023.5 ln 2, 709.4, and about 0 below −708.
    """
    r, scale = _reduced_argument(x)
    return scale * (1.0 + _small_exponential_less_one(r))


@kernel(fastmath=_CONTRACT, forceinline=True)
def exponential_less_one(x):
    """Return e^x − 1, the same way; nothing cancels where x is small."""
    r, scale = _reduced_argument(x)
    return scale * _small_exponential_less_one(r) + (scale - 1.0)


@kernel(fastmath=_CONTRACT, error_model="numpy", forceinline=True)
def power(x, exponent):
    """Return x^exponent for a loop that is to be vectorised: no branch, no call.

    The error is below two units of the last place.  x is normal and the exponent below 2⁵⁰ in size,
    which is not checked.  Any other gives a number without meaning.  The result is infinite from
    :math:`2^{1023.5}` on, and no less than about :math:`2^{-1022}`.
    """
    shifted = bits_of(x) + (ONE - ROOT_HALF)
    k = double_of((shifted >> FRACTION_BITS) - BIAS + ROUNDER_BITS) - ROUNDER
    m = double_of((shifted & FRACTION) + ROOT_HALF)
    f, denominator = m - 1.0, m + 1.0
    reciprocal = 1.0 / denominator
    s = f * reciprocal
    rounding_of_denominator = m - (denominator - 1.0)
    division_left = multiply_add(-s, denominator, f) - s * rounding_of_denominator
    logarithm = k * LN2_HIGH + 2.0 * s
    small = (2.0 * s - (logarithm - k * LN2_HIGH)) + (
        2.0 * division_left * reciprocal + s * _remainder_of_logarithm(s) + k * LN2_LOW
    )
    y = exponent * logarithm
    small = multiply_add(exponent, logarithm, -y) + exponent * small
    rounded = min(max(y * (1.0 / LN2), LOWEST_EXPONENT), INFINITE_EXPONENT) + ROUNDER
    n = rounded - ROUNDER
    r = ((y - n * LN2_HIGH) - n * LN2_LOW) + small
    scale = double_of((bits_of(rounded) << FRACTION_BITS) + ONE)
    return scale * (1.0 + _small_exponential_less_one(r))
