"""README and manual are true: commands run or can be planned, code runs, what is named exists."""

import inspect
import pkgutil
import re
import shlex
import sys

import pytest
import yaml
from chains import driven_scene
from pages import (
    EXTENDING,
    README,
    all_blocks,
    blocks,
    commands,
    commands_in_lines,
    load_script,
    run,
    run_module,
)
from PIL import Image

from granular_fronts.campaign.definition import check_campaign
from granular_fronts.output.datasets import configuration_of, read_dataset
from projects import ROOT

DOCS = ROOT / "docs"
COMMANDS, PROOFS = DOCS / "commands.md", DOCS / "proofs.md"
PAGES = load_script("measured").pages()
DOCUMENTS = [*ROOT.glob("*.md"), *ROOT.glob("projects/*/README.md"), *PAGES[1:]]
# Those of the pages on extensions and projects are run on a copy of the project, those of proofs as
# they are, those for practitioners in the folder of the answers (test_practitioners.py).
ELSEWHERE = (EXTENDING, PROOFS, DOCS / "practitioners.md", DOCS / "your_project.md")
SHOWN = {line for page in DOCUMENTS if page not in ELSEWHERE for line in commands(page)}
NAMED = {
    line for page in DOCUMENTS if page.name != "CHANGELOG.md" for line in commands_in_lines(page)
}


@pytest.fixture
def words_of(tmp_path):
    """The words of the commands of a program; mine.yaml is what README lays over the defaults."""
    file = tmp_path / "mine.yaml"
    [text] = blocks(README, "yaml")
    file.write_text(text, encoding="utf-8")

    def find(program, shown):
        found = {tuple(shlex.split(command.replace("mine.yaml", str(file)))) for command in shown}
        return [words[1:] for words in sorted(found) if words[0] == program]

    return find


def test_make_knows_its_targets(words_of):
    targets = {target for words in words_of("make", SHOWN | NAMED) for target in words}
    outcome = run(["make", "--dry-run", *targets])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.slow
def test_workflow_can_plan_its_targets(words_of):
    # To lock is Snakemake's own business.
    shown = [words for words in words_of("snakemake", SHOWN | NAMED) if "--unlock" not in words]
    short = [rest for options, *rest in shown if options == "-c2" and len(rest) < 2]
    targets = [target for rest in short for target in rest or ["all"]]
    for words in [["-c2", *targets], *(words for words in shown if len(words) > 2)]:
        outcome = run([sys.executable, "-m", "snakemake", "--dry-run", "--nolock", *words])
        assert outcome.returncode == 0, outcome.stderr


def test_modules_run_as_shown(words_of, monkeypatch):
    monkeypatch.chdir(ROOT)
    for option, *words in words_of("python", SHOWN):
        assert option == "-m"
        assert run_module(monkeypatch, *words) is None


