"""Output and reductions: what is located on the continuous extension, against brute force."""

import numpy as np
import pytest
from chains import driven_scene

from granular_fronts.chain.recording import fitted_speed
from granular_fronts.chain.simulate import solve
from granular_fronts.numerics.grids import regular_points

FINE = 0.002


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
        "grid": {"step": 1.0},
        "arrival_level": 0.05,
        "extremes": True,
    }
    scene = driven_scene(0.06, beads, 80.0, record=record)
    return solve(scene, scene["tolerance"]).dataset


def test_regular_points_include_a_stop_that_the_step_hits_up_to_rounding():
    assert regular_points(0.0, 0.3, 0.1).size == 4
    assert regular_points(60.0, 420.0, 0.1)[-1] == pytest.approx(420.0)


def test_probes_meet_snapshots_and_grid(motion):
    fine = motion["relative_displacement_all"]
    for t in motion["t"].values:
        row = fine.sel(t_all=t, method="nearest").values
        np.testing.assert_allclose(row, motion["relative_displacement"].sel(t=t)[:-1], atol=1e-12)
    grid = motion["relative_displacement_grid"].isel(bead=slice(None, -1))
    np.testing.assert_allclose(fine[:: round(1.0 / FINE)], grid, atol=1e-13)


def test_probe_beads_keep_their_order(motion):
    few = motion["relative_displacement_few"]
    assert few["bead_few"].values.tolist() == [7, 3]
    fine = motion["relative_displacement_all"]
    for bead in (7, 3):
        expected = fine.sel(bead_all=bead).sel(t_all=few["t_few"], method="nearest")
        np.testing.assert_allclose(few.sel(bead_few=bead), expected, atol=1e-12)


def test_velocities_are_rates_of_relative_displacements(motion):
    """u̇_n = ẋ_n − ẋ_{n+1}, by central differences of the fine samples."""
    fine = motion["relative_displacement_all"].values
    rate = (fine[2:] - fine[:-2]) / (2.0 * FINE)
    velocity = motion["velocity_grid"].values
    rows = np.arange(1, 80) * round(1.0 / FINE) - 1
    np.testing.assert_allclose(rate[rows], -np.diff(velocity[1:80], axis=1), atol=1e-6)


def test_arrivals_are_level_crossings(motion):
    fine, times = motion["relative_displacement_all"], motion["t_all"].values
    for bead in range(1, 24):
        u = fine.sel(bead_all=bead).values
        first = np.argmax(u >= 0.05)
        crossing = np.interp(0.05, u[first - 1 : first + 1], times[first - 1 : first + 1])
        assert float(motion["arrival_time"].sel(bead=bead)) == pytest.approx(crossing, abs=1e-6)


def test_extremes_bound_all_samples_and_are_nearly_met(motion):
    fine = motion["relative_displacement_all"].values
    largest = float(motion["largest_relative_displacement"])
    smallest = float(motion["smallest_relative_displacement"])
    assert fine.max() <= largest < fine.max() + 1e-6
    assert smallest <= fine.min() < smallest + 1e-3 * abs(smallest)
    row, column = np.unravel_index(fine.argmax(), fine.shape)
    assert float(motion["largest_relative_displacement_bead"]) == column + 1
    time = float(motion["largest_relative_displacement_time"])
    assert time == pytest.approx(motion["t_all"].values[row], abs=FINE)


def test_first_peak_is_the_first_maximum(motion):
    fine = motion["relative_displacement_all"]
    for bead in (1, 5, 12):
        u = fine.sel(bead_all=bead).values
        peaks = (u[1:-1] > u[:-2]) & (u[1:-1] >= u[2:]) & (u[1:-1] > 0.05)
        first = np.argmax(peaks) + 1
        assert float(motion["first_peak"].sel(bead=bead)) == pytest.approx(u[first], abs=1e-6)
        time = float(motion["first_peak_time"].sel(bead=bead))
        assert time == pytest.approx(motion["t_all"].values[first], abs=2 * FINE)


def test_first_gap_is_the_first_change_of_sign(motion):
    fine, times = motion["relative_displacement_all"].values, motion["t_all"].values
    # Ahead of the wave the interpolated samples are rounding of either sign.
    opens = (fine[:-1] > 1e-12) & (fine[1:] < -1e-12)
    row, column = np.argwhere(opens)[0]
    u = fine[row : row + 2, column]
    crossing = times[row] + FINE * u[0] / (u[0] - u[1])
    assert float(motion["first_gap_time"]) == pytest.approx(crossing, abs=1e-6)
    assert float(motion["first_gap_bead"]) == column + 1


def test_reductions_of_the_grid(motion):
    u = motion["relative_displacement_grid"].isel(bead=slice(None, -1))
    np.testing.assert_allclose(motion["mean_relative_displacement"], u.sum("bead") / 24, atol=1e-16)
    exact = 0.1**1.5 * motion["t_grid"]
    np.testing.assert_allclose(motion["total_velocity"], exact, rtol=1e-13, atol=1e-13)


def test_front_speed_is_the_slope_of_the_arrivals(motion):
    arrival = motion["arrival_time"].sel(bead=slice(12, 20)).values
    assert float(motion["front_speed"]) == pytest.approx(1.0 / np.diff(arrival).mean(), rel=0.02)


def test_nothing_is_recorded_that_was_not_asked_for():
    scene = driven_scene(end_time=20.0)
    dataset = solve(scene, scene["tolerance"]).dataset
    assert set(dataset.data_vars) == {"relative_displacement", "velocity"}


def test_speed_is_the_slope_of_the_middle_and_none_without_a_slope():
    bead = np.arange(100.0)
    assert fitted_speed(bead / 0.7) == pytest.approx(0.7, rel=1e-14)
    assert np.isnan(fitted_speed(np.abs(bead - 69.5)))  # Two waves meet in the middle.
    assert np.isnan(fitted_speed(np.where(bead == 60, 1.0, np.nan)))
