r"""Dense output of a step: the continuous extension of order 7, of all contacts or of a few.

With weights :math:`b_j(\theta)` of the sixteen slopes,

.. math::

    u(\theta) = u + \theta h\,d + \sum_j \Bigl( h\, b_j g_j
        + h^2 \sum_l b_l a_{lj}\, k_j \Bigr), \qquad d(\theta) = d + h\sum_j b_j k_j .

Three of the slopes belong to stages that nothing else uses.  A slope depends on the neighbouring
contacts alone, so that the polynomial of contact n needs the first of the three stages on the
contacts n ± 3, the second on n ± 2 and the third on n ± 1; only these are computed.
"""

import numpy as np
from numba import uint64

from granular_fronts.chain.state import (
    DAMPING,
    ELASTIC_SLOPES,
    FORCE,
    NEW_D,
    NEW_U,
    VALUE,
    VISCOUS_SLOPES,
    D,
    U,
)
from granular_fronts.chain.strain import laplacian
from granular_fronts.model.passes import call_row_map
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.compiled import subroutine

_CONTRACT = {"contract"}


@subroutine(forceinline=True)
def take_output_stages(chain, table, h, first, last):
    """The three stages that only dense output uses, as far as the contacts first … last need them.

    The rows `VALUE`, `FORCE` and `DAMPING` are left as the last stage needs them.
    """
    if chain.contacts == chain.beads:
        first, last = 1, chain.beads
    law, clock = chain.law, chain.clock
    for row in range(rk.NEW_SLOPE + 1, rk.SLOPES):
        distance = rk.SLOPES - row
        low, high = max(1, first - distance), min(clock.reach, last + distance)
        contacts = min(high, chain.contacts)
        sum_all_slots(chain, table, row, h, low, contacts)
        call_row_map(law.elastic, table[VALUE], table[FORCE], low, contacts, law.elastic_parameters)
        slot = rk.SLOT[row]
        laplacian(chain, table, FORCE, ELASTIC_SLOPES + slot, clock.acceleration, low, high)
        if not law.single:
            call_row_map(
                law.viscous, table[VALUE], table[DAMPING], low, contacts, law.viscous_parameters
            )
            laplacian(chain, table, DAMPING, VISCOUS_SLOPES + slot, 0.0, low, high)


@subroutine(fastmath=_CONTRACT, forceinline=True)
def sum_all_slots(chain, table, row, h, low, high):
    """U of an output stage on the contacts low … high."""
    single, h_gamma, h_squared = chain.law.single, h * chain.law.gamma, h * h
    for n in range(uint64(low), uint64(high + 1)):
        table[VALUE, n] = table[U, n] + h * rk.C[row] * table[D, n]
    for slot in range(rk.SLOPES - 1):
        on_g, on_k = h_gamma * rk.A_SLOTS[row, slot], h_squared * rk.A_SQUARED_SLOTS[row, slot]
        if single:
            on_k += on_g
        for n in range(uint64(low), uint64(high + 1)):
            table[VALUE, n] += on_k * table[ELASTIC_SLOPES + slot, n]
        if not single:
            for n in range(uint64(low), uint64(high + 1)):
                table[VALUE, n] += on_g * table[VISCOUS_SLOPES + slot, n]


@subroutine
def contact_polynomial(chain, table, h, n, coefficients):
    """Coefficients of u_n(θ) in powers of θ, constant term first."""
    viscous = ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    h_gamma, h_squared = h * chain.law.gamma, h * h
    coefficients[:] = 0.0
    for slot in range(rk.SLOPES):
        on_g = h_gamma * table[viscous + slot, n]
        on_k = h_squared * table[ELASTIC_SLOPES + slot, n]
        for power in range(uint64(rk.DEGREE + 1)):
            coefficients[power] += rk.CONTINUOUS_OF_SLOT[slot, power] * on_g
            coefficients[power] += rk.CONTINUOUS_A_OF_SLOT[slot, power] * on_k
    coefficients[0] += table[U, n]
    coefficients[1] += h * table[D, n]


@subroutine(fastmath=_CONTRACT, forceinline=True)
def write_state(chain, table, h, theta, row_u, row_d):
    """u(θ) and d(θ) of all beads of the active window; at θ = 1 the new state itself."""
    reach = chain.clock.reach
    if theta == 1.0:
        for n in range(1, reach + 1):
            row_u[n] = table[NEW_U, n]
            row_d[n] = table[NEW_D, n]
        return
    for n in range(1, reach + 1):
        row_u[n] = table[U, n] + theta * h * table[D, n]
        row_d[n] = table[D, n]
    viscous = ELASTIC_SLOPES if chain.law.single else VISCOUS_SLOPES
    powers = theta ** np.arange(rk.DEGREE + 1)
    for slot in range(rk.SLOPES):
        b = np.sum(rk.CONTINUOUS_OF_SLOT[slot] * powers)
        on_g = h * chain.law.gamma * b
        on_k = h * h * np.sum(rk.CONTINUOUS_A_OF_SLOT[slot] * powers)
        for n in range(uint64(1), uint64(reach + 1)):
            k = table[ELASTIC_SLOPES + slot, n]
            row_u[n] += on_g * table[viscous + slot, n] + on_k * k
            row_d[n] += h * b * k
