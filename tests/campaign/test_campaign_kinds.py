"""Points of chains and fronts, and the grid that chunks are merged into."""

import numpy as np
import pytest
import xarray as xr
from chains import driven_scene

from campaigns import (
    CHAINS,
    CHAINS_OF_A_LAW,
    FRONTS,
    FRONTS_OF_A_LAW,
    TODA,
    all_chunks,
    campaign,
    merged,
    solve,
    solved_points,
)
from granular_fronts.campaign import merging, points
from granular_fronts.chain.measures import front_speed
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.fronts.sweep import sweep_fronts
from granular_fronts.model.laws import make_law
from granular_fronts.output.datasets import DatasetError, read_dataset, write_dataset


def solved(given=CHAINS, **changes):
    found = solved_points(campaign(given, **changes))
    assert not found.reasons.any()
    return found


# Chains.


@pytest.mark.parametrize(("beta", "right", "crossings"), [(1.5, 0.0, 1.2), (1.0, 0.04, 2.2)])
def test_chain_point_agrees_with_the_same_scene_in_other_units(beta, right, crossings):
    """Solved with δ = 1 by the campaign and with δ = 0.1 by the scene: James (2021), eq. (29)."""
    given = {**CHAINS, "axes": {"gamma": [0.1]}, "tolerance": 1e-10}
    fixed = {"alpha": 1.5, "beta": beta, "delta": 0.1, "delta_right": right, "beads": 30}
    fixed |= {"crossings": crossings} if crossings != 1.2 else {}
    profile = {"start": 1, "stop": 40, "count": 40}
    values = solved(given, fixed=fixed, record={"profile": profile}).values
    speed = 0.1**0.25
    end = crossings * 30 / speed
    record = {"snapshots": [end], "arrival_level": 0.05, "extremes": True}
    record["probes"] = {"middle": {"beads": [15], "start": 0.0, "stop": end, "step": 0.02}}
    ends = {"kind": "pressure", "left": 0.1, "right": right}
    data = simulate_chain(driven_scene(0.1, 30, end, beta=beta, record=record, boundary=ends))
    expected = {
        "front_speed": front_speed(data).value / speed,
        "first_peak": float(data["first_peak"].sel(bead=15)) / 0.1 - 1.0,
        "largest_overshoot": float(data["largest_relative_displacement"]) / 0.1 - 1.0,
        "smallest_compression": float(data["smallest_relative_displacement"]) / 0.1,
        "first_gap_time": float(data["first_gap_time"]) * speed,
        "first_gap_bead": float(data["first_gap_bead"]),
    }
    for name, value in expected.items():
        assert values[name][0, 0] == pytest.approx(value, rel=1e-7, nan_ok=True)
    largest = float(data["relative_displacement_middle"].max()) / 0.1 - 1.0
    assert values["overshoot"][0, 0] == pytest.approx(largest, abs=1e-4)
    last = values["relative_displacement"][0, 0]
    assert np.isnan(last[29:]).all(), "no contact beyond bead N − 1"
    u = data["relative_displacement"].isel(t=0).sel(bead=slice(1, 29)).values / 0.1
    np.testing.assert_allclose(last[:29], u, rtol=0, atol=1e-7)


def test_errors_of_chains_hold_at_every_point():
    """Only one of the points here opens its contacts, and its error is stated too."""
    axes = {"delta": [0.001, 0.5, 3.0], "gamma": [0.05, 0.5]}
    fixed = {"alpha": 1.5, "beta": 1.0, "beads": 20, "crossings": 2.5}
    record = {"scalars": ["front_speed", "overshoot", "largest_overshoot", "smallest_compression"]}
    record |= {"profile": {"start": 1, "stop": 20, "count": 20}}
    coarse, fine = (
        solved(axes=axes, fixed=fixed, tolerance=tolerance, record=record)
        for tolerance in (1e-7, 1e-12)
    )
    for name, values in coarse.values.items():
        error = np.nanmax(np.abs(values - fine.values[name]))
        assert 0.0 < error < 2.0 * coarse.errors[name], name


