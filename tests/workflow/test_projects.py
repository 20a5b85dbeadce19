"""Projects beyond the paper: whole in their folders, which can be added and deleted."""

import re
import shutil
import subprocess
import sys

import pandas as pd
import pytest
from check_verdicts import check_verdicts
from pages import carry_out, commands, run
from tabulate_statements import find_measure

from granular_fronts.output.statements import (
    answers_to,
    criterion_of,
    range_of_criterion,
)
from granular_fronts.scenes.yaml_files import read_yaml
from projects import ROOT, copy_project, lend_kernels, snakemake

PAGE = ROOT / "docs" / "your_project.md"
PROJECTS = sorted(file.parent.name for file in ROOT.glob("projects/*/rules.smk"))
PACKAGES = {"proofs", "referee"}
FILES = [*ROOT.glob("projects/*/statements.yaml"), *ROOT.glob("projects/*/findings.yaml")]
STATEMENTS = [(file.parent, statement) for file in FILES for statement in read_yaml(file)]


@pytest.mark.parametrize(("folder", "statement"), STATEMENTS, ids=lambda one: str(one)[-60:])
def test_every_statement_can_be_measured_and_judged_and_its_measure_has_a_test(folder, statement):
    measure = find_measure(statement["measure"], folder)
    tests = "".join(file.read_text(encoding="utf-8") for file in folder.glob("test_*.py"))
    assert "." in measure.__module__ or re.search(rf"\b{measure.__name__}\b", tests)
    assert (statement["kind"] == "finding") == ("printed" not in statement)
    true, false, not_judged = answers_to(statement)
    if "not_judged" in statement:
        assert statement["expected"] == not_judged
        return
    assert statement["expected"] in (true, false)
    low, high, _ = range_of_criterion(criterion_of(statement))
    assert low < high


def test_no_file_outside_its_folder_names_a_project():
    """An attribute or a function of the same name is another thing."""
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    names = "|".join({*PROJECTS} - PACKAGES)
    named = re.compile(rf"(?<![\w.])(?<!def )(?:{names})(?!\w)")
    for file in map(ROOT.joinpath, listed.stdout.splitlines()):
        if file.suffix not in {".nc", ".npz", ".gif", ".png"} and file.exists():
            found = {*named.findall(file.read_text(encoding="utf-8"))}
            assert file.name == "CHANGELOG.md" or found <= {*file.parts}, file


# A copy of the repository for each project.
@pytest.mark.nightly
@pytest.mark.parametrize("name", PROJECTS)
def test_a_project_that_is_deleted_leaves_nothing_behind(name, tmp_path):
    copy = copy_project(tmp_path)
    shutil.rmtree(copy / "projects" / name)
    plan = snakemake("--dry-run", folder=copy)
    assert plan.returncode == 0, plan.stderr
    everything = ["-m", "slow or not slow", "-p", "no:cacheprovider"]
    found = run([sys.executable, "-m", "pytest", "-q", "--collect-only", *everything], copy)
    assert found.returncode == 0, found.stdout


@pytest.mark.slow
def test_the_paper_needs_no_project(tmp_path):
    copy = copy_project(tmp_path)
    shutil.rmtree(copy / "projects")
    plan = snakemake("--dry-run", folder=copy)
    assert plan.returncode == 0, plan.stderr


@pytest.mark.slow
def test_a_project_is_added_as_the_page_says(tmp_path):
    copy = lend_kernels(copy_project(tmp_path))
    written = carry_out(copy, "Five files", page=PAGE)
    assert len(written) <= 5
    written |= carry_out(copy, "A figure of it", page=PAGE)
    assert all(name.startswith("projects/author_2026/") for name in written)
    assert commands(PAGE) == ["snakemake -c2 author_2026", "snakemake -c2 author_2026_wave"]
    outcome = snakemake("author_2026", "author_2026_wave", folder=copy)
    assert outcome.returncode == 0, outcome.stderr
    verdict = (copy / "results/author_2026.txt").read_text(encoding="utf-8")
    assert verdict == "All 1 verdicts are the expected ones.\n"
    caption = (copy / "results/figures/author_2026_wave.rst").read_text(encoding="utf-8")
    assert "t = 40" in caption


def test_another_verdict_than_the_expected_one_is_refused(tmp_path):
    table, verdict = tmp_path / "table.csv", tmp_path / "verdict.txt"
    judged = {"quantity": ["width", "speed"], "verdict": ["reproduced", "not reproduced"]}
    rows = pd.DataFrame(judged | {"expected": "reproduced", "computed": "0.84"})
    rows.assign(**{"numerical error": "1e-9", "criterion": "0.85 within 0.005"}).to_csv(table)
    with pytest.raises(ValueError, match=r"^speed: not reproduced, but reproduced is expected"):
        check_verdicts([table], verdict)
    assert not verdict.exists()
