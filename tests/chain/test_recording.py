"""Output and reductions: what is located on the continuous extension, against brute force."""

import numpy as np
import pytest
from chains import TIGHT, TODA, driven_scene, free_scene, given
from scipy.optimize import brentq

from granular_fronts.chain.recorder import END, END_TIME, TIME, VALUE
from granular_fronts.chain.recording import (
    collect,
    extremes_of_all,
    fitted_speed,
    front_speed_and_error,
)
from granular_fronts.chain.run import integrate, prepare
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.errors import SolveError
from granular_fronts.numerics.grids import regular_points

FINE = 0.002
EVERY = 500


@pytest.fixture(scope="module")
def motion():
    """A short chain through its first contact losses, sampled finely at every contact."""
    beads = 24
    record = {
        "snapshots": [10.0, 33.0, 80.0],
        "probes": {
            "all": {"beads": list(range(1, beads)), "start": 0.0, "stop": 80.0, "step": FINE},
            "few": {"beads": [7, 3], "start": 5.0, "stop": 33.0, "step": 1.0},
        },
        "grid": {"step": FINE * EVERY},
        "arrival_level": 0.05,
        "extremes": True,
    }
    scene = driven_scene(0.06, beads, 80.0, record=record)
    return solve(scene).dataset


def test_regular_points_end_at_a_stop_that_the_step_hits_up_to_rounding():
    for count in range(1, 1001):
        stop = round(0.1 * count, 1)
        points = regular_points(0.0, stop, 0.1)
        assert points.size == count + 1
        assert points[-1] == stop
        assert (np.diff(points) > 0.0).all()
    assert regular_points(0.0, 1.0, 0.3)[-1] == 3 * 0.3


HELD = {"kind": "pressure", "left": 0.1, "right": 0.02}


@pytest.mark.parametrize("end", [0.7, 1.2, 12.6])
def test_last_rows_of_grid_and_probes_are_the_state_at_the_end(end):
    """126 steps of 0.1 end beyond 12.6, by rounding."""
    probe = {"beads": [1, 8], "start": 0.0, "stop": end, "step": 0.1}
    record = {"snapshots": [end], "grid": {"step": 0.1}, "probes": {"near": probe}}
    data = simulate_chain(driven_scene(0.06, 8, end, boundary=HELD, record=record))
    last = data["relative_displacement"].isel(t=0).values
    np.testing.assert_allclose(data["relative_displacement_grid"][-1], last, rtol=1e-14)
    np.testing.assert_allclose(data["relative_displacement_near"][-1], last[[0, 7]], rtol=1e-14)
    assert last[7] == 0.02  # Held, and not the position of the last bead.
    assert float(data["t_grid"][-1]) == float(data["t_near"][-1]) == end
    # The held right end is no contact of two beads.
    mean = float(data["mean_relative_displacement"][-1])
    assert mean == pytest.approx(last[:7].sum() / 8.0, rel=1e-13)
    momentum = (0.1**1.5 - 0.02**1.5) * end
    assert float(data["total_velocity"][-1]) == pytest.approx(momentum, rel=1e-13)


def test_a_run_that_ends_before_its_last_output_is_no_result():
    scene = driven_scene(end_time=20.0, record={"snapshots": [10.0, 20.0]})
    run = prepare(scene)
    run.recording.stops[-1] = 15.0
    integrate(run, scene["tolerance"])
    with pytest.raises(SolveError, match="before its last output"):
        collect(run)


def extremes_of(*scene):
    """A motion with free ends, its extremes recorded."""
    return simulate_chain(free_scene(*scene, snapshots=[], extremes=True))


@pytest.mark.parametrize("relative", [1e-5, 1e-14])
def test_of_two_contacts_that_open_within_one_step_the_first_one_is_named(relative):
    """Contact 2 opens at 0.179797, contact 1 at 0.197058, neither at a kink."""
    data = extremes_of(TODA, [0.2, 0.2], [-1.0, 0.0, 1.1], 1.0, relative)
    assert data["first_gap_bead"] == 2
    assert float(data["first_gap_time"]) == pytest.approx(0.1797965101523, rel=10.0 * relative)


