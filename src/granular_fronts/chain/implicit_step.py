r"""One implicit step of a chain in strain form: five-stage Radau IIA, order 9.

As in `runge_kutta` only u enters the forces, so that d is eliminated: with the coefficients of
`radau`, the increments :math:`Z_i = U_i - u` obey

.. math:: Z = h c\, d + \Delta_d \bigl( h\gamma A\, g(U) + h^2 A^2 f(U) \bigr), \qquad
    g = u_+^\beta, \quad f = u_+^\alpha .

In the rows :math:`W = T^{-1} Z` a simplified Newton step solves, for each eigenvalue λ of A,

.. math:: \bigl(1 - \Delta_d\, q\bigr)\, \delta W = r, \qquad
    q_n = h\gamma\lambda\, \beta U_n^{\beta-1} + h^2\lambda^2\, \alpha U_n^{\alpha-1},

with U taken at the third stage: tridiagonal systems, whose columns are dominated by their
diagonal, so that no pivot is needed.  The end point is the last stage, and
:math:`d^+ = d + h \sum_j b_j \Delta_d f(U_j)`, so that the momentum law holds to round-off.

The energy dissipated in a step is integrated by the weights of the method.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import uint64

from granular_fronts.chain.state import HERTZ, PAIR
from granular_fronts.chain.strain import NEGLIGIBLE
from granular_fronts.numerics import radau
from granular_fronts.numerics.compiled import kernel

MOST_ITERATIONS = 12
SLOWEST_CONVERGENCE = 0.6
FIRST_STEP = 1.0e-6

_CONTRACT = {"contract"}
_LAMBDA, _LAMBDA_SQUARED = radau.EIGENVALUES.copy(), radau.EIGENVALUES**2


class Workspace(NamedTuple):
    """Arrays of the implicit steps of one chain; rows are stages, or rows of the real layout.

    Attributes
    ----------
    stages, increments, rows : ndarray, shape (5, columns)
        U; W = T⁻¹(U − u); the right-hand side and solution of a Newton step.
    force, damping, weighted : ndarray, shape (5, columns)
        f(U), g(U), and what the Laplacian acts on, in rows.
    coupling, pivot, lower : ndarray of complex, shape (3, columns)
        q, the inverse pivots and the factors of the elimination.
    before : ndarray, shape (6, columns)
        Start and stages of the last accepted step.
    step : ndarray, shape (3,)
        Next step to try, the last accepted one (0 if there is none), and the longest that Newton's
        iteration is trusted with.
    """

    stages: np.ndarray
    increments: np.ndarray
    rows: np.ndarray
    force: np.ndarray
    damping: np.ndarray
    weighted: np.ndarray
    coupling: np.ndarray
    pivot: np.ndarray
    lower: np.ndarray
    before: np.ndarray
    step: np.ndarray


def make_workspace(columns):
    """All arrays, zero, and a small first step."""
    five = [np.zeros((radau.STAGES, columns)) for _ in range(6)]
    complex_rows = [np.zeros((radau.SYSTEMS, columns), dtype=complex) for _ in range(3)]
    before = np.zeros((radau.STAGES + 1, columns))
    return Workspace(*five, *complex_rows, before, np.array([FIRST_STEP, 0.0, np.inf]))


@kernel(fastmath=_CONTRACT)
def evaluate_forces(law, size, state, work, reach):
    """f(U) and, where the exponents differ, g(U), with the forces of held contacts beyond."""
    last = min(reach, size.contacts)
    for i in range(radau.STAGES):
        for n in range(uint64(1), uint64(last + 1)):
            u = work.stages[i, n] if work.stages[i, n] > NEGLIGIBLE else 0.0
            if law.kind == HERTZ:
                work.force[i, n] = u * math.sqrt(u)
            else:
                work.force[i, n] = u**law.alpha
                if law.kind == PAIR:
                    work.damping[i, n] = u**law.beta
        work.force[i, 0], work.damping[i, 0] = state.force[0], state.damping[0]
        for n in range(last + 1, reach + 2):
            held = n > size.contacts
            work.force[i, n] = state.force[n] if held else 0.0
            work.damping[i, n] = state.damping[n] if held else 0.0


@kernel(fastmath=_CONTRACT)
def apply(matrix, source, target, reach):
    """Multiply the five rows of `source` by a matrix, bead by bead, held contacts included."""
    for n in range(uint64(0), uint64(reach + 2)):
        a, b, c, d, e = source[0, n], source[1, n], source[2, n], source[3, n], source[4, n]
        for i in range(radau.STAGES):
            m = matrix[i]
            target[i, n] = m[0] * a + m[1] * b + m[2] * c + m[3] * d + m[4] * e


@kernel(fastmath=_CONTRACT)
def weigh_forces(law, work, h, reach):
    """T⁻¹(hγ A g + h² A² f), what the Laplacian acts on."""
    of_force, of_damping = h * h * radau.FORCE_TO_ROWS, h * law.gamma * radau.DAMPING_TO_ROWS
    if law.kind != PAIR:
        apply(of_force + of_damping, work.force, work.weighted, reach)
        return
    apply(of_force, work.force, work.weighted, reach)
    apply(of_damping, work.damping, work.rows, reach)
    for i in range(radau.STAGES):
        for n in range(uint64(0), uint64(reach + 2)):
            work.weighted[i, n] += work.rows[i, n]


@kernel(fastmath=_CONTRACT)
def residual(state, work, h, reach):
    """What the stages leave: h c d + Δ_d(…) − Z, in rows."""
    for i in range(radau.STAGES):
        psi, rate = work.weighted[i], h * radau.RATE_TO_ROWS[i]
        w, row = work.increments[i], work.rows[i]
        for n in range(uint64(1), uint64(reach + 1)):
            laplacian = psi[n - uint64(1)] - 2.0 * psi[n] + psi[n + uint64(1)]
            row[n] = rate * state.d[n] + laplacian - w[n]


@kernel(fastmath=_CONTRACT)
def factorise(law, size, work, h, reach):
    """Pivots and factors of the three systems, with U at the third stage."""
    last = min(reach, size.contacts)
    u = work.stages[2]
    for i in range(radau.SYSTEMS):
        on_damping = h * law.gamma * _LAMBDA[i] * law.beta
        on_force = h * h * _LAMBDA_SQUARED[i] * law.alpha
        q, inverse, lower = work.coupling[i], work.pivot[i], work.lower[i]
        q[0], q[reach + 1], inverse[0] = 0.0, 0.0, 1.0
        for n in range(1, reach + 1):
            q[n] = 0.0
            if n <= last and u[n] > NEGLIGIBLE:
                if law.kind == HERTZ:
                    q[n] = (on_damping + on_force) * math.sqrt(u[n])
                elif law.kind == PAIR:
                    q[n] = on_damping * u[n] ** (law.beta - 1.0)
                    q[n] += on_force * u[n] ** (law.alpha - 1.0)
                else:
                    q[n] = (on_damping + on_force) * u[n] ** (law.alpha - 1.0)
            factor = q[n - 1] * inverse[n - 1]
            pivot = 1.0 + 2.0 * q[n] - factor * q[n]
            lower[n] = factor
            inverse[n] = pivot.conjugate() / (pivot.real * pivot.real + pivot.imag * pivot.imag)


@kernel(fastmath=_CONTRACT)
def solve_rows(work, reach):
    """Solve the three systems in place in `rows`; side by side, since each waits for itself."""
    rows, q, inverse, lower = work.rows, work.coupling, work.pivot, work.lower
    a, b, c = 0.0, 0.0j, 0.0j
    for n in range(uint64(1), uint64(reach + 1)):
        a = rows[0, n] + lower[0, n].real * a
        b = complex(rows[1, n], rows[2, n]) + lower[1, n] * b
        c = complex(rows[3, n], rows[4, n]) + lower[2, n] * c
        rows[0, n], rows[1, n], rows[2, n] = a, b.real, b.imag
        rows[3, n], rows[4, n] = c.real, c.imag
    a, b, c = 0.0, 0.0j, 0.0j
    for n in range(reach, 0, -1):
        a = inverse[0, n].real * (rows[0, n] + q[0, n + 1].real * a)
        b = inverse[1, n] * (complex(rows[1, n], rows[2, n]) + q[1, n + 1] * b)
        c = inverse[2, n] * (complex(rows[3, n], rows[4, n]) + q[2, n + 1] * c)
        rows[0, n], rows[1, n], rows[2, n] = a, b.real, b.imag
        rows[3, n], rows[4, n] = c.real, c.imag


@kernel
def add_rows(work, reach):
    """Add the Newton step to W; returns its largest entry."""
    largest = 0.0
    for i in range(radau.STAGES):
        for n in range(1, reach + 1):
            work.increments[i, n] += work.rows[i, n]
            change = abs(work.rows[i, n])
            if not change <= largest:
                largest = change
    return largest


@kernel(fastmath=_CONTRACT)
def stages_from_rows(state, work, reach):
    """U = u + T W."""
    apply(radau.TO_STAGES, work.increments, work.stages, reach)
    for i in range(radau.STAGES):
        for n in range(uint64(1), uint64(reach + 1)):
            work.stages[i, n] += state.u[n]


@kernel
def predict(state, work, h, reach):
    """First guess of W: the polynomial of the last step, continued; no change without one."""
    weights = np.zeros((radau.STAGES, radau.STAGES + 1))
    if work.step[1] > 0.0:
        for i in range(radau.STAGES):
            x = 1.0 + h / work.step[1] * radau.NODES[i]
            for k in range(radau.STAGES + 1):
                weights[i, k] = 1.0
                for j in range(radau.STAGES + 1):
                    if j != k:
                        distance = radau.POINTS[k] - radau.POINTS[j]
                        weights[i, k] *= (x - radau.POINTS[j]) / distance
    for n in range(1, reach + 1):
        for i in range(radau.STAGES):
            change = 0.0
            for k in range(radau.STAGES + 1):
                change += weights[i, k] * (work.before[k, n] - state.u[n])
            work.rows[i, n] = change
            work.stages[i, n] = state.u[n] + change
    apply(radau.TO_ROWS, work.rows, work.increments, reach)


class Allowed(NamedTuple):
    """Change of u at which Newton's iteration ends: enough for the step, or mere rounding."""

    newton: float
    rounding: float


