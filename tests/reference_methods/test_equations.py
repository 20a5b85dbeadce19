"""Equations of sections 2 and 3.1 of the paper that no other test names, each on what we compute.

Elsewhere are the potentials of (3), the jump conditions (12)-(14), (16)-(18) and (20)-(23), the
scales (27)-(29), (30) and Remarks 5 and 6; that any chain obeys (1), (3), (5), (25) and (26), and
that (x, w) and (x, ẋ) are one motion.
"""

import functools

import numpy as np
import pytest
from chains import driven_scene
from potentials import fpu, hertz, toda
from scipy.integrate import quad

import granular_fronts as gf
from granular_fronts.model.jump_conditions import signed_area

LAW = {"alpha": 1.5, "beta": 1.5, "gamma": 0.3}
CASES = [(hertz(1.5), -1.0, 0.0), (toda(), -1.2, 0.3), (fpu(1.0, 0.7), 0.9, 0.1)]
NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
SPACING = 1.0e-2
SLOPE = np.array([-1, 9, -45, 0, 45, -9, 1]) / (60.0 * SPACING)
"""Weights of a derivative of order 6, from seven values that far apart."""


def rates(u, velocity):
    """Rate u̇ and transmitted force T of each contact between two beads of a driven chain."""
    rate = velocity[:-1] - velocity[1:]
    closed = np.maximum(u, 0.0)
    return rate, closed**1.5 + 0.3 * 1.5 * np.sqrt(closed) * rate


def test_potentials_4_make_the_contact_law_2():
    """−V'(r) − d/dt W'(r) is k u₊^α + γ₀k d/dt u₊^β of a contact with u = −r."""
    k, damping, u, rate = 3.0, 0.2, np.array([-0.5, 0.0, 1.0e-3, 0.7]), 0.6
    elastic, viscous = hertz(1.5, k), hertz(2.5, damping * k)
    law = k * np.maximum(u, 0.0) ** 1.5 + damping * k * 2.5 * np.maximum(u, 0.0) ** 1.5 * rate
    np.testing.assert_allclose(-elastic.first(-u) + viscous.second(-u) * rate, law, rtol=1e-14)


def test_energy_density_obeys_equation_6():
    """e + ∫ δ⁺q = −∫ (δ⁺ẋ)² W'' for every bead, q_n = T_(n−1) ẋ_n, by Gauss quadrature in time."""
    start, end = 20.0, 20.5
    times = 0.5 * (start + end) + 0.5 * (end - start) * NODES
    record = {"snapshots": [start, *times, end]}
    motion = gf.simulate_chain(driven_scene(0.3, 24, end + 1.0, delta=1.0, record=record))
    u, velocity = motion["relative_displacement"].values[:, :-1], motion["velocity"].values

    def density(row):
        return 0.5 * velocity[row, 1:-1] ** 2 + np.maximum(u[row, 1:], 0.0) ** 2.5 / 2.5

    fluxes, losses = [], []
    for row in range(1, times.size + 1):
        rate, force = rates(u[row], velocity[row])
        fluxes.append(np.diff(force * velocity[row, 1:]))
        losses.append(0.45 * np.sqrt(np.maximum(u[row, 1:], 0.0)) * rate[1:] ** 2)
    mean = 0.5 * (end - start) * WEIGHTS
    left = density(-1) - density(0) + mean @ np.array(fluxes)
    np.testing.assert_allclose(left, -(mean @ np.array(losses)), rtol=0, atol=1e-11)
    assert np.abs(left).max() > 1e-3


@functools.cache
def front():
    return gf.solve_front(**LAW)


def profile(xi, name="relative_displacement"):
    return gf.evaluate_front(front(), np.asarray(xi), name)


def transmitted(xi):
    """u^α − cγ d/dξ u^β, the force in the frame of a front with c = 1."""
    values = profile(np.asarray(xi)[..., None] + SPACING * np.arange(-3, 4)) ** 1.5
    return profile(xi) ** 1.5 - 0.3 * values @ SLOPE


XI = np.linspace(-12.0, 3.0, 31)
WITHIN_A_BEAD = 0.5 + 0.5 * NODES
MEAN = 0.5 * WEIGHTS


def test_front_obeys_the_first_integral_8():
    """c ẋ is the mean of the force over one bead, and −c u' what the velocities differ by (7)."""
    mean = transmitted(XI[:, None] - WITHIN_A_BEAD) @ MEAN
    np.testing.assert_allclose(profile(XI, "velocity"), mean, rtol=0, atol=1e-9)
    slope = profile(XI[:, None] + SPACING * np.arange(-3, 4)) @ SLOPE
    step = profile(XI, "velocity") - profile(XI + 1.0, "velocity")
    np.testing.assert_allclose(-slope, step, rtol=0, atol=1e-10)


def test_front_obeys_the_energy_balance_9():
    """From ξ to +∞: what passes a bead less what has gathered there is dissipated ahead."""

    def energy(xi):
        return 0.5 * profile(xi, "velocity") ** 2 + profile(xi) ** 2.5 / 2.5

    def power(xi):
        rate = profile(xi, "velocity") - profile(xi + 1.0, "velocity")
        return 0.45 * np.sqrt(np.maximum(profile(xi), 0.0)) * rate**2

    for xi in (-6.0, -1.0, 0.0):
        within = xi + WITHIN_A_BEAD
        passing = MEAN @ (transmitted(within - 1.0) * profile(within, "velocity"))
        lost = sum(MEAN @ power(first + WITHIN_A_BEAD) for first in xi + np.arange(12.0))
        assert passing - energy(np.array(xi)) == pytest.approx(lost, abs=1e-9)


def test_front_has_the_limits_10_to_12():
    """δ⁺X → R± and X' → R±, of which ẋ_n → −cR±."""
    far = np.array([-60.0, 30.0])
    np.testing.assert_allclose(profile(far), [1.0, 0.0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(profile(far, "velocity"), [1.0, 0.0], rtol=0, atol=1e-12)


@pytest.mark.parametrize(("potential", "behind", "ahead"), CASES)
def test_dissipation_15_is_the_signed_area_19(potential, behind, ahead):
    """Both are the energy that a front loses per bead, positive in the direction (17)."""
    front = gf.jump_conditions(potential, behind, ahead)
    energy, force = (f(np.array([behind, ahead])) for f in (potential.value, potential.first))
    integrated = 0.5 * front.speed**2 * (ahead**2 - behind**2) + energy[1] - energy[0]
    integrated += force[0] * behind - force[1] * ahead
    jump = ahead - behind

    def above_the_chord(s):
        r = np.array([behind + s * jump])
        return float(jump * (potential.first(r)[0] - s * force[1] - (1.0 - s) * force[0]))

    area, error = quad(above_the_chord, 0.0, 1.0, epsabs=1e-13)
    assert signed_area(potential, behind, ahead).value == pytest.approx(area, abs=10.0 * error)
    assert integrated == pytest.approx(area, rel=1e-11)
    assert front.direction * area > 0.0
