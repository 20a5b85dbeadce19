"""README and manual are true: commands run or can be planned, code runs, what is named exists."""

import importlib.util
import re
import shlex
import sys
from pathlib import Path

import pytest
from pages import EXTENDING, README, blocks, commands, named_blocks, run
from projects import ROOT, copy_project, snakemake

START, PROOFS = ROOT / "docs" / "start.md", ROOT / "docs" / "proofs.md"
PRACTITIONERS = ROOT / "docs" / "practitioners.md"
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
COMMANDS = [line for page in DOCUMENTS if page not in ELSEWHERE for line in commands(page)]


@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("make")])
def test_make_knows_its_targets(command):
    outcome = run([*shlex.split(command), "--dry-run"])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.slow
@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("snakemake")])
def test_workflow_can_plan_its_targets(command):
    outcome = run([sys.executable, "-m", *shlex.split(command), "--dry-run", "--nolock"])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.slow
@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("python")])
def test_script_runs_as_shown(command, tmp_path):
    words = shlex.split(command)[1:]
    words[-1] = str(tmp_path / words[-1])
    outcome = run([sys.executable, *words])
    assert outcome.returncode == 0, outcome.stderr
    assert Path(words[-1]).exists()


def test_all_commands_are_of_a_kind_that_is_tested():
    kinds = ("make", "snakemake", "python", "source .venv/bin/activate")
    assert all(command.startswith(kinds) for command in COMMANDS)
    assert all(command.startswith(("snakemake", "python")) for command in commands(EXTENDING))


@pytest.mark.parametrize("code", blocks(README, "python") + blocks(START, "python"))
def test_python_example_runs(code, capsys):
    exec(code, {})
    assert "±" in capsys.readouterr().out


def test_page_on_proofs_is_true(tmp_path, monkeypatch):
    """Its command accepts the certificates kept, and its example proves what it says."""
    [command], [code] = commands(PROOFS), blocks(PROOFS, "python")
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


@pytest.mark.parametrize("text", blocks(README, "yaml") + blocks(START, "yaml"))
def test_shown_configuration_is_possible(text, tmp_path):
    from granular_fronts.scenes.configuration import check_configuration
    from granular_fronts.scenes.yaml_files import load_configuration

    override = tmp_path / "mine.yaml"
    override.write_text(text)
    check_configuration(load_configuration(ROOT / "config" / "default.yaml", override))


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_named_files_and_links_exist(document):
    text = document.read_text(encoding="utf-8")
    named = re.findall(r"`((?:src|workflow|config|tests)/[\w./]+)`", text)
    linked = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    for path in [*(ROOT / name for name in named), *(document.parent / name for name in linked)]:
        # The build of the manual writes these, and finds a dead link to them.
        if "generated" not in path.parts:
            assert path.exists(), path


def test_readme_is_short():
    """What else there is to say stands in the manual."""
    assert len(README.read_text(encoding="utf-8").splitlines()) <= 150


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


# The index of equations.


def load_index():
    spec = importlib.util.spec_from_file_location("equations", ROOT / "docs" / "equations.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


INDEX = load_index()


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


def test_a_figure_is_added_in_three_places(tmp_path):
    project = copy_project(tmp_path)
    places = {name: text for name, text in PLACES.items() if name.startswith("workflow/")}
    assert len(places) == 3
    for name, text in places.items():
        with (project / name).open("a", encoding="utf-8") as file:
            file.write(text)
    [command] = [line for line in commands(EXTENDING) if "fig25" in line]
    outcome = snakemake(*shlex.split(command)[2:], folder=project)
    assert outcome.returncode == 0, outcome.stderr
    drawn = {path.name for path in (project / "results" / "figures").iterdir()}
    assert drawn == {f"fig25_flux_difference.{ending}" for ending in ("pdf", "png", "rst", "json")}
    caption = (project / "results/figures/fig25_flux_difference.rst").read_text(encoding="utf-8")
    assert "α = 1.5, 1.1" in caption


@pytest.mark.parametrize("missing", ["workflow/scripts/plot_fig25.py", "workflow/report/fig25.rst"])
def test_a_figure_without_one_of_its_places_is_not_drawn(tmp_path, missing):
    project = copy_project(tmp_path)
    for name, text in PLACES.items():
        if name.startswith("workflow/") and name != missing:
            with (project / name).open("a", encoding="utf-8") as file:
                file.write(text)
    outcome = snakemake("fig25", "--dry-run", folder=project)
    assert outcome.returncode != 0
    assert "fig25" in outcome.stdout + outcome.stderr
