"""How speed against error is measured, joined, tabulated, judged and drawn."""

import time
from itertools import product
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import plot_fig14 as drawing
import pytest
import xarray as xr
from dataset_parameters import precision_problems
from pictures import curves

import measure_precision as measuring
import merge_precision as merging
import tabulate_speed_error as tabulating
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.scenes.yaml_files import load_configuration
from peers.runs import Run, Stopwatch
from problems import chain, fronts, log_burgers
from problems.problem import Problem, Reference, errors_of

ROOT = Path(__file__).parents[2]
REFERENCES = ROOT / "tests" / "references"
FAMILIES = {"chain": chain, "fronts": fronts}
ANSWER = {"velocity": Reference(np.array([1.0, 2.0]), np.zeros(2), 1e-9)}


def solution(error, seconds=0.5, share=1.0, **facts):
    fields = {"velocity": np.array([1.0, 2.0 + error])}
    return Run(fields, seconds, share * seconds, 10, 5, **facts)


def test_errors_are_distances_to_the_reference_and_not_below_its_own():
    close, far = errors_of(solution(1e-12), ANSWER), errors_of(solution(1e-3), ANSWER)
    assert close["error"] == close["velocity_error_sup"] == close["velocity_error_rms"] == 1e-9
    assert far["error"] == pytest.approx(1e-3)
    assert far["velocity_error_rms"] == pytest.approx(1e-3 / np.sqrt(2.0))
    assert (close["below_reference"], far["below_reference"]) == (1.0, 0.0)
    assert errors_of(Run(message="stopped"), ANSWER) == {}
    # What double leaves of the reference counts.
    answer = {"velocity": Reference(np.ones(2), np.full(2, 3e-17), 1e-20)}
    found = errors_of(Run({"velocity": np.full(2, np.nextafter(1.0, 2.0))}), answer)
    assert found["error"] == pytest.approx(np.spacing(1.0) - 3e-17, rel=1e-3, abs=0)


def stop(_):
    raise ArithmeticError("the step size collapsed")


METHODS = {
    "mine": lambda tolerance: solution(tolerance, 0.001),
    "theirs": lambda tolerance: solution(tolerance, 0.02, share=0.5),
    "broken": stop,
    "elsewhere": lambda tolerance: Run(message="not installed", absent=True),
}


def test_what_fails_is_kept_and_what_is_absent_is_named():
    problem = Problem("mine", ANSWER, METHODS)
    tolerances = measuring.tolerances_of(
        problem, {"tolerances": [1e-8, 1e-4], "methods": list(METHODS)}
    )
    assert measuring.run_once(problem, tolerances) == {"elsewhere": "not installed"}
    del tolerances["elsewhere"]
    rows = pd.DataFrame(measuring.measure(problem, tolerances, 3)).set_index("solver")
    assert list(rows.index) == ["mine", "mine", "theirs", "theirs", "broken", "broken"]
    assert list(rows.loc["mine", "step_tolerance"]) == [1e-4, 1e-8]
    assert rows.loc["broken", "error"].isna().all()
    assert (rows.loc["broken", "message"] == "ArithmeticError: the step size collapsed").all()
    assert list(rows["disturbed"]) == [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]


def test_least_time_counts_and_a_long_run_is_not_repeated():
    times, calls = iter([0.3, 0.1, 0.2]), []

    def long(_):
        calls.append("long")
        return solution(1e-3, 60.0)

    problem = Problem(
        "quick", ANSWER, {"quick": lambda _: solution(1e-3, next(times)), "long": long}
    )
    rows = measuring.measure(problem, {"quick": [1e-3], "long": [1e-3]}, 3)
    assert [row["seconds"] for row in rows] == [0.1, 60.0]
    assert len(calls) == 1


def test_method_may_have_tolerances_of_its_own():
    listed = {"tolerances": [1e-6, 1e-4], "own_tolerances": {"slow": [1e-3]}}
    problem = Problem("fast", ANSWER, {})
    found = measuring.tolerances_of(problem, listed | {"methods": ["fast", "slow"]})
    assert found == {"fast": [1e-4, 1e-6], "slow": [1e-3]}
    # A family whose configuration gives grids.
    problem = problem._replace(tolerances={"fast": [0.1, 0.2]})
    assert measuring.tolerances_of(problem, {}) == {"fast": [0.2, 0.1]}


