"""Points of every kind of campaign, and the grid that chunks are merged into."""

import numpy as np
import pytest
import xarray as xr
from campaigns import CHAINS, ORBITS, all_chunks, campaign, solve, solved_points
from chains import driven_scene

from granular_fronts.campaign import merging
from granular_fronts.chain.measures import front_speed
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic, turning_points
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.fronts.sweep import sweep_fronts
from granular_fronts.output.datasets import DatasetError, read_dataset, write_dataset

# Kinds.


def test_chain_point_agrees_with_the_same_scene_in_other_units():
    """Solved with δ = 1 by the campaign and with δ = 0.1 by the scene: James (2021), eq. (29)."""
    given = {**CHAINS, "axes": {"gamma": [0.1]}, "tolerance": 1e-10}
    for beta, right in ((1.5, 0.0), (1.0, 0.02)):
        fixed = {"alpha": 1.5, "beta": beta, "delta": 0.1, "delta_right": right, "beads": 30}
        solved = solved_points(campaign(given, fixed=fixed))
        speed = 0.1**0.25
        record = {"snapshots": [], "arrival_level": 0.05, "extremes": True}
        end_time = 1.2 * 30 / speed
        ends = {"kind": "pressure", "left": 0.1, "right": right}
        scene = driven_scene(0.1, 30, end_time, beta=beta, record=record, boundary=ends)
        data = simulate_chain(scene)
        expected = {
            "front_speed": front_speed(data).value / speed,
            "overshoot": float(data["first_peak"].sel(bead=15)) / 0.1 - 1.0,
            "largest_overshoot": float(data["largest_relative_displacement"]) / 0.1 - 1.0,
            "smallest_compression": float(data["smallest_relative_displacement"]) / 0.1,
            "first_gap_time": float(data["first_gap_time"]) * speed,
            "first_gap_bead": float(data["first_gap_bead"]),
        }
        for name, value in expected.items():
            assert solved.values[name][0, 0] == pytest.approx(value, rel=1e-7, nan_ok=True)


def test_equal_normalised_damping_gives_equal_fronts():
    """For β = α a driven chain depends on γ δ^((α − 1)/2) alone, James (2021), eq. (30)."""
    deltas = [0.01, 1.0]
    results = []
    for delta in deltas:
        axes = {"gamma": [0.1 * delta**-0.25]}
        fixed = {"alpha": 1.5, "beads": 30, "delta": delta}
        results.append(solved_points(campaign(axes=axes, fixed=fixed)).values)
    for name in results[0]:
        np.testing.assert_allclose(results[0][name], results[1][name], rtol=1e-9)


def test_error_estimate_of_chains_bounds_the_error():
    coarse, fine = (solved_points(campaign(tolerance=tolerance)) for tolerance in (1e-6, 1e-11))
    for name in ("front_speed", "overshoot", "largest_overshoot"):
        error = np.nanmax(np.abs(coarse.values[name] - fine.values[name]))
        assert 0.0 < error < 20.0 * coarse.errors[name]


def test_chain_profile_is_u_at_the_end():
    asked = campaign(
        record={"scalars": ["overshoot"], "profile": {"start": 1, "stop": 40, "count": 40}}
    )
    solved = solved_points(asked)
    profile = solved.values["relative_displacement"]
    assert profile.shape == (2, 3, 40)
    assert np.isnan(profile[:, :, 29:]).all(), "no contact beyond bead N − 1"
    data = simulate_chain(driven_scene(0.3, 30, 36.0, delta=1.0))
    expected = data["relative_displacement"].isel(t=0).values[:29]
    np.testing.assert_allclose(profile[1, 1, :29], expected, atol=1e-5)


def test_heteroclinic_points_are_those_of_the_orbit():
    asked = campaign(ORBITS, record={"profile": {"start": -5, "stop": 3, "count": 5}})
    solved = solved_points(asked)
    for column, mu in enumerate(ORBITS["axes"]["mu"]):
        _, overshoot = turning_points(mu)
        assert solved.values["overshoot"][0, column] == (overshoot[0] if overshoot.size else 0.0)
        orbit = heteroclinic(mu, np.linspace(-5, 3, 5))
        np.testing.assert_array_equal(
            solved.values["rescaled_force"][0, column], orbit["rescaled_force"]
        )
        width = solved.values["width_10_90"][0, column]
        crossings = heteroclinic(mu, np.linspace(-60.0, 20.0, 80001))["rescaled_force"]
        below = [
            float(crossings["s"][np.flatnonzero(crossings > level)[-1]]) for level in (0.1, 0.9)
        ]
        assert width == pytest.approx(below[0] - below[1], abs=0.003)
    # At μ = 2 the orbit leaves (1, 0) with an algebraic factor, so that its rate is known worse.
    assert max(error for name, error in solved.errors.items() if name != "growth_rate") < 1e-9


def test_front_points_are_exact_fronts():
    axes = {"alpha": [1.3, 1.5], "gamma": [0.1, 0.6]}
    record = {"profile": {"start": -4, "stop": 4, "count": 9}}
    given = {"kind": "front", "axes": axes, "record": record}
    solved = solved_points(campaign(given))
    assert not solved.reasons.any()
    power = [[(alpha - 1.0) / (2.0 * (alpha + 1.0))] * 2 for alpha in axes["alpha"]]
    np.testing.assert_allclose(solved.values["dissipated_power"], power, rtol=1e-12)
    np.testing.assert_allclose(solved.values["speed_defect"], 0.0, atol=1e-13)
    for (line, fast), overshoot in np.ndenumerate(solved.values["overshoot"]):
        alpha, gamma = axes["alpha"][line], axes["gamma"][fast]
        front = solve_front(alpha, gamma)
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-13)
        width = solved.values["width_10_90"][line, fast]
        assert width == pytest.approx(front.attrs["width_10_90"], abs=1e-12)
        u = solved.values["relative_displacement"][line, fast]
        np.testing.assert_array_equal(u, evaluate_front(front, np.linspace(-4, 4, 9)))
        oscillates = gamma < critical_damping(alpha)
        assert (solved.values["tail_frequency"][line, fast] > 0.0) == oscillates


