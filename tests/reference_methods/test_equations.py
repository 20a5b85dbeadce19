"""Equations of sections 2 and 3.1 of the paper that no other test names, each on what we compute.

The rest: the potentials of (3) `test_potentials`, (12)-(14), (16)-(18), (20)-(23)
`test_jump_conditions`, `test_check_jump_conditions` and `test_laws`, (24), (27)-(29)
`test_scaling`, (26) `test_chain_balances`, (30) `test_campaign_kinds`, Remark 6 `test_collision`,
and its materials the table of materials. That (x, w) and (x, ẋ) are one motion is tested by
`test_chain_accuracy`, what (31) and (32) gain by `test_limiting_cases`.
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


def record_around(t, **changes):
    """A driven chain at seven times around t, `SPACING` apart: u with u_0 = 1 in front, and ẋ."""
    times = t + SPACING * np.arange(-3, 4)
    scene = driven_scene(0.3, 24, t + 1.0, delta=1.0, record={"snapshots": list(times)}, **changes)
    motion = gf.simulate_chain(scene)
    u = np.pad(motion["relative_displacement"].values, ((0, 0), (1, 0)), constant_values=1.0)
    return u, motion["velocity"].values


def test_chain_obeys_equations_1_3_and_5():
    """ẍ_n = F_(n−1) − F_n at every bead, ends included, with F = −V'(−δ) − d/dt W'(−δ)."""
    elastic, viscous = hertz(1.5), hertz(1.5, 0.3)
    u, velocity = record_around(20.0)
    force = -elastic.first(-u) - SLOPE @ viscous.first(-u)
    acceleration = SLOPE @ velocity
    np.testing.assert_allclose(acceleration, force[3, :-1] - force[3, 1:], rtol=0, atol=1e-9)
    _, transmitted = rates(u[3, 1:-1], velocity[3])
    inside = transmitted[:-1] - transmitted[1:]
    np.testing.assert_allclose(acceleration[1:-1], inside, rtol=0, atol=1e-10)
    assert np.abs(acceleration).max() > 0.1


def test_generalised_velocity_obeys_equations_31_and_32():
    """w = ẋ − γ(u_(n−1)^β − u_n^β) changes by the elastic forces alone, for another β too."""
    law = {"alpha": 1.5, "beta": 2.5, "gamma": 0.3}
    u, velocity = record_around(20.0, law=law)
    closed = np.maximum(u, 0.0)
    w = velocity + 0.3 * np.diff(closed**2.5, axis=1)
    elastic = -np.diff(closed[3] ** 1.5)
    np.testing.assert_allclose(SLOPE @ w, elastic, rtol=0, atol=1e-9)
    # The velocity itself does not.
    assert np.abs(SLOPE @ velocity - elastic).max() > 0.01


def test_limits_33_and_34_do_not_change():
    """Far on both sides of a front relative displacements, and far to the left w, keep theirs."""
    compressed = (np.arange(100) < 70).astype(float)
    start = {"kind": "given", "relative_displacement": compressed[:-1], "velocity": compressed}
    motion = gf.simulate_chain(driven_scene(0.3, 100, 10.0, delta=1.0, start=start)).isel(t=-1)
    u, velocity = motion["relative_displacement"].values, motion["velocity"].values
    w = velocity + 0.3 * np.diff(np.maximum(u, 0.0) ** 1.5, prepend=1.0)
    np.testing.assert_allclose([u[:10], w[:10], velocity[:10]], 1.0, rtol=1e-13)
    assert np.abs(u[-10:]).max() == 0.0
    assert np.abs(w - 1.0).max() > 0.5


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


@pytest.mark.parametrize("delta", [0.1, 2.0])
def test_pressure_at_the_ends_25_holds_a_compressed_chain(delta):
    """x_0 − x_1 = δ = x_N − x_(N+1): a chain of compression δ between them stays at rest."""
    start = {"kind": "given", "relative_displacement": [delta] * 11, "velocity": [0.0] * 12}
    scene = driven_scene(0.2, 12, 20.0, delta=delta, start=start)
    scene["boundary"]["right"] = delta
    motion = gf.simulate_chain(scene).isel(t=-1)
    assert (motion["relative_displacement"] == delta).all()
    assert (motion["velocity"] == 0.0).all()


def test_pressure_sets_the_scales_of_remark_5():
    """With δ₀ = δ, v₀ and T₀ by (27), a chain under pressure depends on γ of (29) alone."""
    states = []
    for delta in (1.0, 0.1, 1e3):
        speed = delta**1.25
        gamma, end = 0.2 / speed ** (2.0 * 2.5 / 2.5 - 1.0), 12.0 * delta / speed
        tolerance = {"relative": 1e-13, "absolute": 1e-15 * delta}
        scene = driven_scene(gamma, 16, end, beta=2.5, delta=delta, tolerance=tolerance)
        motion = gf.simulate_chain(scene).isel(t=-1)
        states.append([motion["relative_displacement"] / delta, motion["velocity"] / speed])
    np.testing.assert_allclose(states[1:], [states[0]] * 2, rtol=0, atol=1e-12)
    assert np.abs(states[0]).max() > 0.9
