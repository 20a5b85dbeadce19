"""The numbers of docs/practitioners.md are those of the referee."""

import os
import sys
from contextlib import nullcontext
from pathlib import Path

import numpy as np
import pytest
from lammps import LAMMPS, needs_lammps
from pages import blocks, commands, load_script, run
from result_files import PROBLEMS, answer_of, write_dump, write_table

from granular_fronts.referee.assessment import find, observed_order, report
from granular_fronts.referee.decks import write_decks
from granular_fronts.referee.files import write_case, write_problems
from granular_fronts.referee.lammps_run import run_lammps
from granular_fronts.referee.tolerances import move
from granular_fronts.reference_methods.half_step import SCHEMES
from projects import ROOT

DOCUMENT = ROOT / "docs" / "practitioners.md"
MEASURED = load_script("measured")
# What LAMMPS gets: without damping it agrees with our scheme to rounding, and nearly with it.
STEPS = (0.25, 0.1, 0.05, 0.025)
QUOTED = {block.partition(":")[0]: block.rstrip() for block in blocks(DOCUMENT, "")}


def assert_page_holds(**numbers):
    """Each is a value and the format in which the page writes it."""
    page = DOCUMENT.read_text(encoding="utf-8")
    written = {name: MEASURED.in_print(*number) for name, number in numbers.items()}
    assert written.keys() <= {*MEASURED.names_in(page)}
    assert MEASURED.fill(page, written) == page


def found_by_half_steps(name, *steps):
    problem, answer = PROBLEMS[name], answer_of(name)
    return answer, [find(problem, answer, move(problem, step)) for step in steps]


@pytest.mark.parametrize("name", QUOTED)
def test_page_quotes_what_the_referee_says(name):
    _, findings = found_by_half_steps(name, *STEPS)
    said = "\n".join(report(PROBLEMS[name], findings, 1e-3))
    assert said.startswith(QUOTED[name])


def test_the_solitary_wave_hardly_sees_the_step():
    answer, findings = found_by_half_steps("solitary_wave_undamped_hertz", 0.25, 0.1)
    exact = answer.sel(quantity="speed over the sixth root of the force")
    assert exact["value_error"] < 1e-13
    speed = float(exact["value"])
    off_1, off_2 = (100.0 * (one.measurement / one.exact - 1.0) for one in findings)
    assert_page_holds(
        solitary_speed=(speed, ".12f"),
        solitary_speed_error=(1e-13, ".0e"),
        solitary_speed_read=(findings[0].exact, ".6f"),
        solitary_speed_long_waves=(100.0 * (1.0 - 0.8**0.5 / speed), ".1f"),
        solitary_off_1=(off_1, ".2g"),
        solitary_off_2=(off_2, ".2g"),
        solitary_error_1=(100.0 * findings[0].error, ".2g"),
        solitary_error_2=(100.0 * findings[1].error, ".2g"),
    )


SIX = ("drop_undamped_hertz", "plate_steel_viscoelastic", "collision_steel_viscoelastic")
SIX += ("solitary_wave_undamped_hertz", "front_steel_viscoelastic")
SIX += ("contact_loss_steel_viscoelastic",)


def seen(name):
    """A line of the page: orders of the schemes, and the damping that the lagged one looks like."""
    problem, answer = PROBLEMS[name], answer_of(name)
    found = {
        scheme: [find(problem, answer, move(problem, step, scheme)) for step in STEPS[1:]]
        for scheme in SCHEMES
    }
    orders = "".join(f"{observed_order(findings)!s:>18}" for findings in found.values())
    excess = found["lagged_verlet"][0].excess
    return f"{name:31}{orders}" + ("" if np.isnan(excess) else f"{100.0 * excess:+8.1f} %")


def test_page_says_what_each_test_sees():
    *lines, page = *map(seen, SIX), blocks(DOCUMENT, "text")[0].splitlines()
    assert page[1:] == lines


def test_two_files_are_a_test(tmp_path, monkeypatch):
    """The faults of symplectic Euler are seen, those of the scheme of LAMMPS pass."""
    problem = PROBLEMS["front_steel_viscoelastic"]
    write_case(problem, tmp_path)
    monkeypatch.chdir(tmp_path)
    [code], names = blocks(DOCUMENT, "python"), {}
    exec(code, names)
    for scheme, outcome in (
        ("lagged_verlet", nullcontext()),
        ("symplectic_euler", pytest.raises(AssertionError)),
    ):
        file = tmp_path / f"{problem.name}_0.1.csv"
        write_table(file, move(problem, 0.1, scheme))
        _, *lines = file.read_text().splitlines()
        file.write_text("\n".join(lines).replace(" ", ""))
        with outcome:
            names["test_a_front"]()


