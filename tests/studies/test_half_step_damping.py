"""What the half-step scheme does to a front: times, roots, readings, and the checks beside them."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from granular_fronts.errors import SolveError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.model.collision import restitution
from granular_fronts.studies.half_step_damping import (
    collision_loss,
    excess_by_table,
    excess_of_tail,
    measure_half_step_damping,
    tail_root,
)
from granular_fronts.studies.half_step_motions import (
    Case,
    accurate_chain,
    collision_time,
    compare_motion,
    half_step_chain,
    passing,
    read_motion,
)
from granular_fronts.studies.law_measures import excess_damping

UNIT = collision_time(1.5)
CASE = Case(1.5, 1.5, 0.1, 24, 10 * UNIT)
SCENE = {
    "alpha": 1.5,
    "betas": [1.5, 1.0],
    "gammas": [0.05, 0.13],
    "beads": 24,
    "collision_times": 10,
    "steps_per_collision": [160, 320, 80],
    "shown": {"beta": 1.5, "gamma": 0.13, "steps_per_collision": 20},
}


@pytest.fixture(scope="module")
def measured():
    return measure_half_step_damping(**SCENE)


@pytest.mark.parametrize("alpha", [1.0, 1.5, 3.0])
def test_collision_time_is_that_of_two_beads(alpha):
    def parted(_, state):
        return state[0]

    parted.terminal, parted.direction = True, -1.0
    found = solve_ivp(
        lambda _, state: [state[1], -2.0 * max(state[0], 0.0) ** alpha],
        (0.0, 10.0),
        [0.0, 1.0],
        events=parted,
        rtol=1e-11,
        atol=1e-13,
    )
    assert collision_time(alpha) == pytest.approx(found.t[-1], rel=1e-9)


@pytest.mark.parametrize("beta", [1.0, 1.5])
def test_root_of_the_scheme_is_the_tail_root_without_a_step(beta):
    case = CASE._replace(beta=beta)
    exact = tail_roots(1.5, 0.1, beta, count=1)[0]
    distances = [abs(tail_root(case, h) - exact) for h in (0.02, 0.01, 0.005)]
    assert math.log2(distances[0] / distances[1]) == pytest.approx(1.0, abs=0.05)
    assert math.log2(distances[1] / distances[2]) == pytest.approx(1.0, abs=0.03)


def test_motion_of_the_scheme_has_its_root():
    """Behind a driven front extremes of u − 1 follow each other as the root says."""
    case, step = Case(1.5, 1.5, 0.13, 240, 80 * UNIT), UNIT / 10
    motion = half_step_chain(case, step)
    u = motion.x[:, 119] - motion.x[:, 120]
    rate = motion.v[:, 119] - motion.v[:, 120]
    turns = np.flatnonzero((np.sign(rate[1:]) != np.sign(rate[:-1])) & (u[1:] > 0.5))
    times, sizes = motion.t[turns], np.abs(u[turns] - 1.0)
    kept = (sizes < 0.06) & (sizes > 0.002)
    decay = -np.polyfit(times[kept], np.log(sizes[kept]), 1)[0]
    spacing = np.diff(times[kept]).mean()
    root, plain = tail_root(case, step), tail_roots(1.5, 0.13, count=1)[0]
    assert kept.sum() >= 4
    assert math.pi / spacing == pytest.approx(root.imag, rel=0.02)
    assert abs(plain.imag / root.imag - 1.0) > 0.05
    assert decay == pytest.approx(root.real, rel=0.05)


def test_excess_of_a_peak_inverts_its_table():
    factors, peaks = (0.9, 1.0, 1.1, 1.3), [1.5, 1.4, 1.31, 1.2]
    assert excess_by_table(np.array(peaks), factors, peaks) == pytest.approx(
        np.array(factors) - 1.0
    )
    assert np.isnan(excess_by_table(np.array([1.6, 1.1]), factors, peaks)).all()


def test_damping_added_to_the_accurate_chain_is_read_as_such():
    factors = (0.97, 1.0, 1.07, 1.17, 1.3)
    table = [accurate_chain(CASE._replace(gamma=0.1 * factor))[0].peak for factor in factors]
    peak, _ = accurate_chain(CASE._replace(gamma=0.1 * 1.023))
    assert excess_by_table(np.array(peak.peak), factors, table) == pytest.approx(0.023, abs=2e-6)


def test_orders_and_excess_are_of_first_order(measured):
    np.testing.assert_allclose(measured["order"], 1.0, atol=0.06)
    for observable in ("overshoot", "tail"):
        excess = measured[f"excess_{observable}"]
        halved = excess.isel(step=1) / excess.isel(step=2)
        np.testing.assert_allclose(halved, 2.0, atol=0.08)
    steps = measured["step"]
    assert np.all(np.diff(steps) < 0.0)
    # Of the size of h/t_c, and more than the tail says.
    assert np.all(measured["excess_overshoot"] < 1.5 * steps)
    assert np.all(measured["excess_overshoot"] > 0.3 * steps)
    assert np.all(measured["excess_overshoot"] > 1.2 * measured["excess_tail"])


def test_excess_is_measured_at_the_step_that_is_named_and_no_other(measured):
    found = excess_damping(measured, "tail", 1.5, 0.13, 160)
    assert found.value == float(measured["excess_tail"].sel(beta=1.5, gamma=0.13)[1])
    with pytest.raises(KeyError):
        excess_damping(measured, "tail", 1.5, 0.13, 150)


def test_tail_excess_is_that_of_the_roots():
    excess = excess_of_tail(CASE, 0.05)
    roots = tail_roots(1.5, 0.1 * (1.0 + excess), count=1)
    assert roots[0].real == pytest.approx(tail_root(CASE, 0.05).real, rel=1e-11)


def test_checks_do_not_see_what_the_front_shows(measured):
    excess = measured["excess_overshoot"].sel(beta=1.5, gamma=0.13)
    for name in ("restitution", "momentum", "energy", "speed"):
        assert np.all(measured[f"{name}_defect"] < 0.1 * excess)
    assert np.all(measured["momentum_defect"] < 1e-13)
    energy = measured["energy_defect"].values
    np.testing.assert_allclose(np.log2(energy[:-1] / energy[1:]), 2.0, atol=0.2)


def test_restitution_sees_damping_that_is_really_there():
    """The scheme with 5 % more γ loses 4 % more, with its own error far less."""
    step = UNIT / 100
    exact = 1.0 - restitution(CASE.gamma)
    own = collision_loss(CASE, step) / exact - 1.0
    more = collision_loss(CASE._replace(gamma=1.05 * CASE.gamma), step) / exact - 1.0
    assert more > 0.04
    assert abs(own) < 2e-3


def test_motion_that_is_shown_is_the_accurate_one_up_to_the_error():
    motion = compare_motion(CASE, UNIT / 40)
    difference = abs(
        motion["relative_displacement_method"] - motion["relative_displacement_accurate"]
    )
    assert 1e-4 < float(difference.max()) < 0.1
    finer = compare_motion(CASE, UNIT / 80)
    finer_difference = abs(
        finer["relative_displacement_method"] - finer["relative_displacement_accurate"]
    )
    assert float(difference.max() / finer_difference.max()) == pytest.approx(2.0, abs=0.3)


def test_readings_of_both_chains_are_of_the_same_thing():
    fine = read_motion(CASE, half_step_chain(CASE._replace(gamma=1e-9), UNIT / 400))
    exact, _ = accurate_chain(CASE._replace(gamma=1e-9))
    assert fine.peak == pytest.approx(exact.peak, abs=1e-4)
    np.testing.assert_allclose(fine.arrivals, exact.arrivals, atol=1e-4)


def test_a_peak_that_does_not_come_is_named():
    short = half_step_chain(CASE._replace(end_time=UNIT), UNIT / 20)
    with pytest.raises(SolveError, match="Contact 12 does not pass its peak before"):
        passing(short, 12, "peak")
