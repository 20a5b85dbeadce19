"""What the workflow plans, and what it refuses before any job."""

import re
import tomllib

import pytest
import yaml
from packaging.requirements import Requirement

from projects import ROOT, jobs_due, rules_due, snakemake

FIGURES = sorted(file.stem for file in (ROOT / "workflow/captions").glob("[!t]*.rst"))
PROJECTS = [file.parent.name for file in ROOT.glob("projects/*/rules.smk")]
DRAWN = [name.partition("_")[0] if name.startswith("fig") else name for name in FIGURES]
TARGETS = {*DRAWN, *PROJECTS, "all", "figures", "tables", "report"}


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    """The jobs behind each target, where nothing is there yet.

    Planned together, since a target that could not be planned alone would stop this plan too.
    """
    nothing = f"results={tmp_path_factory.mktemp('plan') / 'results'}"
    return jobs_due("--config", nothing, "--", *TARGETS)


def test_every_target_can_be_planned(plan):
    assert plan.keys() >= TARGETS
    assert plan["all"] >= {*DRAWN, "report", "compute_heteroclinic scene: front_profiles"}


def test_figure_solves_only_its_own_scene(plan):
    solved = {job for job in plan["fig03"] if job.startswith("initiate_front")}
    assert solved == {"initiate_front scene: initiation_overdamped"}


def test_a_plain_call_makes_nothing_of_a_project(plan):
    rules = {job.partition(" ")[0] for job in plan["all"]}
    for name in PROJECTS:
        text = (ROOT / f"projects/{name}/rules.smk").read_text(encoding="utf-8")
        own = re.findall(r"^(?:use )?rule (?:\w+ as )?(\w+)(?: with)?:", text, re.MULTILINE)
        assert name in own
        assert rules.isdisjoint(own)


def test_lint_finds_nothing():
    run = snakemake("--lint")
    assert run.returncode == 0, run.stdout


def test_files_replace_other_kinds_and_the_command_line_wins(tmp_path):
    """Snakemake itself would leave keys of the boundary and the law that are below."""
    files = [tmp_path / "one.yaml", tmp_path / "two.yaml"]
    boundary, law = {"kind": "piston", "velocity": 0.05}, {"elastic": {"kind": "toda"}}
    for file, changes in zip(files, ({"boundary": boundary}, {"law": law}), strict=True):
        scenes = {"chain": {"initiation_underdamped": changes}}
        file.write_text(yaml.safe_dump({"results": "no folder?", "scenes": scenes}))
    results = f"results={tmp_path / 'results'}"
    run = snakemake("--dry-run", "--configfile", *files, "--config", results, "--", "fig01")
    assert run.returncode == 0, run.stderr
    assert "initiate_front" in rules_due(run)


def test_an_option_of_which_snakemake_would_drop_the_first_is_refused():
    given = ["--configfile", "config/smoke.yaml"]
    run = snakemake("--dry-run", *given, *given)
    assert run.returncode != 0
    assert "--configfile is given twice" in run.stderr


def pinned_in(file):
    """The versions of each package that a file pins, which names no package index."""
    text = (ROOT / file).read_text()
    assert "://" not in text
    pinned = {}
    for name, version in re.findall(r"^([\w.-]+)==([\w.]+)", text, re.MULTILINE):
        pinned.setdefault(name, set()).add(version)
    return pinned


def test_environments_pin_every_dependency_within_its_range_and_agree():
    """The project's and the one that builds the manual are installed into one environment."""
    here, manual = pinned_in("environment.txt"), pinned_in("docs/environment.txt")
    described = tomllib.loads((ROOT / "pyproject.toml").read_text())
    project = described["project"]
    required = [*project["dependencies"], *described["build-system"]["requires"]]
    required += [one for extra in project["optional-dependencies"].values() for one in extra]
    for pinned, requirements in (here, required), (manual, described["dependency-groups"]["docs"]):
        for requirement in map(Requirement, requirements):
            versions = pinned[requirement.name.lower()]
            assert all(requirement.specifier.contains(version) for version in versions)
    for name in here.keys() & manual.keys():
        assert manual[name] <= here[name]
