r"""The end of a step: the new state, and the error of the pair.

With the weights b of the pair, those of its error estimates e, and the slopes k and g of the
elastic and viscous forces (`numerics.runge_kutta`),

.. math:: d^+ = d + h\, b\cdot k, \qquad u^+ = u + h\,d + h\, b\cdot g + h^2\, bA\cdot k .

Error of a step.  Its estimates in d are :math:`h\,e\cdot k`; in u they are, where
:math:`G = \gamma F`, γ times as large, with another sum of the slopes k that is about h times as
large.  One sum, measured against the smaller of scale_d and scale_u/(γ + h), serves both.  Where G
has slopes g of its own, :math:`h\,e\cdot g` is measured against scale_u beside it, and γ is 0.
"""

import math
from typing import NamedTuple

from numba import int64, uint64

from granular_fronts.chain.state import ELASTIC_SLOPES, NEW_D, NEW_U, VISCOUS_SLOPES, D, U
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.bits import bits_of, double_of
from granular_fronts.numerics.compiled import subroutine

_CONTRACT = {"contract"}


class Largest(NamedTuple):
    """Maxima over beads, from one step.

    Attributes
    ----------
    fifth, third : float
        Of the error estimates of order 5 and 3 from the elastic slopes.
    fifth_viscous, third_viscous : float
        The same from the viscous slopes, 0 for a single law.
    compression, rate : float
        Of u and |d| at the start of the step; of |u| if the law acts in extension too.
    state : float
        Of |u| + |d| at its end; NaN or infinite if any bead is.
    """

    fifth: float
    third: float
    fifth_viscous: float
    third_viscous: float
    compression: float
    rate: float
    state: float


@subroutine(fastmath=_CONTRACT, forceinline=True)
def final_sum(table, slopes, weights, n):
    """Weighted sum of the slopes of bead n over the final stages."""
    total = 0.0
    for j in range(len(weights)):
        total += weights[j] * table[slopes + uint64(rk.FINAL_SLOTS[j]), n]
    return total


@subroutine(fastmath=_CONTRACT, forceinline=True)
def add_elastic(chain, table, h, first, last):
    """New state from the elastic slopes, and `Largest`, for the beads first … last.

    Non-negative doubles are ordered like their bits read as integers, with NaN above all: integer
    maxima vectorise, and no NaN is lost in them.
    """
    slopes = uint64(ELASTIC_SLOPES)
    h_gamma, h_squared = (h * chain.law.gamma if chain.law.single else 0.0), h * h
    attraction = chain.law.attraction
    fifth = third = compression = rate = total = int64(0)
    for n in range(uint64(first), uint64(last + 1)):
        b, b_a = final_sum(table, slopes, rk.FINAL_B, n), final_sum(table, slopes, rk.FINAL_B_A, n)
        u, d = table[U, n], table[D, n]
        new_u, new_d = u + (h * d + (h_gamma * b + h_squared * b_a)), d + h * b
        table[NEW_U, n], table[NEW_D, n] = new_u, new_d
        fifth = max(fifth, bits_of(abs(final_sum(table, slopes, rk.FINAL_5, n))))
        third = max(third, bits_of(abs(final_sum(table, slopes, rk.FINAL_3, n))))
        compression = max(compression, bits_of(max(u, -attraction * u)))
        rate = max(rate, bits_of(abs(d)))
        total = max(total, bits_of(abs(new_u) + abs(new_d)))
    return Largest(
        h * double_of(fifth),
        h * double_of(third),
        0.0,
        0.0,
        double_of(compression),
        double_of(rate),
        double_of(total),
    )


@subroutine(fastmath=_CONTRACT, forceinline=True)
def add_viscous(chain, table, h, first, last):
    """Add the viscous slopes to the new u; the largest estimates of order 5 and 3."""
    slopes = uint64(VISCOUS_SLOPES)
    fifth = third = int64(0)
    for n in range(uint64(first), uint64(last + 1)):
        table[NEW_U, n] += h * final_sum(table, slopes, rk.FINAL_B, n)
        fifth = max(fifth, bits_of(abs(final_sum(table, slopes, rk.FINAL_5, n))))
        third = max(third, bits_of(abs(final_sum(table, slopes, rk.FINAL_3, n))))
    return h * double_of(fifth), h * double_of(third)


@subroutine(forceinline=True)
def finish(chain, table, h, first, last):
    """New state of the beads first … last, and their `Largest`."""
    largest = add_elastic(chain, table, h, first, last)
    if chain.law.single:
        return largest
    fifth, third = add_viscous(chain, table, h, first, last)
    return Largest(
        largest.fifth,
        largest.third,
        fifth,
        third,
        largest.compression,
        largest.rate,
        # NaN where the viscous slopes are.
        largest.state + 0.0 * fifth,
    )


@subroutine
def error_norm(law, largest, h, relative, absolute):
    """Error of the step in units of the tolerance, in the maximum norm over beads.

    u and d are each measured against absolute + relative × (largest u, largest |d|), and the
    estimates of order 5 and 3 are combined as in DOP853.  NaN if the new state is not finite.
    """
    if not math.isfinite(largest.state):
        return math.nan
    scale_u = absolute + relative * largest.compression
    scale_d = absolute + relative * largest.rate
    scale = min(scale_d, scale_u / (h + (law.gamma if law.single else 0.0)))
    fifth = max(largest.fifth / scale, largest.fifth_viscous / scale_u)
    third = max(largest.third / scale, largest.third_viscous / scale_u)
    if fifth == 0.0:
        return 0.0
    ratio = 0.1 * third / fifth
    return fifth / math.sqrt(1.0 + ratio * ratio)
