"""The command that tests codes: exit status, tolerances of schemes, and what it writes."""

import csv
import json
import tomllib
from pkgutil import resolve_name

import pytest
import yaml
from result_files import PROBLEMS, answer_of, write_table

from granular_fronts.numerics.imports import import_closure, module_files, named_in
from granular_fronts.referee import command, files
from granular_fronts.referee.assessment import find
from granular_fronts.referee.command import main
from granular_fronts.referee.problems import described
from granular_fronts.referee.tolerances import deviation, move
from granular_fronts.reference_methods.half_step import SCHEMES
from projects import ROOT

FRONT, WAVE = "front_steel_viscoelastic", "solitary_wave_undamped_hertz"
OVERDAMPED = "front_overdamped_viscoelastic"
COLLISION, PLATE = "collision_steel_viscoelastic", "plate_steel_dashpot"


@pytest.fixture(autouse=True)
def _solve_once(monkeypatch):
    for module in (command, files):
        monkeypatch.setattr(module, "solve", lambda problem: answer_of(problem.name))


def status(*words):
    with pytest.raises(SystemExit) as end:
        main([*map(str, words)])
    return end.value.code


def table(folder, name, step, result):
    """A file that says a step, whoever computed it."""
    folder.mkdir(exist_ok=True)
    return write_table(folder / f"{name}_{step}.csv", result)


@pytest.mark.parametrize(
    ("name", "scheme", "change", "judged_by", "expected"),
    [
        *((FRONT, scheme, {}, scheme, 0) for scheme in SCHEMES),
        (WAVE, "symplectic_euler", {}, "symplectic_euler", 0),
        (PLATE, "lagged_verlet", {}, "lagged_verlet", 0),
        (FRONT, "predicted_verlet", {}, "lagged_verlet", 0),
        # Without damping the lag is not there, and half a step in the velocities is.
        (WAVE, "lagged_verlet", {}, "predicted_verlet", 0),
        (WAVE, "symplectic_euler", {}, "lagged_verlet", 1),
        (FRONT, "lagged_verlet", {}, "predicted_verlet", 1),
        (FRONT, "lagged_verlet", {"factor": 1.03}, "lagged_verlet", 1),
        (FRONT, "lagged_verlet", {"step": 0.125}, "lagged_verlet", 1),
    ],
)
def test_a_scheme_passes_by_its_tolerance_and_faults_do_not(
    name, scheme, change, judged_by, expected, tmp_path, capsys
):
    """At t_c/43; the step of a file's name may be another one than that of the motion."""
    result = move(PROBLEMS[name], **{"step": 0.1, "scheme": scheme} | change)
    file = table(tmp_path, name, 0.1, result._replace(step=0.1))
    assert status("judge", file, "--scheme", judged_by, "--json") == expected
    [case] = json.loads(capsys.readouterr().out)
    [row] = case["results"]
    assert (case["case"], row["step"], row["passes"]) == (name, 0.1, not expected)
    assert case["order"] is None
    within = row["error"] <= row["tolerance"] and row["reading"] <= row["reading_tolerance"]
    assert within == row["passes"]


@pytest.mark.parametrize(
    ("name", "factor", "step", "expected"),
    [
        (FRONT, 0.97, 0.1, 0),
        ("contact_loss_steel_viscoelastic", 0.9, 0.1, 0),
        (FRONT, 0.97, 0.025, 1),
    ],
)
def test_less_damping_hides_behind_that_of_a_step(name, factor, step, expected, tmp_path):
    """As the page says; a smaller step sees it."""
    result = move(PROBLEMS[name], step, factor=factor)
    assert status("judge", table(tmp_path, name, step, result)) == expected


def test_one_result_that_misses_decides(tmp_path, capsys):
    files = [
        table(tmp_path, COLLISION, step, move(PROBLEMS[COLLISION], 0.1)) for step in (0.1, 0.05)
    ]
    assert status("judge", files[0]) == 0
    assert status("judge", *files) == 1
    assert capsys.readouterr().out.count("MISSES") == 1


@pytest.mark.parametrize(
    ("scheme", "orders"),
    [("lagged_verlet", (2, 1)), ("predicted_verlet", (2, 2)), ("symplectic_euler", (1, 1))],
)
def test_impact_without_and_front_with_damping_tell_schemes_apart(scheme, orders, tmp_path, capsys):
    """By two orders, and by a distance that is zero to rounding for one's own scheme alone."""
    files = [
        table(tmp_path, name, step, move(PROBLEMS[name], step, scheme))
        for name in (WAVE, FRONT)
        for step in (0.1, 0.05, 0.025)
    ]
    assert status("judge", *files, "--scheme", scheme, "--json") == 0
    wave, front = json.loads(capsys.readouterr().out)
    assert [case["order"] for case in (wave, front)] == pytest.approx(orders, abs=0.1)
    assert wave["excess_damping"] is None
    assert abs(front["excess_damping"]) < front["change"] < 0.01
    for case in (wave, front):
        same = {name for name, one in case["schemes"].items() if one["distance"] < 1e-10}
        verlets = case is wave and scheme != "symplectic_euler"
        assert same == ({"lagged_verlet", "predicted_verlet"} if verlets else {scheme})
        assert case["schemes"][scheme]["order"] == pytest.approx(case["order"], rel=1e-9)


