"""Chains without fronts, families of fronts, and the choice of variables."""

import itertools

import numpy as np
import pytest

from granular_fronts.chain.equations import Boundary
from granular_fronts.fronts.solitary_waves import gaussian, solitary_wave
from granular_fronts.model.collision import restitution
from granular_fronts.model.laws import make_law
from granular_fronts.reference_methods import position_forms
from granular_fronts.studies import choice_of_variables
from granular_fronts.studies.choice_of_variables import (
    SCHEMES,
    conserved_velocity_drift,
    observed_order,
    quotient_power,
    slope,
)
from granular_fronts.studies.front_trends import critical_gamma, solitary_shape, tail_frequency
from granular_fronts.studies.limiting_cases import (
    collide,
    oscillation_behind,
    press_chain,
    ring_distance,
    wave_width,
)

TIMES = [20.0, 80.0]


def test_without_damping_oscillations_fill_a_growing_region():
    early, late = (oscillation_behind(u)[0] for u in press_chain(1.5, 0.0, 100, TIMES))
    assert late > 0.9 * early > 0.5
    early, late = (oscillation_behind(u)[0] for u in press_chain(1.5, 0.05, 100, TIMES))
    assert late < 0.05 * early
    # Leaving out every other bead changes nothing where the extremes stay; u itself has an error.
    beads = np.arange(200)
    u = np.where(beads < 190, 1.0 + 1e-6 * np.cos(0.5 * np.pi * (beads - 95)), 0.0)
    approx = pytest.approx
    assert oscillation_behind(u) == (approx(2e-6, rel=1e-9), approx(1e-13, rel=0.01, abs=0))


def test_a_harmonic_wave_spreads_and_a_front_does_not():
    early, late = (wave_width(u)[0] for u in press_chain(1.0, 1.0, 120, TIMES))
    assert late / early == pytest.approx(2.0, abs=0.05)
    early, late = (wave_width(u)[0] for u in press_chain(1.5, 1.0, 120, TIMES))
    assert late / early < 1.2


def test_rings_approach_their_equation_as_the_exponent_tends_to_one():
    rings = {"gamma": 0.5, "half_length": 16.0, "half_width": 6.0, "slow_time": 1.0}
    (far, error), (near, _) = (ring_distance(alpha, rings) for alpha in (1.5, 1.2))
    assert error < 1e-4 < near < 0.8 * far


@pytest.mark.parametrize("alpha", [1.5, 2.0])
def test_an_elastic_collision_scales_as_equation_27_says(alpha):
    (time, _), (depth, _) = collide(alpha, 1.0)
    (later, _), (deeper, _) = collide(alpha, 3.0)
    assert later / time == pytest.approx(3.0 ** ((1.0 - alpha) / (1.0 + alpha)), rel=1e-11)
    assert deeper / depth == pytest.approx(3.0 ** (2.0 / (alpha + 1.0)), rel=1e-11)
    # Half of the kinetic energy of two beads is in the contact at its deepest.
    assert depth ** (alpha + 1.0) / (alpha + 1.0) == pytest.approx(0.25, rel=1e-12)


@pytest.mark.parametrize("beta", [1.0, 1.3, 1.5, 1.9])
def test_only_positions_and_w_are_lipschitz(beta):
    law = make_law(alpha=1.5, beta=beta, gamma=0.3)
    assert quotient_power(position_forms.XV, law)[0] == pytest.approx(beta - 2.0, abs=0.02)
    x = np.array([1.0, 2.0, 4.0, 8.0])
    assert slope(x, 3.0 * x**-2) == (pytest.approx(-2.0), pytest.approx(0.0, abs=1e-12))
    # Halves share the point in the middle.
    assert slope(x, np.array([1.0, 2.0, 8.0, 16.0]))[1] == pytest.approx(0.5)
    bounded = min(beta, 1.5) - 1.0
    assert quotient_power(position_forms.XW, law)[0] == pytest.approx(bounded, abs=0.02)


def test_opening_costs_the_runge_kutta_method_its_order(monkeypatch):
    """Of a contact that stays closed, the negative control, schemes have their own."""
    law, start = make_law(alpha=1.5, gamma=0.3), np.array([2.0, 0.0, 0.1, -0.1])
    system = position_forms.make_system(position_forms.XV, law, Boundary(ring=False), 2)
    for name, order in (("euler", 1.0), ("runge_kutta_4", 4.0)):
        ends = [
            position_forms.integrate_by_stages(system, start, 0.5 / n, n, *SCHEMES[name])
            for n in (16, 32, 64)
        ]
        changes = [np.abs(b - a).max() for a, b in itertools.pairwise(ends)]
        assert np.log2(changes[0] / changes[1]) == pytest.approx(order, abs=0.1)
    # A quarter of the gaps have the same median order.
    monkeypatch.setattr(choice_of_variables, "GAPS", choice_of_variables.GAPS[:25])
    in_velocities, _ = observed_order(position_forms.XV, law, "runge_kutta_4")
    in_w, _ = observed_order(position_forms.XW, law, "runge_kutta_4")
    assert 1.2 < in_velocities < 1.8
    assert 2.0 < in_w < 3.0


def test_the_order_is_that_of_most_gaps(monkeypatch):
    """One pair in which an opening falls badly does not count."""
    parting = -restitution(0.3, 1.5, 1.5)

    def part_pairs(_system, _scheme, steps):
        return parting + np.append(np.full(100, steps**-2.0), steps**-0.5)

    monkeypatch.setattr(choice_of_variables, "_part_pairs", part_pairs)
    order, _ = observed_order(position_forms.XV, make_law(alpha=1.5, gamma=0.3), "euler")
    assert order == pytest.approx(2.0, rel=1e-6)


def test_w_far_behind_a_front_is_conserved():
    drift, error = conserved_velocity_drift(1.5, 0.3)
    assert drift < 1e-13
    assert error < 1e-12


@pytest.mark.parametrize(("beta", "slow"), [(1.5, True), (1.0, False)])
def test_tails_oscillate_on_one_side_of_the_critical_velocity(beta, slow):
    ratio = critical_gamma(1.5, 1e-2) / critical_gamma(1.5, 1.0)
    assert ratio == pytest.approx(0.01**-0.25, rel=1e-10)
    assert (tail_frequency(1.5, beta, 0.5) > 0.0) is slow
    assert (tail_frequency(1.5, beta, 2.0) > 0.0) is not slow


def test_solitary_wave_is_that_of_another_quadrature():
    """Its height was found from the convolution with 1 − |s| by Gauss's rule between the points."""
    wave, finer = solitary_wave(1.5), solitary_wave(1.5, points_per_bead=32)
    assert wave.residual < 1e-13
    assert wave.u.max() == pytest.approx(1.4873593743, abs=1e-9)
    np.testing.assert_allclose(finer.u[::2], wave.u, rtol=0, atol=1e-13)


def test_solitary_wave_keeps_its_digits_near_1():
    """Against Newton's iteration in 34 digits, where the change of an iteration is no error."""
    peak, error = solitary_shape(1.02)[0]
    assert abs(peak - 1.63979933203546348) <= 2.0 * error < 1e-13


def test_solitary_waves_become_gaussian():
    distances = [solitary_shape(alpha)[1][0] for alpha in (1.5, 1.1, 1.02)]
    assert distances[0] > distances[1] > distances[2]
    assert distances[2] < 0.01
    assert gaussian(1.02, np.zeros(1))[0] ** 1.02 == pytest.approx(np.exp(0.5))
