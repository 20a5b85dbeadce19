r"""Strain form of the dissipative chain, and one compiled Runge-Kutta step of it.

Equations.  With the compressions :math:`u_n = x_n - x_{n+1}`, the forces :math:`F(u) = -V'(-u)` and
:math:`G(u) = -W'(-u)`, the generalised velocity :math:`w_n` of James (2021), eqs. (31)-(32), and
:math:`d_n = w_n - w_{n+1}`,

.. math::

    \dot u_n = d_n + (\Delta_d G(u))_n, \qquad
    \dot d_n = (\Delta_d F(u))_n, \qquad
    (\Delta_d f)_n = f_{n-1} - 2 f_n + f_{n+1} .

For the power law (28) they are :math:`F = u_+^\alpha`, :math:`G = \gamma u_+^\beta`.  There is no
difference :math:`x_{n-1} - x_n` of large numbers to cancel, and beads which the wave has not
reached stay at rest.

Boundaries.  Arrays run over n = 0 … N + 1, so that an index is the paper's bead number.

- Pressure, eq. (25): the contacts 1 … N − 1 move, :math:`u_0 = \delta` and
  :math:`u_N = \tilde\delta` are held.  Entry N of the state carries the last bead itself,
  :math:`u_N := x_N` and :math:`d_N := w_N`.  It obeys the same equations if the forces beyond it
  are continued as a constant, :math:`F_{N+1} = F_N = F(\tilde\delta)`.  Then
  :math:`x_n = \sum_{k\ge n} u_k`, :math:`w_n = \sum_{k\ge n} d_k`, and
  :math:`\sum_n w_n = \sum_n n\,d_n` grows by exactly :math:`(F(\delta) - F(\tilde\delta))\,h` in
  every step: a linear law that a Runge-Kutta method keeps to round-off.
- Ring, eq. (26): all contacts 1 … N move, indices are taken modulo N.
- Wall on the right: contact N moves too, and entry N is :math:`u_N = x_N` as before.
- Force: as pressure, but with a prescribed force f(t) on bead 1, :math:`F_0 = f(t)` and
  :math:`G_0 = 0`.
- Piston: as pressure, but bead 1 moves at a prescribed velocity V(t) of acceleration a(t).
  Newton's law for this bead, of mass 1 like the others, gives the force behind it,
  :math:`F_0 = F_1 + a(t)`.  With :math:`G_0 = G_1` eq. (31) reads :math:`\dot x_1 = w_1`.

A force or an acceleration of time is taken at the time of each stage.  Its pieces (`drives`) are
smooth, and steps end where they meet.  A single law, below, would need :math:`G_0 = \gamma F_0`,
and with it :math:`\gamma\dot f` in :math:`\dot w_1`.  Where γ is not 0, a law that is driven so
has slopes of G of its own.

Masses and contacts that differ.  With masses :math:`m_n`, and factors κ_n of the elastic and χ_n of
the viscous force of contact n, :math:`f_n` stands for :math:`\kappa_n F(u_n)` and
:math:`\chi_n G(u_n)`, and

.. math:: (\Delta_d f)_n = \frac{f_{n-1} - f_n}{m_n} - \frac{f_n - f_{n+1}}{m_{n+1}} .

A piston of mass m_1 has :math:`F_0 = F_1 + m_1 a`.  A body force :math:`m_n g` accelerates all
beads alike and drops out of every difference but the last.  There the force is continued as
:math:`F_{N+1} = F_N + g`, at a bead of mass 1, so that :math:`\dot w_N` alone receives g.  With
a single law its viscous slope would be γg; therefore :math:`d_N = w_N - \gamma g` there.

Active window.  Ahead of bead `reach` every contact is at rest, compressed by the same `ahead`, and
is not visited.

Slopes.  A single law (`state`) stores :math:`\Delta_d F` alone; other laws :math:`\Delta_d G` too.

End of a step.  With the weights b of the pair, those of its error estimates e, and the slopes k and
g of the elastic and viscous forces (`numerics.runge_kutta`),

.. math:: d^+ = d + h\, b\cdot k, \qquad u^+ = u + h\,d + h\, b\cdot g + h^2\, bA\cdot k .

Error of a step.  Its estimates in d are :math:`h\,e\cdot k`.  In u they are, where
:math:`G = \gamma F`, γ times as large, with another sum of the slopes k that is about h times as
large.  One sum, measured against the smaller of scale_d and scale_u/(γ + h), serves both.  Where G
has slopes g of its own, :math:`h\,e\cdot g` is also measured, against scale_u, and γ is 0.
"""