@pytest.mark.timing
def test_stopwatch_distinguishes_waiting_from_working():
    with Stopwatch() as idle:
        time.sleep(0.05)
    assert idle.seconds >= 0.05
    assert idle.cpu_seconds < 0.5 * idle.seconds


def test_default_names_only_methods_that_exist_and_references_that_are_stored():
    precision = load_configuration(ROOT / "config" / "default.yaml")["precision"]
    for family, module in FAMILIES.items():
        states = xr.load_dataset(REFERENCES / f"{family}_reference.nc")
        for settings in precision[family].values():
            problem = module.make_problem(settings, states)
            assert {*settings["methods"], *settings.get("own_tolerances", {})} <= {*problem.methods}
            assert problem.ours in settings["methods"]


def test_a_ring_is_solved_by_four_schemes():
    configuration = load_configuration(ROOT / "config" / "default.yaml")
    configuration["precision"]["log_burgers"]["weak"] |= {
        "reference": {"cells": 1024, "tolerance": 1e-9, "points": 512, "longest_step": 0.005},
        "upwind_points": [500, 1000],
        "cells": [128, 256],
        "longest_steps": [0.02],
    }
    [settings] = precision_problems(configuration)["log_burgers"].values()
    problem, errors = log_burgers.make_problem(settings), {}
    assert 0.0 < problem.reference_error < 1e-8
    for method, listed in measuring.tolerances_of(problem, settings).items():
        run = problem.methods[method](listed[-1])
        assert run.seconds > 0.0
        assert run.right_hand_sides >= run.steps > 0
        errors[method, run.grid] = errors_of(run, problem.reference)["error"]
    assert errors["upwind", 1000] == pytest.approx(2.8e-2, rel=0.02)
    assert errors["finite_volumes", 256] < 1e-5
    assert errors["uniform_cells", 256] > 2.0 * errors["finite_volumes", 256]
    assert errors["fourier", 512] < 1e-6
    assert len(errors) == 4


def test_problem_without_a_reference_is_refused():
    for family, module in FAMILIES.items():
        states = xr.load_dataset(REFERENCES / f"{family}_reference.nc")
        with pytest.raises(ValueError, match=r"No reference .* = .*choose a stored one"):
            module.make_problem({"gamma": 0.06, "end_time": 1.0}, states)


@pytest.mark.parametrize("gamma", [0.1, 0.65])
def test_own_methods_agree_with_what_is_stored(gamma):
    states = xr.load_dataset(REFERENCES / "fronts_reference.nc")
    problem = fronts.make_problem({"gamma": gamma}, states)
    assert problem.reference_error < 1e-16
    for method in ("profile", "shooting"):
        run = problem.methods[method](1e-13)
        assert errors_of(run, problem.reference)["error"] < 5e-14


def measured_family(scene, problems, limit=np.nan):
    """A dataset of known curves: error = tolerance, seconds = cost / tolerance^(1/8)."""
    rows = [
        {
            "problem": problem,
            "solver": method,
            "step_tolerance": tolerance,
            "error": np.nan if cost is None else tolerance,
            "below_reference": 0.0,
            "velocity_error_sup": np.nan if cost is None else tolerance,
            "seconds": np.nan if cost is None else cost * tolerance**-0.125,
            "disturbed": float(method == "diffrax_dopri8"),
            "right_hand_sides": 1.0,
            "steps": np.nan,
            "grid": np.nan,
            "message": "stopped" if cost is None else "",
        }
        for problem, costs in problems.items()
        for (method, cost), tolerance in product(costs.items(), [1e-4, 1e-8, 1e-12])
    ]
    facts = {
        p: {"own_method": "strain_form", "reference_error": 1e-15, "time_limit": limit}
        for p in problems
    }
    dataset = measuring.to_dataset(rows, facts)
    dataset.attrs = {
        "absent": '{"lammps_nve": "the command lmp is not installed here"}',
        "load_before": 0.1,
        "machine": "a machine",
        "solver": "least time",
    }
    return dataset, scene


COSTS = {"strain_form": 1.0, "scilab_ode": 100.0, "numbalsoda_dop853": 4.0, "diffrax_dopri8": 50.0}