def test_of_two_contacts_that_open_at_once_it_is_uncertain_which_is_the_first():
    data = extremes_of(TODA, [0.2, 0.2], [-1.0, 0.0, 1.0], 1.0)
    assert data["first_gap_bead"].attrs["error_estimate"] == 1.0
    assert data["first_gap_time"].attrs["error_estimate"] < 1e-10


@pytest.mark.parametrize(("sign", "name"), [(1.0, "largest"), (-1.0, "smallest")])
def test_extremes_count_from_the_start_on_and_of_equal_ones_the_first(sign, name):
    law = {"alpha": 1.5, "beta": 1.5, "gamma": 0.0}
    data = extremes_of(law, [1.0, 1.0], [-1000.0 * sign, 0.0, 1000.0 * sign], 1e-3)
    extreme = [
        float(data[f"{name}_relative_displacement{part}"]) for part in ("", "_time", "_bead")
    ]
    assert extreme == [1.0, 0.0, 1.0]


def test_of_extremes_that_are_equal_up_to_rounding_the_first_one_counts():
    record = {"snapshots": [], "extremes": True}
    recording = prepare(driven_scene(beads=4, record=record)).recording
    recording.largest[[VALUE, TIME], 1:4] = [0.5, 1.0 - 2.0**-53, 1.0], [1.0, 3.0, 5.0]
    recording.largest[[END, END_TIME], 1:4] = [[1.0], [7.0]]
    found = extremes_of_all(recording, 3)
    assert found["largest_relative_displacement_time"] == 3.0
    assert found["largest_relative_displacement_bead"] == 2.0


def test_a_contact_that_stands_still_at_its_largest_leaves_all_that_time_uncertain():
    """A bead is pressed on a wall by a force that ends at t = 4."""
    force = {"pulse": {"height": 0.05, "duration": 4.0}}
    scene = driven_scene(2.9, 1, 16.0, beta=1.25, boundary={"kind": "wall", "force": force})
    record = {"snapshots": [], "extremes": True}
    motion = simulate_chain(scene | {"start": {"kind": "equilibrium"}, "record": record})
    time = motion["largest_relative_displacement_time"]
    assert float(time) - time.attrs["error_estimate"] < 0.01
    assert float(time) + time.attrs["error_estimate"] > 3.99


def test_equal_extremes_leave_time_uncertain_by_what_lies_between_them():
    """An undamped contact oscillates for ever: any of its maxima may be the largest."""
    data = extremes_of(TODA, [0.0], [0.5, -0.5], 20.0)
    period = 2.0 * np.pi / np.sqrt(2.0)
    assert data["largest_relative_displacement_time"].attrs["error_estimate"] > period
    assert data["largest_relative_displacement"].attrs["error_estimate"] < 1e-6


@pytest.mark.parametrize("relative", [1e-2, 1e-6])
def test_errors_of_early_and_short_motions_are_stated(relative):
    """Where steps grow as fast as they may the tolerance has no say in them."""
    record = {"snapshots": [0.5, 1.04], "grid": {"step": 0.26}, "arrival_level": 0.01}
    scene = driven_scene(0.06, 8, 1.04, delta=0.5, record=record | {"extremes": True})
    exact = simulate_chain(scene | {"tolerance": {"relative": 1e-14, "absolute": 1e-17}})
    coarse = {"relative": relative, "absolute": 1e-2 * relative}
    found = simulate_chain(scene | {"tolerance": coarse})
    assert found["largest_relative_displacement_bead"].error_estimate < 1e-15  # There is no rival.
    for name, variable in found.items():
        error = float(np.abs(variable - exact[name]).max())
        rounding = 4.0 * np.spacing(float(np.abs(variable).max()))
        if np.isfinite(error):
            # Rounding adds up over the many steps of the exact motion, which says so.
            of_exact = min(exact[name].attrs["error_estimate"], 1e-15)
            assert error <= 2.0 * variable.attrs["error_estimate"] + rounding + of_exact
        if error > 1e-15:
            assert variable.attrs["error_estimate"] <= 20.0 * error