import math
from typing import NamedTuple

from numba import int64, uint64

from granular_fronts.chain.stage_passes import call_stage_pass, sum_rows
from granular_fronts.chain.state import (
    DAMPING,
    ELASTIC_SLOPES,
    FORCE,
    MOBILITY,
    NEW_D,
    NEW_U,
    PARTIAL,
    STIFFNESS,
    VALUE,
    VISCOUS_SLOPES,
    D,
    U,
)
from granular_fronts.model.passes import NEGLIGIBLE, call_row_map
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.bits import bits_of, double_of
from granular_fronts.numerics.compiled import kernel, subroutine

# Loops run over whole vector registers; a remainder costs as much as a block.
WINDOW_BLOCK = 8

# A multiply and an add may fuse. Sums over beads may be reordered where only a norm or an energy
# comes out of them.
_CONTRACT = {"contract"}
_REDUCE = {"contract", "nsz", "reassoc"}

_A, _A_SQUARED = rk.A_WINDOWS.ravel(), rk.A_SQUARED_WINDOWS.ravel()


@subroutine
def _set_weights(chain, h):
    """Weights of the slopes in the stages of a step h."""
    single, h_gamma, h_squared = chain.law.single, h * chain.law.gamma, h * h
    elastic, viscous = chain.elastic_weights.ravel(), chain.viscous_weights.ravel()
    for i in range(uint64(rk.STAGES * rk.LONG)):
        if single:
            elastic[i] = h_gamma * _A[i] + h_squared * _A_SQUARED[i]
        else:
            elastic[i], viscous[i] = h_squared * _A_SQUARED[i], h_gamma * _A[i]


@subroutine
def take_drive(chain, t):
    """Evaluate the drive, if there is one, at the time t of a stage."""
    if not chain.driven:
        return
    piece = chain.drive
    s = t - piece.start
    value = piece.constant + piece.rate * s
    if piece.amplitude != 0.0:
        value += piece.amplitude * math.sin(piece.frequency * s + piece.phase)
    chain.clock.drive = value


@subroutine
def _scale(table, source, first, last):
    """Multiply the forces of the contacts first … last by their factors."""
    factor = source + (STIFFNESS - FORCE)
    for n in range(uint64(first), uint64(last + 1)):
        table[source, n] *= table[factor, n]


@subroutine
def _close(chain, table, source, drive, gravity):
    """Continue a row of forces beyond both ends.

    On a ring it goes on at the other end.  Elsewhere it stays as it is, but for the drive of a
    piston and the body force.
    """
    beads = chain.beads
    if chain.ring:
        table[source, 0] = table[source, beads]
        table[source, beads + 1] = table[source, 1]
        return
    table[source, beads + 1] = table[source, beads] + gravity
    if chain.piston != 0.0:
        table[source, 0] = table[source, 1] + chain.piston * drive


@subroutine
def _complete_forces(chain, table, source, first, last):
    """Scale the forces of the beads first … last where contacts differ, and close their row."""
    if chain.varied:
        _scale(table, source, first, min(last, chain.contacts))
    if source == FORCE:
        if chain.driven:
            table[FORCE, 0] = chain.clock.drive
        _close(chain, table, source, chain.clock.drive, chain.gravity)
    else:
        _close(chain, table, source, 0.0, 0.0)


@subroutine
def _divide_by_masses(table, source, target, first, last):
    """Write (f_{n-1} − f_n)/m_n − (f_n − f_{n+1})/m_{n+1} into a row."""
    for n in range(uint64(first), uint64(last + 1)):
        f = table[source, n]
        behind, ahead = table[source, n - uint64(1)] - f, f - table[source, n + uint64(1)]
        table[target, n] = table[MOBILITY, n] * behind - table[MOBILITY, n + uint64(1)] * ahead


