"""What others cite and check, CITATION.cff and codecheck.yml, agrees with the project."""

import re
import subprocess
import sys
import tomllib

import pytest
import yaml
from projects import ROOT

import granular_fronts

CITATION = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
CODECHECK = yaml.safe_load((ROOT / "codecheck.yml").read_text(encoding="utf-8"))
FIGURES = yaml.safe_load((ROOT / "workflow/figures.yaml").read_text(encoding="utf-8"))
PRINTED_FIGURES = range(1, 9)
"""The paper prints eight figures."""


@pytest.mark.parametrize(
    ("schema", "file"),
    [
        ("vendor.citation-file-format", "CITATION.cff"),
        ("vendor.github-workflows", ".github/workflows/ci.yml"),
        ("vendor.github-workflows", ".github/workflows/weekly.yml"),
    ],
)
def test_file_has_the_form_that_its_readers_expect(schema, file):
    command = [sys.executable, "-m", "check_jsonschema", "--builtin-schema", schema, ROOT / file]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout


def test_version_licence_and_authors_are_the_same_everywhere():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    newest, released = re.search(r"^## ([\d.]+), ([\d-]{10})$", changes, re.MULTILINE).groups()
    assert CITATION["version"] == granular_fronts.__version__ == newest
    assert CITATION["date-released"].isoformat() == released
    assert CITATION["license"] == project["license"]
    assert [author["name"] for author in CITATION["authors"]] == [
        author["name"] for author in project["authors"]
    ]


def test_codecheck_names_the_paper_that_is_cited():
    [paper], checked = CITATION["references"], CODECHECK["paper"]
    assert checked["title"] == paper["title"]
    assert checked["reference"] == f"https://doi.org/{paper['doi']}"
    assert [author["name"] for author in checked["authors"]] == [
        f"{author['given-names']} {author['family-names']}" for author in paper["authors"]
    ]


def test_codecheck_lists_every_figure_and_number_of_the_paper():
    """As the workflow writes them; what this project adds is no part of it."""
    statements = yaml.safe_load((ROOT / "config/paper_numbers.yaml").read_text(encoding="utf-8"))
    *figures, numbers = CODECHECK["manifest"]
    for number, entry in zip(PRINTED_FIGURES, figures, strict=True):
        described = FIGURES[f"fig{number:02d}"]
        assert entry == {
            "file": f"results/figures/fig{number:02d}_{described['name']}.pdf",
            "comment": f"Figure {number} of the paper",
        }
        assert "on_demand" not in described
    assert numbers["file"] == "results/tables/paper_numbers.csv"
    assert re.match(r"The (\d+) numbers and statements", numbers["comment"])[1] == str(
        len(statements)
    )


@pytest.mark.slow
def test_run_writes_everything_that_codecheck_lists(finished):
    for entry in CODECHECK["manifest"]:
        file = finished / entry["file"].replace("results/", "results/smoke/", 1)
        assert file.stat().st_size > 0
