"""README and manual are true: commands run or can be planned, code runs, what is named exists."""

import csv
import re
import shlex
import sys

import pytest
import yaml
from pages import (
    EXTENDING,
    README,
    blocks,
    commands,
    commands_in_lines,
    load_script,
    run,
)
from PIL import Image

from granular_fronts.output.datasets import configuration_of, read_dataset
from granular_fronts.scenes.yaml_files import load_configuration
from projects import ROOT

START, HOW_TO, PROOFS, PRACTITIONERS, YOUR_PROJECT = (
    ROOT / "docs" / f"{name}.md"
    for name in ("start", "how_to", "proofs", "practitioners", "your_project")
)
MADE_BY_THE_BUILD = ("generated", "_build", "jupyter_execute")
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *sorted(ROOT.glob("projects/*/README.md")),
    *(
        page
        for page in sorted((ROOT / "docs").rglob("*.md"))
        if not set(page.parts) & set(MADE_BY_THE_BUILD)
    ),
]


# Those of the pages on extensions and projects are run on a copy of the project, those of proofs as
# they are, those for practitioners in the folder of the answers (test_practitioners.py).
ELSEWHERE = (EXTENDING, PROOFS, PRACTITIONERS, YOUR_PROJECT)
SHOWN = {line for page in DOCUMENTS if page not in ELSEWHERE for line in commands(page)}
NAMED = {
    line for page in DOCUMENTS if page.name != "CHANGELOG.md" for line in commands_in_lines(page)
}
COMMANDS = sorted(SHOWN | NAMED)


@pytest.fixture
def mine(tmp_path):
    """The small file that README lays over the configuration."""
    [text] = blocks(README, "yaml")
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def words_of(command, mine):
    return [str(mine) if word == "mine.yaml" else word for word in shlex.split(command)]


@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("make")])
def test_make_knows_its_targets(command):
    outcome = run([*shlex.split(command), "--dry-run"])
    assert outcome.returncode == 0, outcome.stderr


# To lock is Snakemake's own business.
PLANNED = [c for c in COMMANDS if c.startswith("snakemake") and " --unlock" not in c]


@pytest.mark.slow
@pytest.mark.parametrize("command", PLANNED)
def test_workflow_can_plan_its_targets(command, mine):
    program, *words = words_of(command, mine)
    outcome = run([sys.executable, "-m", program, "--dry-run", "--nolock", *words])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.parametrize("command", sorted(c for c in SHOWN if c.startswith("python")))
def test_module_runs_as_shown(command, mine):
    outcome = run([sys.executable, *words_of(command, mine)[1:]])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.parametrize(
    "code", [code for page in (README, START) for code in blocks(page, "python")]
)
def test_python_example_runs(code, capsys):
    exec(code, {})
    assert "±" in capsys.readouterr().out


def test_readme_prints_what_it_shows(capsys):
    """The number to all its digits, the error to its order, which depends on the machine."""
    [code], [shown] = blocks(README, "python"), blocks(README, "text")
    exec(code, {})
    (text, error), (shown, known) = (
        words.split(" ± ") for words in (capsys.readouterr().out, shown)
    )
    assert text == shown
    assert float(known) / 10 < float(error) < float(known) * 10


def test_a_number_is_checked_as_shown(capsys, monkeypatch):
    """That of the table; only where the workflow has run."""
    if not (ROOT / "results" / "report.html").exists():
        pytest.skip("the workflow has not run")
    monkeypatch.chdir(ROOT)
    [code] = blocks(HOW_TO, "python")
    exec(code, {})
    shown = float(capsys.readouterr().out.split()[0])
    with (ROOT / "results/tables/paper_numbers.csv").open(newline="", encoding="utf-8") as lines:
        rows = {row["quantity"]: row for row in csv.DictReader(lines)}
    row = rows["largest elastic force of the front over the applied pressure, γ = 0.06"]
    assert shown == pytest.approx(float(row["computed"]), rel=1e-12)


def test_a_scene_in_a_file_is_simulated(tmp_path):
    default = load_configuration(ROOT / "config/default.yaml", ROOT / "config/smoke.yaml")
    scene = default["scenes"]["chain"]["initiation_overdamped"]
    file, dataset = tmp_path / "scene.yaml", tmp_path / "out.nc"
    file.write_text(yaml.safe_dump(scene), encoding="utf-8")
    command = [sys.executable, "-m", "granular_fronts", "simulate", str(file), str(dataset)]
    outcome = run(command)
    assert outcome.returncode == 0, outcome.stderr
    assert configuration_of(read_dataset(dataset)) == scene
    file.write_text(yaml.safe_dump(scene | {"beads": -4}), encoding="utf-8")
    outcome = run(command)
    assert outcome.returncode == 1
    assert "beads is -4" in outcome.stderr
    assert "Traceback" not in outcome.stderr