def test_a_contact_that_rises_to_its_highest_at_the_end_has_its_peak_there():
    fixed = {"alpha": 1.5, "beads": 20, "delta": 1.0, "delta_right": 0.5}
    record = {"profile": {"start": 10, "stop": 11, "count": 2}}
    axes = {"gamma": [0.0], "crossings": [2.78]}
    values = solved(axes=axes, fixed=fixed, record=record).values
    assert values["overshoot"] > values["first_peak"]
    assert values["overshoot"] == values["relative_displacement"][..., 0] - 1.0


def test_errors_of_the_last_point_and_of_a_later_peak_are_stated():
    """An undamped chain between two pressures swings on, and its first peak is not its largest."""
    fixed = {"alpha": 1.5, "beads": 20, "delta": 1.0, "delta_right": 0.5}
    axes = {"gamma": [0.0], "crossings": [2.2, 6.0]}
    coarse, fine = (
        solved(axes=axes, fixed=fixed, tolerance=relative) for relative in (1e-7, 1e-13)
    )
    assert fine.values["overshoot"][0, 1] > fine.values["first_peak"][0, 1]
    error = abs(coarse.values["overshoot"] - fine.values["overshoot"])[0, 1]
    assert 0.5 < coarse.errors["overshoot"] / error < 2.0


def test_a_law_of_powers_gives_the_points_of_its_exponents():
    """Solved in the units of the law and in those of δ: James (2021), eq. (29)."""
    ends = {"beads": 30, "delta_right": 1e-8}
    record = {"scalars": [*CHAINS_OF_A_LAW["record"]["scalars"], "smallest_compression"]}
    record["profile"] = {"start": 1, "stop": 29, "count": 29}
    axes = {"gamma": [0.1, 0.3], "delta": [1e-6, 0.5]}
    short = {"kind": "chain", "tolerance": CHAINS_OF_A_LAW["tolerance"], "record": record}
    expected = solved(short | {"axes": axes, "fixed": {"alpha": 1.5, "beta": 2.5} | ends})
    law = {"elastic": {"kind": "hertz", "alpha": 1.5}, "viscous": {"kind": "simon_hunt_crossley"}}
    varied = {"law.viscous.gamma": [0.1, 0.3], "delta": [1e-6, 0.5]}
    found = solved(CHAINS_OF_A_LAW | {"law": law, "axes": varied, "fixed": ends, "record": record})
    assert (expected.values["smallest_compression"] < 0.0).all()
    for name, values in expected.values.items():
        np.testing.assert_allclose(found.values[name], values, rtol=1e-6, atol=1e-7)


# Fronts.


@pytest.mark.parametrize("beta", [None, 1.2])
def test_front_points_are_exact_fronts(beta):
    axes = FRONTS["axes"]
    fixed = {"beta": beta} if beta else {}
    found = solved(FRONTS, fixed=fixed, record={"profile": {"start": -4, "stop": 4, "count": 8}})
    power = [[(alpha - 1.0) / (2.0 * (alpha + 1.0))] * 3 for alpha in axes["alpha"]]
    np.testing.assert_allclose(found.values["dissipated_power"], power, rtol=1e-12)
    np.testing.assert_allclose(found.values["speed_defect"], 0.0, atol=1e-13)
    for (line, fast), overshoot in np.ndenumerate(found.values["overshoot"]):
        alpha, gamma = axes["alpha"][line], axes["gamma"][fast]
        front = solve_front(alpha, gamma, beta=beta)
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-13)
        width = found.values["width_10_90"][line, fast]
        assert width == pytest.approx(front.attrs["width_10_90"], abs=1e-12)
        u = found.values["relative_displacement"][line, fast]
        np.testing.assert_array_equal(u, evaluate_front(front, np.linspace(-4, 4, 8)))
        oscillates = gamma < critical_damping(alpha, beta=beta)
        assert (found.values["tail_frequency"][line, fast] > 0.0) == oscillates
        assert found.errors["relative_displacement"] >= front.attrs["error_estimate"] > 0.0


