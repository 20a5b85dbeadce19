"""Campaigns over the numbers of a scene: mass ratio, taper, impurity, disorder, striker."""

import numpy as np
import pytest
import xarray as xr
from chains import given
from scipy.special import stdtrit

import granular_fronts as gf
from campaigns import RATIOS, SCENE, campaign, solved_points
from granular_fronts.campaign.averages import mean_over
from granular_fronts.campaign.numbers import with_numbers


def test_a_point_is_the_motion_of_its_scene():
    solved = solved_points(
        campaign(RATIOS, record={"profile": {"start": 1, "stop": 25, "count": 25}})
    )
    for column, ratio in enumerate([0.3, 1.0]):
        record = SCENE["record"] | {"snapshots": [30]}
        scene = SCENE | {"beads": {"count": 20, "mass": {"cell": [1, ratio]}}, "record": record}
        motion = gf.simulate_chain(scene)
        pulses = gf.pulses(motion["contact_force_far"])
        first = pulses["arrival"].sel(pulse=1)
        expected = {
            "largest_force": pulses["peak"].sel(contact_far=15).max(),
            "time_of_flight": first.sel(contact_far=15) - first.sel(contact_far=5),
            "last_velocity": motion["velocity"][0, -1],
            "transmitted_energy": motion["transmitted_energy_far"][-1, 1],
            "transmitted_momentum": motion["transmitted_momentum_far"][-1, 1],
        }
        for name, value in expected.items():
            assert solved.values[name][0, column] == value.item()
            assert 0.0 < solved.errors[name] < 1e-4
        profile = solved.values["velocity"][0, column]
        np.testing.assert_array_equal(profile[:20], motion["velocity"][0])
        assert np.isnan(profile[20:]).all()


def test_the_largest_force_is_that_of_any_pulse_at_the_last_contact():
    """Two beads strike, and the weaker pulse is ahead; contacts are listed in any order."""
    struck = given(np.zeros(19), np.where(np.arange(20) == 9, 0.3, np.arange(20) == 0))
    sensor = SCENE["record"]["sensors"]["far"] | {"contacts": [15, 5]}
    scene = SCENE | {"start": struck, "record": {"snapshots": [], "sensors": {"far": sensor}}}
    solved = solved_points(campaign(RATIOS, scene=scene))
    peaks = gf.pulses(gf.simulate_chain(scene)["contact_force_far"])["peak"].sel(contact_far=15)
    assert peaks[0] < 0.5 * peaks[1]
    assert solved.values["largest_force"][0, 1] == pytest.approx(float(peaks.max()), rel=1e-12)


def test_axes_find_numbers_in_lists_and_keep_whole_ones_and_laws_gain_those_they_lack():
    points = {"beads_mass_random_seed": 7.0, "beads_mass_random_spread": 0.5, "end_time": 12.5}
    beads = {"count": 20, "mass": {"random": {"spread": 0.1, "seed": 1}}}
    scene = with_numbers(SCENE | {"beads": beads}, points)
    assert scene["beads"]["mass"]["random"] == {"spread": 0.5, "seed": 7}
    assert type(scene["beads"]["mass"]["random"]["seed"]) is int
    assert scene["end_time"] == 12.5
    assert with_numbers(SCENE, {"beads_mass_cell_2": 0.3})["beads"]["mass"]["cell"] == [1, 0.3]
    assert SCENE["beads"]["mass"]["cell"] == [1, 1]
    law = with_numbers({"elastic": {"kind": "toda"}}, {"elastic_rate": 2, "viscous_gamma": 0.5})
    assert law == {"elastic": {"kind": "toda", "rate": 2.0}, "viscous": {"gamma": 0.5}}


def test_means_leave_failed_points_out_and_know_nothing_of_one_value():
    values = [[1.0, 2.0, 6.0], [1.0, 2.0, np.nan], [5.0, np.nan, np.nan]]
    data = xr.Dataset({"x": (("a", "seed"), values, {"error_estimate": 0.25}), "reason": ((), 1)})
    means = mean_over(data, "seed")
    assert set(means) == {"x", "x_error"}
    np.testing.assert_allclose(means["x"], [3.0, 1.5, 5.0])
    scatter = [stdtrit(2, 0.975) * (7.0 / 3.0) ** 0.5, stdtrit(1, 0.975) * 0.5, np.inf]
    np.testing.assert_allclose(means["x_error"], 0.5 * np.array(scatter) + 0.25)


@pytest.mark.parametrize("count", [2, 4, 16])
def test_a_scatter_of_draws_covers_the_mean_of_many(count):
    """Of 2000 means of normal numbers 95 % lie within twice the error, however few the numbers."""
    draws = np.random.default_rng(5).normal(3.0, 1.0, (2000, count))
    data = xr.Dataset({"x": (("sample", "seed"), draws, {"error_estimate": 0.0})})
    means = mean_over(data, "seed")
    inside = np.abs(means["x"] - 3.0) < 2.0 * means["x_error"]
    assert inside.mean() == pytest.approx(0.95, abs=0.015)