def test_probes_meet_snapshots_and_grid_and_keep_the_order_of_their_beads(motion):
    fine, few = motion["relative_displacement_all"], motion["relative_displacement_few"]
    at_snapshots = fine.sel(t_all=motion["t"].values, method="nearest")
    snapshots = motion["relative_displacement"][:, :-1]
    np.testing.assert_allclose(at_snapshots, snapshots, rtol=0, atol=1e-12)
    grid = motion["relative_displacement_grid"][:, :-1]
    np.testing.assert_allclose(fine[::EVERY], grid, rtol=0, atol=1e-13)
    assert few["bead_few"].values.tolist() == [7, 3]
    expected = fine.sel(bead_all=[7, 3]).sel(t_all=few["t_few"].values, method="nearest")
    np.testing.assert_allclose(few, expected, rtol=0, atol=1e-12)
    # By central differences, u̇_n = ẋ_n − ẋ_{n+1}.
    rate = (fine[2:].values - fine[:-2].values)[EVERY - 1 :: EVERY] / (2.0 * FINE)
    velocity = motion["velocity_grid"].values[1:80]
    np.testing.assert_allclose(rate, -np.diff(velocity, axis=1), rtol=0, atol=1e-6)


def first_crossing(times, u, level):
    """Time at which samples pass a level for the first time, by a straight line."""
    row = np.flatnonzero((u[:-1] - level) * (u[1:] - level) < 0.0)[0]
    return times[row] + FINE * (level - u[row]) / (u[row + 1] - u[row])


def test_passages_are_those_of_the_samples(motion):
    """Arrivals, and the first opening; ahead of the wave samples are rounding of either sign."""
    fine, times = motion["relative_displacement_all"].values, motion["t_all"].values
    arrival = motion["arrival_time"].values
    exact = [first_crossing(times, u, 0.05) for u in fine.T]
    np.testing.assert_allclose(arrival[:-1], exact, rtol=0, atol=1e-6)
    assert float(motion["front_speed"]) == fitted_speed(arrival)
    row, column = np.argwhere((fine[:-1] > 1e-12) & (fine[1:] < -1e-12))[0]
    opening = first_crossing(times[row:], fine[row:, column], 0.0)
    assert float(motion["first_gap_time"]) == pytest.approx(opening, abs=1e-6)
    assert float(motion["first_gap_bead"]) == column + 1


def test_a_level_that_is_passed_between_the_ends_of_a_step_is_met(motion):
    peak, time = (float(motion[name].sel(bead=12)) for name in ("first_peak", "first_peak_time"))
    record = {"snapshots": [], "arrival_level": peak * (1.0 - 1e-10)}
    arrival = solve(driven_scene(0.06, 24, 80.0, record=record), TIGHT).dataset["arrival_time"]
    assert float(arrival.sel(bead=12)) == pytest.approx(time, abs=1e-3)


def test_extremes_and_first_peaks_are_those_of_the_samples(motion):
    fine, times = motion["relative_displacement_all"].values, motion["t_all"].values
    for name, side, share in (("largest", 1.0, 1e-5), ("smallest", -1.0, 1e-3)):
        found = [
            float(motion[f"{name}_relative_displacement{part}"]) for part in ("", "_time", "_bead")
        ]
        row, column = np.unravel_index((side * fine).argmax(), fine.shape)
        most = side * fine[row, column]
        assert most <= side * found[0] < most + share * abs(most)
        np.testing.assert_allclose(found[1:], [times[row], column + 1], atol=FINE)
    for bead in (1, 5, 12):
        u = fine[:, bead - 1]
        first = 1 + np.argmax((u[1:-1] > u[:-2]) & (u[1:-1] >= u[2:]) & (u[1:-1] > 0.05))
        assert float(motion["first_peak"].sel(bead=bead)) == pytest.approx(u[first], abs=1e-6)
        time = float(motion["first_peak_time"].sel(bead=bead))
        assert time == pytest.approx(times[first], abs=2 * FINE)


