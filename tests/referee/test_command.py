"""The command that tests codes: exit status, tolerances of schemes, and what it writes."""

import csv
import json
import re
import subprocess
import sys
import tomllib
from pkgutil import resolve_name

import pytest
import yaml
from result_files import write_table

from granular_fronts.referee.command import main
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.tolerances import move
from granular_fronts.reference_methods.half_step import SCHEMES
from projects import ROOT

PROBLEMS = load_problems()
FRONT, WAVE = "front_steel_viscoelastic", "solitary_wave_undamped_hertz"
COLLISION = "collision_steel_viscoelastic"


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
        *((name, scheme, {}, scheme, 0) for name in (FRONT, WAVE) for scheme in SCHEMES),
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


def test_one_result_that_misses_decides(tmp_path, capsys):
    files = [
        table(tmp_path, COLLISION, step, move(PROBLEMS[COLLISION], 0.1)) for step in (0.1, 0.05)
    ]
    assert status("judge", files[0]) == 0
    assert status("judge", *files) == 1
    assert capsys.readouterr().out.count("MISSES") == 1


BESIDE = r"^    (\w+): order (\S+) ± \S+, (\S+) from the result"


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
    assert status("judge", *files, "--scheme", scheme) == 0
    beside = re.findall(BESIDE, capsys.readouterr().out, re.MULTILINE)
    assert status("judge", *files, "--scheme", scheme, "--json") == 0
    cases = json.loads(capsys.readouterr().out)
    assert [case["order"] for case in cases] == pytest.approx(orders, abs=0.1)
    assert cases[0]["excess_damping"] is None
    assert abs(cases[1]["excess_damping"]) < cases[1]["excess_damping_scatter"] < 0.01
    distances = [(name, float(far)) for name, _, far in beside]
    assert {name for name, far in distances[3:] if far < 1e-10} == {scheme}
    assert min(far for name, far in distances[3:] if name != scheme) > 1e-3
    alike = {name for name, far in distances[:3] if far < 1e-10}
    assert alike == (
        {"symplectic_euler"} if orders[0] == 1 else SCHEMES.keys() - {"symplectic_euler"}
    )


def test_bad_input_has_a_status_of_its_own_and_one_sentence(tmp_path, capsys):
    few = move(PROBLEMS[FRONT], 0.1)
    few = few._replace(x=few.x.round(3), v=few.v.round(3))
    for words, sentence in (
        (["judge", table(tmp_path, FRONT, 0.1, few)], "2 digits, too few to tell whether"),
        (["judge", tmp_path / f"{FRONT}_*.csv"], "There is no file"),
        (["write", "front_of_steel", tmp_path / "case"], "There is no case front_of_steel: choose"),
        (["write", COLLISION, tmp_path / f"{FRONT}_0.1.csv"], "no folder can be made"),
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


def test_a_folder_is_enough_to_judge_without_the_package(tmp_path):
    """By the tolerances of the four states, from plain YAML and CSV."""
    assert status("write", FRONT, tmp_path / "case") == 0
    case = yaml.safe_load((tmp_path / "case" / "case.yaml").read_text())
    units = case["dimensionless"]
    states, tolerances = (
        list(csv.DictReader((tmp_path / "case" / f"{name}.csv").read_text().splitlines()))
        for name in ("states", "tolerances")
    )
    assert sorted({float(row["t"]) for row in states}) == [25.0, 50.0, 75.0, 100.0]
    for row in tolerances:
        result = move(PROBLEMS[FRONT], float(row["step"]), row["scheme"])
        error = 0.0
        for one in states[:-1]:
            at, bead = round(float(one["t"]) / units["interval"]), int(one["bead"])
            error = max(error, abs(result.v[at, bead - 1] - float(one["v"])) / units["velocity"])
            if bead < case["beads"]:
                u = result.x[at, bead - 1] - result.x[at, bead]
                error = max(error, abs(u - float(one["u"])) / units["displacement"])
        tolerance = float(row["states"])
        # A step a quarter larger would just pass.
        assert error < tolerance < 1.4 * 1.25 ** float(row["order"]) * error
        collision = units["collision_time"] / float(row["step"])
        assert float(row["steps_per_collision"]) == pytest.approx(collision, rel=1e-3)
    orders = {row["scheme"]: float(row["order"]) for row in tolerances}
    expected = {"lagged_verlet": 1.0, "predicted_verlet": 2.0, "symplectic_euler": 1.0}
    assert orders == pytest.approx(expected, abs=0.05)


def test_units_of_steel_beads_are_those_of_the_chain(tmp_path):
    """Force over stiffness, collision time and damping by their formulas, with the SI numbers."""
    status("write", COLLISION, tmp_path)
    case = yaml.safe_load((tmp_path / "case.yaml").read_text())
    si, plain = case["si_of_steel_20_mm"], case["dimensionless"]
    assert si["velocity"] == pytest.approx(0.5) == si["velocity_of_bead_1"]
    delta = (si["mass"] * si["velocity"] ** 2 / si["stiffness"]) ** 0.4
    assert si["displacement"] == pytest.approx(delta, rel=1e-13)
    # A time over δ/v, and a damping γ_0 in such times, have no unit.
    for name in ("collision_time", "end_time", "interval", "damping"):
        ratio, expected = (one[name] * one["velocity"] / one["displacement"] for one in (si, plain))
        assert ratio == pytest.approx(expected, rel=1e-13)


def test_the_command_is_installed_and_needs_no_workflow():
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["scripts"]
    assert resolve_name(scripts["granular-fronts-referee"]) is main
    code = "import sys, granular_fronts.referee.command; print(*sys.modules)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"snakemake", "matplotlib"} & set(said.stdout.split())
