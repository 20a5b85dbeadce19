r"""One implicit step of a chain in strain form: five-stage Radau IIA, order 9.

As in `runge_kutta` only u enters the forces, so that d is eliminated: with the coefficients of
`radau`, the increments :math:`Z_i = U_i - u` obey

.. math:: Z = h c\, d + \Delta_d \bigl( h A\, G(U) + h^2 A^2 F(U) \bigr) .

In the rows :math:`W = T^{-1} Z` a simplified Newton step solves, for each eigenvalue λ of A,

.. math:: \bigl(1 - \Delta_d\, q\bigr)\, \delta W = r, \qquad
    q_n = h\lambda\, G'(U_n) + h^2\lambda^2\, F'(U_n),

with U taken at the third stage: tridiagonal systems, whose columns are dominated by their
diagonal, so that no pivot is needed.  The end point is the last stage, and
:math:`d^+ = d + h \sum_j b_j \Delta_d F(U_j)`, so that the momentum law holds to round-off.

The energy dissipated in a step is integrated by the weights of the method.
"""

import math
from typing import NamedTuple

import numpy as np
from numba import uint64

from granular_fronts.chain.state import (
    DAMPING,
    FORCE,
    MOST_PARAMETERS,
    NEW_D,
    NEW_U,
    D,
    U,
    record_type,
)
from granular_fronts.model.passes import call_row_map, row_map, row_parameters
from granular_fronts.numerics import radau
from granular_fronts.numerics.compiled import subroutine

MOST_ITERATIONS = 12
SLOWEST_CONVERGENCE = 0.6
FIRST_STEP = 1.0e-6

_CONTRACT = {"contract"}
_LAMBDA, _LAMBDA_SQUARED = radau.EIGENVALUES.copy(), radau.EIGENVALUES**2


STEPS = record_type(("next", float), ("last", float), ("longest", float))
"""Next step to try, the last accepted one (0 if there is none), and the longest that Newton's
iteration is trusted with."""

SLOPES = record_type(
    ("elastic", np.int64),
    ("viscous", np.int64),
    ("elastic_parameters", float, MOST_PARAMETERS),
    ("viscous_parameters", float, MOST_PARAMETERS),
)
"""Addresses and parameters of the row maps F' and G'."""


class Workspace(NamedTuple):
    """Arrays of the implicit steps of one chain; rows are stages, or rows of the real layout.

    Attributes
    ----------
    stages, increments, rows : ndarray, shape (5, columns)
        U; W = T⁻¹(U − u); the right-hand side and solution of a Newton step.
    force, damping, weighted : ndarray, shape (5, columns)
        F(U), G(U), and what the Laplacian acts on, in rows.
    coupling, pivot, lower : ndarray of complex, shape (3, columns)
        q, the inverse pivots and the factors of the elimination.
    stiffness, viscosity : ndarray, shape (columns,)
        F' and G' at the third stage.
    before : ndarray, shape (6, columns)
        Start and stages of the last accepted step.
    steps, slopes : record
        Of types `STEPS` and `SLOPES`.
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
    stiffness: np.ndarray
    viscosity: np.ndarray
    before: np.ndarray
    steps: np.record
    slopes: np.record


def make_workspace(law, columns):
    """All arrays, zero, and a small first step.

    Parameters
    ----------
    law : model.laws.Law
    columns : int
        Length of a row.
    """
    five = [np.zeros((radau.STAGES, columns)) for _ in range(6)]
    complex_rows = [np.zeros((radau.SYSTEMS, columns), dtype=complex) for _ in range(3)]
    before = np.zeros((radau.STAGES + 1, columns))
    steps, slopes = np.zeros(1, STEPS)[0], np.zeros(1, SLOPES)[0]
    steps.next, steps.longest = FIRST_STEP, np.inf
    for name, potential in (("elastic", law.elastic), ("viscous", law.viscous)):
        parameters = row_parameters(potential, 2)
        slopes[name] = row_map(potential, 2)
        slopes[f"{name}_parameters"][: parameters.size] = parameters
    rows = np.zeros(columns), np.zeros(columns)
    return Workspace(*five, *complex_rows, *rows, before, steps, slopes)


@subroutine
def evaluate_forces(chain, table, work, reach):
    """F(U) and, for laws with viscous slopes of their own, G(U); at rest beyond the window."""
    law, last = chain.law, min(reach, chain.contacts)
    for i in range(radau.STAGES):
        u, force, damping = work.stages[i], work.force[i], work.damping[i]
        call_row_map(law.elastic, u, force, 1, last, law.elastic_parameters)
        if not law.single:
            call_row_map(law.viscous, u, damping, 1, last, law.viscous_parameters)
        force[0], damping[0] = table[FORCE, 0], table[DAMPING, 0]
        for n in range(last + 1, reach + 2):
            force[n], damping[n] = table[FORCE, n], table[DAMPING, n]


@subroutine(fastmath=_CONTRACT)
def apply(matrix, source, target, reach):
    """Multiply the five rows of `source` by a matrix, bead by bead, held contacts included."""
    for n in range(uint64(0), uint64(reach + 2)):
        a, b, c, d, e = source[0, n], source[1, n], source[2, n], source[3, n], source[4, n]
        for i in range(radau.STAGES):
            m = matrix[i]
            target[i, n] = m[0] * a + m[1] * b + m[2] * c + m[3] * d + m[4] * e


@subroutine(fastmath=_CONTRACT)
def weigh_forces(chain, work, h, reach):
    """T⁻¹(h A G + h² A² F), what the Laplacian acts on."""
    gamma = chain.law.gamma
    of_force, of_damping = h * h * radau.FORCE_TO_ROWS, h * gamma * radau.DAMPING_TO_ROWS
    if chain.law.single:
        apply(of_force + of_damping, work.force, work.weighted, reach)
        return
    apply(of_force, work.force, work.weighted, reach)
    apply(of_damping, work.damping, work.rows, reach)
    for i in range(radau.STAGES):
        for n in range(uint64(0), uint64(reach + 2)):
            work.weighted[i, n] += work.rows[i, n]


@subroutine(fastmath=_CONTRACT)
def residual(table, work, h, reach):
    """What the stages leave: h c d + Δ_d(…) − Z, in rows."""
    for i in range(radau.STAGES):
        psi, rate = work.weighted[i], h * radau.RATE_TO_ROWS[i]
        w, row = work.increments[i], work.rows[i]
        for n in range(uint64(1), uint64(reach + 1)):
            laplacian = psi[n - uint64(1)] - 2.0 * psi[n] + psi[n + uint64(1)]
            row[n] = rate * table[D, n] + laplacian - w[n]


@subroutine(fastmath=_CONTRACT)
def factorise(chain, work, h, reach):
    """Pivots and factors of the three systems, with U at the third stage."""
    last, slopes = min(reach, chain.contacts), work.slopes
    u, stiffness, viscosity = work.stages[2], work.stiffness, work.viscosity
    call_row_map(slopes.elastic, u, stiffness, 1, last, slopes.elastic_parameters)
    call_row_map(slopes.viscous, u, viscosity, 1, last, slopes.viscous_parameters)
    for i in range(radau.SYSTEMS):
        on_damping, on_force = h * _LAMBDA[i], h * h * _LAMBDA_SQUARED[i]
        q, inverse, lower = work.coupling[i], work.pivot[i], work.lower[i]
        q[0], q[reach + 1], inverse[0] = 0.0, 0.0, 1.0
        for n in range(1, reach + 1):
            q[n] = on_damping * viscosity[n] + on_force * stiffness[n] if n <= last else 0.0
            factor = q[n - 1] * inverse[n - 1]
            pivot = 1.0 + 2.0 * q[n] - factor * q[n]
            lower[n] = factor
            inverse[n] = pivot.conjugate() / (pivot.real * pivot.real + pivot.imag * pivot.imag)


@subroutine(fastmath=_CONTRACT)
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


@subroutine
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


@subroutine(fastmath=_CONTRACT)
def stages_from_rows(table, work, reach):
    """U = u + T W."""
    apply(radau.TO_STAGES, work.increments, work.stages, reach)
    for i in range(radau.STAGES):
        for n in range(uint64(1), uint64(reach + 1)):
            work.stages[i, n] += table[U, n]


@subroutine
def predict(table, work, h, reach):
    """First guess of W: the polynomial of the last step, continued; no change without one."""
    weights = np.zeros((radau.STAGES, radau.STAGES + 1))
    if work.steps.last > 0.0:
        for i in range(radau.STAGES):
            x = 1.0 + h / work.steps.last * radau.NODES[i]
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
                change += weights[i, k] * (work.before[k, n] - table[U, n])
            work.rows[i, n] = change
            work.stages[i, n] = table[U, n] + change
    apply(radau.TO_ROWS, work.rows, work.increments, reach)


class Allowed(NamedTuple):
    """Change of u at which Newton's iteration ends: enough for the step, or mere rounding."""

    newton: float
    rounding: float


