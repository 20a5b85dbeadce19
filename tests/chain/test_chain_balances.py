"""Balance laws to round-off through openings, their drifts, and where nothing happens."""

import numpy as np
import pytest
from chains import driven_scene, given

import granular_fronts as gf
from granular_fronts.chain import equations, run
from granular_fronts.chain.balances import Balances
from granular_fronts.chain.equations import Boundary
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.state import D

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


@pytest.mark.parametrize("wrong", [0.01, -0.01])
def test_drifts_are_the_largest_relative_ones_and_lose_no_nan(wrong):
    """A bead of 20 that move alike is too fast: by 1/20 of its share of momentum."""
    start = given([0.0] * 19, [0.5] * 20)
    prepared = run.prepare(driven_scene(beads=20, delta=0.0, start=start, record=BALANCES))
    balances = Balances(prepared)
    for change in (wrong, -wrong):
        prepared.table[D, 1] += change
        balances.check(prepared)
    drifts = list(balances.drifts().values())
    assert drifts == pytest.approx([abs(wrong) / 10.0, abs(wrong) / 5.0], rel=0.02)
    for rate in (np.nan, 0.0):
        prepared.table[D, 1] = rate
        balances.check(prepared)
    assert np.isnan(list(balances.drifts().values())).all()


def test_a_held_contact_has_no_energy_of_its_own():
    state, elastic = (np.array([0.5, 0.3]), np.array([1.0, 2.0])), 0.4 * np.array([0.5, 0.3]) ** 2.5
    hertz = gf.make_law(alpha=1.5).elastic
    for ring, expected in ((False, 2.5 + elastic[0]), (True, 2.5 + elastic.sum())):
        assert equations.energy(*state, Boundary(ring), hertz) == pytest.approx(expected)


def test_beads_ahead_of_the_wave_are_exactly_at_rest():
    solution = solve(driven_scene(0.06, beads=200, end_time=50.0))
    velocity = solution.dataset["velocity"][-1]
    assert not velocity[40:].any()
    assert velocity[19] > 0.05
    assert np.isnan(solution.drifts["energy_drift"])  # It was not asked for.