@pytest.fixture
def merged(tmp_path):
    """Three families in one file."""
    files = []
    for family, problems, limit in (
        ("chain", {"one": COSTS}, np.nan),
        ("fronts", {"two": {"strain_form": 2.0, "scipy_least_squares": None}}, np.nan),
        ("log_burgers", {"log_burgers_weak": {"strain_form": 1e-3, "upwind": 1.0}}, 5e-3),
    ):
        dataset, scene = measured_family(f"precision_{family}", problems, limit)
        if family == "log_burgers":
            dataset["error"].loc[:, "upwind"] = 1e3 * dataset["step_tolerance"].values ** 0.75
        files.append(tmp_path / f"{scene}.nc")
        write_dataset(dataset, files[-1], scene_id=scene, config={})
    merging.merge_precision(files, tmp_path / "speed_error.nc")
    return tmp_path / "speed_error.nc"


def test_families_are_joined_without_loss(merged):
    data = read_dataset(merged, "speed_error")
    assert list(data["problem"].values) == ["one", "two", "log_burgers_weak"]
    assert list(data["solver"].values) == [*COSTS, "scipy_least_squares", "upwind"]
    assert int(np.isfinite(data["disturbed"]).sum()) == 12 + 6 + 6
    point = data.sel(problem="one", solver="scilab_ode", step_tolerance=1e-8)
    assert float(point["seconds"]) == pytest.approx(1000.0)
    assert list(data["own_method"].values) == ["strain_form"] * 3
    np.testing.assert_array_equal(data["time_limit"], [np.nan, np.nan, 5e-3])


def test_same_problem_in_two_families_is_refused(merged, tmp_path):
    family = tmp_path / "precision_chain.nc"
    with pytest.raises(ValueError, match="Problem one is in two families"):
        merging.merge_precision([family, family], tmp_path / "never.nc")


def tabulate(merged):
    files = [merged.with_name(f"{name}.{end}") for name in "abc" for end in ("csv", "md")]
    tabulating.tabulate_speed_error(merged, *files)
    verdicts = pd.read_csv(files[2]).set_index(["problem", "error"])["verdict"]
    return pd.read_csv(files[0], keep_default_na=False), verdicts, pd.read_csv(files[4])


def test_methods_are_compared_at_equal_error(merged):
    table, _, _ = tabulate(merged)
    one = table[(table["problem"] == "one") & (table["error"] == 1e-10)].set_index("method")
    assert one.loc["strain_form", "milliseconds"] == pytest.approx(1e3 * 1e-10**-0.125)
    assert float(one.loc["scilab_ode", "times_ours"]) == pytest.approx(100.0)
    assert one.loc["diffrax_dopri8", "remark"] == tabulating.BUSY
    assert not (table["error"] < 1e-12).any()


def test_verdicts_say_what_to_use_and_whether_a_limit_is_kept(merged):
    _, found, _ = tabulate(merged)
    assert found["one", 1e-9].endswith(
        "4 times faster than numbalsoda_dop853 and 100 times faster than scilab_ode."
    )
    assert "which alone reached it" in found["two", 1e-6]
    assert ("one", 1e-5) not in found
    assert found["log_burgers_weak", 1e-12].endswith(
        "upwind did not get there with the tolerances asked: it comes to 1.0e-06 in "
        f"{1e3 * 1e-12**-0.125:.3g} ms, 5600 times as long as strain_form."
    )
    assert "limit" not in found["log_burgers_weak", 1e-6]
    assert found["log_burgers_weak", 1e-5].endswith("; strain_form keeps its limit of 5 ms.")
    data = read_dataset(merged).sel(problem="log_burgers_weak")
    data["time_limit"] = 4.1e-3
    assert tabulating.judge(data, 1e-5).endswith("; strain_form misses its limit of 4.1 ms.")
    # Of a looser run that takes longer, nothing is said.
    data["seconds"].loc["strain_form", 1e-4] = 1e9
    assert "use strain_form (10 ms)" in tabulating.judge(data, 1e-4)
    data["error"] = data["error"] * 1e4
    assert tabulating.judge(data, 1e-9) == (
        "Nobody reached 1e-09; strain_form came closest with 1.0e-08."
    )


def test_runs_are_listed_with_their_orders(merged):
    *_, runs = tabulate(merged)
    assert len(runs) == 24
    ring = runs[runs["problem"] == "log_burgers_weak"].set_index(["method", "tolerance"])
    np.testing.assert_allclose(ring.loc["strain_form", "order"], [np.nan, 1.0, 1.0])
    np.testing.assert_allclose(ring.loc["upwind", "order"], [np.nan, 0.75, 0.75])
    assert list(ring.loc["upwind"].index) == [1e-4, 1e-8, 1e-12]
    assert ring.loc[("upwind", 1e-8), "milliseconds"] == pytest.approx(1e4)
    assert ring.loc[("upwind", 1e-8), "error"] == pytest.approx(1e-3)


