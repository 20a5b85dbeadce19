"""The profile equation: its quadrature, its matrix, its windows and grids."""

from fractions import Fraction

import numpy as np
import pytest
from kernels import from_python

from granular_fronts.fronts import sweep
from granular_fronts.fronts.linear.tails import rate_of_tail_ahead
from granular_fronts.fronts.profile import newton, solve
from granular_fronts.fronts.profile.equation import power_problem
from granular_fronts.fronts.profile.long_wave_front import long_wave_front
from granular_fronts.fronts.profile.newton import Unknowns
from granular_fronts.fronts.profile.solve import (
    _reason_against,
    choose_window,
    make_grid,
    rate_ahead,
    refine,
    solve_profile,
)
from granular_fronts.numerics.band import factorise, substitute
from granular_fronts.numerics.interpolation import interpolate_all, largest
from granular_fronts.numerics.quadrature import kernel_weights

SPACINGS = [Fraction(1, 12), Fraction(7)]


def moment(weights, spacing, power):
    """∫ K(s) s^power ds by the rule, at ξ = 0 of P(−s) = s^power."""
    width = weights.size // 2
    return np.dot(weights, (-float(spacing) * np.arange(-width, width + 1)) ** power)


@pytest.mark.parametrize("spacing", SPACINGS)
def test_weights_have_the_moments_of_the_kernels(spacing):
    """Among them ∫K = 1, ∫s² K = 1/6 of the hat, ∫s sgn = 1 of the jump."""
    weights = kernel_weights(spacing, 12)
    scale = max(1.0, 6.0 * float(spacing))
    for power in range(7):
        hat = 2.0 / ((power + 1) * (power + 2)) if power % 2 == 0 else 0.0
        jump = 2.0 / (power + 1) if power % 2 else 0.0
        tolerance = 1e-14 * scale**power
        assert moment(weights.hat, spacing, power) == pytest.approx(hat, abs=tolerance)
        assert moment(weights.jump, spacing, power) == pytest.approx(jump, abs=tolerance)
        assert moment(weights.site, spacing, power) == pytest.approx(
            1.0 / (power + 1), abs=tolerance
        )
    np.testing.assert_array_equal(weights.hat, weights.hat[::-1])
    np.testing.assert_array_equal(weights.jump, -weights.jump[::-1])


def test_interpolation_is_exact_on_polynomials_and_constant_outside():
    k = np.arange(60.0)
    values = ((k - 30.0) / 30.0) ** 7
    inside = np.array([25.25, 30.0, 31.9])
    found = interpolate_all(values, inside, -1.0, 1.0)
    np.testing.assert_allclose(found, ((inside - 30.0) / 30.0) ** 7, rtol=0, atol=1e-15)
    np.testing.assert_array_equal(
        interpolate_all(values, np.array([-50.0, 99.0]), 2.0, 3.0), [2, 3]
    )


def test_largest_value_is_that_of_the_interpolant_not_of_the_grid():
    k = np.arange(200.0)
    # Two crests; the grid alone prefers the wrong one.
    values = np.exp(-(((k - 60.5) / 6.0) ** 2)) + 0.9975 * np.exp(-(((k - 140.0) / 6.0) ** 2))
    assert np.argmax(values) == 140
    assert largest(values, 0.0, 0.0) == pytest.approx(1.0, abs=1e-10)


def test_band_factors_solve_a_matrix_with_a_constant_stretch():
    rng = np.random.default_rng(5)
    size, lower, constant = 400, 3, 300
    band = np.tile([0.2, -0.4, 0.3, 2.0, 0.5, -0.3, 0.1, 0.05], (size, 1))
    band[constant:] += 0.1 * rng.standard_normal((size - constant, 8))
    matrix = np.zeros((size, size))
    for i in range(size):
        for place in range(8):
            if 0 <= i - lower + place < size:
                matrix[i, i - lower + place] = band[i, place]
            else:
                band[i, place] = 0.0
    b = rng.standard_normal(size)
    exact = np.linalg.solve(matrix, b)
    for prefix, skipped in ((size, 0), (60, constant - 60)):
        kept = np.concatenate([band[:prefix], band[prefix + skipped :]])
        x = b.copy()
        factorise(kept, lower, prefix)
        substitute(kept, lower, prefix, skipped, x)
        np.testing.assert_allclose(x, exact, rtol=0, atol=1e-13)


