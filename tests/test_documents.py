"""README and manual are true: commands run or can be planned, code runs, what is named exists."""

import csv
import importlib.util
import re
import shlex
import sys
from pathlib import Path

import pytest
import yaml
from pages import (
    EXTENDING,
    README,
    all_blocks,
    blocks,
    commands,
    commands_in_lines,
    named_blocks,
    run,
)
from projects import ROOT, copy_project, snakemake

START, HOW_TO, PROOFS, PRACTITIONERS = (
    ROOT / "docs" / f"{name}.md" for name in ("start", "how_to", "proofs", "practitioners")
)
MADE_BY_THE_BUILD = ("generated", "_build", "jupyter_execute")
DOCUMENTS = [
    *sorted(ROOT.glob("*.md")),
    *(
        page
        for page in sorted((ROOT / "docs").rglob("*.md"))
        if not set(page.parts) & set(MADE_BY_THE_BUILD)
    ),
]


# Those of the page on extensions are run on a copy of the project, those of proofs as they are,
# those for practitioners in the folder of the answers (test_practitioners.py).
ELSEWHERE = (EXTENDING, PROOFS, PRACTITIONERS)
SHOWN = {line for page in DOCUMENTS if page not in ELSEWHERE for line in commands(page)}
NAMED = {
    line for page in DOCUMENTS if page.name != "CHANGELOG.md" for line in commands_in_lines(page)
}
COMMANDS = sorted(SHOWN | NAMED)

NOT_RUN = {
    "snakemake --workflow-profile profiles/slurm": "needs SLURM, see tests/cluster/test_slurm.py",
    "make .venv/installed": "needs a record that was unpacked, see tests/test_crate.py",
    "configfile": "is a workflow of its own, see tests/test_catalog.py",
    "podman build": "needs podman; tests/test_container.py runs the steps of the recipe",
}
"""How blocks of commands begin that no test here runs, and why."""


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


# To lock, to list and to archive is Snakemake's own business.
PLANNED = [c for c in COMMANDS if c.startswith("snakemake") and " --unlock" not in c]


@pytest.mark.slow
@pytest.mark.parametrize("command", PLANNED)
def test_workflow_can_plan_its_targets(command, mine):
    program, *words = words_of(command, mine)
    outcome = run([sys.executable, "-m", program, "--dry-run", "--nolock", *words])
    assert outcome.returncode == 0, outcome.stderr


STEPS = sorted(c for c in SHOWN if c.startswith("python workflow/scripts"))


@pytest.mark.slow
@pytest.mark.parametrize("command", STEPS)
def test_script_runs_as_shown(command, tmp_path):
    words = shlex.split(command)[1:]
    words[-1] = str(tmp_path / words[-1])
    outcome = run([sys.executable, *words])
    assert outcome.returncode == 0, outcome.stderr
    assert Path(words[-1]).exists()


@pytest.mark.parametrize("command", sorted(c for c in SHOWN - {*STEPS} if c.startswith("python")))
def test_module_runs_as_shown(command, mine):
    outcome = run([sys.executable, *words_of(command, mine)[1:]])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.parametrize("command", sorted(c for c in NAMED if c.startswith("python")))
def test_named_script_is_there(command):
    assert (ROOT / shlex.split(command)[1]).is_file()


def test_all_commands_are_of_a_kind_that_is_tested():
    kinds = ("make", "snakemake", "python", "source .venv/bin/activate")
    assert all(command.startswith(kinds) for command in COMMANDS)
    assert all(command.startswith(("snakemake", "python")) for command in commands(EXTENDING))


TESTED = {"sh", "python", "yaml", "rst"}
MADE_BY_SPHINX = {"{code-cell}", "{eval-rst}", "{toctree}", "{include}"}


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_block_is_of_a_kind_that_is_tested(document):
    """Or it says what it needs; what programs print is compared where they run."""
    for language, block in all_blocks(document):
        if language == "text":
            assert block.startswith(tuple(NOT_RUN)), block
        elif language:
            assert language in TESTED | MADE_BY_SPHINX, block
        else:
            assert document == PRACTITIONERS, block


@pytest.mark.parametrize(
    "code", [code for page in (README, START) for code in blocks(page, "python")]
)
def test_python_example_runs(code, capsys):
    exec(code, {})
    assert "±" in capsys.readouterr().out


def test_every_python_block_is_run_somewhere():
    """Here, with the page on extensions, or with that on proofs."""
    pages = {page for page in DOCUMENTS if blocks(page, "python")}
    assert pages == {START, HOW_TO, EXTENDING, PROOFS}


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


def test_a_configuration_that_can_be_computed_is_said_so(mine):
    check = [sys.executable, "-m", "granular_fronts.scenes", "config/default.yaml", str(mine)]
    assert run(check).stdout == "The configuration can be computed.\n"


@pytest.mark.slow
def test_page_on_proofs_is_true(tmp_path, monkeypatch):
    """Its command accepts the certificates kept, and its examples prove what they say."""
    [command], [critical, code, dashpots] = commands(PROOFS), blocks(PROOFS, "python")
    assert command.startswith("python -m granular_fronts.proofs ")
    outcome = run([sys.executable, *shlex.split(command)[1:]])
    assert outcome.returncode == 0, outcome.stderr
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(code, names)
    assert names["record"]["proved"]
    assert "monotone" in names["record"]["statements"][-1]
    assert len(names["family"]) == len(names["records"]) == 2
    assert [one["gamma"] for one in names["family"]] == [one["gamma"] for one in names["records"]]
    exec(critical, names)
    assert names["record"]["numbers"]["critical"] == 1
    assert "is monotone" in names["record"]["statements"][-1]
    exec(dashpots, names)
    assert names["record"]["proved"]
    assert names["record"]["numbers"]["overshoot"] > 1.0136


