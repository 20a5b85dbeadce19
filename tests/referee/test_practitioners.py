"""The numbers of docs/practitioners.md are those of the referee."""

import math
import os
import re
import sys
from pathlib import Path

import numpy as np
import pytest
from half_steps import half_steps, write_dump
from lammps import LAMMPS, needs_lammps
from pages import commands, run

from granular_fronts.referee.answers import solve
from granular_fronts.referee.assessment import find, report
from granular_fronts.referee.files import write_problems
from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.lammps_run import run_lammps
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.settings import read_settings
from projects import ROOT

DOCUMENT = ROOT / "docs" / "practitioners.md"
PAGE = DOCUMENT.read_text(encoding="utf-8")
SETTINGS = read_settings()
PROBLEMS = load_problems()
QUOTED = re.search(r"```\n(front_steel_viscoelastic: .*?)\n```", PAGE, re.DOTALL).group(1)
PACKAGES = str(ROOT / "src")
# That of two beads meeting at the velocity of a front, of δ = 1 and of the problems.
UNIT = 2.0 * 0.625**0.4 * math.sqrt(math.pi) * math.gamma(1.4) / math.gamma(0.9)
COLLISION_TIME = UNIT * SETTINGS.displacement**-0.25


def numbers(sentence):
    """The numbers of a sentence of the page, wherever its lines end."""
    return tuple(map(float, re.search(sentence, " ".join(PAGE.split())).groups()))


def found_by_half_steps(name, *steps):
    problem = PROBLEMS[name]
    answer = solve(problem)
    return answer, [find(problem, answer, half_steps(problem, step)) for step in steps]


def test_what_the_referee_says_of_a_front():
    _, findings = found_by_half_steps("front_steel_viscoelastic", 0.25, 0.1, 0.05, 0.025)
    said = list(report(PROBLEMS["front_steel_viscoelastic"], findings, 1e-3))
    assert QUOTED.splitlines() == said[: len(QUOTED.splitlines())]


def test_what_the_referee_says_of_a_solitary_wave():
    """The block is LAMMPS's, which without damping agrees with our scheme to rounding."""
    name = "solitary_wave_undamped_hertz"
    answer, findings = found_by_half_steps(name, 0.25, 0.1, 0.05, 0.025)
    said = "\n".join(report(PROBLEMS[name], findings, 1e-3))
    assert f"```\n{said}\n```" in PAGE
    exact = answer.sel(quantity="speed over the sixth root of the force")
    value, error = numbers(r"of speed 1: (\S+) with an error below (\S+) \(`answers")
    assert float(exact["value"]) == pytest.approx(value, abs=5.1e-13)
    assert float(exact["value_error"]) < error
    read = numbers(r"0\.5 apart, as above, it is (\S+)\. Long waves")
    assert (findings[0].exact,) == pytest.approx(read, abs=5.1e-7)
    assert 100.0 * (1.0 - 0.8**0.5 / value) == pytest.approx(1.2, abs=0.05)
    *counts, _ = numbers(
        r"At \$t_c/(\d+)\$ the number is off by \S+ %, at \$t_c/(\d+)\$ by (\S+) %"
    )
    assert [round(COLLISION_TIME / one.step) for one in findings[:2]] == list(counts)
    defects = [100.0 * (one.measurement / one.exact - 1.0) for one in findings[:2]]
    printed = numbers(r"the number is off by (\S+) %, at \$t_c/43\$ by (\S+) %")
    assert defects == pytest.approx(printed, rel=0.03)
    percent = numbers(r"itself is off by (\S+) % and (\S+) % of δ")
    assert [100.0 * one.error for one in findings[:2]] == pytest.approx(percent, rel=0.05)


