"""Balance laws to round-off, and what must not depend on how the chain is stored."""

import numpy as np
import pytest
from chains import driven_scene, ring_scene, smooth_ring

import granular_fronts as gf
from granular_fronts.chain import equations, run, state
from granular_fronts.chain.balances import Balances
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.studies.hard_cases.contact_cases import squeezed_chain

HERTZ = gf.make_law(alpha=1.5).elastic
BALANCES = {"snapshots": [], "balances": True}


@pytest.mark.parametrize("beta", [1.0, 1.5, 2.5])
@pytest.mark.parametrize("gamma", [0.0, 0.3])
def test_pressure_balances_close(gamma, beta):
    scene = driven_scene(gamma, beta=beta, end_time=60.0, record=BALANCES)
    drifts = solve(scene, scene["tolerance"]).drifts
    assert drifts["momentum_drift"] < 5.0e-15
    assert drifts["energy_drift"] < 2.0e-13


def test_energy_balance_closes_through_contact_loss():
    """The pressed end works while the last beads fly off."""
    scene = driven_scene(0.06, end_time=250.0, record=BALANCES | {"extremes": True})
    solution = solve(scene, scene["tolerance"])
    assert float(solution.dataset["first_gap_time"]) < 100.0
    assert solution.drifts["momentum_drift"] < 1.0e-14
    assert solution.drifts["energy_drift"] < 1.0e-13


LAWS = [(1.5, 1.5), (1.2, 1.2), (3.0, 3.0), (1.5, 1.0), (1.5, 2.5), (1.0, 1.0)]


@pytest.mark.parametrize(("alpha", "beta"), LAWS)
def test_balances_close_through_openings(alpha, beta):
    """A squeezed chain falls apart; W'' has roots or jumps there, the balances go on."""
    scene = squeezed_chain()
    scene["law"] = {"alpha": alpha, "beta": beta, "gamma": 0.06}
    solution = solve(scene, scene["tolerance"])
    assert solution.counts["steps_cut_at_contacts"] > 0
    assert solution.drifts["momentum_drift"] < 1.0e-14
    assert solution.drifts["energy_drift"] < 1.0e-12


@pytest.mark.parametrize(("alpha", "beta"), LAWS)
@pytest.mark.parametrize("ring", [True, False])
def test_both_forms_of_the_energy_balance_are_one(ring, alpha, beta):
    """Their dissipated powers differ by d/dt Σ ½ (ẋ² − w²), with ẍ and ẇ by (24) and (32)."""
    gamma, boundary = 0.4, Boundary(ring, 0.3, 0.2)
    law = gf.make_law(alpha=alpha, beta=beta, gamma=gamma)
    u, w = np.random.default_rng(2).normal(size=(2, 30))
    if not ring:
        u[-1] = boundary.right
    velocity = w + equations.velocity_correction(u, boundary, law)
    rate = velocity - np.roll(velocity, -1)
    if not ring:
        rate[-1] = 0.0
    stiffness = np.where(u > 0.0, beta * np.abs(u) ** (beta - 1.0), 0.0)
    viscous = gamma * stiffness * rate
    behind, ahead = equations.forces_on_both_sides(u, boundary, law.elastic)
    viscous_behind = np.roll(viscous, 1)
    if not ring:
        viscous_behind[0] = 0.0
    difference = velocity @ (behind + viscous_behind - ahead - viscous) - w @ (behind - ahead)
    in_u_and_w = (behind - ahead) @ (velocity - w)
    assert difference == pytest.approx(in_u_and_w - viscous @ rate, abs=1.0e-12)


@pytest.mark.parametrize(("alpha", "beta"), [(1.5, 1.5), (1.2, 1.2), (1.5, 1.0), (1.0, 1.0)])
def test_ring_balances_close(alpha, beta):
    """And the ring keeps its length, eq. (26): over one turn Σ u_n = −L, at all times."""
    u, velocity = smooth_ring()
    scene = ring_scene(u, velocity, alpha=alpha, beta=beta, end_time=20.0)
    scene["record"] = BALANCES | {"snapshots": [0.0, 5.0, 20.0]}
    solution = solve(scene, scene["tolerance"])
    lengths = solution.dataset["relative_displacement"].sum("bead")
    assert solution.drifts["momentum_drift"] < 5.0e-15
    assert solution.drifts["energy_drift"] < 1.0e-13
    np.testing.assert_allclose(lengths, u.sum(), rtol=2e-15)


def test_a_drift_that_is_no_number_is_not_lost():
    scene = driven_scene(end_time=1.0)
    prepared = run.prepare(scene)
    balances = Balances(prepared)
    for rate in (np.nan, 0.0):
        prepared.table[state.D, 1] = rate
        balances.check(prepared)
    assert np.isnan(balances.drifts()["momentum_drift"])