@subroutine
def iterate(chain, table, work, h, allowed, reach):
    """Newton's iteration for the stages: how often it went round, and whether it converged."""
    factorise(chain, work, h, reach)
    before = math.inf
    for iteration in range(MOST_ITERATIONS):
        evaluate_forces(chain, table, work, reach)
        weigh_forces(chain, work, h, reach)
        residual(table, work, h, reach)
        solve_rows(work, reach)
        change = add_rows(work, reach)
        stages_from_rows(table, work, reach)
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


@subroutine
def estimate(chain, table, work, reach):
    """Largest difference of the end point from the polynomial through the other stages."""
    largest = 0.0
    weights = radau.END_FROM_OTHERS
    for n in range(1, min(reach, chain.contacts) + 1):
        difference = weights[0] * table[U, n] - work.stages[4, n]
        for i in range(radau.STAGES - 1):
            difference += weights[i + 1] * work.stages[i, n]
        largest = max(largest, abs(difference))
    return largest


@subroutine(fastmath=_CONTRACT)
def finish(table, work, h, reach):
    """New u and d, from the converged stages and their forces."""
    for n in range(uint64(1), uint64(reach + 1)):
        total = 0.0
        for i in range(radau.STAGES):
            f = work.force[i]
            total += radau.WEIGHTS[i] * (f[n - uint64(1)] - 2.0 * f[n] + f[n + uint64(1)])
        table[NEW_U, n] = work.stages[4, n]
        table[NEW_D, n] = table[D, n] + h * total


@subroutine(fastmath=_CONTRACT)
def dissipated_energy(chain, work, h, reach):
    """Energy lost in the step, from the forces of the converged stages on both sides of a bead."""
    energy = 0.0
    for i in range(radau.STAGES):
        f = work.force[i]
        g = f if chain.law.single else work.damping[i]
        total = 0.0
        for n in range(uint64(1), uint64(reach + 1)):
            total += (f[n - uint64(1)] - f[n]) * (g[n - uint64(1)] - g[n])
        energy += h * radau.WEIGHTS[i] * chain.law.gamma * total
    return energy


@subroutine
def accept(table, work, h, reach):
    """Make the end point the next start, and remember the step."""
    for n in range(1, reach + 1):
        work.before[0, n] = table[U, n]
        for i in range(radau.STAGES):
            work.before[i + 1, n] = work.stages[i, n]
        table[U, n], table[D, n] = table[NEW_U, n], table[NEW_D, n]
    work.steps.last = h