def dense_newton_matrix(problem, grid, s, speed):
    """The Jacobian of all equations and the phase condition by central differences."""
    unknowns = np.append(s, speed)

    def equations(unknowns):
        s = np.ascontiguousarray(unknowns[:-1])
        forces = newton.make_forces(s.size, grid.hat.size // 2)
        newton.fill_forces(problem, s, forces)
        residual = np.empty(s.size)
        newton.residuals(problem, grid, Unknowns(s, unknowns[-1:]), forces, residual)
        return np.append(residual, s[grid.middle] - 0.5)

    columns = []
    for k in range(unknowns.size):
        change = np.zeros(unknowns.size)
        change[k] = 1e-6
        columns.append((equations(unknowns + change) - equations(unknowns - change)) / 2e-6)
    return equations(unknowns), np.array(columns).T


@pytest.mark.parametrize(("beta", "ahead"), [(1.5, 0.0), (1.0, 0.0), (2.5, 0.2)])
def test_newton_step_is_that_of_the_full_matrix(beta, ahead):
    """One step of the shifted, bordered elimination against a dense solve."""
    problem = power_problem(1.5, 0.4, beta, ahead)
    spacing, middle = Fraction(1, 4), 60
    grid = make_grid(spacing, middle, kernel_weights(spacing, 8))
    s = 0.5 * (1.0 - np.tanh(float(spacing) * np.arange(-middle, 30)))
    residual, matrix = dense_newton_matrix(problem, grid, s, 1.0)
    exact = np.append(s, 1.0) - np.linalg.solve(matrix, residual)
    stepped = Unknowns(s.copy(), np.ones(1))
    newton.iterate(problem, grid, 1e-15, stepped, np.empty(2))
    np.testing.assert_allclose(np.concatenate(stepped), exact, rtol=0, atol=1e-5)


def test_a_window_that_is_too_short_is_lengthened_at_both_ends(monkeypatch):
    problem = power_problem(1.5, 0.5, 1.0)
    usual = solve_profile(problem)
    short = choose_window(problem).longer(0.6, 0.6)
    monkeypatch.setattr(solve, "choose_window", lambda _: short)
    found = solve_profile(problem)
    assert not found.reason
    assert short.behind < -0.75 * found.xi[0]
    assert short.ahead < 0.75 * found.xi[-1]
    np.testing.assert_allclose(found.evaluate(usual.xi), usual.s, rtol=0, atol=1e-13)


def test_a_front_far_from_long_waves_is_followed_from_stronger_damping():
    problem = power_problem(3.0, 0.004, 3.0)
    found = solve_profile(problem)
    assert solve._from_long_wave(problem, choose_window(problem)).reason
    assert not found.reason
    assert found.problem.damping == problem.damping
    assert abs(found.speed_defect) < 1e-14


def test_refined_front_has_a_finer_grid_and_a_longer_window():
    front = solve_profile(power_problem(1.5, 0.5, 1.5))
    finer = refine(front)
    assert front.spacing / finer.spacing >= 1.4
    np.testing.assert_allclose(finer.xi[[0, -1]], 1.1 * front.xi[[0, -1]], rtol=0, atol=0.5)


def changed(front, index, value):
    s = front.s.copy()
    s[index] = value
    return front._replace(s=s)


# By the words that refuse it.
NO_FRONTS = {
    "above round-off": lambda front: front._replace(residuals=np.array([1e-12])),
    "the speed is wrong": lambda front: front._replace(speed_defect=-1e-11),
    "again ahead": lambda front: changed(front, front.middle + 9, 0.6),
    "another branch": lambda front: changed(front, -9, -1e-11),
    "out of the domain": lambda front: front._replace(problem=front.problem._replace(most=0.9)),
    "overshoots by": lambda front: front._replace(problem=front.problem._replace(least=0.1)),
    "ends of the window": lambda front: changed(front, 0, 1.0 + 1e-12),
    "decays more slowly": lambda front: changed(front, -1, 1e-12),
}


def test_what_is_no_front_is_none_for_a_sweep_either():
    front = solve_profile(power_problem(1.5, 0.5, 1.5))
    passes = from_python(sweep._is_front)
    for words, change in ({"": lambda front: front} | NO_FRONTS).items():
        found = change(front)
        given = _reason_against(found)
        assert words in given
        assert bool(given) == bool(words)
        grid = make_grid(found.spacing, found.middle, kernel_weights(found.spacing, 8))
        unknowns = Unknowns(found.s, np.array([1.0 + found.speed_defect]))
        assert passes(found.problem, grid, unknowns, found.residuals[-1]) == (not words)


def test_front_of_long_waves_is_that_of_the_papers_equation():
    """For β = α it is (46), for β = 1 the closed form of its docstring."""
    start = long_wave_front(power_problem(1.5, 2.0, 1.5))
    y = (1.0 - (1.0 - 2.0**-0.5) * np.exp(start.xi / 6.0)).clip(0.0) ** 3
    np.testing.assert_allclose(start.evaluate(start.xi), y ** (2.0 / 3.0), rtol=0, atol=1e-4)
    start = long_wave_front(power_problem(1.5, 2.0, 1.0))
    exact = (1.0 + (2.0**0.5 - 1.0) * np.exp(0.5 * start.xi / 2.0)) ** -2.0
    np.testing.assert_allclose(start.evaluate(start.xi), exact, rtol=0, atol=1e-4)


def test_rate_ahead_solves_its_equation():
    gamma = 0.7
    assert rate_ahead(power_problem(1.5, gamma, 1.5)) == np.inf
    kappa = rate_ahead(power_problem(1.5, gamma, 1.0))
    assert kappa == pytest.approx(4.0 * gamma * np.sinh(0.5 * kappa) ** 2, rel=1e-12)
    problem = power_problem(1.5, gamma, 1.5, 0.3)
    kappa, bell = rate_ahead(problem), 4.0 * np.sinh(0.5 * rate_ahead(problem)) ** 2
    stiffness = 1.5 * 0.3**0.5 / problem.speed**2
    damped = 1.0 + gamma * problem.speed * kappa
    assert kappa**2 == pytest.approx(stiffness * damped * bell, rel=1e-12)
    # Slower than in any window, and faster than any grid resolves.
    assert rate_of_tail_ahead(1.0, 0.1, 1.0) == 1e-12
    assert rate_of_tail_ahead(1e-300, 0.0, 1.0) == 512.0