def test_bad_input_has_a_status_of_its_own_and_one_sentence(tmp_path, capsys):
    cases = (OVERDAMPED, 3), (WAVE, 5)  # An overdamped front has no reading that could decide.
    results = [(move(PROBLEMS[name], 0.1), digits) for name, digits in cases]
    few, fewer = (one._replace(x=one.x.round(n), v=one.v.round(n)) for one, n in results)
    for words, sentence in (
        (["judge", table(tmp_path, OVERDAMPED, 0.1, few)], "2 digits, too few to tell whether"),
        (["judge", table(tmp_path, WAVE, 0.1, fewer)], "digits, too few to tell whether"),
        (["judge", table(tmp_path, WAVE, 1e-300, results[1][0])], "steps of 1e-300 for a"),
        (["judge", tmp_path / f"{FRONT}_*.csv"], "There is no file"),
        (["write", "front_of_steel", tmp_path / "case"], "There is no case front_of_steel: choose"),
        (["write", COLLISION, tmp_path / f"{OVERDAMPED}_0.1.csv"], "no folder can be made"),
    ):
        assert status(*words) == 2
        said = capsys.readouterr()
        assert sentence in said.err
        assert (said.err.count("\n"), said.out) == (1, "")


def test_cases_are_listed(capsys):
    assert status("cases") == status("cases", "--json") == 0
    *lines, described = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in lines] == list(PROBLEMS)
    assert [problem["name"] for problem in json.loads(described)] == list(PROBLEMS)


def test_tolerance_is_the_error_of_a_step_a_quarter_larger(tmp_path):
    """And the table says so of all states and of the four."""
    problem = PROBLEMS[FRONT]
    assert status("write", FRONT, tmp_path) == 0
    assert yaml.safe_load((tmp_path / "case.yaml").read_text())["case"] == FRONT
    table = csv.DictReader((tmp_path / "tolerances.csv").read_text().splitlines())
    rows = {row["scheme"]: row for row in table if row["step"] == "0.1"}
    for scheme, order in (("lagged_verlet", 1), ("predicted_verlet", 2), ("symplectic_euler", 1)):
        row = {name: float(value) for name, value in rows[scheme].items() if name != "scheme"}
        larger = find(problem, answer_of(FRONT), move(problem, 0.125, scheme))
        assert row["motion"] == pytest.approx(larger.error, rel=0.06)
        assert row["reading"] == pytest.approx(deviation(larger), rel=0.2)
        assert 0.7 * larger.error < row["states"] <= row["motion"]
        assert row["order"] == pytest.approx(order, abs=0.08)
        assert row["steps_per_collision"] == pytest.approx(10.0 * problem.collision_time, rel=1e-3)


def test_units_of_steel_beads_are_those_of_the_chain():
    """Force over stiffness, collision time and damping by their formulas, with the SI numbers."""
    case = described(PROBLEMS[COLLISION])
    si, plain = case["si_of_steel_20_mm"], case["dimensionless"]
    assert si["velocity"] == pytest.approx(0.5) == si["velocity_of_bead_1"]
    delta = (si["mass"] * si["velocity"] ** 2 / si["stiffness"]) ** 0.4
    assert si["displacement"] == pytest.approx(delta, rel=1e-13)
    # A time over δ/v, and a damping γ_0 in such times, have no unit.
    # A sphere of mass 1/2 at the velocity v, by Hertz.
    v = plain["velocity"]
    assert plain["collision_time"] == pytest.approx(2.94328 * (0.625 * v**2) ** 0.4 / v, rel=1e-5)
    for name in ("collision_time", "end_time", "interval", "damping"):
        ratio, expected = (one[name] * one["velocity"] / one["displacement"] for one in (si, plain))
        assert ratio == pytest.approx(expected, rel=1e-13)


def test_the_command_is_installed_and_needs_no_workflow():
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["scripts"]
    assert resolve_name(scripts["granular-fronts-referee"]) is main
    modules = module_files(ROOT / "src")
    needed = import_closure([main.__module__], modules)
    named = set().union(*(named_in(modules[name]) for name in needed))
    assert not {"snakemake", "matplotlib"} & named
