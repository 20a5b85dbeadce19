"""The numbers of docs/practitioners.md are those of the study and of the referee."""

import os
import re
import shlex
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from half_steps import half_steps, write_dump
from pages import commands, run
from projects import ROOT
from write_referee import write_referee

from granular_fronts.referee.answers import solve
from granular_fronts.referee.assessment import find, observed_order, report
from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.lammps_run import run_lammps
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.settings import read_settings
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.half_step_damping import measure_excess, measure_half_step_damping
from granular_fronts.studies.half_step_motions import Case, collision_time
from peers.lammps_chain import find_command

DOCUMENT = ROOT / "docs" / "practitioners.md"
PAGE = DOCUMENT.read_text(encoding="utf-8")
TEXT = " ".join(PAGE.split())
REFERENCES = ROOT / "tests" / "references"
COUNTS = {2: "two", 12: "twelve"}
SETTINGS = read_settings(ROOT / "config" / "referee.yaml")
PROBLEMS = load_problems(SETTINGS)
QUOTED = re.search(r"```\n(front_steel_viscoelastic: .*?)\n```", PAGE, re.DOTALL).group(1)
PACKAGES = str(ROOT / "src")
COLUMNS = ("excess_overshoot", "excess_tail", *(f"{n}_defect" for n in ("restitution", "energy")))
COLUMNS += ("speed_defect", "momentum_defect")


def last_digit(number):
    """Half a unit of the last digit of a decimal number."""
    return 0.5 * 10.0 ** -len(number.partition(".")[2])


@pytest.fixture(scope="module")
def measured():
    scene = load_configuration(ROOT / "config" / "default.yaml")["laws"]["half_step_damping"]
    shown = scene["shown"]
    assert shown["beta"] == 1.5
    assert shown["gamma"] == 0.05
    return measure_half_step_damping(scene | {"steps_per_collision": [10, 20, 50, 100]})


def test_table_of_checks(measured):
    rows = re.findall(r"^\| 1/(\d+) \| (.*) \|$", PAGE, re.MULTILINE)
    assert [int(count) for count, _ in rows] == [10, 20, 50, 100]
    for count, cells in rows:
        at = measured.sel(beta=1.5, gamma=0.05).sel(step=1.0 / int(count), method="nearest")
        for name, cell in zip(COLUMNS, cells.split(" | "), strict=True):
            if cell.startswith("<"):
                assert float(at[name]) < float(cell[1:])
                continue
            number = cell.removesuffix(" %")
            assert 100.0 * float(at[name]) == pytest.approx(float(number), abs=last_digit(number))


def test_sentences_around_the_table(measured):
    """About h/t_c more damping by the overshoot, a third of that by the tail, and 1 to 2 %."""
    shown = measured.sel(beta=1.5, gamma=0.05)
    ratio = shown["excess_overshoot"] / shown["step"]
    assert "takes the error for about h/t_c more damping and the tail for a third of that" in TEXT
    assert ratio.values == pytest.approx(1.0, abs=0.15)
    assert (shown["excess_tail"] / shown["excess_overshoot"]).values == pytest.approx(0.3, abs=0.1)
    low, high = map(float, re.search(r"it is (\d) to (\d) % of the damping", TEXT).groups())
    fine = 100.0 * shown["excess_overshoot"].sel(step=[0.02, 0.01], method="nearest")
    assert fine.round().values.tolist() == [high, low]


def test_chains_of_other_codes_are_those_stored():
    stored = xr.load_dataset(REFERENCES / "lammps_reference.nc")
    step, end = stored.attrs["step"], stored.attrs["end_time"]
    chains = f"on {COUNTS[stored.sizes['case']]} chains of {stored.sizes['bead']} beads"
    assert f"{chains}, with step {step} up to t = {end:g}" in TEXT
    version = stored.attrs["title"].removesuffix(", fix nve")
    assert re.findall(r"LAMMPS \([^)]*\)", TEXT) == [version] * 2
    others = xr.load_dataset(REFERENCES / "other_codes_reference.nc")
    assert others.attrs["step"] == 0.1
    assert f"on {COUNTS[others.sizes['gamma']]} pressed chains each with step 0.1" in TEXT


