r"""Natural logarithm of an array, written so that a compiler turns it into vector instructions.

The library's logarithm is called for one number at a time and would take most of the time of a
right-hand side.  Here :math:`x = 2^k m` with :math:`m \in [\sqrt{1/2}, \sqrt2)` is split by integer
arithmetic on the bits, and with :math:`s = f/(2+f)`, :math:`f = m - 1`,

.. math:: \ln m = f - \tfrac12 f^2 + s\,(\tfrac12 f^2 + R(s^2)), \qquad
    R(z) = z P(z) \approx \frac{\ln(1+s) - \ln(1-s)}{s} - 2,

where the minimax polynomial `P` of degree 6 is that of the C library fdlibm (Sun Microsystems,
1993); the error is below one unit of the last place.
"""

import numpy as np

from granular_fronts.compiled import kernel

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


@kernel(error_model="numpy")
def logarithms(x, exponent, mantissa, result):
    """Natural logarithm of every entry.

    Parameters
    ----------
    x : ndarray, shape (n,)
        Positive and normal, that is, at least 2.3e-308; not checked.
    exponent : ndarray of int64, shape (n,)
        Work space, as `mantissa`.
    mantissa, result : ndarray, shape (n,)
    """
    bits, mantissa_bits = x.view(np.int64), mantissa.view(np.int64)
    for i in range(x.size):
        shifted = bits[i] + (ONE - ROOT_HALF)
        exponent[i] = (shifted >> FRACTION_BITS) - BIAS
        mantissa_bits[i] = (shifted & FRACTION) + ROOT_HALF
    for i in range(x.size):
        k, f = float(exponent[i]), mantissa[i] - 1.0
        s = f / (2.0 + f)
        z = s * s
        w = z * z
        remainder = z * (P0 + w * (P2 + w * (P4 + w * P6))) + w * (P1 + w * (P3 + w * P5))
        half_square = 0.5 * f * f
        small = s * (half_square + remainder) + k * LN2_LOW
        result[i] = k * LN2_HIGH - ((half_square - small) - f)
