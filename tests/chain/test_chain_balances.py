"""Balance laws to round-off, and what must not depend on how the chain is stored."""

import numpy as np
import pytest
from chains import driven_scene, given, ring_scene, smooth_ring

import granular_fronts as gf
from granular_fronts.chain import equations, run, state
from granular_fronts.chain.balances import Balances
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.simulate import simulate_chain, solve

HERTZ = gf.make_law(alpha=1.5).elastic
BALANCES = {"snapshots": [], "balances": True}


@pytest.mark.parametrize(("alpha", "beta"), [(1.2, 1.2), (1.5, 1.0), (1.5, 2.5)])
def test_balances_close_through_openings(alpha, beta):
    """A squeezed chain falls apart; W'' has roots or jumps there, the balances go on."""
    start = given(0.1 * (1.0 + 0.5 * np.sin(1.7 * np.arange(19))), np.zeros(20))
    scene = driven_scene(0.06, 20, 100.0, alpha, beta, delta=0.0, start=start, record=BALANCES)
    solution = solve(scene)
    assert solution.drifts["momentum_drift"] < 1.0e-14
    assert solution.drifts["energy_drift"] < 1.0e-12
    assert solution.counts["steps_cut_at_contacts"] > 0


@pytest.mark.parametrize("ring", [True, False])
@pytest.mark.parametrize("beta", [1.5, 1.0])
def test_both_forms_of_the_energy_balance_are_one(beta, ring):
    """Their dissipated powers differ by d/dt Σ ½ (ẋ² − w²), with ẍ and ẇ by (24) and (32)."""
    gamma, boundary = 0.4, Boundary(ring, 0.3, 0.2)
    law = gf.make_law(alpha=1.5, beta=beta, gamma=gamma)
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


def test_a_ring_keeps_its_length():
    """Eq. (26): over one turn Σ u_n = −L, at all times."""
    u, velocity = smooth_ring()
    record = {"snapshots": [0.0, 5.0, 20.0]}
    motion = solve(ring_scene(u, velocity, end_time=20.0, record=record)).dataset
    lengths = motion["relative_displacement"].sum("bead")
    np.testing.assert_allclose(lengths, u.sum(), rtol=2e-15)


def test_drifts_are_relative_to_the_largest_terms_and_lose_no_nan():
    prepared = run.prepare(driven_scene(end_time=1.0, record=BALANCES))
    balances = Balances(prepared)
    for law in ("momentum", "energy"):
        balances._note(law, 1e-3, 10.0)
        balances._note(law, -5e-4, 1.0)
    assert list(balances.drifts().values()) == [1e-4, 1e-4]
    for rate in (np.nan, 0.0):
        prepared.table[state.D, 1] = rate
        balances.check(prepared)
    assert np.isnan(balances.drifts()["momentum_drift"])


def test_a_held_contact_has_no_energy_of_its_own():
    state, elastic = (np.array([0.5, 0.3]), np.array([1.0, 2.0])), 0.4 * np.array([0.5, 0.3]) ** 2.5
    for ring, expected in ((False, 2.5 + elastic[0]), (True, 2.5 + elastic.sum())):
        assert equations.energy(*state, Boundary(ring), HERTZ) == pytest.approx(expected)


def test_beads_ahead_of_the_wave_are_exactly_at_rest():
    scene = driven_scene(0.06, beads=200, end_time=50.0)
    state = solve(scene).dataset.isel(t=-1)
    ahead = state["bead"] > 40
    assert float(np.abs(state["velocity"].where(ahead, 0.0)).max()) == 0.0
    assert float(state["velocity"].sel(bead=20)) > 0.05


def test_rest_means_zero_velocity_and_not_zero_w():
    """With pressure held from t = 0 on, w_1 starts at −γ δ^β and ẋ at 0."""
    scene = driven_scene(0.4, end_time=1.0e-3, record={"snapshots": [0.0, 1.0e-3]})
    velocity = solve(scene).dataset["velocity"]
    assert np.abs(velocity.sel(t=0.0)).max() < 1.0e-17
    assert float(velocity.sel(t=1.0e-3, bead=1)) == pytest.approx(1.0e-3 * 0.1**1.5, rel=1.0e-3)


def test_error_estimates_stand_beside_every_variable():
    dataset = simulate_chain(driven_scene(end_time=20.0))
    for variable in dataset.data_vars.values():
        assert 0.0 <= variable.attrs["error_estimate"] < 1.0e-12
        assert "each step in two halves" in variable.attrs["error_method"]