@kernel
def iterate(law, size, state, work, h, allowed, reach):
    """Newton's iteration for the stages: how often it went round, and whether it converged."""
    factorise(law, size, work, h, reach)
    before = math.inf
    for iteration in range(MOST_ITERATIONS):
        evaluate_forces(law, size, state, work, reach)
        weigh_forces(law, work, h, reach)
        residual(state, work, h, reach)
        solve_rows(work, reach)
        change = add_rows(work, reach)
        stages_from_rows(state, work, reach)
        if not math.isfinite(change):
            return iteration + 1, False
        ratio = change / before
        if iteration > 0 and ratio < 1.0 and change * ratio / (1.0 - ratio) <= allowed.newton:
            return iteration + 1, True
        if iteration > 0 and change <= allowed.rounding:
            return iteration + 1, True
        if iteration > 1 and ratio > SLOWEST_CONVERGENCE:
            return iteration + 1, False
        before = change
    return MOST_ITERATIONS, False


@kernel
def estimate(size, state, work, reach):
    """Largest difference of the end point from the polynomial through the other stages."""
    largest = 0.0
    weights = radau.END_FROM_OTHERS
    for n in range(1, min(reach, size.contacts) + 1):
        difference = weights[0] * state.u[n] - work.stages[4, n]
        for i in range(radau.STAGES - 1):
            difference += weights[i + 1] * work.stages[i, n]
        largest = max(largest, abs(difference))
    return largest


