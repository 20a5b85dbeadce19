"""Parts of the schemes for the logarithmic Burgers equation: starts, cells, steps."""

import numpy as np
import pytest
from kernels import from_python
from rings import assert_order
from scipy.integrate import quad

from granular_fronts.continuum.log_burgers import finite_volumes, time_steps
from granular_fronts.continuum.log_burgers.equation import flux, limit_flux
from granular_fronts.continuum.log_burgers.starts import Given, Plateau

evaluate_rates, lift = map(from_python, (finite_volumes.evaluate_rates, finite_volumes.lift))
try_step = from_python(time_steps.try_step)


@pytest.mark.parametrize(("alpha", "floor"), [(1.0, 0.0), (1.5, 0.3)])
def test_start_averages_are_exact(alpha, floor):
    half_length, cells, start = 27.78, 37, Plateau(10.0, floor)
    averages = start.averages(cells, half_length, alpha)
    edges = np.linspace(-half_length, half_length, cells + 1)
    kinks = [sign * k for k in (10.0, 10.0 + np.sqrt(1.0 - floor)) for sign in (-1, 1)]
    for average, a, b in zip(averages, edges[:-1], edges[1:], strict=True):
        inside = [k for k in kinks if a < k < b] or None
        values = lambda x: start.values(x, half_length) ** (1 / alpha)  # noqa: E731
        integral, _ = quad(values, a, b, points=inside, epsabs=1e-12)
        assert average == pytest.approx(integral / (b - a), abs=2e-11)
    assert averages.min() >= floor ** (1 / alpha)


def test_given_start_is_interpolated_by_a_trigonometric_polynomial():
    half_length = 12.0
    xi = half_length * np.linspace(-1.0, 1.0, 33)
    start = Given(tuple(2.0 + np.cos(np.pi * xi / half_length)))
    points = np.linspace(-12.0, 30.0, 50)
    exact = 2.0 + np.cos(np.pi * points / half_length)
    np.testing.assert_allclose(start.values(points, half_length), exact, rtol=0, atol=1e-13)
    edges = np.pi * np.linspace(-1.0, 1.0, 21)
    exact = 2.0 + np.diff(np.sin(edges)) / np.diff(edges)
    np.testing.assert_allclose(start.averages(20, half_length, 1.0), exact, rtol=0, atol=1e-13)
    # The shortest wave of an even number of points too.
    rough = np.resize([1.0, 0.2, 0.7, 0.1], 33)
    found = Given(tuple(rough)).values(xi, half_length)
    np.testing.assert_allclose(found, rough, rtol=0, atol=1e-13)


def sine_averages(n):
    """Edges of n cells from −π to π, and the averages of the sine over them."""
    edges = np.linspace(-np.pi, np.pi, n + 1)
    return edges, np.diff(-np.cos(edges)) / np.diff(edges)


def test_point_values_are_of_seventh_order():
    cells, errors, xi = [24, 32, 48, 64, 96], [], np.linspace(-4.0, 4.0, 1001)
    for n in cells:
        found = finite_volumes.point_values(sine_averages(n)[1], np.pi, xi, -2.0)
        errors.append(np.abs(found - np.sin(xi)).max())
    assert_order(cells, errors, 7.0, 0.15)


@pytest.mark.parametrize("alpha", [1.0, 1.5])
def test_rates_are_of_sixth_order(alpha):
    """On a smooth positive wave the rates are the differences of the exact flux."""
    cells, errors = [32, 48, 64, 96, 128], []
    for n in cells:
        edges, averages = sine_averages(n)
        value, width, rates = 2.0 + np.sin(edges), 2.0 * np.pi / n, np.empty(n)
        equation = finite_volumes.Equation(alpha, 1e-16, 0.0, width)
        evaluate_rates(equation, 2.0 + averages, finite_volumes.make_work(n), rates)
        advected = limit_flux(value) if alpha == 1 else flux(value**1.5, 1.5)
        diffused = alpha * value ** (alpha - 1.0) * np.cos(edges)
        exact = -np.diff(advected - value - diffused) / width
        errors.append(np.abs(rates - exact).max())
    assert_order(cells, errors, 6.0, 0.15)


def test_lifting_keeps_the_mean_and_the_bound():
    averages = np.random.default_rng(1).uniform(0.0, 1.0, 200) ** 4
    before = averages.mean()
    assert lift(averages, 0.1) > 0.0
    assert averages.min() == 0.1
    assert averages.mean() == pytest.approx(before, rel=1e-15)


def test_symbols_are_the_eigenvalues_of_the_rates():
    """In the limit of (41) about v = 1 the rates are D v'' − c v' with D = 1 and c = ln 1 = 0."""
    n, small = 24, 1.0e-6
    angle, width = 2.0 * np.pi * 5 / n, 0.1
    wave = np.exp(1j * angle * np.arange(n))
    for level in (1.0, 0.3):
        equation = finite_volumes.Equation(1.0, 1e-16, 0.0, width)
        work, rates, linear = finite_volumes.make_work(n), np.empty(n), np.zeros(n, complex)
        for part, unit in ((wave.real, 1.0), (wave.imag, 1j)):
            evaluate_rates(equation, level + small * part, work, rates)
            linear += unit * rates / small
        diffusion, advection = finite_volumes.symbols(angle)
        expected = -diffusion / width**2 - 1j * np.log(level) * advection / width
        np.testing.assert_allclose(linear / wave, expected, rtol=1e-4)


def test_tabulated_steps_are_stable():
    """|P| ≤ 1 on all of a spectrum, at angles that the table was not made from; P ≈ exp."""
    angle = np.linspace(0.0, np.pi, 2027)
    for b, parabola in zip(time_steps.DIFFUSION_NUMBERS, time_steps.PARABOLA, strict=True):
        for share in (0.0, 0.3, 1.0, 1.1):
            z = time_steps.spectrum(b, share * parabola, angle)
            growth = np.abs(time_steps.stability_polynomial(z)).max()
            assert (growth <= 1.0 + 1e-12) == (share <= 1.0)
    for h in (1.0e-2, -1.0e-2):
        assert abs(time_steps.stability_polynomial(h) - np.exp(h)) < abs(h) ** 5


def test_step_is_of_fourth_order_and_its_estimate_of_third():
    """One step on a smooth wave against many small ones."""
    equation = finite_volumes.Equation(1.5, 1e-16, 0.0, 2.0 * np.pi / 32)
    steps, errors, estimates = np.array([0.012, 0.01, 0.008, 0.006]), [], []
    for h in steps:
        state, exact = (time_steps.make_state(2.0 + sine_averages(32)[1]) for _ in range(2))
        estimates.append(try_step(equation, state, h))
        for _ in range(16):
            try_step(equation, exact, h / 16)
            exact.averages[:] = exact.trial
        errors.append(np.abs(state.trial - exact.trial).max())
    assert_order(1.0 / steps, errors, 5.0, 0.25)
    assert_order(1.0 / steps, estimates, 4.0, 0.25)