def two_modes(slow, fast, tau):
    """u of two linear contacts between held ends, 1 + a sin τ ∓ b sin √3τ, and velocities."""
    root = np.sqrt(3.0)
    even, odd = slow * np.sin(tau), fast * np.sin(root * tau)
    even_rate, odd_rate = slow * np.cos(tau), root * fast * np.cos(root * tau)
    u, rates = [1.0 + even - odd, 1.0 + even + odd], [even_rate - odd_rate, even_rate + odd_rate]
    return u, [rates[0], 0.0 * rates[0], -rates[1]]


def swing(slow, fast, tau, end_time, level, relative):
    """The motion of both modes from a phase on, with the first peaks above a level."""
    start = given(*two_modes(slow, fast, tau))
    held = {"kind": "pressure", "left": 1.0, "right": 1.0}
    record = {"snapshots": [], "extremes": True, "arrival_level": level}
    scene = driven_scene(0.0, 3, end_time, 1.0, boundary=held, start=start, record=record)
    return solve(scene, {"relative": relative, "absolute": 1e-2 * relative})


def test_a_first_peak_is_seen_where_u_turns_again_within_the_step():
    """The rate of u_1 is 0.15 (cos τ − 1.02 cos √3τ), which is 0 near ±0.14."""
    modes, within = (0.15, 0.15 * 1.02 / np.sqrt(3.0)), 0
    top = brentq(lambda tau: two_modes(*modes, tau)[1][0], -0.3, 0.0, xtol=1e-15)
    level = two_modes(*modes, -top)[0][0] - 1e-5
    for moment in np.linspace(2.0, 3.0, 21):
        found = swing(*modes, -moment, moment + 0.6, level, 1e-5)
        assert float(found.dataset["first_peak_time"][0]) == pytest.approx(moment + top, abs=1e-3)
        within += not ((moment + top < found.ends) & (found.ends < moment - top)).any()
    assert within >= 10


def test_a_first_peak_comes_after_the_arrival():
    """A maximum below the level is none."""
    tau = 8.0 + np.linspace(0.0, 12.0, 12001)
    u = two_modes(0.1, 0.1, tau)[0][0]
    low, high, *_ = 1 + np.flatnonzero((u[1:-1] > u[:-2]) & (u[1:-1] >= u[2:]))
    assert u[low] < u[high] - 0.01
    found = swing(0.1, 0.1, tau[0], 12.0, 0.5 * (u[low] + u[high]), 1e-9).dataset
    assert float(found["first_peak"][0]) == pytest.approx(u[high], abs=1e-7)
    assert float(found["first_peak_time"][0]) == pytest.approx(tau[high] - tau[0], abs=1e-3)


def test_no_turns_are_seen_in_the_steep_foot_of_a_front():
    """There u grows by orders of magnitude within a step, and the cubic through its ends swings."""
    record = {"snapshots": [], "extremes": True, "arrival_level": 0.05}
    scene = driven_scene(0.06, 60, 60.0, record=record)
    smallest = solve(scene, {"relative": 1e-7, "absolute": 1e-9}).recording.smallest
    turned = smallest[VALUE, 1:60]
    assert turned[np.isfinite(turned)].min(initial=1.0) > 0.0


def test_speed_is_the_slope_of_the_middle_and_none_without_a_slope():
    bead = np.arange(100.0)
    speed, error = front_speed_and_error(bead / 0.7, np.full(100, 1e-3))
    middle = np.arange(-19.5, 20.0)
    assert speed == pytest.approx(0.7, rel=1e-14)
    # Errors of 1e-3 of either sign, in the worst case.
    assert error == pytest.approx(0.49e-3 * sum(abs(middle)) / sum(middle**2), rel=1e-12)
    assert np.isnan(fitted_speed(np.abs(bead - 69.5)))  # Two waves meet in the middle.
    assert np.isnan(fitted_speed(np.where(bead == 60, 1.0, np.nan)))