@kernel(fastmath=_CONTRACT)
def finish(state, work, h, reach):
    """New u and d, from the converged stages and their forces."""
    for n in range(uint64(1), uint64(reach + 1)):
        total = 0.0
        for i in range(radau.STAGES):
            f = work.force[i]
            total += radau.WEIGHTS[i] * (f[n - uint64(1)] - 2.0 * f[n] + f[n + uint64(1)])
        state.new_u[n] = work.stages[4, n]
        state.new_d[n] = state.d[n] + h * total


@kernel(fastmath=_CONTRACT)
def dissipated_energy(law, work, h, reach):
    """Energy lost in the step, from the forces of the converged stages on both sides of a bead."""
    energy = 0.0
    for i in range(radau.STAGES):
        f = work.force[i]
        g = work.damping[i] if law.kind == PAIR else f
        total = 0.0
        for n in range(uint64(1), uint64(reach + 1)):
            total += (f[n - uint64(1)] - f[n]) * (g[n - uint64(1)] - g[n])
        energy += h * radau.WEIGHTS[i] * law.gamma * total
    return energy


@kernel
def accept(state, work, h, reach):
    """Make the end point the next start, and remember the step."""
    for n in range(1, reach + 1):
        work.before[0, n] = state.u[n]
        for i in range(radau.STAGES):
            work.before[i + 1, n] = work.stages[i, n]
        state.u[n], state.d[n] = state.new_u[n], state.new_d[n]
    work.step[1] = h