@pytest.mark.parametrize(
    ("costs", "verdict"),
    [
        (
            COSTS | {"strain_form": 8.0},
            "numbalsoda_dop853 (5.33e+04 ms), 2 times faster than strain_form and 25 times faster "
            "than scilab_ode",
        ),
        (
            {"strain_form": 2.0, "strain_form_on_grid": 1.0, "scipy_dop853": 60.0},
            "strain_form (2.67e+04 ms), 30 times faster than scipy_dop853; on a given grid "
            "1.33e+04 ms",
        ),
        ({"own_on_grid": 1.0}, "own_on_grid (1.33e+04 ms), which alone reached it"),
        (
            {"strain_form": 1.0, "scipy_dop853": 60.0, "lammps_nve": 900.0, "lammps_mvv": 240.0},
            "strain_form (1.33e+04 ms), 60 times faster than scipy_dop853; lammps_mvv takes 240 "
            "times as long as strain_form",
        ),
    ],
)
def test_verdict_is_fair_to_rivals_and_names_what_a_user_calls(costs, verdict):
    dataset, _ = measured_family("x", {"one": costs})
    assert tabulating.judge(dataset.sel(problem="one"), 1e-9) == f"To 1e-09 use {verdict}."


def test_figure_14_draws_every_point_and_names_failures(merged):
    data = read_dataset(merged)
    figure = drawing.plot_fig14(data)
    panels = {axes.get_title(): axes for axes in figure.axes}
    assert panels.keys() == {"one", "two", "logarithmic Burgers"}
    lines = curves(panels["one"])
    drawn = [line for line in lines if line.get_linestyle() != "None"]
    seconds = data["seconds"].sel(problem="one").values
    np.testing.assert_allclose(
        np.sort(np.concatenate([line.get_ydata() for line in drawn])),
        np.sort(seconds[np.isfinite(seconds)]),
    )
    hollow = [line for line in lines if line.get_linestyle() == "None"]
    assert sum(line.get_xdata().size for line in hollow) == 3
    assert ": scipy least squares" in panels["two"].get_xlabel()
    assert figure.get_supxlabel() == "not installed here: lammps nve"
    plt.close("all")


@pytest.mark.parametrize("crowded", [True, False])
def test_figure_14_names_each_curve_at_its_end_of_largest_error(crowded):
    costs = {"strain_form": 1.0, "lammps_nve": 9.0, "scipy_least_squares": None}
    costs |= {"scipy_dop853": 8.9} if crowded else {}
    data, _ = measured_family("precision_chain", {"one": costs})
    axes = drawing.plot_fig14(data).axes[0]
    names = {text.get_text().replace(" ", "_"): text for text in axes.texts}
    assert names.keys() == costs.keys() - {"scipy_least_squares"}
    (code,) = [line for line in axes.get_lines() if line.get_linestyle() == "-."]
    assert names["lammps_nve"].get_color() == code.get_color()
    for method, name in names.items():
        assert name.xy == (1e-4, pytest.approx(costs[method] * 1e-4**-0.125))
        _, end = axes.transLimits.transform(axes.transScale.transform(name.xy))
        assert crowded or name.xyann[1] == pytest.approx(end)
    # In the order of the ends, a name's height apart, within the panel.
    places = [names[name].xyann[1] for name in sorted(names, key=lambda name: costs[name])]
    assert 0 <= places[0] < places[-1] <= 1
    assert np.all(np.diff(places) >= drawing.NAME_HEIGHT / drawing.LOWEST - 1e-12)
    assert "failed throughout: scipy least squares" in axes.get_xlabel()
    data["error"][{"problem": 0, "solver": 1, "step_tolerance": 0}] = np.nan
    sentence, _ = drawing._failures(data.isel(problem=0))
    assert sentence == "failed at step 1e-12: lammps nve"
    plt.close("all")


def test_verdict_says_that_no_code_got_there():
    data = measured_family("x", {"one": {"strain_form": 2.0, "lammps_nve": 900.0}})[0]
    data["error"].loc[:, "lammps_nve"] *= 1e6
    verdict = tabulating.judge(data.sel(problem="one"), 1e-9)
    assert verdict.endswith("; no scheme of lammps got there with the steps tried.")
