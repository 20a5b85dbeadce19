"""Help in words names every target there is, and no other."""

import re
import subprocess

import pytest
import yaml
from projects import ROOT, snakemake

from papers import listed_in_papers


def target_rules():
    """Names of the rules that make nothing themselves; one that tests is asked for by name too."""
    figures = yaml.safe_load((ROOT / "workflow/figures.yaml").read_text(encoding="utf-8"))
    names = {"check_results", *figures, *listed_in_papers("figures")}
    for file in [ROOT / "Snakefile", *ROOT.glob("workflow/rules/*.smk")]:
        for part in re.split(r"^(?=rule |checkpoint )", file.read_text(), flags=re.MULTILINE)[1:]:
            name = re.match(r"rule (\w+):", part)
            if name and "    output:" not in part:
                names.add(name[1])
    return names


@pytest.fixture(scope="module")
def workflow_help():
    """Targets of the workflow and their words."""
    run = snakemake("help")
    assert run.returncode == 0, run.stderr
    return dict(
        re.findall(r"^  (\w+) +(\S.*)$", run.stdout + run.stderr.partition("Job 0")[2], re.M)
    )


def test_help_of_the_workflow_names_every_target(workflow_help):
    assert set(workflow_help) == target_rules()
    assert all(words.endswith(".") for words in workflow_help.values())


@pytest.mark.slow
def test_help_of_make_names_its_targets_and_those_of_the_workflow(workflow_help):
    run = subprocess.run(["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True)
    shown = dict(re.findall(r"^  ([\w.]+) +(\S.*)$", run.stdout, re.MULTILINE))
    phony = re.search(r"^\.PHONY: (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()
    own = run.stdout.partition("source .venv")[0]
    assert set(re.findall(r"^  ([\w.]+) ", own, re.MULTILINE)) == {*phony, "environment.txt"}
    for name, words in workflow_help.items():
        assert name in phony or shown[name] == words
