"""The referee: problems, decks, answers, and what it says of results that are known to be off."""

import math
import re

import numpy as np
import pytest
from newton import newton, solutions
from result_files import PROBLEMS, answer_of, write_table

from granular_fronts.chain import simulate
from granular_fronts.errors import InputError
from granular_fronts.model.collision import restitution
from granular_fronts.output.datasets import read_dataset
from granular_fronts.referee.__main__ import main
from granular_fronts.referee.answers import states
from granular_fronts.referee.assessment import (
    Finding,
    damping_without_step,
    find,
    observed_order,
    report,
)
from granular_fronts.referee.decks import write_decks
from granular_fronts.referee.drawing import draw
from granular_fronts.referee.files import write_problems
from granular_fronts.referee.measurements import excess_damping, first_peak, read_motion
from granular_fronts.referee.problems import in_words, load_problems
from granular_fronts.referee.results_files import Result, read_result
from granular_fronts.referee.settings import read_settings
from granular_fronts.referee.tolerances import move
from granular_fronts.reference_methods.half_step import SCHEMES

SETTINGS = read_settings().plain()
LAWS = SETTINGS["laws"]
FRONT, COLLISION = "front_steel_viscoelastic", "collision_steel_dashpot"
DROP, WAVE = "drop_undamped_hertz", "solitary_wave_undamped_hertz"
SMALL = SETTINGS | {
    "laws": {"viscoelastic": 1.5, "dashpot": 1},
    "factors": [0.97, 1, 1.07, 1.17],
    "motions": {
        "plate": {"beads": 1, "end_time": 20, "dampings": ["steel"]},
        "drop": {"beads": 1, "end_time": 20, "dampings": ["undamped"]},
        "front": {"beads": 16, "end_time": 40, "dampings": ["steel"]},
        "collision": {"beads": 2, "end_time": 20, "dampings": ["steel"]},
        "striker": {"beads": 8, "end_time": 30, "dampings": ["steel"]},
        "contact_loss": {"beads": 8, "end_time": 40, "dampings": ["steel"]},
    },
}