@subroutine(forceinline=True)
def laplacian(chain, table, source, target, first, last):
    """Write Δ_d f into a row, for the beads first … last."""
    _complete_forces(chain, table, source, first, last)
    if chain.varied:
        _divide_by_masses(table, source, target, first, last)
        return
    for n in range(uint64(first), uint64(last + 1)):
        f = table[source, n]
        behind, ahead = table[source, n - uint64(1)], table[source, n + uint64(1)]
        table[target, n] = (behind - f) - (f - ahead)


@subroutine(fastmath=_REDUCE, forceinline=True)
def _laplacian_and_squares(chain, table, target, reach):
    """Do the same of F for equal beads 1 … reach; return the sum of (F_{n-1} − F_n)²."""
    _complete_forces(chain, table, FORCE, int64(1), reach)
    total = 0.0
    for n in range(uint64(1), uint64(reach + 1)):
        f = table[FORCE, n]
        behind, ahead = table[FORCE, n - uint64(1)], table[FORCE, n + uint64(1)]
        table[target, n] = (behind - f) - (f - ahead)
        total += (behind - f) * (behind - f)
    return total


@subroutine(fastmath=_REDUCE, forceinline=True)
def _sum_of_products(table, reach):
    """Return Σ (F_{n-1} − F_n)(G_{n-1} − G_n) over the beads 1 … reach."""
    total = 0.0
    for n in range(uint64(1), uint64(reach + 1)):
        force = table[FORCE, n - uint64(1)] - table[FORCE, n]
        total += force * (table[DAMPING, n - uint64(1)] - table[DAMPING, n])
    return total


@subroutine(fastmath=_REDUCE, forceinline=True)
def _varied_products(table, viscous, reach):
    """Return Σ (F_{n-1} − F_n)(G_{n-1} − G_n)/m_n over the beads 1 … reach."""
    total = 0.0
    for n in range(uint64(1), uint64(reach + 1)):
        force = table[FORCE, n - uint64(1)] - table[FORCE, n]
        total += table[MOBILITY, n] * force * (table[viscous, n - uint64(1)] - table[viscous, n])
    return total


@subroutine(forceinline=True)
def _difference_forces(chain, table, slot, reach, with_power):
    """Write slopes of the present forces into a slot; return the dissipated power, if asked.

    It is the sum over beads in the energy balance of `equations`.
    """
    single = chain.law.single
    target = ELASTIC_SLOPES + slot
    viscous = FORCE if single else DAMPING
    products = 0.0
    if single and with_power and not chain.varied:
        products = _laplacian_and_squares(chain, table, target, reach)
    else:
        laplacian(chain, table, FORCE, target, int64(1), reach)
        if not single:
            laplacian(chain, table, DAMPING, VISCOUS_SLOPES + slot, int64(1), reach)
        if with_power:
            if chain.varied:
                products = _varied_products(table, viscous, reach)
            else:
                products = _sum_of_products(table, reach)
    if chain.driven:
        # Of the first bead alone: the slope of w_1.
        table[target, 0] = table[MOBILITY, 1] * (table[FORCE, 0] - table[FORCE, 1]) + chain.gravity
    if not with_power:
        return 0.0
    # G beyond the end is continued as a constant, so that this is the whole of Σ m_n (ẋ_n − w_n).
    products += chain.gravity * (table[viscous, 0] - table[viscous, chain.beads])
    return products * chain.law.gamma


@subroutine(fastmath=_REDUCE)
def _sum(table, row, reach):
    """Return the sum of a row over the beads 1 … reach."""
    total = 0.0
    for n in range(uint64(1), uint64(reach + 1)):
        total += table[row, n]
    return total


@subroutine(fastmath=_REDUCE)
def _slope_of_first(table, row):
    """Return what the stages before `row` give for the slope of w_1."""
    total = 0.0
    for earlier in range(row):
        total += rk.A[row, earlier] * table[ELASTIC_SLOPES + rk.SLOT[earlier], 0]
    return total


@subroutine
def _supplied_power(chain, table, w_1):
    """Return F_0 ẋ_1, what a drive supplies, from w_1 and the present forces."""
    viscous = FORCE if chain.law.single else DAMPING
    difference = chain.law.gamma * (table[viscous, 0] - table[viscous, 1])
    return table[FORCE, 0] * (w_1 + table[MOBILITY, 1] * difference)