def test_fronts_are_the_same_whichever_axis_is_fast_and_state_the_largest_error():
    turned = dict(reversed(FRONTS["axes"].items()))
    one, two = (solved(FRONTS, axes=axes) for axes in (FRONTS["axes"], turned))
    for name, value in one.values.items():
        np.testing.assert_array_equal(value, two.values[name].T)
    sweeps = [sweep_fronts(alpha, FRONTS["axes"]["gamma"]) for alpha in FRONTS["axes"]["alpha"]]
    errors = [sweep["slope_error"].max() for sweep in sweeps]
    assert one.errors["slope"] == max(errors) > min(errors)
    for name, value in one.values.items():
        if name.startswith("tail"):
            assert one.errors[name] == np.spacing(value.max())
    estimates = [sweep["error_estimate"] for sweep in sweeps]
    np.testing.assert_array_equal(one.values["profile_error"], estimates)


def test_front_points_of_a_law_are_its_exact_fronts():
    found = solved(FRONTS_OF_A_LAW)
    for (line, fast), overshoot in np.ndenumerate(found.values["overshoot"]):
        rate = FRONTS_OF_A_LAW["axes"]["law.elastic.rate"][line]
        law = make_law(TODA | {"elastic": {"kind": "toda", "rate": rate}})
        damped = law.with_damping(FRONTS_OF_A_LAW["axes"]["damping"][fast])
        front = solve_front(law=damped, states=(-2.0, 0.0))
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-12)
        u, xi = found.values["relative_displacement"][line, fast], np.linspace(-2, 2, 5)
        np.testing.assert_allclose(u, evaluate_front(front, xi), rtol=0, atol=1e-12)
    undamped_axis = solved(FRONTS_OF_A_LAW, axes={"law.elastic.rate": [0.5, 1.0], "ahead": [0.0]})
    np.testing.assert_array_equal(undamped_axis.values["slope"][:, 0], found.values["slope"][:, 1])


# Merging.


@pytest.fixture(scope="module")
def solved_grid(tmp_path_factory):
    """A campaign, the files of its chunks, and its merged grid."""
    folder, asked = tmp_path_factory.mktemp("chunks"), campaign()
    files = [solve(chunk, folder) for chunk in all_chunks(asked, 2)]
    return asked, files, merging.merge_chunks(asked, files)


def test_merged_grid_holds_each_point_in_its_place(solved_grid):
    asked, files, whole = solved_grid
    assert whole.sizes == {"delta": 2, "gamma": 3, "sentence": 1}
    for name, value in solved_points(asked).values.items():
        np.testing.assert_array_equal(whole[name], value)
    errors = [read_dataset(file, file.stem)["overshoot"].error_estimate for file in files]
    assert whole["overshoot"].error_estimate == max(errors) > min(errors)
    assert whole["first_peak"].attrs["long_name"].startswith("first maximum of u_n")
    # Every chunk of two points took a second.
    assert whole.attrs["seconds_per_point"] == len(files) / 6
    assert (whole.attrs["failed_points"], whole.attrs["beads"]) == (0, 30)
    assert whole.equals(merging.merge_chunks(asked, files[::-1]))


def test_merged_grid_may_have_its_axes_turned_or_cut(solved_grid):
    _, files, whole = solved_grid
    turned = campaign(axes={"gamma": [0.3, 0.8], "delta": [0.1, 1.0]})
    part = merging.merge_chunks(turned, files)
    expected = whole["overshoot"].sel(gamma=[0.3, 0.8]).transpose("gamma", "delta")
    assert part["overshoot"].equals(expected)
    assert part.attrs["seconds_per_point"] == whole.attrs["seconds_per_point"]


def test_chunks_that_do_not_make_the_grid_are_refused(solved_grid):
    asked, files, _ = solved_grid
    with pytest.raises(DatasetError, match="points are in no chunk"):
        merging.merge_chunks(asked, files[1:])
    with pytest.raises(DatasetError, match="was solved with other settings"):
        merging.merge_chunks(campaign(tolerance=1e-6), files)