# Of impacts alone by both laws.
SHORT = {
    name: problem
    for name, problem in load_problems(SMALL).items()
    if problem.motion in ("plate", "collision") or not name.endswith("dashpot")
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Answers of a small set of problems."""
    place = tmp_path_factory.mktemp("referee")
    write_problems(SHORT, place / "answers.csv")
    return place


@pytest.fixture(scope="module")
def problem():
    return SHORT[FRONT]


def test_dampings_are_those_of_a_front():
    """γ̂ δ^(5/4 − β): with β = 5/4 the damping has no unit but that of the front."""
    for name, problem in PROBLEMS.items():
        _, damping, law = name.rsplit("_", 2)
        expected = SETTINGS["dampings"][damping] * 0.1 ** (1.25 - SETTINGS["laws"].get(law, 1.5))
        assert problem.scene.law.gamma == pytest.approx(expected, rel=1e-14)
    assert {problem.motion for problem in PROBLEMS.values()} == SETTINGS["motions"].keys()


FORCE = r"u\^\((.*)/(.*)\) \+ (\S+) \* (\S+) \* u\^\((\S+)\) \* du/dt"
FOUND = {
    "lammps.in": (r"hertz (\S+) ", r"hertz \S+ (\S+) damping"),
    "liggghts.in": (r"kn peratomtypepair 1 (\S+)", r"gamman peratomtypepair 1 (\S+)"),
    "yade.py": (r"young=([\d.]+)", r"betan=([\d.e-]+)"),
    "lethe.prm": (r"young modulus wall += (\S+)", r"coefficient particles = (\S+)"),
}
"""Stiffness and damping of a deck."""
PUSHED = {"drop": (0.1**1.25 / 10.0, None)} | dict.fromkeys(
    ("front", "contact_loss"), (0.1**1.5, None)
)
"""Force and velocity of bead 1 where it does not just strike."""


def forces_by_manual(file, stiffness, damping, u, beta, at_plate):
    """Elastic force, and viscous one over the velocity, of spheres of radius 1/2 and mass 1."""
    radius, mass = (0.5, 1.0) if at_plate else (0.25, 0.5)
    log = math.log(damping or 1.0)
    ratio = -log / math.hypot(math.pi, log)  # of damping, if it is a coefficient of restitution
    if file in ("lammps.in", "liggghts.in"):
        elastic = stiffness * radius**0.5 * u**1.5
        by_rate = {1.5: mass * (radius * u) ** 0.5, 1.0: 1.0 + 0.0 * u}.get(beta)
        if beta != 1.25:
            return elastic, damping * by_rate
        return elastic, ratio * (5.0 * mass * stiffness * (radius * u) ** 0.5) ** 0.5
    # YADE takes half the radius at a plate.
    modulus = stiffness / 2.0
    if file == "lethe.prm":
        modulus = 1.0 / (1.0 / 3.0 + 1.0 / stiffness)
        viscous = 2.0 * ratio * (5.0 / 3.0 * mass * modulus * (radius * u) ** 0.5) ** 0.5
    else:
        radius, elastic_rate = 0.25, 2.0 * modulus * (0.25 * u) ** 0.5
        viscous = 2.0 * damping * (mass * elastic_rate) ** 0.5
    return 4.0 / 3.0 * modulus * radius**0.5 * u**1.5, viscous


# Each motion, law and damping at least once, and all decks of each code's law.
DECKS = [
    *(FRONT, "front_overdamped_dashpot", "contact_loss_steel_restitution", "plate_steel_dashpot"),
    *("front_cork_restitution", "striker_glass_restitution", COLLISION, WAVE),
    *("plate_steel_viscoelastic", "plate_steel_restitution", "drop_undamped_hertz"),
]


@pytest.mark.parametrize("name", DECKS)
def test_decks_and_words_are_those_of_the_scene(name):
    """Each by its code's manual; what runs them is in `test_decks.py`."""
    problem, u = PROBLEMS[name], np.array([1e-3, 0.1, 2.0])
    scene, law = problem.scene, problem.scene.law
    viscous = law.gamma * law.beta * u ** (law.beta - 1.0)
    decks, words = write_decks(problem), in_words(problem)
    for file, deck in decks.items():
        numbers = [float(re.search(pattern, deck)[1]) for pattern in FOUND[file]]
        found = forces_by_manual(file, *numbers, u, law.beta, problem.wall)
        np.testing.assert_allclose(found, [u**1.5, viscous], rtol=1e-14)
    assert ("liggghts.in" in decks) == (law.beta == 1.5)
    assert ("yade.py" in decks) == (not law.gamma or name == "front_cork_restitution")
    above, below, gamma, beta, less = map(float, re.search(FORCE, words).groups())
    np.testing.assert_allclose(u ** (above / below), u**1.5)
    np.testing.assert_allclose(gamma * beta * u**less, viscous, rtol=1e-14)
    assert f"up to t = {scene.end_time:g}, " in words
    assert f"at t = 0, {problem.interval:g}, {2 * problem.interval:g}, ..." in words
    deck = decks["lammps.in"]
    assert len(re.findall("^create_atoms 1 single", deck, re.M)) == scene.beads.count
    pushed, struck = PUSHED.get(problem.motion, (None, 0.1**1.25))
    for pattern, expected in ((r"addforce (\S+) 0 0", pushed), (r"^set atom 1 vx (\S+)", struck)):
        found = [float(number) for number in re.findall(pattern, deck, re.M)]
        assert found == ([pytest.approx(expected, rel=1e-15)] if expected else [])
        assert all(repr(number) in words for number in found)
    # Beads that move with the front stay in the box, whose margin is the same on both sides.
    low, high = map(float, re.search(r"region room block (\S+) (\S+) ", deck).groups())
    assert high + low - scene.beads.count >= scene.boundary.left_end**1.25 * scene.end_time


@pytest.mark.parametrize("law", ["viscoelastic", "dashpot"])
@pytest.mark.parametrize("motion", ["plate", "collision"])
def test_answer_of_an_impact_is_the_restitution(folder, motion, law):
    """A ball on a plate loses what two do by their reduced mass, of a damping that is smaller."""
    answer, beta = read_dataset(folder / f"{motion}_steel_{law}" / "answer.nc"), LAWS[law]
    gamma = 0.05 / 2.0 ** (1.0 - beta / 2.5) if motion == "plate" else 0.05
    expected = [restitution(gamma * factor, 1.5, beta) for factor in answer["factor"].values]
    error = np.abs(answer["reading"] - expected).max()
    assert error < 2.0 * answer["reading"].attrs["error_estimate"] < 1e-10
    assert 0.0 < answer["velocity"].attrs["error_estimate"] < 1e-12


def test_a_drop_keeps_its_energy(folder):
    answer, drop = read_dataset(folder / DROP / "answer.nc"), PROBLEMS[DROP]
    x, v = answer["relative_displacement"].values[:, 0], answer["velocity"].values[:, 0]
    weight, fall = 0.1**1.25 / 10.0, 5.0 * 0.1**1.25
    assert (drop.force, -x[0], x[20], v[20]) == pytest.approx((weight, fall, 0.0, 0.1**1.25))
    energy = 0.5 * v**2 + 0.4 * np.maximum(x, 0.0) ** 2.5 - weight * x
    np.testing.assert_allclose(energy, weight * fall, rtol=1e-11)


@pytest.mark.parametrize("name", ["plate_steel_viscoelastic", COLLISION])
def test_collision_time_is_that_without_damping(name):
    """After the contact beads move evenly, so that the last gap tells when they parted."""
    problem = PROBLEMS[name]
    undamped = problem.scene.plain() | {"law": {"alpha": 1.5, "gamma": 0.0}}
    t, u, v = states(problem, simulate.solve(undamped).dataset)
    speed = np.diff(v[-1], append=0.0 if problem.wall else [])[0]
    assert t[-1] + u[-1, 0] / speed == pytest.approx(problem.collision_time, rel=1e-9)


def test_every_problem_has_its_files_and_numbers(folder):
    table = [line.split(",") for line in (folder / "answers.csv").read_text().splitlines()]
    names = {path.name for path in folder.iterdir()} - {"answers.csv"}
    assert {row[0] for row in table[1:]} == names == SHORT.keys()
    assert all(0.0 < float(row[3]) < 1e-9 for row in table[1:] if row[1][:7] != "contact")
    assert any(row[1] == "time of the first gap" for row in table if row[0][:12] == "contact_loss")
    answer = read_dataset(folder / FRONT / "answer.nc")
    assert answer["value"].attrs["error_estimate"] == answer["value_error"].max() > 0.0
    states = answer.sel(t=[10.0, 20.0, 30.0, 40.0])
    v = states["velocity"].values
    u = np.pad(states["relative_displacement"].values, [(0, 0), (0, 1)])
    times, beads = np.meshgrid(states["t"], states["bead"], indexing="ij")
    expected = np.stack([times, beads, u, v], axis=-1).reshape(-1, 4)
    listed = np.loadtxt(folder / FRONT / "states.csv", delimiter=",", skiprows=1)
    np.testing.assert_array_equal(listed[:, :4], expected)
    ends = [float(row[2]) for row in table if row[0] == FRONT and row[1].startswith("velocity")]
    assert ends == v[-1, -3:].tolist()


def test_half_step_scheme_is_told_its_order_and_damping(folder, problem, capsys, tmp_path):
    files = [
        write_table(tmp_path / f"{FRONT}_{step}.csv", move(problem, step), shift)
        for step, shift in ((0.05, 0.0), (0.1, 1.0), (0.025, 0.0))
    ]
    main([*files, "--answers", str(folder), "--figures", str(tmp_path)])
    said = capsys.readouterr().out
    order, scatter = map(float, re.search(r"order is (\S+) ± (\S+)\.\n", said).groups())
    assert abs(order - 1.0) < 0.2 > 2.0 * scatter
    excess = [float(found) for found in re.findall(r"gamma were (\S+) % too large", said)]
    np.testing.assert_allclose(np.divide(excess[:2], excess[1:]), 2.0, rtol=0, atol=0.15)
    # The step over the time of a collision is 2.3 %, of which a short chain shows half.
    assert 1.0 < excess[0] < 1.5
    wanted = float(re.search("For an error of 0.001 take the step (.*)\\.\n", said)[1])
    answer = read_dataset(folder / FRONT / "answer.nc")
    assert find(problem, answer, move(problem, 0.005)).error < 1.3 * 1e-3 * 0.005 / wanted
    assert (tmp_path / f"{FRONT}.png").stat().st_size > 10_000


def test_accurate_result_passes_and_another_damping_is_seen(folder, problem):
    answer = read_dataset(folder / FRONT / "answer.nc")
    u, v = answer["relative_displacement"].values, answer["velocity"].values
    x = np.zeros_like(v)
    x[:, :-1] = np.cumsum(u[:, ::-1], axis=1)[:, ::-1]
    perfect = find(problem, answer, Result(FRONT, 0.1, answer["t"].values, x, v))
    assert perfect.error < 1e-14
    assert abs(perfect.excess) < 1e-12
    for name, scale in (("x", 0.1), ("v", 0.1**1.25)):
        one = np.zeros_like(v)
        one[40, 3] = 1e-4
        off = Result(FRONT, 0.1, answer["t"].values, x, v)._asdict()
        off[name] = off[name] + one
        assert find(problem, answer, Result(**off)).error == pytest.approx(1e-4 / scale, rel=1e-9)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_damping_is_told_from_the_step(folder, problem, scheme):
    """3 % of it are really there, the rest falls with the step."""
    answer, steps = read_dataset(folder / FRONT / "answer.nc"), (0.1, 0.05, 0.025)
    found = [find(problem, answer, move(problem, step, scheme, 1.03)) for step in steps]
    excess, change = damping_without_step(found)
    assert abs(excess - 0.03) < 2.0 * change < 0.003
    assert np.isnan(damping_without_step(found[:2])).all()


def test_order_of_known_errors():
    """The two smallest steps say the order, larger ones how far it is settled."""
    for errors, expected in (
        ((0.48, 0.12, 0.03), (2.0, 0.0)),
        ((99.0, 4.0, 1.0, 0.5), (1.0, 1.0)),
        ((1.0, 0.5), (1.0, np.nan)),
    ):
        steps = 0.1 * 2.0 ** np.arange(len(errors))[::-1]
        findings = [Finding(h, err, 0.0, 0.0, 0.0) for h, err in zip(steps, errors, strict=True)]
        assert observed_order(findings) == pytest.approx(expected, abs=1e-12, nan_ok=True)


@pytest.mark.parametrize(
    ("errors", "sentence", "unsaid"),
    [
        ((8e-3,), "Give a second step", "observed"),
        ((8e-3, 4e-3, 2e-3), "take the step 0.05.\n  Order one has several causes", "not clear"),
        ((32e-3, 8e-3, 2e-3), "take the step 0.071.", "Order one"),
        ((8e-3, 4e-3, 1e-3), "as wanted", "take the step"),
        ((5e-4, 5e-4, 5e-4), "as wanted", "another problem"),
        ((4e-3, 4e-3, 4e-3), "this is another problem", "take the step"),
        ((1e-3, 2e-3, 4e-3), "this is another problem", "take the step"),
        ((8e-3, 4e-3, 4e-3 / 2**1.5), "not clear yet: add a smaller step", "take the step"),
        # Of slope 1 at last, but 3 before.
        ((32e-3, 4e-3, 2e-3), "not clear yet: add a smaller step", "Order one"),
    ],
)
def test_advice_is_what_the_errors_allow(problem, errors, sentence, unsaid):
    findings = [
        Finding(step, error, np.nan, np.nan, np.nan)
        for step, error in zip((0.4, 0.2, 0.1), errors, strict=False)
    ]
    said = "\n".join(report(problem, findings, 1e-3))
    assert sentence in said
    assert unsaid not in said


@pytest.mark.parametrize("motion", ["front", "striker", "contact_loss"])
def test_measurements_are_what_they_are_called(folder, motion):
    """Of δ = 0.1: the first peak of u in the middle, or the velocity of the last bead."""
    answer = read_dataset(folder / f"{motion}_steel_viscoelastic" / "answer.nc")
    measurement = float(answer["reading"].sel(factor=1.0))
    if motion == "contact_loss":
        assert measurement == float(answer["velocity"][-1, -1]) / 0.1**1.25
    else:
        u = answer["relative_displacement"].sel(contact=answer.sizes["bead"] // 2).values / 0.1
        peak = u[np.argmax((u[1:-1] > u[:-2]) & (u[1:-1] > u[2:]) & (u[1:-1] > 0.5)) + 1]
        assert peak <= measurement < 1.01 * peak


def test_overdamped_front_has_no_measurement():
    factors = np.array([0.9, 1.0, 1.1])
    for rise in (1e-3, -1e-5):
        assert np.isnan(excess_damping(1.0, factors, 1.0 + rise * np.array([-1.0, 0.0, 1.0])))
    assert excess_damping(1.0, factors, np.array([1.001, 1.0, 0.999])) == pytest.approx(0.0)
    assert np.isnan(first_peak(np.arange(4.0), np.arange(4.0), np.ones(4))).all()


@pytest.mark.parametrize("name", [FRONT, "contact_loss_steel_viscoelastic", DROP])
def test_answers_are_those_of_newtons_law(folder, name):
    """SciPy's DOP853 knows nothing of strains, of contacts that open, or of refinement."""
    scene = SHORT[name].scene
    last = read_dataset(folder / name / "answer.nc").isel(t=-1)
    held = np.zeros(scene.beads.count - scene.contact_count)
    found = np.concatenate([last["relative_displacement"], held, last["velocity"]])
    np.testing.assert_allclose(found, newton(scene), rtol=0, atol=1e-10)


def test_a_solitary_wave_keeps_its_laws_and_has_the_speed_of_its_force():
    """The answer's between states 0.5 apart is that of the exact wave, and not of long waves."""
    wave = answer_of(WAVE)
    v = wave["velocity"].values[-1]
    # Steps across contacts that open and close cost SciPy accuracy.
    [found] = solutions(PROBLEMS[WAVE].scene, rtol=1e-13, atol=1e-16, max_step=0.05)
    np.testing.assert_allclose(v, found.y[-v.size :, -1], rtol=0, atol=2e-12)
    last = [f"velocity of bead {n} at the end" for n in (38, 39, 40)]
    np.testing.assert_array_equal(wave["value"].sel(quantity=last), v[-3:])
    # Without damping momentum and energy are those of the striker, and all beads have parted.
    assert v.sum() == pytest.approx(0.1**1.25, rel=1e-12)
    assert (v**2).sum() == pytest.approx(0.1**2.5, rel=1e-11)
    assert (np.diff(v) > 0.0).all()
    exact = wave.sel(quantity="speed over the sixth root of the force")
    assert exact["value"] == pytest.approx(1.4873593743493956**-0.25, rel=1e-13)
    assert 0.0 < exact["value_error"] < 1e-13
    np.testing.assert_allclose(wave["reading"] / exact["value"], 1.0, rtol=0, atol=2e-5)
    assert exact["value"] / 0.8**0.5 == pytest.approx(1.0124, abs=1e-4)


def test_errors_of_every_motion_fall_with_the_step(folder):
    """By order one, though not evenly where the force of a dashpot jumps."""
    for name, problem in SHORT.items():
        answer = read_dataset(folder / name / "answer.nc")
        coarse, fine = (find(problem, answer, move(problem, step)).error for step in (0.1, 0.00625))
        assert coarse / fine > (8.0 if problem.scene.law.gamma else 200.0), name


def test_peak_between_states_is_close_to_that_of_the_motion():
    """The number in the docstring of `measurements`, for the front that overshoots most."""
    problem = PROBLEMS["front_glass_viscoelastic"]
    scene = problem.scene.plain()
    record = scene["record"] | {"grid": {"step": 0.05}}
    fine = states(problem, simulate.solve(scene | {"record": record}).dataset)
    coarse = (values[::10] for values in fine)
    assert 1e-4 < 1.0 - read_motion(problem, *coarse) / read_motion(problem, *fine) < 1.3e-4


@pytest.mark.parametrize("name", [FRONT, DROP])
def test_figure_shows_answer_and_results(folder, name):
    problem, answer = SHORT[name], read_dataset(folder / name / "answer.nc")
    results = [move(problem, step) for step in (0.25, 0.1, 0.05)]
    findings = [find(problem, answer, result) for result in results]
    motion, error = draw(problem, answer, results, findings).axes
    at = max(0, problem.scene.beads.count // 2 - 1)
    shown = [problem.relative_displacements(result.x)[:, at] for result in results]
    shown = [answer["relative_displacement"][:, at], *shown]
    for line, u in zip(motion.get_lines(), shown, strict=True):
        np.testing.assert_array_equal(line.get_ydata(), u)
    errors, line = error.get_lines()
    np.testing.assert_array_equal(errors.get_ydata(), [one.error for one in findings])
    slopes = line.get_ydata() / line.get_xdata()
    np.testing.assert_allclose(slopes, findings[-1].error / findings[-1].step, rtol=1e-12)


CSV, FILE = f"{FRONT}_0.1.csv", f"{FRONT}_0.1.dump"
TABLE = "t,bead,x,v\n0,1,0,0\n0,2,0,0\n"
DUMP = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x vx\n1 0 0\n2 1 0\n"
LATER = "ITEM: TIME\n0.5\n" + DUMP.replace("STEP\n0", "STEP\n10")
BOX = "ITEM: BOX BOUNDS pp ff ff\n1 5 0\n0 1 0\n0 1 0\n"
TILTED = BOX.replace("1 0\n0", "1 0.2\n0") + DUMP.replace(" x", " xsu")


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        (f"{FRONT}_0.1.txt", TABLE, "does not say what it is"),
        (f"{FRONT}_inf.csv", TABLE, "does not say what it is"),
        ("wave_0.1.csv", TABLE, "is about wave, but the problems are front_steel"),
        (CSV, "t,bead,x\n", "has no column v"),
        (CSV, TABLE + "9" * 200_000 + "\n", "is no table"),
        (CSV, "t,bead,x,v\n", "holds no states"),
        (CSV, TABLE[:-1], "ends inside a line"),
        (CSV, TABLE + "1,1,nan,0\n", "holds 'nan', no finite number: if the run was lost"),
        (CSV, TABLE + "1,1,o,0\n", "holds 'o' where a number should be"),
        (CSV, TABLE + '1,1,"0,5",0\n', "holds '0,5' where a number should be: write"),
        (CSV, TABLE + "0,1,1,0,5,0,1\n", "has rows of more than 4 numbers"),
        (CSV, TABLE + "0,1,0,0\n1,1,0,0\n", "has 3 rows for 2 times and beads 1 to 2"),
        (CSV, TABLE + "0,1,0,1\n", "has bead 1 twice at t = 0, with different"),
        (f"{FRONT}_0.3.csv", TABLE + "0.5,1,0,0\n0.5,2,0,0\n", "1.667 of these apart, not a whole"),
        (FILE, DUMP + LATER, "are 5 of these apart, not TIMESTEP's 10"),
        (FILE, DUMP[17:], "holds id x vx and no time"),
        (FILE, DUMP.replace(" x", " xs"), "has xs, but no ITEM: BOX BOUNDS"),
        (FILE, DUMP.replace(" 0\n", " 0 1\n").replace("vx", "vx ix"), "has ix other than 0"),
        (FILE, TILTED, "has xsu, but no ITEM: BOX BOUNDS of a box with right angles"),
        (FILE, BOX + DUMP + BOX + LATER.replace("10", "5").replace("2 1", "2 -3"), "half the box"),
        (FILE, DUMP.replace("ATOMS id", "ENTRIES"), "is a dump local or grid of"),
        (f"{FRONT}_*.dump", None, "There is no file"),
        (FILE, "", "is empty"),
        (FILE, "\x1f\x8b\x08", "is compressed by gzip (unpack it)"),
        (f"{FRONT}_0.1.bin", "\xf6" + 7 * "\xff" + "DUMPCUSTOM", "is a binary dump of LAMMPS"),
        (f"{FRONT}_0.1.yaml", "---\ncreator: LAMMPS\n", "is YAML: give a dump custom"),
        (FILE, "ITEM: TIME\nabc\n" + DUMP, "holds 'abc' where a number should be"),
        (FILE, DUMP.replace(" vx", ""), "holds id x and the time, but id, vx, one of"),
    ],
)
def test_files_that_do_not_fit_are_named(name, text, sentence, tmp_path):
    if text is not None:
        (tmp_path / name).write_text(text, encoding="latin-1")
    with pytest.raises(InputError, match=re.escape(sentence)):
        read_result(tmp_path / name, [FRONT])


@pytest.mark.parametrize(
    ("columns", "first", "second"),
    [
        ("x", "0.25", "1.5"),
        ("x ix", "0.25 0", "-2.5 1"),
        ("xs ix", "0.8125 -1", "0.125 0"),
        ("xu ix", "0.25 7", "1.5 7"),
        ("xsu x", "-0.1875 0", "0.125 0"),
    ],
)
def test_dump_and_table_are_read_alike(columns, first, second, tmp_path):
    """By TIMESTEP × step, and in a box from 1 to 5; a restarted run wrote a state again."""
    later = f"ITEM: TIMESTEP\n5\n{BOX}ITEM: ATOMS id {columns} vx\n1 {first} 0\n2 {second} 0.1\n"
    (tmp_path / FILE).write_text(BOX + DUMP + 2 * later)
    # A spreadsheet may mark its encoding by a first character.
    table = f"\ufeff{TABLE}0.5,2,0.5,0.1\n0.5,1,0.25,0\n"
    (tmp_path / CSV).write_text(table, encoding="utf-8")
    dump, table = (read_result(tmp_path / name, [FRONT])[:5] for name in (FILE, CSV))
    for first, second in zip(dump, table, strict=True):
        np.testing.assert_array_equal(first, second)


def test_neither_order_nor_damping_follows_from_few_digits(folder, problem, capsys, tmp_path):
    files, cut = [], np.vectorize(lambda number: float(f"{number:.5g}"))
    for step in (0.1, 0.05, 0.025):
        result = move(problem, step)
        few = result._replace(x=cut(result.x + np.arange(16)), v=cut(result.v))
        files.append(write_table(tmp_path / f"{FRONT}_{step}.csv", few))
    main([*files, "--answers", str(folder)])
    said = capsys.readouterr().out
    assert all(words in said for words in ("by its 5 digits", "format float %.17g"))
    assert not any(words in said for words in ("order is", "gamma were", "take the step"))


def test_results_of_another_motion_are_named(folder, problem):
    """Of other beads, times or starts; velocities of half steps are those of the problem."""
    answer, result = read_dataset(folder / FRONT / "answer.nc"), move(problem, 0.1)
    late = result.v.copy()
    late[0, 0] = 0.5 * 0.1 * 0.1**1.5
    measured = find(problem, answer, result).measurement
    assert find(problem, answer, result._replace(v=late)).measurement == measured
    shorter = {"t": result.t[:-1], "x": result.x[:-1], "v": result.v[:-1]}
    for change, sentence in (
        ({"x": result.x[:, 1:]}, "has 15 beads, but the problem has 16"),
        (shorter, "has no state at t = 40, its last is at t = 39.5"),
        (
            {"x": result.x + 0.001 * np.arange(16)},
            "at t = 0 beads are 0.001 from where they should",
        ),
        ({"v": result.v + 0.1}, "at t = 0 a velocity is 0.1 off"),
        ({"v": 3.0 * late}, "at t = 0 a velocity is"),
    ):
        with pytest.raises(InputError, match=re.escape(sentence)):
            find(problem, answer, result._replace(**change))


def test_impossible_arguments_are_named(folder, problem, tmp_path):
    """The files of an earlier run may be broken, or of other problems."""
    first = write_table(tmp_path / f"{FRONT}_0.1.csv", move(problem, 0.1))
    for name in (COLLISION, FRONT):
        (tmp_path / name / FRONT).mkdir(parents=True)
        (tmp_path / name / "answers.csv").write_text(
            f"problem,quantity,value,error\n{name},a,1,0\n"
        )
        (tmp_path / name / FRONT / "answer.nc").write_text("no dataset")
    known = [first, "--answers", str(folder)]
    for words, sentence in (
        ([first, "--answers", "nowhere"], "nowhere holds no answers: make them by snakemake"),
        ([*known, "--error=0"], r"--error is 0\S*, but must be a finite number, above 0"),
        ([*known, f"--figures={folder}/answers.csv"], "no folder can be made"),
        ([first, *known], "is there twice with step"),
        ([first, "--answers", str(tmp_path / COLLISION)], f"but the problems are {COLLISION}:"),
        ([first, "--answers", str(tmp_path / FRONT)], r"answer\.nc is not a readable netCDF"),
    ):
        with pytest.raises(SystemExit, match=sentence):
            main(words)
