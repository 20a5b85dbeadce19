"""The logarithmic Burgers limit: flux, fronts and scales."""

import numpy as np
import pytest

from granular_fronts.continuum.log_burgers.equation import (
    flux,
    front_end,
    limit_flux,
    log_burgers_front,
)
from granular_fronts.model.amplitude_scaling import make_slow_scales


def test_flux_tends_to_its_limit_without_cancellation():
    y = np.array([0.0, 1.0e-300, 1.0e-7, 0.3, 1.0, 2.0])
    # The next term of the expansion is −(1 − 1/α) y ln²y / 2.
    np.testing.assert_allclose(flux(y, 1.0 + 1e-12), limit_flux(y), rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(flux(y, 1.5), 3.0 * (y - y ** (2 / 3)), rtol=1e-14, atol=1e-15)


@pytest.mark.parametrize("alpha", [1.0 + 1.0e-9, 1.1, 1.5, 3.0])
def test_front_solves_its_equation(alpha):
    """Six-point differences of y equal f_α(y), inside the support."""
    xi = np.linspace(-6.0, min(front_end(alpha), 2.5) - 0.05, 200)
    h = 1.0e-2 if alpha < 2 else 2.0e-3
    weights = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
    slope = sum(
        w * (log_burgers_front(xi + k * h, alpha) - log_burgers_front(xi - k * h, alpha)) / h
        for k, w in weights.items()
    )
    np.testing.assert_allclose(slope, flux(log_burgers_front(xi, alpha), alpha), rtol=0, atol=2e-8)


def test_limit_front_solves_its_equation_and_is_the_limit():
    xi = np.linspace(-8.0, 3.0, 50)
    y = log_burgers_front(xi)
    slope = -np.log(2.0) * np.exp(xi) * y
    np.testing.assert_allclose(slope, limit_flux(y), rtol=1.0e-12, atol=1e-300)
    np.testing.assert_allclose(log_burgers_front(xi, 1.0 + 1.0e-10), y, rtol=0, atol=1.0e-9)


@pytest.mark.parametrize("alpha", [1.1, 1.5])
def test_front_has_the_phase_of_the_paper_and_ends_where_it_should(alpha):
    assert log_burgers_front(0.0, alpha) ** (1 / alpha) == pytest.approx(0.5, abs=1e-15)
    assert log_burgers_front(front_end(alpha) + 1.0e-9, alpha) == 0.0
    assert log_burgers_front(front_end(alpha) - 1.0e-3, alpha) > 0.0


def test_scales_are_those_the_paper_prints():
    for alpha, epsilon, half_length in ((1.1, 0.35, 27.78), (1.5, 0.93, 73.84)):
        scales = make_slow_scales(alpha, 0.24, 5.0)
        assert scales.epsilon == pytest.approx(epsilon, abs=0.005)
        assert scales.half_length(80) == pytest.approx(half_length, abs=0.006)
        relation = scales.speed + scales.slow_rate / scales.epsilon
        assert scales.frame_speed == pytest.approx(relation, rel=1e-14)


def test_velocity_of_a_front_agrees_with_the_first_order_velocity():
    """(44) is (43) with y' = f_α(y) up to the next order: for weak nonlinearity they meet."""
    differences = []
    for excess in (0.02, 0.01):
        scaling = make_slow_scales(1.0 + excess, 1.0, 5.0)
        y = log_burgers_front(np.linspace(-3.0, 1.0, 9), scaling.alpha)
        slope = flux(y, scaling.alpha)
        first_order = scaling.corrected_velocity(y, slope, slope)
        of_front = scaling.front_velocity(y ** (1.0 / scaling.alpha))
        differences.append(np.abs(first_order - of_front).max() / scaling.velocity_scale)
    assert differences[0] < 1.0e-3
    assert differences[1] == pytest.approx(differences[0] / 4.0, rel=0.2)