@pytest.mark.skipif(not find_command(), reason="LAMMPS is not installed")
def test_what_lammps_gets_with_predicted_velocities():
    *errors, order, scatter = re.search(
        r"`-var integrator mvv` (\S+), (\S+) and (\S+) at steps 0.25, 0.1 and 0.05, of order (\S+)"
        r" ± (\S+?)\. ",
        TEXT,
    ).groups()
    name = "front_steel_viscoelastic"
    problem = PROBLEMS[name]
    deck, answer = (
        write_deck(name, problem.title, problem.scene, problem.interval),
        solve(problem),
    )
    results = [run_lammps(find_command(), name, deck, step, "mvv") for step in (0.25, 0.1, 0.05)]
    findings = [find(problem, answer, result) for result, _ in results]
    assert [f"{one.error:.1e}" for one in findings] == [f"{float(error):.1e}" for error in errors]
    found = observed_order(findings)
    assert (f"{found.value:.2f}", f"{found.scatter:.2f}") == (order, scatter)


RULE = re.search(
    r"(\S+) to (\S+) times this in\s+the middle of (\d+) beads. With β = 5/4 it is (\S+) to (\S+)"
    r" times h/t_c,\s+with\s+β = 1 (\S+) to\s+(\S+), in the middle of (\d+) beads",
    PAGE,
)


def holds_tightly(ratio, low, high):
    """Whether printed limits are those of some ratios, to the digits printed."""
    return low <= ratio.min() < low + 0.015 and high - 0.015 < ratio.max() <= high


def test_overshoot_in_a_short_chain(measured):
    rows = re.findall(r"^  \| (0\.\d+) \| (.*) \|$", PAGE, re.MULTILINE)
    assert [float(gamma) for gamma, _ in rows] == measured["gamma"].values.tolist()
    fine = measured.sel(step=slice(0.0201, None))
    ratios = (fine["excess_overshoot"] / fine["step"]).transpose("gamma", "beta", "step")
    printed = [[cell.split(", ") for cell in cells.split(" | ")] for _, cells in rows]
    np.testing.assert_allclose(ratios, np.array(printed, float), rtol=0, atol=0.005)


def test_share_of_the_tail(measured):
    fine = measured.sel(step=slice(0.0201, None))
    share = (fine["excess_tail"] / fine["excess_overshoot"]).transpose("gamma", ...)
    low, high = re.search(
        r"the excess is (\S+) to (\S+) times that of the overshoot", PAGE
    ).groups()
    assert holds_tightly(share.values, float(low), float(high))
    assert np.all(np.diff(share, axis=0) > 0.0)


@pytest.mark.slow
def test_rule_of_thumb_in_a_long_chain():
    unit, counts = collision_time(1.5), np.array([50.0, 100.0, 200.0])
    chains = [Case(1.5, 1.5, gamma, int(RULE[3]), 208 * unit) for gamma in (0.01, 0.03, 0.13)]
    ratios = [measure_excess(case, unit / counts).overshoot * counts for case in chains]
    assert holds_tightly(np.array(ratios), float(RULE[1]), float(RULE[2]))


@pytest.mark.slow
@pytest.mark.parametrize(("beta", "printed"), [(1.25, RULE.group(4, 5)), (1.0, RULE.group(6, 7))])
def test_overshoot_of_weaker_powers_in_a_long_chain(beta, printed):
    unit, counts = collision_time(1.5), np.array([50.0, 100.0, 200.0])
    chains = [Case(1.5, beta, gamma, int(RULE[8]), 108 * unit) for gamma in (0.01, 0.13)]
    ratios = np.array([measure_excess(case, unit / counts).overshoot * counts for case in chains])
    assert holds_tightly(ratios[:, :2], *map(float, printed))