def test_a_configuration_that_can_be_computed_is_said_so(mine):
    check = [sys.executable, "-m", "granular_fronts.scenes", "config/default.yaml", str(mine)]
    assert run(check).stdout == "The configuration can be computed.\n"


@pytest.mark.slow
def test_page_on_proofs_is_true(tmp_path, monkeypatch):
    """Its commands accept the certificates kept and print what it shows, as its examples prove."""
    [code, dashpots, critical] = blocks(PROOFS, "python")
    printed = ""
    for command in commands(PROOFS):
        assert command.startswith("python -m granular_fronts.proofs ")
        outcome = run([sys.executable, *shlex.split(command)[1:]])
        assert outcome.returncode == 0, outcome.stderr
        printed += outcome.stdout
    shown = [line.strip() for block in blocks(PROOFS, "text") for line in block.splitlines()]
    assert len(shown) == 6
    assert [line for line in shown if line not in printed] == []
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(code, names)
    assert names["record"]["proved"]
    assert "monotone" in names["record"]["statements"][-1]
    assert len(names["family"]) == len(names["records"]) == 2
    assert [one["gamma"] for one in names["family"]] == [one["gamma"] for one in names["records"]]
    assert "one continuous family" in names["theorem"][0]
    exec(critical, names)
    assert names["record"]["numbers"]["critical"] == 1
    assert "is monotone" in names["record"]["statements"][-1]
    exec(dashpots, names)
    assert names["record"]["proved"]
    assert names["record"]["numbers"]["overshoot"] > 1.0136


FIGURES = {
    file.stem
    for file in (ROOT / "workflow" / "captions").glob("*.rst")
    if not file.stem.startswith("table_")
}


def test_gallery_shows_every_figure_of_a_plain_call():
    page = (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8")
    assert set(re.findall(r"figures/(\w+)\.png", page)) == FIGURES


def test_small_pictures_show_the_default_configuration(default):
    digest = load_script("pictures").digest
    parts = [*default["scenes"].values(), default["exact_fronts"], default["laws"]]
    parts.append({"log_burgers_fronts": {"exponents": default["front_exponents"]}})
    known = {f"{name}:{digest(one)}" for part in parts for name, one in part.items()}
    pictures = sorted((ROOT / "docs" / "figures").glob("*.png"))
    assert {file.stem for file in pictures} == FIGURES
    for file in pictures:
        assert file.stat().st_size < 60_000
        with Image.open(file) as picture:
            assert set(picture.text["Keywords"].split()) <= known, f"run docs/pictures.py ({file})"


def test_shown_campaign_is_possible():
    from granular_fronts.campaign.definition import check_campaign

    [text] = blocks(HOW_TO, "yaml")
    assert check_campaign(yaml.safe_load(text), "shown").size > 10_000


def test_laboratory_scene_is_the_same_in_yaml_and_in_python():
    page = ROOT / "docs" / "tutorials" / "laboratory.md"
    [text], names = blocks(page, "yaml"), {}
    exec(blocks(page, "{code-cell}")[0].partition("motion =")[0], names)
    assert yaml.safe_load(text)["scenes"]["chain"]["steel_ptfe"] == names["scene"]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_named_files_and_links_exist(document):
    text = document.read_text(encoding="utf-8")
    named = re.findall(r"`((?:src|workflow|config|tests)/[\w./]+)`", text)
    linked = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    for path in [*(ROOT / name for name in named), *(document.parent / name for name in linked)]:
        # The build of the manual writes these, and finds a dead link to them.
        if "generated" not in path.parts:
            assert path.exists(), path


def test_configuration_page_names_every_key():
    page = (ROOT / "config/README.md").read_text(encoding="utf-8")
    default = yaml.safe_load((ROOT / "config/default.yaml").read_text(encoding="utf-8"))
    keys = {*default, *(f"scenes.{family}" for family in default["scenes"])} - {"scenes"}
    for key in keys:
        assert f"`{key}`" in page


def test_index_of_equations_is_that_of_the_docstrings():
    script = load_script("equations")
    page = (ROOT / "docs" / "equations.md").read_text(encoding="utf-8")
    assert page == script.make_page(*script.find_equations()), "run python docs/equations.py"
