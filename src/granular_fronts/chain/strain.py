r"""Strain form of the dissipative chain, and one compiled Runge-Kutta step of it.

Equations.  With :math:`u_n = x_n - x_{n+1}` (compression > 0), the generalised velocity
:math:`w_n` of James (2021), eqs. (31)-(32), and :math:`d_n = w_n - w_{n+1}`,

.. math::

    \dot u_n = d_n + \gamma\,(\Delta_d u_+^\beta)_n, \qquad
    \dot d_n = (\Delta_d u_+^\alpha)_n, \qquad
    (\Delta_d f)_n = f_{n-1} - 2 f_n + f_{n+1} .

There is no difference :math:`x_{n-1} - x_n` of large numbers to cancel, and beads which the wave
has not reached stay zero.

Boundaries.  Arrays run over n = 0 … N + 1, so that an index is the paper's bead number.

- Pressure, eq. (25): the contacts 1 … N − 1 move, :math:`u_0 = \delta` and
  :math:`u_N = \tilde\delta` are held.  Entry N of the state carries the last bead itself,
  :math:`u_N := x_N` and :math:`d_N := w_N`; it obeys the same equations if the forces beyond it are
  continued as a constant, :math:`F_{N+1} = F_N = \tilde\delta^\alpha`.  Then
  :math:`x_n = \sum_{k\ge n} u_k`, :math:`w_n = \sum_{k\ge n} d_k`, and
  :math:`\sum_n w_n = \sum_n n\,d_n` grows by exactly
  :math:`(\delta^\alpha - \tilde\delta^\alpha)\,h` in every step: a linear law that a Runge-Kutta
  method keeps to round-off.
- Ring, eq. (26): all contacts 1 … N move, indices are taken modulo N.
- Piston: as pressure, but bead 1 moves at a prescribed velocity V(t), whose acceleration a is
  piecewise constant.  Newton's law for this bead, of mass 1 like the others, gives the force behind
  it: :math:`F_0 = F_1 + a` closes both Laplacians, the mirror image of contact 1 shifted by a.
  Then :math:`\dot d_1 = a - F_1 + F_2`, and since the viscous closure has the same shift,
  eq. (31) reads :math:`\dot x_1 = w_1 + \gamma a`: g may be read from k here too, and w_1 jumps
  by γ times the jump of a.

Active window.  Entries beyond the `reach` of the wave are exactly zero and are not visited.

Kernels.  One nonlinearity is evaluated per contact and stage when β = α or γ = 0 (kinds `HERTZ`, α
= 3/2, and `POWER`), two otherwise (`PAIR`).  The slopes of bead n are
`k[:, n]` :math:`= \Delta_d u_+^\alpha` and, for `PAIR` only, `g[:, n]`
:math:`= \Delta_d u_+^\beta`; the other kinds read g from k.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import int64, uint64

from granular_fronts.chain.state import HERTZ, PAIR
from granular_fronts.numerics import runge_kutta as rk
from granular_fronts.numerics.bits import bits_of, double_of
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.vector_functions import power

# A smaller compression exerts no force: it could not influence another bead in double precision,
# and arithmetic on the subnormal numbers that its powers lead to is a hundred times slower.
NEGLIGIBLE = 1.0e-60
WINDOW_MARGIN = 4
# Loops run over whole blocks of vector registers; a remainder costs as much as a block.
WINDOW_BLOCK = 32
ALL = np.arange(rk.SLOPES)

# A multiply and an add may fuse; sums over beads may be reordered where nothing but a norm or an
# energy comes out of them.
_CONTRACT = {"contract"}
_REDUCE = {"contract", "nsz", "reassoc"}


@kernel(fastmath=_CONTRACT)
def stage_value(state, columns, a, a_squared, c, h, h_gamma, n):
    """U_i of bead n when one nonlinearity drives both equations; weights at `columns` only."""
    value = state.u[n] + c * h * state.d[n]
    for j in range(len(a)):
        value += (h_gamma * a[j] + h * h * a_squared[j]) * state.k[columns[j], n]
    return value


@kernel(fastmath=_CONTRACT)
def stage_value_pair(state, a, a_squared, c, h, h_gamma, n):
    """U_i of bead n when the damping has an exponent of its own."""
    value = state.u[n] + c * h * state.d[n]
    for j in range(len(a)):
        value += h_gamma * a[j] * state.g[j, n] + h * h * a_squared[j] * state.k[j, n]
    return value


@kernel(fastmath=_CONTRACT)
def laplacian(force, slopes, row, size, reach):
    """Write f_{n-1} − 2 f_n + f_{n+1} into a row, for beads 1 … reach.

    A ring and a piston are closed first.
    """
    if size.contacts == size.beads:
        force[0] = force[size.beads]
        force[size.beads + 1] = force[1]
    if size.piston:
        force[0] = force[1] + size.acceleration
    for n in range(uint64(1), uint64(reach + 1)):
        slopes[row, n] = force[n - uint64(1)] - 2.0 * force[n] + force[n + uint64(1)]


@kernel(fastmath=_CONTRACT)
def raise_to(exponent, u, force, last):
    """Write u₊^exponent of the contacts 1 … last into `force`."""
    if exponent == 1.5:
        for n in range(uint64(1), uint64(last + 1)):
            compression = u[n] if u[n] > NEGLIGIBLE else 0.0
            force[n] = compression * math.sqrt(compression)
    elif exponent == 1.0:
        for n in range(uint64(1), uint64(last + 1)):
            force[n] = u[n] if u[n] > NEGLIGIBLE else 0.0
    else:
        for n in range(uint64(1), uint64(last + 1)):
            # Taken of every number, so that there is no branch and the loop is vectorised.
            whole = power(u[n], exponent)
            force[n] = whole if u[n] > NEGLIGIBLE else 0.0


@kernel(forceinline=True)
def evaluate_slopes(law, size, state, u, row, reach):
    """Slopes of the state `u`, which may be row `row` of k, into that row of k (and g)."""
    last = min(reach, size.contacts)
    if law.kind == PAIR:
        raise_to(law.beta, u, state.damping, last)
        laplacian(state.damping, state.g, row, size, reach)
    raise_to(law.alpha, u, state.force, last)
    laplacian(state.force, state.k, row, size, reach)


@kernel(fastmath=_CONTRACT, forceinline=True)
def hertz_stage(law, size, state, row, weights, h, reach):
    """Stage `row` for the force u₊^{3/2}.

    The weights are tuples, so that the sum over earlier slopes is unrolled and the loop over beads
    vectorises, square root included.
    """
    columns, a, a_squared = weights
    force = state.force
    h_gamma = h * law.gamma
    for n in range(uint64(1), uint64(min(reach, size.contacts) + 1)):
        value = stage_value(state, columns, a, a_squared, rk.C[row], h, h_gamma, n)
        compression = value if value > NEGLIGIBLE else 0.0
        force[n] = compression * math.sqrt(compression)
    laplacian(force, state.k, row, size, reach)


@kernel(fastmath=_CONTRACT)
def add_slopes(row, on_a, on_a_squared, slopes, u, last):
    """Add the earlier slopes of stage `row` to the contacts 1 … last, four in one pass."""
    columns, a, a_squared = rk.COLUMNS, rk.A_IN_BLOCKS, rk.A_SQUARED_IN_BLOCKS
    for j in range(0, rk.ENDS[row], rk.BLOCK):
        i0, i1 = columns[row, j], columns[row, j + 1]
        i2, i3 = columns[row, j + 2], columns[row, j + 3]
        w0 = on_a * a[row, j] + on_a_squared * a_squared[row, j]
        w1 = on_a * a[row, j + 1] + on_a_squared * a_squared[row, j + 1]
        w2 = on_a * a[row, j + 2] + on_a_squared * a_squared[row, j + 2]
        w3 = on_a * a[row, j + 3] + on_a_squared * a_squared[row, j + 3]
        for n in range(uint64(1), uint64(last + 1)):
            u[n] += (w0 * slopes[i0, n] + w1 * slopes[i1, n]) + (
                w2 * slopes[i2, n] + w3 * slopes[i3, n]
            )


@kernel(fastmath=_CONTRACT)
def power_stage(law, size, state, row, h, reach):
    """Stage `row` for general exponents; one loop serves all stages, which compiles sooner."""
    last = min(reach, size.contacts)
    h_c, h_gamma = h * rk.C[row], h * law.gamma
    value, u, d = state.k[row], state.u, state.d
    for n in range(uint64(1), uint64(last + 1)):
        value[n] = u[n] + h_c * d[n]
    if law.kind == PAIR:
        add_slopes(row, h_gamma, 0.0, state.g, value, last)
        add_slopes(row, 0.0, h * h, state.k, value, last)
    else:
        add_slopes(row, h_gamma, h * h, state.k, value, last)
    evaluate_slopes(law, size, state, value, row, reach)


@kernel
def stages(law, size, state, h, reach):
    """The eleven stages after the first, whose slopes stand in row 0."""
    if law.kind != HERTZ:
        for row in range(1, rk.STAGES):
            power_stage(law, size, state, row, h, reach)
        return
    rows = rk.STAGE_ROWS
    hertz_stage(law, size, state, 1, rows[1], h, reach)
    hertz_stage(law, size, state, 2, rows[2], h, reach)
    hertz_stage(law, size, state, 3, rows[3], h, reach)
    hertz_stage(law, size, state, 4, rows[4], h, reach)
    hertz_stage(law, size, state, 5, rows[5], h, reach)
    hertz_stage(law, size, state, 6, rows[6], h, reach)
    hertz_stage(law, size, state, 7, rows[7], h, reach)
    hertz_stage(law, size, state, 8, rows[8], h, reach)
    hertz_stage(law, size, state, 9, rows[9], h, reach)
    hertz_stage(law, size, state, 10, rows[10], h, reach)
    hertz_stage(law, size, state, 11, rows[11], h, reach)


@kernel
def stages_for_output(law, size, state, h, reach):
    """The three stages that only the continuous extension uses."""
    if law.kind != HERTZ:
        for row in range(rk.NEW_SLOPE + 1, rk.SLOPES):
            power_stage(law, size, state, row, h, reach)
        return
    rows = rk.STAGE_ROWS
    hertz_stage(law, size, state, 13, rows[13], h, reach)
    hertz_stage(law, size, state, 14, rows[14], h, reach)
    hertz_stage(law, size, state, 15, rows[15], h, reach)


class Largest(NamedTuple):
    """Maxima over beads, from one step.

    Attributes
    ----------
    fifth_u, third_u, fifth_d, third_d : float
        Of the error estimates of order 5 and 3 in u and d.
    compression, rate : float
        Of u₊ and |d| at the start of the step.
    state : float
        Of |u| + |d| at its end; NaN or infinite if any bead is.
    """

    fifth_u: float
    third_u: float
    fifth_d: float
    third_d: float
    compression: float
    rate: float
    state: float


@kernel(fastmath=_CONTRACT, forceinline=True)
def combine(row, slopes, n):
    """Weighted sum over the stages of the slopes of bead n."""
    columns, weights = row
    total = 0.0
    for j in range(len(weights)):
        total += weights[j] * slopes[columns[j], n]
    return total


@kernel(fastmath=_CONTRACT)
def finish_range(law, state, h, first, last):
    """New state and `Largest` for the beads first … last, in one pass over the slopes.

    Non-negative doubles are ordered like their bits read as integers, with NaN above all: integer
    maxima vectorise, and no NaN is lost in them.
    """
    u, d, new_u, new_d, k, g = state.u, state.d, state.new_u, state.new_d, state.k, state.g
    pair = law.kind == PAIR
    h_gamma, h_squared = h * law.gamma, h * h
    fifth_u = third_u = fifth_d = third_d = compression = rate = total = int64(0)
    for n in range(uint64(first), uint64(last + 1)):
        b_k, ba_k = combine(rk.B_ROW, k, n), combine(rk.B_A_ROW, k, n)
        e5_k, e5a_k = combine(rk.ERROR_5_ROW, k, n), combine(rk.ERROR_5_A_ROW, k, n)
        e3_k, e3a_k = combine(rk.ERROR_3_ROW, k, n), combine(rk.ERROR_3_A_ROW, k, n)
        b_g = combine(rk.B_ROW, g, n) if pair else b_k
        e5_g = combine(rk.ERROR_5_ROW, g, n) if pair else e5_k
        e3_g = combine(rk.ERROR_3_ROW, g, n) if pair else e3_k
        next_d = d[n] + h * b_k
        next_u = u[n] + (h * d[n] + (h_gamma * b_g + h_squared * ba_k))
        new_d[n], new_u[n] = next_d, next_u
        fifth_u = max(fifth_u, bits_of(abs(h_gamma * e5_g + h_squared * e5a_k)))
        third_u = max(third_u, bits_of(abs(h_gamma * e3_g + h_squared * e3a_k)))
        fifth_d = max(fifth_d, bits_of(abs(h * e5_k)))
        third_d = max(third_d, bits_of(abs(h * e3_k)))
        compression = max(compression, bits_of(max(u[n], 0.0)))
        rate = max(rate, bits_of(abs(d[n])))
        total = max(total, bits_of(abs(next_u) + abs(next_d)))
    return Largest(
        double_of(fifth_u),
        double_of(third_u),
        double_of(fifth_d),
        double_of(third_d),
        double_of(compression),
        double_of(rate),
        double_of(total),
    )


@kernel
def finish(law, size, state, h, reach):
    """New state of the active window and the `Largest` of its moving contacts.

    With pressure at the ends entry N holds the last bead; it drives nothing but itself, so that it
    stays outside the error norm.
    """
    last = min(reach, size.contacts)
    if reach > last:
        finish_range(law, state, h, reach, reach)
    return finish_range(law, state, h, 1, last)


@kernel
def error_norm(largest, relative, absolute):
    """Error of the step in units of the tolerance, in the maximum norm over beads.

    u and d are each measured against absolute + relative × (largest u₊, largest |d|), and the
    estimates of order 5 and 3 are combined as in DOP853.  NaN if the new state is not finite.
    """
    if not math.isfinite(largest.state):
        return math.nan
    scale_u = absolute + relative * largest.compression
    scale_d = absolute + relative * largest.rate
    fifth = max(largest.fifth_u / scale_u, largest.fifth_d / scale_d)
    third = max(largest.third_u / scale_u, largest.third_d / scale_d)
    if fifth == 0.0:
        return 0.0
    ratio = 0.1 * third / fifth
    return fifth / math.sqrt(1.0 + ratio * ratio)


@kernel
def try_step(law, size, state, h, reach):
    """All stages and the new state for a step h; the slopes of the start stand in row 0."""
    stages(law, size, state, h, reach)
    return finish(law, size, state, h, reach)


@kernel
def accept(state, reach):
    """Make the new state and its slopes (row 12) the start of the next step."""
    for n in range(uint64(1), uint64(reach + 1)):
        state.u[n] = state.new_u[n]
        state.d[n] = state.new_d[n]
        state.k[0, n] = state.k[rk.NEW_SLOPE, n]
        state.g[0, n] = state.g[rk.NEW_SLOPE, n]


@kernel
def reach_of(size, u, d, start):
    """Last bead the wave can touch within one step, looking down from bead `start`."""
    return end_of_window(u, d, 0.0, WINDOW_MARGIN, start, size.beads)


@kernel
def end_of_window(u, d, ahead, margin, start, end):
    """The bead `margin` beyond the last one of 1 … start that differs from u = `ahead`, d = 0.

    Rounded up to whole blocks, and at most `end`.
    """
    n = start
    while n > 1 and abs(u[n] - ahead) <= NEGLIGIBLE and abs(d[n]) <= NEGLIGIBLE:
        n -= 1
    blocks = (n + margin + WINDOW_BLOCK - 1) // WINDOW_BLOCK
    return min(blocks * WINDOW_BLOCK, end)


@kernel(fastmath=_CONTRACT)
def compression(law, state, row, h, n):
    """u₊ of contact n at stage `row`."""
    a, a_squared = rk.A[row, :row], rk.A_SQUARED[row, :row]
    if law.kind == PAIR:
        return max(0.0, stage_value_pair(state, a, a_squared, rk.C[row], h, h * law.gamma, n))
    return max(0.0, stage_value(state, ALL, a, a_squared, rk.C[row], h, h * law.gamma, n))


@kernel(fastmath=_REDUCE)
def dissipated_power(law, size, state, row, h, reach):
    r"""Power lost at stage `row`, the sum over beads in the energy balance of `equations`.

    With :math:`f_n = u_{n,+}^\alpha` it is summed by parts,
    :math:`\gamma \sum_n (f - f_n)(\Delta_d u_+^\beta)_n` with :math:`f = f_0`, since the slopes are
    stored.  They add up to zero on a ring and to a with a piston, so that any other number f serves
    there too, but for a term in a.
    """
    slopes = state.g if law.kind == PAIR else state.k
    total = 0.0
    for n in range(1, reach + 1):
        force = state.force[n]
        if n <= size.contacts:
            u = compression(law, state, row, h, n)
            force = u * math.sqrt(u) if law.kind == HERTZ else u**law.alpha
        total += (state.force[0] - force) * slopes[row, n]
    if size.acceleration != 0.0:
        u = compression(law, state, row, h, 1)
        total += size.acceleration * (u**law.alpha - u**law.beta - state.force[0])
    return law.gamma * total


@kernel
def dissipated_energy(law, size, state, h, reach):
    """Energy lost in the step: the pair's own quadrature of the dissipated power, order 8."""
    energy = 0.0
    for row in range(rk.STAGES):
        if rk.B[row] != 0.0:
            energy += h * rk.B[row] * dissipated_power(law, size, state, row, h, reach)
    return energy