@needs_lammps
@pytest.mark.parametrize("older", ["", "gran/hertz/history"])
@pytest.mark.parametrize("name", ["solitary_wave_undamped_hertz", "front_steel_viscoelastic"])
def test_lammps_moves_beads_as_our_scheme_does(name, older):
    """By two styles of contacts, the older one with the page's K_n = 2 and γ_n = 6γ."""
    problem = PROBLEMS[name]
    deck = write_deck(problem.name, problem.title, problem.scene, problem.interval)
    if older:
        style = f"{older} 2 0 {6.0 * problem.scene.law.gamma!r} 0 0 0"
        granular = '"pair_style granular" "pair_coeff * * ${law}"'
        deck = deck.replace(granular, f'"pair_style {style}" "pair_coeff * *"')
    assert older in deck
    found, _ = run_lammps(LAMMPS, problem.name, deck, 0.1)
    ours = half_steps(problem, 0.1)
    np.testing.assert_allclose(found.v, ours.v, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.diff(found.x), np.diff(ours.x), rtol=0, atol=1e-11)


def test_how_a_line_of_balls_breaks_up():
    name = "solitary_wave_undamped_hertz"
    problem, answer = PROBLEMS[name], solve(PROBLEMS[name])
    unit = problem.front_velocity
    last = answer["velocity"].values[-1] / unit
    printed = numbers(r"balls leave with (\S+), (\S+) and (\S+) of the striker")
    assert last[:-4:-1] == pytest.approx(printed, abs=5.1e-10)
    assert (-last[0],) == pytest.approx(numbers(r"goes back with (\S+)\."), abs=5.1e-10)
    assert answer["velocity"].attrs["error_estimate"] / unit < 1e-10
    off = 100.0 * (half_steps(problem, 0.1).v[-1] / unit / last - 1.0)
    fast, slow = numbers(r"the last one is (\S+) % too fast, and the one before (\S+) % too slow")
    assert off[:-3:-1] == pytest.approx([fast, -slow], rel=0.03)


@pytest.mark.slow
def test_single_collisions():
    names = [name for name in PROBLEMS if name.startswith("collision")]
    less = [-100.0 * found_by_half_steps(name, 0.1)[1][0].excess for name in names]
    limits = numbers(r"those of the referee show (\S+) to (\S+) % less damping")
    assert (min(less), max(less)) == pytest.approx(limits, abs=0.05)
    assert "dashpot" in names[int(np.argmax(less))]


def test_ejected_beads():
    answer, (found,) = found_by_half_steps("contact_loss_steel_restitution", 0.1)
    slow = 1.0 - found.measurement / float(answer["reading"].sel(factor=1.0))
    printed = numbers(r"the last bead is (\S+) % too slow, which looks like (\S+) % more damping")
    assert (100.0 * slow, 100.0 * found.excess) == pytest.approx(printed, abs=0.05)


def test_problems_and_the_time_of_a_collision():
    assert numbers(r"writes (\d+) problems into `results/referee`") == (len(PROBLEMS),)
    unit, count = numbers(r"t_c = (\S+)\$, so that 0\.1 is \$t_c/(\d+)\$\.")
    assert (round(COLLISION_TIME, 2), round(COLLISION_TIME / 0.1)) == (unit, count)
    assert (round(UNIT, 3),) == numbers(r"in the units of the front (\S+)\. Judged")


@pytest.mark.slow
def test_errors_of_the_answers():
    (below,) = numbers(r"with their errors \(below (\S+)\)")
    for problem in PROBLEMS.values():
        answer = solve(problem)
        fields = (answer[name] for name in ("relative_displacement", "velocity"))
        assert 0.0 < max(field.attrs["error_estimate"] for field in fields) < below
        assert answer["value_error"].max() < below


@pytest.mark.slow
def test_commands_run_as_shown(tmp_path):
    """In the folder of the decks, where LAMMPS leaves its dumps."""
    make, enter, ask = commands(DOCUMENT)
    assert make == "snakemake -c2 referee"
    folder = tmp_path / enter.removeprefix("cd ")
    name = "front_steel_viscoelastic"
    write_problems({name: PROBLEMS[name]}, folder / "answers.csv")
    for step in (0.25, 0.1, 0.05, 0.025):
        write_dump(folder / f"{name}_{step}.dump", half_steps(PROBLEMS[name], step))
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    outcome = run(["bash", "-c", f"{enter} && {ask}"], tmp_path, PATH=path, PYTHONPATH=PACKAGES)
    assert outcome.returncode == 0, outcome.stderr
    assert QUOTED in outcome.stdout
    assert (folder / f"{name}.png").stat().st_size > 10_000