def test_varied_numbers_of_a_law_are_dimensions_of_the_grid_and_profiles_stand_at_their_beads(
    tmp_path,
):
    def grid(count):
        record = {"scalars": ["overshoot"], "profile": {"start": 1, "stop": 29, "count": count}}
        return merged(campaign(CHAINS_OF_A_LAW, record=record), tmp_path, 2)

    few = grid(4)["relative_displacement"]
    assert few.dims == ("elastic_rate", "delta", "bead")
    assert few["elastic_rate"].attrs["long_name"] == "law.elastic.rate"
    assert list(few["bead"].values) == [1, 10, 20, 29]
    xr.testing.assert_equal(few, grid(29)["relative_displacement"].sel(bead=few["bead"]))


# Points that fail.


def test_failing_points_have_their_reasons_and_the_others_are_solved(tmp_path):
    """A motion too short for the front to pass the middle fails; the campaign goes on."""
    asked = campaign(
        axes={"crossings": [0.3, 1.2], "delta_right": [0.0, 1e300]},
        fixed={"alpha": 1.5, "beads": 30, "delta": 1.0, "gamma": 0.1},
    )
    path = tmp_path / "merged.nc"
    write_dataset(merged(asked, tmp_path, 1), path, scene_id="mine", config=CHAINS)
    grid = read_dataset(path)
    np.testing.assert_array_equal(grid["status"], [[1, 1], [0, 1]])
    assert grid.attrs["failed_points"] == 3
    texts = grid["reason_text"].values[grid["reason"].values]
    assert "has not passed the middle of the chain" in texts[0, 0]
    assert "energies of about" in texts[0, 1]
    assert texts[1, 0] == ""
    assert texts[1, 1] == texts[0, 1]
    np.testing.assert_array_equal(np.isfinite(grid["overshoot"]), grid["status"] == 0)


def test_a_front_that_is_not_found_has_no_values():
    """Not even those that are roots of the dispersion relation."""
    found = solved_points(campaign(FRONTS, axes={"gamma": [1e-9, 0.6]}, fixed={"alpha": 1.5}))
    assert found.reasons[0, 0]
    assert not found.reasons[0, 1]
    for value in found.values.values():
        np.testing.assert_array_equal(np.isnan(value), [[True, False]])


def test_numbers_that_overflow_are_a_reason():
    fixed = {"alpha": 1.0001, "beads": 30, "delta": 1e-300, "gamma": 1e300}
    chain = CHAINS | {"axes": {"crossings": [1.0]}, "fixed": fixed}
    law = TODA | {"elastic": {"kind": "hertz", "alpha": 300.0}}
    front = {"law": law, "axes": {"damping": [1e-300]}, "fixed": {"behind": -10.0}}
    for given, words in (
        (chain, "law has gamma 9.66"),
        (FRONTS_OF_A_LAW | front, "A front of this law lies beyond double precision"),
    ):
        found = solved_points(campaign(given))
        assert words in found.reasons[0, 0]
        assert np.isnan(found.values["overshoot"][0, 0])


def test_an_answer_of_a_solver_is_a_reason_and_a_mistake_ends_the_job():
    def solve_points(error):
        def fail():
            raise error

        groups = [(((0,), (0,)), fail), (((0,), (1,)), lambda: {"x": (2.0, 0.25)})]
        groups.append((((0,), (2,)), lambda: {"x": (1.0, 0.125)}))
        return points.solve_groups((1, 3), {"x": ()}, groups, "", "")

    found = solve_points(SolveError("no convergence"))
    assert found.reasons.tolist() == [["no convergence", "", ""]]
    np.testing.assert_array_equal(found.values["x"], [[np.nan, 2.0, 1.0]])
    assert found.errors == {"x": 0.25}
    with pytest.raises(ZeroDivisionError):
        solve_points(ZeroDivisionError("a bug"))