def test_fronts_are_the_same_whichever_axis_is_fast():
    axes = {"alpha": [1.3, 1.5], "gamma": [0.1, 0.2, 0.6]}
    turned = dict(reversed(axes.items()))
    one, two = (
        solved_points(campaign({"kind": "front", "axes": given})) for given in (axes, turned)
    )
    for name, value in one.values.items():
        np.testing.assert_array_equal(value, two.values[name].T)
    sweeps = [sweep_fronts(alpha, axes["gamma"])["slope_error"].max() for alpha in axes["alpha"]]
    assert one.errors["slope"] == max(sweeps) > min(sweeps)


# Merging, failing points.


@pytest.fixture
def solved_folder(tmp_path):
    asked = campaign()
    files = [solve(chunk, tmp_path) for chunk in all_chunks(asked, 2)]
    return asked, files


def test_merged_grid_holds_each_point_in_its_place(solved_folder):
    asked, files = solved_folder
    merged = merging.merge_chunks(asked, files)
    assert merged.sizes == {"delta": 2, "gamma": 3, "sentence": 1}
    for name, value in solved_points(asked).values.items():
        np.testing.assert_array_equal(merged[name], value)
    errors = [read_dataset(file, file.stem)["overshoot"].error_estimate for file in files]
    assert merged["overshoot"].error_estimate == max(errors) > min(errors)
    assert merged.attrs["failed_points"] == 0
    assert merged.attrs["beads"] == 30
    again = merging.merge_chunks(asked, files[::-1])
    assert merged.drop_vars([]).equals(again)


def test_merged_grid_may_have_its_axes_turned_or_cut(solved_folder):
    asked, files = solved_folder
    merged = merging.merge_chunks(asked, files)
    turned = campaign(axes={"gamma": [0.3, 0.8], "delta": [0.1, 1.0]})
    part = merging.merge_chunks(turned, files)
    assert part["overshoot"].dims == ("gamma", "delta")
    expected = merged["overshoot"].sel(gamma=[0.3, 0.8]).transpose("gamma", "delta")
    assert part["overshoot"].equals(expected)


def test_missing_chunk_is_named(solved_folder):
    asked, files = solved_folder
    with pytest.raises(DatasetError, match="points are in no chunk"):
        merging.merge_chunks(asked, files[1:])


def test_chunk_of_other_settings_is_refused(solved_folder):
    _, files = solved_folder
    with pytest.raises(DatasetError, match="was solved with other settings"):
        merging.merge_chunks(campaign(tolerance=1e-6), files)


def test_merged_file_opens_lazily(solved_folder, tmp_path):
    asked, files = solved_folder
    path = tmp_path / "merged" / "mine.nc"
    write_dataset(merging.merge_chunks(asked, files), path, scene_id="mine", config=CHAINS)
    with xr.open_dataset(path) as data:
        assert not data["overshoot"].variable._in_memory
        assert float(data["overshoot"].sel(delta=0.1, gamma=0.3)) > 0.0
        assert data["overshoot"].attrs["long_name"].startswith("first maximum of u_n")


def test_profile_of_chains_stands_at_the_beads_it_was_taken_at(tmp_path):
    def final_state(count):
        profile = {"start": 1, "stop": 29, "count": count}
        asked = campaign(record={"scalars": ["overshoot"], "profile": profile})
        files = [solve(chunk, tmp_path) for chunk in all_chunks(asked, 10)]
        return merging.merge_chunks(asked, files)["relative_displacement"]

    few = final_state(4)
    assert list(few["bead"].values) == [1, 10, 20, 29]
    xr.testing.assert_equal(few, final_state(29).sel(bead=few["bead"]))


def test_failing_point_has_a_reason_and_the_others_are_solved(tmp_path):
    """A run too short for the front to pass the middle fails; the campaign goes on."""
    asked = campaign(
        axes={"crossings": [0.3, 1.2], "gamma": [0.1, 0.3]},
        fixed={"alpha": 1.5, "beads": 30, "delta": 1.0},
    )
    [chunk] = all_chunks(asked, 10)
    path = tmp_path / "merged.nc"
    write_dataset(
        merging.merge_chunks(asked, [solve(chunk, tmp_path)]), path, scene_id="mine", config=CHAINS
    )
    merged = read_dataset(path)
    assert len(merged.drop_dims("sentence").to_dataframe()) == 4
    np.testing.assert_array_equal(merged["status"], [[1, 1], [0, 0]])
    assert merged.attrs["failed_points"] == 2
    texts = merged["reason_text"].values[merged["reason"].values]
    assert texts[1, 0] == ""
    assert "has not passed the middle of the chain" in texts[0, 0]
    assert np.isnan(merged["overshoot"].values[0]).all()
    assert np.isfinite(merged["overshoot"].values[1]).all()


def test_failure_of_the_solver_is_a_reason_too():
    """Pressures that overflow: the sentence of the integrator becomes the reason."""
    given = {"axes": {"delta_right": [1e300], "gamma": [0.1]}}
    fixed = {"alpha": 1.5, "beads": 30, "delta": 1.0}
    solved = solved_points(campaign(**given, fixed=fixed))
    assert "overflow double precision" in solved.reasons[0, 0]
    assert np.isnan(solved.values["overshoot"][0, 0])