@subroutine(forceinline=True)
def take_forces(law, table, source, first, last):
    """Write the forces of the compressions first … last of a row."""
    call_row_map(law.elastic, table[source], table[FORCE], first, last, law.elastic_parameters)
    if not law.single:
        call_row_map(
            law.viscous, table[source], table[DAMPING], first, last, law.viscous_parameters
        )


@subroutine(forceinline=True)
def take_slopes(chain, table, source, slot, reach, with_power):
    """Write slopes of the compressions of a row into a slot; return the power, if asked."""
    take_forces(chain.law, table, source, int64(1), min(reach, chain.contacts))
    power = _difference_forces(chain, table, slot, reach, with_power)
    if with_power and chain.driven:
        chain.clock.w_1 = _sum(table, source + (D - U), reach)
        power -= _supplied_power(chain, table, chain.clock.w_1)
    return power


@subroutine(forceinline=True)
def _take_stage(chain, table, row, h, reach, with_power):
    """Write the slopes of stage `row` from earlier stages; return the power, if asked."""
    law, last = chain.law, min(reach, chain.contacts)
    first, terms, factor = rk.FIRST_SLOT[row], rk.TERMS[row], h * rk.C[row]
    elastic, weights = (ELASTIC_SLOPES + first, terms), chain.elastic_weights[row]
    if law.stage_pass != 0:
        call_stage_pass(
            law.stage_pass, table, elastic, last, factor, weights, law.elastic_parameters
        )
    else:
        target = VALUE if law.single else PARTIAL
        sum_rows(table, target, U, D, factor, elastic, weights, last)
        if not law.single:
            viscous, weights = (VISCOUS_SLOPES + first, terms), chain.viscous_weights[row]
            sum_rows(table, VALUE, PARTIAL, D, 0.0, viscous, weights, last)
        take_forces(law, table, VALUE, int64(1), last)
    take_drive(chain, chain.clock.t + factor)
    power = _difference_forces(chain, table, rk.SLOT[row], reach, with_power)
    if with_power and chain.driven:
        power -= _supplied_power(chain, table, chain.clock.w_1 + h * _slope_of_first(table, row))
    return power


class Largest(NamedTuple):
    """Maxima over beads, from one step."""

    # Of the error estimates of order 5 and 3 from the elastic slopes, and from the viscous slopes,
    # which are 0 for a single law.
    fifth: float
    third: float
    fifth_viscous: float
    third_viscous: float
    # Of u and |d| at the start of the step; of |u| if the law acts in extension too.
    compression: float
    rate: float
    # Of |u| + |d| at its end; NaN or infinite if any bead is.
    state: float


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _final_sum(table, slopes, weights, n):
    """Return the weighted sum of the slopes of bead n over the final stages."""
    total = 0.0
    for j in range(len(weights)):
        if weights[j] != 0.0:
            total += weights[j] * table[slopes + uint64(rk.FINAL_SLOTS[j]), n]
    return total


@subroutine(fastmath=_CONTRACT, forceinline=True)
def _add_elastic(chain, table, h, first, last):
    """Return the new state from the elastic slopes, and `Largest`, for the beads first … last.

    Non-negative doubles are ordered like their bits read as integers, with NaN above all.  Integer
    maxima vectorise, and no NaN is lost in them.
    """
    slopes = uint64(ELASTIC_SLOPES)
    h_gamma, h_squared = (h * chain.law.gamma if chain.law.single else 0.0), h * h
    attraction = chain.law.attraction
    fifth = third = compression = rate = total = int64(0)
    for n in range(uint64(first), uint64(last + 1)):
        # All sums before the stores, so that each slope is loaded once.
        b, b_a = (
            _final_sum(table, slopes, rk.FINAL_B, n),
            _final_sum(table, slopes, rk.FINAL_B_A, n),
        )
        error_5 = _final_sum(table, slopes, rk.FINAL_5, n)
        error_3 = b + _final_sum(table, slopes, rk.FINAL_3_LESS_B, n)
        u, d = table[U, n], table[D, n]
        new_u, new_d = u + (h * d + (h_gamma * b + h_squared * b_a)), d + h * b
        table[NEW_U, n], table[NEW_D, n] = new_u, new_d
        fifth, third = max(fifth, bits_of(abs(error_5))), max(third, bits_of(abs(error_3)))
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
def _add_viscous(chain, table, h, first, last):
    """Add the viscous slopes to the new u; the largest estimates of order 5 and 3."""
    slopes = uint64(VISCOUS_SLOPES)
    fifth = third = int64(0)
    for n in range(uint64(first), uint64(last + 1)):
        b = _final_sum(table, slopes, rk.FINAL_B, n)
        error_5 = _final_sum(table, slopes, rk.FINAL_5, n)
        error_3 = b + _final_sum(table, slopes, rk.FINAL_3_LESS_B, n)
        table[NEW_U, n] += h * b
        fifth, third = max(fifth, bits_of(abs(error_5))), max(third, bits_of(abs(error_3)))
    return h * double_of(fifth), h * double_of(third)


