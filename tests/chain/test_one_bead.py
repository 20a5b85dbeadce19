"""A ball on a plate: a chain of a single bead before a wall, with and without a load."""

import numpy as np
import pytest
from chains import STRIKER, TIGHT, given, last_state
from newton import solutions

import granular_fronts as gf

LAWS = [(1.5, 1.0, 0.2), (1.5, 1.25, 0.3), (1.5, 1.5, 0.1), (1.5, 2.5, 1.0), (1.0, 1.0, 0.4)]
FALLS, LOAD, END = given([0.0], [1.0]), 0.05, 8.0


def on_plate(alpha, beta, gamma, load=0.0, **changes):
    """ẍ = g − x₊^α − γ d(x₊^β)/dt from x = 0 and ẋ = 1."""
    scene = {
        "law": {"alpha": alpha, "beta": beta, "gamma": gamma},
        "beads": 1,
        "boundary": {"kind": "wall"},
        "start": FALLS,
        "gravity": load,
        "end_time": END,
        "tolerance": TIGHT,
        "record": {"snapshots": [END], "extremes": True, "balances": True, "grid": {"step": 1.0}},
    }
    return scene | changes


@pytest.mark.parametrize(("alpha", "beta", "gamma"), LAWS)
@pytest.mark.parametrize("load", [0.0, LOAD])
def test_a_ball_leaves_a_plate_as_by_newtons_law(alpha, beta, gamma, load):
    leaves = lambda t, state: state[0] + 1.0e-300  # noqa: E731 - SciPy wants an attribute
    leaves.direction = -1.0
    scene, options = on_plate(alpha, beta, gamma, load), {"rtol": 1.0e-12, "atol": 1.0e-14}
    [by_scipy] = solutions(scene, max_step=0.05, events=leaves, **options)
    time, (_, velocity) = by_scipy.t_events[0][0], by_scipy.y_events[0][0]
    motion = gf.simulate_chain(scene)
    assert float(motion["first_gap_time"]) == pytest.approx(time, abs=1.0e-10)
    assert float(motion["first_gap_velocity"]) == pytest.approx(velocity, abs=1.0e-8)
    found = motion["relative_displacement"].item(), motion["velocity"].item()
    assert found == pytest.approx(by_scipy.y[:, -1], abs=1.0e-10)
    assert motion.attrs["energy_drift"] < 1.0e-11


@pytest.mark.parametrize(("alpha", "beta", "gamma"), LAWS)
def test_two_beads_lose_what_a_ball_on_a_plate_does(alpha, beta, gamma):
    """By the reduced mass 1/2 of James (2021), remark 6, γ of two is smaller by a power of 2."""
    of_two = gamma / 2.0 ** (1.0 - beta / (alpha + 1.0))
    motion, e = gf.simulate_chain(on_plate(alpha, beta, gamma)), gf.restitution(of_two, alpha, beta)
    for velocity, least in (motion["first_gap_velocity"], 1.0e-9), (motion["velocity"], 1.0e-13):
        assert abs(velocity.item() + e) <= 2.0 * velocity.attrs["error_estimate"] < 2.0 * least


def test_a_ball_that_sticks_settles_where_the_plate_bears_it():
    record = {"snapshots": [200.0], "extremes": True}
    motion = gf.simulate_chain(on_plate(1.5, 1.0, 2.0, LOAD, end_time=200.0, record=record))
    assert np.isnan(motion["first_gap_velocity"])
    assert motion["relative_displacement"].item() == pytest.approx(LOAD ** (1.0 / 1.5), abs=1.0e-9)


@pytest.mark.parametrize("beads", [1, 3])
def test_all_beads_of_a_striker_may_hit_a_wall(beads):
    thrown = on_plate(1.5, 1.5, 0.1, beads=beads, start=STRIKER | {"beads": beads})
    listed = thrown | {"start": given([0.0] * beads, [1.0] * beads)}
    assert np.array_equal(last_state(thrown), last_state(listed))