def test_shown_configuration_is_possible(mine):
    from granular_fronts.scenes.configuration import check_configuration
    from granular_fronts.scenes.yaml_files import load_configuration

    check_configuration(load_configuration(ROOT / "config" / "default.yaml", mine))


def test_shown_campaign_is_possible():
    from granular_fronts.campaign.definition import check_campaign

    [text] = blocks(HOW_TO, "yaml")
    assert check_campaign(yaml.safe_load(text), "shown").size > 10_000


def test_every_yaml_block_is_checked_somewhere():
    pages = {page for page in DOCUMENTS if blocks(page, "yaml")}
    assert pages == {README, HOW_TO, EXTENDING}


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_named_files_and_links_exist(document):
    text = document.read_text(encoding="utf-8")
    named = re.findall(r"`((?:src|workflow|config|tests)/[\w./]+)`", text)
    linked = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    for path in [*(ROOT / name for name in named), *(document.parent / name for name in linked)]:
        # The build of the manual writes these, and finds a dead link to them.
        if "generated" not in path.parts:
            assert path.exists(), path


def test_wings_of_the_manual_are_those_of_the_package():
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ((?:`[\w/]+`(?:, )?)+) \|", text, re.MULTILINE)
    named = {name for row in rows for name in re.findall(r"`([\w/]+)`", row)}
    package = ROOT / "src" / "granular_fronts"
    parts = (path for path in package.iterdir() if path.is_dir() or path.suffix == ".py")
    wings = {path.stem for path in parts if not path.name.startswith("__")}
    assert {name.split("/")[0] for name in named} >= wings
    for name in named & {name for name in named if name.split("/")[0] in wings}:
        assert (package / name).is_dir() or (package / f"{name}.py").exists(), name


# Pages that scripts write.


def load_script(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


ARCHITECTURE = load_script("architecture")


def test_picture_of_the_architecture_is_that_of_the_code():
    picture = ARCHITECTURE.PICTURE.read_text(encoding="utf-8")
    assert picture == ARCHITECTURE.draw(ARCHITECTURE.read_wings()), (
        "run python docs/architecture.py"
    )
    for _, place in ARCHITECTURE.FLOW:
        if not place.startswith("results"):
            assert any(ROOT.glob(place)), place


def test_picture_leaves_out_detours_and_stands_on_what_is_imported():
    imports = {"a": {"b", "c"}, "b": {"c"}, "c": set(), "d": {"c"}}
    assert ARCHITECTURE.without_detours(imports) == imports | {"a": {"b"}}
    assert ARCHITECTURE.levels(imports) == [["a"], ["b", "d"], ["c"]]


INDEX = load_script("equations")


def test_index_of_equations_is_that_of_the_docstrings():
    page = (ROOT / "docs" / "equations.md").read_text(encoding="utf-8")
    assert page == INDEX.make_page(*INDEX.find_equations()), "run python docs/equations.py"


@pytest.mark.parametrize(
    ("number", "module"),
    [
        (31, "chain/equations.py"),
        (36, "continuum/log_burgers/equation.py"),
        (54, "continuum/log_kdv_burgers/equation.py"),
    ],
)
def test_equation_leads_to_the_module_that_holds_its_mathematics(number, module):
    written, _ = INDEX.find_equations()
    assert written[number][0] == module


USED = {2, 4, 5, 6, 9, 12, 13, 14, 16, 17, 19, *range(21, 33), *range(34, 42), *range(43, 58)}


def test_every_equation_that_the_project_uses_is_found():
    written, used = INDEX.find_equations()
    assert written.keys() | used.keys() >= USED


def test_numbers_in_formulas_are_no_equations():
    docstring = """Eqs. (24)-(26) and (31), u(0) = f(2).

    .. math:: x = (3) + y

    The front :math:`(4)` obeys (57).
    """
    assert list(INDEX.numbers(docstring)) == [24, 25, 26, 31, 57]


# The page on extensions, carried out; its law is in `test_a_further_law`.


PLACES = named_blocks(EXTENDING)


@pytest.mark.slow
def test_a_figure_is_added_in_three_places(tmp_path):
    project = copy_project(tmp_path)
    places = {name: text for name, text in PLACES.items() if name.startswith("workflow/")}
    assert len(places) == 3
    for name, text in places.items():
        with (project / name).open("a", encoding="utf-8") as file:
            file.write(text)
    [command] = [line for line in commands(EXTENDING) if "fig26" in line]
    outcome = snakemake(*shlex.split(command)[2:], folder=project)
    assert outcome.returncode == 0, outcome.stderr
    drawn = {path.name for path in (project / "results" / "figures").iterdir()}
    assert drawn == {f"fig26_flux_difference.{ending}" for ending in ("pdf", "png", "rst", "json")}
    caption = (project / "results/figures/fig26_flux_difference.rst").read_text(encoding="utf-8")
    assert "α = 1.5, 1.1" in caption


@pytest.mark.parametrize("missing", ["workflow/scripts/plot_fig26.py", "workflow/report/fig26.rst"])
def test_a_figure_without_one_of_its_places_is_not_drawn(tmp_path, missing):
    project = copy_project(tmp_path)
    for name, text in PLACES.items():
        if name.startswith("workflow/") and name != missing:
            with (project / name).open("a", encoding="utf-8") as file:
                file.write(text)
    outcome = snakemake("fig26", "--dry-run", folder=project)
    assert outcome.returncode != 0
    assert "fig26" in outcome.stdout + outcome.stderr