@subroutine(forceinline=True)
def _finish(chain, table, h, first, last):
    """Return the new state of the beads first … last, and their `Largest`."""
    largest = _add_elastic(chain, table, h, first, last)
    if chain.law.single:
        return largest
    fifth, third = _add_viscous(chain, table, h, first, last)
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
    """Return the error of the step in units of the tolerance, in the maximum norm over beads.

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


@subroutine(forceinline=True)
def try_step(chain, table, h, reach, with_energy):
    """Return all stages and the new state for a step h: its `Largest` and the energy dissipated.

    The slopes and the power at the start must be there.  The power of every stage is taken while
    its forces are in the cache.  It is added up by the pair's own quadrature, of order 8.  With
    pressure at the ends entry N holds the last bead.  It drives only itself, so that it stays
    outside the error norm.
    """
    _set_weights(chain, h)
    energy = rk.B[0] * chain.clock.power
    for row in range(1, rk.STAGES):
        with_power = with_energy and rk.B[row] != 0.0
        energy += rk.B[row] * _take_stage(chain, table, row, h, reach, with_power)
    last = min(reach, chain.contacts)
    # The last bead first, so that what is largest is that of the others.
    first, end = (reach, reach) if reach > last else (int64(1), last)
    while True:
        largest = _finish(chain, table, h, first, end)
        if first == 1:
            return largest, h * energy
        first, end = int64(1), last


@subroutine
def accept(chain, table, reach):
    """Make the new state and its slopes the start of the next step."""
    start, end = rk.SLOT[0], rk.SLOT[rk.NEW_SLOPE]
    table[ELASTIC_SLOPES + start, 0] = table[ELASTIC_SLOPES + end, 0]
    for n in range(uint64(1), uint64(reach + 1)):
        table[U, n] = table[NEW_U, n]
        table[D, n] = table[NEW_D, n]
        table[ELASTIC_SLOPES + start, n] = table[ELASTIC_SLOPES + end, n]
    if not chain.law.single:
        for n in range(uint64(1), uint64(reach + 1)):
            table[VISCOUS_SLOPES + start, n] = table[VISCOUS_SLOPES + end, n]


@kernel
def end_of_window(chain, table, start):
    """Return the last bead the wave can touch within one step, looking down from bead `start`.

    It is the bead `margin` beyond the last one that differs from rest, rounded up to whole blocks.
    """
    ahead = chain.ahead
    n = start
    while n > 1 and abs(table[U, n] - ahead) <= NEGLIGIBLE and abs(table[D, n]) <= NEGLIGIBLE:
        n -= 1
    blocks = (n + chain.margin + WINDOW_BLOCK - 1) // WINDOW_BLOCK
    return min(blocks * WINDOW_BLOCK, chain.beads)


@subroutine
def forget_slopes(chain, table):
    """Set the slopes of all stages but the first to 0.

    A stage multiplies slopes that it does not use by 0, which must not meet numbers that are not
    finite.
    """
    kept = rk.SLOT[0]
    for slot in range(rk.SLOPES):
        if slot != kept:
            table[ELASTIC_SLOPES + slot, :] = 0.0
            if not chain.law.single:
                table[VISCOUS_SLOPES + slot, :] = 0.0