@needs_lammps
@pytest.mark.parametrize("name", ["solitary_wave_undamped_hertz", "front_steel_viscoelastic"])
def test_older_style_of_lammps_moves_beads_alike(name):
    """With the page's K_n = 2 and γ_n = 6γ."""
    problem = PROBLEMS[name]
    style = f"gran/hertz/history 2 0 {6.0 * problem.scene.law.gamma!r} 0 0 0"
    granular = '"pair_style granular" "pair_coeff * * ${law}"'
    deck = write_decks(problem)["lammps.in"]
    assert granular in deck
    deck = deck.replace(granular, f'"pair_style {style}" "pair_coeff * *"')
    found, _ = run_lammps(LAMMPS, problem.name, deck, 0.1)
    ours = move(problem, 0.1)
    np.testing.assert_allclose(found.v, ours.v, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.diff(found.x), np.diff(ours.x), rtol=0, atol=1e-11)


def test_how_a_line_of_balls_breaks_up():
    problem = PROBLEMS["solitary_wave_undamped_hertz"]
    velocity = answer_of(problem.name)["velocity"]
    last = velocity.values[-1] / problem.front_velocity
    assert velocity.attrs["error_estimate"] / problem.front_velocity < 1e-10
    off = 100.0 * (move(problem, 0.1).v[-1] / problem.front_velocity / last - 1.0)
    assert_page_holds(
        ball_last=(last[-1], ".9f"),
        ball_before=(last[-2], ".9f"),
        ball_third=(last[-3], ".9f"),
        ball_first=(-last[0], ".9f"),
        ball_errors=(1e-10, ".0e"),
        ball_last_off=(off[-1], ".2g"),
        ball_before_off=(-off[-2], ".2g"),
    )


@pytest.mark.slow
def test_single_collisions_and_errors_of_all_answers():
    excess = {}
    for name, problem in PROBLEMS.items():
        answer = answer_of(name)
        fields = (answer[name] for name in ("relative_displacement", "velocity"))
        assert 0.0 < max(field.attrs["error_estimate"] for field in fields) < 1e-10
        assert answer["value_error"].max() < 1e-10
        if name.startswith("collision"):
            excess[name] = find(problem, answer, move(problem, 0.1)).excess
    assert "dashpot" in min(excess, key=excess.get)
    assert_page_holds(
        referee_problems=(len(PROBLEMS), "d"),
        referee_errors=(1e-10, ".0e"),
        collision_least=(-100.0 * max(excess.values()), ".1f"),
        collision_most=(-100.0 * min(excess.values()), ".1f"),
    )


def test_ejected_beads():
    answer, [found] = found_by_half_steps("contact_loss_steel_restitution", 0.1)
    slow = 1.0 - found.measurement / float(answer["reading"].sel(factor=1.0))
    assert_page_holds(
        ejected_slow=(100.0 * slow, ".1f"), ejected_damping=(100.0 * found.excess, ".1f")
    )


@pytest.mark.slow
def test_commands_run_as_shown(tmp_path):
    """With our scheme in the place of LAMMPS."""
    cases, write, test, make, enter, ask = commands(DOCUMENT)
    assert (cases, make) == ("granular-fronts-referee cases", "snakemake -c2 referee")
    name, folder = "front_steel_viscoelastic", tmp_path / enter.removeprefix("cd ")
    write_problems({name: PROBLEMS[name]}, folder / "answers.csv")
    for place, steps in ((folder, STEPS), (tmp_path, (0.1,))):
        for step in steps:
            write_dump(place / f"{name}_{step}.dump", move(PROBLEMS[name], step))
    assert test.startswith("cd case && lmp -in lammps.in -var step 0.1 && ")
    command = "python -m granular_fronts.referee.command"
    test = f"mv *.dump case; cd case && {test.rpartition('&& ')[2]}"
    shell = "; ".join([cases, write, test]).replace("granular-fronts-referee", command)
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    for words in (shell, f"{enter} && {ask}"):
        packages = str(ROOT / "src")
        outcome = run(["bash", "-ec", words], tmp_path, PATH=path, PYTHONPATH=packages)
        assert outcome.returncode == 0, outcome.stderr
    assert QUOTED[name] in outcome.stdout
    assert (folder / f"{name}.png").stat().st_size > 10_000