@pytest.mark.parametrize("name", ["start", "commands", "what_is_a_front"])
def test_pages_print_what_they_show(name, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    names, printed, compared = {}, "", 0
    for language, text in all_blocks(DOCS / f"{name}.md"):
        if language == "python":
            exec(text, names)
            printed = capsys.readouterr().out
        elif language == "text" and printed:
            assert printed == text
            printed, compared = "", compared + 1
    assert compared


def test_readme_prints_what_it_shows(capsys):
    """The number to all its digits, the error to its order, which depends on the machine."""
    [code], [shown] = blocks(README, "python"), blocks(README, "text")
    exec(code, {})
    (text, error), (shown, known) = (
        words.split(" ± ") for words in (capsys.readouterr().out, shown)
    )
    assert text == shown
    assert float(known) / 10 < float(error) < float(known) * 10


def test_example_that_reads_a_finished_run_is_executed(monkeypatch):
    if not (ROOT / "results" / "report.html").exists():
        pytest.skip("the workflow has not run")
    monkeypatch.chdir(ROOT)
    [code] = blocks(DOCS / "tutorials" / "front_initiation.md", "py")
    exec(code, {})


def test_a_scene_in_a_file_is_simulated_or_refused(tmp_path, monkeypatch):
    scene = driven_scene(beads=20, end_time=5.0)
    file, dataset = tmp_path / "scene.yaml", tmp_path / "out.nc"
    for beads, said in ((20, ""), (-4, "beads is -4")):
        file.write_text(yaml.safe_dump(scene | {"beads": beads}), encoding="utf-8")
        ends = run_module(monkeypatch, "granular_fronts", "simulate", file, dataset)
        assert said in (ends or "")
        assert bool(ends) == bool(said)
    assert configuration_of(read_dataset(dataset)) == scene


@pytest.mark.slow
def test_commands_on_proofs_accept_the_certificates_kept_and_print_what_is_shown():
    printed = ""
    for command in commands(PROOFS):
        outcome = run([sys.executable, *shlex.split(command)[1:]])
        assert outcome.returncode == 0, outcome.stderr
        printed += outcome.stdout
    shown = [line.strip() for block in blocks(PROOFS, "text") for line in block.splitlines()]
    assert shown
    assert [line for line in shown if line not in printed] == []


# Ten seconds, in which the tests of proofs prove the like.
@pytest.mark.nightly
def test_examples_on_proofs_prove(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    for code in blocks(PROOFS, "python"):
        exec(code, names)
        assert names["record"]["proved"]


FIGURES = {file.stem for file in ROOT.glob("workflow/captions/*.rst") if file.stem[:6] != "table_"}


def test_gallery_shows_every_figure_of_a_plain_call():
    page = (DOCS / "gallery.md").read_text(encoding="utf-8")
    assert [name for name in FIGURES if f"figures/{name}.png" not in page] == []


def test_small_pictures_show_the_default_configuration(default):
    digest = load_script("pictures").digest
    parts = [*default["scenes"].values(), default["exact_fronts"], default["laws"]]
    parts.append({"log_burgers_fronts": {"exponents": default["front_exponents"]}})
    known = {f"{name}:{digest(one)}" for part in parts for name, one in part.items()}
    pictures = sorted((DOCS / "figures").glob("*.png"))
    assert {file.stem for file in pictures} == FIGURES
    for file in pictures:
        with Image.open(file) as picture:
            assert set(picture.text["Keywords"].split()) <= known, f"run docs/pictures.py ({file})"


def test_shown_campaigns_are_possible():
    for text in blocks(COMMANDS, "yaml"):
        assert check_campaign(yaml.safe_load(text), "shown").size > 1


def test_laboratory_scene_is_the_same_in_yaml_and_in_python():
    page = DOCS / "tutorials" / "laboratory.md"
    [text], names = blocks(page, "yaml"), {}
    exec(blocks(page, "python")[0].partition("motion =")[0], names)
    assert yaml.safe_load(text)["scenes"]["chain"]["steel_ptfe"] == names["scene"]


def test_linked_files_exist():
    """None is a page that only a build writes."""
    for document in DOCUMENTS:
        for name in re.findall(r"\]\((?!https?:)([^)#]+)", document.read_text(encoding="utf-8")):
            assert (document.parent / name).exists(), (document, name)


def test_configuration_page_names_every_key(default):
    page = (ROOT / "config/README.md").read_text(encoding="utf-8")
    keys = {*default, *(f"scenes.{family}" for family in default["scenes"])} - {"scenes"}
    assert [key for key in keys if f"`{key}`" not in page] == []


def test_equations_lead_to_functions_in_files_that_name_them():
    page = (DOCS / "equations.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| \((\d+)\) \| .* \| (.*) \|$", page, re.MULTILINE)
    assert [int(number) for number, _ in rows] == [*range(1, 60)]
    for number, cell in rows:
        for name, link in re.findall(r"\[`([\w.]+)`\]\(([^)]+)\)", cell):
            function = pkgutil.resolve_name(re.sub(r"^(gf\.)?", "granular_fronts.", name))
            file = (DOCS / link).resolve()
            compiled = getattr(function, "py_func", function)
            assert inspect.getsourcefile(compiled) == str(file)
            text = file.read_text(encoding="utf-8")
            named = re.findall(r"\((\d+)\)(?:(?:-| to )\((\d+)\))?", text)
            ranges = [range(int(first), int(last or first) + 1) for first, last in named]
            assert any(int(number) in one for one in ranges), (number, name)