def test_drifts_are_relative_to_the_largest_energy_and_velocities():
    scene = driven_scene(end_time=1.0, record=BALANCES)
    balances = Balances(run.prepare(scene))
    for law in ("momentum", "energy"):
        balances._note(law, 1e-3, 10.0)
        balances._note(law, -5e-4, 1.0)
    assert list(balances.drifts().values()) == [1e-4, 1e-4]


def test_a_held_contact_has_no_energy_of_its_own():
    state, elastic = (np.array([0.5, 0.3]), np.array([1.0, 2.0])), 0.4 * np.array([0.5, 0.3]) ** 2.5
    for ring, expected in ((False, 2.5 + elastic[0]), (True, 2.5 + elastic.sum())):
        assert equations.energy(*state, Boundary(ring), HERTZ) == pytest.approx(expected)


def test_energy_is_lost_only_to_damping():
    u, velocity = smooth_ring()
    energies = {}
    for gamma in (0.0, 0.2):
        scene = ring_scene(u, velocity, gamma=gamma, end_time=10.0)
        state = solve(scene, scene["tolerance"]).dataset.isel(t=-1)
        values = state["relative_displacement"].values, state["velocity"].values
        energies[gamma] = equations.energy(*values, Boundary(ring=True), HERTZ)
    before = equations.energy(u, velocity, Boundary(ring=True), HERTZ)
    assert energies[0.0] == pytest.approx(before, rel=1.0e-13)
    assert energies[0.2] < 0.999 * before


def test_beads_ahead_of_the_wave_are_exactly_at_rest():
    scene = driven_scene(0.06, beads=200, end_time=50.0)
    state = solve(scene, scene["tolerance"]).dataset.isel(t=-1)
    ahead = state["bead"] > 40
    assert float(np.abs(state["velocity"].where(ahead, 0.0)).max()) == 0.0
    assert float(state["velocity"].sel(bead=20)) > 0.05


def test_shifting_the_start_along_a_ring_shifts_the_motion():
    u, velocity = smooth_ring()
    shift = 7
    scene = ring_scene(u, velocity)
    shifted = ring_scene(np.roll(u, shift), np.roll(velocity, shift))
    states = [solve(s, s["tolerance"]).dataset.isel(t=-1) for s in (scene, shifted)]
    for name in ("relative_displacement", "velocity"):
        values = [state[name].values for state in states]
        np.testing.assert_allclose(np.roll(values[0], shift), values[1], rtol=0, atol=2.0e-14)


def test_pressure_from_the_right_mirrors_pressure_from_the_left():
    left = driven_scene(0.2, end_time=40.0)
    right = left | {"boundary": {"kind": "pressure", "left": 0.0, "right": 0.1}}
    states = [solve(s, s["tolerance"]).dataset.isel(t=-1) for s in (left, right)]
    velocities = [state["velocity"].values for state in states]
    np.testing.assert_allclose(velocities[1], -velocities[0][::-1], rtol=0, atol=2.0e-14)


def test_rest_means_zero_velocity_and_not_zero_w():
    """With pressure held from t = 0 on, w_1 starts at −γ δ^β and ẋ at 0."""
    scene = driven_scene(0.4, end_time=1.0e-3, record={"snapshots": [0.0, 1.0e-3]})
    velocity = solve(scene, scene["tolerance"]).dataset["velocity"]
    assert np.abs(velocity.sel(t=0.0)).max() < 1.0e-17
    assert float(velocity.sel(t=1.0e-3, bead=1)) == pytest.approx(1.0e-3 * 0.1**1.5, rel=1.0e-3)


@pytest.mark.parametrize("ring", [True, False])
def test_conversion_to_strain_form_and_back(ring):
    random = np.random.default_rng(1)
    u, velocity = random.normal(size=(2, 5, 30))
    boundary = Boundary(ring, 0.3, 0.2)
    if not ring:
        u[:, -1] = boundary.right
    law = gf.make_law(alpha=1.5, gamma=0.4)
    d = equations.strain_rates(velocity, u, boundary, law)
    momentum = velocity.sum(axis=-1, keepdims=True)
    back = equations.velocities(d, u, boundary, law, momentum)
    np.testing.assert_allclose(back, velocity, rtol=0, atol=2.0e-14)


def test_rows_avoid_the_stride_that_evicts_the_cache():
    for beads in range(2, 2000):
        columns = state.row_length(beads)
        assert columns >= beads + 2
        assert columns % 8 == 0
        assert columns % 512 != 0


def test_error_estimates_stand_beside_every_variable():
    dataset = simulate_chain(driven_scene(end_time=20.0))
    for variable in dataset.data_vars.values():
        assert 0.0 <= variable.attrs["error_estimate"] < 1.0e-12
        assert "each step in two halves" in variable.attrs["error_method"]