def found_by_half_steps(name, steps):
    problem = PROBLEMS[name]
    answer = solve(problem)
    return problem, [find(problem, answer, half_steps(problem, step)) for step in steps]


def test_what_the_referee_says_of_a_front():
    problem, findings = found_by_half_steps("front_steel_viscoelastic", [0.25, 0.1, 0.05, 0.025])
    said = list(report(problem, findings, 1e-3))
    assert QUOTED.splitlines() == said[: len(QUOTED.splitlines())]


@pytest.mark.slow
def test_commands_run_as_shown(tmp_path):
    """In the folder of the decks, where LAMMPS leaves its dumps."""
    make, enter, ask = commands(DOCUMENT)
    assert make == "snakemake -c2 referee"
    folder = tmp_path / enter.removeprefix("cd ")
    front = {"front": SETTINGS["motions"]["front"] | {"dampings": ["steel"]}}
    write_referee(SETTINGS | {"motions": front}, folder / "answers.csv")
    for step in (0.25, 0.1, 0.05, 0.025):
        result = half_steps(PROBLEMS["front_steel_viscoelastic"], step)
        write_dump(folder / f"front_steel_viscoelastic_{step}.dump", result)
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    outcome = run(["bash", "-c", f"{enter} && {ask}"], tmp_path, PATH=path, PYTHONPATH=PACKAGES)
    assert outcome.returncode == 0, outcome.stderr
    assert QUOTED in outcome.stdout
    assert (folder / "front_steel_viscoelastic.png").stat().st_size > 10_000


@pytest.mark.slow
def test_workflow_can_plan_the_problems():
    words = shlex.split(commands(DOCUMENT)[0])
    outcome = run([sys.executable, "-m", *words, "--dry-run", "--nolock"])
    assert outcome.returncode == 0, outcome.stderr


def test_single_collisions():
    low, high = re.search(r"those of the referee read (\S+) to (\S+) % less damping", PAGE).groups()
    names = [name for name in PROBLEMS if name.startswith("collision")]
    less = [-100.0 * found_by_half_steps(name, [0.1])[1][0].excess for name in names]
    assert min(less) == pytest.approx(float(low), abs=0.05)
    assert max(less) == pytest.approx(float(high), abs=0.05)
    assert "dashpot" in names[int(np.argmax(less))]


def test_numbers_of_the_problems():
    assert int(re.search(r"`results/referee` (\d+) problems", PAGE).group(1)) == len(PROBLEMS)
    stated, count = re.search(r"t_c = (\S+), so that 0\.1 is t_c/(\d+)", PAGE).groups()
    unit = collision_time(1.5) * SETTINGS["displacement"] ** -0.25
    assert unit == pytest.approx(float(stated), abs=0.005)
    assert round(unit / 0.1) == int(count)


@pytest.mark.slow
@pytest.mark.parametrize("name", PROBLEMS)
def test_errors_of_the_answers(name):
    below = float(re.search(r"with their errors \(below (\S+)\)", PAGE).group(1))
    answer = solve(PROBLEMS[name])
    fields = ("relative_displacement", "velocity")
    assert max(answer[field].attrs["error_estimate"] for field in fields) < below
    assert answer["value_error"].max() < below


def test_ejected_beads():
    name, slow, more = re.search(
        r"in `(\w+)`, `fix nve` with step 0.1\n.*? is (\S+) % too slow, which reads as (\S+) %",
        PAGE,
    ).groups()
    problem, (found,) = found_by_half_steps(name, [0.1])
    exact = solve(problem)["reading"].sel(factor=1.0)
    assert 100.0 * (1.0 - found.reading / float(exact)) == pytest.approx(float(slow), abs=0.05)
    assert 100.0 * found.excess == pytest.approx(float(more), abs=0.05)
